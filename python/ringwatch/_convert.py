"""Meshes of other packages."""
from __future__ import annotations

import importlib
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._errors import InputError
from ._ringwatch import Mesh, _elements

# meshio's names of cells with volume. Its order of nodes is ours.
_ELEMENT_OF_MESHIO = {
    "tetra": "tet4",
    "tetra10": "tet10",
    "hexahedron": "hex8",
    "hexahedron20": "hex20",
    "wedge": "wedge6",
    "pyramid": "pyramid5",
}
# Surfaces, lines and points that such files hold beside the volume.
_BELOW_VOLUME_BY_DIMENSION = (("vertex",), ("line",), ("triangle", "quad", "polygon"))
_BELOW_VOLUME = tuple(name for names in _BELOW_VOLUME_BY_DIMENSION for name in names)


def mesh_from(source: Any) -> Mesh:
    """The mesh of an object of another package.

    source: a vtkUnstructuredGrid, which PyVista's are too, with the sets that ringwatch writes into .vtu files; gmsh, the module, for its current model, with its numbers of
    nodes and elements and its physical groups of surfaces, lines and points as node sets; a meshio.Mesh, or any object
    with `points` (N, 3) and `cells`, each with a `type` and `data`, and its groups where it has them: point sets, and
    cell sets and physical groups of surfaces, lines and points, become node sets, those of volumes cell sets. Cells with volume become a block for each of their
    types, or of meshio's blocks, in their order; surfaces, lines and points are left out. Coordinates are taken as m.
    Raises InputError for another object and for cells that ringwatch does not have.
    """
    if hasattr(source, "GetCellTypesArray"):
        return _from_vtk(source)
    model = getattr(source, "model", source)
    if hasattr(getattr(model, "mesh", None), "getElementTypes"):
        return _from_gmsh(model)
    try:
        points, cells = source.points, list(source.cells)
        named = [(str(block.type), np.asarray(block.data)) for block in cells]
    except (AttributeError, TypeError):
        raise InputError(
            f"mesh_from: an object of type {type(source).__name__}; must be a vtkUnstructuredGrid, the module gmsh, or "
            "have points and cells as a meshio.Mesh has"
        ) from None
    blocks, volumes = [], []
    for i, (name, data) in enumerate(named):
        if name in _ELEMENT_OF_MESHIO:
            blocks.append((_ELEMENT_OF_MESHIO[name], data))
            volumes.append(i)
        elif not name.startswith(_BELOW_VOLUME):
            known = ", ".join(_ELEMENT_OF_MESHIO)
            raise InputError(f"mesh_from: unknown cells '{name}'; known are {known}, and those without volume")
    node_sets = {str(name): np.asarray(nodes, dtype=np.int64) for name, nodes in getattr(source, "point_sets", {}).items()}
    cell_sets: dict[str, list[NDArray[np.int64]]] = {}
    for name, members in _groups(source, named).items():
        flat = [data[own].ravel() for i, ((_, data), own) in enumerate(zip(named, members)) if i not in volumes]
        nodes = np.unique(np.concatenate([np.empty(0, np.int64), *flat, node_sets.get(name, np.empty(0, np.int64))]))
        if nodes.size:
            node_sets[name] = nodes.astype(np.int64)
        if any(members[i].size for i in volumes):
            cell_sets[name] = [members[i] for i in volumes]
    return Mesh(np.ascontiguousarray(points, dtype=np.float64), blocks, node_sets=node_sets, cell_sets=cell_sets)


