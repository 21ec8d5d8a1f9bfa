#pragma once
#include <span>
#include <string_view>

#include <ringwatch/base/matrix3.h>
#include <ringwatch/base/rounding.h>
#include <ringwatch/materials/inverse_norm.h>
#include <ringwatch/materials/lame.h>
#include <ringwatch/materials/modulus_rounding.h>
#include <ringwatch/materials/tangent_drift.h>

namespace ringwatch {

/// Compressible neo-Hookean (Bonet & Wood 2008, eq. 6.28), J = det F:
///   W = μ/2 (tr FᵀF - 3) - μ ln J + λ/2 ln²J,   P = μ (F - F⁻ᵀ) + λ ln J F⁻ᵀ.
/// Undefined for J <= 0: energy and stress are NaN there, which the monitor reports as an inverted element.
struct NeoHookean {
  static constexpr std::string_view name = "neo-hookean";
  static constexpr std::string_view help = "compressible neo-Hookean: stiffens without bound under compression";
  static constexpr std::span<const OptionInfo> parameters = youngAndPoisson;
  static constexpr bool objective = true, isotropic = true, tangentIsConstant = false;
  static constexpr bool tangentStiffens = true;
  static constexpr bool energyAlongStress = true;
  static constexpr bool definedInverted = false, allowsInversion = false;
  Lame constants;

  static NeoHookean of(const Options& parameters) { return {lameConstants(parameters)}; }
  static constexpr auto parametersFor = youngAndPoissonOf;
  Lame restModuli() const { return constants; }

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

    /// weight Σ_KL g_aK g_bL ∂P_iK/∂F_jL, the tangent's 3×3 block of two nodes with shape gradients g: with h = F⁻ᵀ g,
    ///   μ (g_a·g_b) I + λ h_a h_bᵀ + (μ - λ ln J) h_b h_aᵀ.
    struct NodeBlocks {
      struct Node {
        S g[3], h[3];
      };
      Matrix3<S> inverseTranspose;
      S lambda, mu, a;
      RINGWATCH_INLINE Node node(const S (&g)[3]) const {
        Node r;
        for (int i = 0; i < 3; ++i) {
          r.g[i] = g[i];
          r.h[i] = inverseTranspose(i, 0) * g[0] + inverseTranspose(i, 1) * g[1] + inverseTranspose(i, 2) * g[2];
        }
        return r;
      }
      RINGWATCH_INLINE Matrix3<S> operator()(const Node& first, const Node& second) const {
        const S product = mu * (first.g[0] * second.g[0] + first.g[1] * second.g[1] + first.g[2] * second.g[2]);
        Matrix3<S> r;
        for (int i = 0; i < 3; ++i) {
          const S lambdaH = lambda * first.h[i], aH = a * second.h[i];
          for (int j = 0; j < 3; ++j) r(i, j) = lambdaH * second.h[j] + aH * first.h[j];
          r(i, i) += product;
        }
        return r;
      }
    };
    RINGWATCH_INLINE NodeBlocks nodeBlocks(const S& weight) const {
      return {inverseTranspose, weight * S(law.constants.lambda), weight * S(law.constants.mu), weight * a};
    }
    /// Blocks are at most 2μ + (|λ| + |a|) |G|², with G = F⁻ᵀ and a = μ - λ ln J; ΔG and Δa by detail::inverseRounding.
    RINGWATCH_INLINE ModulusRounding<S> rounding(const Matrix3<S>& F, const S& error) const {
      const auto inverse = detail::inverseRounding(F, inverseTranspose, error);
      const S lambda(math::abs(law.constants.lambda)), mu(law.constants.mu), terms = lambda + math::abs(a);
      const S size = S(2.0) * mu + terms * inverse.norm2;
      const S da = lambda * inverse.logarithm + S(4 * unitRoundoff) * (math::abs(mu - a) + terms);
      return {size,
              S(lawRounding * unitRoundoff) * size + inverse.norm2 * (S(2.5) * inverse.relative * terms + S(1.3) * da)};
    }
  };
  template <class S>
  RINGWATCH_INLINE Linearization<S> linearize(const Matrix3<S>& F) const {
    const Matrix3<S> cof = cofactor(F);
    const S J = F.m[0] * cof.m[0] + F.m[1] * cof.m[1] + F.m[2] * cof.m[2];
    return {*this, (S(1) / J) * cof, S(constants.mu) - S(constants.lambda) * math::log(J)};
  }

  /// ∂P/∂F = μ I + a T + λ G⊗G with G = F⁻ᵀ, T dF = G dFᵀ G, a = μ - λ ln J. With 1/w <= σ_min(F) and δ <= θ/w the
  /// resolvent identity gives |ΔG| <= k w² δ, k = 1/(1 - θ); |G| <= w in the spectral norm. So
  ///   |ΔT| <= |ΔG| (2 w + |ΔG|),   |Δa| <= |λ| (|G| δ + k w² δ²/2),
  ///   λ_max(G'⊗G' - G⊗G) <= |ΔG| (2 |G| + |ΔG|),
  /// and the tangent moves by |a| |ΔT| + |Δa| (w² + |ΔT|) + |λ| |ΔG| (2 |G| + |ΔG|), all norms but w's Frobenius. w² is
  /// bounded as the largest eigenvalue of GᵀG, by its trace and norm. No eigenvalue is below μ - |a| w² + min(0, λ)
  /// |G|². Theorem 26, docs/theory/tangent_drift.md.
  template <class S>
  RINGWATCH_INLINE TangentDriftCoefficients<S> drift(const Matrix3<S>& F) const {
    constexpr double share = 0.1, k = 1 / (1 - share);  // θ
    const S zero(0.0);
    const auto upright = determinant(F) > zero;
    const Linearization<S> l = linearize(detail::knownOrIdentity(upright, F));
    const S trace2 = innerProduct(l.inverseTranspose, l.inverseTranspose);
    const S w2 = detail::spectralNorm2(l.inverseTranspose), w = math::sqrt(w2);
    const S G = math::sqrt(trace2), a = math::abs(l.a), lambda(math::abs(constants.lambda));
    const S linear = S(2 * k) * a * w * w2 + lambda * G * w2 * S(1 + 2 * k);
    const S quadratic = w2 * w2 * (S(k * k) * (a + lambda) + S(0.5 * k) * lambda) +
                        lambda * (G + S(0.5 * k * share) * w) * S(k * (2 + k * share)) * w2 * w;
    const S negative = math::max(zero, a * w2 - S(constants.mu)) + S(math::max(0.0, -constants.lambda)) * trace2;
    return {zero, select(upright, linear, zero), select(upright, quadratic, zero), select(upright, negative, zero),
            select(upright, S(share) / w, S(-1.0))};
  }
};

}  // namespace ringwatch
