#pragma once
#include <cstdint>
#include <limits>

#include <ringwatch/base/matrix3.h>
#include <ringwatch/base/pack.h>

namespace ringwatch {

/// How unevenly groups of batches have moved, found by a pass while it computes with the deformation gradients: how far
/// those of each batch's elements, at all quadrature points, lie from the centre of its group, and their sum.
struct BatchMotion {
  const double* centre;              ///< C of each group, row by row, and |C|²: [group][centreSize]
  const std::int32_t* groupOfBatch;  ///< [batch]
  double* farthest2;                 ///< [batch][lane]: becomes max |F - C|², Frobenius; not finite where an F is not
  const std::uint8_t* wantsSum;      ///< [batch]: not zero where the sum is wanted
  double* sum;                       ///< of F, of a pack of elements, row by row: [batch][9][lane]

  static constexpr std::ptrdiff_t centreSize = 10, placeOfSquare = 9;
  static constexpr double dimensions = 3;  // tr I

  /// The distances of a batch, point by point.
  class OfBatch {
   public:
    RINGWATCH_INLINE void start(const BatchMotion& motion, std::int32_t batch) {
      centre_ = motion.centre + centreSize * motion.groupOfBatch[batch];
      total_ =
          motion.wantsSum[batch] != 0 ? motion.sum + static_cast<std::ptrdiff_t>(batch) * 9 * nativeWidth : nullptr;
      if (total_)
        for (int i = 0; i < 9; ++i) NativePack(0.0).store(total_ + i * nativeWidth);
    }
    RINGWATCH_INLINE void add(const Matrix3<NativePack>& F) {
      addSum(F);
      NativePack sums[3] = {NativePack(0.0), NativePack(0.0), NativePack(0.0)};
      for (int i = 0; i < 9; ++i) {
        const NativePack d = F.m[i] - NativePack(centre_[i]);
        sums[i % 3] += d * d;
      }
      note(sums[0] + sums[1] + sums[2]);
    }
    /// The same in half the operations where tr E = (|F|² - 3)/2 is known: |F - C|² = 2 (tr E - C:F) + |C|² + 3.
    RINGWATCH_INLINE void add(const Matrix3<NativePack>& F, const NativePack& traceOfStrain) {
      addSum(F);
      NativePack sums[3] = {traceOfStrain, NativePack(0.0), NativePack(0.0)};
      for (int i = 0; i < 9; ++i) sums[i % 3] -= F.m[i] * NativePack(centre_[i]);
      note(NativePack(2.0) * (sums[0] + sums[1] + sums[2]) + NativePack(centre_[placeOfSquare] + dimensions));
    }
    RINGWATCH_INLINE void finish(const BatchMotion& motion, std::int32_t batch) const {
      // A comparison loses what is not a number; a sum does not.
      const NativePack infinity(std::numeric_limits<double>::infinity());
      select(all_ < infinity, farthest2_, all_)
          .store(motion.farthest2 + static_cast<std::ptrdiff_t>(batch) * nativeWidth);
    }

   private:
    RINGWATCH_INLINE void addSum(const Matrix3<NativePack>& F) const {
      if (!total_) return;
      for (int i = 0; i < 9; ++i) (NativePack::load(total_ + i * nativeWidth) + F.m[i]).store(total_ + i * nativeWidth);
    }
    RINGWATCH_INLINE void note(const NativePack& square) {
      farthest2_ = math::max(farthest2_, square);
      all_ += square;
    }

    const double* centre_;
    double* total_;
    NativePack farthest2_ = NativePack(0.0), all_ = NativePack(0.0);
  };
};

}  // namespace ringwatch
