#pragma once
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace ringwatch {

/// A sum of doubles without rounding: an integer of 2176 bits in units of 2⁻¹⁰⁷⁴, the least double, as Kulisch 2013
/// has it. Any order of the terms, and any cut of them into partial sums, gives the same sum and the same double.
class ExactSum {
 public:
  /// Digits to the base 2³²; the last one has the sign. Digits of several sums may be added one by one.
  static constexpr std::size_t digitCount = 68;
  using Digits = std::array<std::int64_t, digitCount>;

  /// Adds a term. Terms that are not finite make value() not a number.
  void add(double term) {
    const auto bits = std::bit_cast<std::uint64_t>(term);
    const auto exponent = static_cast<unsigned>((bits >> 52) & 0x7ff);
    if (exponent == 0x7ff) {
      ++notFinite_;
      return;
    }
    const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
    const std::uint64_t mantissa = exponent == 0 ? fraction : fraction | (std::uint64_t{1} << 52);
    const unsigned shift = exponent == 0 ? 0 : exponent - 1;  // term = ± mantissa 2^(shift - 1074)
    const std::size_t digit = shift / 32;
    const unsigned within = shift % 32;
    const std::uint64_t low = (mantissa & mask) << within, high = (mantissa >> 32) << within;
    const auto first = static_cast<std::int64_t>(low & mask),
               second = static_cast<std::int64_t>((low >> 32) + (high & mask)),
               third = static_cast<std::int64_t>(high >> 32);
    const std::int64_t sign = term < 0 ? -1 : 1;
    digits_[digit] += sign * first;
    digits_[digit + 1] += sign * second;
    digits_[digit + 2] += sign * third;
    if (++terms_ == termsBetweenCarries) carry();
  }
  /// The digits, each below 2³² but for the last one, and how many terms were not finite: what another sum can take
  /// with addDigits.
  const Digits& digits() {
    carry();
    return digits_;
  }
  std::int64_t notFinite() const { return notFinite_; }
  /// Adds the digits of other sums, up to 2³⁰ of them added one by one.
  void addDigits(const std::int64_t* digits, std::int64_t notFinite) {
    carry();
    for (std::size_t i = 0; i < digitCount; ++i) digits_[i] += digits[i];
    notFinite_ += notFinite;
    carry();
  }
  /// The sum, rounded to the nearest double, ties to even.
  double value() {
    if (notFinite_ > 0) return std::numeric_limits<double>::quiet_NaN();
    carry();
    Digits size = digits_;
    const bool negative = size.back() < 0;
    if (negative) {
      for (std::int64_t& digit : size) digit = -digit;
      carry(size);
    }
    std::size_t top = digitCount;
    while (top > 0 && size[top - 1] == 0) --top;
    if (top == 0) return 0;
    // Three digits hold at least 65 bits: what lies below them only tells whether a tie is one.
    const auto at = [&](std::size_t below) {
      return top > below ? static_cast<std::uint64_t>(size[top - 1 - below]) : std::uint64_t{0};
    };
    bool sticky = false;
    for (std::size_t i = 0; i + 3 < top; ++i) sticky |= size[i] != 0;
    // 96 bits to 64, the lowest one sticky; 64 are more than 53 + 2, so that nothing is rounded twice.
    const int shift = 32 - std::countl_zero(static_cast<std::uint32_t>(at(0)));
    const std::uint64_t upper = (at(0) << 32) | at(1), lower = at(2);
    std::uint64_t mantissa = shift == 32 ? upper : (upper << (32 - shift)) | (lower >> shift);
    const std::uint64_t lost = lower & ((std::uint64_t{1} << shift) - 1);
    if (sticky || lost != 0) mantissa |= 1;
    const int exponent = 32 * (static_cast<int>(top) - 3) + shift - 1074;
    const double rounded = std::ldexp(static_cast<double>(mantissa), exponent);
    return negative ? -rounded : rounded;
  }

 private:
  static constexpr std::uint64_t mask = 0xffffffff;
  /// A term adds less than 2³³ to a digit of 64 bits.
  static constexpr std::int64_t termsBetweenCarries = std::int64_t{1} << 29;

  static void carry(Digits& digits) {
    for (std::size_t i = 0; i + 1 < digitCount; ++i) {
      digits[i + 1] += digits[i] >> 32;  // towards minus infinity
      digits[i] &= static_cast<std::int64_t>(mask);
    }
  }
  void carry() {
    carry(digits_);
    terms_ = 0;
  }

  Digits digits_{};
  std::int64_t terms_ = 0, notFinite_ = 0;
};

}  // namespace ringwatch
