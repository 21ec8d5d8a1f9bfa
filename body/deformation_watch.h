#pragma once
#include <cstdint>
#include <vector>

#include <ringwatch/base/aligned.h>
#include <ringwatch/base/short_floats.h>
#include <ringwatch/body/element_block.h>

namespace ringwatch {

/// Tells which elements of a block have left a ball |F - F0| <= r around an anchor, cheaply: groups of batches rest
/// while their nodes say that nothing has moved by more than the room that the last look left. With
///   x = y + t + A (y - c) + r   for any t and A
/// for the nodes of a group since that look, each of its deformation gradients has changed by at most
///   |ΔF| <= |A| |F| + γ max |r - r'|,   γ = Σ_a |∂N_a/∂X|.
/// Norms are Frobenius norms. Numbers of elements are kept in 16 bits and rounded to the safe side. Positions come as
/// the rows of a patch: four numbers a node, the last one zero.
struct DeformationWatch {
  static constexpr int groupBatches = 64;
  /// Elements with less than this share of their radius left count as having left their balls: one that is at the edge
  /// would keep its whole group from resting.
  static constexpr double restingShare = 0.25;
  /// Anchors are multiples of this; entries of F beyond 8 have none, and their elements no ball.
  static constexpr double anchorUnit = 1.0 / 4096, mostAnchored = 8 - anchorUnit;
  /// How far an anchor may lie from its F0, at most.
  static constexpr double anchorError = 1.5 * anchorUnit;
  struct Group {
    std::int32_t batchBegin, batchEnd;
    std::size_t nodeBegin, nodeEnd;                    // into nodes
    double roomAtLook = -1;                            // at the last look: min of (r - |F - F0|) over γ, m; < 0: look
    double reach = 0;                                  // largest |F| over γ then, m
    double rounding = 0;                               // of `before`, m
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();  // of `before`, m
    Eigen::Matrix3d turn = Eigen::Matrix3d::Zero();    // A of the common motion since then, as last fitted
    std::int64_t lookedAt = 0;                         // the count of looks then
    bool rested = true;                                // since it last began to rest
    std::int16_t pause = 0, waits = 0;  // looks without trying to rest after one that was in vain; those still to come
  };
  AlignedVector<std::int16_t> anchor;           // [batch][q][9][lane], F0 in units
  AlignedVector<Bfloat16> radius;               // [batch][lane], r about the anchor; < 0: always left; infinity: never
  AlignedVector<Bfloat16> inverseGradientNorm;  // [batch][lane], 1/γ, m
  std::vector<Group> groups;
  std::vector<std::int32_t> patchGroups;  // patches + 1: groups of each patch
  std::vector<std::uint16_t> nodes;       // of each group, within the patch; filled up to a multiple of 4 with its last
  std::vector<float> before;              // their positions at the last look from `centre`, m
  std::int64_t looks = 0;

  /// Sizes everything for a block; every element counts as having left until it is anchored.
  explicit DeformationWatch(const ElementBlock& block);
  /// Forgets all room: the next look visits every element.
  void lookAtAll() {
    for (Group& group : groups) group.roomAtLook = -1;
  }
  /// The element at `place` gets an anchor: F0 of its quadrature points, [q][9][lane] of some pack. Returns how far the
  /// anchor lies from it, at most; infinity when it cannot be kept.
  double setAnchor(std::size_t place, const double* F0, int points, int lane);
  /// And the radius of its ball around F0.
  void setRadius(std::size_t place, double aroundF0, double fromAnchor);
  /// The element at `place` has got a new ball around positions of the present look.
  void noteBall(std::size_t place);
  /// Whether no element of the group can have left its ball at the patch's rows of positions.
  bool rests(Group& group, const double* rows) const;
  /// A group has been looked at.
  void startRest(Group& group, double room, double reach, const double* rows);

 private:
  double roomLeft(Group& group, const double* rows) const;
};

}  // namespace ringwatch
