// Checks follow from their numbers, and nothing passes for want of a number.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include <ringwatch/base/infinity.h>
#include <ringwatch/verify/report.h>

namespace ringwatch {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

bool near(double measured, double expected, double tolerance) {
  StudyReport report;
  checkNear(report, "", measured, expected, tolerance);
  return report.passed();
}
bool atMost(double measured, double expected, double tolerance) {
  StudyReport report;
  checkAtMost(report, "", measured, expected, tolerance);
  return report.passed();
}
bool atLeast(double measured, double expected, double tolerance) {
  StudyReport report;
  checkAtLeast(report, "", measured, expected, tolerance);
  return report.passed();
}

TEST(StudyCheck, PassesOnTheSideOfItsSense) {
  EXPECT_TRUE(near(1.5, 1, 0.5));
  EXPECT_TRUE(near(0.5, 1, 0.5));
  EXPECT_FALSE(near(1.6, 1, 0.5));
  EXPECT_FALSE(near(0.4, 1, 0.5));
  EXPECT_TRUE(atMost(1.5, 1, 0.5));
  EXPECT_TRUE(atMost(-9, 1, 0.5));
  EXPECT_FALSE(atMost(1.6, 1, 0.5));
  EXPECT_TRUE(atLeast(0.5, 1, 0.5));
  EXPECT_TRUE(atLeast(9, 1, 0.5));
  EXPECT_FALSE(atLeast(0.4, 1, 0.5));
}

TEST(StudyCheck, FailsWithoutANumber) {
  for (const auto check : {near, atMost, atLeast}) {
    EXPECT_FALSE(check(nan, 1, 0.5));
    EXPECT_FALSE(check(1, nan, 0.5));
    EXPECT_FALSE(check(1, 1, nan));
    EXPECT_FALSE(check(1, 1, infinity));
  }
  EXPECT_FALSE(near(2, infinity, 0.5));
  EXPECT_FALSE(near(infinity, 2, 0.5));
  EXPECT_TRUE(near(infinity, infinity, 0.5));  // a limit that is none, found to be none
}

TEST(StudyCheck, OneThatFailsFailsTheReport) {
  StudyReport report;
  checkBelow(report, "small enough", 0.1, 0.2);
  EXPECT_TRUE(report.passed());
  checkBelow(report, "too large", 0.3, 0.2);
  EXPECT_FALSE(report.passed());
}

}  // namespace
}  // namespace ringwatch
