"""A bar of St. Venant-Kirchhoff tetrahedra in GetFEM: its tangents in our bracket, held to its own matrices."""

import numpy as np
import support

gf = support.need("getfem")
from getfem_adapter import element_tangents  # noqa: E402

law = """((Id(3)+Grad_u)*(la*Trace(Grad_u+0.5*Grad_u'*Grad_u)*Id(3)+mu*(Grad_u+Grad_u'+Grad_u'*Grad_u))):Grad_Test_u"""
data = {"la": support.LAMBDA, "mu": support.MU}

mesh = gf.Mesh("regular simplices", np.linspace(0, 0.16, 9), np.linspace(0, 0.02, 2), np.linspace(0, 0.02, 2))
mf, scalar = gf.MeshFem(mesh, 3), gf.MeshFem(mesh, 1)
mf.set_classical_fem(1)
scalar.set_classical_fem(1)
mim = gf.MeshIm(mesh, 2)
points = np.ascontiguousarray(mf.basic_dof_nodes().T[::3])
arguments = [part for name, value in data.items() for part in (name, 0, value)]
nodes, _ = element_tangents(mesh, mim, law, np.zeros(mf.nbdof()), mf, **data)
mass = gf.asm_generic(mim, 1, f"{support.DENSITY}*Test_p", -1, "p", 1, scalar, np.zeros(scalar.nbdof()))
# Both finite elements number the same nodes, in the same order.
assert np.array_equal(scalar.basic_dof_nodes().T, points)


def assembled(order, u):
    return gf.asm_generic(mim, order, law, -1, "u", 1, mf, u.ravel(), *arguments)


support.pulled(
    "GetFEM",
    points,
    nodes.astype(np.int32),
    lambda u: element_tangents(mesh, mim, law, u.ravel(), mf, **data)[1],
    float(np.min(mesh.convex_radius())) / support.WAVE,
    lambda u: assembled(1, u).reshape(-1, 3),
    lambda u: assembled(2, u).full(),
    np.asarray(mass),
    speed=1.0,
    steps=400,
)
