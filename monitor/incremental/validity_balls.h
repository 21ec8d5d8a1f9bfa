#pragma once
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include <ringwatch/base/aligned.h>
#include <ringwatch/base/short_floats.h>
#include <ringwatch/body/element_block.h>

namespace ringwatch {

/// Finds the elements of a block that have left their validity balls |F - F0| <= r, F0 the reference gradient at which
/// an element was last evaluated. Norms are Frobenius norms.
///
/// Most elements are not visited. Elements are checked in groups of batches, and a group skips checks while its nodes
/// say that no element can have left. With
///   x = y + t + A (y - c) + ρ   for any t and A
/// for the nodes of a group since its last check, each of its deformation gradients has changed by at most
///   |ΔF| <= |A| |F| + γ max |ρ - ρ'|,   γ = Σ_a |∂N_a/∂X|
/// (Theorem 19, docs/theory/incremental_certificate.md; the code takes half the diagonal of a box of all ρ).
/// Stored numbers have 16 bits and are rounded to the safe side.
class ValidityBalls {
 public:
  /// Reference gradients are stored as multiples of this; entries of F beyond `largestEntry` cannot be stored, and
  /// their elements have no ball.
  static constexpr double entryUnit = 1.0 / 4096, largestEntry = 8 - entryUnit;
  /// How far a stored reference gradient lies from F0, at most.
  static constexpr double storageError = 1.5 * entryUnit;
  /// Elements with less than this fraction of their radius left count as outside: one at the edge of its ball would
  /// keep its whole group from skipping.
  static constexpr double edgeFraction = 0.25;

  /// Every element counts as outside until it has a ball.
  explicit ValidityBalls(const ElementBlock& block);

  /// Stores F0 of the element at `place` (batch * lanes + lane): F0[(q * 9 + i) * lanes + lane]. Returns how far the
  /// stored gradient lies from it, at most; infinity when it cannot be stored.
  double setReferenceGradient(std::size_t place, const double* F0, int points, int lane);
  /// Sums the stored reference gradients of an element over its quadrature points, row by row.
  void addReferenceGradient(std::size_t place, double (&sum)[9]) const;
  /// Sets the radius of the ball around F0; fromStored is the distance that setReferenceGradient returned. A negative
  /// radius puts the element outside at every check.
  void setRadius(std::size_t place, double aroundF0, double fromStored);
  /// The same for the elements of a batch, about stored gradients as far from F0 as can be. Those that are always or
  /// never outside stay so.
  void setRadii(std::int32_t batch, NativePack aroundF0);
  /// The element can never matter: it is inside at every check.
  void setNeverOutside(std::size_t place);
  /// The radius about the stored gradient: < 0 always outside, infinity never.
  double radius(std::size_t place) const { return radius_[place]; }

  /// How far the gradients of an element lie from its reference gradient F0, at most: F[(q * 9 + i) * lanes + lane].
  double distance(std::size_t place, const double* F, int lane) const;

  /// Begins a check at new positions: checkPatch of every patch follows.
  void beginCheck() { ++checks_; }
  /// Runs the batches of a patch and appends the elements that have left their balls.
  void checkPatch(const PatchPass& pass, std::vector<std::int32_t>& outside);
  /// Call it for every element that got a new ball, before the next check; distance: of the positions of the last check
  /// from F0, at most.
  void ballChanged(std::size_t place, double distance = storageError);
  /// The next check visits every element: radii have changed other than at the positions of the last check.
  void invalidateAll() {
    for (Group& group : groups_) group.marginAtCheck = -1;
  }
  /// What the last check took, in WorkAccount's units: it depends on how the groups moved, not on threads.
  double workOfCheck() const;
  /// Groups, and how many of them the last check visited.
  std::size_t groupCount() const { return groups_.size(); }
  std::size_t visitedGroups() const;

  template <class Archive>
  void archive(Archive& a) {
    a(referenceGradient_, radius_, groups_, before_, checks_);
  }

 private:
  class BallCheck;
  struct Group {
    template <class Archive>
    void archive(Archive& a) {
      a(batchBegin, batchEnd, nodeBegin, nodeEnd, marginAtCheck, leverArm, rounding, centre, motion, visitedAt, skipped,
        tried, fitted, pause, waits);
    }

    std::int32_t batchBegin, batchEnd;
    std::size_t nodeBegin, nodeEnd;                    // into nodes_
    double marginAtCheck = -1;                         // at the last visit: min of (r - |F - F0|)/γ, m; < 0: visit
    double leverArm = 0;                               // largest |F|/γ then, m
    double rounding = 0;                               // of `before_`, m
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();  // of `before_`, m
    Eigen::Matrix3d motion = Eigen::Matrix3d::Zero();  // A of the common motion since then, as last fitted
    std::int64_t visitedAt = 0;                        // number of the check that visited it last
    bool skipped = true;                               // a check since it last began to skip
    bool tried = false, fitted = false;                // at the last check: its nodes were asked, a motion was fitted
    std::int16_t pause = 0, waits = 0;  // checks without trying to skip after a try in vain; those still to come
  };
  bool canSkip(Group& group, const double* rows);
  double remainingMargin(Group& group, const double* rows);
  void beginSkipping(Group& group, double margin, double leverArm, const double* rows);

  const ElementBlock* block_;
  int points_;
  AlignedVector<std::int16_t> referenceGradient_;             // [batch][q][9][lane], in units
  AlignedVector<RoundedDown<Bfloat16>> radius_;               // [batch][lane]
  AlignedVector<RoundedDown<Bfloat16>> inverseGradientNorm_;  // [batch][lane], 1/γ, m
  std::vector<Group> groups_;
  std::vector<std::int32_t> patchGroups_;  // patches + 1: groups of each patch
  std::vector<std::uint16_t> nodes_;  // of each group, within the patch; filled up to a multiple of 4 with its last
  std::vector<float> before_;         // their positions at the last visit from `centre`, m
  std::int64_t checks_ = 0;
};

}  // namespace ringwatch
