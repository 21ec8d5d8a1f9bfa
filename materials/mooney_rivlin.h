#pragma once
#include <array>
#include <span>
#include <string_view>

#include <ringwatch/base/error.h>
#include <ringwatch/materials/isochoric_law.h>

namespace ringwatch {

/// Nearly incompressible Mooney–Rivlin: W = c10 (Ī1 - 3) + c01 (Ī2 - 3) + K/2 (J - 1)², see IsochoricLaw; c01 = 0 is
/// the neo-Hookean law of the same family.
struct MooneyRivlin : IsochoricLaw<MooneyRivlin, false, true> {
  static constexpr std::string_view name = "mooney-rivlin";
  static constexpr std::string_view help = "nearly incompressible Mooney-Rivlin, for rubber up to twice its length";
  static constexpr std::array parameterTable{
      OptionInfo{.name = "c10", .unit = "Pa", .help = "coefficient of the first invariant; c10 + c01 > 0"},
      OptionInfo{.name = "c01", .unit = "Pa", .fallback = "0", .help = "coefficient of the second invariant"},
      OptionInfo{.name = "bulk", .unit = "Pa", .range = NumberRange::positive(), .help = "bulk modulus, 2/D1"}};
  static constexpr std::span<const OptionInfo> parameters = parameterTable;

  static MooneyRivlin of(const Options& parameters) {
    MooneyRivlin law;
    law.c10 = parameters.number("c10");
    law.c01 = parameters.number("c01");
    law.c20 = law.c30 = 0;
    law.bulk = parameters.number("bulk");
    if (!(law.c10 + law.c01 > 0))
      throw InputError(
          joinText("c10 = ", law.c10, " Pa, c01 = ", law.c01, " Pa: their sum, half the shear modulus, must be > 0"));
    return law;
  }
  /// Four fifths of the shear modulus by the first invariant.
  static Options parametersFor(double young, double poisson) {
    const Lame rest = lameConstants(young, poisson);
    return {{"c10", 0.4 * rest.mu}, {"c01", 0.1 * rest.mu}, {"bulk", rest.lambda + 2.0 / 3.0 * rest.mu}};
  }
};

}  // namespace ringwatch
