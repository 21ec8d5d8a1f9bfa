#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <ringwatch/meshes/mesh.h>

namespace ringwatch {

/// The splits of all elements.
std::vector<CellSubdivision> allCellSubdivisions();

/// A box of nx × ny × nz cells.
struct BarOptions {
  std::array<double, 3> size{1, 1, 1};    // m, each > 0
  std::array<int, 3> cells{1, 1, 1};      // along x, y, z, each > 0
  std::array<double, 3> origin{0, 0, 0};  // the corner with the smallest coordinates, m
  std::string element = "tet4";
  int split = 0;      // elements a cell (tet4: 6 or 5); 0 takes the element's usual split
  double jitter = 0;  // largest displacement of a node along each axis, as a fraction of the local cell size, < 0.5
  std::uint64_t seed = 1;  // of the jitter
  double grading = 1;      // length of the last cell over that of the first along x, ≥ 1
};

/// The box. Nodes: x fastest, then y, z, then the middles of the cells. Node sets "x-min" … "z-max" hold the faces, the
/// element set "all" every element. Jitter moves inner nodes freely and nodes of the surface within it, so that the box
/// keeps its shape; it depends on the seed alone, not on the machine.
/// Throws InputError naming the parameter, its value and its range, or the element that the jitter inverts.
Mesh generateBar(const BarOptions& options);

/// A bar that holds every linear element, faces shared without gaps, in sections along x: wedges (axis z), hexahedra,
/// one layer of pyramids with a few tetrahedra, tetrahedra (Kuhn's split), wedges (axis x). Triangles meet triangles
/// and quadrilaterals quadrilaterals throughout. element and split of the options are not used; at least 5 cells along
/// x.
Mesh generateMixedBar(const BarOptions& options);

/// A ball of radius `radius` around the origin.
struct BallOptions {
  double radius = 1;  // m, > 0
  int cells = 4;      // across the diameter, > 0
  std::string element = "tet4";
  int split = 0;
};

/// A cube of cells mapped smoothly onto the ball: x ← x √(1 − y²/2 − z²/2 + y²z²/3), and so on round (Nowell). Node set
/// "surface", element set "all". Quadratic elements have straight sides: an element with two curved faces in the sphere
/// would be flat along their common edge. Throws InputError like `generateBar`.
Mesh generateBall(const BallOptions& options);

/// A hollow cylinder around the axis y, or a gear.
struct RingOptions {
  double radius = 1, inner = 0.5;      // m, 0 < inner < radius
  double width = 0.5;                  // along y, from 0, m, > 0
  std::array<int, 3> cells{16, 2, 2};  // around, between inner and outer radius, along y; at least 3 around
  std::string element = "tet4";
  int split = 0;
  int teeth = 0;          // 0: round. Trapezoids: a quarter of each pitch outside, inside and on each flank
  double toothDepth = 0;  // m, from the radius inwards, >= 0, < radius - inner
};

/// Cells in polar coordinates, closed around. Node sets "inside", "outside", "y-min" and "y-max", element set "all".
/// Throws InputError like `generateBar`; where the cells around do not fit the teeth (a multiple of four cells each) or
/// a split that alternates from cell to cell (an even number).
Mesh generateRing(const RingOptions& options);

/// Two boxes of the same element, one above the other, that share no node.
struct StackOptions {
  BarOptions lower;                          // element, split and jitter are those of both
  std::array<double, 3> upperSize{1, 1, 1};  // m, each > 0
  std::array<int, 3> upperCells{1, 1, 1};    // each > 0
  double gap = 0;                            // m, along z, ≥ 0
  std::array<double, 2> offset{0, 0};        // of the upper one's middle from the lower one's, along x and y, m
};

/// The boxes, the nodes and elements of the lower one first. Node sets "lower" and "upper" hold the nodes of each,
/// "lower x-min" … "upper z-max" its faces; element sets "lower", "upper" and "all". The jitter of the upper box has
/// the next seed. Throws InputError like `generateBar`.
Mesh generateStack(const StackOptions& options);

/// A box of tetrahedra that are small at a plane.
struct RefinedBarOptions {
  BarOptions coarse;    // cells to begin with; element and split are tet4's
  double finest = 0;    // longest edge at the plane, m, > 0
  double plane = 0;     // its x, m, from the smallest coordinates of the box
  double growth = 0.3;  // of the longest edge a metre of distance from the plane, m/m, ≥ 0
};

/// The box, its tetrahedra bisected until no edge is longer than finest + growth × (distance of their middle from the
/// plane). Sets as `generateBar`. Throws InputError like it.
Mesh generateRefinedBar(const RefinedBarOptions& options);

/// A cube: `generateBar` with equal sizes and counts; edge in m.
Mesh generateCube(double edge, int cells, BarOptions rest = {});

}  // namespace ringwatch
