#pragma once
#include <span>
#include <string_view>

#include <ringwatch/base/matrix3.h>
#include <ringwatch/base/rounding.h>
#include <ringwatch/materials/lame.h>
#include <ringwatch/materials/modulus_rounding.h>
#include <ringwatch/materials/rotation.h>
#include <ringwatch/materials/tangent_drift.h>

namespace ringwatch {

/// Corotational linear elasticity as a law on F, with R the rotation closest to F:
///   W = μ |F - R|² + λ/2 tr²(RᵀF - I),   P = 2μ (F - R) + λ tr(RᵀF - I) R.
/// The differential is exact: it contains the turning of R, dR = R [w]×, (tr(U) I - U) w = axial(Rᵀ dF - dFᵀ R),
/// U = sym(RᵀF) (Chao et al. 2010).
struct Corotational {
  static constexpr std::string_view name = "corotational";
  static constexpr std::string_view help = "linear elasticity in a frame that turns with the element";
  static constexpr std::span<const OptionInfo> parameters = youngAndPoisson;
  static constexpr bool objective = true, isotropic = true, tangentIsConstant = false;
  /// ∂P/∂F exceeds the turned tangent at rest by its part on spins alone, 2μ + 2 (λ (tr U - 3) - 2μ)/(sum of two
  /// stretches), where the turned tangent has nothing that could be scaled, and its highest eigenvalue stays 3λ + 2μ
  /// while three times that sum exceeds 2 (tr U - 3).
  static constexpr bool tangentStiffens = false;
  static constexpr bool definedInverted = true, allowsInversion = false;
  Lame constants;

  static Corotational of(const Options& parameters) { return {lameConstants(parameters)}; }
  static constexpr auto parametersFor = youngAndPoissonOf;
  Lame restModuli() const { return constants; }

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

