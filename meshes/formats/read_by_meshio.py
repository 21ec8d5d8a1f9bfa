"""Reads a mesh with meshio and writes it as ringwatch's own .vtu, with its groups as sets.

usage: read_by_meshio.py FILE KIND FOLDER

KIND: a format by meshio's name; "exodus"; "hdf5" for what the file itself tells. Writes FOLDER/mesh.vtu, whose integer fields
originalNodeId, originalElementId and set:NAME are the file's numbers and groups, and notes into FOLDER/said, one a line. Ends with 1
and one line in FOLDER/said where the file is no mesh, and with 3 and the name of a module that is missing.
"""
import contextlib
import io
import os
import re
import sys

# The folder of the file becomes the current one, and modules are not to be found there.
sys.path[:] = [folder for folder in sys.path if folder]

FLAT = (("vertex",), ("line",), ("triangle", "quad"))  # how meshio's names begin, by dimension
DIMENSIONS = ("point", "curve", "surface", "volume")
# Fields of one integer a cell or point that are groups by their very meaning, so that a group is named by dimension and number, as
# ringwatch names groups of gmsh without a name; 0 stands for none.
MARKERS = ("gmsh:physical", "medit:ref", "nastran:ref", "netgen:index", "su2:tag", "avsucd:material")
NO_GROUPS = ("gmsh:geometrical", "gmsh:dim_tags", "cell_ids")
NAMED = "tags of string type"  # what meshio says of SU2's markers, whose names are found here
MOST_VALUES = 1000  # of an integer field that is taken for groups; more are numbers of something else
MEDIT_HEAD = ("MeshVersionFormatted", "Dimension", "Vertices")
MEDIT_CELLS = {"Edges": 2, "Triangles": 3, "Quadrilaterals": 4, "Tetrahedra": 4, "Prisms": 6, "Pyramids": 5, "Hexahedra": 8, "Hexaedra": 8}
CORNERS = {"tetra": 4, "pyramid": 5, "wedge": 6, "hexahedron": 8}
# Of each shape in VTK's order: the edges, in the order of the nodes on them.
EDGES = {
    "tetra": ((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)),
    "pyramid": ((0, 1), (1, 2), (2, 3), (3, 0), (0, 4), (1, 4), (2, 4), (3, 4)),
    "wedge": ((0, 1), (1, 2), (2, 0), (3, 4), (4, 5), (5, 3), (0, 3), (1, 4), (2, 5)),
    "hexahedron": ((0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)),
}
# The sides of Exodus' elements, in their order there.
EXODUS_SIDES = {
    "tetra": ((0, 1, 3), (1, 2, 3), (0, 3, 2), (0, 2, 1)),
    "pyramid": ((0, 1, 4), (1, 2, 4), (2, 3, 4), (0, 4, 3), (0, 3, 2, 1)),
    "wedge": ((0, 1, 4, 3), (1, 2, 5, 4), (0, 3, 5, 2), (0, 2, 1), (3, 4, 5)),
    "hexahedron": ((0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (0, 4, 7, 3), (0, 3, 2, 1), (4, 5, 6, 7)),
}
# Exodus' types by the letters that they begin with, and the nodes of the linear one; meshio's names add the nodes of others.
EXODUS_TYPES = {
    "SPH": ("vertex", 1), "BEA": ("line", 2), "BAR": ("line", 2), "TRU": ("line", 2), "EDG": ("line", 2), "TRI": ("triangle", 3),
    "SHE": ("quad", 4), "QUA": ("quad", 4), "TET": ("tetra", 4), "PYR": ("pyramid", 5), "WED": ("wedge", 6), "HEX": ("hexahedron", 8),
}  # fmt: skip


class Fault(Exception):
    pass


def shape_of(kind):
    return kind.rstrip("0123456789")


def dimension_of(kind):
    return next((d for d, begins in enumerate(FLAT) if kind.startswith(begins)), 3)


class Groups:
    """Groups of nodes and cells by name. Cells of surfaces, lines and points leave their nodes in the group."""

    def __init__(self, points, cells):
        self.points, self.cells = points, cells
        self.of_nodes, self.of_cells = {}, {}

    def add_nodes(self, name, nodes):
        flags = self.of_nodes.setdefault(name, np.zeros(len(self.points), np.int8))
        flags[nodes] = 1

    def add_cells(self, name, block, members):
        kind, data = self.cells[block]
        if dimension_of(kind) < 3:
            return self.add_nodes(name, data[members].ravel())
        flags = self.of_cells.setdefault(name, [np.zeros(len(own), np.int8) for _, own in self.cells])
        flags[block][members] = 1


def named_by_numbers(name, values):
    """The values of an integer field that stand for groups, and what the names of these groups begin with: the name of the field, or None
    where they begin with a dimension."""
    values = np.unique(values)
    if len(values) > MOST_VALUES:
        notes.append(f'"{name}" has {len(values)} different values: they are taken for numbers, not for groups')
        return (), ""
    return (values[values != 0], None) if name in MARKERS else (values, name)


def is_marker(name, data):
    return name not in NO_GROUPS and all(own.dtype.kind in "iu" and own.size == len(own) for own in data)


def groups_of_meshio(mesh, cells, groups):
    def members_of(own):
        own = np.asarray(() if own is None else own)
        return np.flatnonzero(own) if own.dtype == bool else own.astype(np.int64)

    for name, nodes in mesh.point_sets.items():
        groups.add_nodes(str(name), members_of(nodes))
    for name, members in mesh.cell_sets.items():
        if not name.startswith("gmsh:"):
            for block, own in enumerate(members):
                groups.add_cells(str(name), block, members_of(own))
    # Families of MED: a number at each node and cell, and the groups that it stands for.
    point_families, cell_families = getattr(mesh, "point_tags", {}), getattr(mesh, "cell_tags", {})
    physical = {(int(v[0]), int(v[1])): n for n, v in mesh.field_data.items() if np.size(v) == 2}
    for field, data in mesh.point_data.items():
        if not is_marker(field, [data]):
            continue
        if field == "point_tags":
            for number, names in point_families.items():
                for name in names:
                    groups.add_nodes(name, np.flatnonzero(data.ravel() == number))
            continue
        values, begin = named_by_numbers(field, data)
        for value in values:
            groups.add_nodes(f"{begin or DIMENSIONS[0]}-{value}", np.flatnonzero(data.ravel() == value))
    for field, data in mesh.cell_data.items():
        if not is_marker(field, data):
            continue
        if field == "cell_tags" and cell_families:
            for block, own in enumerate(data):
                for number, names in cell_families.items():
                    for name in names:
                        groups.add_cells(name, block, np.flatnonzero(own.ravel() == number))
            continue
        values, begin = named_by_numbers(field, np.concatenate([own.ravel() for own in data]))
        for block, own in enumerate(data):
            dimension = dimension_of(cells[block][0])
            for value in values:
                name = f"{begin or DIMENSIONS[dimension]}-{value}"
                if begin is None:
                    name = physical.get((int(value), dimension), name)
                groups.add_cells(name, block, np.flatnonzero(own.ravel() == value))


def in_vtk_order(kind, data, points):
    """Hexahedra of 20 and 27 nodes have the nodes of upright edges before those of the top in Exodus, behind them in VTK and in files
    that meshio writes as Exodus: where the nodes lie tells it."""
    if shape_of(kind) != "hexahedron" or data.shape[1] < 20:
        return data
    edges = np.array(EDGES["hexahedron"])
    middles = points[data[:, edges]].mean(axis=2)
    here, there = slice(12, 16), slice(16, 20)
    swapped = data.copy()
    swapped[:, here], swapped[:, there] = data[:, there], data[:, here]

    def distance(order):
        return np.linalg.norm(points[order[:, 8:20]] - middles, axis=2).sum()

    return swapped if distance(swapped) < distance(data) else data


def read_exodus(path):
    """Points, cells by block, groups, and the numbers of nodes and of elements. Read here, since meshio 5 knows neither names of blocks,
    nor side sets, nor several of the types, and takes the nodes of hexahedra as they stand."""
    import netCDF4

    with netCDF4.Dataset(path) as file:
        file.set_auto_mask(False)
        held = file.variables

        def named(kind, what, count):
            """The names of blocks or sets; those without one are called by number."""
            numbers = held[f"{kind}_prop1"][:] if f"{kind}_prop1" in held else np.arange(1, count + 1)
            texts = held[f"{kind}_names"][:] if f"{kind}_names" in held else [()] * count
            texts = [b"".join(text).split(b"\0")[0].decode("utf-8", "replace").strip() for text in texts]
            return [text or f"{what}-{number}" for text, number in zip(texts, numbers)]

        def size(name):
            return len(file.dimensions[name]) if name in file.dimensions else 0

        if "coord" in held:
            axes = list(held["coord"][:])
        else:
            axes = [held[f"coord{axis}"][:] for axis in "xyz" if f"coord{axis}" in held]
        if not axes:
            raise Fault("is a netCDF file without the coordinates of an Exodus mesh")
        points = three_axes(np.column_stack(axes))
        cells, block_names = [], []
        for i, name in enumerate(named("eb", "block", size("num_el_blk")), 1):
            if f"connect{i}" not in held:
                continue  # a block without elements
            data = held[f"connect{i}"][:].astype(np.int64) - 1
            theirs = held[f"connect{i}"].elem_type
            shape, least = EXODUS_TYPES.get(theirs[:3].upper(), ("", 0))
            if not shape:
                raise Fault(f'block "{name}" has elements of type {theirs}, which is not known')
            kind = shape if data.shape[1] == least else f"{shape}{data.shape[1]}"
            cells.append((kind, in_vtk_order(kind, data, points)))
            block_names.append(name)
        groups = Groups(points, cells)
        for block, name in enumerate(block_names):
            groups.add_cells(name, block, slice(None))
        for i, name in enumerate(named("ns", "nodeset", size("num_node_sets")), 1):
            if f"node_ns{i}" in held:
                groups.add_nodes(name, held[f"node_ns{i}"][:].astype(np.int64) - 1)
        first = np.cumsum([0] + [len(data) for _, data in cells])
        for i, name in enumerate(named("ss", "sideset", size("num_side_sets")), 1):
            if f"elem_ss{i}" not in held:
                continue
            elements, sides = held[f"elem_ss{i}"][:].astype(np.int64) - 1, held[f"side_ss{i}"][:] - 1
            owners = np.searchsorted(first, elements, side="right") - 1
            for block, (kind, data) in enumerate(cells):
                own, shape = owners == block, shape_of(kind)
                if shape not in CORNERS and own.any():
                    notes.append(f'side set "{name}": {own.sum()} sides of {kind} are left out')
                for side, corners in enumerate(EXODUS_SIDES.get(shape, ())):
                    edges = enumerate(EDGES[shape], CORNERS[shape])
                    on = [*corners, *(node for node, (a, b) in edges if a in corners and b in corners and node < data.shape[1])]
                    groups.add_nodes(name, data[elements[own & (sides == side)] - first[block]][:, on].ravel())
        node_ids = held["node_num_map"][:] if "node_num_map" in held else None
        element_ids = held["elem_num_map"][:] if "elem_num_map" in held else None
    return points, cells, groups, node_ids, element_ids


def hdf5_kind(path):
    import h5py

    with h5py.File(path, "r") as file:
        for name, kind in (("ENS_MAA", "med"), ("CGNSLibraryVersion", "cgns"), ("Base", "cgns"), ("tstt", "h5m")):
            if name in file:
                return kind
        if any(name.startswith("coord") for name in file):
            return "exodus"
    raise Fault("is an HDF5 file of no kind that is known (MED, Exodus, CGNS, MOAB); of an XDMF mesh name the .xdmf file")


# What follows makes copies that meshio takes, of files as other programs write them.


def plain_nastran(path, folder):
    """With the frame that meshio asks for. It passes over cards that it does not know, and over what other files hold."""
    types = meshio.nastran._nastran.nastran_to_meshio_type
    with open(path, encoding="utf-8", errors="replace") as file:
        lines = file.read().splitlines()
    for number, line in enumerate(lines, 1):
        card = re.match(r"[A-Za-z0-9]*\*?", line)[0].upper()
        if card == "INCLUDE" or (card.endswith("*") and card[:-1] in types):
            raise Fault(f"line {number}: {card} is not read; elements in the small or free format in one file are")
    begin = [] if any(line.strip().startswith("BEGIN BULK") for line in lines) else ["BEGIN BULK"]
    return written(folder, "mesh.bdf", [*begin, *lines, "ENDDATA"])


def plain_medit(path, folder):
    """Without sections that tell of the shape (Ridges, RequiredTriangles, Normals, …), some of which meshio does not know, and of version
    2: versions differ in binary files."""
    with open(path, encoding="utf-8", errors="replace") as file:
        text = re.sub("#.*", "", file.read())
    names = list(re.finditer(r"^[ \t]*([A-Za-z]\w*)", text, re.M))
    lines = []
    for name, after in zip(names, [*names[1:], None]):
        content = text[name.end() : after.start() if after else None].split(None, 1)
        if re.search(r"[PQ]\d$", name[1]):
            raise Fault(f"{name[1]} are not read: elements are linear ones in what meshio knows of Medit")
        if name[1] == "MeshVersionFormatted":
            content = ["1" if content == ["1"] else "2"]
        row = content[1].split("\n", 1)[0].split() if len(content) > 1 else []
        if len(row) > MEDIT_CELLS.get(name[1], len(row)) + 1:
            raise Fault(f"{name[1]} have {len(row)} numbers a line; linear ones, of {MEDIT_CELLS[name[1]] + 1}, are read")
        if name[1] in MEDIT_HEAD or name[1] in MEDIT_CELLS:
            begin = f"{name[1]} " if name[1] in MEDIT_HEAD[:2] else f"{name[1]}\n"
            lines.append(begin + "\n".join(part.rstrip() for part in content))
    return written(folder, "plain.mesh", [*lines, "End"])


def names_of_su2(path):
    """The numbers that meshio gives to markers with names."""
    names, number = {}, 0
    with open(path, encoding="utf-8", errors="replace") as lines:
        for line in lines:
            tag = re.match(r"\s*MARKER_TAG\s*=\s*(.*?)\s*$", line)
            if tag:
                number = int(tag[1]) if re.fullmatch(r"[-+]?\d+", tag[1]) else number + 1
                if number in names:
                    raise Fault(f'meshio gives the marker "{tag[1]}" the number of "{names[number]}"; call all by names')
                names[number] = tag[1]
    return {name: (number, 2) for number, name in names.items() if not name.isdigit()}


def written(folder, name, lines):
    path = os.path.join(folder, name)
    with open(path, "w", encoding="utf-8") as file:
        file.write("\n".join(lines) + "\n")
    return path


def three_axes(points):
    points = np.asarray(points, dtype=np.float64)
    return np.pad(points, ((0, 0), (0, 3 - points.shape[1])))


def read_file(path, kind, folder):
    if kind == "hdf5":
        kind = hdf5_kind(path)
    if kind == "exodus":
        return read_exodus(path)
    of_meshio = path
    if kind == "nastran":
        of_meshio = plain_nastran(path, folder)
    if kind == "medit" and not path.endswith("b"):  # which tells meshio that it is binary
        of_meshio = plain_medit(path, folder)
    mesh = meshio.read(of_meshio, file_format=kind)
    if kind == "su2":
        mesh.field_data = names_of_su2(path)
    if kind == "nastran" and np.any(mesh.point_data.pop("nastran:ref", 0)):
        raise Fault("GRID cards are in a coordinate system of their own; only the basic one is read")
    points = three_axes(mesh.points)
    cells = [(block.type, np.asarray(block.data, dtype=np.int64)) for block in mesh.cells]
    groups = Groups(points, cells)
    groups_of_meshio(mesh, cells, groups)
    # XDMF and dolfin count from 0, others from 1.
    begin = 0 if kind in ("xdmf", "dolfin-xml") else 1
    node_ids = getattr(mesh, "points_id", np.arange(begin, begin + len(points)))
    element_ids = getattr(mesh, "cells_id", None)  # Nastran's, by block
    return points, cells, groups, node_ids, np.concatenate(element_ids) if element_ids else None


def convert(path, kind, folder):
    points, cells, groups, node_ids, element_ids = read_file(path, kind, folder)
    count = sum(len(data) for _, data in cells)
    if element_ids is None:
        element_ids = np.arange(1, count + 1)
    if count == 0:
        raise Fault("has no elements")
    known = meshio._vtk_common.meshio_to_vtk_type.keys() & meshio._mesh.topological_dimension.keys()
    for name, data in cells:
        if name not in known:
            raise Fault(f"has {len(data)} elements of type {name}, which are not supported")
    for name, data in cells:
        if data.size and (data.min() < 0 or data.max() >= len(points)):
            raise Fault(f"has a {name} with node {data.max() + 1}; there are {len(points)} nodes")
    point_data = {f"set:{name}": flags for name, flags in groups.of_nodes.items()}
    cell_data = {f"set:{name}": flags for name, flags in groups.of_cells.items()}
    if node_ids is not None:
        point_data["originalNodeId"] = np.asarray(node_ids, dtype=np.int64)
    cell_data["originalElementId"] = np.split(
        np.asarray(element_ids, dtype=np.int64), np.cumsum([len(data) for _, data in cells])[:-1]
    )
    # meshio puts wedges into VTK's order itself.
    meshio.write_points_cells(
        os.path.join(folder, "mesh.vtu"), points, cells, point_data, cell_data, file_format="vtu", compression=None
    )


def say(folder, lines):
    with open(os.path.join(folder, "said"), "w", encoding="utf-8") as file:
        file.writelines(" ".join(line.split()) + "\n" for line in lines)


source, kind_of_source, target = sys.argv[1:]
notes = []
status = 0
heard = io.StringIO()  # what meshio says
try:
    import meshio
    import numpy as np

    os.chdir(os.path.dirname(source))
    with contextlib.redirect_stdout(heard), contextlib.redirect_stderr(heard):
        convert(source, kind_of_source, target)
    warned = heard.getvalue().replace("\n", " ").split("Warning:")
    say(target, [*notes, *(f"meshio says: {text}" for text in dict.fromkeys(warned) if text.strip() and NAMED not in text)])
except ModuleNotFoundError as fault:
    say(target, [str(fault.name)])
    status = 3
except Fault as fault:
    say(target, [str(fault)])
    status = 1
except (Exception, SystemExit) as fault:  # meshio raises what comes, and ends the program where it cannot read
    said = heard.getvalue() if isinstance(fault, SystemExit) else f"{type(fault).__name__}: {fault}"
    if isinstance(fault, KeyError):
        said = f"it does not know {fault}"
    said = re.sub(r"Error: Couldn't read file.*", "", said, flags=re.S).strip() or "it is not as meshio knows the format"
    say(target, [f"meshio cannot read it: {said}"])
    status = 1
sys.exit(status)
