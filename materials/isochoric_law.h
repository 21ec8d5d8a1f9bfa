#pragma once
#include <limits>

#include <ringwatch/base/matrix3.h>
#include <ringwatch/base/rounding.h>
#include <ringwatch/materials/inverse_norm.h>
#include <ringwatch/materials/lame.h>
#include <ringwatch/materials/modulus_rounding.h>
#include <ringwatch/materials/tangent_drift.h>
#include <ringwatch/materials/volume_energy.h>

namespace ringwatch {

/// Polynomials in the isochoric invariants and a quadratic energy of volume, as rubber is fitted by (Bonet & Wood 2008,
/// §6.5; the forms *HYPERELASTIC of CalculiX and its relatives), J = det F:
///   W = c10 (Ī1 - 3) + c20 (Ī1 - 3)² + c30 (Ī1 - 3)³ + c01 (Ī2 - 3) + K/2 (J - 1)²,
///   Ī1 = J^(-2/3) |F|²,   Ī2 = J^(-4/3) |cof F|².
/// With G = F⁻ᵀ, b = |G|², M = G Gᵀ G: ∂Ī1/∂F = 2 J^(-2/3) (F - |F|²/3 G), ∂Ī2/∂F = J^(2/3) (2/3 b G - 2 M), and
/// Ī2 = J^(2/3) b. Undefined for J <= 0: energy and stress are NaN there, which the monitor reports as an inverted
/// element. Own is the law that derives from it; terms that it has not are not computed.
template <class Own, bool hasPowers, bool hasSecond>
struct IsochoricLaw {
  static constexpr bool objective = true, isotropic = true, tangentIsConstant = false, tangentStiffens = true;
  static constexpr bool energyAlongStress = true;
  static constexpr bool definedInverted = false, allowsInversion = false;
  double c10, c20, c30, c01;  // Pa
  double bulk;                // K, Pa

  /// Moduli of the linearisation at rest: μ = 2 (c10 + c01), λ = K - 2/3 μ.
  Lame restModuli() const {
    const double mu = 2 * (c10 + c01);
    return {bulk - 2.0 / 3.0 * mu, mu};
  }
  /// The share `lambda` of the energy of volume and `mu` of the isochoric one: what a selective rule integrates apart.
  Own withShares(double lambda, double mu) const {
    Own share = static_cast<const Own&>(*this);
    share.c10 *= mu;
    share.c20 *= mu;
    share.c30 *= mu;
    share.c01 *= mu;
    share.bulk *= lambda;
    return share;
  }

