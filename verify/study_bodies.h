#pragma once
#include <limits>

#include <ringwatch/body/body.h>

/// What the bodies of several studies have in common.
namespace ringwatch::detail {

/// The soft solid of Fierz 2013's examples: Young's modulus in Pa, Poisson's ratio, density in kg/m³.
inline constexpr double young = 30e3, poisson = 0.3, density = 1000;

/// Largest h ω of symplectic Euler and Störmer–Verlet.
inline constexpr double verletLimit = 2;

inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Highest eigenvalue of M⁻¹K at rest, rad²/s², to `tolerance`, relative; 0 for a body without elements. Throws
/// NumericalError when the iteration does not converge.
double highestEigenvalue(const Body& body, double tolerance);

/// Moves an inner node of a regular bar of tetrahedra toward the opposite face of one of its elements until that one
/// has `height` times its height. The elements around a node fill a convex body, so none is turned inside out. Throws
/// NumericalError for a bar without inner nodes.
void flattenOneElement(Mesh& mesh, double height);

}  // namespace ringwatch::detail
