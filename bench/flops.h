#pragma once
#include <cmath>
#include <cstdint>
#include <variant>

#include <ringwatch/base/math.h>
#include <ringwatch/base/matrix3.h>

namespace ringwatch::bench {

inline std::int64_t countedOperations = 0;

/// A number that counts what is done with it: each + - * / square root and logarithm is one operation. T as a kernel
/// may iterate until T's rounding.
template <class T>
struct CountedAs {
  T value = 0;
  CountedAs() = default;
  CountedAs(T v) : value(v) {}
  static CountedAs counted(T v) {
    ++countedOperations;
    return v;
  }
  friend CountedAs operator+(CountedAs a, CountedAs b) { return counted(a.value + b.value); }
  friend CountedAs operator-(CountedAs a, CountedAs b) { return counted(a.value - b.value); }
  friend CountedAs operator*(CountedAs a, CountedAs b) { return counted(a.value * b.value); }
  friend CountedAs operator/(CountedAs a, CountedAs b) { return counted(a.value / b.value); }
  friend CountedAs operator-(CountedAs a) { return -a.value; }
  CountedAs& operator+=(CountedAs b) { return *this = *this + b; }
  CountedAs& operator-=(CountedAs b) { return *this = *this - b; }
  CountedAs& operator*=(CountedAs b) { return *this = *this * b; }
  friend bool operator<(CountedAs a, CountedAs b) { return a.value < b.value; }
  friend bool operator>(CountedAs a, CountedAs b) { return a.value > b.value; }
  friend bool operator<=(CountedAs a, CountedAs b) { return a.value <= b.value; }
  friend bool operator>=(CountedAs a, CountedAs b) { return a.value >= b.value; }
};
using Counted = CountedAs<double>;
template <class T>
CountedAs<T> select(bool condition, CountedAs<T> yes, CountedAs<T> no) {
  return condition ? yes : no;
}

/// Operations of a call.
template <class Call>
double operationsOf(const Call& call) {
  countedOperations = 0;
  call();
  return static_cast<double>(countedOperations);
}

}  // namespace ringwatch::bench

namespace ringwatch::math {
template <class T>
bench::CountedAs<T> sqrt(bench::CountedAs<T> a) {
  return bench::CountedAs<T>::counted(std::sqrt(a.value));
}
template <class T>
bench::CountedAs<T> log(bench::CountedAs<T> a) {
  return bench::CountedAs<T>::counted(std::log(a.value));
}
template <class T>
bench::CountedAs<T> cbrt(bench::CountedAs<T> a) {
  return bench::CountedAs<T>::counted(std::cbrt(a.value));
}
template <class T>
bench::CountedAs<T> abs(bench::CountedAs<T> a) {
  return std::fabs(a.value);
}
template <class T>
bench::CountedAs<T> max(bench::CountedAs<T> a, bench::CountedAs<T> b) {
  return a.value > b.value ? a : b;
}
template <class T>
bench::CountedAs<T> min(bench::CountedAs<T> a, bench::CountedAs<T> b) {
  return a.value < b.value ? a : b;
}
}  // namespace ringwatch::math
