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

/// A quadrature rule that a user can choose by name.
struct QuadratureRule {
  std::string_view name;
  std::string_view help;
  std::span<const QuadraturePoint> points;
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
constexpr std::array<QuadraturePoint, n * n * n> gaussCube(const std::array<double, n>& x, const std::array<double, n>& w) {
  std::array<QuadraturePoint, n * n * n> points{};
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = 0; i < n; ++i)
        points[(k * n + j) * n + i] = {{x[i], x[j], x[k]}, w[i] * w[j] * w[k]};
  return points;
}

}  // namespace ringwatch
