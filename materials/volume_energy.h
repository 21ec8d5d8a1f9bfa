#pragma once
#include <ringwatch/base/matrix3.h>

namespace ringwatch {

/// An upper bound of the largest stretch s₁ of F: s₁² by Gershgorin's circles of FᵀF.
template <class S>
RINGWATCH_INLINE S largestStretch(const Matrix3<S>& F) {
  const Matrix3<S> C = transposeTimes(F, F);
  S most(0.0);
  for (int i = 0; i < 3; ++i)
    most = math::max(most, C(i, i) + math::abs(C(i, (i + 1) % 3)) + math::abs(C(i, (i + 2) % 3)));
  return math::sqrt(most);
}

/// An upper bound of |D³U(J)| on the ball of that radius around F, for an energy U of the volume J = det F with the
/// constant second derivative `curvature` and the first one `slope` at F, Pa:
///   D³U = 3 U'' DJ D²J + U' D³J,   |DJ| = |cof F|,  |D²J| <= 2 s₁,  |D³J| <= 2/√3,  |cof(F + Δ)| <= |cof F| + 2 s₁ δ +
///   δ²/√3.
/// Theorem 50, docs/theory/tangent_drift.md.
template <class S>
RINGWATCH_INLINE S volumeThirdDerivative(const S& curvature, const S& slope, const Matrix3<S>& F, const S& radius) {
  constexpr double inverseRoot3 = 0.57735026918962584;  // rounded up
  const Matrix3<S> cof = cofactor(F);
  const S stretch = largestStretch(F), size = math::abs(curvature);
  const S cofactorNorm =
      math::sqrt(innerProduct(cof, cof)) + S(2.0) * stretch * radius + S(inverseRoot3) * radius * radius;
  return S(6.0) * size * cofactorNorm * (stretch + radius) +
         S(2 * inverseRoot3) * (math::abs(slope) + size * cofactorNorm * radius);
}

}  // namespace ringwatch
