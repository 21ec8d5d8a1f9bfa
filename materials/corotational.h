#pragma once
#include <string_view>

#include <ringwatch/base/matrix3.h>
#include <ringwatch/materials/lame.h>
#include <ringwatch/materials/rotation.h>

namespace ringwatch {

/// Corotational linear elasticity as a law on F, with R the rotation closest to F:
///   W = μ |F - R|² + λ/2 tr²(RᵀF - I),   P = 2μ (F - R) + λ tr(RᵀF - I) R.
/// The differential is exact: it contains the turning of R, dR = R [w]×, (tr(U) I - U) w = axial(Rᵀ dF - dFᵀ R),
/// U = sym(RᵀF) (Chao et al. 2010).
struct Corotational {
  static constexpr std::string_view name = "corotational";
  static constexpr std::string_view help = "linear elasticity in a frame that turns with the element";
  static constexpr bool objective = true;
  Lame constants;

  /// Energy density, J/m³, of the deformation gradient F.
  template <class S>
  RINGWATCH_INLINE S energy(const Matrix3<S>& F) const {
    const Matrix3<S> R = closestRotation(F), d = F - R;
    const S t = innerProduct(R, F) - S(3);
    return S(constants.mu) * innerProduct(d, d) + S(0.5 * constants.lambda) * t * t;
  }
  /// First Piola–Kirchhoff stress P = ∂W/∂F, Pa.
  template <class S>
  RINGWATCH_INLINE Matrix3<S> stress(const Matrix3<S>& F) const {
    const Matrix3<S> R = closestRotation(F);
    const S t = S(constants.lambda) * (innerProduct(R, F) - S(3)) - S(2 * constants.mu);
    return S(2 * constants.mu) * F + t * R;
  }
  /// dF ↦ dP = 2μ dF + λ (R:dF) R + (λ tr(RᵀF - I) - 2μ) dR, exact.
  template <class S>
  struct Linearization {
    const Corotational& law;
    Matrix3<S> R, spin;  // spin = (tr(U) I - U)⁻¹
    S t;                 // λ tr(RᵀF - I) - 2μ
    RINGWATCH_INLINE Matrix3<S> operator()(const Matrix3<S>& dF) const {
      const Matrix3<S> a = transposeTimes(R, dF);
      const S k0 = a.m[7] - a.m[5], k1 = a.m[2] - a.m[6], k2 = a.m[3] - a.m[1];
      const S w0 = spin.m[0] * k0 + spin.m[1] * k1 + spin.m[2] * k2;
      const S w1 = spin.m[3] * k0 + spin.m[4] * k1 + spin.m[5] * k2;
      const S w2 = spin.m[6] * k0 + spin.m[7] * k1 + spin.m[8] * k2;
      const S o(0);
      const Matrix3<S> cross{{o, -w2, w1, w2, o, -w0, -w1, w0, o}};
      return S(2 * law.constants.mu) * dF + (S(law.constants.lambda) * trace(a)) * R + t * (R * cross);
    }
  };
  template <class S>
  RINGWATCH_INLINE Linearization<S> linearize(const Matrix3<S>& F) const {
    const Matrix3<S> R = closestRotation(F), a = transposeTimes(R, F);
    const Matrix3<S> U = S(0.5) * (a + transpose(a));
    return {*this, R, inverse(Matrix3<S>::diagonal(trace(U)) - U),
            S(constants.lambda) * (trace(U) - S(3)) - S(2 * constants.mu)};
  }
};

}  // namespace ringwatch
