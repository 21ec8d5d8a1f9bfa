"""Meshes of other packages."""
from __future__ import annotations

from typing import Any

import numpy as np

from ._errors import InputError
from ._ringwatch import Mesh

# meshio's names of cells with volume. Its order of nodes is VTK's, as ours is.
_ELEMENT_OF_MESHIO = {
    "tetra": "tet4",
    "tetra10": "tet10",
    "hexahedron": "hex8",
    "hexahedron20": "hex20",
    "wedge": "wedge6",
    "pyramid": "pyramid5",
}
# Surfaces, lines and points that such files hold beside the volume.
_BELOW_VOLUME = ("vertex", "line", "triangle", "quad", "polygon")


def mesh_from(source: Any) -> Mesh:
    """The mesh of a meshio.Mesh, or of any object with `points` (N, 3) and `cells`, each with a `type` and `data`.

    Cells with volume become blocks, in their order; surfaces, lines and points are left out. Coordinates are taken as m.
    Raises InputError for another object and for cells that ringwatch does not have.
    """
    try:
        points, cells = source.points, list(source.cells)
        named = [(str(block.type), np.asarray(block.data)) for block in cells]
    except (AttributeError, TypeError):
        raise InputError(
            f"mesh_from: an object of type {type(source).__name__}; must have points and cells as a meshio.Mesh has"
        ) from None
    blocks = []
    for name, data in named:
        if name in _ELEMENT_OF_MESHIO:
            blocks.append((_ELEMENT_OF_MESHIO[name], data))
        elif not name.startswith(_BELOW_VOLUME):
            known = ", ".join(_ELEMENT_OF_MESHIO)
            raise InputError(f"mesh_from: unknown cells '{name}'; known are {known}, and those without volume")
    return Mesh(np.ascontiguousarray(points, dtype=np.float64), blocks)
