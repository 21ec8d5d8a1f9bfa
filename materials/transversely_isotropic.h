#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <string_view>

#include <ringwatch/base/error.h>
#include <ringwatch/base/matrix3.h>
#include <ringwatch/base/rounding.h>
#include <ringwatch/materials/lame.h>
#include <ringwatch/materials/modulus_rounding.h>
#include <ringwatch/materials/st_venant_kirchhoff.h>
#include <ringwatch/materials/tangent_drift.h>
#include <ringwatch/materials/volume_energy.h>

namespace ringwatch {

/// Transversely isotropic St. Venant–Kirchhoff with the axis a, |a| = 1, E = (FᵀF - I)/2 (Spencer 1984):
///   W = λ/2 tr²E + μ E:E + α (a·E a) tr E + 2 (μa - μ) |E a|² + β/2 (a·E a)²,   P = F S,  S = ∂W/∂E = ℂ E.
/// Made of the five engineering constants of fibre composites, wood or muscle.
struct TransverselyIsotropic {
  static constexpr std::string_view name = "transversely-isotropic";
  static constexpr std::string_view help =
      "transversely isotropic St. Venant-Kirchhoff: one axis of its own, as of fibres; linear in the Green strain";
  static constexpr std::array parameterTable{
      OptionInfo{
          .name = "young_axial", .unit = "Pa", .range = NumberRange::positive(), .help = "Young's modulus on the axis"},
      OptionInfo{.name = "young_transverse",
                 .unit = "Pa",
                 .range = NumberRange::positive(),
                 .help = "Young's modulus across the axis"},
      OptionInfo{.name = "poisson_axial",
                 .help = "contraction across the axis under a pull along it; < sqrt(young_axial/young_transverse (1 - "
                         "poisson_transverse)/2)"},
      OptionInfo{.name = "poisson_transverse",
                 .range = {-1, 1, false, false},
                 .help = "contraction across the axis under a pull across it"},
      OptionInfo{.name = "shear_axial",
                 .unit = "Pa",
                 .range = NumberRange::positive(),
                 .help = "shear modulus along the axis"},
      OptionInfo{.name = "axis_x", .fallback = "1", .help = "direction of the axis at rest, of any length"},
      OptionInfo{.name = "axis_y", .fallback = "0", .help = "see axis_x"},
      OptionInfo{.name = "axis_z", .fallback = "0", .help = "see axis_x"}};
  static constexpr std::span<const OptionInfo> parameters = parameterTable;
  static constexpr bool objective = true, isotropic = false, tangentIsConstant = false;
  static constexpr bool tangentStiffens = true;
  static constexpr bool definedInverted = true, allowsInversion = false;
  double lambda, mu, alpha, axialMu, beta;  // Pa; axialMu is μa
  double axis[3];