def grid_of(mesh: Mesh, x: NDArray[np.float64] | None = None, **fields: NDArray[Any] | Sequence[NDArray[Any]]) -> Any:
    """A mesh at positions x ((N, 3), m; at rest without them) as an unstructured grid, for pictures in 3-D.

    fields: by name a number for each node, (N,), or (N, 3); or for each element, an array for each block, as
    `Inspection.element_steps`. Returns PyVista's UnstructuredGrid, which `.plot(scalars="NAME")` draws, or without
    PyVista VTK's. Raises InputError for a field of another size, ImportError without VTK (Debian: python3-vtk9).
    """
    data, support = (importlib.import_module(f"vtkmodules.{name}") for name in ("vtkCommonDataModel", "util.numpy_support"))
    core = importlib.import_module("vtkmodules.vtkCommonCore")
    grid, points = data.vtkUnstructuredGrid(), core.vtkPoints()
    points.SetData(support.numpy_to_vtk(np.array(mesh.points if x is None else x, dtype=np.float64), deep=True))
    if points.GetNumberOfPoints() != len(mesh.points):
        raise InputError(f"grid_of: x: {points.GetNumberOfPoints()} positions; the mesh has {len(mesh.points)} nodes")
    grid.SetPoints(points)
    element = {name: (vtk, np.argsort(order)) for name, _, vtk, _, _, order in _elements()}
    for name, nodes in mesh.blocks:
        kind, order = element[name]
        for cell in nodes[:, order].tolist():
            grid.InsertNextCell(kind, len(cell), cell)
    for name, values in fields.items():
        of_nodes = isinstance(values, np.ndarray)
        numbers = values if isinstance(values, np.ndarray) else np.concatenate(list(values))
        wanted = len(mesh.points) if of_nodes else mesh.element_count
        if len(numbers) != wanted:
            raise InputError(f"grid_of: {name}: {len(numbers)} values; {wanted} {'nodes' if of_nodes else 'elements'} need one each")
        array = support.numpy_to_vtk(np.ascontiguousarray(numbers), deep=True)
        array.SetName(name)
        (grid.GetPointData() if of_nodes else grid.GetCellData()).AddArray(array)
    try:
        return importlib.import_module("pyvista").wrap(grid)
    except ImportError:
        return grid


def _groups(source: Any, blocks: list[tuple[str, NDArray[Any]]]) -> dict[str, list[NDArray[np.int64]]]:
    """The cells of each group of a meshio.Mesh, an array for each block: its cell sets, and the physical groups of gmsh."""
    groups: dict[str, list[NDArray[np.int64]]] = {}
    for name, members in getattr(source, "cell_sets", {}).items():
        if not name.startswith("gmsh:"):
            groups[str(name)] = [np.asarray(() if own is None else own, dtype=np.int64) for own in members]
    listed = set(groups)
    names = {(int(tag), int(dimension)): name for name, (tag, dimension) in getattr(source, "field_data", {}).items()}
    for i, tags in enumerate(getattr(source, "cell_data", {}).get("gmsh:physical", [])):
        kind = blocks[i][0]
        dimension = next((d for d, begin in enumerate(_BELOW_VOLUME_BY_DIMENSION) if kind.startswith(begin)), 3)
        for tag in np.unique(np.abs(tags)):
            name = names.get((int(tag), dimension), f"{('point', 'curve', 'surface', 'volume')[dimension]}-{tag}")
            if tag != 0 and name not in listed:
                own = groups.setdefault(name, [np.empty(0, np.int64) for _ in blocks])
                own[i] = np.flatnonzero(np.abs(tags) == tag)
    return groups


