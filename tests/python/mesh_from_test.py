"""Meshes of meshio, to and fro; of VTK and gmsh, against the files that these write."""
import pathlib
from typing import Any

import meshio  # type: ignore[import]
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import ringwatch as rw
from support import bar, body_of

ELEMENTS = {"tet4": "tetra", "tet10": "tetra10", "hex8": "hexahedron", "hex20": "hexahedron20", "wedge6": "wedge",
            "pyramid5": "pyramid"}


@pytest.mark.parametrize("element", ELEMENTS)
def test_a_mesh_read_by_meshio_is_ours(tmp_path: pathlib.Path, element: str) -> None:
    mesh = bar(element=element, jitter=0)
    mesh.save(tmp_path / "bar.msh")
    theirs = meshio.read(tmp_path / "bar.msh")
    assert ELEMENTS[element] in {block.type for block in theirs.cells}
    ours = rw.mesh_from(theirs)
    assert np.array_equal(ours.points, mesh.points)
    for (name, cells), (again, same) in zip(mesh.blocks, ours.blocks):
        assert name == again and np.array_equal(cells, same)


def test_groups_of_meshio_are_those_of_the_file(tmp_path: pathlib.Path) -> None:
    """Physical groups by their names, point sets, cell sets of surfaces and of volumes."""
    bar(cells=[3, 2, 1]).save(tmp_path / "bar.msh")
    read = rw.load_mesh(tmp_path / "bar.msh")
    ours = rw.mesh_from(meshio.read(tmp_path / "bar.msh"))
    assert set(read.node_sets) >= {"x-min", "x-max"} and ours.node_sets.keys() == read.node_sets.keys()
    for name, nodes in read.node_sets.items():
        assert np.array_equal(ours.node_sets[name], nodes)
    assert ours.cell_sets.keys() == read.cell_sets.keys() == {"all"}
    assert np.array_equal(ours.cell_sets["all"][0], read.cell_sets["all"][0])
    volume = [("triangle", np.array([[0, 1, 2]])), ("tetra", np.array([[0, 1, 2, 3]])), ("tetra", np.array([[1, 2, 4, 3]]))]
    points = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]])
    sets = {"top": [np.array([0]), np.array([], int), np.array([], int)],
            "core": [np.array([], int), np.array([], int), np.array([0])]}
    tagged = {"gmsh:physical": [np.array([4]), np.array([5]), np.array([5])]}
    mesh = rw.mesh_from(meshio.Mesh(points, volume, point_sets={"tip": np.array([4])}, cell_sets=sets,
                                    cell_data=tagged, field_data={"skin": np.array([4, 2])}))
    assert {name: list(nodes) for name, nodes in mesh.node_sets.items()} == {
        "tip": [4], "top": [0, 1, 2], "skin": [0, 1, 2]}
    assert {name: [list(own) for own in members] for name, members in mesh.cell_sets.items()} == {
        "core": [[], [0]], "volume-5": [[0], [0]]}
    with pytest.raises(rw.InputError, match=r"cell_sets\['core'\]|cell_sets\[\"core\"\]"):
        rw.Mesh(points, [volume[1]], cell_sets={"core": [np.array([1])]})


@pytest.mark.parametrize("element", ELEMENTS)
def test_other_programs_find_positive_volumes(tmp_path: pathlib.Path, element: str) -> None:
    """VTK's own sizes of the cells of a written mesh and of a frame, and meshio's nodes of them."""
    verdict = pytest.importorskip("vtkmodules.vtkFiltersVerdict")
    mesh = bar(element=element, jitter=0, cells=[3, 2, 1])
    mesh.save(tmp_path / "bar.vtu")
    size = verdict.vtkCellSizeFilter()
    size.SetInputData(grid_of(tmp_path / "bar.vtu"))
    size.Update()
    volumes = np.array(size.GetOutput().GetCellData().GetArray("Volume"))
    extent = mesh.points.max(axis=0) - mesh.points.min(axis=0)
    assert volumes.min() > 0 and volumes.sum() == pytest.approx(extent.prod())
    for (name, cells), theirs in zip(mesh.blocks, meshio.read(tmp_path / "bar.vtu").cells):
        assert ELEMENTS[name] == theirs.type and np.array_equal(theirs.data, cells)


