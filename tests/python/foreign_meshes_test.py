"""Meshes in the formats that meshio reads, against meshio's own reading of the same file, to the last bit of coordinates."""
import json
import os
import pathlib
import shutil
import subprocess
import time
from collections.abc import Iterable
from typing import Any

import meshio  # type: ignore[import]
import netCDF4  # type: ignore[import]
import numpy as np
import pytest
from numpy.typing import NDArray

import ringwatch as rw
from support import PROGRAM

for kind in ("wedge15", "pyramid13"):  # of which meshio 5.0 does not know the dimension
    meshio._mesh.topological_dimension.setdefault(kind, 3)
NAMES = {"tetra": "tet4", "tetra10": "tet10", "hexahedron": "hex8", "hexahedron20": "hex20", "wedge": "wedge6",
         "pyramid": "pyramid5"}
ELEMENTS = {ours: theirs for theirs, ours in NAMES.items()}
LINEAR = ["tet4", "hex8", "wedge6", "pyramid5"]
ALL = [*LINEAR, "tet10", "hex20"]
# What meshio writes of each format, by its name: the extension, what it is told, and the elements.
WRITTEN: dict[str, tuple[str, dict[str, Any], list[str]]] = {
    "gmsh": ("msh", {"binary": False}, ALL),
    "gmsh22": ("msh", {"binary": True}, ALL),
    "vtk42": ("vtk", {"binary": True}, ALL),
    "vtk51": ("vtk", {"binary": False}, ALL),
    "vtu": ("vtu", {"compression": "zlib"}, ALL),
    "abaqus": ("inp", {"float_fmt": ".17g"}, [element for element in ALL if element != "pyramid5"]),
    "tetgen": ("node", {"float_fmt": ".17g"}, ["tet4"]),
    "exodus": ("exo", {}, [element for element in ALL if element != "tet4"]),
    "med": ("med", {}, ALL),
    "xdmf": ("xdmf", {}, ALL),
    "medit": ("mesh", {}, LINEAR),
    "medit binary": ("meshb", {}, LINEAR),
    "nastran": ("bdf", {}, ALL),
    "netgen": ("vol", {}, LINEAR),
    "su2": ("su2", {}, LINEAR),
}
CASES = [(format, element) for format, (_, _, elements) in WRITTEN.items() for element in elements]


def call(*arguments: object) -> "subprocess.CompletedProcess[str]":
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True)


def a_mesh(element: str) -> tuple[NDArray[np.float64], list[tuple[str, NDArray[np.int64]]]]:
    """A bar whose coordinates use all bits, and triangles and quads at its end as meshers write them beside."""
    mesh = rw.generate_mesh("bar", size=[0.6, 0.2, 0.2], cells=[3, 1, 1], element=element)
    points = mesh.points + 1e-3 * np.random.default_rng(1).random(mesh.points.shape)
    if element in ("tet10", "hex20"):  # straight edges, so that no middle is far from its own
        points = mesh.points / 3
    return points, [(ELEMENTS[name], np.asarray(cells, dtype=np.int64)) for name, cells in mesh.blocks]


@pytest.mark.parametrize("format,element", CASES)
def test_a_mesh_of_each_format_is_that_of_meshio(tmp_path: pathlib.Path, format: str, element: str) -> None:
    extension, options, _ = WRITTEN[format]
    format = format.split()[0]
    points, cells = a_mesh(element)
    file = tmp_path / f"mesh.{extension}"
    meshio.write(file, meshio.Mesh(points, cells), file_format=format, **options)
    theirs = meshio.read(file, file_format={"gmsh22": "gmsh", "vtk42": "vtk", "vtk51": "vtk"}.get(format, format))
    ours = rw.load_mesh(file)
    assert np.array_equal(np.asarray(theirs.points), ours.points), "coordinates differ"
    if format != "nastran":  # whose numbers have some digits
        assert np.array_equal(points, ours.points)
    read = [(NAMES[block.type], block.data) for block in theirs.cells]
    if format == "med":  # which meshio sorts by type
        read.sort(key=lambda own: [name for name, _ in ours.blocks].index(own[0]))
    assert [name for name, _ in ours.blocks] == list(dict.fromkeys(name for name, _ in read))
    for name, connectivity in ours.blocks:
        theirs_of_type = np.concatenate([data for own, data in read if own == name])
        assert np.array_equal(connectivity, theirs_of_type)


def numbers(mesh: rw.Mesh, file: pathlib.Path) -> tuple[list[int], list[int]]:
    """The numbers of nodes and elements that the mesh has kept, as a text file of gmsh has them."""
    mesh.save(file)
    lines = [line.split() for line in file.read_text().splitlines()]
    at, tags = lines.index(["$Nodes"]) + 2, []
    while lines[at] != ["$EndNodes"]:
        count = int(lines[at][3])
        tags += [int(line[0]) for line in lines[at + 1 : at + 1 + count]]
        at += 1 + 2 * count
    at, of_elements = lines.index(["$Elements"]) + 2, []
    while lines[at] != ["$EndElements"]:
        count = int(lines[at][3])
        of_elements += [int(line[0]) for line in lines[at + 1 : at + 1 + count] if lines[at][0] == "3"]
        at += 1 + count
    return tags, of_elements


def test_numbers_are_those_of_the_file(tmp_path: pathlib.Path) -> None:
    """Nastran has numbers of its own, Medit counts from 1."""
    points, cells = a_mesh("hex8")
    meshio.write(tmp_path / "m.mesh", meshio.Mesh(points, cells))
    assert numbers(rw.load_mesh(tmp_path / "m.mesh"), tmp_path / "m.msh")[0] == list(range(1, len(points) + 1))
    (tmp_path / "own.bdf").write_text("CEND\nBEGIN BULK\nGRID,7,,0.,0.,0.\nGRID,9,,1.,0.,0.\nGRID,8,,0.,1.,0.\n"
                                      "GRID,70,,0.,0.,1.\nCTETRA,55,1,7,9,8,70\nENDDATA\n")
    mesh = rw.load_mesh(tmp_path / "own.bdf")
    assert numbers(mesh, tmp_path / "own.msh") == ([7, 9, 8, 70], [55])
    assert list(mesh.cell_sets["volume-1"][0]) == [0]


def write_med(file: pathlib.Path) -> None:
    points, cells = a_mesh("tet4")
    end = np.flatnonzero(points[:, 0] < 0.1)
    tags = np.zeros(len(points), np.int64)
    tags[end] = 2
    halves = np.where(points[cells[0][1], 0].mean(axis=1) < 0.3, -6, -7)
    mesh = meshio.Mesh(points, cells, point_data={"point_tags": tags}, cell_data={"cell_tags": [halves]})
    mesh.point_tags, mesh.cell_tags = {2: ["clamp"]}, {-6: ["near", "steel"], -7: ["far", "steel"]}
    meshio.write(file, mesh)


