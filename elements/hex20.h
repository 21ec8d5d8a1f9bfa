#pragma once
#include <array>

#include <ringwatch/base/host_device.h>
#include <ringwatch/elements/cell_subdivision.h>
#include <ringwatch/elements/quadrature.h>

namespace ringwatch {

/// Twenty-node hexahedron, quadratic (serendipity). Natural coordinates on [-1, 1]³; VTK node order: corners, then the
/// middles of `edges`. Row sums of its mass are negative at the corners, so its mass is lumped by diagonal scaling.
struct Hex20 {
  static constexpr std::string_view name = "hex20";
  static constexpr int nodes = 20;
  static constexpr int order = 2;
  static constexpr int vtkCellType = 25;
  static constexpr int gmshType = 17;
  static constexpr bool constantGradient = false;
  static constexpr bool positiveRowSums = false;
  static constexpr double referenceVolume = 8.0;
  static constexpr std::array<std::array<double, 3>, nodes> referenceNodes{
      {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1},  {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1},
       {-1, 1, 1},   {0, -1, -1}, {1, 0, -1},  {0, 1, -1},  {-1, 0, -1}, {0, -1, 1}, {1, 0, 1},
       {0, 1, 1},    {-1, 0, 1},  {-1, -1, 0}, {1, -1, 0},  {1, 1, 0},   {-1, 1, 0}}};
  static constexpr std::array<std::array<int, 4>, 6> faces{
      {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
  static constexpr std::array<std::array<int, 2>, 12> edges{
      {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};
  static constexpr std::array<std::uint8_t, nodes> gmshOrder{0,  1, 2,  3,  4,  5,  6,  7,  8,  11,
                                                             13, 9, 16, 18, 19, 17, 10, 12, 14, 15};
  static constexpr std::array<CellSubdivision, 1> cellSplits{
      {{name, 1, false, CellSubdivision::whole, CellSubdivision::whole}}};

  /// Corners Π_j (1 + ξ_j ξ_aj) (Σ_j ξ_j ξ_aj - 2)/8; middles Π_j p_j/4 with p_j = 1 - ξ_j² along the edge, 1 + ξ_j
  /// ξ_aj across it.
  template <class S>
  RINGWATCH_HOST_DEVICE static constexpr void shape(const S xi[3], S N[nodes]) {
    for (int a = 0; a < nodes; ++a) {
      S p[3], dp[3], sum(-2);
      factors(xi, a, p, dp);
      for (int j = 0; j < 3; ++j) sum = sum + S(referenceNodes[a][j]) * xi[j];
      N[a] = p[0] * p[1] * p[2] * (a < 8 ? S(0.125) * sum : S(0.25));
    }
  }
  /// ∂N_a/∂ξ_j
  template <class S>
  RINGWATCH_HOST_DEVICE static constexpr void shapeGradient(const S xi[3], S dN[nodes][3]) {
    for (int a = 0; a < nodes; ++a) {
      S p[3], dp[3], sum(-2);
      factors(xi, a, p, dp);
      for (int j = 0; j < 3; ++j) sum = sum + S(referenceNodes[a][j]) * xi[j];
      for (int j = 0; j < 3; ++j) {
        const S others = p[(j + 1) % 3] * p[(j + 2) % 3];
        dN[a][j] =
            a < 8 ? S(0.125) * others * (dp[j] * sum + p[j] * S(referenceNodes[a][j])) : S(0.25) * others * dp[j];
      }
    }
  }

  static constexpr auto gauss2 = gaussCube(gauss::x2, gauss::w2);
  static constexpr auto gauss3 = gaussCube(gauss::x3, gauss::w3);
  static constexpr std::array<QuadratureRule, 2> rules{
      {{"gauss-3x3x3", "27 points, full rank", gauss3},
       {"gauss-2x2x2", "eight points, cheap and soft; six spurious modes in a free element", gauss2, {}, 6}}};
  static constexpr QuadratureRule massRule = rules[0];

 private:
  /// p_j and dp_j/dξ_j of node a.
  template <class S>
  RINGWATCH_HOST_DEVICE static constexpr void factors(const S xi[3], int a, S p[3], S dp[3]) {
    for (int j = 0; j < 3; ++j) {
      const double xa = referenceNodes[a][j];
      p[j] = xa == 0 ? S(1) - xi[j] * xi[j] : S(1) + S(xa) * xi[j];
      dp[j] = xa == 0 ? S(-2) * xi[j] : S(xa);
    }
  }
};

}  // namespace ringwatch