    /// weight Σ_KL g_aK g_bL ∂P_iK/∂F_jL, the tangent's 3×3 block of two nodes with shape gradients g: with r = R g and
    /// G = R (tr(U) I - U)⁻¹ Rᵀ,
    ///   2μ (g_a·g_b) I + λ r_a r_bᵀ - (λ tr(RᵀF - I) - 2μ) [r_a]× G [r_b]×.
    struct NodeBlocks {
      struct Node {
        S g[3], r[3];
        Matrix3<S> turn;  // G [r]×
      };
      Matrix3<S> R, G;  // G with its factor
      S lambda, twoMu;
      RINGWATCH_INLINE Node node(const S (&g)[3]) const {
        Node a;
        for (int i = 0; i < 3; ++i) {
          a.g[i] = g[i];
          a.r[i] = R(i, 0) * g[0] + R(i, 1) * g[1] + R(i, 2) * g[2];
        }
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j) {
            const int k = (j + 1) % 3, l = (j + 2) % 3;  // [r]×: column j holds r_l in row k and -r_k in row l
            a.turn(i, j) = G(i, k) * a.r[l] - G(i, l) * a.r[k];
          }
        return a;
      }
      RINGWATCH_INLINE Matrix3<S> operator()(const Node& a, const Node& b) const {
        const S product = twoMu * (a.g[0] * b.g[0] + a.g[1] * b.g[1] + a.g[2] * b.g[2]);
        Matrix3<S> r;
        for (int i = 0; i < 3; ++i) {
          const S lambdaR = lambda * a.r[i];
          const int k = (i + 1) % 3, l = (i + 2) % 3;
          for (int j = 0; j < 3; ++j) r(i, j) = lambdaR * b.r[j] + a.r[l] * b.turn(k, j) - a.r[k] * b.turn(l, j);
          r(i, i) += product;
        }
        return r;
      }
    };
    RINGWATCH_INLINE NodeBlocks nodeBlocks(const S& weight) const {
      return {R, (weight * t) * timesTranspose(R * spin, R), weight * S(law.constants.lambda),
              weight * S(2 * law.constants.mu)};
    }
    /// A posteriori: R is the rotation closest to R sym(RᵀF), from which F lies away by the skew part of RᵀF. So R errs
    /// by at most 2 ρ / (g - √2 ρ), ρ that part and what F errs by, 1/g = |(tr(U) I - U)⁻¹|, as in drift below. U and
    /// the inverse of tr(U) I - U move with it. Infinite where R is not unique to rounding.
    RINGWATCH_INLINE ModulusRounding<S> rounding(const Matrix3<S>& F, const S& error) const {
      const Matrix3<S> A = transposeTimes(R, F), off = transposeTimes(R, R) - Matrix3<S>::identity();
      const S k0 = A.m[7] - A.m[5], k1 = A.m[2] - A.m[6], k2 = A.m[3] - A.m[1];
      const S skew = math::sqrt(S(0.5) * (k0 * k0 + k1 * k1 + k2 * k2)), f = math::sqrt(innerProduct(F, F));
      const S oblique = math::sqrt(innerProduct(off, off)) + S(8 * unitRoundoff);
      const S rho = skew + error + S(2.0) * f * oblique, spinNorm = S(1.1) * math::sqrt(innerProduct(spin, spin));
      const S minor = spin.m[0] * spin.m[4] - spin.m[1] * spin.m[3], det = determinant(spin);
      const S dR = S(2.3) * spinNorm * rho + oblique;
      const S dU = S(2.0) * error + f * dR + S(8 * unitRoundoff) * f;
      const S z = S(27.0) * f * f * f * det;  // |tr(U) I - U|³ over its determinant, at most
      const auto unique = (spin.m[0] > S(0.0)) & (minor > S(0.0)) & (det > S(0.0)) & (spinNorm * rho < S(0.03)) &
                          (spinNorm * dU < S(0.03)) & (S(unitRoundoff) * z < S(1e-3));
      const S dSpin = spinNorm * (S(4.0) * spinNorm * dU + S(unitRoundoff) * (S(5.0) * z + S(4.0)));
      const S lambda(math::abs(law.constants.lambda)), absolute = math::abs(t);
      const S dt =
          lambda * (S(2.0) * error + f * dR + S(8 * unitRoundoff) * (f + S(1.0))) + S(4 * unitRoundoff) * absolute;
      const S size = lambda + S(4 * law.constants.mu) + absolute * spinNorm;
      return {size, detail::knownOnly(unique, S(lawRounding * unitRoundoff) * size + S(2.5) * lambda * dR +
                                                  absolute * (S(2.5) * spinNorm * dR + S(1.1) * dSpin) +
                                                  S(1.1) * spinNorm * dt)};
    }
  };
  template <class S>
  RINGWATCH_INLINE Linearization<S> linearize(const Matrix3<S>& F) const {
    const Matrix3<S> R = closestRotation(F), a = transposeTimes(R, F);
    const Matrix3<S> U = S(0.5) * (a + transpose(a));
    return {*this, R, inverse(Matrix3<S>::diagonal(trace(U)) - U),
            S(constants.lambda) * (trace(U) - S(3)) - S(2 * constants.mu)};
  }

  /// ∂P/∂F = 2μ I + λ R⊗R + t H with s = tr(U), t = λ (s - 3) - 2μ and H = ∂R/∂F. H = ∂²s/∂F² has the norm 2/g, g the
  /// sum of the two least stretches, signed. For |ΔF| <= δ:
  ///   - signed singular values move by at most |ΔF| as a vector (Miranda & Thompson 1993): g' >= g - √2 δ;
  ///   - |ΔR| <= 2 δ / (g - √2 δ), and λ_max(R'⊗R' - R⊗R) <= √3 |ΔR| for vectors of equal norm √3;
  ///   - |Δt| <= √3 |λ| δ;
  ///   - H = R J (tr(U) I - U)⁻¹ Jᵀ Rᵀ, J w = [w]×, changes by at most 2√2/g² times the symmetric and the skew part of
  ///     Rᵀ dF, so that |dH| <= 4 |dF| / g². The factor 4√2 + 4 below is larger than it need be.
  /// With g - √2 δ >= q g inside the radius these sum up to linear δ + quadratic δ². A lower bound of g follows from s
  /// and |F|²: the largest of three numbers of mean s/3 lies at most √(2/3) of their deviation |U - s/3 I| above it.
  /// The least eigenvalue is at least 2μ + min(0, 3λ, 2 t/g), since H R = 0. Theorem 25,
  /// docs/theory/tangent_drift.md.
  template <class S>
  RINGWATCH_INLINE TangentDriftCoefficients<S> drift(const Matrix3<S>& F) const {
    constexpr double root2 = 1.4142135623730951, root3 = 1.7320508075688773;
    constexpr double share = 0.1, q = 1 - root2 * share;  // of g, that the radius spends
    const S zero(0.0), s = innerProduct(closestRotation(F), F), size2 = innerProduct(F, F);
    const S spread = math::sqrt(math::max(zero, size2 - s * s * S(1.0 / 3.0)) * S(2.0 / 3.0));
    const S least = S(2.0 / 3.0) * s - spread - S(leastGapRounding) * math::sqrt(size2);
    const auto bounded = least > zero;
    const S g = select(bounded, least, S(1.0)), twoOverG = S(2.0) / g;
    const double lambda = math::abs(constants.lambda);
    const S t = S(constants.lambda) * (s - S(3.0)) - S(2 * constants.mu), dH = S((4 * root2 + 4) / q) / (g * g);
    const S negative = math::max(zero, S(-2 * constants.mu) - math::min(S(3 * constants.lambda), t * twoOverG));
    return {zero, S(root3 * lambda * (1 + 1 / q)) * twoOverG + math::abs(t) * dH, S(root3 * lambda) * dH,
            select(bounded, negative, zero), select(bounded, S(share) * g, S(-1.0))};
  }
};

}  // namespace ringwatch
