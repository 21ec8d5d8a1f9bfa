#pragma once
#include <array>
#include <span>
#include <string_view>

#include <ringwatch/base/matrix3.h>
#include <ringwatch/materials/lame.h>
#include <ringwatch/materials/modulus_rounding.h>
#include <ringwatch/materials/tangent_drift.h>

namespace ringwatch::test {

/// A law of three constants, added from outside: compressible Mooney–Rivlin, with J = det F, C = FᵀF, I1 = tr C,
/// I2 = (I1² - C:C)/2 and d = 2 (c10 + 2 c01),
///   W = c10 (I1 - 3) + c01 (I2 - 3) - d ln J + λ/2 ln²J,   P = 2 c10 F + 2 c01 (I1 F - F C) - (d - λ ln J) F⁻ᵀ.
/// At rest μ = 2 (c10 + c01), and Lamé's first constant is λ + 4 c01.
struct LogMooneyRivlin {
  static constexpr std::string_view name = "log-mooney-rivlin";
  static constexpr std::string_view help = "compressible Mooney-Rivlin with a logarithmic energy of volume";
  static constexpr std::array parameterTable{
      OptionInfo{.name = "c10", .unit = "Pa", .range = NumberRange::positive(), .help = "coefficient of I1 - 3"},
      OptionInfo{.name = "c01",
                 .unit = "Pa",
                 .range = {0, std::numeric_limits<double>::infinity(), true, true},
                 .help = "coefficient of I2 - 3"},
      OptionInfo{.name = "bulk", .unit = "Pa", .range = NumberRange::positive(), .help = "bulk modulus at rest"}};
  static constexpr std::span<const OptionInfo> parameters = parameterTable;
  static constexpr bool objective = true, isotropic = true, tangentIsConstant = false;
  static constexpr bool tangentStiffens = true, definedInverted = false, allowsInversion = false;
  double c10, c01, lambda;  // Pa

  static LogMooneyRivlin of(const Options& parameters) {
    const double c10 = parameters.number("c10"), c01 = parameters.number("c01");
    return {c10, c01, parameters.number("bulk") - 4.0 / 3.0 * (c10 + c01) - 4 * c01};
  }
  static Options parametersFor(double young, double poisson) {
    const Lame rest = lameConstants(young, poisson);
    return {{"c10", 0.4 * rest.mu}, {"c01", 0.1 * rest.mu}, {"bulk", rest.lambda + 2.0 / 3.0 * rest.mu}};
  }
  Lame restModuli() const { return {lambda + 4 * c01, 2 * (c10 + c01)}; }
  double d() const { return 2 * (c10 + 2 * c01); }

  template <class S>
  RINGWATCH_INLINE S energy(const Matrix3<S>& F) const {
    const Matrix3<S> C = transposeTimes(F, F);
    const S I1 = trace(C), I2 = S(0.5) * (I1 * I1 - innerProduct(C, C)), logJ = math::log(determinant(F));
    return S(c10) * (I1 - S(3)) + S(c01) * (I2 - S(3)) - S(d()) * logJ + S(0.5 * lambda) * logJ * logJ;
  }
  template <class S>
  RINGWATCH_INLINE Matrix3<S> stress(const Matrix3<S>& F) const {
    const Linearization<S> l = linearize(F);
    return S(2 * c10) * F + S(2 * c01) * (trace(l.C) * F - F * l.C) - l.a * l.inverseTranspose;
  }
  /// dF ↦ dP = 2 c10 dF + 2 c01 (dI1 F + I1 dF - dF C - F dC) + (d - λ ln J) F⁻ᵀ dFᵀ F⁻ᵀ + λ (F⁻ᵀ : dF) F⁻ᵀ.
  template <class S>
  struct Linearization {
    const LogMooneyRivlin& law;
    Matrix3<S> F, C, inverseTranspose;
    S a;  // d - λ ln J
    RINGWATCH_INLINE Matrix3<S> operator()(const Matrix3<S>& dF) const {
      const Matrix3<S> dC = transposeTimes(dF, F) + transposeTimes(F, dF);
      const Matrix3<S> turned = timesTranspose(inverseTranspose, dF) * inverseTranspose;
      return S(2 * law.c10) * dF + S(2 * law.c01) * (trace(dC) * F + trace(C) * dF - dF * C - F * dC) + a * turned +
             (S(law.lambda) * innerProduct(inverseTranspose, dF)) * inverseTranspose;
    }
    /// As NeoHookean's, and 2 c01 times at most 6 |F|² for the terms of I2, which F + Δ moves by 12 |F| δ + 6 δ².
    RINGWATCH_INLINE ModulusRounding<S> rounding(const Matrix3<S>& F0, const S& error) const {
      const auto inverse = detail::inverseRounding(F0, inverseTranspose, error);
      const S lambda(math::abs(law.lambda)), terms = lambda + math::abs(a), F2 = innerProduct(F0, F0);
      const S size = S(4 * law.c10) + S(12 * law.c01) * F2 + terms * inverse.norm2;
      const S da = lambda * inverse.logarithm + S(4 * unitRoundoff) * (math::abs(S(law.d()) - a) + terms);
      return {size, S(3 * lawRounding * unitRoundoff) * size + S(24 * law.c01) * error * (math::sqrt(F2) + error) +
                        inverse.norm2 * (S(2.5) * inverse.relative * terms + S(1.3) * da)};
    }
  };
  template <class S>
  RINGWATCH_INLINE Linearization<S> linearize(const Matrix3<S>& F) const {
    const Matrix3<S> cof = cofactor(F);
    const S J = F.m[0] * cof.m[0] + F.m[1] * cof.m[1] + F.m[2] * cof.m[2];
    return {*this, F, transposeTimes(F, F), (S(1) / J) * cof, S(d()) - S(lambda) * math::log(J)};
  }

  /// No bound on how fast the tangent grows: every element is evaluated again. With G = F⁻ᵀ and the sum of the singular
  /// values of cof(dF) at most |dF|², no eigenvalue is below 2 c10 - 4 c01 |cof F| - |d - λ ln J| |G|² + min(0, λ)
  /// |G|².
  template <class S>
  RINGWATCH_INLINE TangentDriftCoefficients<S> drift(const Matrix3<S>& F) const {
    const S zero(0.0);
    const auto upright = determinant(F) > zero;
    Matrix3<S> own = Matrix3<S>::identity();
    for (int i = 0; i < 9; ++i) own.m[i] = select(upright, F.m[i], own.m[i]);
    const Linearization<S> l = linearize(own);
    const Matrix3<S> cof = cofactor(own);
    const S G2 = innerProduct(l.inverseTranspose, l.inverseTranspose);
    const S negative = math::max(zero, S(4 * c01) * math::sqrt(innerProduct(cof, cof)) + math::abs(l.a) * G2 +
                                           S(math::max(0.0, -lambda)) * G2 - S(2 * c10));
    return {zero, zero, zero, select(upright, negative, zero), S(-1.0)};
  }
};

}  // namespace ringwatch::test
