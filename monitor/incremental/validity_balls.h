#pragma once
#include <cstdint>
#include <vector>

#include <ringwatch/base/aligned.h>
#include <ringwatch/base/short_floats.h>
#include <ringwatch/body/element_block.h>

namespace ringwatch {

/// Finds the elements of a block that have left their validity balls |F - F0| <= r, F0 the reference gradient at which
/// an element was last evaluated. Norms are Frobenius norms.
///
/// The elements of a batch lie close together and have moved alike. So a check compares all their deformation gradients
/// with one matrix C, the centre of the batch: while |F - C| <= s, with s <= r - |F0 - C|, an element is in its ball
/// (Theorem 19, docs/theory/incremental_certificate.md). That is done where the force is computed, and hardly reads
/// memory. A batch of which an element is not inside by that is compared with the balls themselves, and gets another
/// centre; where none serves, its elements are compared with their own gradients for a while. So the elements that are
/// found are those outside their balls, whatever the centres.
class ValidityBalls {
 public:
  /// Reference gradients are stored as multiples of this; entries of F beyond `largestEntry` cannot be stored, and
  /// their elements have no ball.
  static constexpr double entryUnit = 1.0 / 4096, largestEntry = 8 - entryUnit;
  /// How far a stored reference gradient lies from F0, at most.
  static constexpr double storageError = 1.5 * entryUnit;

  /// Every element counts as outside until it has a ball.
  explicit ValidityBalls(const ElementBlock& block);

  /// Stores gradients F[(q * 9 + i) * lanes + lane] of a batch at `to`, [q][9][lane], and returns how far what is
  /// stored lies from them, at most, of each lane; infinity where they cannot be stored.
  static NativePack storeGradients(const double* F, int points, std::int16_t* to);
  /// The same for reference gradients of a batch. The radii have to be set after it.
  NativePack setReferenceGradients(std::int32_t batch, const double* F0);
  /// Sets the radii of a batch about the stored gradients; < 0: always outside. Those that are never outside stay so.
  void fitRadii(std::int32_t batch, NativePack radii);
  /// Stores F0 of the element at `place` (batch * lanes + lane): F0[(q * 9 + i) * lanes + lane]. Returns how far the
  /// stored gradient lies from it, at most; infinity when it cannot be stored. The radius has to be set after it.
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

  /// Runs the batches of a patch and appends the elements that are outside their balls.
  void checkPatch(const PatchPass& pass, std::vector<std::int32_t>& outside);
  /// What the last check took, in WorkAccount's units: it depends on how the elements moved, not on threads.
  double workOfCheck() const;
  /// Batches, and how many of them the last check compared with the balls themselves, or will the next one.
  std::size_t batchCount() const { return radius_.size() / lanes; }
  std::size_t testedBatches() const;

  template <class Archive>
  void archive(Archive& a) {
    a(referenceGradient_, radius_, centre_, diagonal_, squareAroundCentre_, byOwn_);
  }

 private:
  class BallCheck;
  const std::int16_t* referenceOf(std::int32_t batch) const {
    return referenceGradient_.data() + static_cast<std::ptrdiff_t>(batch) * points_ * 9 * lanes;
  }
  double squareOfCentre(std::size_t batch) const {
    return centre_[BatchBalls::centreSize * batch + BatchBalls::placeOfSquare];
  }
  /// As a pass compares with them.
  BatchBalls balls() {
    return {centre_.data(),
            diagonal_.data(),
            squareAroundCentre_.data(),
            byOwn_.data(),
            referenceGradient_.data(),
            entryUnit,
            radius_.data(),
            left_.data()};
  }
  /// The square of how far entry(q, i) lies from the stored gradients of an element, at the point where that is most.
  template <class Entry>
  double squareOfDistance(std::size_t place, const Entry& entry) const;
  /// The square about the centre that the batch has, of an element with a new reference gradient; < 0: there is none.
  double squareAround(std::size_t place, double radius) const;
  /// Gives the batch the mean of the gradients of the elements `of` as its centre, those with small balls first.
  /// Whether these are inside by it.
  bool moveCentre(std::int32_t batch, const double* F, const NativePack::Mask& of);
  /// The same for a centre that is given.
  bool setCentre(std::int32_t batch, const double (&centre)[9], bool diagonal, const double* F,
                 const NativePack::Mask& of);

  const ElementBlock* block_;
  int points_;
  AlignedVector<std::int16_t> referenceGradient_;  // [batch][q][9][lane], in units
  AlignedVector<RoundedDown<Bfloat16>> radius_;    // [batch][lane]
  std::vector<double> centre_;                     // [batch], as BatchBalls has it
  std::vector<std::uint8_t> diagonal_;             // the same
  /// s² of the elements, [batch][lane]; < 0: there is none.
  AlignedVector<RoundedDown<Bfloat16>> squareAroundCentre_;
  // [batch]: checks in which its elements are still compared with their own gradients, before its centre is moved again
  std::vector<std::uint8_t> byOwn_;
  std::vector<std::uint8_t> left_;  // [batch]: whether the last check looked at it again
};

}  // namespace ringwatch