def write_medit(file: pathlib.Path) -> None:
    points, cells = a_mesh("tet4")
    face = np.flatnonzero(points[:, 0] < 0.1)
    tetrahedra = cells[0][1]
    triangles = np.array([[n for n in t if n in face] for t in tetrahedra if np.isin(t, face).sum() == 3])
    marks = np.where(points[tetrahedra, 0].mean(axis=1) < 0.3, 6, 7)
    meshio.write(file, meshio.Mesh(points, [("triangle", triangles), cells[0]],
                                   point_data={"medit:ref": np.zeros(len(points), int)},
                                   cell_data={"medit:ref": [np.full(len(triangles), 4), marks]}))


@pytest.mark.parametrize("write,extension,clamp,near,far", [
    (write_med, "med", "clamp", "near", "far"), (write_medit, "mesh", "surface-4", "volume-6", "volume-7"),
    (write_medit, "xdmf", "surface-4", "volume-6", "volume-7")])  # fmt: skip
def test_groups_are_sets_that_a_scene_can_hold(tmp_path: pathlib.Path, write: Any, extension: str, clamp: str, near: str,
                                               far: str) -> None:
    file = tmp_path / f"mesh.{extension}"
    write(file)
    mesh = rw.load_mesh(file)
    held = np.flatnonzero(mesh.points[:, 0] < 0.1)
    assert len(held) and list(mesh.node_sets[clamp]) == list(held)
    middle = mesh.points[mesh.cells["tet4"], 0].mean(axis=1)
    assert list(mesh.cell_sets[near][0]) == list(np.flatnonzero(middle < 0.3))
    (tmp_path / "scene.toml").write_text(f"""
[mesh]
file = "mesh.{extension}"
[[material]]
set = "{near}"
model = "linear"
young = 1e5
poisson = 0.3
density = 1000
[[material]]
set = "{far}"
model = "linear"
young = 2e5
poisson = 0.3
density = 1000
[integrator]
step = "auto"
end = 0.01
[[fix]]
set = "{clamp}"
[[force]]
where = "all"
acceleration = [0, 0, -9.81]
[output]
every = 0.01
picture = false
""")
    result = call("run", tmp_path / "scene.toml", "--out", tmp_path / "out")
    assert result.returncode == 0, result
    frames = sorted((tmp_path / "out").glob("**/*.vtu"))
    frame = meshio.read(frames[-1])
    still = np.linalg.norm(frame.point_data["displacement"], axis=1) == 0
    assert {tuple(point) for point in frame.points[still]} == {tuple(point) for point in mesh.points[held]}


def exodus_of_cubit(file: pathlib.Path, element: str, type_: str) -> tuple[NDArray[np.float64], list[tuple[str, Any]]]:
    """As Cubit and MOOSE write it: named blocks and sets, numbers of its own, sides, and Exodus' order of nodes."""
    points, cells = a_mesh(element)
    data = cells[0][1]
    stored = data[:, [*range(12), *range(16, 20), *range(12, 16)]] if element == "hex20" else data
    half = len(data) // 2
    with netCDF4.Dataset(file, "w", format="NETCDF3_64BIT_OFFSET") as out:
        for name, size in (("num_dim", 3), ("num_nodes", len(points)), ("num_elem", len(data)), ("num_el_blk", 2),
                           ("num_node_sets", 1), ("num_side_sets", 1), ("len_string", 33), ("nodes", data.shape[1]),
                           ("in1", half), ("in2", len(data) - half), ("ns", 2), ("ss", 1)):  # fmt: skip
            out.createDimension(name, size)

        def put(name: str, type_: str, shape: tuple[str, ...], values: Any) -> Any:
            variable = out.createVariable(name, type_, shape)
            variable[:] = values
            return variable

        def names(*texts: str) -> NDArray[Any]:
            return np.array([list(text.ljust(33, "\0")) for text in texts], "S1")

        for k, axis in enumerate("xyz"):
            put(f"coord{axis}", "f8", ("num_nodes",), points[:, k])
        put("eb_prop1", "i4", ("num_el_blk",), [10, 20])
        put("eb_names", "S1", ("num_el_blk", "len_string"), names("steel", ""))
        put("connect1", "i4", ("in1", "nodes"), stored[:half] + 1).elem_type = type_
        put("connect2", "i4", ("in2", "nodes"), stored[half:] + 1).elem_type = type_
        put("ns_prop1", "i4", ("num_node_sets",), [3])
        put("ns_names", "S1", ("num_node_sets", "len_string"), names(""))
        put("node_ns1", "i4", ("ns",), [1, 5])
        put("ss_prop1", "i4", ("num_side_sets",), [4])
        put("ss_names", "S1", ("num_side_sets", "len_string"), names("load"))
        put("elem_ss1", "i4", ("ss",), [len(data)])
        put("side_ss1", "i4", ("ss",), [2])
        put("node_num_map", "i4", ("num_nodes",), np.arange(len(points)) + 100)
        put("elem_num_map", "i4", ("num_elem",), np.arange(len(data)) + 500)
    return points, [(element, data)]


@pytest.mark.parametrize("element,type_", [("tet4", "TETRA4"), ("tet10", "TETRA"), ("hex8", "HEX8"), ("hex20", "HEX20"),
                                           ("wedge6", "WEDGE6")])  # fmt: skip
def test_exodus_keeps_blocks_sets_sides_numbers_and_its_order_of_nodes(tmp_path: pathlib.Path, element: str, type_: str) -> None:
    points, [(_, data)] = exodus_of_cubit(tmp_path / "m.e", element, type_)
    mesh = rw.load_mesh(tmp_path / "m.e")
    assert np.array_equal(mesh.points, points) and np.array_equal(mesh.cells[element], data)
    half = len(data) // 2
    assert list(mesh.cell_sets["steel"][0]) == list(range(half))
    assert list(mesh.cell_sets["block-20"][0]) == list(range(half, len(data)))
    assert list(mesh.node_sets["nodeset-3"]) == [0, 4]
    kept = numbers(mesh, tmp_path / "m.msh")
    assert kept == (list(range(100, 100 + len(points))), list(range(500, 500 + len(data))))
    # The nodes of the last element that lie in the plane of its second side, by their place.
    sides = {"tet4": [1, 2, 3], "tet10": [1, 2, 3], "hex8": [1, 2, 6, 5], "hex20": [1, 2, 6, 5], "wedge6": [1, 2, 5, 4]}
    corners = points[data[-1][sides[element]]]
    normal = np.cross(corners[1] - corners[0], corners[2] - corners[0])
    flat = np.abs((points[data[-1]] - corners[0]) @ normal) < (1e-9 if element in ("tet10", "hex20") else 1e-2) * np.linalg.norm(normal)
    on = set(data[-1][flat]) if element in ("tet10", "hex20") else set(data[-1][sides[element]])
    assert set(mesh.node_sets["load"]) == on


