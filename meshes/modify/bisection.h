#pragma once
#include <functional>
#include <vector>

#include <ringwatch/meshes/mesh.h>

namespace ringwatch {

/// A point on the edge between two nodes, at (1 - t) x_a + t x_b, 0 < t < 1.
struct EdgePoint {
  std::int32_t a, b;
  double t;
};

/// A mesh of tetrahedra whose edges were cut in two.
struct BisectedMesh {
  Mesh mesh;                                      // nodes of the mesh before keep their numbers, new ones follow
  std::vector<EdgePoint> newNodes;                // where they are, in their order
  std::vector<std::vector<std::int32_t>> parent;  // [block][element]: the element before that it is a part of
};

/// Puts a node onto each of these edges and cuts the tetrahedra around it, edge after edge, the longest first (ties by
/// node number): an order that all tetrahedra around a face share, so that the result conforms whatever the edges are.
/// Parts of an element follow each other; the first keeps its id, others get ids beyond the largest one, like new
/// nodes. A new node is in a node set when both ends of its edge are. Pairs that are no edge of the mesh get a node
/// that no element uses. Throws InputError for elements other than tet4, a point outside its edge and an edge given
/// twice.
BisectedMesh bisectEdges(const Mesh& mesh, const std::vector<EdgePoint>& points);

/// Bisects longest edges in the middle, and those of neighbours as far as conformity asks for (Rivara 1984), until
/// every tetrahedron's longest edge is at most longest(its middle), m. Throws InputError for elements other than tet4,
/// a wanted length that is not > 0, and when there are more than `most` tetrahedra before all are short enough.
Mesh refineTetrahedra(Mesh mesh, const std::function<double(const Eigen::Vector3d& middle)>& longest,
                      std::size_t most = 200'000'000);

}  // namespace ringwatch
