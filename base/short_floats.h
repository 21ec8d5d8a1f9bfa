#pragma once
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#include <ringwatch/base/pack.h>

/// Numbers of fewer bits in memory, for what need not be known better, and rounding to a side.
namespace ringwatch {

namespace detail {
typedef std::int16_t NativeShorts __attribute__((vector_size(nativeWidth * sizeof(std::int16_t))));
typedef std::int32_t NativeIntegers __attribute__((vector_size(nativeWidth * sizeof(std::int32_t))));
typedef float NativeFloats __attribute__((vector_size(nativeWidth * sizeof(float))));

template <class To, class From>
RINGWATCH_INLINE To bitCast(const From& from) {
  static_assert(sizeof(To) == sizeof(From));
  To to;
  std::memcpy(&to, &from, sizeof to);
  return to;
}
// GCC 12 takes conversions between registers of 512 bits and smaller ones apart into halves, at three times the cost.
#if defined(__AVX512F__)
RINGWATCH_INLINE NativeIntegers loadShorts(const void* from) {
  return bitCast<NativeIntegers>(_mm256_cvtepi16_epi32(_mm_loadu_si128(static_cast<const __m128i*>(from))));
}
RINGWATCH_INLINE NativePack packOf(NativeIntegers values) {
  return NativePack(bitCast<NativePack::Values>(_mm512_cvtepi32_pd(bitCast<__m256i>(values))));
}
RINGWATCH_INLINE NativePack packOf(NativeFloats values) {
  return NativePack(bitCast<NativePack::Values>(_mm512_cvtps_pd(bitCast<__m256>(values))));
}
RINGWATCH_INLINE NativeFloats singlesOf(NativePack values) {
  return bitCast<NativeFloats>(_mm512_cvtpd_ps(bitCast<__m512d>(values.v)));
}
#else
RINGWATCH_INLINE NativeIntegers loadShorts(const void* from) {
  NativeShorts shorts;
  std::memcpy(&shorts, from, sizeof shorts);
  return __builtin_convertvector(shorts, NativeIntegers);
}
RINGWATCH_INLINE NativePack packOf(NativeIntegers values) {
  return NativePack(__builtin_convertvector(values, NativePack::Values));
}
RINGWATCH_INLINE NativePack packOf(NativeFloats values) {
  return NativePack(__builtin_convertvector(values, NativePack::Values));
}
RINGWATCH_INLINE NativeFloats singlesOf(NativePack values) { return __builtin_convertvector(values.v, NativeFloats); }
#endif

/// Single precision at or below numbers that are not negative, by up to 2⁻²¹ of themselves; zero for what is not a
/// number or too small for all the bits of single precision.
RINGWATCH_INLINE NativeFloats belowInSingle(NativePack values) {
  const NativePack below = select(values >= NativePack(1e-37), values * NativePack(1 - 0x1p-22), NativePack(0.0));
  return singlesOf(below);
}
/// The negatives of numbers at or above those that are given, none of them negative; NaN and infinity stay.
RINGWATCH_INLINE NativeFloats negativesOfAbove(NativePack values) {
  const NativePack above =
      select(values <= NativePack(0.0), values, values * NativePack(1 + 0x1p-22) + NativePack(1e-37));
  return singlesOf(-above);
}

/// Single precision at or below a number; NaN stays.
inline float singleAtOrBelow(double number) {
  const auto near = static_cast<float>(number);
  if (!(static_cast<double>(near) > number)) return near;
  // The next one below, as std::nextafter has it, which is a call into the library.
  constexpr std::uint32_t leastNegative = 0x80000001U;
  const auto bits = bitCast<std::uint32_t>(near);
  return bitCast<float>(near > 0 ? bits - 1 : near < 0 ? bits + 1 : leastNegative);
}
}  // namespace detail

/// A number between -1 and 1 by the root of its size, as a multiple of 1/32767: off by at most 3.1e-5 √|number|, so
/// that small ones are known better than by equal steps. Larger ones become ±1, what is not finite zero.
class ShortRoot {
 public:
  ShortRoot() = default;
  explicit ShortRoot(double value) : root_(static_cast<std::int16_t>(rounded(value))) {}
  operator double() const { return unit * static_cast<double>(root_ * std::abs(root_)); }

  static NativePack load(const ShortRoot* from) {
    const detail::NativeIntegers roots = detail::loadShorts(from);
    const detail::NativeIntegers squares = roots * (roots < 0 ? -roots : roots);
    return NativePack(unit) * detail::packOf(squares);
  }
  static void store(NativePack values, ShortRoot* to) {
    const auto shorts = __builtin_convertvector(__builtin_convertvector(rounded(values).v, detail::NativeIntegers),
                                                detail::NativeShorts);
    std::memcpy(static_cast<void*>(to), &shorts, sizeof shorts);
  }

