#pragma once
#include <optional>
#include <span>
#include <string>

#include <ringwatch/body/domain.h>
#include <ringwatch/distributed/halo.h>

namespace ringwatch {

/// The domain of a rank's part: what works on the body of a process works on the part with it, and has the same bits
/// for any number of ranks and any partition (Theorems 78 and 84, docs/theory/distribution.md).
class RankDomain : public Domain {
 public:
  /// The part's body is of this domain until it ends. halo: of the part, or of another on the same nodes. All must
  /// outlive the domain.
  RankDomain(Ranks& ranks, Halo& halo, RankBody& part) : ranks_(ranks), halo_(halo), part_(part) {
    part.body().setDomain(*this);
  }
  ~RankDomain() override { part_.body().setDomain(wholeDomain()); }
  RankDomain(const RankDomain&) = delete;
  RankDomain& operator=(const RankDomain&) = delete;

  bool whole() const override { return false; }
  bool first() const override { return ranks_.rank() == 0; }
  Eigen::Index owned(Eigen::Index) const override { return part_.ownedNodes(); }
  bool counts(ElementRef e) const override { return part_.counts(e); }
  ElementRef inWhole(ElementRef e) const override { return part_.globalElement(e); }
  std::int32_t nodeInWhole(std::int32_t node) const override { return part_.globalNode(node); }
  std::optional<ElementRef> here(ElementRef inWhole) const override { return part_.localElement(inWhole); }
  void largest(std::span<double> numbers, const std::function<void()>& meanwhile = {}) override {
    ranks_.largest(numbers, meanwhile);
  }
  void sum(std::span<ExactSum> sums) override { ranks_.sum(sums); }
  std::optional<ElementRef> firstFound(std::optional<ElementRef> found, std::string& text) override;
  void share(void* data, std::size_t bytes, bool has) override;
  void exchange(NodeVectors& vectors) override { halo_.exchange(vectors); }
  void exchange(Eigen::Matrix<double, 6, Eigen::Dynamic>& values) override { halo_.exchange(values); }
  void begin(NodeVectors& vectors) override { halo_.begin(vectors); }
  void finish() override { halo_.finish(); }
  NodeArrival* arrival() override { return halo_.arrival(); }
  const NodeVectors& withGhosts(const NodeVectors& x) override;
  NodeVectors gathered(const NodeVectors& ofPart) override;
  NodeVectors taken(NodeVectors ofWhole) const override { return ofWhole(Eigen::all, part_.globalNodes()); }

 private:
  Ranks& ranks_;
  Halo& halo_;
  RankBody& part_;
  NodeVectors withGhosts_;
};

/// The vectors of all nodes (3×N, numbered as in the whole) on rank 0, from their owners; 3×0 on the others.
/// Collective.
NodeVectors gathered(Ranks& ranks, const RankBody& part, NodeVectorsView vectors);

}  // namespace ringwatch
