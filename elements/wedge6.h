#pragma once
#include <array>

#include <ringwatch/base/host_device.h>
#include <ringwatch/elements/cell_subdivision.h>
#include <ringwatch/elements/directions.h>
#include <ringwatch/elements/quadrature.h>

namespace ringwatch {

/// Six-node wedge (triangular prism): linear on the triangle (r, s), linear along ζ in [-1, 1]. Node order of
/// gmsh and of decks: 3, 4, 5 lie above 0, 1, 2 on the side that the right-handed normal of 0, 1, 2 points to; VTK's
/// linear wedge has them on the other side.
struct Wedge6 {
  static constexpr std::string_view name = "wedge6";
  static constexpr int nodes = 6;
  static constexpr int order = 1;
  static constexpr int vtkCellType = 13;
  static constexpr int gmshType = 6;
  static constexpr bool constantGradient = false;
  static constexpr bool positiveRowSums = true;
  static constexpr double referenceVolume = 1.0;
  static constexpr std::array<std::array<double, 3>, nodes> referenceNodes{
      {{0, 0, -1}, {1, 0, -1}, {0, 1, -1}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}}};
  static constexpr std::array<std::array<int, 4>, 5> faces{
      {{0, 2, 1, -1}, {3, 4, 5, -1}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}}};
  static constexpr std::array<std::array<int, 2>, 9> edges{
      {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}}};
  static constexpr std::array<CellSubdivision, 1> cellSplits{
      {{name, 2, false, CellSubdivision::wedges, CellSubdivision::wedges}}};

  /// N_a = L_a(r, s) (1 ± ζ)/2 with the area coordinates L = (1 - r - s, r, s)
  template <class S>
  RINGWATCH_HOST_DEVICE static constexpr void shape(const S xi[3], S N[nodes]) {
    const S L[3] = {S(1) - xi[0] - xi[1], xi[0], xi[1]};
    for (int a = 0; a < 3; ++a) {
      N[a] = S(0.5) * L[a] * (S(1) - xi[2]);
      N[a + 3] = S(0.5) * L[a] * (S(1) + xi[2]);
    }
  }
  /// ∂N_a/∂ξ_j
  template <class S>
  RINGWATCH_HOST_DEVICE static constexpr void shapeGradient(const S xi[3], S dN[nodes][3]) {
    const S L[3] = {S(1) - xi[0] - xi[1], xi[0], xi[1]};
    const S low = S(0.5) * (S(1) - xi[2]), high = S(0.5) * (S(1) + xi[2]);
    for (int a = 0; a < 3; ++a) {
      for (int j = 0; j < 2; ++j) {
        const S slope(a == 0 ? -1 : a == j + 1 ? 1 : 0);
        dN[a][j] = slope * low;
        dN[a + 3][j] = slope * high;
      }
      dN[a][2] = S(-0.5) * L[a];
      dN[a + 3][2] = S(0.5) * L[a];
    }
  }

  using Directions = WedgeDirections;
  static constexpr auto sixPoints = Directions::points;
  static constexpr std::array<QuadraturePoint, 2> twoPoints{
      {{{1.0 / 3, 1.0 / 3, -gauss::p2}, 0.5}, {{1.0 / 3, 1.0 / 3, gauss::p2}, 0.5}}};
  static constexpr std::array<QuadratureRule, 3> rules{
      {{"gauss-3x2", "three points on the triangle by two along the axis, full rank", sixPoints},
       {.name = "fierz2013",
        .help = "two points, as in Fierz 2013, table 2.1; one spurious mode: the triangles turn against each other",
        .points = twoPoints,
        .spuriousModes = 1,
        .alias = "source"},
       {"selective", "gauss-3x2 for shear, the mean strain of the element for pressure: no volumetric locking",
        sixPoints, selectiveShares}}};
  static constexpr QuadratureRule massRule{"gauss-3x2", "exact for masses", sixPoints};
};

}  // namespace ringwatch
