#pragma once
#include <cstdint>

#include <ringwatch/base/matrix3.h>
#include <ringwatch/base/pack.h>
#include <ringwatch/base/rounding.h>
#include <ringwatch/base/short_floats.h>

namespace ringwatch {

/// Balls with which a pass compares deformation gradients while it computes with them: |F - C| <= s at all quadrature
/// points of an element, in the Frobenius norm. The elements of a batch have one C, or each a C of its own at every
/// point.
struct BatchBalls {
  const double* centre;                 ///< C of each batch, row by row, and |C|²: [batch][centreSize]
  const std::uint8_t* diagonal;         ///< [batch]: not zero where C has no entry beside its diagonal
  const RoundedDown<Bfloat16>* square;  ///< s² of each element about it, [batch][lane]; < 0: nothing is inside
  const std::uint8_t* byOwn;            ///< [batch]: not zero where elements have a C each
  const std::int16_t* ownCentre;        ///< these, [batch][point][9][lane], as multiples of
  double unit;
  const RoundedDown<Bfloat16>* ownRadius;  ///< s about them, [batch][lane]
  std::uint8_t* left;                      ///< [batch]: becomes whether an element of it is not inside

  static constexpr std::ptrdiff_t centreSize = 10, placeOfSquare = 9;  // |C|² stands behind C
  static constexpr double dimensions = 3;                              // tr I

  /// The comparison for a batch, point by point; what is not a number is not inside.
  class OfBatch {
   public:
    RINGWATCH_INLINE void start(const BatchBalls& balls, std::int32_t batch, int points) {
      start(balls, batch, points, balls.byOwn[batch] != 0);
    }
    RINGWATCH_INLINE void start(const BatchBalls& balls, std::int32_t batch, int points, bool byOwn) {
      const std::ptrdiff_t first = batch;
      centre_ = balls.centre + centreSize * first;
      diagonal_ = balls.diagonal[batch] != 0;
      own_ = byOwn ? balls.ownCentre + 9 * nativeWidth * first * points : nullptr;
      unit_ = balls.unit;
      if (byOwn) {
        const NativePack radius =
            NativePack(1 - ballRounding) * RoundedDown<Bfloat16>::load(balls.ownRadius + first * nativeWidth);
        square_ = radius * math::abs(radius);
      } else {
        square_ = RoundedDown<Bfloat16>::load(balls.square + first * nativeWidth);
        room_ = NativePack(0.5) * (square_ - NativePack(centre_[placeOfSquare] + dimensions));
      }
      inside_ = square_ >= NativePack(0.0);
    }
    RINGWATCH_INLINE void add(const Matrix3<NativePack>& F) {
      NativePack sums[3] = {NativePack(0.0), NativePack(0.0), NativePack(0.0)};
      if (own_) {
        for (int i = 0; i < 9; ++i, own_ += nativeWidth)
          addSquare(F.m[i] - NativePack(unit_) * detail::packOf(detail::loadShorts(own_)), sums[i % 3]);
      } else {
        for (int i = 0; i < 9; ++i) addSquare(F.m[i] - NativePack(centre_[i]), sums[i % 3]);
      }
      inside_ = inside_ & (sums[0] + sums[1] + sums[2] <= square_);
    }
    /// The same in half the operations where tr E = (|F|² - 3)/2 is known, in a sixth where C is diagonal:
    /// |F - C|² <= s² as tr E - C:F <= (s² - |C|² - 3)/2.
    RINGWATCH_INLINE void add(const Matrix3<NativePack>& F, const NativePack& traceOfStrain) {
      if (own_) return add(F);
      NativePack sums[3] = {traceOfStrain, NativePack(0.0), NativePack(0.0)};
      for (int i = 0; i < 9; i += 4) sums[i / 4] -= F.m[i] * NativePack(centre_[i]);
      if (!diagonal_)
        for (int i = 0; i < 9; ++i)
          if (i % 4 != 0) sums[i % 3] -= F.m[i] * NativePack(centre_[i]);
      inside_ = inside_ & (sums[0] + sums[1] + sums[2] <= room_);
    }
    RINGWATCH_INLINE NativePack::Mask inside() const { return inside_; }
    RINGWATCH_INLINE bool left() const { return !allOf(inside_); }

   private:
    RINGWATCH_INLINE static void addSquare(const NativePack& d, NativePack& sum) { sum += d * d; }

    const double* centre_;
    const std::int16_t* own_;
    double unit_;
    bool diagonal_;
    NativePack square_, room_;  // room_: (s² - |C|² - 3)/2
    NativePack::Mask inside_;
  };
};

}  // namespace ringwatch
