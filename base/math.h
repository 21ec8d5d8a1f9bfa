#pragma once
#include <algorithm>
#include <cmath>

#include <ringwatch/base/host_device.h>

// What is compiled from headers would prove nothing. The first four are those of GCC and Clang for all of it and its
// parts.
#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__) || \
    defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__)
#error "ringwatch: -ffast-math, or a part of it, voids tests for NaN and proven bounds; compile without it"
#endif

/// The operations that a kernel may use besides + - * /, for plain floating-point numbers. `Pack` and `Dual` offer the
/// same names, so that one kernel source serves all of them. Kernels never branch on data: they `select`.
namespace ringwatch {

RINGWATCH_INLINE double select(bool condition, double yes, double no) { return condition ? yes : no; }
RINGWATCH_INLINE float select(bool condition, float yes, float no) { return condition ? yes : no; }
RINGWATCH_INLINE bool anyOf(bool mask) { return mask; }
RINGWATCH_INLINE bool allOf(bool mask) { return mask; }

namespace math {
RINGWATCH_INLINE double sqrt(double a) { return ::sqrt(a); }
RINGWATCH_INLINE float sqrt(float a) { return ::sqrtf(a); }
RINGWATCH_INLINE double log(double a) { return ::log(a); }
RINGWATCH_INLINE float log(float a) { return ::logf(a); }
RINGWATCH_INLINE double cbrt(double a) { return ::cbrt(a); }
RINGWATCH_INLINE float cbrt(float a) { return ::cbrtf(a); }
RINGWATCH_INLINE double abs(double a) { return ::fabs(a); }
RINGWATCH_INLINE float abs(float a) { return ::fabsf(a); }
RINGWATCH_INLINE double max(double a, double b) { return a > b ? a : b; }
RINGWATCH_INLINE float max(float a, float b) { return a > b ? a : b; }
RINGWATCH_INLINE double min(double a, double b) { return a < b ? a : b; }
RINGWATCH_INLINE float min(float a, float b) { return a < b ? a : b; }
}  // namespace math

}  // namespace ringwatch

// A kernel's math::log is looked up where the kernel is defined, so the other scalars come before any kernel, whatever
// is included first.
#if !defined(__CUDACC__)
#include <ringwatch/base/dual.h>
#include <ringwatch/base/pack.h>
#endif
