#pragma once
#include <span>
#include <string_view>

#include <ringwatch/base/matrix3.h>
#include <ringwatch/materials/lame.h>
#include <ringwatch/materials/modulus_rounding.h>
#include <ringwatch/materials/tangent_drift.h>

namespace ringwatch {

/// Linear elasticity at small strain, ε = sym(F) - I:
///   W = μ ε:ε + λ/2 tr²ε,   P = 2μ ε + λ tr(ε) I.
/// Not objective: rotations strain it.
struct LinearElastic {
  static constexpr std::string_view name = "linear";
  static constexpr std::string_view help = "linear elasticity at small strain";
  static constexpr std::span<const OptionInfo> parameters = youngAndPoisson;
  static constexpr bool objective = false, isotropic = true, tangentIsConstant = true;
  static constexpr bool tangentStiffens = false;
  static constexpr bool energyAlongStress = true;
  static constexpr bool definedInverted = true, allowsInversion = false;
  Lame constants;

  static LinearElastic of(const Options& parameters) { return {lameConstants(parameters)}; }
  static constexpr auto parametersFor = youngAndPoissonOf;
  Lame restModuli() const { return constants; }

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

    /// weight Σ_KL g_aK g_bL ∂P_iK/∂F_jL, the tangent's 3×3 block of two nodes with shape gradients g:
    ///   λ g_a g_bᵀ + μ g_b g_aᵀ + μ (g_a·g_b) I.
    struct NodeBlocks {
      struct Node {
        S g[3];
      };
      S lambda, mu;
      RINGWATCH_INLINE Node node(const S (&g)[3]) const { return {{g[0], g[1], g[2]}}; }
      RINGWATCH_INLINE Matrix3<S> operator()(const Node& a, const Node& b) const {
        const S product = mu * (a.g[0] * b.g[0] + a.g[1] * b.g[1] + a.g[2] * b.g[2]);
        Matrix3<S> r;
        for (int i = 0; i < 3; ++i) {
          const S lambdaG = lambda * a.g[i], muG = mu * b.g[i];
          for (int j = 0; j < 3; ++j) r(i, j) = lambdaG * b.g[j] + muG * a.g[j];
          r(i, i) += product;
        }
        return r;
      }
    };
    RINGWATCH_INLINE NodeBlocks nodeBlocks(const S& weight) const {
      return {weight * S(law.constants.lambda), weight * S(law.constants.mu)};
    }
    /// The tangent does not depend on F.
    RINGWATCH_INLINE ModulusRounding<S> rounding(const Matrix3<S>& /*F*/, const S& /*error*/) const {
      const double size = math::abs(law.constants.lambda) + 3 * law.constants.mu;
      return {S(size), S(lawRounding * unitRoundoff * size)};
    }
  };
  template <class S>
  RINGWATCH_INLINE Linearization<S> linearize(const Matrix3<S>&) const {
    return {*this};
  }

  /// The tangent is constant: it does not drift. Its eigenvalues are 0, 2μ and 3λ+2μ. Theorem 23,
  /// docs/theory/tangent_drift.md.
  template <class S>
  RINGWATCH_INLINE TangentDriftCoefficients<S> drift(const Matrix3<S>&) const {
    const S zero(0.0);
    return {zero, zero, zero, S(math::max(0.0, -3 * constants.lambda - 2 * constants.mu))};
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
