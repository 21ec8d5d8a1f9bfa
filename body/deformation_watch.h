#pragma once
#include <cstdint>
#include <vector>

#include <ringwatch/base/aligned.h>
#include <ringwatch/body/element_block.h>
#include <ringwatch/body/motion_odometer.h>

namespace ringwatch {

/// Tells which elements of a block have left a ball |F - F0| <= r around an anchor, cheaply: groups of batches rest
/// while an odometer says that nothing has moved by more than the room that the last look left. Norms are Frobenius
/// norms. Numbers are kept in single precision and rounded to the safe side.
struct DeformationWatch {
  static constexpr int groupBatches = 64;
  struct Group {
    std::int32_t batchBegin, batchEnd;
    std::size_t runBegin, runEnd;  // into runs
    double room = -1;              // at the last look: min of (r - |F - F0|) over γ; < 0: look
    double reach = 0;              // largest |F| over γ that elements come to within that room
    double turnedSince = 0;        // the odometer then
  };
  AlignedVector<float> anchor;               // [batch][q][9][lane], F0
  AlignedVector<float> radius;               // [batch][lane], r; < 0: always left; infinity: never
  AlignedVector<float> inverseGradientNorm;  // [batch][lane], 1/γ, m
  std::vector<Group> groups;
  std::vector<std::int32_t> patchGroups;      // patches + 1: groups of each patch
  std::vector<std::int32_t> runs;             // the odometer's runs of nodes that each group touches
  std::vector<MotionOdometer::Course> since;  // of each of them, the odometer at the last look

  /// Sizes everything for a block; every element counts as having left until it is anchored.
  DeformationWatch(const ElementBlock& block, const MotionOdometer& odometer);
  /// Forgets all room: the next look visits every element.
  void lookAtAll() {
    for (Group& group : groups) group.room = -1;
  }
  /// Forgets the room of a batch's group: its elements' balls have become smaller.
  void lookAtBatch(std::int32_t batch);
  /// Whether no element of the group can have left its ball.
  bool rests(const Group& group, const MotionOdometer& odometer) const;
  /// A group has been looked at.
  void startRest(Group& group, double room, double reach, const MotionOdometer& odometer);
};

}  // namespace ringwatch
