"""Reads a mesh with meshio and writes it as ringwatch's own .vtu, with its groups as sets.

usage: read_by_meshio.py FILE KIND FOLDER

KIND: a format by meshio's name; "exodus"; "hdf5" for what the file itself tells. Writes FOLDER/mesh.vtu, whose integer fields
originalNodeId, originalElementId and set:NAME are the file's numbers and groups, and notes into FOLDER/said, one a line. Ends with 1
and one line in FOLDER/said where the file is no mesh, and with 3 and the name of a module that is missing.
"""
import contextlib
import ctypes
import io
import os
import re
import shutil
import signal
import sys
from xml.sax.saxutils import escape

# The folder of the file becomes the current one, and modules are not to be found there.
sys.path[:] = [folder for folder in sys.path if folder]

MOST_SECONDS = 600  # of one file; meshio does not find the end of some files that are cut off
QUOTE = {'"': "&quot;"}
FLAT = (("vertex",), ("line",), ("triangle", "quad"))  # how meshio's names begin, by dimension
DIMENSIONS = ("point", "curve", "surface", "volume")
# Fields of one integer a cell or point that are groups by their very meaning, so that a group is named by dimension and number, as
# ringwatch names groups of gmsh without a name; 0 stands for none.
MARKERS = ("gmsh:physical", "medit:ref", "netgen:index", "su2:tag")
NO_GROUPS = ("gmsh:geometrical", "gmsh:dim_tags", "cell_ids")
MOST_VALUES = 1000  # of an integer field that is taken for groups; more are numbers of something else
NETGEN_NAMES = {"materials": 3, "bcnames": 2, "cd2names": 1, "cd3names": 0}  # the dimensions of what they name
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
# Of Nastran's elements: the shape, the nodes of the linear and the quadratic one, and whether it is always the latter.
NASTRAN = {
    "CTETRA": ("tetra", 4, 10, False), "CPYRAM": ("pyramid", 5, 13, False), "CPYRA": ("pyramid", 5, 13, False),
    "CPENTA": ("wedge", 6, 15, False), "CHEXA": ("hexahedron", 8, 20, False), "CTRIA3": ("triangle", 3, 3, False),
    "CTRIAR": ("triangle", 3, 3, False), "CTRIA6": ("triangle", 3, 6, True), "CQUAD4": ("quad", 4, 4, False),
    "CQUADR": ("quad", 4, 4, False), "CQUAD8": ("quad", 4, 8, True), "CBAR": ("line", 2, 2, False),
    "CBEAM": ("line", 2, 2, False), "CROD": ("line", 2, 2, False), "CTUBE": ("line", 2, 2, False),
}  # fmt: skip
# How the names of other elements without a volume begin, and of other cards with a C.
NASTRAN_FLAT = ("CELAS", "CBUSH", "CGAP", "CONROD", "CMASS", "CDAMP", "CONM", "CVISC", "CFAST", "CWELD", "CSEAM", "CSHEAR", "CQUAD", "CBEND", "RBE", "RBAR", "RROD")
NASTRAN_OTHERS = (*NASTRAN_FLAT, "CORD", "CEND", "CHBDY", "CONV", "CREEP", "CAERO", "CSET", "CSUP", "CYSYM", "CYJOIN", "CONTACT", "COMMENT")
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


def groups_of_meshio(mesh, cells, groups, physical):
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
            raise Fault("it is a netCDF file without the coordinates of an Exodus mesh")
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
        if "ENS_MAA" in file:
            return "med"
        if any(name.startswith("coord") for name in file):
            return "exodus"
    raise Fault("it is an HDF5 file of no kind that is read (MED and Exodus are); of an XDMF mesh name the .xdmf file")


# What follows makes copies that meshio takes, of files as other programs write them.


