#pragma once
#include <ringwatch/base/math.h>
#include <ringwatch/base/matrix3.h>
#include <ringwatch/materials/tangent_drift.h>

namespace ringwatch {

/// The tangent ∂P/∂F of an isotropic law at diag(s₁, s₂, s₃), Pa: its quadratic form is that of `normal` in the
/// diagonal of dF, and for each pair i, j half the eigenvalue times the square of dF_ij + dF_ji, and of dF_ij - dF_ji
/// (Theorem 99, docs/theory/moved_majorants.md).
template <class S>
struct PrincipalTangent {
  S normal[3][3];                     ///< ∂P_ii/∂F_jj
  S flip, twist;                      ///< the largest of the three eigenvalues for sums, and for differences
  TangentDriftCoefficients<S> drift;  ///< how fast the tangent can grow from there
};

/// The principal tangent of a law. False, and nothing written, of laws that do not say that they have no direction of
/// their own.
template <class Law, class S>
RINGWATCH_INLINE bool principalTangent(const Law& law, const S (&stretches)[3], PrincipalTangent<S>& tangent) {
  if constexpr (requires { requires Law::isotropic; }) {
    Matrix3<S> F = Matrix3<S>::zero();
    for (int i = 0; i < 3; ++i) F(i, i) = stretches[i];
    const auto linearization = law.linearize(F);
    const auto along = [&](int row, int column) {
      Matrix3<S> dF = Matrix3<S>::zero();
      dF(row, column) = S(1.0);
      return linearization(dF);
    };
    for (int j = 0; j < 3; ++j) {
      const Matrix3<S> dP = along(j, j);
      for (int i = 0; i < 3; ++i) tangent.normal[i][j] = dP(i, i);
      const int next = (j + 1) % 3;
      const Matrix3<S> shear = along(j, next);
      const S flip = shear(j, next) + shear(next, j), twist = shear(j, next) - shear(next, j);
      tangent.flip = j == 0 ? flip : math::max(tangent.flip, flip);
      tangent.twist = j == 0 ? twist : math::max(tangent.twist, twist);
    }
    tangent.drift = law.drift(F);
    return true;
  }
  return false;
}

}  // namespace ringwatch
