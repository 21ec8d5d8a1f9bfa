#pragma once
#include <cstdint>
#include <span>
#include <string_view>

namespace ringwatch {

/// One way to cut a box-shaped cell into elements. Each element names its own, its usual one first.
struct CellSubdivision {
  std::string_view element;  // its name
  int elementsPerCell;
  bool centre;  // the cell gets a node of its own in its middle, corner number 8
  /// Corners i + 2j + 4k of the cell, element after element, in the element's (VTK) node order. Quadratic elements get
  /// nodes in the middle of their edges by themselves.
  std::span<const std::uint8_t> even;
  /// The same for cells of odd i + j + k, where a split must alternate to match its neighbours; else equal to even.
  std::span<const std::uint8_t> odd;

  // Corners that elements share.
  /// Kuhn's split: one tetrahedron for each order in which x, y and z can be walked from corner 0 to corner 7.
  static constexpr std::uint8_t kuhn[] = {0, 1, 3, 7, 0, 1, 7, 5, 0, 2, 7, 3, 0, 2, 6, 7, 0, 4, 5, 7, 0, 4, 7, 6};
  /// One tetrahedron in the middle and one at each of four corners; the face diagonals match when cells alternate.
  static constexpr std::uint8_t fiveEven[] = {0, 3, 6, 5, 1, 0, 5, 3, 2, 3, 6, 0, 4, 5, 0, 6, 7, 6, 3, 5};
  static constexpr std::uint8_t fiveOdd[] = {1, 2, 4, 7, 0, 1, 2, 4, 3, 2, 1, 7, 5, 4, 7, 1, 6, 7, 4, 2};
  static constexpr std::uint8_t whole[] = {0, 1, 3, 2, 4, 5, 7, 6};
  /// Prisms along z, cut by the plane through corners 0, 3, 4 and 7.
  static constexpr std::uint8_t wedges[] = {0, 1, 3, 4, 5, 7, 0, 3, 2, 4, 7, 6};
  /// A pyramid on each face, the apex in the middle.
  static constexpr std::uint8_t pyramids[] = {0, 1, 3, 2, 8, 6, 7, 5, 4, 8, 4, 5, 1, 0, 8,
                                              5, 7, 3, 1, 8, 7, 6, 2, 3, 8, 6, 4, 0, 2, 8};
};

}  // namespace ringwatch
