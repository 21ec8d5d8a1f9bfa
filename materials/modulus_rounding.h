#pragma once
#include <limits>

#include <ringwatch/base/matrix3.h>
#include <ringwatch/base/rounding.h>

namespace ringwatch {

/// What a law says of the rounding of its tangent C = ∂P/∂F at a deformation gradient F that was computed: of the
/// blocks g_a C g_b of all shape gradients g. Theorem 42, docs/theory/floating_point.md.
template <class S>
struct ModulusRounding {
  S size;   ///< |g_a C g_b| <= size |g_a| |g_b|, of the sum of the sizes of all terms, Pa
  S error;  ///< |computed - exact| <= error |g_a| |g_b|, exact: at a gradient within the error that was given, Pa
};

namespace detail {
/// The error where it is known, and infinity where it is not.
template <class Mask, class S>
RINGWATCH_INLINE S knownOnly(const Mask& known, const S& error) {
  return select(known, error, S(std::numeric_limits<double>::infinity()));
}

/// Bounds of what G = F⁻ᵀ = cof F / J and ln J err by, for |ΔF| <= error: laws of ln J share them.
template <class S>
struct InverseRounding {
  S relative;   // |ΔG| <= relative |G|
  S logarithm;  // |Δ ln J|, without the rounding of ln itself
  S norm2;      // |G|²
};
/// G: as computed. Cofactors err by 2 u (|ab| + |cd|), J by 4 u |F|³, so that with z = |F|³/J the quotient errs by
/// u (5 z + 4) |G|; |(F + Δ)⁻¹ - F⁻¹| <= |F⁻¹|² |Δ| / (1 - |F⁻¹| |Δ|). Infinite where either is too large to be small.
template <class S>
RINGWATCH_INLINE InverseRounding<S> inverseRounding(const Matrix3<S>& F, const Matrix3<S>& G, const S& error) {
  const S F2 = innerProduct(F, F), norm2 = innerProduct(G, G);
  const S J = determinant(F), z = math::sqrt(F2) * F2 / J, moved = math::sqrt(norm2) * error;
  const auto known = (J > S(0.0)) & (S(unitRoundoff) * z < S(1e-3)) & (moved < S(0.1));
  return {knownOnly(known, S(unitRoundoff) * (S(5.0) * z + S(4.0)) + S(1.2) * moved),
          S(6 * unitRoundoff) * z + S(3.0) * moved, norm2};
}
}  // namespace detail

}  // namespace ringwatch
