#pragma once
#include <ringwatch/verify/report.h>

namespace ringwatch {

/// Holds every element of `Elements`, with every quadrature rule, to what theory says of it:
///  - shape functions: partition of unity, gradients of linear fields; volume and mass of a distorted mesh;
///  - rank: six rigid modes and as many spurious ones as the rule declares;
///  - patch test on distorted and on mixed meshes: constant strain, and a linear strain for quadratic elements;
///  - frame indifference, force = ∂energy/∂x, tangent = ∂force/∂x, symmetry of the tangent;
///  - a manufactured solution (linear law, and St. Venant–Kirchhoff at large strain): rates in L2 and H1, theory: order
///  + 1
///    and order, within 0.1;
///  - natural frequencies: a free rod (ν = 0, exact), a ball of linear elements (Lamb 1882, breathing and torsion), a
///    cantilever against Timoshenko's beam; all with the observed order;
///  - locking: the tip deflection of a cantilever at ν = 0.3, 0.45, 0.49, 0.499;
///  - cost: tip error against the time that a simulated second of an explicit run takes.
/// quick: seconds, coarse meshes; full: one refinement more.
StudyReport verifyElements(StudyEffort effort);

}  // namespace ringwatch
