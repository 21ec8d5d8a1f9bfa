#pragma once
#include <array>

#include <ringwatch/base/host_device.h>
#include <ringwatch/elements/cell_subdivision.h>
#include <ringwatch/elements/directions.h>
#include <ringwatch/elements/hourglass.h>
#include <ringwatch/elements/quadrature.h>

namespace ringwatch {

/// Eight-node hexahedron, trilinear. Natural coordinates on [-1, 1]³; VTK node order.
struct Hex8 {
  static constexpr std::string_view name = "hex8";
  static constexpr int nodes = 8;
  static constexpr int order = 1;
  static constexpr int vtkCellType = 12;
  static constexpr int gmshType = 5;
  static constexpr bool constantGradient = false;
  static constexpr bool positiveRowSums = true;
  static constexpr double referenceVolume = 8.0;
  static constexpr std::array<std::array<double, 3>, nodes> referenceNodes{
      {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}};
  static constexpr std::array<std::array<int, 4>, 6> faces{
      {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
  static constexpr std::array<std::array<int, 2>, 12> edges{
      {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};
  static constexpr std::array<CellSubdivision, 1> cellSplits{
      {{name, 1, false, CellSubdivision::whole, CellSubdivision::whole}}};

  /// N_a(ξ) = Π_j (1 + ξ_j ξ_aj) / 8
  template <class S>
  RINGWATCH_HOST_DEVICE static constexpr void shape(const S xi[3], S N[nodes]) {
    for (int a = 0; a < nodes; ++a) {
      N[a] = S(0.125);
      for (int j = 0; j < 3; ++j) N[a] = N[a] * (S(1) + S(referenceNodes[a][j]) * xi[j]);
    }
  }
  /// ∂N_a/∂ξ_j
  template <class S>
  RINGWATCH_HOST_DEVICE static constexpr void shapeGradient(const S xi[3], S dN[nodes][3]) {
    for (int a = 0; a < nodes; ++a)
      for (int j = 0; j < 3; ++j) {
        dN[a][j] = S(0.125 * referenceNodes[a][j]);
        for (int k = 0; k < 3; ++k)
          if (k != j) dN[a][j] = dN[a][j] * (S(1) + S(referenceNodes[a][k]) * xi[k]);
      }
  }

  using Directions = TrilinearDirections<Hex8>;
  using Hourglass = HourglassModes<Hex8>;
  static constexpr auto onePoint = gaussCube(gauss::x1, gauss::w1);
  static constexpr auto gauss2 = gaussCube(gauss::x2, gauss::w2);
  static constexpr auto gauss3 = gaussCube(gauss::x3, gauss::w3);
  /// One evaluation at the mean (Flanagan & Belytschko 1981) with a tenth of μ left at eight points to hold the
  /// hourglass modes.
  static constexpr LameShares hourglassShares{0, 0.1, 1, 0.9};
  static constexpr std::array<QuadratureRule, 5> rules{
      {{"gauss-2x2x2", "full rank, the usual choice", gauss2},
       {"gauss-3x3x3", "27 points, for strongly distorted elements", gauss3},
       {"selective", "gauss-2x2x2 for shear, the mean strain of the element for pressure: no volumetric locking",
        gauss2, selectiveShares},
       {"hourglass",
        "the mean strain of the element, hourglass modes held by a tenth of the shear stiffness at 2x2x2 points",
        gauss2, hourglassShares},
       {.name = "uniform-strain",
        .help =
            "the mean strain of the element alone, hourglass modes held by a stiffness and a viscosity of their own "
            "(Flanagan & Belytschko 1981): the quickest",
        .points = onePoint,
        .uniformStrain = true}}};
  static constexpr QuadratureRule massRule = rules[0];
};

}  // namespace ringwatch
