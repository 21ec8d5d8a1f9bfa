#pragma once
#include <array>
#include <span>
#include <string_view>

#include <ringwatch/materials/isochoric_law.h>

namespace ringwatch {

/// Yeoh (1993), nearly incompressible: W = c10 (Ī1 - 3) + c20 (Ī1 - 3)² + c30 (Ī1 - 3)³ + K/2 (J - 1)², see
/// IsochoricLaw.
struct Yeoh : IsochoricLaw<Yeoh, true, false> {
  static constexpr std::string_view name = "yeoh";
  static constexpr std::string_view help = "nearly incompressible Yeoh, for rubber at large stretches: stiffens again";
  static constexpr std::array parameterTable{
      OptionInfo{.name = "c10", .unit = "Pa", .range = NumberRange::positive(), .help = "half the shear modulus"},
      OptionInfo{.name = "c20", .unit = "Pa", .fallback = "0", .help = "softens at middle stretches where < 0"},
      OptionInfo{.name = "c30", .unit = "Pa", .fallback = "0", .help = "stiffens at large stretches where > 0"},
      OptionInfo{.name = "bulk", .unit = "Pa", .range = NumberRange::positive(), .help = "bulk modulus, 2/D1"}};
  static constexpr std::span<const OptionInfo> parameters = parameterTable;

  static Yeoh of(const Options& parameters) {
    Yeoh law;
    law.c10 = parameters.number("c10");
    law.c20 = parameters.number("c20");
    law.c30 = parameters.number("c30");
    law.c01 = 0;
    law.bulk = parameters.number("bulk");
    return law;
  }
  /// c20 and c30 as carbon-filled rubber has them relative to c10: -1/100 and 1/1000.
  static Options parametersFor(double young, double poisson) {
    const Lame rest = lameConstants(young, poisson);
    return {{"c10", 0.5 * rest.mu},
            {"c20", -0.005 * rest.mu},
            {"c30", 0.0005 * rest.mu},
            {"bulk", rest.lambda + 2.0 / 3.0 * rest.mu}};
  }
};

}  // namespace ringwatch
