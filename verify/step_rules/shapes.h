#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <ringwatch/base/random.h>
#include <ringwatch/body/body.h>
#include <ringwatch/verify/plane_element.h>

namespace ringwatch {

/// A family of shapes of an element, from which shapes are drawn at random. Sizes are about 1 m.
struct ShapeFamily {
  std::string_view name, element;
  std::string_view rule;   // quadrature; "" for the element's default
  bool stretched = false;  // the shapes are what random gradients, stretches 0.7 to 1.4, make of those of the mesh
  /// Draws the corners of a shape, 3×n, m; it need not be valid.
  NodeVectors (*draw)(Random& random);
};

/// Random tetrahedra, nine kinds of bad ones, hexahedra, wedges and pyramids, and stretched ones of each.
std::span<const ShapeFamily> shapeFamilies();

/// `count` valid shapes of a family as one mesh of separate elements: det F is positive at the corners and at the
/// points of the mass's quadrature rule. `seed` says which.
Mesh meshOfShapes(const ShapeFamily& family, int count, std::uint64_t seed);

/// Random gradients of separate elements applied to their nodes, 3×N, m.
NodeVectors stretchedShapes(const Mesh& mesh, std::uint64_t seed);

/// A valid random triangle or quadrilateral: normal coordinates, as those of tetrahedra; convex quadrilaterals.
PlaneShape randomPlaneShape(int nodes, Random& random);

}  // namespace ringwatch
