#pragma once
#include <variant>

#include <ringwatch/base/math.h>
#include <ringwatch/base/matrix3.h>
#include <ringwatch/base/pack.h>
#include <ringwatch/body/body.h>
#include <ringwatch/materials/lame.h>
#include <ringwatch/materials/rotation.h>
#include <ringwatch/monitor/small/extreme_eigenvalues.h>
#include <ringwatch/monitor/small/symmetric3.h>

/// The arithmetic of majorants that move with a body (Theorem 97, docs/theory/moved_majorants.md), for an element or a
/// pack of them.
namespace ringwatch {

/// Whether some components of a node are held and some are free: what moves must keep them apart.
inline bool isPartlyHeld(const Body& body, std::int32_t node) {
  const int free = body.constraints().any() ? body.constraints().freeComponents(node) : 3;
  return free != 0 && free != 3;
}
/// Whether a majorant of the block's elements moves with any T: St. Venant-Kirchhoff with one gradient a point.
inline bool stretchesFreely(const ElementBlock& block) {
  const QuadratureRule& rule = block.rule();
  return std::holds_alternative<StVenantKirchhoff>(block.material().law) && !block.material().outside &&
         !rule.uniformStrain && rule.shares.meanLambda == 0 && rule.shares.meanMu == 0 &&
         block.material().restModuli().lambda >= 0;
}

/// T D Tᵀ.
template <class S>
RINGWATCH_INLINE Symmetric3<S> movedWeight(const Matrix3<S>& T, const Symmetric3<S>& D) {
  S half[3][3];
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) half[i][j] = T(i, 0) * D(0, j) + T(i, 1) * D(1, j) + T(i, 2) * D(2, j);
  Symmetric3<S> moved;
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j) moved(i, j) = half[i][0] * T(j, 0) + half[i][1] * T(j, 1) + half[i][2] * T(j, 2);
  return moved;
}

/// R (3 I - RᵀR)/2: a rotation to rounding, of one that is known in single precision.
template <class S>
RINGWATCH_INLINE Matrix3<S> polishedRotation(const Matrix3<S>& R) {
  return S(0.5) * (R * (Matrix3<S>::diagonal(S(3)) - transposeTimes(R, R)));
}

/// Bounds of the eigenvalues of a symmetric 3×3 matrix, mean ± √2 deviations (Samuelson 1968): exact where two of them
/// are the same.
template <class S>
struct EigenvalueBounds {
  S mean, half;
  S high() const { return mean + half; }
};
template <class S>
RINGWATCH_INLINE EigenvalueBounds<S> eigenvalueBounds(const Symmetric3<S>& A) {
  const S mean = S(1.0 / 3) * A.trace();
  S squares(0.0);
  for (int c = 0; c < 3; ++c) squares += (A.m[c] - mean) * (A.m[c] - mean) + S(2.0) * A.m[c + 3] * A.m[c + 3];
  // Rounding of the mean and of the sums.
  return {mean, math::sqrt(S(2.0 / 3) * squares) + S(eigenvalueRounding) * (math::abs(mean) + math::sqrt(squares))};
}

/// S = λ tr(E) I + 2μ E of St. Venant-Kirchhoff, Pa.
template <class S>
RINGWATCH_INLINE Symmetric3<S> secondStressOf(const Lame& constants, const Matrix3<S>& F) {
  const Matrix3<S> C = transposeTimes(F, F);
  const S ofTrace = S(0.5 * constants.lambda) * (trace(C) - S(3.0)) - S(constants.mu);
  Symmetric3<S> stress;
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j) stress(i, j) = S(constants.mu) * C(i, j) + (i == j ? ofTrace : S(0.0));
  return stress;
}

/// m with |λ tr(e) 1 + 2μ e| <= m |e|: the largest size of an eigenvalue by the Frobenius norm of e.
inline double stressModulus(double lambda, double twoMu) {
  return std::sqrt((lambda + twoMu) * (lambda + twoMu) + 2 * lambda * lambda);
}

/// What St. Venant-Kirchhoff's geometric stiffness at F has beyond (1+η) times what T makes of that at A, Pa: with σ₋,
/// σ₊ bounds of the eigenvalues of T Tᵀ, at most
///   max(0, lambda_max(S(F) - (1+η) σ_m S(A)) + (1+η) σ_d |S(A)|),   σ_m = (σ₋+σ₊)/2,   σ_d = (σ₊-σ₋)/2.
/// errorOfAnchor: |A - A'|, A' the gradient at which K ≼ l D was proven.
RINGWATCH_INLINE NativePack geometricGrowth(const Lame& constants, const Matrix3<NativePack>& F,
                                            const Matrix3<NativePack>& A, const Matrix3<NativePack>& T,
                                            const NativePack& eta, double errorOfAnchor) {
  using P = NativePack;
  Symmetric3<P> stretch;
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j) stretch(i, j) = T(i, 0) * T(j, 0) + T(i, 1) * T(j, 1) + T(i, 2) * T(j, 2);
  const auto [mean, half] = eigenvalueBounds(stretch);
  const Symmetric3<P> before = secondStressOf(constants, A);
  Symmetric3<P> rest = secondStressOf(constants, F);
  P size2(0.0);
  for (int c = 0; c < 6; ++c) {
    rest.m[c] -= (P(1.0) + eta) * mean * before.m[c];
    size2 += P(c < 3 ? 1.0 : 2.0) * before.m[c] * before.m[c];
  }
  const double modulus = stressModulus(constants.lambda, 2 * constants.mu);
  // |S(A) - S(A')| <= modulus |E - E'|.
  const P error = P(modulus * errorOfAnchor) * (math::sqrt(innerProduct(A, A)) + P(0.5 * errorOfAnchor));
  return math::max(P(0.0),
                   eigenvalueBounds(rest).high() + (P(1.0) + eta) * (half * math::sqrt(size2) + (mean + half) * error));
}

}  // namespace ringwatch
