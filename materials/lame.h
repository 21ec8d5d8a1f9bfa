#pragma once
#include <array>

#include <ringwatch/base/options.h>

namespace ringwatch {

/// Lamé's constants, Pa.
struct Lame {
  double lambda;
  double mu;
};

/// λ = E ν / ((1+ν)(1-2ν)), μ = E / (2(1+ν)); E in Pa, -1 < ν < 0.5.
inline Lame lameConstants(double young, double poisson) {
  return {young * poisson / ((1 + poisson) * (1 - 2 * poisson)), young / (2 * (1 + poisson))};
}

/// Young's modulus and Poisson's ratio: the parameters of laws of Lamé's constants.
inline constexpr std::array youngAndPoisson{
    OptionInfo{.name = "young", .unit = "Pa", .range = NumberRange::positive(), .help = "Young's modulus"},
    OptionInfo{.name = "poisson", .range = {-1, 0.5, false, false}, .help = "Poisson's ratio"}};
inline Options youngAndPoissonOf(double young, double poisson) { return {{"young", young}, {"poisson", poisson}}; }
inline Lame lameConstants(const Options& parameters) {
  return lameConstants(parameters.number("young"), parameters.number("poisson"));
}

}  // namespace ringwatch
