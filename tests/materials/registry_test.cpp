// Materials by name, their wave speed, and what is said about impossible constants.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <string>

#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/materials/registry.h>

namespace ringwatch {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::string refusal(std::string_view model, double young, double poisson, double density) {
  try {
    makeMaterial(model, young, poisson, density);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Materials, AreMadeByTheNameOfEveryLaw) {
  std::set<std::string_view> names;
  for (const LawInfo& info : allLaws()) {
    EXPECT_TRUE(names.insert(info.name).second) << info.name << " twice";
    EXPECT_FALSE(info.help.empty());
    const Material material = makeMaterial(info.name, 30e3, 0.3, 1000);
    EXPECT_EQ(material.lawName(), info.name);
    EXPECT_EQ(material.density, 1000);
    EXPECT_NEAR(material.restModuli().mu, 30e3 / 2.6, 1e-10);
  }
  EXPECT_EQ(names.size(), Laws::size);
}

TEST(Materials, HaveLamesConstantsOfYoungAndPoisson) {
  for (const double nu : {-0.9, -0.2, 0.0, 0.3, 0.499}) {
    const Lame c = lameConstants(2e5, nu);
    EXPECT_NEAR(c.mu * (3 * c.lambda + 2 * c.mu) / (c.lambda + c.mu), 2e5, 1e-6);  // Young's modulus back
    EXPECT_NEAR(c.lambda / (2 * (c.lambda + c.mu)), nu, 1e-12);                    // Poisson's ratio back
  }
}

TEST(Materials, CarryPressureWavesAtTheKnownSpeed) {
  // Steel, 210 GPa, 0.3, 7800 kg/m3: √(E (1-ν) / ((1+ν)(1-2ν) ρ)) = 6020.2 m/s.
  const double speed = std::sqrt(210e9 * 0.7 / (1.3 * 0.4 * 7800));
  for (const LawInfo& info : allLaws()) {
    EXPECT_NEAR(makeMaterial(info.name, 210e9, 0.3, 7800).waveSpeed(), speed, 1e-9 * speed);
    EXPECT_NEAR(makeMaterial(info.name, 30e3, 0, 1200).waveSpeed(), 5, 1e-12);
  }
}

TEST(Materials, RefuseAYoungsModulusThatIsNotPositive) {
  for (const double bad : {0.0, -1.0, nan, infinity, -infinity})
    EXPECT_THAT(refusal("stvk", bad, 0.3, 1000), AllOf(HasSubstr("young = "), HasSubstr("Pa"), HasSubstr("> 0")))
        << bad;
  EXPECT_THAT(refusal("stvk", -12.5, 0.3, 1000), HasSubstr("-12.5"));
}

TEST(Materials, RefuseAPoissonsRatioOutsideItsRange) {
  for (const double bad : {0.5, 0.7, -1.0, -3.0, nan, infinity, -infinity})
    EXPECT_THAT(refusal("stvk", 1, bad, 1000), AllOf(HasSubstr("poisson = "), HasSubstr("> -1"), HasSubstr("< 0.5")))
        << bad;
  EXPECT_THAT(refusal("stvk", 1, 0.7, 1000), HasSubstr("0.7"));
}

TEST(Materials, RefuseADensityThatIsNotPositive) {
  for (const double bad : {0.0, -1000.0, nan, infinity, -infinity})
    EXPECT_THAT(refusal("stvk", 1, 0.3, bad), AllOf(HasSubstr("density = "), HasSubstr("kg/m3"), HasSubstr("> 0")))
        << bad;
  EXPECT_THAT(refusal("stvk", 1, 0.3, -1000), HasSubstr("-1000"));
}

TEST(Materials, TakeTheParametersOfTheirLawAlone) {
  EXPECT_EQ(makeMaterial("stvk", {{"young", 30e3}, {"poisson", 0.3}}, 1000).restModuli().mu, 30e3 / 2.6);
  const auto refused = [](const Options& parameters) -> std::string {
    try {
      makeMaterial("stvk", parameters, 1000);
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_EQ(refused({{"young", 1}, {"poisson", 0.3}, {"c10", 2}}),
            "c10 = 2: is no parameter of the law \"stvk\"; it takes young, poisson");
  EXPECT_THAT(refused({{"young", 1}}), AllOf(HasSubstr("poisson: missing"), HasSubstr("< 0.5")));
}

TEST(Materials, NameAllLawsWhenTheModelIsUnknown) {
  const std::string text = refusal("ogden", 1, 0.3, 1000);
  EXPECT_THAT(text, HasSubstr("\"ogden\""));
  for (const LawInfo& info : allLaws()) EXPECT_THAT(text, HasSubstr(std::string(info.name)));
  EXPECT_THAT(text, ::testing::Not(HasSubstr("\n")));
}

}  // namespace
}  // namespace ringwatch
