#pragma once

/// The constants of the rounding budget, docs/theory/floating_point.md: what stands between a computed number and the
/// statement in exact arithmetic that it is taken for. Each is named there with its derivation.
namespace ringwatch {

/// u: half the distance from 1 to the next double.
inline constexpr double unitRoundoff = 0x1p-53;

// Theorem 42: the tangent of an element. In units of u; `condition` is |edges| |∂N/∂ξ| |J⁻¹| at a point.
/// Of F, relative to the condition in the present state; nodes of the element are added.
inline constexpr double gradientRounding = 24;
/// Of shape gradients and weights, relative to the condition at rest.
inline constexpr double shapeRounding = 48;
/// Both for elements of constant gradient, whose ∂N/∂ξ are exact.
inline constexpr double simplexGradientRounding = 8, simplexShapeRounding = 16;
/// Of the products of a law's tangent with shape gradients, of sums over points, of scaling by weights, and of sums at
/// nodes, relative to the norm of the law's tangent.
inline constexpr double productRounding = 128;
/// Of a law's tangent as it is evaluated, relative to the sum of the sizes of its terms.
inline constexpr double lawRounding = 24;

/// Of an eigenvalue, relative to the Gershgorin radius of the matrix as computed: Theorem 43. 9e4 u; the largest matrix
/// is 60×60.
inline constexpr double eigenvalueRounding = 1e-11;
/// Of a Rayleigh quotient, relative to the largest size of an eigenvalue, beside what its sums add: Theorem 44.
inline constexpr double quotientRounding = 1e-12;

}  // namespace ringwatch
