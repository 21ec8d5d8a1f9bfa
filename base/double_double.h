#pragma once
#include <cmath>

#include <ringwatch/base/math.h>

namespace ringwatch {

namespace detail {
RINGWATCH_INLINE double fusedProduct(double a, double b, double c) { return std::fma(a, b, c); }
template <class P>
RINGWATCH_INLINE P fusedProduct(const P& a, const P& b, const P& c) {
  P r;
  for (int lane = 0; lane < P::width; ++lane) r.set(lane, std::fma(a[lane], b[lane], c[lane]));
  return r;
}
}  // namespace detail

/// A kernel scalar of about 106 bits: the unevaluated sum of two numbers S (double, or a pack of them). Sums and
/// products err by at most 8 u² of the sum of the sizes of their terms, quotients by 16 u² (Joldes, Muller & Popescu
/// 2017). For what is computed once and then used often, such as inverse Jacobians.
template <class S>
struct DoubleDouble {
  S high, low;

  DoubleDouble() = default;
  RINGWATCH_INLINE explicit DoubleDouble(double number) : high(number), low(0.0) {}
  RINGWATCH_INLINE DoubleDouble(const S& first, const S& second) : high(first), low(second) {}
  /// a + b, exactly.
  RINGWATCH_INLINE static DoubleDouble sum(const S& a, const S& b) {
    const S s = a + b, t = s - a;
    return {s, (a - (s - t)) + (b - t)};
  }
  /// a b, exactly.
  RINGWATCH_INLINE static DoubleDouble product(const S& a, const S& b) {
    const S p = a * b;
    return {p, detail::fusedProduct(a, b, -p)};
  }
  /// The nearest S.
  RINGWATCH_INLINE S rounded() const { return high + low; }

  RINGWATCH_INLINE friend DoubleDouble operator-(const DoubleDouble& a) { return {-a.high, -a.low}; }
  RINGWATCH_INLINE friend DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
    const DoubleDouble s = sum(a.high, b.high), t = sum(a.low, b.low);
    const DoubleDouble v = quickSum(s.high, s.low + t.high);
    return quickSum(v.high, t.low + v.low);
  }
  RINGWATCH_INLINE friend DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) { return a + -b; }
  RINGWATCH_INLINE friend DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
    const DoubleDouble p = product(a.high, b.high);
    return quickSum(p.high, p.low + (a.high * b.low + a.low * b.high));
  }
  RINGWATCH_INLINE friend DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
    // Two digits of the quotient, the second from the remainder.
    const S first = a.high / b.high;
    const DoubleDouble rest = a - b * DoubleDouble(first, S(0.0));
    return quickSum(first, rest.high / b.high);
  }
  RINGWATCH_INLINE DoubleDouble& operator+=(const DoubleDouble& b) { return *this = *this + b; }

 private:
  /// a + b, exactly, for |a| >= |b|.
  RINGWATCH_INLINE static DoubleDouble quickSum(const S& a, const S& b) {
    const S s = a + b;
    return {s, b - (s - a)};
  }
};

}  // namespace ringwatch
