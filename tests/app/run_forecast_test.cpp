// What a run says of its end, by a clock that the test turns.
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ringwatch/app/run/run_forecast.h>

namespace ringwatch {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(RunForecast, TellsOnceOfARunThatWillNotEnd) {
  RunForecast forecast;
  const auto contact = [] { return std::string("contact"); };
  // 100 steps a second, of 1e-6 s each, to 1 s: 10⁴ s.
  EXPECT_EQ(forecast.observe({0, 0, 0, 1, 1e-6}, contact), "");
  EXPECT_EQ(forecast.observe({1, 100, 100e-6, 1, 1e-6}, contact), "");
  const std::string told = forecast.observe({10, 1000, 1000e-6, 1, 1e-6}, contact);
  EXPECT_THAT(told, AllOf(HasSubstr("9.99e+05 steps are left, about 2.8 h"), Not(HasSubstr("contact"))));
  EXPECT_NEAR(forecast.left(), 0.999e4, 1);
  EXPECT_EQ(forecast.observe({20, 2000, 2000e-6, 1, 1e-6}, contact), "");
  // The step collapses to a ten thousandth.
  EXPECT_THAT(
      forecast.observe({30, 3000, 2000.1e-6, 1, 1e-10}, contact),
      AllOf(HasSubstr("h = 1e-10 s"), HasSubstr("days; the step began with 1e-06 s, and contact keeps it small")));
  EXPECT_EQ(forecast.observe({40, 4000, 2000.2e-6, 1, 1e-10}, contact), "");
}

TEST(RunForecast, SaysNothingOfARunThatEndsSoon) {
  RunForecast forecast;
  const auto none = [] { return std::string(); };
  for (int second = 0; second <= 50; ++second)
    EXPECT_EQ(forecast.observe({second * 1.0, second * 10, second * 0.02, 1, 2e-3}, none), "") << second;
}

TEST(RunForecast, NamesTimesAsPeopleDo) {
  EXPECT_EQ(RunForecast::durationText(42), "42 seconds");
  EXPECT_EQ(RunForecast::durationText(600), "10 min");
  EXPECT_EQ(RunForecast::durationText(3 * 3600), "3.0 h");
  EXPECT_EQ(RunForecast::durationText(10 * 86400), "10 days");
}

}  // namespace
}  // namespace ringwatch
