#pragma once
#include <span>
#include <string_view>

#include <ringwatch/base/matrix3.h>
#include <ringwatch/materials/lame.h>
#include <ringwatch/materials/modulus_rounding.h>
#include <ringwatch/materials/tangent_drift.h>

namespace ringwatch {

/// St. Venant–Kirchhoff, E = (FᵀF - I)/2, S = λ tr(E) I + 2μ E:
///   W = μ E:E + λ/2 tr²E,   P = F S,   dP = dF S + F (λ tr(dE) I + 2μ dE),  dE = sym(Fᵀ dF).
struct StVenantKirchhoff {
  static constexpr std::string_view name = "stvk";
  static constexpr std::string_view help =
      "St. Venant-Kirchhoff: linear in the Green strain; softens and collapses under strong compression";
  static constexpr std::span<const OptionInfo> parameters = youngAndPoisson;
  static constexpr bool objective = true, isotropic = true, tangentIsConstant = false;
  static constexpr bool tangentStiffens = true;
  static constexpr bool energyAlongStress = true;
  static constexpr bool definedInverted = true, allowsInversion = false;
  Lame constants;

  static StVenantKirchhoff of(const Options& parameters) { return {lameConstants(parameters)}; }
  static constexpr auto parametersFor = youngAndPoissonOf;
  Lame restModuli() const { return constants; }

  /// Energy density, J/m³, of the deformation gradient F.
  template <class S>
  RINGWATCH_INLINE S energy(const Matrix3<S>& F) const {
    const Matrix3<S> E = greenStrain(F);
    const S t = trace(E);
    return S(constants.mu) * innerProduct(E, E) + S(0.5 * constants.lambda) * t * t;
  }
  /// First Piola–Kirchhoff stress P = ∂W/∂F, Pa.
  template <class S>
  RINGWATCH_INLINE Matrix3<S> stress(const Matrix3<S>& F) const {
    return F * secondStress(greenStrain(F));
  }
  /// The same and tr E, which it has in any case.
  template <class S>
  RINGWATCH_INLINE Matrix3<S> stress(const Matrix3<S>& F, S& traceOfStrain) const {
    const Matrix3<S> E = greenStrain(F);
    traceOfStrain = trace(E);
    return F * secondStress(E);
  }
  /// dF ↦ dP = ∂P/∂F : dF, exact.
  template <class S>
  struct Linearization {
    const StVenantKirchhoff& law;
    Matrix3<S> F, secondStress;
    RINGWATCH_INLINE Matrix3<S> operator()(const Matrix3<S>& dF) const {
      const Matrix3<S> a = transposeTimes(F, dF);
      return dF * secondStress + F * law.secondStress(symmetricPart(a));
    }

    /// weight Σ_KL g_aK g_bL ∂P_iK/∂F_jL, the tangent's 3×3 block of two nodes with shape gradients g: with p = F g,
    ///   (g_a·S g_b) I + λ p_a p_bᵀ + μ p_b p_aᵀ + μ (g_a·g_b) F Fᵀ.
    struct NodeBlocks {
      struct Node {
        S g[3], p[3], Sg[3];
      };
      Matrix3<S> F, stress, muFFt;
      S lambda, mu;
      RINGWATCH_INLINE Node node(const S (&g)[3]) const {
        Node a;
        for (int i = 0; i < 3; ++i) {
          a.g[i] = g[i];
          a.p[i] = F(i, 0) * g[0] + F(i, 1) * g[1] + F(i, 2) * g[2];
          a.Sg[i] = stress(i, 0) * g[0] + stress(i, 1) * g[1] + stress(i, 2) * g[2];
        }
        return a;
      }
      RINGWATCH_INLINE Matrix3<S> operator()(const Node& a, const Node& b) const {
        const S product = a.g[0] * b.g[0] + a.g[1] * b.g[1] + a.g[2] * b.g[2];
        const S geometric = a.g[0] * b.Sg[0] + a.g[1] * b.Sg[1] + a.g[2] * b.Sg[2];
        Matrix3<S> r;
        for (int i = 0; i < 3; ++i) {
          const S lambdaP = lambda * a.p[i], muP = mu * b.p[i];
          for (int j = 0; j < 3; ++j) r(i, j) = lambdaP * b.p[j] + muP * a.p[j] + product * muFFt(i, j);
          r(i, i) += geometric;
        }
        return r;
      }
    };
    RINGWATCH_INLINE NodeBlocks nodeBlocks(const S& weight) const {
      const S mu = weight * S(law.constants.mu);
      return {F, weight * secondStress, mu * timesTranspose(F, F), weight * S(law.constants.lambda), mu};
    }
    /// With m = |λ| + 2μ: |S| <= m (|F|² + 3) √3/2 as a sum of sizes, so that the blocks are at most
    /// m (2.5 |F|² + 4.5); F + Δ, with |F| <= (1 + |F|²)/2, moves S by at most (3|λ| + 2μ) (|F| δ + δ²/2) and the other
    /// terms by m (2 |F| δ + δ²).
    RINGWATCH_INLINE ModulusRounding<S> rounding(const Matrix3<S>& F0, const S& error) const {
      const double m = math::abs(law.constants.lambda) + 2 * law.constants.mu;
      const S F2 = innerProduct(F0, F0), size = S(m) * (S(2.5) * F2 + S(4.5));
      return {size, S(lawRounding * unitRoundoff) * size + S(8 * m) * error * (S(0.5) * (S(1.0) + F2) + error)};
    }
  };
  template <class S>
  RINGWATCH_INLINE Linearization<S> linearize(const Matrix3<S>& F) const {
    return {*this, F, secondStress(greenStrain(F))};
  }