def test_a_sound_wedge_is_taken_as_it_is(tmp_path: pathlib.Path) -> None:
    points, [(_, data)] = exodus_of_cubit(tmp_path / "m.e", "wedge6", "WEDGE6")
    meshio.write(tmp_path / "m.mesh", meshio.Mesh(points, [("wedge", data)]))
    (tmp_path / "m.bdf").write_text("BEGIN BULK\n" + "".join(f"GRID,{n},,{x:.7f},{y:.7f},{z:.7f}\n" for n, (x, y, z) in enumerate(points, 1))
                                    + "".join(f"CPENTA,{e},1,{','.join(map(str, own))}\n" for e, own in enumerate(data + 1, 1)) + "ENDDATA\n")
    for name in ("m.e", "m.mesh", "m.bdf"):
        mesh = rw.load_mesh(tmp_path / name)
        assert np.array_equal(mesh.cells["wedge6"], data) and not any("turned" in note for note in mesh.notes), mesh.notes


def test_what_is_missing_is_named_with_its_packages(tmp_path: pathlib.Path) -> None:
    exodus_of_cubit(tmp_path / "m.e", "tet4", "TETRA4")
    (tmp_path / "modules").mkdir()
    (tmp_path / "modules" / "netCDF4.py").write_text('raise ModuleNotFoundError("none", name="netCDF4")\n')
    result = subprocess.run([PROGRAM, "mesh", "check", tmp_path / "m.e"], capture_output=True, text=True,
                            env={**os.environ, "PYTHONPATH": str(tmp_path / "modules")})
    assert result.returncode == 2 and result.stderr.count("\n") == 1, result
    for part in ("m.e: this is a netCDF file, as of Exodus, which meshio reads", "python3-meshio", "python3-netcdf4",
                 "missing is netCDF4"):
        assert part in result.stderr


def test_modules_beside_the_mesh_are_not_run(tmp_path: pathlib.Path) -> None:
    exodus_of_cubit(tmp_path / "m.e", "tet4", "TETRA4")
    for name in ("netCDF4", "meshio", "numpy"):
        (tmp_path / f"{name}.py").write_text("raise SystemExit(9)\n")
    result = subprocess.run([PROGRAM, "mesh", "check", "m.e"], cwd=tmp_path, capture_output=True, text=True)
    assert result.returncode == 0, result


TETRAHEDRON = "GRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\nGRID,3,,0.,1.,0.\nGRID,4,,0.,0.,1.\nctetra,1,,1,2,3,4\n"


def test_cards_of_nastran_in_each_format_are_one_mesh(tmp_path: pathlib.Path) -> None:
    points, [(_, data)] = a_mesh("hex8")
    points = np.round(points, 4)

    def fixed(card: str, width: int, values: list[Any]) -> str:
        star, a_line = "*" * (width == 16), 64 // width
        parts = ["".join(str(value).ljust(width) for value in values[i : i + a_line]) for i in range(0, len(values), a_line)]
        return (card + star).ljust(8) + f"\n{star:8}".join(parts) + "\n"

    decks = ["".join(fixed("GRID", width, [n, "", *point]) for n, point in enumerate(points, 1))
             + "".join(fixed("CHEXA", width, [e, 9, *own]) for e, own in enumerate(data + 1, 1)) for width in (8, 16)]  # fmt: skip
    decks.append("".join(f"grid*,{n},,{x},{y}\n*,{z}\n" for n, (x, y, z) in enumerate(points, 1))
                 + "".join(f"CHEXA,{e},9,{','.join(map(str, own[:6]))},+A\n+A,{own[6]},{own[7]}\n" for e, own in enumerate(data + 1, 1)))
    for deck in decks:
        (tmp_path / "m.BDF").write_text(deck)
        mesh = rw.load_mesh(tmp_path / "m.BDF")
        assert np.array_equal(mesh.points, points) and np.array_equal(mesh.cells["hex8"], data)
        assert list(mesh.cell_sets["volume-9"][0]) == list(range(len(data)))
    (tmp_path / "m.bdf").write_text(TETRAHEDRON)
    assert list(rw.load_mesh(tmp_path / "m.bdf").cell_sets["volume-1"][0]) == [0]  # a property without a number has the element's


def test_names_given_twice_are_one_set_and_may_have_any_letters(tmp_path: pathlib.Path) -> None:
    nodes = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 1 1\n"
    (tmp_path / "m.vol").write_text("mesh3d\ndimension\n3\ngeomtype\n0\nvolumeelements\n2\n1 4 1 3 2 4\n2 4 2 4 3 5\npoints\n5\n" + nodes
                                    + 'materials\n2\n1 soft <"&\n2 soft <"&\nendmesh\n')
    assert list(rw.load_mesh(tmp_path / "m.vol").cell_sets['soft <"&'][0]) == [0, 1]
    (tmp_path / "m.su2").write_text("NDIME = 3\nNELEM = 2\n10 0 1 2 3\n10 1 2 3 4\nNPOIN = 5\n" + nodes + "NMARK = 3\n" + "".join(
        f"MARKER_TAG = {name}\nMARKER_ELEMS = 1\n5 {own}\n" for name, own in (("a'b", "0 1 2"), ("0", "0 1 3"), ("a'b", "1 2 4"))))
    sets = rw.load_mesh(tmp_path / "m.su2").node_sets
    assert list(sets["a'b"]) == [0, 1, 2, 4] and list(sets["surface-0"]) == [0, 1, 3]


def test_a_program_that_is_ended_leaves_nothing(tmp_path: pathlib.Path) -> None:
    (tmp_path / "m.su2").write_text("NDIME= 3\n")
    (tmp_path / "modules").mkdir()
    (tmp_path / "temporary").mkdir()
    (tmp_path / "modules" / "meshio.py").write_text(f"import os, time\nopen({str(tmp_path / 'began')!r}, 'w').write(str(os.getpid()))\ntime.sleep(60)\n")
    program = subprocess.Popen([PROGRAM, "mesh", "check", str(tmp_path / "m.su2")],
                               env={**os.environ, "PYTHONPATH": str(tmp_path / "modules"), "TMPDIR": str(tmp_path / "temporary")})

    def wait_for(what: Any) -> None:
        end = time.monotonic() + 30
        while not what():
            assert time.monotonic() < end
            time.sleep(0.02)

    wait_for(lambda: (tmp_path / "began").exists() and (tmp_path / "began").read_text())
    program.kill()
    program.wait()
    wait_for(lambda: not list((tmp_path / "temporary").iterdir()))


