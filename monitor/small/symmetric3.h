#pragma once
#include <ringwatch/base/math.h>

namespace ringwatch {

/// A symmetric 3×3 matrix of any kernel scalar: 00, 11, 22, 12, 02, 01.
template <class S>
struct Symmetric3 {
  S m[6];

  RINGWATCH_INLINE static Symmetric3 diagonal(S d) { return {{d, d, d, S(0), S(0), S(0)}}; }
  /// Where entry (i, j) is in m.
  RINGWATCH_INLINE static constexpr int index(int i, int j) { return i == j ? i : 6 - i - j; }
  RINGWATCH_INLINE const S& operator()(int i, int j) const { return m[index(i, j)]; }
  RINGWATCH_INLINE S& operator()(int i, int j) { return m[index(i, j)]; }
  template <class Archive>
  void archive(Archive& a) {
    a(m);
  }
  RINGWATCH_INLINE S trace() const { return m[0] + m[1] + m[2]; }
  RINGWATCH_INLINE S determinant() const {
    return m[0] * (m[1] * m[2] - m[3] * m[3]) - m[5] * (m[5] * m[2] - m[3] * m[4]) + m[4] * (m[5] * m[3] - m[1] * m[4]);
  }
  RINGWATCH_INLINE friend Symmetric3 operator*(S s, const Symmetric3& a) {
    Symmetric3 r;
    for (int i = 0; i < 6; ++i) r.m[i] = s * a.m[i];
    return r;
  }
  RINGWATCH_INLINE friend Symmetric3 operator+(const Symmetric3& a, const Symmetric3& b) {
    Symmetric3 r;
    for (int i = 0; i < 6; ++i) r.m[i] = a.m[i] + b.m[i];
    return r;
  }
};

/// a²
template <class S>
RINGWATCH_INLINE Symmetric3<S> square(const Symmetric3<S>& a) {
  Symmetric3<S> r;
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j) r(i, j) = a(i, 0) * a(0, j) + a(i, 1) * a(1, j) + a(i, 2) * a(2, j);
  return r;
}

/// r a r, symmetric for symmetric r and a.
template <class S>
RINGWATCH_INLINE Symmetric3<S> congruence(const Symmetric3<S>& r, const Symmetric3<S>& a) {
  S t[3][3];
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) t[i][j] = r(i, 0) * a(0, j) + r(i, 1) * a(1, j) + r(i, 2) * a(2, j);
  Symmetric3<S> out;
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j) out(i, j) = t[i][0] * r(0, j) + t[i][1] * r(1, j) + t[i][2] * r(2, j);
  return out;
}

/// Square root of a positive definite matrix C (Hoger & Carlson 1984): with the invariants i1, i2, i3 of U = √C,
/// U = (C + i2 I)⁻¹ (i1 C + i3 I) = (i1 i3 I + (i1² - i2) C - C²) / (i1 i2 - i3). i1 is the largest root of
/// x⁴ - 2 I x² - 8 J x + I² - 4 II, found as in closestRotation, with the invariants I, II, J² of C.
template <class S>
RINGWATCH_INLINE Symmetric3<S> squareRoot(const Symmetric3<S>& C) {
  const Symmetric3<S> C2 = square(C);
  const S I = C.trace(), II = S(0.5) * (I * I - C2.trace());
  const S J = math::sqrt(math::max(C.determinant(), S(0)));
  const S c0 = I * I - S(4) * II;
  S x = math::sqrt(S(3) * I);
  auto going = x >= S(0);
  for (int iteration = 0; iteration < 30; ++iteration) {
    const S g = ((x * x - S(2) * I) * x - S(8) * J) * x + c0, slope = S(4) * (x * x - I) * x - S(8) * J;
    const auto falling = going & (g > S(0)) & (slope > S(0));
    const S step = select(falling, g / select(falling, slope, S(1)), S(0));
    x -= step;
    going = going & (step > S(1e-12) * x);
    if (!anyOf(going)) break;
  }
  const S i2 = S(0.5) * (x * x - I), denominator = x * i2 - J;
  const auto regular = denominator > S(0);
  const S scale = select(regular, S(1) / select(regular, denominator, S(1)), S(0));
  return scale * (Symmetric3<S>::diagonal(x * J) + (x * x - i2) * C + S(-1) * C2);
}

}  // namespace ringwatch
