#pragma once
#include <cstdint>
#include <cstring>

#include <ringwatch/base/matrix3.h>
#include <ringwatch/base/pack.h>
#include <ringwatch/base/short_floats.h>

namespace ringwatch {

/// How unevenly groups of batches have moved since a reference state, found by a pass while it computes with the
/// deformation gradients: how far those of the elements, at all quadrature points, lie from G times the reference ones,
/// with one G a group. In single precision, whose rounding is motionRounding times |F| + |G F'| at most.
struct BatchMotion {
  /// What the pass does with a group: it takes G for the identity, has Σ F as well, or takes F' for the identity, and
  /// reads none.
  enum Flags : std::uint8_t { still = 1, summed = 2, rest = 4 };

  const float* motion;               ///< G of each group over the unit of its F', 1 at rest, row by row: [group][9]
  const std::uint8_t* flags;         ///< [group]
  const std::int32_t* groupOfBatch;  ///< [batch]
  const std::int16_t* reference;     ///< F' in units: [batch][point][9][lane]
  float unit;
  std::int64_t points;  ///< of an element
  /// [group][sizeOfGroup], zero before the pass: max |F - G F'|² (Frobenius) of a pack of elements, not finite where an
  /// F is not, and Σ F at their first points, row by row.
  float* measured;

  static constexpr std::ptrdiff_t sizeOfGroup = 10 * nativeWidth;
  static constexpr double motionRounding = 1e-6;

  /// The distances of a batch, point by point.
  class OfBatch {
   public:
    RINGWATCH_INLINE void start(const BatchMotion& motion, std::int32_t batch) {
      const std::int32_t group = motion.groupOfBatch[batch];
      unit_ = motion.unit;
      motion_ = motion.motion + 9 * static_cast<std::ptrdiff_t>(group);
      reference_ = motion.reference + 9 * nativeWidth * (static_cast<std::ptrdiff_t>(batch) * motion.points);
      measured_ = motion.measured + sizeOfGroup * group;
      still_ = (motion.flags[group] & still) != 0;
      rest_ = (motion.flags[group] & rest) != 0;
      sums_ = (motion.flags[group] & summed) != 0;
      farthest2_ = all_ = Floats{};
    }
    RINGWATCH_INLINE void add(const Matrix3<NativePack>& F) {
      Floats here[9], squares[3];
      for (int i = 0; i < 9; ++i) here[i] = detail::singlesOf(F.m[i]);
      if (sums_)
        for (int i = 0; i < 9; ++i) store(load(measured_ + (i + 1) * nativeWidth) + here[i], (i + 1) * nativeWidth);
      sums_ = false;
      if (rest_) {
        for (int i = 0; i < 9; ++i) here[i] -= motion_[i];
      } else if (still_) {
        for (int i = 0; i < 9; ++i) here[i] -= unit_ * reference(i);
      } else {
        for (int column = 0; column < 3; ++column) {
          Floats there[3];
          for (int k = 0; k < 3; ++k) there[k] = reference(3 * k + column);
          for (int row = 0; row < 3; ++row)
            for (int k = 0; k < 3; ++k) here[3 * row + column] -= motion_[3 * row + k] * there[k];
        }
      }
      for (int row = 0; row < 3; ++row)
        squares[row] = here[3 * row] * here[3 * row] + here[3 * row + 1] * here[3 * row + 1] +
                       here[3 * row + 2] * here[3 * row + 2];
      const Floats square = squares[0] + squares[1] + squares[2];
      farthest2_ = farthest2_ > square ? farthest2_ : square;
      all_ += square;
      reference_ += 9 * nativeWidth;
    }
    RINGWATCH_INLINE void finish() const {
      const Floats before = load(measured_);
      // A comparison loses what is not a number; a sum does not.
      const Floats farthest = before > farthest2_ ? before : farthest2_;
      store(farthest + (all_ - all_) + (before - before), 0);
    }

   private:
    using Floats = detail::NativeFloats;
    RINGWATCH_INLINE static Floats load(const float* from) {
      Floats floats;
      std::memcpy(&floats, from, sizeof floats);
      return floats;
    }
    RINGWATCH_INLINE Floats reference(int entry) const {
      return __builtin_convertvector(detail::loadShorts(reference_ + entry * nativeWidth), Floats);
    }
    RINGWATCH_INLINE void store(const Floats& floats, std::ptrdiff_t at) const {
      std::memcpy(measured_ + at, &floats, sizeof floats);
    }

    const float* motion_;
    const std::int16_t* reference_;
    float unit_;
    float* measured_;
    bool still_, rest_, sums_;
    Floats farthest2_, all_;
  };
};

}  // namespace ringwatch