 private:
  static constexpr double most = 32767, unit = 1 / (most * most);
  /// The signed root of a value in units, such that cutting off what follows the point rounds it to the nearest.
  template <class S>
  RINGWATCH_INLINE static S rounded(S value) {
    const S size = math::abs(value), root = S(most) * math::sqrt(math::min(size, S(1.0))) + S(0.5);
    return select(size < S(std::numeric_limits<double>::infinity()), select(value < S(0.0), -root, root), S(0.0));
  }
  std::int16_t root_ = 0;
};

/// The upper half of a single-precision number: its range, 8 significant bits. Rounded to a side of the caller's, which
/// costs up to 0.8 %.
class Bfloat16 {
 public:
  Bfloat16() = default;
  /// down: at or below the number, up: at or above it; NaN stays.
  static Bfloat16 down(double value) {
    const float at = detail::singleAtOrBelow(value);
    Bfloat16 result;
    auto bits = detail::bitCast<std::uint32_t>(at);
    if (at < 0) bits += 0xffffU;  // away from zero
    result.bits_ = static_cast<std::uint16_t>(bits >> 16);
    return result;
  }
  static Bfloat16 up(double value) {
    Bfloat16 result = down(-value);
    result.bits_ ^= 0x8000U;
    return result;
  }
  operator double() const { return static_cast<double>(detail::bitCast<float>(std::uint32_t{bits_} << 16)); }

  static NativePack load(const Bfloat16* from) {
    return detail::packOf(detail::bitCast<detail::NativeFloats>(detail::loadShorts(from) << 16));
  }

 private:
  std::uint16_t bits_ = 0;
};

/// Rounds a double to a type of fewer bits, at or below it; NaN stays. A type that has it can be stored as RoundedDown
/// and RoundedUp.
template <class T>
struct RoundingDown;
template <>
struct RoundingDown<float> {
  static float of(double number) { return detail::singleAtOrBelow(number); }
  static NativePack load(const float* from) {
    detail::NativeFloats values;
    std::memcpy(&values, from, sizeof values);
    return detail::packOf(values);
  }
  /// Of numbers that are not negative.
  static void store(NativePack values, float* to) {
    const detail::NativeFloats below = detail::belowInSingle(values);
    std::memcpy(to, &below, sizeof below);
  }
  static void storeNegative(NativePack values, float* to) {
    const detail::NativeFloats negative = detail::negativesOfAbove(values);
    std::memcpy(to, &negative, sizeof negative);
  }
};
template <>
struct RoundingDown<Bfloat16> {
  static Bfloat16 of(double number) { return Bfloat16::down(number); }
  static NativePack load(const Bfloat16* from) { return Bfloat16::load(from); }
  /// Of numbers that are not negative.
  static void store(NativePack values, Bfloat16* to) {
    typedef std::uint16_t Halves __attribute__((vector_size(nativeWidth * sizeof(std::uint16_t))));
    typedef std::uint32_t Bits __attribute__((vector_size(nativeWidth * sizeof(std::uint32_t))));
    const auto upper = __builtin_convertvector(detail::bitCast<Bits>(detail::belowInSingle(values)) >> 16, Halves);
    static_assert(sizeof upper == nativeWidth * sizeof(Bfloat16));
    std::memcpy(static_cast<void*>(to), &upper, sizeof upper);
  }
  static void storeNegative(NativePack values, Bfloat16* to) {
    typedef std::uint16_t Halves __attribute__((vector_size(nativeWidth * sizeof(std::uint16_t))));
    typedef std::uint32_t Bits __attribute__((vector_size(nativeWidth * sizeof(std::uint32_t))));
    const auto bits = detail::bitCast<Bits>(detail::negativesOfAbove(values));
    // Away from zero, but for what is not a number or infinite.
    const auto finite = (bits & 0x7f800000U) != 0x7f800000U;
    const auto upper = __builtin_convertvector((bits + (Bits(finite) & 0xffffU)) >> 16, Halves);
    std::memcpy(static_cast<void*>(to), &upper, sizeof upper);
  }
};

/// A number in memory as a T at or below the number that it is made of: for what a proof may underestimate, as an
/// element's allowance or the radius of its validity ball.
template <class T>
class RoundedDown {
 public:
  RoundedDown() = default;
  RoundedDown(double number) : stored_(RoundingDown<T>::of(number)) {}
  operator double() const { return static_cast<double>(stored_); }
  /// A pack of numbers that lie one beside another.
  static NativePack load(const RoundedDown* from) {
    static_assert(sizeof(RoundedDown) == sizeof(T));
    return RoundingDown<T>::load(reinterpret_cast<const T*>(from));
  }
  /// Stores such a pack, none of them negative.
  static void store(NativePack numbers, RoundedDown* to) {
    static_assert(sizeof(RoundedDown) == sizeof(T));
    RoundingDown<T>::store(numbers, reinterpret_cast<T*>(to));
  }
  template <class Archive>
  void archive(Archive& a) {
    a(stored_);
  }

 private:
  T stored_{};
};

/// A number in memory as a T at or above the number that it is made of: for what a proof may overestimate, as an
/// element's highest eigenvalue.
template <class T>
class RoundedUp {
 public:
  RoundedUp() = default;
  RoundedUp(double number) : negative_(-number) {}
  operator double() const { return -static_cast<double>(negative_); }
  /// A pack of numbers that lie one beside another.
  static NativePack load(const RoundedUp* from) { return -RoundedDown<T>::load(&from->negative_); }
  /// Stores such a pack, none of them negative.
  static void store(NativePack numbers, RoundedUp* to) {
    static_assert(sizeof(RoundedUp) == sizeof(T));
    RoundingDown<T>::storeNegative(numbers, reinterpret_cast<T*>(to));
  }
  template <class Archive>
  void archive(Archive& a) {
    a(negative_);
  }

 private:
  RoundedDown<T> negative_;
};

}  // namespace ringwatch
