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
  /// Of which eigenvalue of M⁻¹K: the lowest one's mode is searched in the coordinates of LowestModeSearch, and what is
  /// said of a highest eigenvalue holds of -M⁻¹K.
  enum class End { highest, lowest };
  /// The body must outlive this.
  explicit PartMode(const Body& body, End end = End::highest);

  /// Searches the mode at x (3×N, m, ghosts as their owners have them) with so many tangent products, by the locally
  /// optimal conjugate gradient method (Knyazev 2001, LOBPCG with one vector) from the vector kept, at first from a
  /// random one. Where few nodes hold nearly all of the quotient the others are left out, which makes bounds cheap.
  void find(NodeVectorsView x, int products);
  /// The quotient at x, less what rounding can have added. One product with the elements at nodes where the vector is
  /// not zero, one reduction, no exchange.
  LowerBound bound(NodeVectorsView x);
  bool found() const { return norm2_ > 0; }
  /// The element with the least uᵀKu at x, u the vector, numbered as in the whole.
  ElementRef softestElement(NodeVectorsView x);

 private:
  /// S K S y of free components at owned nodes, or -S K S y; ghosts are zero.
  void apply(NodeVectorsView x, const NodeVectors& y, NodeVectors& result);
  void take(const NodeVectors& y, double cut);
  double highestSize(const NodeVectors& y);
  /// Which patches have a node where u is not zero.
  void findActive();

  const Body& body_;
  Domain& domain_;
  Eigen::Index owned_;
  double sign_;                            // -1: of the lowest eigenvalue
  NodeVectors scale_;                      // S: M^-½, or scaleForSigns(); zero in constrained components
  NodeVectors mode_;                       // as the last search left it
  NodeVectors u_;                          // S mode_, cut, with ghosts
  double norm2_ = 0;                       // uᵀMu
  std::vector<std::vector<bool>> active_;  // [block][patch]
  NodeVectors product_, rounding_;
  Body::Workspace workspace_;
};

}  // namespace ringwatch
