#pragma once
#include <cstdint>
#include <vector>

#include <ringwatch/base/aligned.h>
#include <ringwatch/body/element_block.h>
#include <ringwatch/body/motion_odometer.h>

namespace ringwatch {

/// Tells which elements of a block have left a ball |F - F0| <= r around an anchor, cheaply: groups of batches rest
/// while an odometer says that nothing has moved by more than the room that the last look left. Where it says too much,
/// for it adds up paths and knows one affine motion only, the group's own nodes are asked: with x = y + t + A (y - c) +
/// r since the look, each deformation gradient has changed by at most |A| |F| + γ max |r - r'|. Norms are Frobenius
/// norms. Numbers of elements are kept in single precision and rounded to the safe side.
struct DeformationWatch {
  static constexpr int groupBatches = 64;
  /// Elements with less than this share of their radius left count as having left their balls: one that is at the edge
  /// would keep its whole group from resting.
  static constexpr double restingShare = 0.25;
  struct Group {
    std::int32_t batchBegin, batchEnd;
    std::size_t runBegin, runEnd;                    // into runs
    std::size_t nodeBegin, nodeEnd;                  // into nodes
    double roomAtLook = -1;                          // at the last look: min of (r - |F - F0|) over γ, m; < 0: look
    double reach = 0;                                // largest |F| over γ that elements come to within that room, m
    double room = 0;                                 // what was left of it when the group last rested by its own nodes
    double turnedSince = 0;                          // the odometer then
    Eigen::Matrix3d turn = Eigen::Matrix3d::Zero();  // A of the common motion since then, as last fitted
    std::int64_t lookedAt = 0;                       // the odometer's count at the last look
    bool rested = true;                              // since it last began to rest
    std::int16_t pause = 0, waits = 0;  // looks without trying to rest after one that was in vain; those still to come
  };
  AlignedVector<float> anchor;               // [batch][q][9][lane], F0
  AlignedVector<float> radius;               // [batch][lane], r; < 0: always left; infinity: never
  AlignedVector<float> inverseGradientNorm;  // [batch][lane], 1/γ, m
  std::vector<Group> groups;
  std::vector<std::int32_t> patchGroups;      // patches + 1: groups of each patch
  std::vector<std::int32_t> runs;             // the odometer's runs of nodes that each group touches
  std::vector<MotionOdometer::Course> since;  // of each of them, the odometer when `room` was set
  std::vector<std::int32_t> nodes;            // of each group, filled up to a multiple of 8 with its last
  AlignedVector<double> before;               // their positions at the last look

  /// Sizes everything for a block; every element counts as having left until it is anchored.
  DeformationWatch(const ElementBlock& block, const MotionOdometer& odometer);
  /// Forgets all room: the next look visits every element.
  void lookAtAll() {
    for (Group& group : groups) group.roomAtLook = -1;
  }
  /// The element at `place` has got a new ball around positions at which the odometer stands.
  void noteBall(std::size_t place, const MotionOdometer& odometer);
  /// Whether no element of the group can have left its ball at x, where the odometer stands.
  bool rests(Group& group, const MotionOdometer& odometer, const NodeVectors& x);
  /// A group is looked at without an odometer: it is not known any more what has moved since.
  static void getUp(Group& group) {
    group.roomAtLook = -1;
    group.rested = true;
  }
  /// A group has been looked at, at x, where the odometer stands.
  void startRest(Group& group, double room, double reach, const MotionOdometer& odometer, const NodeVectors& x);

 private:
  bool restsByOdometer(const Group& group, const MotionOdometer& odometer) const;
  double roomLeft(Group& group, const NodeVectors& x);
  static void noteRest(Group& group) {
    group.rested = true;
    group.pause = 0;
  }
  void setRoom(Group& group, double room, const MotionOdometer& odometer);
};

}  // namespace ringwatch
