#pragma once
#include <cstdint>
#include <vector>

#include <ringwatch/body/body.h>
#include <ringwatch/monitor/bounds/nodal_bound.h>

namespace ringwatch {

/// Where the highest eigenvalue of M⁻¹K(x) may be: the nodes whose own 3×3 block of it has the longest diagonal, the
/// longest first, no two of them in one element. A guess, from one tangent of every element, which costs a fraction of
/// all reduced rings. Springs, contact and the nodes of rigid bodies are left out.
class StiffNodes {
 public:
  /// Both must outlive the search; `incidences` knows the elements at each node.
  StiffNodes(const Body& body, const NodalBound& incidences) : body_(body), incidences_(incidences) {}

  /// At most `count` nodes at positions x (3×N, m), fewer where not so many are free. Nodes whose diagonal is not
  /// finite are left out.
  std::vector<std::int32_t> find(NodeVectorsView x, std::size_t count);
  /// The diagonal of a node's block, N/m, as found last; 0 in constrained components.
  Eigen::Vector3d diagonalAt(std::int32_t node) const { return diagonal_.col(node); }

 private:
  const Body& body_;
  const NodalBound& incidences_;
  Body::Workspace workspace_;
  NodeVectors diagonal_;
};

}  // namespace ringwatch