@pytest.mark.parametrize("name,content,said", [
    ("m.msh", "MESH dimension 3 ElemType Hexahedra Nnode 8\n", "a GiD mesh, which is not read"),
    ("m.msh", '(0 "a mesh")\n(2 3)\n', "a Fluent mesh, which is not read; it gives cells by their faces"),
    ("m.rad", "#RADIOSS STARTER\n/BEGIN\n", "a Radioss deck, which is not read; OpenRadioss reads LS-DYNA decks, too"),
    ("m.xml", "<?xml version='1.0'?>\n<mujoco model='m'/>\n", "a model of MuJoCo (MJCF), which is not read"),
    ("m.stl", "solid a\nendsolid a\n", "a surface in STL, which is not read; a surface has no volume elements"),
    ("m.vtu", "version https://git-lfs.github.com/spec/v1\noid sha256:0\n", "a pointer of Git LFS"),
    ("m.mesh", "MeshVersionFormatted 2\nDimension 3\nVertices\n3\n0 0 0 0\n1 0 0 0\n0 1 0 0\nTriangles\n1\n1 2 3 0\nEnd\n",
     "there are no volume elements, only 1 of surfaces"),
    ("m.mesh", "MeshVersionFormatted 2\nDimension 3\nVertices\n3\n0 0 0 0\n1 0 0 0\n0 1 0 0\nTetrahedra\n1\n1 2 3 0 0\nEnd\n",
     "it has a tetra with node 0; there are 3 nodes"),
    ("m.mesh", "MeshVersionFormatted 2\nDimension 3\nVertices\n99999999999\n0 0 0 0\nEnd\n",
     "a Medit mesh; meshio cannot read it: it asks for more memory than there is; is a count in it damaged?"),
    ("m.unv", "    -1\n  2411\n         1         1         1        11\n 0.0 0.0 0.0\n", "m.unv:1: this is a universal file (UNV) whose dataset 2411 has no end, a line of -1; is it cut short?"),
    ("m.mesh", "MeshVersionFormatted 2\nWhat\n", "a Medit mesh; meshio cannot read it: Expected `Vertices`"),
    ("m.bdf", "BEGIN BULK\nGRID,1,7,0.,0.,0.\nGRID,2,7,1.,0.,0.\nGRID,3,7,0.,1.,0.\nGRID,4,7,0.,0.,1.\nCTETRA,1,1,1,2,3,4\nENDDATA\n",
     "line 2: GRID has coordinate system 7; only the basic one is read"),
    ("m.bdf", TETRAHEDRON + "GRDSET,,7\n", "line 6: GRDSET has coordinate system 7"),
    ("m.bdf", TETRAHEDRON + "GRID,1,,0.,0.,0.\n", "line 6: GRID 1 stands a second time"),
    ("m.bdf", TETRAHEDRON + "  include 'other.bdf'\n", "line 6: INCLUDE is not read"),
    ("m.bdf", TETRAHEDRON + "CIHEX2,2,1,1,2,3,4\n", "line 6: CIHEX2 is not known"),
    ("m.bdf", TETRAHEDRON + "CTETRA,2,1,1,2,3,4,5\n", "line 6: CTETRA 2 needs 4 nodes or 10"),
    ("m.bdf", TETRAHEDRON + "CTETRA,2,1,1,2,3,9\n", "line 6: CTETRA 2 has node 9, which has no GRID"),
    ("m.bdf", "GRID,1,,0,0,0\nGRID,2,,1,0,0\n" + "CPENTA,2,1," + ",".join("12" * 3) + ",\n,,," + ",".join("1" * 5) + "\n", "line 3: CPENTA 2 needs 6 nodes or 15"),
    ("m.mdpa", "Begin Nodes\n", "a model part of Kratos, which is not read"),
    ("M.TEC", "TITLE\n", "a Tecplot file, which is not read"),
    ("m.xdmf", '<Xdmf><Domain><Grid><Geometry><DataItem Endian="Big"/></Geometry></Grid></Domain></Xdmf>', 'DataItem has Endian="Big", which is not read'),
    ("m.xdmf", '<Xdmf><Domain><Grid><Topology Order="0 1 3 2" BaseOffset="0"/></Grid></Domain></Xdmf>', 'Topology has Order="0 1 3 2", which is not read'),
    ("m.xdmf", '<Xdmf><Domain><Grid><Topology BaseOffset="1"/></Grid></Domain></Xdmf>', 'Topology has BaseOffset="1", which is not read'),
    ("m.bdf", "BEGIN BULK\nINCLUDE 'other.bdf'\nENDDATA\n", "line 2: INCLUDE is not read"),
    ("m.bdf", "BEGIN BULK\nGRID,1,,0.,0.,0.\nCHEXA*  1               1\nENDDATA\n", "line 3: CHEXA 1 needs 8 nodes or 20"),
    ("m.xdmf", '<?xml version="1.0"?>\n<Xdmf Version="3.0"><Domain/></Xdmf>\n', "an XDMF file; meshio cannot read it"),
])  # fmt: skip
def test_what_cannot_be_read_is_named_in_one_line(tmp_path: pathlib.Path, name: str, content: str, said: str) -> None:
    (tmp_path / name).write_text(content)
    result = call("mesh", "check", tmp_path / name)
    assert result.returncode == 2 and result.stderr.count("\n") == 1 and said in result.stderr, result


def test_elements_that_are_not_known_are_refused_by_name(tmp_path: pathlib.Path) -> None:
    exodus_of_cubit(tmp_path / "m.e", "hex20", "HEX20")
    with netCDF4.Dataset(tmp_path / "m.e", "a") as file:
        file["connect2"].elem_type = "HEX21"
    assert call("mesh", "check", tmp_path / "m.e").returncode == 0  # the connectivity counts
    for kind, name in (("WEDGE", "wedge16"), ("PYRAMID", "pyramid14"), ("WEDGE", "wedge15"), ("PYRAMID", "pyramid13")):
        nodes = int(name.lstrip("wedgpyrami"))
        with netCDF4.Dataset(tmp_path / "m.e", "w") as file:
            for dimension, size in (("num_dim", 3), ("num_nodes", nodes), ("num_el_blk", 1), ("one", 1)):
                file.createDimension(dimension, size)
            file.createVariable("coord", "f8", ("num_dim", "num_nodes"))[:] = np.random.default_rng(2).random((3, nodes))
            connectivity = file.createVariable("connect1", "i4", ("one", "num_nodes"))
            connectivity[:] = np.arange(nodes)[None] + 1
            connectivity.elem_type = kind
        result = call("mesh", "check", tmp_path / "m.e")
        if nodes in (15, 13):  # of which the corners are had
            assert f"1 {name} are read as" in result.stdout, result
        else:
            assert result.returncode == 2 and f"has 1 elements of type {name}, which are not supported" in result.stderr, result


