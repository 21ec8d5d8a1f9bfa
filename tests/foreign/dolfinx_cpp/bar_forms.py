# The energy of St. Venant-Kirchhoff's law, its forces, its tangent and the lumped mass, for ffcx.
from ufl import (Coefficient, FunctionSpace, Identity, Mesh, TestFunction, TrialFunction, VectorElement, as_vector, derivative,
                 dx, grad, inner, tetrahedron, tr)

element = VectorElement("Lagrange", tetrahedron, 1)
V = FunctionSpace(Mesh(element), element)
u, v, w = Coefficient(V), TestFunction(V), TrialFunction(V)

young, poisson, density = 1e6, 0.3, 1000.0  # Pa, 1, kg/m3
mu = young / (2 * (1 + poisson))
lmbda = young * poisson / ((1 + poisson) * (1 - 2 * poisson))
F = Identity(3) + grad(u)
E = (F.T * F - Identity(3)) / 2
force = derivative((mu * inner(E, E) + lmbda / 2 * tr(E) ** 2) * dx, u, v)
tangent = derivative(force, u, w)
mass = density * inner(as_vector((1.0, 1.0, 1.0)), v) * dx
forms = [force, tangent, mass]
