#pragma once
#include <array>

#include <ringwatch/base/host_device.h>
#include <ringwatch/elements/cell_subdivision.h>
#include <ringwatch/elements/quadrature.h>

namespace ringwatch {

/// Four-node tetrahedron, linear. Natural coordinates (r, s, t) on the unit tetrahedron; VTK node order.
struct Tet4 {
  static constexpr std::string_view name = "tet4";
  static constexpr int nodes = 4;
  static constexpr int order = 1;
  static constexpr int vtkCellType = 10;
  static constexpr int gmshType = 4;
  static constexpr bool constantGradient = true;
  static constexpr bool positiveRowSums = true;
  static constexpr double referenceVolume = 1.0 / 6.0;
  static constexpr std::array<std::array<double, 3>, nodes> referenceNodes{
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  /// Corner nodes of each face, seen from outside counter-clockwise; -1 fills triangles.
  static constexpr std::array<std::array<int, 4>, 4> faces{
      {{0, 2, 1, -1}, {0, 1, 3, -1}, {1, 2, 3, -1}, {0, 3, 2, -1}}};
  static constexpr std::array<std::array<int, 2>, 6> edges{{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};
  static constexpr std::array<CellSubdivision, 2> cellSplits{
      {{name, 6, false, CellSubdivision::kuhn, CellSubdivision::kuhn},
       {name, 5, false, CellSubdivision::fiveEven, CellSubdivision::fiveOdd}}};

  /// N_a(ξ)
  template <class S>
  RINGWATCH_HOST_DEVICE static constexpr void shape(const S xi[3], S N[nodes]) {
    N[0] = S(1) - xi[0] - xi[1] - xi[2];
    N[1] = xi[0];
    N[2] = xi[1];
    N[3] = xi[2];
  }
  /// ∂N_a/∂ξ_j
  template <class S>
  RINGWATCH_HOST_DEVICE static constexpr void shapeGradient(const S[3], S dN[nodes][3]) {
    for (int j = 0; j < 3; ++j) {
      dN[0][j] = S(-1);
      for (int a = 1; a < 4; ++a) dN[a][j] = S(a == j + 1 ? 1 : 0);
    }
  }

  static constexpr std::array<QuadraturePoint, 1> onePoint{{{{0.25, 0.25, 0.25}, 1.0 / 6.0}}};
  // Keast 1986, rule 1: degree 2. Of use for mass; the stiffness is constant.
  static constexpr double keastA = 0.58541019662496845446, keastB = 0.13819660112501051518;
  static constexpr std::array<QuadraturePoint, 4> fourPoints{{{{keastB, keastB, keastB}, 1.0 / 24.0},
                                                              {{keastA, keastB, keastB}, 1.0 / 24.0},
                                                              {{keastB, keastA, keastB}, 1.0 / 24.0},
                                                              {{keastB, keastB, keastA}, 1.0 / 24.0}}};
  static constexpr std::array<QuadratureRule, 1> rules{
      {{"gauss-1", "one point, exact for linear tetrahedra", onePoint}}};
  static constexpr QuadratureRule massRule{"keast-4", "four points, degree 2", fourPoints};
};

}  // namespace ringwatch
