#pragma once
#include <array>

#include <ringwatch/base/host_device.h>
#include <ringwatch/elements/cell_subdivision.h>
#include <ringwatch/elements/quadrature.h>

namespace ringwatch {

/// Ten-node tetrahedron, quadratic. Natural coordinates (r, s, t) on the unit tetrahedron; VTK node order: corners,
/// then the middles of `edges`. Row sums of its mass are negative at the corners, so its mass is lumped by diagonal
/// scaling.
struct Tet10 {
  static constexpr std::string_view name = "tet10";
  static constexpr int nodes = 10;
  static constexpr int order = 2;
  static constexpr int vtkCellType = 24;
  static constexpr int gmshType = 11;
  static constexpr bool constantGradient = false;
  static constexpr bool positiveRowSums = false;
  static constexpr double referenceVolume = 1.0 / 6.0;
  static constexpr std::array<std::array<double, 3>, nodes> referenceNodes{{{0, 0, 0},
                                                                            {1, 0, 0},
                                                                            {0, 1, 0},
                                                                            {0, 0, 1},
                                                                            {0.5, 0, 0},
                                                                            {0.5, 0.5, 0},
                                                                            {0, 0.5, 0},
                                                                            {0, 0, 0.5},
                                                                            {0.5, 0, 0.5},
                                                                            {0, 0.5, 0.5}}};
  static constexpr std::array<std::array<int, 4>, 4> faces{
      {{0, 2, 1, -1}, {0, 1, 3, -1}, {1, 2, 3, -1}, {0, 3, 2, -1}}};
  static constexpr std::array<std::array<int, 2>, 6> edges{{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};
  static constexpr std::array<std::uint8_t, nodes> gmshOrder{0, 1, 2, 3, 4, 5, 6, 7, 9, 8};
  static constexpr std::array<CellSubdivision, 2> cellSplits{
      {{name, 6, false, CellSubdivision::kuhn, CellSubdivision::kuhn},
       {name, 5, false, CellSubdivision::fiveEven, CellSubdivision::fiveOdd}}};

  /// Corners L_a (2 L_a - 1), middles 4 L_a L_b, with the volume coordinates L = (1 - r - s - t, r, s, t)
  template <class S>
  RINGWATCH_HOST_DEVICE static constexpr void shape(const S xi[3], S N[nodes]) {
    const S L[4] = {S(1) - xi[0] - xi[1] - xi[2], xi[0], xi[1], xi[2]};
    for (int a = 0; a < 4; ++a) N[a] = L[a] * (S(2) * L[a] - S(1));
    for (int e = 0; e < 6; ++e) N[4 + e] = S(4) * L[edges[e][0]] * L[edges[e][1]];
  }
  /// ∂N_a/∂ξ_j
  template <class S>
  RINGWATCH_HOST_DEVICE static constexpr void shapeGradient(const S xi[3], S dN[nodes][3]) {
    const S L[4] = {S(1) - xi[0] - xi[1] - xi[2], xi[0], xi[1], xi[2]};
    for (int j = 0; j < 3; ++j) {
      for (int a = 0; a < 4; ++a) dN[a][j] = (S(4) * L[a] - S(1)) * S(slope(a, j));
      for (int e = 0; e < 6; ++e) {
        const int a = edges[e][0], b = edges[e][1];
        dN[4 + e][j] = S(4) * (S(slope(a, j)) * L[b] + L[a] * S(slope(b, j)));
      }
    }
  }

  // Keast 1986, rule 1: degree 2, exact for the stiffness of straight-sided elements at rest.
  static constexpr double keastA = 0.58541019662496845446, keastB = 0.13819660112501051518;
  static constexpr std::array<QuadraturePoint, 4> fourPoints{{{{keastB, keastB, keastB}, 1.0 / 24.0},
                                                              {{keastA, keastB, keastB}, 1.0 / 24.0},
                                                              {{keastB, keastA, keastB}, 1.0 / 24.0},
                                                              {{keastB, keastB, keastA}, 1.0 / 24.0}}};
  // Stroud 1971, T3: 5-1, degree 5: the centre, (b, a, a, a) twice with a = (7 ∓ √15)/34, b = 1 - 3a, and (c, c, d, d)
  // with c = (10 - 2√15)/40, d = 1/2 - c.
  static constexpr double root15 = 3.872983346207416885180, a1 = (7 - root15) / 34, b1 = 1 - 3 * a1,
                          w1 = (2665 + 14 * root15) / 226800, a2 = (7 + root15) / 34, b2 = 1 - 3 * a2,
                          w2 = (2665 - 14 * root15) / 226800, c = (10 - 2 * root15) / 40, d = 0.5 - c, w3 = 5.0 / 567;
  static constexpr std::array<QuadraturePoint, 15> fifteenPoints{{{{0.25, 0.25, 0.25}, 8.0 / 405},
                                                                  {{a1, a1, a1}, w1},
                                                                  {{b1, a1, a1}, w1},
                                                                  {{a1, b1, a1}, w1},
                                                                  {{a1, a1, b1}, w1},
                                                                  {{a2, a2, a2}, w2},
                                                                  {{b2, a2, a2}, w2},
                                                                  {{a2, b2, a2}, w2},
                                                                  {{a2, a2, b2}, w2},
                                                                  {{c, c, d}, w3},
                                                                  {{c, d, c}, w3},
                                                                  {{d, c, c}, w3},
                                                                  {{d, d, c}, w3},
                                                                  {{d, c, d}, w3},
                                                                  {{c, d, d}, w3}}};
  static constexpr std::array<QuadratureRule, 2> rules{
      {{"keast-4", "four points, degree 2: exact at rest for straight-sided elements", fourPoints},
       {"stroud-15", "15 points, degree 5, for curved elements and large strain", fifteenPoints}}};
  static constexpr QuadratureRule massRule{"stroud-15", "degree 5", fifteenPoints};

 private:
  /// ∂L_a/∂ξ_j
  static constexpr int slope(int a, int j) { return a == 0 ? -1 : a == j + 1 ? 1 : 0; }
};

}  // namespace ringwatch
