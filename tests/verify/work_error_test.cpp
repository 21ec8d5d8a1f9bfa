// The study of error against time by step rules: everything holds, runs are at the steps that their rules say, and what
// is said to be cheapest is.
#include <gtest/gtest.h>

#include <map>
#include <utility>

#include <ringwatch/verify/work_error/work_error.h>

#include "report_tools.h"

namespace ringwatch {
namespace {

const StudyReport& workErrorReport() {
  static const StudyReport report = verifyWorkError(StudyEffort::quick);
  return report;
}

TEST(WorkError, EveryClaimHolds) { test::expectHolds(workErrorReport(), 5); }

TEST(WorkError, HasAPictureOfEachBody) {
  EXPECT_EQ(test::figureNames(workErrorReport()).size(), test::tableOf(workErrorReport(), "bodies").rows.size());
}

TEST(WorkError, RunsAreAtTheStepsOfTheirRules) {
  std::map<std::string, std::pair<double, double>> steps;  // proven, pressure wave
  for (const auto& row : test::tableOf(workErrorReport(), "bodies").rows) {
    EXPECT_LE(test::numberAt(row, 3), test::numberAt(row, 5));  // proven, exact
    steps[test::textAt(row, 0)] = {test::numberAt(row, 3), test::numberAt(row, 4)};
  }
  std::set<std::string> rules;
  for (const auto& row : test::tableOf(workErrorReport(), "runs").rows) {
    if (test::textAt(row, 2) == "pefrl") continue;  // has a limit of its own
    const auto [proven, usual] = steps.at(test::textAt(row, 0));
    const double asked = test::numberAt(row, 3) * (test::textAt(row, 1) == "pressure-wave" ? usual : proven);
    EXPECT_LE(test::numberAt(row, 4), asked * (1 + 1e-8));  // divides the end
    EXPECT_GE(test::numberAt(row, 4), 0.95 * asked);
    rules.insert(test::textAt(row, 1));
  }
  EXPECT_EQ(rules, (std::set<std::string>{"handler", "pressure-wave", "proven"}));
}

TEST(WorkError, TheCheapestIsNoSlowerThanAnyOtherThatIsAsGood) {
  const StudyTable& best = test::tableOf(workErrorReport(), "cheapest");
  EXPECT_GE(best.rows.size(), 4U);
  for (const auto& row : best.rows) {
    EXPECT_LE(test::numberAt(row, 4), 0.01);
    for (const auto& run : test::tableOf(workErrorReport(), "runs").rows)
      EXPECT_TRUE(test::textAt(run, 0) != test::textAt(row, 0) || test::textAt(run, 1) != test::textAt(row, 1) ||
                  !(test::numberAt(run, 5) <= 0.01) || test::numberAt(run, 8) >= test::numberAt(row, 5));
  }
}

TEST(WorkError, FrequenciesAreNearThoseOfTheTangentAtRest) {
  // Strains are some per cent, which changes stiffnesses by as much; suddenly loaded, other modes take part.
  for (const auto& row : test::tableOf(workErrorReport(), "bodies").rows)
    EXPECT_NEAR(test::numberAt(row, 7) / test::numberAt(row, 6), 1, 0.1) << test::textAt(row, 0);
}

}  // namespace
}  // namespace ringwatch
