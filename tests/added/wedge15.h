#pragma once
#include <array>

#include <ringwatch/base/host_device.h>
#include <ringwatch/elements/cell_subdivision.h>
#include <ringwatch/elements/quadrature.h>

namespace ringwatch::test {

/// A point of a rule on the triangle.
struct TrianglePoint {
  double rs[2];
  double weight;
};
/// These times three Gauss points along the axis.
template <std::size_t n>
constexpr std::array<QuadraturePoint, 3 * n> byThree(const std::array<TrianglePoint, n>& triangle) {
  std::array<QuadraturePoint, 3 * n> points{};
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < n; ++i)
      points[k * n + i] = {{triangle[i].rs[0], triangle[i].rs[1], gauss::x3[k]}, triangle[i].weight * gauss::w3[k]};
  return points;
}

/// An element added from outside: the fifteen-node wedge, quadratic (serendipity). Triangle (r, s), ζ in [-1, 1]; VTK
/// node order: corners, then the middles of `edges`. Row sums of its mass are negative at the corners, so its mass is
/// lumped by diagonal scaling.
struct Wedge15 {
  static constexpr std::string_view name = "wedge15";
  static constexpr int nodes = 15;
  static constexpr int order = 2;
  static constexpr int vtkCellType = 26;
  static constexpr int gmshType = 18;
  static constexpr bool constantGradient = false;
  static constexpr bool positiveRowSums = false;
  static constexpr double referenceVolume = 1.0;
  static constexpr std::array<std::array<double, 3>, nodes> referenceNodes{{{0, 0, -1},
                                                                            {1, 0, -1},
                                                                            {0, 1, -1},
                                                                            {0, 0, 1},
                                                                            {1, 0, 1},
                                                                            {0, 1, 1},
                                                                            {0.5, 0, -1},
                                                                            {0.5, 0.5, -1},
                                                                            {0, 0.5, -1},
                                                                            {0.5, 0, 1},
                                                                            {0.5, 0.5, 1},
                                                                            {0, 0.5, 1},
                                                                            {0, 0, 0},
                                                                            {1, 0, 0},
                                                                            {0, 1, 0}}};
  static constexpr std::array<std::array<int, 4>, 5> faces{
      {{0, 2, 1, -1}, {3, 4, 5, -1}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}}};
  static constexpr std::array<std::array<int, 2>, 9> edges{
      {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}}};
  /// gmsh's middles of edges: 01 02 03 12 14 25 34 35 45.
  static constexpr std::array<std::uint8_t, nodes> gmshOrder{0, 1, 2, 3, 4, 5, 6, 9, 7, 12, 14, 13, 8, 10, 11};
  static constexpr std::array<CellSubdivision, 1> cellSplits{
      {{name, 2, false, CellSubdivision::wedges, CellSubdivision::wedges}}};

  /// With the area coordinates L = (1 - r - s, r, s) and z = ±ζ at the two ends: corners L_a (1 + z) (2 L_a - 2 + z)/2,
  /// middles of the triangles' edges 2 L_a L_b (1 + z), of the upright ones L_a (1 - ζ²) (Zienkiewicz & Taylor 2000).
  template <class S>
  RINGWATCH_HOST_DEVICE static constexpr void shape(const S xi[3], S N[nodes]) {
    const S L[3] = {S(1) - xi[0] - xi[1], xi[0], xi[1]};
    for (int a = 0; a < 3; ++a) {
      const int b = (a + 1) % 3;
      for (int end = 0; end < 2; ++end) {
        const S z = end == 0 ? -xi[2] : xi[2];
        N[a + 3 * end] = S(0.5) * L[a] * (S(1) + z) * (S(2) * L[a] - S(2) + z);
        N[6 + a + 3 * end] = S(2) * L[a] * L[b] * (S(1) + z);
      }
      N[12 + a] = L[a] * (S(1) - xi[2] * xi[2]);
    }
  }
  /// ∂N_a/∂ξ_j
  template <class S>
  RINGWATCH_HOST_DEVICE static constexpr void shapeGradient(const S xi[3], S dN[nodes][3]) {
    const S L[3] = {S(1) - xi[0] - xi[1], xi[0], xi[1]};
    for (int a = 0; a < 3; ++a) {
      const int b = (a + 1) % 3;
      for (int end = 0; end < 2; ++end) {
        const double sign = end == 0 ? -1 : 1;
        const S z = S(sign) * xi[2];
        const S corner = S(0.5) * (S(1) + z) * (S(4) * L[a] - S(2) + z);  // ∂/∂L_a
        for (int j = 0; j < 2; ++j) {
          dN[a + 3 * end][j] = S(slope(a, j)) * corner;
          dN[6 + a + 3 * end][j] = S(2) * (S(1) + z) * (S(slope(a, j)) * L[b] + L[a] * S(slope(b, j)));
        }
        dN[a + 3 * end][2] = S(0.5 * sign) * L[a] * (S(2) * L[a] - S(1) + S(2) * z);
        dN[6 + a + 3 * end][2] = S(2 * sign) * L[a] * L[b];
      }
      for (int j = 0; j < 2; ++j) dN[12 + a][j] = S(slope(a, j)) * (S(1) - xi[2] * xi[2]);
      dN[12 + a][2] = S(-2) * L[a] * xi[2];
    }
  }

  // The three inner points of degree 2 (Strang & Fix 1973, table 4.1), and six points of degree 4 (Dunavant 1985).
  static constexpr auto ninePoints =
      byThree<3>({{{{1.0 / 6, 1.0 / 6}, 1.0 / 6}, {{2.0 / 3, 1.0 / 6}, 1.0 / 6}, {{1.0 / 6, 2.0 / 3}, 1.0 / 6}}});
  static constexpr double a1 = 0.4459484909159648863183, w1 = 0.1116907948390057328475, a2 = 0.0915762135097707434595,
                          w2 = 0.0549758718276609338191;
  static constexpr auto eighteenPoints = byThree<6>({{{{a1, a1}, w1},
                                                      {{1 - 2 * a1, a1}, w1},
                                                      {{a1, 1 - 2 * a1}, w1},
                                                      {{a2, a2}, w2},
                                                      {{1 - 2 * a2, a2}, w2},
                                                      {{a2, 1 - 2 * a2}, w2}}});
  static constexpr std::array<QuadratureRule, 2> rules{
      {{"gauss-3x3", "three points on the triangle by three along the axis, full rank", ninePoints},
       {"gauss-6x3", "six points on the triangle by three along the axis", eighteenPoints}}};
  static constexpr QuadratureRule massRule{"gauss-6x3", "exact for masses", eighteenPoints};

 private:
  /// ∂L_a/∂ξ_j
  static constexpr int slope(int a, int j) { return a == 0 ? -1 : a == j + 1 ? 1 : 0; }
};

}  // namespace ringwatch::test
