#pragma once
#include <ringwatch/base/matrix3.h>
#include <ringwatch/base/rounding.h>

namespace ringwatch::detail {

/// An upper bound of ‖G‖², the largest eigenvalue of GᵀG, by its trace and norm (Fact J, docs/theory/notation.md). For
/// G = F⁻ᵀ its root is at least 1/s₃, s₃ the least singular value of F.
template <class S>
RINGWATCH_INLINE S spectralNorm2(const Matrix3<S>& G) {
  const Matrix3<S> C = transposeTimes(G, G);
  const S third = trace(C) * S(1.0 / 3.0);
  const S spread2 = math::max(S(0.0), innerProduct(C, C) - S(3.0) * third * third);
  return (third + math::sqrt(S(2.0 / 3.0) * spread2)) * S(1 + largestInverseRounding);
}

/// F where `known`, else the identity: what a bound is computed from where the law has no tangent.
template <class Mask, class S>
RINGWATCH_INLINE Matrix3<S> knownOrIdentity(const Mask& known, const Matrix3<S>& F) {
  Matrix3<S> own = Matrix3<S>::identity();
  for (int i = 0; i < 9; ++i) own.m[i] = select(known, F.m[i], own.m[i]);
  return own;
}

/// The largest distance from F, as a share of its least stretch, to which the bounds of isochoric laws reach: θ.
inline constexpr double driftBallShare = 0.05;
/// The ball around F in which ‖F'⁻¹‖ <= k w, k = 1/(1 - θ).
template <class S>
struct DriftBall {
  S w;         ///< at least ‖F⁻¹‖
  S inverse2;  ///< |F⁻¹|²
  S radius;    ///< θ / w
};
template <class S>
RINGWATCH_INLINE DriftBall<S> driftBall(const Matrix3<S>& inverseTranspose) {
  const S w = math::sqrt(spectralNorm2(inverseTranspose));
  return {w, innerProduct(inverseTranspose, inverseTranspose), S(driftBallShare) / w};
}

}  // namespace ringwatch::detail
