#pragma once
#include <ringwatch/base/math.h>

namespace ringwatch {

/// a + b·ε with ε² = 0: carries a first derivative through any kernel exactly (forward automatic differentiation).
struct Dual {
  double value = 0;
  double derivative = 0;
  constexpr Dual() = default;
  constexpr Dual(double v, double d = 0) : value(v), derivative(d) {}

  friend Dual operator+(Dual a, Dual b) { return {a.value + b.value, a.derivative + b.derivative}; }
  friend Dual operator-(Dual a, Dual b) { return {a.value - b.value, a.derivative - b.derivative}; }
  friend Dual operator*(Dual a, Dual b) { return {a.value * b.value, a.value * b.derivative + a.derivative * b.value}; }
  friend Dual operator/(Dual a, Dual b) {
    const double q = a.value / b.value;
    return {q, (a.derivative - q * b.derivative) / b.value};
  }
  friend Dual operator-(Dual a) { return {-a.value, -a.derivative}; }
  Dual& operator+=(Dual b) { return *this = *this + b; }
  Dual& operator-=(Dual b) { return *this = *this - b; }
  Dual& operator*=(Dual b) { return *this = *this * b; }
  friend bool operator<(Dual a, Dual b) { return a.value < b.value; }
  friend bool operator>(Dual a, Dual b) { return a.value > b.value; }
  friend bool operator<=(Dual a, Dual b) { return a.value <= b.value; }
  friend bool operator>=(Dual a, Dual b) { return a.value >= b.value; }
};

inline Dual select(bool condition, Dual yes, Dual no) { return condition ? yes : no; }

namespace math {
inline Dual sqrt(Dual a) {
  const double r = ::sqrt(a.value);
  return {r, a.derivative / (2 * r)};
}
inline Dual log(Dual a) { return {::log(a.value), a.derivative / a.value}; }
inline Dual cbrt(Dual a) {
  const double r = ::cbrt(a.value);
  return {r, a.derivative / (3 * r * r)};
}
inline Dual abs(Dual a) { return a.value < 0 ? -a : a; }
inline Dual max(Dual a, Dual b) { return a.value > b.value ? a : b; }
inline Dual min(Dual a, Dual b) { return a.value < b.value ? a : b; }
}  // namespace math

}  // namespace ringwatch
