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
/// Most elements are not tested. With
///   x = y + t + A (y - c) + ρ   for any t and A
/// for the nodes of a group of elements, from positions y at an earlier check, each of its deformation gradients has
/// changed since then by at most
///   |ΔF| <= γ C,   C = |A| max |F|/γ + max |ρ - ρ'|,   γ = Σ_a |∂N_a/∂X|
/// (Theorem 19, docs/theory/incremental_certificate.md; the code takes half the diagonal of a box of all ρ). What was
/// left of a batch's balls when it was tested, over γ, is used up by motions C of its patch or, where that would be too
/// much, of the few batches around it: only then it is tested again (Theorem 70). Where elements tremble so much that
/// this costs more than testing all of them, a patch is tested directly for a while. Stored numbers are rounded to the
/// safe side.
class ValidityBalls {
 public:
  /// Reference gradients are stored as multiples of this; entries of F beyond `largestEntry` cannot be stored, and
  /// their elements have no ball.
  static constexpr double entryUnit = 1.0 / 4096, largestEntry = 8 - entryUnit;
  /// How far a stored reference gradient lies from F0, at most.
  static constexpr double storageError = 1.5 * entryUnit;
  /// Elements with less than this fraction of their radius left count as outside: one at the edge of its ball would
  /// be tested at every check.
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

  /// Runs the batches of a patch and appends the elements that have left their balls.
  void checkPatch(const PatchPass& pass, std::vector<std::int32_t>& outside);
  /// Call it for every element that got a new ball, before the next check; distance: of the positions of the last check
  /// from F0, at most.
  void ballChanged(std::size_t place, double distance = storageError);
  /// The next check tests every element: radii have changed other than at the positions of the last check.
  void invalidateAll() {
    for (Motion& motion : motions_) motion.testAll = true;
  }
  /// What the last check took, in WorkAccount's units: it depends on how the groups moved, not on threads.
  double workOfCheck() const;
  /// Batches, and how many of them the last check tested.
  std::size_t batchCount() const { return left_.size(); }
  std::size_t testedBatches() const;

  template <class Archive>
  void archive(Archive& a) {
    a(referenceGradient_, radius_, left_, motions_, clusters_, before_);
  }

 private:
  class BallCheck;
  class DirectCheck;
  /// The motion of a patch since `before_`, which its batches are tested by.
  struct Motion {
    template <class Archive>
    void archive(Archive& a) {
      a(leastLeft, moved, leverArm, testedLeverArm, rounding, centre, rate, checks, checksSinceFit, gapOfFits, tested,
        asked, fitted, clustered, testAll, kept, wasDirect, direct, gapOfDirect, looks, meanWork);
    }

    double leastLeft = 0;                              // of its batches, m
    double moved = 0;                                  // C at the last check, m
    double leverArm = 0;                               // largest |F|/γ at `before_`, at most, m
    double testedLeverArm = 0;                         // the same when all elements were tested last, m
    double rounding = 0;                               // of `before_`, m
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();  // of `before_`, m
    Eigen::Matrix3d rate = Eigen::Matrix3d::Zero();    // A a check, as last fitted
    std::int32_t checks = 0;                           // since `before_`
    std::int32_t checksSinceFit = 0, gapOfFits = 1;
    // At the last check: batches tested, times that nodes were gone through, whether a motion was fitted, clusters were
    // asked, positions kept, and whether it was direct.
    std::int32_t tested = 0, asked = 0;
    bool fitted = false, clustered = false, kept = false, wasDirect = false;
    bool testAll = true;  // at the next one
    // Checks that are still to be direct, and were the last time; others in a row since then, and the work of one of
    // these, on average.
    std::int32_t direct = 0, gapOfDirect = 0, looks = 0;
    double meanWork = 0;
  };
  /// Batches that move together.
  struct Cluster {
    template <class Archive>
    void archive(Archive& a) {
      a(batchBegin, batchEnd, nodeBegin, nodeEnd, moved);
    }

    std::int32_t batchBegin, batchEnd;
    std::size_t nodeBegin, nodeEnd;  // into nodes_
    double moved = 0;                // C at the last check, where clusters were asked, m
  };
  struct Residuals;
  /// C of a patch since `before_`, with A = checks * rate or one that is fitted where C would be too large. NaN or
  /// infinite when a position is not finite.
  double move(Motion& motion, const Patch& patch, const double* rows, Residuals& residuals) const;
  /// Marks the batches of a patch that have nothing left by -1, and decides whether positions are kept: then the others
  /// have less left.
  void moveClusters(Motion& motion, std::int32_t patch, const Residuals& residuals);
  /// Has what a test of the batch reads brought into the cache: few batches of a patch are tested, here and there.
  void prefetch(std::int32_t batch) const;
  /// Appends the elements of a batch that are not inside.
  void addOutside(std::int32_t batch, const NativePack::Mask& inside, std::vector<std::int32_t>& outside) const;
  /// Runs the batches of a patch; those that are marked are tested.
  void testMarked(const Motion& motion, const PatchPass& pass, BallCheck& check) const;
  /// The work of the last check of a patch, and of a direct one.
  double workOf(const Motion& motion, std::size_t patch) const;
  double workOfDirectCheck(const Patch& patch) const;
  /// Has the next checks of a patch be direct, if looking at its nodes has cost more of late.
  void chooseCheck(Motion& motion, std::size_t patch) const;
  /// Keeps the positions at hand as those that motions are from.
  void keepPositions(Motion& motion, const Patch& patch, const double* rows);

  const ElementBlock* block_;
  int points_;
  AlignedVector<std::int16_t> referenceGradient_;             // [batch][q][9][lane], in units
  AlignedVector<RoundedDown<Bfloat16>> radius_;               // [batch][lane]
  AlignedVector<RoundedDown<Bfloat16>> inverseGradientNorm_;  // [batch][lane], 1/γ, m
  // [batch]: least (r - |F - F0|)/γ of its elements at the positions `before_`, at least, m
  std::vector<double> left_;
  std::vector<Motion> motions_;  // [patch]
  std::vector<Cluster> clusters_;
  std::vector<std::int32_t> patchClusters_;  // patches + 1: clusters of each patch
  std::vector<std::uint16_t> nodes_;         // of each cluster, within the patch
  AlignedVector<float> before_;  // positions of the nodes of patches at some check from `centre`, m, in fours
};

}  // namespace ringwatch
