"""Element tangents of a GetFEM model for ringwatch.TangentBracket: assembled on the discontinuous twin of the
displacement's finite elements, so that each element keeps a block of its own."""

import getfem as gf
import numpy as np


def element_tangents(mesh, mim, tangent, u, mf, **data):
    """tangent: GetFEM's expression of second order in u; u: displacement on mf, m. Returns the nodes of the elements,
    (elements, n), and their tangents, (elements, 3 n, 3 n), N/m."""
    twin = gf.MeshFem(mesh, 3)
    twin.set_fem(gf.Fem(f"FEM_PK_DISCONTINUOUS(3,{int(mf.fem(0)[0].estimated_degree())})"))
    cells = mesh.cvid()
    dofs = np.array([mf.basic_dof_from_cvid(c)[0] for c in cells])
    own = np.array([twin.basic_dof_from_cvid(c)[0] for c in cells])
    moved = np.empty(twin.nbdof())
    moved[own] = u[dofs]
    arguments = [part for name, value in data.items() for part in (name, 0, value)]
    K = gf.asm_generic(mim, 2, tangent, -1, "u", 1, twin, moved, *arguments)
    blocks = np.array([K.full(o, o) for o in own])
    return dofs[:, ::3] // 3, blocks