  /// Energy density, J/m³, of the deformation gradient F.
  template <class S>
  RINGWATCH_INLINE S energy(const Matrix3<S>& F) const {
    const S J = determinant(F), s = isochoricScale(J), x = s * innerProduct(F, F) - S(3);
    S W = S(c10) * x + S(0.5 * bulk) * (J - S(1)) * (J - S(1));
    if constexpr (hasPowers) W += x * x * (S(c20) + S(c30) * x);
    if constexpr (hasSecond) {
      const Matrix3<S> cof = cofactor(F);
      W += S(c01) * (s * s * innerProduct(cof, cof) - S(3));
    }
    return W;
  }
  /// First Piola–Kirchhoff stress P = ∂W/∂F, Pa.
  template <class S>
  RINGWATCH_INLINE Matrix3<S> stress(const Matrix3<S>& F) const {
    const Linearization<S> l = linearize(F);
    Matrix3<S> P = l.slope * l.first + (S(bulk) * l.J * (l.J - S(1))) * l.inverseTranspose;
    if constexpr (hasSecond) P = P + S(c01) * l.second;
    return P;
  }
  /// dF ↦ dP, exact. With p = G : dF and T = G dFᵀ G = -dG:
  ///   d(∂Ī1/∂F) = -2/3 p ∂Ī1/∂F + 2 J^(-2/3) (dF - 2/3 (F : dF) G + |F|²/3 T),
  ///   d(∂Ī2/∂F) = 2/3 p ∂Ī2/∂F + J^(2/3) (2 (T Gᵀ G + G Tᵀ G + G Gᵀ T) - 4/3 (G : T) G - 2/3 b T).
  template <class S>
  struct Linearization {
    const Own& law;
    Matrix3<S> F, inverseTranspose, first, second;  // G, ∂Ī1/∂F, ∂Ī2/∂F
    S J, s, I1, b;                                  // s = J^(-2/3)
    S slope, curvature;                             // of the polynomial in Ī1
    RINGWATCH_INLINE Matrix3<S> operator()(const Matrix3<S>& dF) const {
      const Matrix3<S>& G = inverseTranspose;
      const S p = innerProduct(G, dF);
      const Matrix3<S> T = timesTranspose(G, dF) * G;
      const S two = S(2) * s * slope, K(law.bulk);
      S ofFirst = S(-2.0 / 3.0) * slope * p, ofG = K * J * (S(2) * J - S(1)) * p, ofT = S(1.0 / 3.0) * two * I1;
      ofG -= S(2.0 / 3.0) * two * innerProduct(F, dF);
      ofT -= K * J * (J - S(1));
      if constexpr (hasPowers) ofFirst += curvature * innerProduct(first, dF);
      Matrix3<S> dP = two * dF + ofFirst * first;
      if constexpr (hasSecond) {
        const S t = S(law.c01) / s;
        const Matrix3<S> TGt = timesTranspose(T, G), GGt = timesTranspose(G, G);
        dP =
            dP + (S(2.0 / 3.0) * S(law.c01) * p) * second + (S(2) * t) * (TGt * G + timesTranspose(G, T) * G + GGt * T);
        ofG -= S(4.0 / 3.0) * t * innerProduct(G, T);
        ofT -= S(2.0 / 3.0) * t * b;
      }
      return dP + ofG * G + ofT * T;
    }

    /// Every term is a product of at most eight computed factors, each off by what G is, relatively; the sum of the
    /// sizes of all terms is `size`. An error of the gradient moves the tangent by at most the largest third derivative
    /// of W times it. Unknown where the error is not small.
    RINGWATCH_INLINE ModulusRounding<S> rounding(const Matrix3<S>& F0, const S& error) const {
      const auto exact = detail::inverseRounding(F0, inverseTranspose, S(0.0));
      const S F2 = innerProduct(F0, F0), G2 = exact.norm2, f = math::sqrt(F2), g = math::sqrt(G2);
      const S slopeSize = law.slopeSize(s * F2 + S(3.0)), d1 = S(2.0) * s * (f + S(1.0 / 3.0) * F2 * g);
      S size =
          slopeSize * (S(2.0 / 3.0) * g * d1 + S(2.0) * s * (S(1.0) + S(2.0 / 3.0) * f * g + S(1.0 / 3.0) * F2 * G2)) +
          S(law.bulk) * J * (S(3.0) * J + S(2.0)) * G2;
      if constexpr (hasPowers) size += law.curvatureSize(s * F2 + S(3.0)) * d1 * d1;
      if constexpr (hasSecond) size += S(math::abs(law.c01)) / s * G2 * G2 * S(8.0 / 3.0 * 2.0 / 3.0 + 8.0);
      const detail::DriftBall<S> ball = detail::driftBall(inverseTranspose);
      const S factors = S(8.0) * exact.relative + S(3 * lawRounding * unitRoundoff);
      return {size, detail::knownOnly(error <= ball.radius, size * factors + law.thirdDerivative(*this, ball) * error)};
    }
  };
  template <class S>
  RINGWATCH_INLINE Linearization<S> linearize(const Matrix3<S>& F) const {
    const Matrix3<S> cof = cofactor(F);
    const S J = F.m[0] * cof.m[0] + F.m[1] * cof.m[1] + F.m[2] * cof.m[2], s = isochoricScale(J);
    const S I1 = innerProduct(F, F), x = s * I1 - S(3);
    const Matrix3<S> G = (S(1) / J) * cof;
    Linearization<S> l{static_cast<const Own&>(*this),
                       F,
                       G,
                       (S(2) * s) * (F - (S(1.0 / 3.0) * I1) * G),
                       Matrix3<S>::zero(),
                       J,
                       s,
                       I1,
                       S(0),
                       S(c10),
                       S(0)};
    if constexpr (hasPowers) {
      l.slope += x * (S(2 * c20) + S(3 * c30) * x);
      l.curvature = S(2 * c20) + S(6 * c30) * x;
    }
    if constexpr (hasSecond) {
      l.b = innerProduct(G, G);
      l.second = (S(1) / s) * ((S(2.0 / 3.0) * l.b) * G - S(2) * (timesTranspose(G, G) * G));
    }
    return l;
  }

