#pragma once
#include <string_view>

#include <ringwatch/base/matrix3.h>
#include <ringwatch/materials/lame.h>

namespace ringwatch {

/// Compressible neo-Hookean (Bonet & Wood 2008, eq. 6.28), J = det F:
///   W = μ/2 (tr FᵀF - 3) - μ ln J + λ/2 ln²J,   P = μ (F - F⁻ᵀ) + λ ln J F⁻ᵀ.
/// Undefined for J <= 0: energy and stress are NaN there, which the monitor reports as an inverted element.
struct NeoHookean {
  static constexpr std::string_view name = "neo-hookean";
  static constexpr std::string_view help = "compressible neo-Hookean: stiffens without bound under compression";
  static constexpr bool objective = true;
  Lame constants;

  /// Energy density, J/m³, of the deformation gradient F.
  template <class S>
  RINGWATCH_INLINE S energy(const Matrix3<S>& F) const {
    const S logJ = math::log(determinant(F));
    return S(0.5 * constants.mu) * (innerProduct(F, F) - S(3)) - S(constants.mu) * logJ +
           S(0.5 * constants.lambda) * logJ * logJ;
  }
  /// First Piola–Kirchhoff stress P = ∂W/∂F, Pa.
  template <class S>
  RINGWATCH_INLINE Matrix3<S> stress(const Matrix3<S>& F) const {
    const Linearization<S> l = linearize(F);
    return S(constants.mu) * F - l.a * l.inverseTranspose;
  }
  /// dF ↦ dP = μ dF + (μ - λ ln J) F⁻ᵀ dFᵀ F⁻ᵀ + λ (F⁻ᵀ : dF) F⁻ᵀ, exact.
  template <class S>
  struct Linearization {
    const NeoHookean& law;
    Matrix3<S> inverseTranspose;
    S a;  // μ - λ ln J
    RINGWATCH_INLINE Matrix3<S> operator()(const Matrix3<S>& dF) const {
      const Matrix3<S> b = timesTranspose(inverseTranspose, dF) * inverseTranspose;
      const S c = S(law.constants.lambda) * innerProduct(inverseTranspose, dF);
      return S(law.constants.mu) * dF + a * b + c * inverseTranspose;
    }
  };
  template <class S>
  RINGWATCH_INLINE Linearization<S> linearize(const Matrix3<S>& F) const {
    const Matrix3<S> cof = cofactor(F);
    const S J = F.m[0] * cof.m[0] + F.m[1] * cof.m[1] + F.m[2] * cof.m[2];
    return {*this, (S(1) / J) * cof, S(constants.mu) - S(constants.lambda) * math::log(J)};
  }
};

}  // namespace ringwatch