  /// Throws InputError where the constants have no positive definite stiffness or the axis no direction.
  static TransverselyIsotropic of(const Options& parameters) {
    const double Ea = parameters.number("young_axial"), Et = parameters.number("young_transverse"),
                 na = parameters.number("poisson_axial"), nt = parameters.number("poisson_transverse");
    const double across = (1 - nt) / Et, determinant = across / Ea - 2 * na * na / (Ea * Ea);
    if (!(determinant > 0))
      throw InputError(joinText("poisson_axial = ", na, ": must be < ", std::sqrt(0.5 * Ea * across), " in size with ",
                                "these moduli, or the stiffness is not positive definite"));
    TransverselyIsotropic law;
    // Stiffnesses by axes: C11 along a, C12 = λ + α between a and across, C22 + C23 = 2 (λ + μ) across.
    const double C11 = across / determinant, C12 = na / (Ea * determinant);
    law.mu = Et / (2 * (1 + nt));
    law.axialMu = parameters.number("shear_axial");
    law.lambda = 0.5 / (Ea * determinant) - law.mu;
    law.alpha = C12 - law.lambda;
    law.beta = C11 - law.lambda - 2 * law.alpha - 4 * law.axialMu + 2 * law.mu;
    const double a[3] = {parameters.number("axis_x"), parameters.number("axis_y"), parameters.number("axis_z")};
    const double length = std::hypot(a[0], a[1], a[2]);
    if (!(length > 0) || !std::isfinite(length))
      throw InputError(joinText("axis_x, axis_y, axis_z = ", a[0], ", ", a[1], ", ", a[2],
                                ": must be a direction, three finite numbers that are not all 0"));
    for (int i = 0; i < 3; ++i) law.axis[i] = a[i] / length;
    return law;
  }
  /// The isotropic one.
  static Options parametersFor(double young, double poisson) {
    return {{"young_axial", young},
            {"young_transverse", young},
            {"poisson_axial", poisson},
            {"poisson_transverse", poisson},
            {"shear_axial", young / (2 * (1 + poisson))},
            {"axis_x", 1},
            {"axis_y", 0},
            {"axis_z", 0}};
  }
  /// Those across the axis.
  Lame restModuli() const { return {lambda, mu}; }
  /// ρ c² of the fastest plane wave at rest, Pa: the largest of Christoffel's equation for waves at every degree from
  /// the axis (Auld 1973, §7.C).
  double stiffestModulus() const {
    const double C11 = lambda + 2 * alpha + beta + 4 * axialMu - 2 * mu, C22 = lambda + 2 * mu, C12 = lambda + alpha;
    constexpr int quarter = 90;
    double stiffest = 0;
    for (int degree = 0; degree <= quarter; ++degree) {
      const double angle = 0.5 * std::numbers::pi * degree / quarter, s = std::sin(angle), c = std::cos(angle);
      const double along = (C11 - axialMu) * c * c, across = (C22 - axialMu) * s * s;
      const double coupling = 2 * (C12 + axialMu) * s * c;
      stiffest = std::max(stiffest, axialMu + 0.5 * (along + across + std::hypot(along - across, coupling)));
    }
    return stiffest;
  }
  TransverselyIsotropic withShares(double ofLambda, double ofMu) const {
    TransverselyIsotropic share = *this;
    share.lambda *= ofLambda;
    share.mu *= ofMu;
    share.alpha *= ofMu;
    share.axialMu *= ofMu;
    share.beta *= ofMu;
    return share;
  }

  /// Energy density, J/m³, of the deformation gradient F.
  template <class S>
  RINGWATCH_INLINE S energy(const Matrix3<S>& F) const {
    const Matrix3<S> E = greenStrain(F);
    const S t = trace(E);
    S Ea[3], along(0), square(0);
    for (int i = 0; i < 3; ++i) Ea[i] = E(i, 0) * S(axis[0]) + E(i, 1) * S(axis[1]) + E(i, 2) * S(axis[2]);
    for (int i = 0; i < 3; ++i) along += S(axis[i]) * Ea[i];
    for (int i = 0; i < 3; ++i) square += Ea[i] * Ea[i];
    return S(mu) * innerProduct(E, E) + S(0.5 * lambda) * t * t + S(alpha) * along * t +
           S(2 * (axialMu - mu)) * square + S(0.5 * beta) * along * along;
  }
  /// First Piola–Kirchhoff stress P = ∂W/∂F, Pa.
  template <class S>
  RINGWATCH_INLINE Matrix3<S> stress(const Matrix3<S>& F) const {
    return F * secondStress(greenStrain(F));
  }
  /// dF ↦ dP = dF S + F ℂ sym(Fᵀ dF), exact.
  template <class S>
  struct Linearization {
    const TransverselyIsotropic& law;
    Matrix3<S> F, secondStress;
    RINGWATCH_INLINE Matrix3<S> operator()(const Matrix3<S>& dF) const {
      const Matrix3<S> a = transposeTimes(F, dF);
      return dF * secondStress + F * law.secondStress(S(0.5) * (a + transpose(a)));
    }
    /// As StVenantKirchhoff's, with the sum of the sizes of all moduli for |λ| + 2μ.
    RINGWATCH_INLINE ModulusRounding<S> rounding(const Matrix3<S>& F0, const S& error) const {
      const double m = math::abs(law.lambda) + 2 * law.mu + 2 * math::abs(law.alpha) +
                       4 * math::abs(law.axialMu - law.mu) + math::abs(law.beta);
      const S F2 = innerProduct(F0, F0), size = S(m) * (S(2.5) * F2 + S(4.5));
      return {size, S(lawRounding * unitRoundoff) * size + S(8 * m) * error * (S(0.5) * (S(1.0) + F2) + error)};
    }
  };
  template <class S>
  RINGWATCH_INLINE Linearization<S> linearize(const Matrix3<S>& F) const {
    return {*this, F, secondStress(greenStrain(F))};
  }

