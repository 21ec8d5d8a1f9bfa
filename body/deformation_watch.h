#pragma once
#include <cstdint>
#include <vector>

#include <ringwatch/base/aligned.h>
#include <ringwatch/body/element_block.h>

namespace ringwatch {

/// Tells which elements of a block have left a ball |F - F0| <= r around an anchor, cheaply: groups of batches are
/// passed over while their nodes have moved, but for an affine motion, by less than the slack that the last look left.
/// With y the positions and F' the deformation gradient at that look, x = y + t + A y + r for any t and A,
///   |F - F'| <= |A| |F'| + γ_e max_a |r_a|,   γ_e = max_q Σ_a |∂N_a/∂X|.
/// t and A are those of four nodes of the group that lie far apart. Norms are Frobenius norms. Numbers are kept in
/// single precision and rounded to the safe side.
struct DeformationWatch {
  static constexpr int groupBatches = 8;
  struct Group {
    std::int32_t batchBegin, batchEnd;
    std::int32_t nodeBegin, nodeEnd;  // into groupNodes
    double slack = -1;                // min of room over γ: what |A| reach + |r| may be; < 0: look
    double reach = 0;                 // max of |F'| over γ
    std::int32_t frame[4] = {};       // group nodes that t and A are taken from
    double inverse[9] = {};           // of the frame's edges at the look, row by row
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
