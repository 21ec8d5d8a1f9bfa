#pragma once
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include <ringwatch/app/output/frames.h>
#include <ringwatch/distributed/rank_body.h>
#include <ringwatch/distributed/ranks.h>

namespace ringwatch {

/// The frames of a run on ranks: each rank writes the elements that it counts (RankBody::counts), with their nodes.
/// Nodes at a border are in several pieces; the array originalNodeId says which are the same.
class RankFrames final : public FramePieces {
 public:
  /// Collective. Both must outlive this.
  RankFrames(Ranks& ranks, const RankBody& part);

  /// Collective.
  void write(const std::filesystem::path& path, const NodeVectors& x, std::span<const VtuField> pointFields,
             std::span<const VtuField> cellFields, double time, std::span<const VtuField> frameFields) override;
  bool writesList() const override { return ranks_.rank() == 0; }

 private:
  Ranks& ranks_;
  Mesh piece_;
  std::vector<std::size_t> nodes_, elements_;  // of the part, that the piece has; elements counted through all blocks
  std::vector<int> writers_;                   // ranks that count an element; on rank 0
};

}  // namespace ringwatch