  /// As StVenantKirchhoff's, with the norm of ℂ + η I for its own, η >= 0 what makes that one positive semidefinite,
  /// and |ℂ n⊗n| <= ‖ℂ‖: Theorem 52, docs/theory/tangent_drift.md.
  template <class S>
  RINGWATCH_INLINE TangentDriftCoefficients<S> drift(const Matrix3<S>& F) const {
    const double least = math::min(0.0, leastStiffness()), most = math::max(0.0, largestStiffness());
    const Matrix3<S> stress = secondStress(greenStrain(F));
    const S stretch = largestStretch(F);
    S lowest = stress.m[0];
    for (int i = 0; i < 3; ++i)
      lowest = math::min(lowest, stress(i, i) - math::abs(stress(i, (i + 1) % 3)) - math::abs(stress(i, (i + 2) % 3)));
    const double norm = math::max(most, -least);
    return {S(most - least), S(norm - 2 * least) * stretch, S(0.5 * norm),
            math::max(S(0.0), -lowest) - S(least) * stretch * stretch};
  }

 private:
  /// ℂ has the eigenvalues 2μ and 2μa, twice each, and those of its 2×2 block on a⊗a and (I - a⊗a)/√2.
  RINGWATCH_HOST_DEVICE double blockMean() const { return 0.5 * (3 * lambda + 2 * alpha + beta + 4 * axialMu); }
  RINGWATCH_HOST_DEVICE double blockRadius() const {
    const double difference = 0.5 * (2 * alpha - lambda + beta + 4 * (axialMu - mu)), coupling = lambda + alpha;
    return std::sqrt(difference * difference + 2 * coupling * coupling);
  }
  RINGWATCH_INLINE double largestStiffness() const {
    return math::max(blockMean() + blockRadius(), 2 * math::max(mu, axialMu));
  }
  RINGWATCH_INLINE double leastStiffness() const {
    return math::min(blockMean() - blockRadius(), 2 * math::min(mu, axialMu));
  }

  template <class S>
  RINGWATCH_INLINE static Matrix3<S> greenStrain(const Matrix3<S>& F) {
    return StVenantKirchhoff::greenStrain(F);
  }
  /// S = ℂ E of a symmetric E, Pa.
  template <class S>
  RINGWATCH_INLINE Matrix3<S> secondStress(const Matrix3<S>& E) const {
    const S t = trace(E);
    S Ea[3], along(0);
    for (int i = 0; i < 3; ++i) Ea[i] = E(i, 0) * S(axis[0]) + E(i, 1) * S(axis[1]) + E(i, 2) * S(axis[2]);
    for (int i = 0; i < 3; ++i) along += S(axis[i]) * Ea[i];
    const S isotropic = S(lambda) * t + S(alpha) * along, axial = S(alpha) * t + S(beta) * along;
    Matrix3<S> r;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        r(i, j) = S(2 * mu) * E(i, j) + axial * S(axis[i] * axis[j]) +
                  S(2 * (axialMu - mu)) * (S(axis[i]) * Ea[j] + Ea[i] * S(axis[j])) + (i == j ? isotropic : S(0));
    return r;
  }
};

}  // namespace ringwatch
