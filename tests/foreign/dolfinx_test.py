"""A bar of St. Venant-Kirchhoff tetrahedra in dolfinx: its tangents in our bracket, held to its own matrices."""

import numpy as np
import support

support.need("dolfinx")
import dolfinx  # noqa: E402
import ufl  # noqa: E402
from dolfinx import fem  # noqa: E402
from dolfinx.fem import petsc  # noqa: E402
from dolfinx_adapter import ElementTangents  # noqa: E402
from mpi4py import MPI  # noqa: E402

mesh = dolfinx.mesh.create_box(MPI.COMM_WORLD, [[0, 0, 0], [0.16, 0.02, 0.02]], [8, 1, 1])
V = fem.VectorFunctionSpace(mesh, ("CG", 1))
moved = fem.Function(V)


def energy(u):
    F = ufl.Identity(3) + ufl.grad(u)
    E = (F.T * F - ufl.Identity(3)) / 2
    return support.MU * ufl.inner(E, E) + support.LAMBDA / 2 * ufl.tr(E) ** 2


tangents = ElementTangents(V, energy)
residual = ufl.derivative(energy(moved) * ufl.dx, moved)
force, matrix = fem.form(residual), fem.form(ufl.derivative(residual, moved))
test = ufl.TestFunction(fem.FunctionSpace(mesh, ("CG", 1)))
mass = petsc.assemble_vector(fem.form(support.DENSITY * test * ufl.dx)).array
points = V.tabulate_dof_coordinates()
corners = points[tangents.nodes]
diameters = np.linalg.norm(corners[:, :, None] - corners[:, None, :], axis=3).max(axis=(1, 2))  # ufl.CellDiameter


def at(u, take):
    moved.x.array[:] = u.ravel()
    return take()


def assembled():
    K = petsc.assemble_matrix(matrix)
    K.assemble()
    return K[:, :]


support.pulled(
    "dolfinx",
    points,
    tangents.nodes.astype(np.int32),
    lambda u: at(u, lambda: tangents(moved)),
    diameters.min() / support.WAVE,
    lambda u: at(u, lambda: petsc.assemble_vector(force).array.reshape(-1, 3).copy()),
    lambda u: at(u, assembled),
    mass.copy(),
    speed=1.0,
    steps=400,
)
