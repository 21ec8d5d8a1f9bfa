#pragma once
#include <span>
#include <string_view>

#include <ringwatch/base/matrix3.h>
#include <ringwatch/base/rounding.h>
#include <ringwatch/materials/lame.h>
#include <ringwatch/materials/modulus_rounding.h>
#include <ringwatch/materials/tangent_drift.h>
#include <ringwatch/materials/volume_energy.h>

namespace ringwatch {

/// Stable neo-Hookean (Smith, de Goes & Kim 2018, eq. 14), I = |F|², J = det F:
///   W = m/2 (I - 3 - ln((I + 1)/4)) - 3/4 m (J - 1) + l/2 (J - 1)²,   m = 4/3 μ,  l = λ + 5/6 μ > 0,
///   P = m I/(I + 1) F + (l (J - 1) - 3/4 m) cof F.
/// A number for every F, inverted and flat ones included.
struct StableNeoHookean {
  static constexpr std::string_view name = "stable-neo-hookean";
  static constexpr std::string_view help = "stable neo-Hookean: stays finite and recovers when an element inverts";
  static constexpr std::span<const OptionInfo> parameters = youngAndPoisson;
  static constexpr bool objective = true, isotropic = true, tangentIsConstant = false;
  static constexpr bool tangentStiffens = true;
  static constexpr bool energyAlongStress = true;
  static constexpr bool definedInverted = true, allowsInversion = true;
  Lame constants;

  static StableNeoHookean of(const Options& parameters) { return {lameConstants(parameters)}; }
  static constexpr auto parametersFor = youngAndPoissonOf;
  Lame restModuli() const { return constants; }
  RINGWATCH_HOST_DEVICE double m() const { return 4.0 / 3.0 * constants.mu; }
  RINGWATCH_HOST_DEVICE double l() const { return constants.lambda + 5.0 / 6.0 * constants.mu; }

  /// Energy density, J/m³, of the deformation gradient F.
  template <class S>
  RINGWATCH_INLINE S energy(const Matrix3<S>& F) const {
    const S I = innerProduct(F, F), volume = determinant(F) - S(1);
    return S(0.5 * m()) * (I - S(3) - math::log(S(0.25) * (I + S(1)))) +
           volume * (S(0.5 * l()) * volume - S(0.75 * m()));
  }
  /// First Piola–Kirchhoff stress P = ∂W/∂F, Pa.
  template <class S>
  RINGWATCH_INLINE Matrix3<S> stress(const Matrix3<S>& F) const {
    const Linearization<S> at = linearize(F);
    return at.shear * F + at.pressure * at.cof;
  }
  /// dF ↦ dP = a dF + 2m/(I+1)² (F : dF) F + l (cof F : dF) cof F + c ∂cof/∂F dF, a = m I/(I+1), c = l (J-1) - 3/4 m.
  template <class S>
  struct Linearization {
    const StableNeoHookean& law;
    Matrix3<S> F, cof;
    S shear, softening, pressure;  // a, 2m/(I+1)², c
    RINGWATCH_INLINE Matrix3<S> operator()(const Matrix3<S>& dF) const {
      return shear * dF + (softening * innerProduct(F, dF)) * F + (S(law.l()) * innerProduct(cof, dF)) * cof +
             pressure * cofactorDifferential(F, dF);
    }

