#pragma once
#include <array>
#include <span>
#include <string_view>

namespace ringwatch {

/// A point of a quadrature rule in natural coordinates, with its weight (the weights sum to the reference volume).
struct QuadraturePoint {
  double xi[3];
  double weight;
};

/// How a rule splits an energy that is linear in Lamé's constants, W = λ W_λ(F) + μ W_μ(F), between its points and one
/// evaluation at the mean deformation gradient F̄ = 1/V ∫F dV of the element:
///   energy = Σ_q w_q (pointLambda λ W_λ + pointMu μ W_μ)(F_q) + V (meanLambda λ W_λ + meanMu μ W_μ)(F̄).
/// For each constant the two shares add up to 1. Forces and tangents are exact derivatives, so they stay symmetric and
/// frame-indifferent, and a constant strain is integrated exactly: the patch test holds.
struct LameShares {
  double pointLambda = 1, pointMu = 1;
  double meanLambda = 0, meanMu = 0;
  constexpr bool mean() const { return meanLambda != 0 || meanMu != 0; }
};
/// Selective reduced integration: shear at the points, pressure at the mean. At small strain λ/2 V tr²(ε̄), which is the
/// volumetric part of the B-bar method with mean dilatation (Hughes 1980).
inline constexpr LameShares selectiveShares{0, 1, 1, 0};

/// A quadrature rule that a user can choose by name.
struct QuadratureRule {
  std::string_view name;
  std::string_view help;
  std::span<const QuadraturePoint> points;
  LameShares shares{};
  int spuriousModes = 0;        // zero-energy modes of an undistorted element beyond the six rigid ones
  std::string_view alias = {};  // an older name, accepted wherever the name is; "" for none
  /// One evaluation at the mean gradients ∂N_a/∂X of the element, exact on distorted elements too, and hourglass
  /// control (elements/hourglass.h); the point stands for it, and nothing is evaluated there.
  bool uniformStrain = false;
};

/// Gauss–Legendre abscissas and weights on [-1, 1] (Abramowitz & Stegun, table 25.4).
namespace gauss {
inline constexpr double p2 = 0.57735026918962576451;  // 1/√3
inline constexpr double p3 = 0.77459666924148337704;  // √(3/5)
inline constexpr std::array<double, 1> x1{0.0}, w1{2.0};
inline constexpr std::array<double, 2> x2{-p2, p2}, w2{1.0, 1.0};
inline constexpr std::array<double, 3> x3{-p3, 0.0, p3}, w3{5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0};
}  // namespace gauss

/// The n×n×n product rule on [-1, 1]³, first coordinate fastest.
template <std::size_t n>
constexpr std::array<QuadraturePoint, n * n * n> gaussCube(const std::array<double, n>& x,
                                                           const std::array<double, n>& w) {
  std::array<QuadraturePoint, n * n * n> points{};
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = 0; i < n; ++i) points[(k * n + j) * n + i] = {{x[i], x[j], x[k]}, w[i] * w[j] * w[k]};
  return points;
}

/// Points on [-1, 1]³ brought to the pyramid with base [-1, 1]² and apex (0, 0, 1): z = (1 + ζ)/2, x and y times 1 - z,
/// weights times (1 - z)²/2.
template <std::size_t n>
constexpr std::array<QuadraturePoint, n> collapseToPyramid(std::array<QuadraturePoint, n> points) {
  for (QuadraturePoint& p : points) {
    const double z = 0.5 * (1 + p.xi[2]), w = 1 - z;
    p = {{p.xi[0] * w, p.xi[1] * w, z}, p.weight * 0.5 * w * w};
  }
  return points;
}

}  // namespace ringwatch
