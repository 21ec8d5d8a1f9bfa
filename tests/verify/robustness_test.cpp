// Long and nasty runs, in short.
#include <gtest/gtest.h>

#include <ringwatch/verify/robustness.h>

namespace ringwatch {
namespace {

TEST(VerifyRobustness, StableStepsSurviveAndOthersDoNot) {
  const StudyReport report = verifyRobustness(StudyEffort::quick);
  for (const StudyCheck& check : report.checks)
    EXPECT_TRUE(check.passed) << check.name << ": " << check.measured << ", expected " << check.expected << " within "
                              << check.tolerance;
  // Six integrators with a limit: four fractions of one case, four cases at one, and the spin.
  EXPECT_EQ(report.tables.at(0).rows.size(), 6u * 9u);
}

}  // namespace
}  // namespace ringwatch