  /// The tangent is the second derivative of W, so within a ball it moves by at most the largest third derivative there
  /// times the distance: Theorems 49 and 50, docs/theory/tangent_drift.md.
  template <class S>
  RINGWATCH_INLINE TangentDriftCoefficients<S> drift(const Matrix3<S>& F) const {
    const S zero(0.0);
    const auto upright = determinant(F) > zero;
    const Linearization<S> l = linearize(detail::knownOrIdentity(upright, F));
    const detail::DriftBall<S> ball = detail::driftBall(l.inverseTranspose);
    return {zero, select(upright, thirdDerivative(l, ball), zero), zero, select(upright, mostNegative(l, ball), zero),
            select(upright, ball.radius, S(-1.0))};
  }

 private:
  /// J^(-2/3), NaN for J <= 0.
  template <class S>
  RINGWATCH_INLINE static S isochoricScale(const S& J) {
    const S root = math::cbrt(J);
    return select(J > S(0.0), S(1) / (root * root), S(std::numeric_limits<double>::quiet_NaN()));
  }
  /// What the polynomial's first and second derivatives are at most, for |Ī1 - 3| <= x.
  template <class S>
  RINGWATCH_INLINE S slopeSize(const S& x) const {
    S size(math::abs(c10));
    if constexpr (hasPowers) size += x * (S(2 * math::abs(c20)) + S(3 * math::abs(c30)) * x);
    return size;
  }
  template <class S>
  RINGWATCH_INLINE S curvatureSize(const S& x) const {
    return S(2 * math::abs(c20)) + S(6 * math::abs(c30)) * x;
  }

  /// An upper bound of the third derivative of W within a ball, Pa. Theorem 50.
  template <class S>
  RINGWATCH_INLINE S thirdDerivative(const Linearization<S>& l, const detail::DriftBall<S>& ball) const {
    constexpr double theta = detail::driftBallShare, k = 1 / (1 - theta), x = k * theta;
    const S third(1.0 / 3.0), G = math::sqrt(ball.inverse2), F = math::sqrt(l.I1);
    // In the ball: s and I1, |G|, ‖G‖, the oblique projection's norm squared, and how far ∂Ī1/∂F is off.
    const S s = S(k * k) * l.s, I1 = S((1 + theta) * (1 + theta)) * l.I1, P = S(k) * G, w = S(k) * ball.w;
    const S projection = third * S(k * (1 + theta)) * F * G, N = projection * projection;
    const S e = math::sqrt(innerProduct(l.first, l.first)) / (S(2.0) * l.s) + ball.radius +
                third * P * ((S(2.0) * F + ball.radius) * ball.radius + l.I1 * S(theta));
    const S one = S(2.0) * s * e, two = S(2.0) * s * (N + third * I1 * w * w + S(2.0 / 3.0) * P * e);
    const S three = S(4.0) * s * (third * P * P * e + P * N + third * I1 * w * w * (P + w) + e * w * w);
    S bound = volumeThirdDerivative(S(bulk), S(bulk) * (l.J - S(1.0)), l.F, ball.radius);
    if constexpr (hasPowers) {
      const S most = s * I1 - S(3.0);
      bound +=
          slopeSize(most) * three + S(3.0) * curvatureSize(most) * one * two + S(6 * math::abs(c30)) * one * one * one;
    } else {
      bound += S(math::abs(c10)) * three;
    }
    if constexpr (hasSecond) {
      constexpr double cubed = (1 + x) * (1 + x) * (1 + x) - 1;
      const S b = S(k * k) * ball.inverse2, t = S((1 + theta) * (1 + theta)) / l.s, w2 = w * w;
      const S E = math::sqrt(innerProduct(l.second, l.second)) * l.s +
                  S(cubed) * G * (S(2.0) * ball.w * ball.w + S(2.0 / 3.0) * ball.inverse2);
      bound += S(math::abs(c01)) * t *
               (S(2.0 / 3.0) * P * P * E + S(4.0) * P * w2 * (S(3.0) * w2 + third * b) +
                w2 * (S(24.0) * w2 * w + S(2.0) * E + S(4.0 / 3.0) * b * w));
    }
    return bound;
  }

