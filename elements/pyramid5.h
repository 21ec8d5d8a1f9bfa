#pragma once
#include <array>

#include <ringwatch/base/host_device.h>
#include <ringwatch/base/math.h>
#include <ringwatch/elements/cell_subdivision.h>
#include <ringwatch/elements/quadrature.h>

namespace ringwatch {

/// Five-node pyramid with rational shape functions (Bedrosian, "Shape functions and integration formulas for
/// three-dimensional finite element analysis", IJNME 35, 1992). Base [-1, 1]² at z = 0, apex (0, 0, 1); VTK node order.
/// The same functions are those of a hexahedron with one face collapsed: with u = x/(1-z), v = y/(1-z) the nodes of the
/// base have (1 + u_a u)(1 + v_a v)(1 - z)/4, so they join linear triangles and bilinear quadrilaterals without a gap.
/// The gradient has no limit at the apex; there it gets its value along the axis.
struct Pyramid5 {
  static constexpr std::string_view name = "pyramid5";
  static constexpr int nodes = 5;
  static constexpr int order = 1;
  static constexpr int vtkCellType = 14;
  static constexpr int gmshType = 7;
  static constexpr bool constantGradient = false;
  static constexpr bool positiveRowSums = true;
  static constexpr double referenceVolume = 4.0 / 3.0;
  static constexpr std::array<std::array<double, 3>, nodes> referenceNodes{
      {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, 1}}};
  static constexpr std::array<std::array<int, 4>, 5> faces{
      {{0, 3, 2, 1}, {0, 1, 4, -1}, {1, 2, 4, -1}, {2, 3, 4, -1}, {3, 0, 4, -1}}};
  static constexpr std::array<std::array<int, 2>, 8> edges{
      {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {1, 4}, {2, 4}, {3, 4}}};
  static constexpr std::array<CellSubdivision, 1> cellSplits{
      {{name, 6, true, CellSubdivision::pyramids, CellSubdivision::pyramids}}};

  /// N_a = (w + x_a x)(w + y_a y)/(4w), w = 1 - z; N_4 = z
  template <class S>
  RINGWATCH_HOST_DEVICE static constexpr void shape(const S xi[3], S N[nodes]) {
    const S w = math::max(S(1) - xi[2], S(tiny)), v = xi[1] / w;
    for (int a = 0; a < 4; ++a)
      N[a] = S(0.25) * (w + S(referenceNodes[a][0]) * xi[0]) * (S(1) + S(referenceNodes[a][1]) * v);
    N[4] = xi[2];
  }
  /// ∂N_a/∂ξ_j
  template <class S>
  RINGWATCH_HOST_DEVICE static constexpr void shapeGradient(const S xi[3], S dN[nodes][3]) {
    const S w = math::max(S(1) - xi[2], S(tiny)), u = xi[0] / w, v = xi[1] / w;
    for (int a = 0; a < 4; ++a) {
      const S x(referenceNodes[a][0]), y(referenceNodes[a][1]);
      dN[a][0] = S(0.25) * x * (S(1) + y * v);
      dN[a][1] = S(0.25) * y * (S(1) + x * u);
      dN[a][2] = S(0.25) * (x * y * u * v - S(1));
    }
    dN[4][0] = dN[4][1] = S(0);
    dN[4][2] = S(1);
  }

  static constexpr auto collapsed2 = collapseToPyramid(gaussCube(gauss::x2, gauss::w2));
  static constexpr auto collapsed3 = collapseToPyramid(gaussCube(gauss::x3, gauss::w3));
  // Gauss–Jacobi along the axis, one point for the weight (1 - z)²: z = 1/4, weight 1/3.
  static constexpr double jacobi = 0.75 * gauss::p2;
  static constexpr std::array<QuadraturePoint, 4> fourPoints{{{{-jacobi, -jacobi, 0.25}, 1.0 / 3},
                                                              {{jacobi, -jacobi, 0.25}, 1.0 / 3},
                                                              {{-jacobi, jacobi, 0.25}, 1.0 / 3},
                                                              {{jacobi, jacobi, 0.25}, 1.0 / 3}}};
  // Fierz 2013's points, (±8/5 √(2/15), ±8/5 √(2/15), -2/3) and (0, 0, 2/5) with weights 81/100 and 125/27, are those
  // of Felippa's collapsed coordinates on [-1, 1]³; brought here by the map above with z = (1 + ζ)/2.
  static constexpr double felippa = 0.48686449556014765641;  // 5/6 · 8/5 √(2/15)
  static constexpr std::array<QuadraturePoint, 5> fivePoints{{{{-felippa, -felippa, 1.0 / 6}, 9.0 / 32},
                                                              {{felippa, -felippa, 1.0 / 6}, 9.0 / 32},
                                                              {{-felippa, felippa, 1.0 / 6}, 9.0 / 32},
                                                              {{felippa, felippa, 1.0 / 6}, 9.0 / 32},
                                                              {{0, 0, 0.7}, 5.0 / 24}}};
  static constexpr std::array<QuadratureRule, 4> rules{
      {{"collapsed-2x2x2", "eight points; at rest exact for pyramids whose base is a parallelogram", collapsed2},
       {"collapsed-3x3x3", "27 points, for strongly distorted elements and large strain", collapsed3},
       {"jacobi-2x2x1", "four points, at rest exact for pyramids whose base is a parallelogram", fourPoints},
       {.name = "fierz2013",
        .help = "five points, as in Fierz 2013, table 2.1",
        .points = fivePoints,
        .alias = "source"}}};
  static constexpr QuadratureRule massRule{"collapsed-2x2x2", "exact for masses", collapsed2};

 private:
  static constexpr double tiny = 1e-300;
};

}  // namespace ringwatch
