#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include <ringwatch/meshes/adjacency.h>

namespace ringwatch {

/// A triangle of the surface of a mesh.
struct SurfaceTriangle {
  std::array<std::int32_t, 3> nodes;  ///< counter-clockwise as seen from outside
  ElementFace face;                   ///< of which it is a part
};

/// The boundary faces as triangles, in element order. A quadrilateral is cut along its shorter diagonal at rest, that
/// of its first corner where both are equal; a face of a quadratic element at the middles of its edges.
std::vector<SurfaceTriangle> surfaceTriangles(const Mesh& mesh);

/// The nodes of the surface, those in the middles of edges included, ascending.
std::vector<std::int32_t> surfaceNodes(const Mesh& mesh);

}  // namespace ringwatch