  /// ν: no eigenvalue of ∂P/∂F is below -ν. Theorem 50.
  template <class S>
  RINGWATCH_INLINE S mostNegative(const Linearization<S>& l, const detail::DriftBall<S>& ball) const {
    const S zero(0.0), third(1.0 / 3.0), w2 = ball.w * ball.w, P = math::sqrt(ball.inverse2);
    const S slope = math::max(zero, l.slope), e = math::sqrt(innerProduct(l.first, l.first));
    // What D²Ī1 takes away, and, as |G|² times a factor, what a slope or a curvature below zero does.
    const Matrix3<S> C = transposeTimes(l.F, l.F);
    S negative = slope * (S(2.0) * l.s * deviatorNorm(C) * w2 + S(2.0 / 3.0) * P * e);
    S stiffness = S(4.0) * third * slope * l.s * l.I1;  // of |sym Z|²
    const S projection = third * math::sqrt(l.I1) * P;
    negative += math::max(zero, -l.slope) *
                (S(2.0) * l.s * (projection * projection + third * l.I1 * w2) + S(2.0 / 3.0) * P * e);
    if constexpr (hasPowers) negative += math::max(zero, -l.curvature) * e * e;
    if constexpr (hasSecond) {
      const Matrix3<S> D = timesTranspose(transpose(l.inverseTranspose), transpose(l.inverseTranspose));
      const S t = S(1.0) / l.s, E = math::sqrt(innerProduct(l.second, l.second)), c(c01);
      const S all = S(2.0) * t * w2 * (S(3.0) * w2 + third * l.b) + S(2.0 / 3.0) * P * E;
      negative +=
          math::max(zero, c) * (S(6.0) * t * deviatorNorm(D) * w2 + S(2.0 / 3.0) * P * E) + math::max(zero, -c) * all;
      stiffness += math::max(zero, c) * S(4.0) * third * t * l.b;
    }
    const S pressure = S(bulk) * (l.J - S(1.0)), J = l.J, G2J2 = ball.inverse2 * J * J;  // |cof F|²
    const S stretched = math::max(zero, pressure * J - stiffness) * w2;
    const S compressed = -pressure * largestStretch(l.F) + math::max(zero, -pressure / J - S(bulk)) * G2J2;
    return negative + select(pressure > zero, stretched, compressed);
  }
  /// |A - tr(A)/3 I| of a symmetric A.
  template <class S>
  RINGWATCH_INLINE static S deviatorNorm(const Matrix3<S>& A) {
    const S third = trace(A) * S(1.0 / 3.0);
    return math::sqrt(math::max(S(0.0), innerProduct(A, A) - S(3.0) * third * third));
  }
};

}  // namespace ringwatch
