#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <ringwatch/body/body.h>
#include <ringwatch/distributed/partition.h>
#include <ringwatch/distributed/rank_part.h>

namespace ringwatch {

/// What a rank has of a body: the nodes that it owns, every element that touches one of them, and the other nodes of
/// these elements, its ghosts. Sums at owned nodes have the terms of the whole body in its order, so that they have its
/// bits, for any partition (Theorem 78, docs/theory/distribution.md); sums at ghosts lack terms.
class RankBody {
 public:
  /// The part of `rank`, with the masses, constraints, dead forces and sets of the whole body, which may go after this.
  /// Throws InputError for what is not distributed: springs and contact, and elements that damp.
  RankBody(const Body& whole, const Partition& partition, int rank, int threads = 0);
  /// A part of a mesh that no rank has as a whole, without constraints and loads: with a block for each of the part's
  /// mesh, and the lumped mass of each node, kg, ghosts as their owners have them.
  RankBody(RankPart part, std::vector<std::unique_ptr<ElementBlock>> blocks, Eigen::VectorXd lumpedMass,
           int threads = 0);
  /// The body refers to itself.
  RankBody(const RankBody&) = delete;
  RankBody& operator=(const RankBody&) = delete;

  /// Owned nodes first, by their numbers in the whole; then ghosts, by owner and number.
  const Body& body() const { return *body_; }
  Body& body() { return *body_; }
  std::int32_t ownedNodes() const { return part_.ownedNodes; }
  std::int32_t ghostNodes() const { return body_->nodeCount() - ownedNodes(); }
  std::int64_t elements() const { return body_->elementCount(); }
  /// The number of a node in the whole.
  std::int32_t globalNode(std::int32_t node) const { return part_.globalNodes[node]; }
  const std::vector<std::int32_t>& globalNodes() const { return part_.globalNodes; }
  /// The element in the whole.
  ElementRef globalElement(ElementRef e) const { return {e.block, part_.globalElements[e.block][e.element]}; }
  /// The element here that has that number in the whole; nothing where it is not of this part.
  std::optional<ElementRef> localElement(ElementRef global) const;
  /// The whole is some elements of a larger body, whose numbers there are given by block, ascending: elements are named
  /// by them from here on.
  void nameElementsBy(const std::vector<std::vector<std::int32_t>>& numbers);
  /// Whether this rank counts the element where each is to count once: the one that owns its first node.
  bool counts(ElementRef e) const { return body_->blocks()[e.block]->nodesOf(e.element).front() < ownedNodes(); }

  using Neighbour = RankPart::Neighbour;
  /// By rank.
  const std::vector<Neighbour>& neighbours() const { return part_.neighbours; }
  /// Patches of the body, counted over all blocks, ascending: those whose nodes are all owned, and those with a ghost.
  const std::vector<std::int64_t>& patchesOfOwned() const { return patchesOfOwned_; }
  const std::vector<std::int64_t>& patchesWithGhosts() const { return patchesWithGhosts_; }

 private:
  using Blocks = std::vector<std::unique_ptr<ElementBlock>>;
  /// Takes the part with its elements and masses.
  void take(RankPart part, Blocks blocks, Eigen::VectorXd mass, int threads);

  std::unique_ptr<Body> body_;  // blocks refer to the mesh's arrays
  RankPart part_;               // without its mesh, which the body has
  std::vector<std::int64_t> patchesOfOwned_, patchesWithGhosts_;
};

}  // namespace ringwatch