@pytest.mark.parametrize("extension", ["msh", "vtk", "vtu", "xdmf"])
def test_hexahedra_of_27_nodes_are_read_as_those_of_20_with_a_note(tmp_path: pathlib.Path, extension: str) -> None:
    points, [(_, cells)] = a_mesh("hex20")
    corners = points[cells[:, :8]]
    faces = ([0, 4, 7, 3], [1, 2, 6, 5], [0, 1, 5, 4], [3, 2, 6, 7], [0, 3, 2, 1], [4, 5, 6, 7], list(range(8)))
    inner = [corners[:, face].mean(axis=1) for face in faces]
    more = len(points) + np.arange(7 * len(cells)).reshape(len(cells), 7)
    both = np.concatenate([points, np.stack(inner, axis=1).reshape(-1, 3)])
    meshio.write(tmp_path / f"m.{extension}", meshio.Mesh(both, [("hexahedron27", np.concatenate([cells, more], axis=1))]),
                 file_format={"msh": "gmsh"}.get(extension))
    mesh = rw.load_mesh(tmp_path / f"m.{extension}")
    assert np.array_equal(mesh.points, points) and np.array_equal(mesh.cells["hex20"], cells)
    check = call("mesh", "check", tmp_path / f"m.{extension}")
    assert "3 hex27 are read as hex20, which is another element" in check.stdout, check
    assert call("mesh", "repair", tmp_path / f"m.{extension}", tmp_path / "m20.msh").returncode == 0
    assert "nothing wrong" in call("mesh", "check", tmp_path / "m20.msh").stdout


# Of each shape in VTK's order: the edges, in the order of the nodes on them.
EDGES = {
    "wedge": ((0, 1), (1, 2), (2, 0), (3, 4), (4, 5), (5, 3), (0, 3), (1, 4), (2, 5)),
    "pyramid": ((0, 1), (1, 2), (2, 3), (3, 0), (0, 4), (1, 4), (2, 4), (3, 4)),
}  # fmt: skip


def quadratic(shape: str) -> tuple[NDArray[np.float64], NDArray[np.int64], NDArray[np.int64]]:
    """A bar's points with those in the middles of the edges behind them, and its cells with their corners alone and with both."""
    points, [(_, cells)] = a_mesh(ELEMENTS_OF[shape])
    edges = np.sort(cells[:, np.array(EDGES[shape])].reshape(-1, 2), axis=1)
    unique, places = np.unique(edges, axis=0, return_inverse=True)
    return (np.concatenate([points, points[unique].mean(axis=1)]), cells,
            np.concatenate([cells, len(points) + places.reshape(len(cells), -1)], axis=1))


ELEMENTS_OF = {"wedge": "wedge6", "pyramid": "pyramid5"}


@pytest.mark.parametrize("shape,extension", [(shape, extension) for shape in EDGES for extension in ("msh", "vtk", "vtu", "xdmf", "med", "inp")
                                             if (shape, extension) != ("pyramid", "inp")])  # which meshio does not write
def test_of_quadratic_wedges_and_pyramids_the_corners_are_read_with_a_note(tmp_path: pathlib.Path, shape: str, extension: str) -> None:
    points, cells, both = quadratic(shape)
    kind = f"{shape}{both.shape[1]}"
    file = tmp_path / f"m.{extension}"
    meshio.write(file, meshio.Mesh(points, [(kind, both)]), file_format={"msh": "gmsh"}.get(extension))
    mesh = rw.load_mesh(file)
    assert np.array_equal(mesh.points, points[: cells.max() + 1]) and np.array_equal(mesh.cells[ELEMENTS_OF[shape]], cells)
    check = call("mesh", "check", file)
    assert f"{len(cells)} {kind} are read as {ELEMENTS_OF[shape]}, which is another element" in check.stdout, check


def test_middle_nodes_that_other_elements_keep_are_refused(tmp_path: pathlib.Path) -> None:
    """As a linear wedge the element would leave them hanging."""
    points, _, both = quadratic("wedge")
    wedge = both[0]
    apex = len(points)
    tetrahedron = np.append(wedge[[0, 1, 2]], apex)
    middles = np.append(wedge[[6, 7, 8]], apex + 1 + np.arange(3))
    more = points[tetrahedron[:3]].mean(axis=0) - [0.1, 0, 0]
    all_points = np.concatenate([points, [more], (points[tetrahedron[:3]] + more) / 2])
    meshio.write(tmp_path / "m.vtu", meshio.Mesh(all_points, [("wedge15", wedge[None]), ("tetra10", np.append(tetrahedron, middles)[None])]))
    check = call("mesh", "check", tmp_path / "m.vtu")
    assert check.returncode == 2 and "(wedge15) could be read as linear, but element" in check.stderr, check


def records(numbers: Iterable[int], each: int = 8) -> str:
    """Lines of so many numbers in columns of ten."""
    numbers = list(numbers)
    return "".join("".join(f"{n:10d}" for n in numbers[i : i + each]) + "\n" for i in range(0, len(numbers), each))


def dataset(number: int, text: str) -> str:
    return f"    -1\n{number:6d}\n{text}    -1\n"


# Node i of meshio is node UNIVERSAL[1][i] of a universal file ("Universal File Datasets", the figures of dataset 2412).
UNIVERSAL: dict[str, tuple[int, list[int]]] = {
    "tet4": (111, [0, 1, 2, 3]), "tet10": (118, [0, 2, 4, 9, 1, 3, 5, 6, 7, 8]), "wedge6": (112, [0, 1, 2, 3, 4, 5]),
    "hex8": (115, list(range(8))), "hex20": (116, [0, 2, 4, 6, 12, 14, 16, 18, 1, 3, 5, 7, 13, 15, 17, 19, 8, 9, 10, 11])}  # fmt: skip


@pytest.mark.parametrize("element", UNIVERSAL)
@pytest.mark.parametrize("nodes,elements,groups", [(2411, 2412, 2467), (781, 780, 2430), (15, 2412, 2477), (2411, 780, 2429), (2411, 2412, 2435),
                                                   (2411, 2412, 2452), (781, 2412, 2432), (2411, 2412, 2417)])  # fmt: skip