  /// The material part dE:ℂ:dE of dF:∂P/∂F:dF is a squared norm (3λ+2μ >= 0) whose root moves by at most
  /// √(max(0, λ)+2μ) |ΔF| |dF| (Cauchy–Schwarz on tr²(ΔFᵀdF) and |sym(ΔFᵀdF)|²); it exceeds the whole by at most max(0,
  /// -lambda_min(S)). The geometric part dF S : dF moves by lambda_max(ΔS) <= c |ΔE|, c = √((λ+2μ)² + 2λ²), |ΔE| <=
  /// |F|₂ δ + δ²/2. Spectral norms and eigenvalues are bounded by Gershgorin's circles. Theorem 24,
  /// docs/theory/tangent_drift.md.
  template <class S>
  RINGWATCH_INLINE TangentDriftCoefficients<S> drift(const Matrix3<S>& F) const {
    const double lambda = constants.lambda, mu = constants.mu;
    const double c = math::sqrt((lambda + 2 * mu) * (lambda + 2 * mu) + 2 * lambda * lambda);
    const Matrix3<S> E = greenStrain(F), stress = secondStress(E);
    const S zero(0.0);
    S stretch2 = zero, lowest = stress.m[0];
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      stretch2 = math::max(stretch2, S(1.0) + S(2.0) * (E(i, i) + math::abs(E(i, j)) + math::abs(E(i, k))));
      lowest = math::min(lowest, stress(i, i) - math::abs(stress(i, j)) - math::abs(stress(i, k)));
    }
    const S negative = math::max(zero, -lowest) + S(math::max(0.0, -3 * lambda - 2 * mu)) * stretch2;
    // Without a norm, as in a rule's share of λ < 0 alone, there is no bound.
    if (!(3 * lambda + 2 * mu >= 0)) return {zero, zero, zero, negative, S(-1.0)};
    return {S(math::max(0.0, lambda) + 2 * mu), S(c) * math::sqrt(stretch2), S(0.5 * c), negative};
  }

  /// E = (FᵀF - I)/2
  template <class S>
  RINGWATCH_INLINE static Matrix3<S> greenStrain(const Matrix3<S>& F) {
    const S h(0.5), one(1);
    Matrix3<S> E;
    auto c = [&](int i, int j) { return F(0, i) * F(0, j) + F(1, i) * F(1, j) + F(2, i) * F(2, j); };
    E.m[0] = h * (c(0, 0) - one);
    E.m[4] = h * (c(1, 1) - one);
    E.m[8] = h * (c(2, 2) - one);
    E.m[1] = E.m[3] = h * c(0, 1);
    E.m[2] = E.m[6] = h * c(0, 2);
    E.m[5] = E.m[7] = h * c(1, 2);
    return E;
  }
  /// S = λ tr(E) I + 2μ E for a symmetric E, Pa.
  template <class S>
  RINGWATCH_INLINE Matrix3<S> secondStress(const Matrix3<S>& E) const {
    const S twoMu(2 * constants.mu), t = S(constants.lambda) * trace(E);
    Matrix3<S> r;
    r.m[0] = t + twoMu * E.m[0];
    r.m[4] = t + twoMu * E.m[4];
    r.m[8] = t + twoMu * E.m[8];
    r.m[1] = r.m[3] = twoMu * E.m[1];
    r.m[2] = r.m[6] = twoMu * E.m[2];
    r.m[5] = r.m[7] = twoMu * E.m[5];
    return r;
  }

 private:
  template <class S>
  RINGWATCH_INLINE static Matrix3<S> symmetricPart(const Matrix3<S>& a) {
    const S h(0.5);
    Matrix3<S> r;
    r.m[0] = a.m[0];
    r.m[4] = a.m[4];
    r.m[8] = a.m[8];
    r.m[1] = r.m[3] = h * (a.m[1] + a.m[3]);
    r.m[2] = r.m[6] = h * (a.m[2] + a.m[6]);
    r.m[5] = r.m[7] = h * (a.m[5] + a.m[7]);
    return r;
  }
};

}  // namespace ringwatch
