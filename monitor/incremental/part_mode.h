#pragma once
#include <vector>

#include <ringwatch/body/body.h>
#include <ringwatch/monitor/bounds.h>

namespace ringwatch {

/// A vector on a part of a body (body/domain.h) that is kept near the mode of the highest frequency, and its Rayleigh
/// quotient: a proven lower bound of the highest eigenvalue of M⁻¹K, whatever the vector (Theorems 8 and 44). Sums over
/// nodes are exact (ExactSum), so that the vector and the bound have the same bits for any partition. Collective.
class PartMode {
 public:
  /// The body must outlive this.
  explicit PartMode(const Body& body);

  /// Searches the mode at x (3×N, m, ghosts as their owners have them) with so many tangent products, by the locally
  /// optimal conjugate gradient method (Knyazev 2001, LOBPCG with one vector) from the vector kept, at first from a
  /// random one. Where few nodes hold nearly all of the quotient the others are left out, which makes bounds cheap.
  void find(NodeVectorsView x, int products);
  /// The quotient at x, less what rounding can have added. One product with the elements at nodes where the vector is
  /// not zero, one reduction, no exchange.
  LowerBound bound(NodeVectorsView x);
  bool found() const { return norm2_ > 0; }

 private:
  /// M^-½ K M^-½ y of free components at owned nodes; ghosts are zero.
  void apply(NodeVectorsView x, const NodeVectors& y, NodeVectors& result);
  void take(const NodeVectors& y, double cut);
  double highestSize(const NodeVectors& y);
  /// Which patches have a node where u is not zero.
  void findActive();

  const Body& body_;
  Domain& domain_;
  Eigen::Index owned_;
  NodeVectors inverseRootMass_;            // zero in constrained components
  NodeVectors mode_;                       // mass-scaled, as the last search left it
  NodeVectors u_;                          // M^-½ mode_, cut, with ghosts
  double norm2_ = 0;                       // uᵀMu
  std::vector<std::vector<bool>> active_;  // [block][patch]
  NodeVectors product_, rounding_;
  Body::Workspace workspace_;
};

}  // namespace ringwatch