def test_universal_files_are_read_with_their_groups(tmp_path: pathlib.Path, element: str, nodes: int, elements: int, groups: int) -> None:
    points, blocks = a_mesh(element)
    cells = blocks[0][1] + 1
    descriptor, order = UNIVERSAL[element]
    single, text = nodes == 15, ""
    if single:
        points = np.array([[float(f"{x:.5E}") for x in X] for X in points])
    for n, X in enumerate(points, 1):
        reals = "".join(f"{x:13.5E}" if single else f"{x:25.16E}".replace("E", "D") for x in X) + "\n"
        text += records([n, 1, 1, 11]).rstrip("\n" if single else "") + reals
    file = dataset(nodes, text)
    text = records([900, 24, 1, 1, 1, 1, 7, 3] if elements == 780 else [900, 24, 1, 1, 7, 3]) + records([0, 1, 1]) + records([1, 2, 3])
    for e, cell in enumerate(cells, 10):
        ours = np.empty(len(order), int)
        ours[order] = cell
        material = 5 if e == 10 else 6
        text += records([e, descriptor, 1, 1, 1, material, 7, len(cell)] if elements == 780 else [e, descriptor, 1, material, 7, len(cell)])
        text += records(ours)
    file += dataset(elements, text)
    fields = [0, 0] if groups in (2435, 2452, 2467, 2477) else []
    members = [(7, 4), (7, 2), (8, 11), (8, 900), (2, 1)]
    text = records([3, 0, 0, 0, 0, 0, 0, len(members)]) + "  the left one, 2 \n" + records(sum(([*m, *fields] for m in members), []))
    file += dataset(groups, text + records([4, 0, 0, 0, 0, 0, 0, 0]) + "empty\n\n" + records([5, 0, 0, 0, 0, 0, 0, 1]) + "\n" + records([8, 10, *fields]))
    (tmp_path / "m.unv").write_text(file.replace("\n", "\r\n") if groups == 2477 else file)
    mesh = rw.load_mesh(tmp_path / "m.unv")
    assert np.array_equal(mesh.points, points) and mesh.blocks[0][0] == element
    assert np.array_equal(mesh.blocks[0][1] + 1, cells)
    assert {name: list(sets[0]) for name, sets in mesh.cell_sets.items()} == {
        "the left one, 2": [1], "group-5": [0], "material-5": [0], "material-6": list(range(1, len(cells)))}  # fmt: skip
    assert {name: list(set_) for name, set_ in mesh.node_sets.items()} == {"the left one, 2": [0, 1, 2, 3]}


@pytest.mark.parametrize("order", [1, 2])
@pytest.mark.parametrize("groups", [2467, 2477])
def test_universal_files_of_gmsh_are_its_model(tmp_path: pathlib.Path, order: int, groups: int) -> None:
    if not shutil.which("gmsh"):
        pytest.skip("gmsh is not installed (scripts/setup --remeshing)")
    shape = ('Point(1) = {0, 0, 0}; Extrude {0.3, 0, 0} {Point{1}; Layers{2};} Extrude {0, 1 / 7, 0} {Curve{1}; Layers{2}; Recombine;} '
             'Extrude {0, 0, 0.1} {Surface{5}; Layers{1}; Recombine;} Physical Surface("left", 8) = {18};' if groups == 2467 else
             'SetFactory("OpenCASCADE"); Box(1) = {0, 0, 0, 0.3, 1 / 7, 0.1}; Mesh.MeshSizeMax = 0.1; Physical Surface("left", 8) = {1};')  # fmt: skip
    (tmp_path / "box.geo").write_text(shape + 'Physical Volume("body", 7) = {1}; Mesh.SaveGroupsOfNodes = 1; Mesh.SecondOrderIncomplete = 1;\n')
    for extension, format in (("unv", "unv"), ("msh", "msh22")):
        subprocess.run(["gmsh", "-v", "1", "box.geo", "-3", "-order", str(order), "-format", format, "-bin", "-o", f"m.{extension}"],
                       cwd=tmp_path, check=True)
    text = (tmp_path / "m.unv").read_text()
    (tmp_path / "m.txt").write_text(text.replace("  2477\n", f"  {groups}\n"))  # the content tells the format
    of_unv, of_msh = rw.load_mesh(tmp_path / "m.txt"), rw.load_mesh(tmp_path / "m.msh")
    # gmsh numbers nodes otherwise in each of its formats: they are told by their coordinates.
    ours, theirs = np.lexsort(of_unv.points.T), np.lexsort(of_msh.points.T)
    assert np.array_equal(of_unv.points[ours], of_msh.points[theirs])
    place = np.empty(len(ours), int)
    place[ours] = theirs
    for (name, cells), (other_name, others) in zip(of_unv.blocks, of_msh.blocks, strict=True):
        assert name == other_name and sorted(map(tuple, place[cells])) == sorted(map(tuple, others))
    left = sorted(of_msh.node_sets["left"])
    assert len(left) > 3 and sorted(place[of_unv.node_sets["left"]]) == left
    assert all(len(mesh.cell_sets["body"][0]) == len(mesh.blocks[0][1]) for mesh in (of_unv, of_msh))


OWN_AXES = dataset(2420, records([1]) + "part\n" + records([2, 0, 8]) + "own axes\n{}")
CORNERS = "".join(records([n, 2, 1, 11]) + "".join(f"{x:25.16E}" for x in X) + "\n" for n, X in enumerate(((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)), 1))
TET = dataset(2411, CORNERS) + dataset(2412, records([1, 21, 1, 1, 7, 2]) + records([0, 1, 1]) + records([1, 2]) + records([2, 111, 1, 1, 7, 4]) + records([1, 2, 3, 4]))
IDENTITY = " 1.0D+00 0.0D+00 0.0D+00\n 0.0D+00 1.0D+00 0.0D+00\n 0.0D+00 0.0D+00 1.0D+00\n 0.0D+00 0.0D+00 0.0D+00\n"
GROUP = records([3, 0, 0, 0, 0, 0, 0, 1]) + "left\n"


