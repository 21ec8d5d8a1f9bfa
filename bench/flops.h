#pragma once
#include <cstdint>
#include <variant>

#include <ringwatch/base/math.h>
#include <ringwatch/base/matrix3.h>

namespace ringwatch::bench {

/// A number that counts what is done with it: each + - * / square root and logarithm is one operation.
struct Counted {
  double value = 0;
  static inline std::int64_t operations = 0;
  Counted() = default;
  Counted(double v) : value(v) {}
  static Counted counted(double v) {
    ++operations;
    return v;
  }
  friend Counted operator+(Counted a, Counted b) { return counted(a.value + b.value); }
  friend Counted operator-(Counted a, Counted b) { return counted(a.value - b.value); }
  friend Counted operator*(Counted a, Counted b) { return counted(a.value * b.value); }
  friend Counted operator/(Counted a, Counted b) { return counted(a.value / b.value); }
  friend Counted operator-(Counted a) { return -a.value; }
  Counted& operator+=(Counted b) { return *this = *this + b; }
  Counted& operator-=(Counted b) { return *this = *this - b; }
  Counted& operator*=(Counted b) { return *this = *this * b; }
  friend bool operator<(Counted a, Counted b) { return a.value < b.value; }
  friend bool operator>(Counted a, Counted b) { return a.value > b.value; }
  friend bool operator<=(Counted a, Counted b) { return a.value <= b.value; }
  friend bool operator>=(Counted a, Counted b) { return a.value >= b.value; }
};
inline Counted select(bool condition, Counted yes, Counted no) { return condition ? yes : no; }

/// Operations of a call.
template <class Call>
double operationsOf(const Call& call) {
  Counted::operations = 0;
  call();
  return static_cast<double>(Counted::operations);
}

}  // namespace ringwatch::bench

namespace ringwatch::math {
inline bench::Counted sqrt(bench::Counted a) { return bench::Counted::counted(::sqrt(a.value)); }
inline bench::Counted log(bench::Counted a) { return bench::Counted::counted(::log(a.value)); }
inline bench::Counted abs(bench::Counted a) { return ::fabs(a.value); }
inline bench::Counted max(bench::Counted a, bench::Counted b) { return a.value > b.value ? a : b; }
inline bench::Counted min(bench::Counted a, bench::Counted b) { return a.value < b.value ? a : b; }
}  // namespace ringwatch::math