def test_steps_go_back_into_the_mesh(tmp_path: pathlib.Path) -> None:
    points = bar(cells=[3, 1, 1]).points
    mesh = bar(cells=[3, 1, 1])
    triangles = np.array([[0, 1, 2]])
    theirs = meshio.Mesh(points, [("triangle", triangles), ("tetra", mesh.cells["tet4"])])
    ours = rw.mesh_from(theirs)
    steps = rw.inspect(body_of(ours), metrics=["single-element"]).element_steps
    volume = meshio.Mesh(ours.points, [("tetra", ours.cells["tet4"])], cell_data={"step": list(steps)})
    volume.write(tmp_path / "steps.vtu")
    assert np.array_equal(meshio.read(tmp_path / "steps.vtu").cell_data["step"][0], steps[0])


def same(ours: Any, theirs: Any) -> None:
    """Points, cells, node sets, and the numbers that messages give."""
    assert np.array_equal(ours.points, theirs.points)
    assert len(ours.blocks) == len(theirs.blocks)
    for (name, cells), (again, as_well) in zip(ours.blocks, theirs.blocks):
        assert name == again and np.array_equal(cells, as_well)
    assert ours.node_sets.keys() == theirs.node_sets.keys()
    for name, nodes in ours.node_sets.items():
        assert np.array_equal(np.unique(nodes), np.unique(theirs.node_sets[name])), name
    steps = [rw.inspect(body_of(mesh), metrics=[]) for mesh in (ours, theirs)]
    assert steps[0] == steps[1]  # also the controlling element, with its number and those of its nodes


def grid_of(path: pathlib.Path) -> Any:
    """What VTK's own reader makes of a file."""
    reader = pytest.importorskip("vtkmodules.vtkIOXML").vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


@pytest.mark.parametrize("element", ELEMENTS)
def test_a_grid_of_vtk_is_its_file(tmp_path: pathlib.Path, element: str) -> None:
    bar(element=element, jitter=0, cells=[3, 2, 1]).save(tmp_path / "bar.vtu")
    same(rw.mesh_from(grid_of(tmp_path / "bar.vtu")), rw.load_mesh(tmp_path / "bar.vtu"))


@pytest.mark.parametrize("element", ELEMENTS)
def test_a_grid_for_pictures_is_that_of_the_file(tmp_path: pathlib.Path, element: str) -> None:
    """Points and cells are what VTK reads of the mesh's file, fields lie where they belong, and PyVista draws them where it is there."""
    mesh = bar(element=element, jitter=0, cells=[3, 2, 1])
    mesh.save(tmp_path / "bar.vtu")
    steps = rw.inspect(body_of(mesh)).element_steps
    grid, file = rw.grid_of(mesh, step=steps, place=mesh.points), grid_of(tmp_path / "bar.vtu")
    for array in ("GetOffsetsArray", "GetConnectivityArray"):
        assert np.array_equal(np.array(getattr(grid.GetCells(), array)()), np.array(getattr(file.GetCells(), array)()))
    assert np.array_equal(np.array(grid.GetCellTypesArray()), np.array(file.GetCellTypesArray()))
    assert np.array_equal(np.array(grid.GetPoints().GetData()).reshape(-1, 3), mesh.points)
    assert np.array_equal(np.array(grid.GetCellData().GetArray("step")).ravel(), np.concatenate(steps))
    assert np.array_equal(np.array(grid.GetPointData().GetArray("place")).reshape(-1, 3), mesh.points)
    moved = rw.grid_of(mesh, 2 * mesh.points)
    assert np.array_equal(np.array(moved.GetPoints().GetData()).reshape(-1, 3), 2 * mesh.points)
    with pytest.raises(rw.InputError, match="grid_of: x: 1 positions"):
        rw.grid_of(mesh, mesh.points[:1])
    with pytest.raises(rw.InputError, match="grid_of: step: .* elements need one each"):
        rw.grid_of(mesh, step=[steps[0][:-1]])


def test_pyvista_draws_a_grid() -> None:
    pyvista = pytest.importorskip("pyvista")
    mesh = bar()
    grid: Any = rw.grid_of(mesh, step=rw.inspect(body_of(mesh)).element_steps)
    assert isinstance(grid, pyvista.UnstructuredGrid)
    picture = grid.plot(scalars="step", off_screen=True, return_img=True)
    assert picture.std() > 0


