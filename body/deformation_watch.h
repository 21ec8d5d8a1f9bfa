#pragma once
#include <cstdint>
#include <vector>

#include <ringwatch/base/aligned.h>
#include <ringwatch/body/element_block.h>

namespace ringwatch {

/// Tells which elements of a block have left a ball |F - F0| <= r around an anchor, cheaply: groups of batches are
/// passed over while their nodes have moved, relative to each other, by less than the slack that the last look left,
/// for
///   |F - F'| <= γ_e max_a |u_a - u'_a - t|   for any translation t,  γ_e = max_q Σ_a |∂N_a/∂X|.
/// Norms are Frobenius norms. Numbers are kept in single precision and rounded to the safe side.
struct DeformationWatch {
  static constexpr int groupBatches = 8;
  struct Group {
    std::int32_t batchBegin, batchEnd;
    std::int32_t nodeBegin, nodeEnd;  // into groupNodes
    double slack = -1;                // how far nodes may move before the next look; < 0: look
  };
  AlignedVector<float> anchor;        // [batch][q][9][lane], F0
  AlignedVector<float> radius;        // [batch][lane], r; < 0: always left; infinity: never
  AlignedVector<float> gradientNorm;  // [batch][lane], γ
  std::vector<Group> groups;
  std::vector<std::int32_t> patchGroups;  // patches + 1: groups of each patch
  std::vector<std::uint16_t> groupNodes;  // rows of the patch's node list
  AlignedVector<double> lookedAt;         // [group node][4], position at the last look

  /// Sizes everything for a block; every element counts as having left until it is anchored.
  explicit DeformationWatch(const ElementBlock& block);
  /// Forgets every slack: the next look visits every element.
  void lookAtAll() {
    for (Group& group : groups) group.slack = -1;
  }
};

}  // namespace ringwatch
