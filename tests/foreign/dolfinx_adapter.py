"""dolfinx in ringwatch: element tangents of an energy for TangentBracket, assembled on the discontinuous twin of the
displacement's space, so that each element keeps a block of its own; or, for a law that ringwatch has, a body that takes
the positions of linear tetrahedra."""

import numpy as np
import ringwatch as rw
import ufl
from dolfinx import fem
from dolfinx.fem import petsc


class ElementTangents:
    """energy: of a displacement, as a UFL density, J/m3. V: the space of the displacement, linear or quadratic."""

    def __init__(self, V, energy):
        twin = fem.VectorFunctionSpace(V.mesh, ("DG", V.ufl_element().degree()))
        self.moved = fem.Function(twin)
        self.form = fem.form(ufl.derivative(ufl.derivative(energy(self.moved) * ufl.dx, self.moved), self.moved))
        cells = range(V.mesh.topology.index_map(V.mesh.topology.dim).size_local)
        self.nodes = np.array([V.dofmap.cell_dofs(c) for c in cells])  # (elements, n)
        self.own = np.array([twin.dofmap.cell_dofs(c) for c in cells])

    def __call__(self, u):
        """(elements, 3 n, 3 n), N/m, at the displacement u."""
        self.moved.x.array.reshape(-1, 3)[self.own] = u.x.array.reshape(-1, 3)[self.nodes]
        K = petsc.assemble_matrix(self.form)
        K.assemble()
        rows = [(3 * o[:, None] + np.arange(3)).ravel().astype(np.int32) for o in self.own]
        return np.array([K.getValues(r, r) for r in rows])


def body_of(V, model, threads=0, **law):
    """A body of ours on the cells of V, linear tetrahedra, for rw.Monitor: its nodes are in V's order."""
    cells = range(V.mesh.topology.index_map(V.mesh.topology.dim).size_local)
    nodes = np.array([V.dofmap.cell_dofs(c) for c in cells], np.int32)
    return rw.Body(rw.Mesh(V.tabulate_dof_coordinates(), {"tet4": nodes}), rw.Material(model, **law), threads=threads)