@pytest.mark.parametrize("text,said", [
    (OWN_AXES.format(IDENTITY) + TET, ""),
    (OWN_AXES.format(IDENTITY.replace(" 1.0D+00 0.0D+00", " 0.0D+00 1.0D+00", 1)) + TET, "m.unv:14: node 1 is in coordinate system 2, which is not followed"),
    (dataset(18, records([2, 0, 0, 8, 1]) + "own axes\n" + 2 * (6 * "  0.00000E+00" + "\n")) + TET, "m.unv:10: node 1 is in coordinate system 2"),
    (TET.replace("       111", "       117"), "m.unv:17: element 2 is of type 117; solids of types 111, 112, 113, 115, 116 and 118 are read"),
    (TET.replace("       111", "       115"), "m.unv:17: element 2 (hex8) has 4 nodes; it must have 8"),
    (TET.replace("         7         4", "         7         3"), "m.unv:18: element 2 has 4 nodes; its first line says 3"),
    (TET.replace("         7         4", "         7-999999999"), "m.unv:17: element 2 has -999999999 nodes"),
    (TET.replace("1.0000000000000000E+00", "1.0000000000000000X+00", 1), 'm.unv:6: node 2: coordinate x is "1.0000000000000000X+00"; it must be a number'),
    (TET + dataset(2467, GROUP + records([7, 9, 0, 0])), 'm.unv:22: group "left" holds node 9, which the file does not have'),
    (TET + dataset(2467, GROUP + records([8, 9, 0, 0])), 'm.unv:22: group "left" holds element 9, which the file does not have'),
    (TET + dataset(2467, GROUP), 'm.unv:24: the dataset ends where group "left" is expected'),
    (TET + dataset(2467, GROUP.replace("         1\n", "9999999999\n")), "m.unv:22: group 3 has 9999999999 members, more than the lines that follow"),
    (dataset(2414, "results\n"), "m.unv: there are no nodes, dataset 2411, 781 or 15"),
])  # fmt: skip
def test_what_is_not_followed_in_universal_files_is_refused(tmp_path: pathlib.Path, text: str, said: str) -> None:
    (tmp_path / "m.unv").write_text(text)
    result = call("mesh", "check", tmp_path / "m.unv")
    assert said in result.stderr and result.returncode == (2 if said else 0), result


def test_notes_of_universal_files(tmp_path: pathlib.Path) -> None:
    units = records([5]).rstrip("\n") + "  mm (milli-newton)         2\n" + "".join(f"{x:25.17E}" for x in (1000, 1000, 1)) + "\n" + f"{273.15:25.17E}\n"
    (tmp_path / "m.unv").write_text(dataset(164, units) + TET + dataset(2414, "results\n"))
    notes = "; ".join(rw.load_mesh(tmp_path / "m.unv").notes)
    assert "a metre has 1000 of its units of length (mm (milli-newton)); its coordinates are taken as they stand" in notes, notes
    assert "skipped, only nodes, elements and their groups are read: dataset 2414" in notes, notes


@pytest.mark.parametrize("order,hexahedra", [(1, False), (1, True), (2, False), (2, True)])
def test_files_of_gmsh_are_its_model(tmp_path: pathlib.Path, order: int, hexahedra: bool) -> None:
    """Medit, Nastran and SU2 as gmsh writes them, against its own format."""
    gmsh = pytest.importorskip("gmsh")
    gmsh.initialize(["gmsh", "-v", "0"])
    try:
        gmsh.model.occ.addBox(0, 0, 0, 0.3, 1 / 7, 0.1)
        gmsh.model.occ.synchronize()
        gmsh.model.setPhysicalName(3, gmsh.model.addPhysicalGroup(3, [1], 7), "body")
        gmsh.model.setPhysicalName(2, gmsh.model.addPhysicalGroup(2, [1], 8), "left")
        gmsh.option.setNumber("Mesh.SecondOrderIncomplete", 1)
        gmsh.option.setNumber("Mesh.MeshSizeMax", 0.1)
        for dimension, tag in gmsh.model.getEntities() if hexahedra else ():
            if dimension == 1:
                gmsh.model.mesh.setTransfiniteCurve(tag, 3)
            if dimension == 2:
                gmsh.model.mesh.setTransfiniteSurface(tag)
                gmsh.model.mesh.setRecombine(2, tag)
            if dimension == 3:
                gmsh.model.mesh.setTransfiniteVolume(tag)
        gmsh.model.mesh.generate(3)
        gmsh.model.mesh.setOrder(order)
        for extension in ("msh", "mesh", "bdf", "su2"):
            gmsh.write(str(tmp_path / f"m.{extension}"))
    finally:
        gmsh.finalize()
    right = rw.load_mesh(tmp_path / "m.msh")
    element = (("tet4", "hex8"), ("tet10", "hex20"))[order - 1][hexahedra]

    def places(mesh: rw.Mesh, nodes: NDArray[np.int32]) -> set[tuple[float, ...]]:
        return {tuple(point) for point in np.round(mesh.points[nodes], 9)}

    left = places(right, right.node_sets["left"])

    def ours(extension: str, digits: float) -> rw.Mesh:
        mesh = rw.load_mesh(tmp_path / f"m.{extension}")
        assert len(mesh.points) == len(right.points) and mesh.cells[element].shape == right.cells[element].shape
        middles, others = (np.sort(m.points[m.cells[element]].mean(axis=1) @ [1, 3.1, 7.7]) for m in (mesh, right))
        assert np.allclose(middles, others, rtol=0, atol=digits)
        return mesh

    ours("bdf", 1e-5)
    if order == 1:
        medit, su2 = ours("mesh", 1e-12), ours("su2", 1e-12)
        assert places(su2, su2.node_sets["left"]) == left
        assert any(places(medit, nodes) == left for nodes in medit.node_sets.values())
    else:
        assert call("mesh", "check", tmp_path / "m.su2").returncode == 2
        result = call("mesh", "check", tmp_path / "m.mesh")
        assert result.returncode == 2 and "a Medit mesh; " in result.stderr, result