def _from_vtk(grid: Any) -> Mesh:
    if grid.GetPoints() is None or grid.GetNumberOfCells() == 0:
        raise InputError(f"mesh_from: a {grid.GetClassName()} without points or cells; a mesh of at least one is needed")
    points = np.array(grid.GetPoints().GetData(), dtype=np.float64).reshape(-1, 3)
    types = np.array(grid.GetCellTypesArray()).ravel()
    offsets = np.array(grid.GetCells().GetOffsetsArray(), dtype=np.int64).ravel()
    nodes = np.array(grid.GetCells().GetConnectivityArray(), dtype=np.int64).ravel()
    element_of_type = {vtk: (name, count, order) for name, count, vtk, _, _, order in _elements()}
    blocks: list[tuple[str, NDArray[np.int64]]] = []
    ids: list[NDArray[np.int64]] = []
    for kind in _in_order(types):
        cells = np.flatnonzero(types == kind)
        if grid.GetCell(int(cells[0])).GetCellDimension() < 3:
            continue
        if kind not in element_of_type:
            known = ", ".join(f"{number} ({name})" for number, (name, _, _) in element_of_type.items() if number)
            raise InputError(
                f"mesh_from: cell {cells[0]} is of VTK's type {kind}; known are {known}, and those without volume"
            )
        name, count, order = element_of_type[kind]
        begin = offsets[cells]
        if np.any(offsets[cells + 1] - begin != count):
            raise InputError(f"mesh_from: cells of VTK's type {kind} without {count} points each; {name} has {count}")
        blocks.append((name, nodes[begin[:, None] + np.array(order)]))
        ids.append(cells.astype(np.int64))
    sets: dict[str, NDArray[np.int64]] = {}
    node_ids = None
    for i in range(grid.GetPointData().GetNumberOfArrays()):  # as ringwatch writes them into .vtu
        array = grid.GetPointData().GetArray(i)
        if array is not None and str(array.GetName()).startswith("set:"):
            sets[array.GetName().removeprefix("set:")] = np.flatnonzero(np.array(array).ravel())
        elif array is not None and array.GetName() == "originalNodeId":
            node_ids = np.array(array, dtype=np.int64).ravel()
    original = grid.GetCellData().GetArray("originalElementId")
    if original is not None:
        numbers = np.array(original, dtype=np.int64).ravel()
        ids = [numbers[cells] for cells in ids]
    return Mesh(points, blocks, node_sets=sets, node_ids=node_ids, cell_ids=ids)


def _from_gmsh(model: Any) -> Mesh:
    tags, coordinates, _ = model.mesh.getNodes()
    tags = np.asarray(tags, dtype=np.int64)
    order = np.argsort(tags, kind="stable")

    def rows(numbers: Any) -> NDArray[np.int64]:
        wanted = np.asarray(numbers, dtype=np.int64)
        at = np.searchsorted(tags, wanted, sorter=order)
        return np.asarray(order[at], dtype=np.int64)

    element_of_type = {gmsh: (name, gmsh_order) for name, _, _, gmsh, gmsh_order, _ in _elements()}
    blocks: list[tuple[str, NDArray[np.int64]]] = []
    ids: list[NDArray[np.int64]] = []
    for kind in model.mesh.getElementTypes(3):
        named, _, _, count, *_ = model.mesh.getElementProperties(kind)
        if kind not in element_of_type:
            known = ", ".join(f"{number} ({name})" for number, (name, _) in element_of_type.items() if number)
            raise InputError(f"mesh_from: elements of gmsh's type {kind}, {named}; known are {known}")
        name, gmsh_order = element_of_type[kind]
        elements, nodes = model.mesh.getElementsByType(kind)
        blocks.append((name, rows(nodes).reshape(-1, count)[:, list(gmsh_order)]))
        ids.append(np.asarray(elements, dtype=np.int64))
    if not blocks:
        raise InputError("mesh_from: gmsh's current model has no elements with volume; gmsh.model.mesh.generate(3) makes them")
    sets: dict[str, NDArray[np.int64]] = {}
    for dimension, tag in model.getPhysicalGroups():
        if dimension < 3:
            name = model.getPhysicalName(dimension, tag) or f"{('point', 'curve', 'surface')[dimension]}-{tag}"
            members, _ = model.mesh.getNodesForPhysicalGroup(dimension, tag)
            sets[name] = np.unique(np.concatenate([sets.get(name, np.empty(0, np.int64)), rows(members)]))
    points = np.ascontiguousarray(np.asarray(coordinates, dtype=np.float64).reshape(-1, 3))
    return Mesh(points, blocks, node_sets=sets, node_ids=tags, cell_ids=ids)


def _in_order(values: NDArray[Any]) -> list[int]:
    """Each value once, in the order of their first places."""
    found, first = np.unique(values, return_index=True)
    return [int(value) for value in found[np.argsort(first)]]
