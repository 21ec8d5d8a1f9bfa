#pragma once
#include <string_view>

#include <ringwatch/base/matrix3.h>
#include <ringwatch/materials/lame.h>

namespace ringwatch {

/// Linear elasticity at small strain, ε = sym(F) - I:
///   W = μ ε:ε + λ/2 tr²ε,   P = 2μ ε + λ tr(ε) I.
/// Not objective: rotations strain it.
struct LinearElastic {
  static constexpr std::string_view name = "linear";
  static constexpr std::string_view help = "linear elasticity at small strain";
  static constexpr bool objective = false;
  Lame constants;

  /// Energy density, J/m³, of the deformation gradient F.
  template <class S>
  RINGWATCH_INLINE S energy(const Matrix3<S>& F) const {
    const Matrix3<S> e = strain(F);
    const S t = trace(e);
    return S(constants.mu) * innerProduct(e, e) + S(0.5 * constants.lambda) * t * t;
  }
  /// First Piola–Kirchhoff stress P = ∂W/∂F, Pa.
  template <class S>
  RINGWATCH_INLINE Matrix3<S> stress(const Matrix3<S>& F) const {
    return stressOfStrain(strain(F));
  }
  /// dF ↦ dP = ∂P/∂F : dF, exact.
  template <class S>
  struct Linearization {
    const LinearElastic& law;
    RINGWATCH_INLINE Matrix3<S> operator()(const Matrix3<S>& dF) const {
      return law.stressOfStrain(S(0.5) * (dF + transpose(dF)));
    }
  };
  template <class S>
  RINGWATCH_INLINE Linearization<S> linearize(const Matrix3<S>&) const {
    return {*this};
  }

  /// The tangent is constant: it does not drift. Its eigenvalues are 0, 2μ and 3λ+2μ.
  RINGWATCH_INLINE TangentDriftCoefficients drift(const Matrix3<double>&) const {
    return {0, 0, 0, math::max(0.0, -3 * constants.lambda - 2 * constants.mu)};
  }

 private:
  template <class S>
  RINGWATCH_INLINE static Matrix3<S> strain(const Matrix3<S>& F) {
    return S(0.5) * (F + transpose(F)) - Matrix3<S>::identity();
  }
  template <class S>
  RINGWATCH_INLINE Matrix3<S> stressOfStrain(const Matrix3<S>& e) const {
    return S(2 * constants.mu) * e + Matrix3<S>::diagonal(S(constants.lambda) * trace(e));
  }
};

}  // namespace ringwatch