def test_a_grid_of_several_kinds_and_single_precision() -> None:
    """Triangles are left out, cells keep their numbers, and points of other types are widened."""
    model = pytest.importorskip("vtkmodules.vtkCommonDataModel")
    core = pytest.importorskip("vtkmodules.vtkCommonCore")

    Grid: Any = type("Grid", (model.vtkUnstructuredGrid,), {})  # as PyVista's are

    coordinates = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 1), (0.1, 0.2, -0.7), (7, 7, 7)]
    points = core.vtkPoints()
    points.SetDataTypeToFloat()
    for point in coordinates:
        points.InsertNextPoint(point)
    grid = Grid()
    grid.SetPoints(points)
    for kind, nodes in ((5, (0, 1, 2)), (10, (0, 1, 2, 3)), (14, (0, 1, 4, 2, 5)), (10, (1, 2, 3, 4))):
        ids = core.vtkIdList()
        for node in nodes:
            ids.InsertNextId(node)
        if kind == 14:
            continue
        grid.InsertNextCell(kind, ids)
    mesh = rw.mesh_from(grid)
    assert [name for name, _ in mesh.blocks] == ["tet4"]
    assert np.array_equal(mesh.cells["tet4"], [[0, 1, 2, 3], [1, 2, 3, 4]])
    assert np.array_equal(mesh.points, np.array(coordinates[:5], dtype=np.float64))
    assert "2 nodes that no element uses" in mesh.notes[0]
    assert rw.inspect(body_of(mesh)).controlling.id in (1, 2)
    one = core.vtkIdList()
    for node in range(5):
        one.InsertNextId(node)
    grid.InsertNextCell(7, one)  # a polygon
    assert rw.mesh_from(grid).element_count == 2
    for node in (5, 6, 0):
        one.InsertNextId(node)
    grid.InsertNextCell(11, one)
    with pytest.raises(rw.InputError, match=r"cell 4 is of VTK's type 11; known are 10 \(tet4\), 12 \(hex8\)"):
        rw.mesh_from(grid)
    with pytest.raises(rw.InputError, match="without points or cells"):
        rw.mesh_from(model.vtkUnstructuredGrid())
    with pytest.raises(rw.InputError, match="an object of type vtkPolyData; must be a vtkUnstructuredGrid"):
        rw.mesh_from(model.vtkPolyData())


@settings(max_examples=40, deadline=None, database=None, derandomize=True)
@given(st.lists(st.tuples(st.sampled_from([10, 12, 13, 14, 5, 3]), st.integers(0, 10)), min_size=1, max_size=12))
def test_any_grid_of_vtk_is_sorted_by_kind(cells: Any) -> None:
    """Cells of all kinds in any order, each a unit cell of its own: blocks in the order in which kinds appear, numbers kept."""
    model = pytest.importorskip("vtkmodules.vtkCommonDataModel")
    core = pytest.importorskip("vtkmodules.vtkCommonCore")
    cube = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
    corners = {10: (0, 1, 3, 4), 12: range(8), 13: (0, 3, 1, 4, 7, 5), 14: (0, 1, 2, 3, 4), 5: (0, 1, 2), 3: (0, 1)}
    names = {10: "tet4", 12: "hex8", 13: "wedge6", 14: "pyramid5"}
    grid, points = model.vtkUnstructuredGrid(), core.vtkPoints()
    points.SetDataTypeToDouble()
    grid.SetPoints(points)
    expected: dict[str, list[int]] = {}
    for number, (kind, shift) in enumerate(cells):
        ids = core.vtkIdList()
        for corner in corners[kind]:
            x, y, z = cube[corner]
            ids.InsertNextId(points.InsertNextPoint(x + 2 * number, y + shift, z))
        grid.InsertNextCell(kind, ids)
        if kind in names:
            expected.setdefault(names[kind], []).append(number)
    if not expected:
        with pytest.raises(rw.InputError, match="no elements"):
            rw.mesh_from(grid)
        return
    mesh = rw.mesh_from(grid)
    assert [name for name, _ in mesh.blocks] == list(expected)
    for (name, nodes), numbers in zip(mesh.blocks, expected.values()):
        assert len(nodes) == len(numbers)
        assert np.array_equal(np.floor(mesh.points[nodes, 0].min(axis=1) / 2), numbers)  # cell by cell where it was put
        mean = mesh.points[nodes, 1].mean(axis=1) - [cells[number][1] for number in numbers]
        assert np.all((0 < mean) & (mean < 1))