def test_tags_of_dolfinx_are_sets(tmp_path: pathlib.Path) -> None:
    """They are grids of some cells and facets, with the points of the first."""
    points, cells = a_mesh("tet4")
    meshio.write(tmp_path / "m.xdmf", meshio.Mesh(points, cells))
    tetrahedra = cells[0][1]

    def grid(shape: str, own: NDArray[np.int64], tags: list[int], more: str = '<xi:include xpointer="xpointer(/Xdmf/Domain/Grid/Geometry)"/>') -> str:
        rows, columns = own.shape
        return (f'<Grid Name="t" GridType="Uniform">{more}<Topology TopologyType="{shape}" NumberOfElements="{rows}" '
                f'NodesPerElement="{columns}"><DataItem Dimensions="{rows} {columns}" NumberType="Int" Format="XML">'
                f'{" ".join(map(str, own.ravel()))}</DataItem></Topology><Attribute Name="tag" AttributeType="Scalar" Center="Cell">'
                f'<DataItem Dimensions="{rows}" NumberType="Int" Format="XML">{" ".join(map(str, tags))}</DataItem></Attribute></Grid>')

    text = (tmp_path / "m.xdmf").read_text().replace("<Xdmf ", '<Xdmf xmlns:xi="http://www.w3.org/2001/XInclude" ')
    series = '<Grid GridType="Collection" CollectionType="Temporal"/>'
    tagged = grid("Tetrahedron", tetrahedra[[5, 2]][:, ::-1], [7, 8]) + grid("Triangle", tetrahedra[3:4, :3], [9]) + series
    (tmp_path / "tagged.xdmf").write_text(text.replace("</Domain>", tagged + "</Domain>"))
    mesh = rw.load_mesh(tmp_path / "tagged.xdmf")
    assert np.array_equal(mesh.points, points) and np.array_equal(mesh.cells["tet4"], tetrahedra)
    assert {name: list(members[0]) for name, members in mesh.cell_sets.items()} == {"tag-7": [5], "tag-8": [2]}
    assert set(mesh.node_sets) == {"tag-9"} and set(mesh.node_sets["tag-9"]) == set(tetrahedra[3, :3])
    assert any("1 grids without cells of their own" in note for note in mesh.notes), mesh.notes
    (tmp_path / "two.xdmf").write_text(text.replace("</Domain>", grid("Triangle", tetrahedra[3:4, :3], [9], "<Geometry/>") + "</Domain>"))
    result = call("mesh", "check", tmp_path / "two.xdmf")
    assert result.returncode == 2 and "several grids with points of their own" in result.stderr, result


def test_the_time_of_a_grid_of_xdmf_is_passed_over(tmp_path: pathlib.Path) -> None:
    points, cells = a_mesh("tet4")
    meshio.write(tmp_path / "m.xdmf", meshio.Mesh(points, cells))
    text = (tmp_path / "m.xdmf").read_text()
    (tmp_path / "timed.xdmf").write_text(text.replace("</Grid>", '<Time Value="0.5"/></Grid>'))
    assert np.array_equal(rw.load_mesh(tmp_path / "timed.xdmf").points, points)


@pytest.mark.parametrize("version", [4.0, 4.1])
def test_a_partition_changes_no_group(tmp_path: pathlib.Path, version: float) -> None:
    """gmsh gives the faces between two parts the numbers of the groups of the volume that they cut."""
    gmsh = pytest.importorskip("gmsh")
    gmsh.initialize(["gmsh", "-v", "0"])
    try:
        gmsh.model.occ.addBox(0, 0, 0, 0.3, 1 / 7, 0.1)
        gmsh.model.occ.synchronize()
        for dimension, name in ((3, "body"), (2, "left")):
            gmsh.model.setPhysicalName(dimension, gmsh.model.addPhysicalGroup(dimension, [1], 8), name)
        gmsh.option.setNumber("Mesh.MeshSizeMax", 0.1)
        gmsh.option.setNumber("Mesh.MshFileVersion", version)
        gmsh.model.mesh.generate(3)
        gmsh.write(str(tmp_path / "whole.msh"))
        gmsh.model.mesh.partition(3)
        gmsh.write(str(tmp_path / "parts.msh"))
    finally:
        gmsh.finalize()
    whole, parts = (rw.load_mesh(tmp_path / f"{name}.msh") for name in ("whole", "parts"))
    for mesh in (whole, parts):
        assert set(mesh.cell_sets) == {"body"} and len(mesh.cell_sets["body"][0]) == mesh.element_count
    left = [{tuple(point) for point in mesh.points[mesh.node_sets["left"]]} for mesh in (whole, parts)]
    assert set(parts.node_sets) == {"left"} and left[0] == left[1]


def test_medit_as_mmg_writes_it(tmp_path: pathlib.Path) -> None:
    """Sections that tell of the shape, a version of long numbers, and blanks before and after."""
    (tmp_path / "m.mesh").write_text("""
MeshVersionFormatted 3

Dimension 3
# nodes
Vertices
 4
0 0 0 1
1 0 0 0
0 1 0 0
0 0 1 0

Corners
2
1
2
RequiredTriangles
1
1
Triangles
1
1 2 3 5
Ridges
1
1
Normals
1
0 0 1
NormalAtVertices
1
1 1
Tetrahedra
1
1 2 3 4 6
End
""")
    mesh = rw.load_mesh(tmp_path / "m.mesh")
    assert np.array_equal(mesh.points, [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
    assert list(mesh.node_sets["surface-5"]) == [0, 1, 2] and list(mesh.cell_sets["volume-6"][0]) == [0]


@pytest.mark.parametrize("element", ["tet4", "tet10", "hex8", "hex20", "wedge6", "pyramid5"])
def test_exodus_of_vtk_is_its_grid(tmp_path: pathlib.Path, element: str) -> None:
    """As VTK's own writer of Exodus has it, whose order of nodes is that of Exodus."""
    exodus = pytest.importorskip("vtkmodules.vtkIOExodus")
    xml = pytest.importorskip("vtkmodules.vtkIOXML")
    points, blocks = a_mesh(element)
    right = rw.Mesh(points, [(NAMES[name], cells) for name, cells in blocks])
    right.save(tmp_path / "m.vtu")
    reader, writer = xml.vtkXMLUnstructuredGridReader(), exodus.vtkExodusIIWriter()
    reader.SetFileName(str(tmp_path / "m.vtu"))
    writer.SetInputConnection(reader.GetOutputPort())
    writer.SetFileName(str(tmp_path / "m.exo"))
    writer.WriteOutBlockIdArrayOff()
    writer.WriteOutGlobalNodeIdArrayOff()
    writer.WriteOutGlobalElementIdArrayOff()
    assert writer.Write() == 1
    mesh = rw.load_mesh(tmp_path / "m.exo")
    assert np.array_equal(mesh.points, points)
    assert np.array_equal(mesh.cells[element], right.cells[element])
    # VTK writes its own wedges as they are, which are of the other handedness than those of Exodus by their sides.
    assert any("turned" in note for note in mesh.notes) == (element == "wedge6")


def test_a_converted_mesh_is_the_same_for_the_monitor(tmp_path: pathlib.Path) -> None:
    write_medit(tmp_path / "m.mesh")
    law = ("--young", 1e6, "--poisson", 0.3, "--density", 1000, "--json", "-")
    assert call("mesh", "convert", tmp_path / "m.mesh", tmp_path / "m.msh").returncode == 0
    results = [json.loads(call("inspect", tmp_path / name, *law).stdout) for name in ("m.mesh", "m.msh")]
    assert results[0]["critical_step"]["safe"] == results[1]["critical_step"]["safe"]