def nastran_cards(path):
    """The bulk data: of each card its line, its name in capitals and its fields, with those of the lines that continue it."""
    with open(path, encoding="utf-8", errors="replace") as file:
        lines = [line.split("$")[0].rstrip().expandtabs(8) for line in file]
    begins = [at for at, line in enumerate(lines) if re.match(r"\s*BEGIN\b", line, re.I)]
    if len(begins) > 1:
        raise Fault(f"line {begins[1] + 1}: a second BEGIN; decks of one part are read")
    cards, mark = [], ""
    for number, line in enumerate(lines, 1):
        if re.match(r"\s*INCLUDE\b", line, re.I):
            raise Fault(f"line {number}: INCLUDE is not read; decks in one file are")
        if re.match(r"\s*ENDDATA\b", line, re.I):
            break
        if not line.strip() or number <= (begins[0] + 1 if begins else 0):
            continue
        free = [field.strip() for field in line.split(",")] if "," in line else None
        name = (free[0] if free else line[:8]).strip().upper()
        width = 4 if "*" in name else 8  # fields of a line, in the large format and in the small one
        if free and len(free) > width + 2:
            raise Fault(f"line {number} has {len(free)} fields; at most {width + 2} are read")
        fields = free[1:] if free else [line[8 + i * 64 // width : 8 + (i + 1) * 64 // width].strip() for i in range(width)] + [line[72:80].strip()]
        fields += [""] * (width + 1 - len(fields))
        if name[:1] in ("", "+", "*"):
            if not cards or (name[1:] and mark and name[1:] != mark):
                raise Fault(f"line {number} goes on with a card that does not stand before it")
            cards[-1][2].extend(fields[:width])
        else:
            cards.append((number, name.rstrip("*_"), fields[:width]))  # meshio writes CTETRA_ for one of 10 nodes
        mark = fields[width].upper().lstrip("+*")
    return cards


def read_nastran(path):
    """As read_exodus. Read here, since meshio passes over what it does not know and takes some cards for others."""
    nodes, points, elements, numbers, left_out = {}, [], {}, set(), {}

    def number_in(text, kind, line, card):
        try:  # 1.5-3 and 1.5D-3 are 1.5e-3
            return kind(re.sub(r"(?<=[\d.])([+-])", r"e\1", re.sub("[dD]", "e", text)) if kind is float else text)
        except ValueError:
            raise Fault(f'line {line}: {card} has "{text}" where a number is needed') from None

    for line, card, fields in nastran_cards(path):
        if card in ("GRID", "GRDSET"):
            if fields[1] not in ("", "0"):
                raise Fault(f"line {line}: {card} has coordinate system {fields[1]}; only the basic one is read")
            if card == "GRID":
                node = number_in(fields[0], int, line, card)
                if node in nodes:
                    raise Fault(f"line {line}: GRID {node} stands a second time")
                nodes[node] = len(points)
                points.append([number_in(text or "0", float, line, card) for text in fields[2:5]])
        elif card in NASTRAN:
            shape, linear, quadratic, always = NASTRAN[card]
            element = number_in(fields[0], int, line, card)
            if element in numbers:
                raise Fault(f"line {line}: element {element} stands a second time")
            numbers.add(element)
            given = fields[2 : 2 + quadratic] + [""] * (quadratic - len(fields[2:]))
            count = quadratic if always or any(given[linear:]) else linear
            if not all(given[:count]) or (shape in CORNERS and any(fields[2 + quadratic :])):
                raise Fault(f"line {line}: {card} {element} needs {linear} nodes" + f" or {quadratic}" * (quadratic > linear))
            own = [number_in(text, int, line, card) for text in given[:count]]
            for node in own:
                if node not in nodes:
                    elements.setdefault(None, []).append((line, card, element, node))
            if count == 20:  # upright edges stand before those of the top
                own = own[:12] + own[16:] + own[12:16]
            kind = shape if count == linear else f"{shape}{count}"
            elements.setdefault(kind, []).append((own, element, number_in(fields[1] or fields[0], int, line, card)))
        elif card.startswith("C") and not card.startswith(NASTRAN_OTHERS):
            raise Fault(f"line {line}: {card} is not known")
        elif card.startswith(NASTRAN_FLAT):
            left_out[card] = left_out.get(card, 0) + 1
    for line, card, element, node in elements.pop(None, ()):
        if node not in nodes:
            raise Fault(f"line {line}: {card} {element} has node {node}, which has no GRID")
    if left_out:
        notes.append("left out are " + ", ".join(f"{count} {card}" for card, count in left_out.items()))
    cells = [(kind, np.array([[nodes[node] for node in own] for own, _, _ in held])) for kind, held in elements.items()]
    groups = Groups(np.array(points), cells)
    for block, (kind, held) in enumerate(elements.items()):
        properties = np.array([number for _, _, number in held])
        for number in np.unique(properties):
            groups.add_cells(f"{DIMENSIONS[dimension_of(kind)]}-{number}", block, np.flatnonzero(properties == number))
    return np.array(points), cells, groups, list(nodes), [element for held in elements.values() for _, element, _ in held]


def plain_medit(path, folder):
    """Without sections that tell of the shape (Ridges, RequiredTriangles, Normals, …), some of which meshio does not know, and of version
    2: versions differ in binary files, and meshio rounds the numbers of version 1."""
    with open(path, encoding="utf-8", errors="replace") as file:
        text = re.sub("#.*", "", file.read())
    names = list(re.finditer(r"^[ \t]*([A-Za-z]\w*)", text, re.M))
    lines = []
    for name, after in zip(names, [*names[1:], None]):
        content = text[name.end() : after.start() if after else None].split(None, 1)
        if re.search(r"[PQ]\d$", name[1]):
            raise Fault(f"{name[1]} are not read: elements are linear ones in what meshio knows of Medit")
        if name[1] == "MeshVersionFormatted":
            content = ["2"]
        row = content[1].split("\n", 1)[0].split() if len(content) > 1 else []
        if len(row) > MEDIT_CELLS.get(name[1], len(row)) + 1:
            raise Fault(f"{name[1]} have {len(row)} numbers a line; linear ones, of {MEDIT_CELLS[name[1]] + 1}, are read")
        if name[1] in MEDIT_HEAD or name[1] in MEDIT_CELLS:
            begin = f"{name[1]} " if name[1] in MEDIT_HEAD[:2] else f"{name[1]}\n"
            lines.append(begin + "\n".join(part.rstrip() for part in content))
    return written(folder, "plain.mesh", [*lines, "End"])


def plain_su2(path, folder):
    """With markers numbered from 1, and without blanks before "=", with which meshio passes over a line. Also the name of each number."""
    numbers, lines = {}, []
    with open(path, encoding="utf-8", errors="replace") as file:
        for line in file.read().splitlines():
            key, equals, value = (part.strip() for part in line.split("%")[0].partition("="))
            if key == "MARKER_TAG":
                name = f"surface-{value}" if value.isdigit() else value
                value = numbers.setdefault(name, len(numbers) + 1)
            lines.append(f"{key}{equals}{value}")
    return written(folder, "plain.su2", lines), {(number, 2): name for name, number in numbers.items()}


def names_of_netgen(path):
    """The names of numbers by dimension, of which several may be the same."""
    with open(path, encoding="utf-8", errors="replace") as file:
        lines = file.read().splitlines()
    names = {}
    for at, line in enumerate(lines):
        if line.strip() in NETGEN_NAMES:
            for entry in lines[at + 2 : at + 2 + int(lines[at + 1])]:
                number, *name = entry.split(None, 1)
                if name:
                    names[int(number), NETGEN_NAMES[line.strip()]] = name[0].strip()
    return names


def grids_of_xdmf(path, folder):
    """Files of one grid each without times, which meshio takes: the mesh, and tags of its cells and facets on the same points, as dolfinx writes them.
    What meshio passes over is refused."""
    from xml.etree import ElementTree

    right = {"Endian": ("Little", "Native"), "BaseOffset": ("0",), "Seek": ("0",), "Order": (), "ItemType": ("Uniform",)}
    tree = ElementTree.parse(path)
    for element in tree.iter():
        for key, values in right.items():
            tag = str(element.tag)
            if key == "ItemType" and tag != "DataItem":
                continue
            if element.get(key, values[0] if values else None) not in (*values, None):
                raise Fault(f'{tag} has {key}="{element.get(key)}", which is not read')
    domain = tree.find("Domain")
    grids = [] if domain is None else domain.findall("Grid")
    uniform = [grid for grid in grids if grid.get("GridType", "Uniform") == "Uniform" and grid.find("Topology") is not None]
    if not uniform or uniform[0].find("Geometry") is None:
        return [path]
    if any(grid.find("Geometry") is not None for grid in uniform[1:]):
        raise Fault("it has several grids with points of their own; one mesh is read")
    if len(uniform) < len(grids):
        notes.append(f"{len(grids) - len(uniform)} grids without cells of their own, such as states in time, are left out")
    for item in domain.iter("DataItem"):
        if item.get("Format") == "HDF":
            item.text = os.path.join(os.path.dirname(path), item.text.strip())
    geometry, files = uniform[0].find("Geometry"), []
    for number, grid in enumerate(uniform):
        domain[:] = [grid]
        grid[:] = [geometry, *(part for part in grid if part.tag in ("Topology", "Attribute"))]
        files.append(os.path.join(folder, f"grid{number}.xdmf"))
        tree.write(files[-1])
    return files


def add_tags(groups, path):
    """Groups of a grid that tags some cells and facets of the mesh."""
    tags = meshio.read(path, file_format="xdmf")
    cells = [(block.type, np.asarray(block.data, dtype=np.int64)) for block in tags.cells]
    tagged = Groups(groups.points, cells)
    groups_of_meshio(tags, cells, tagged, {})
    for name, flags in tagged.of_nodes.items():
        groups.add_nodes(name, np.flatnonzero(flags))
    for name, members in tagged.of_cells.items():
        wanted = {tuple(sorted(row)) for own, (_, data) in zip(members, cells) for row in data[own == 1]}
        for block, (_, data) in enumerate(groups.cells):
            groups.add_cells(name, block, [i for i, row in enumerate(np.sort(data, axis=1)) if tuple(row) in wanted])


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
    if kind == "nastran":
        return read_nastran(path)
    of_meshio, names, tags = path, {}, []
    if kind == "medit":
        with open(path, "rb") as file:
            binary = file.read(4) in (b"\1\0\0\0", b"\0\0\0\1")
        if binary:  # which the name tells meshio
            of_meshio = os.path.join(folder, "mesh.meshb")
            os.symlink(path, of_meshio)
        else:
            of_meshio = plain_medit(path, folder)
    if kind == "su2":
        of_meshio, names = plain_su2(path, folder)
    if kind == "netgen":
        names = names_of_netgen(path)
    if kind == "xdmf":
        of_meshio, *tags = grids_of_xdmf(path, folder)
    mesh = meshio.read(of_meshio, file_format=kind)
    points = three_axes(mesh.points)
    cells = [(block.type, np.asarray(block.data, dtype=np.int64)) for block in mesh.cells]
    groups = Groups(points, cells)
    groups_of_meshio(mesh, cells, groups, names)
    for file in tags:
        add_tags(groups, file)
    begin = 0 if kind == "xdmf" else 1  # from where they count
    return points, cells, groups, np.arange(begin, begin + len(points)), None


def convert(path, kind, folder):
    points, cells, groups, node_ids, element_ids = read_file(path, kind, folder)
    count = sum(len(data) for _, data in cells)
    if element_ids is None:
        element_ids = np.arange(1, count + 1)
    if node_ids is None:
        node_ids = np.arange(1, len(points) + 1)
    if count == 0:
        raise Fault("it has no elements")
    known = meshio._vtk_common.meshio_to_vtk_type.keys() & meshio._mesh.topological_dimension.keys()
    for name, data in cells:
        if name not in known:
            raise Fault(f"it has {len(data)} elements of type {name}, which are not supported")
    for name, data in cells:
        if data.size and (data.min() < 0 or data.max() >= len(points)):
            bad = data.min() if data.min() < 0 else data.max()
            raise Fault(f"it has a {name} with node {bad + 1}; there are {len(points)} nodes")
    # meshio writes names into the XML as they are.
    point_data = {f"set:{escape(name, QUOTE)}": flags for name, flags in groups.of_nodes.items()}
    cell_data = {f"set:{escape(name, QUOTE)}": flags for name, flags in groups.of_cells.items()}
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


def leave(*_):
    """Ends with the program that called, and leaves nothing behind."""
    shutil.rmtree(target, ignore_errors=True)
    os._exit(130)


for number in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP):
    signal.signal(number, leave)
PARENT_DEATH = 1  # PR_SET_PDEATHSIG
ctypes.CDLL(None).prctl(PARENT_DEATH, signal.SIGTERM)
signal.alarm(MOST_SECONDS)  # which ends the program
notes = []
status = 0
heard = io.StringIO()  # what meshio says
try:
    import meshio
    import numpy as np

    for kind in "wedge15 pyramid13".split():  # which meshio 5.0 reads and writes, without knowing their dimension
        meshio._mesh.topological_dimension.setdefault(kind, 3)
    os.chdir(os.path.dirname(source))
    with contextlib.redirect_stdout(heard), contextlib.redirect_stderr(heard):
        convert(source, kind_of_source, target)
    warned = heard.getvalue().replace("\n", " ").split("Warning:")
    say(target, [*notes, *(f"meshio says: {text}" for text in dict.fromkeys(warned) if text.strip())])
except ModuleNotFoundError as fault:
    say(target, [str(fault.name)])
    status = 3
except Fault as fault:
    say(target, [str(fault)])
    status = 1
except (Exception, SystemExit) as fault:  # meshio raises what comes, and ends the program where it cannot read
    said = heard.getvalue() if isinstance(fault, SystemExit) else str(fault)
    said = re.sub(r"Error: Couldn't read file.*", "", said, flags=re.S).strip()
    if isinstance(fault, MemoryError):  # or numpy, of a size that it cannot count
        said = "it asks for more memory than there is; is a count in it damaged?"
    elif isinstance(fault, KeyError):
        said = f"it does not know {fault}"
    elif not said or not isinstance(fault, (SystemExit, OSError, meshio.ReadError)):
        said = f"it is not as meshio knows the format ({type(fault).__name__}{': ' * bool(said)}{said})"
    say(target, [f"meshio cannot read it: {said}"])
    status = 1
sys.exit(status)
