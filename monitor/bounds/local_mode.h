#pragma once
#include <algorithm>
#include <memory>
#include <vector>

#include <ringwatch/base/archive.h>
#include <ringwatch/body/body.h>
#include <ringwatch/monitor/bounds.h>
#include <ringwatch/monitor/bounds/first_element.h>
#include <ringwatch/monitor/bounds/nodal_bound.h>

namespace ringwatch {

/// A lower bound of the highest eigenvalue from a region around the place where a tracked mode is largest: M^-½ K M^-½
/// cut to its nodes is a principal submatrix of the whole (Theorem 9), and a Rayleigh quotient a lower bound of its
/// highest eigenvalue (Theorem 8, docs/theory/rings_and_rayleigh.md). The elements at those nodes are a body of their
/// own, so that the cost does not grow with the mesh. A region is connected: on a regular grid, where the mode moves
/// all nodes alike, scattered nodes would hold little of it, and a box of n nodes a side loses about (π/n)²/4 of a
/// direction's part. Nodes of rigid bodies are of no region.
class LocalMode {
 public:
  /// `incidences` knows the elements at each node. Every `gap`-th evaluation improves the mode by Lanczos with
  /// `products` tangent products, the first one in a region with three times as many; the others take one.
  LocalMode(const Body& body, const NodalBound& incidences, int products, int gap)
      : body_(body), incidences_(incidences), products_(products), gap_(gap), highest_(firstElement(body)) {}

  /// Chooses a region of at most `nodes` nodes around the largest entry of `mode` (3×N, mass-scaled coordinates), and
  /// starts from the mode there. A mode without an entry above zero has no region, nor has an empty one,
  /// nor one that is largest at a node without elements.
  void choose(const NodeVectors& mode, std::size_t nodes);
  /// The bound at positions x (3×N, m); 0 without a region, NaN where the tangent is not finite, after which a mode has
  /// to be chosen again. Masses and constraints are those of now.
  /// mayImprove: whether the mode may be improved now.
  LowerBound evaluate(NodeVectorsView x, bool mayImprove = true);
  /// The last evaluation's; 0 after a choice.
  const LowerBound& last() const { return last_; }
  /// Tangent products of the last evaluation, one of them for rounding, and the body of the region that they were of;
  /// nullptr for none.
  int products() const { return spentProducts_; }
  const Body* part() const { return part_.get(); }
  /// Whether the region has a node.
  bool holds(std::int32_t node) const { return std::binary_search(region_.begin(), region_.end(), node); }
  /// The mode as it is now, of the whole body (3×N, mass-scaled coordinates): zero outside of the region.
  NodeVectors mode() const;
  /// Products that an evaluation takes which improves the mode.
  int productsOfImproving() const { return products_ + 1; }
  /// The element that holds most of the mode's energy at the node that it moves most, as of one of the last
  /// evaluations.
  ElementRef highestElement() const { return highest_; }
  /// The share of the mode's energy that springs and contact hold, of the last evaluation.
  double discreteShare() const { return discreteShare_; }
  /// Likewise what damping holds.
  double dampingShare() const { return last_.dampingShare(); }
  /// Searches highestElement() in the mode as it is now, at the positions of the last evaluation (3×N, m).
  void searchHighest(NodeVectorsView x);

  template <class Archive>
  void archive(Archive& a) {
    a(size_, region_);
    if constexpr (Archive::loads) {
      part_.reset();
      nodes_.clear();
      requireRegion();
      if (!region_.empty()) makePart(region_);
    }
    a(vector_, largest_, last_, highest_, discreteShare_, spentProducts_, sinceSearch_, sinceImproved_, isNew_);
    archiveVersion(a, bodyVersion_, body_.version());
    if constexpr (Archive::loads) requireVector();
  }

 private:
  /// Throw InputError unless what was read are nodes of the body, ascending, and a mode of their part.
  void requireRegion() const;
  void requireVector() const;
  /// Nodes of the region, grown from the largest entry.
  std::vector<std::int32_t> grow(const NodeVectors& mode) const;
  void makePart(const std::vector<std::int32_t>& region);
  void measureShare(LowerBound bound);
  /// Entries below this share of the largest one count as that much, so that nodes beside a mode of few entries come
  /// first.
  static constexpr double leastAmplitude = 1e-3;
  /// Evaluations between two searches for the highest element, which take some tangents each.
  static constexpr int searchGap = 16;

  const Body& body_;
  const NodalBound& incidences_;
  std::size_t size_ = 0;  // nodes of the region, at most
  int products_, gap_, spentProducts_ = 0;
  std::unique_ptr<Body> part_;
  std::vector<std::int32_t> region_, nodes_;  // ascending; nodes_: of the part, the region and its rim, which is held
  NodeVectors x_, vector_;                    // positions and the mode, of the part
  double largest_ = 0;                        // size of an eigenvalue that was seen in this region, for the rounding
  LowerBound last_{0};
  ElementRef highest_;
  double discreteShare_ = 0;
  int sinceSearch_ = searchGap, sinceImproved_ = 0;
  bool isNew_ = false;
  std::int64_t bodyVersion_ = 0;  // that the part has masses and constraints of
};

}  // namespace ringwatch
