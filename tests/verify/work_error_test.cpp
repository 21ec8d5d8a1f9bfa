// The study of error against time by step rules: everything holds, runs are at the steps that their rules say, and what
// is said to be cheapest is.
#include <gtest/gtest.h>

#include <map>
#include <utility>

#include <ringwatch/verify/work_error/work_error.h>

#include "report_tools.h"

namespace ringwatch {
namespace {

const StudyReport& quickReport() {
  static const StudyReport report = verifyWorkError(StudyEffort::quick);
  return report;
}
const std::string& textAt(const std::vector<StudyTable::Cell>& row, std::size_t column) {
  return std::get<std::string>(row[column]);
}
double numberAt(const std::vector<StudyTable::Cell>& row, std::size_t column) { return std::get<double>(row[column]); }

TEST(WorkError, EveryClaimHolds) { test::expectHolds(quickReport(), 5); }

TEST(WorkError, HasAPictureOfEachBody) {
  EXPECT_EQ(test::figureNames(quickReport()).size(), test::tableOf(quickReport(), "bodies").rows.size());
}

TEST(WorkError, RunsAreAtTheStepsOfTheirRules) {
  std::map<std::string, std::pair<double, double>> steps;  // proven, pressure wave
  for (const auto& row : test::tableOf(quickReport(), "bodies").rows) {
    EXPECT_LE(numberAt(row, 3), numberAt(row, 5));  // proven, exact
    steps[textAt(row, 0)] = {numberAt(row, 3), numberAt(row, 4)};
  }
  std::set<std::string> rules;
  for (const auto& row : test::tableOf(quickReport(), "runs").rows) {
    if (textAt(row, 2) == "pefrl") continue;  // has a limit of its own
    const auto [proven, usual] = steps.at(textAt(row, 0));
    const double asked = numberAt(row, 3) * (textAt(row, 1) == "pressure-wave" ? usual : proven);
    EXPECT_LE(numberAt(row, 4), asked * (1 + 1e-12));  // divides the end
    EXPECT_GE(numberAt(row, 4), 0.95 * asked);
    rules.insert(textAt(row, 1));
  }
  EXPECT_EQ(rules, (std::set<std::string>{"handler", "pressure-wave", "proven"}));
}

TEST(WorkError, TheCheapestIsNoSlowerThanAnyOtherThatIsAsGood) {
  const StudyTable& best = test::tableOf(quickReport(), "cheapest");
  EXPECT_GE(best.rows.size(), 4U);
  for (const auto& row : best.rows) {
    EXPECT_LE(numberAt(row, 4), 0.01);
    for (const auto& run : test::tableOf(quickReport(), "runs").rows)
      EXPECT_TRUE(textAt(run, 0) != textAt(row, 0) || textAt(run, 1) != textAt(row, 1) || !(numberAt(run, 5) <= 0.01) ||
                  numberAt(run, 8) >= numberAt(row, 5));
  }
}

TEST(WorkError, FrequenciesAreNearThoseOfTheTangentAtRest) {
  // Strains are some per cent, which changes stiffnesses by as much; suddenly loaded, other modes take part.
  for (const auto& row : test::tableOf(quickReport(), "bodies").rows)
    EXPECT_NEAR(numberAt(row, 7) / numberAt(row, 6), 1, 0.1) << textAt(row, 0);
}

}  // namespace
}  // namespace ringwatch
