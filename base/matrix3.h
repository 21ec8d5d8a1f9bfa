#pragma once
#include <ringwatch/base/math.h>

namespace ringwatch {

/// A 3×3 matrix of any kernel scalar (double, float, Pack, Dual), row by row. Plain data, no allocation, fit for CUDA.
template <class S>
struct Matrix3 {
  S m[9];

  RINGWATCH_INLINE S& operator()(int i, int j) { return m[3 * i + j]; }
  RINGWATCH_INLINE const S& operator()(int i, int j) const { return m[3 * i + j]; }

  RINGWATCH_INLINE static Matrix3 zero() { return diagonal(S(0)); }
  RINGWATCH_INLINE static Matrix3 identity() { return diagonal(S(1)); }
  RINGWATCH_INLINE static Matrix3 diagonal(S d) {
    const S o(0);
    return {{d, o, o, o, d, o, o, o, d}};
  }

  RINGWATCH_INLINE friend Matrix3 operator+(const Matrix3& a, const Matrix3& b) {
    Matrix3 r;
    for (int i = 0; i < 9; ++i) r.m[i] = a.m[i] + b.m[i];
    return r;
  }
  RINGWATCH_INLINE friend Matrix3 operator-(const Matrix3& a, const Matrix3& b) {
    Matrix3 r;
    for (int i = 0; i < 9; ++i) r.m[i] = a.m[i] - b.m[i];
    return r;
  }
  RINGWATCH_INLINE friend Matrix3 operator*(S s, const Matrix3& a) {
    Matrix3 r;
    for (int i = 0; i < 9; ++i) r.m[i] = s * a.m[i];
    return r;
  }
  RINGWATCH_INLINE friend Matrix3 operator*(const Matrix3& a, const Matrix3& b) {
    Matrix3 r;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) r(i, j) = a(i, 0) * b(0, j) + a(i, 1) * b(1, j) + a(i, 2) * b(2, j);
    return r;
  }
};

template <class S>
RINGWATCH_INLINE Matrix3<S> transpose(const Matrix3<S>& a) {
  return {{a.m[0], a.m[3], a.m[6], a.m[1], a.m[4], a.m[7], a.m[2], a.m[5], a.m[8]}};
}
/// aᵀ b
template <class S>
RINGWATCH_INLINE Matrix3<S> transposeTimes(const Matrix3<S>& a, const Matrix3<S>& b) {
  Matrix3<S> r;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) r(i, j) = a(0, i) * b(0, j) + a(1, i) * b(1, j) + a(2, i) * b(2, j);
  return r;
}
/// a bᵀ
template <class S>
RINGWATCH_INLINE Matrix3<S> timesTranspose(const Matrix3<S>& a, const Matrix3<S>& b) {
  Matrix3<S> r;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) r(i, j) = a(i, 0) * b(j, 0) + a(i, 1) * b(j, 1) + a(i, 2) * b(j, 2);
  return r;
}
template <class S>
RINGWATCH_INLINE S trace(const Matrix3<S>& a) {
  return a.m[0] + a.m[4] + a.m[8];
}
/// Σ a_ij b_ij
template <class S>
RINGWATCH_INLINE S innerProduct(const Matrix3<S>& a, const Matrix3<S>& b) {
  S r = a.m[0] * b.m[0];
  for (int i = 1; i < 9; ++i) r += a.m[i] * b.m[i];
  return r;
}
/// Cofactor matrix: det(a)·a⁻ᵀ, also ∂det(a)/∂a.
template <class S>
RINGWATCH_INLINE Matrix3<S> cofactor(const Matrix3<S>& a) {
  return {{a.m[4] * a.m[8] - a.m[5] * a.m[7], a.m[5] * a.m[6] - a.m[3] * a.m[8], a.m[3] * a.m[7] - a.m[4] * a.m[6],
           a.m[2] * a.m[7] - a.m[1] * a.m[8], a.m[0] * a.m[8] - a.m[2] * a.m[6], a.m[1] * a.m[6] - a.m[0] * a.m[7],
           a.m[1] * a.m[5] - a.m[2] * a.m[4], a.m[2] * a.m[3] - a.m[0] * a.m[5], a.m[0] * a.m[4] - a.m[1] * a.m[3]}};
}
template <class S>
RINGWATCH_INLINE S determinant(const Matrix3<S>& a) {
  return a.m[0] * (a.m[4] * a.m[8] - a.m[5] * a.m[7]) + a.m[1] * (a.m[5] * a.m[6] - a.m[3] * a.m[8]) +
         a.m[2] * (a.m[3] * a.m[7] - a.m[4] * a.m[6]);
}
/// Inverse; a singular matrix gives infinities or NaN, as IEEE arithmetic has it.
template <class S>
RINGWATCH_INLINE Matrix3<S> inverse(const Matrix3<S>& a) {
  return (S(1) / determinant(a)) * transpose(cofactor(a));
}

}  // namespace ringwatch