@pytest.fixture
def gmsh() -> Any:
    module = pytest.importorskip("gmsh")
    module.initialize(interruptible=False) if "interruptible" in module.initialize.__code__.co_varnames else module.initialize()
    module.option.setNumber("General.Terminal", 0)
    yield module
    module.finalize()


@pytest.mark.parametrize("order", [1, 2])
@pytest.mark.parametrize("kind", ["tet", "hex"])
def test_gmshs_model_is_its_file(tmp_path: pathlib.Path, gmsh: Any, kind: str, order: int) -> None:
    gmsh.model.occ.addBox(0, 0, 0, 0.2, 0.04, 0.04)
    gmsh.model.occ.synchronize()
    if kind == "hex":
        gmsh.model.mesh.setTransfiniteAutomatic()
        gmsh.option.setNumber("Mesh.SecondOrderIncomplete", 1)
    gmsh.option.setNumber("Mesh.MeshSizeMax", 0.03)
    gmsh.model.mesh.generate(3)
    gmsh.model.mesh.setOrder(order)
    gmsh.model.addPhysicalGroup(3, [1])
    ends = [tag for _, tag in gmsh.model.getEntitiesInBoundingBox(-1e-3, -1, -1, 1e-3, 1, 1, 2)]
    gmsh.model.setPhysicalName(2, gmsh.model.addPhysicalGroup(2, ends), "left")
    gmsh.model.addPhysicalGroup(0, [1], 7)
    gmsh.option.setNumber("Mesh.Binary", 1)  # text has fewer digits
    gmsh.write(str(tmp_path / "box.msh"))
    theirs = rw.load_mesh(tmp_path / "box.msh")
    element = {("tet", 1): "tet4", ("tet", 2): "tet10", ("hex", 1): "hex8", ("hex", 2): "hex20"}[kind, order]
    assert [name for name, _ in theirs.blocks] == [element] and set(theirs.node_sets) == {"left", "point-7"}
    ours = rw.mesh_from(gmsh)
    same(ours, theirs)
    assert np.abs(ours.points[ours.node_sets["left"], 0]).max() < 1e-12


def test_gmshs_models_that_are_refused(gmsh: Any) -> None:
    gmsh.model.occ.addBox(0, 0, 0, 1, 1, 1)
    gmsh.model.occ.synchronize()
    with pytest.raises(rw.InputError, match="no elements with volume; gmsh.model.mesh.generate"):
        rw.mesh_from(gmsh)
    gmsh.model.mesh.generate(3)
    gmsh.model.mesh.setOrder(3)
    with pytest.raises(rw.InputError, match=r"elements of gmsh's type 29, Tetrahedron 20; known are 4 \(tet4\)"):
        rw.mesh_from(gmsh)


def test_numbers_of_another_program(tmp_path: pathlib.Path) -> None:
    mesh = bar(cells=[2, 1, 1])
    (name, cells), count = mesh.blocks[0], len(mesh.points)
    ours = rw.Mesh(mesh.points, [(name, cells)], node_ids=np.arange(count) + 100, cell_ids=[np.arange(len(cells)) * 10])
    controlling = rw.inspect(body_of(ours)).controlling
    assert controlling.id == 10 * controlling.index
    assert controlling.node_ids == tuple(node + 100 for node in controlling.nodes)
    wrong: Any
    for wrong, said in (({"node_ids": np.arange(3)}, f"node_ids: 3 numbers; must be {count}, one each"),
                        ({"node_ids": np.zeros(count)}, "node_ids: an array of float64"),
                        ({"cell_ids": [np.arange(1)]}, rf"cell_ids\[0\]: 1 numbers; must be {len(cells)}"),
                        ({"cell_ids": []}, "cell_ids: .* a list of an array for each of the 1 blocks")):
        with pytest.raises(rw.InputError, match=said):
            rw.Mesh(mesh.points, [(name, cells)], **wrong)