    /// weight Σ_KL g_aK g_bL ∂P_iK/∂F_jL, the tangent's 3×3 block of two nodes with shape gradients g: with p = F g,
    /// q = cof(F) g and r = F (g_a × g_b), a (g_a·g_b) I + 2m/(I+1)² p_a p_bᵀ + l q_a q_bᵀ - c [r]×.
    struct NodeBlocks {
      struct Node {
        S g[3], p[3], q[3];
      };
      Matrix3<S> F, cof;
      S shear, softening, l, pressure;
      RINGWATCH_INLINE Node node(const S (&g)[3]) const {
        Node r;
        for (int i = 0; i < 3; ++i) {
          r.g[i] = g[i];
          r.p[i] = F(i, 0) * g[0] + F(i, 1) * g[1] + F(i, 2) * g[2];
          r.q[i] = cof(i, 0) * g[0] + cof(i, 1) * g[1] + cof(i, 2) * g[2];
        }
        return r;
      }
      RINGWATCH_INLINE Matrix3<S> operator()(const Node& a, const Node& b) const {
        const S product = shear * (a.g[0] * b.g[0] + a.g[1] * b.g[1] + a.g[2] * b.g[2]);
        const S cross[3] = {a.g[1] * b.g[2] - a.g[2] * b.g[1], a.g[2] * b.g[0] - a.g[0] * b.g[2],
                            a.g[0] * b.g[1] - a.g[1] * b.g[0]};
        S turned[3];
        for (int i = 0; i < 3; ++i)
          turned[i] = pressure * (F(i, 0) * cross[0] + F(i, 1) * cross[1] + F(i, 2) * cross[2]);
        Matrix3<S> r;
        for (int i = 0; i < 3; ++i) {
          const S soft = softening * a.p[i], stiff = l * a.q[i];
          for (int j = 0; j < 3; ++j) r(i, j) = soft * b.p[j] + stiff * b.q[j];
          r(i, i) += product;
        }
        for (int i = 0; i < 3; ++i) {
          const int j = (i + 1) % 3, k = (i + 2) % 3;
          r(i, j) += turned[k];
          r(j, i) -= turned[k];
        }
        return r;
      }
    };
    RINGWATCH_INLINE NodeBlocks nodeBlocks(const S& weight) const {
      return {F, cof, weight * shear, weight * softening, weight * S(law.l()), weight * pressure};
    }
    /// The sum of the sizes of all terms; J and cof F are sums of products of entries of F. An error of the gradient
    /// moves the tangent by at most the largest third derivative of W times it.
    RINGWATCH_INLINE ModulusRounding<S> rounding(const Matrix3<S>& F0, const S& error) const {
      const S I = innerProduct(F0, F0), f = math::sqrt(I), size3 = S(1.0) + I * f;
      const S l(math::abs(law.l())), m(law.m());
      const S size = S(3.0) * m + l * I * I + (l * size3 + m) * f;
      const S third = law.thirdDerivative(F0, pressure, error);
      return {size, detail::knownOnly(error <= S(largestError), S(lawRounding * unitRoundoff) * size + third * error)};
    }
  };
  template <class S>
  RINGWATCH_INLINE Linearization<S> linearize(const Matrix3<S>& F) const {
    const Matrix3<S> cof = cofactor(F);
    const S J = F.m[0] * cof.m[0] + F.m[1] * cof.m[1] + F.m[2] * cof.m[2];
    const S I = innerProduct(F, F), inverse = S(1) / (I + S(1));
    return {*this, F, cof, S(m()) * I * inverse, S(2 * m()) * inverse * inverse, S(l()) * (J - S(1)) - S(0.75 * m())};
  }

  /// The tangent is the second derivative of W, so within a ball it moves by at most the largest third derivative there
  /// times the distance. With c = l (J - 1) - 3/4 m it has no eigenvalue below a - 2 c s₁ - max(0, -l) |cof F|² for
  /// c > 0, and for c <= 0 < J none below a - |c| s₁ - max(0, |c|/J - l) |cof F|². Theorems 49 and 51,
  /// docs/theory/tangent_drift.md.
  template <class S>
  RINGWATCH_INLINE TangentDriftCoefficients<S> drift(const Matrix3<S>& F) const {
    const S zero(0.0), radius(largestError);
    const Linearization<S> at = linearize(F);
    const S J = determinant(F), cof2 = innerProduct(at.cof, at.cof), stretch = largestStretch(F), rate(l());
    const S c = math::abs(at.pressure), indefinite = math::max(zero, -rate) * cof2;
    const S any = S(2.0) * c * stretch + indefinite;
    const S upright = c * stretch + math::max(zero, c / math::max(J, S(smallestVolume)) - rate) * cof2;
    const auto compressed = (at.pressure <= zero) & (J > S(smallestVolume));
    const S negative = math::max(zero, select(compressed, math::min(any, upright), any) - at.shear);
    return {zero, thirdDerivative(F, at.pressure, radius), zero, negative, radius};
  }

 private:
  /// The bounds reach as far: a tenth of a stretch. Below a tenth of its volume an element counts as flat.
  static constexpr double largestError = 0.1, smallestVolume = 0.1;

  /// An upper bound of |D³W| on the ball of that radius around F, Pa: of the shear part it is 6 m |F|/(I + 1)².
  template <class S>
  RINGWATCH_INLINE S thirdDerivative(const Matrix3<S>& F, const S& pressure, const S& radius) const {
    const S f = math::sqrt(innerProduct(F, F)), least = math::max(S(0.0), f - radius), q = S(1.0) + least * least;
    return S(6 * m()) * (f + radius) / (q * q) + volumeThirdDerivative(S(l()), pressure, F, radius);
  }
  /// ∂cof/∂F : dF, row by row the sums of cross products of a row of F with one of dF.
  template <class S>
  RINGWATCH_INLINE static Matrix3<S> cofactorDifferential(const Matrix3<S>& F, const Matrix3<S>& dF) {
    Matrix3<S> r;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
        r(i, j) = F(i1, j1) * dF(i2, j2) + dF(i1, j1) * F(i2, j2) - F(i1, j2) * dF(i2, j1) - dF(i1, j2) * F(i2, j1);
      }
    return r;
  }
};

}  // namespace ringwatch
