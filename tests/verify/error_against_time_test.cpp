// The whole picture of error against time: errors shrink with the mesh, fronts hold what nothing beats, and what is
// said to be cheapest is.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include <ringwatch/verify/work_precision/error_against_time.h>

#include "report_tools.h"

namespace ringwatch {
namespace {

TEST(ErrorAgainstTime, AFrontHoldsWhatNoOtherRunBeats) {
  const auto run = [](const char* name, double error, double seconds) {
    ErrorCost r;
    r.method = name;
    r.error = error;
    r.seconds = seconds;
    return r;
  };
  const std::vector<ErrorCost> front =
      paretoFront({run("slow and good", 1e-3, 9), run("beaten", 1e-2, 8), run("quick", 1e-1, 1),
                   run("lost", std::nan(""), 0.1), run("middle", 1e-2, 3), run("as good, slower", 1e-3, 10)});
  ASSERT_EQ(front.size(), 3U);
  EXPECT_EQ(front[0].method, "quick");
  EXPECT_EQ(front[1].method, "middle");
  EXPECT_EQ(front[2].method, "slow and good");
}

class WholePicture : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    report = new StudyReport;
    // Explicit ones of one force a step suffice here; the others' errors have tests of their own.
    std::vector<IntegratorEntry> integrators;
    for (const IntegratorEntry& entry : coreIntegrators())
      if (entry.info->name == "verlet") integrators.push_back(entry);
    runs = new std::vector<ErrorCost>(addErrorAgainstTime(integrators, StudyEffort::quick, *report));
  }
  static void TearDownTestSuite() {
    delete runs;
    delete report;
  }
  static double leastError(const std::string& motion, const std::string& element, std::int64_t elements) {
    double least = 1e9;
    for (const ErrorCost& run : *runs)
      if (run.motion == motion && run.element == element && run.mesh == "regular" && run.elements == elements)
        least = std::min(least, run.error);
    return least;
  }
  static inline std::vector<ErrorCost>* runs = nullptr;
  static inline StudyReport* report = nullptr;
};

TEST_F(WholePicture, TheReferencesAgree) { test::expectHolds(*report); }

TEST_F(WholePicture, FinerMeshesOfEveryElementErrLess) {
  std::map<std::pair<std::string, std::string>, std::set<std::int64_t>> sizes;
  for (const ErrorCost& run : *runs)
    if (run.mesh == "regular") sizes[{run.motion, run.element}].insert(run.elements);
  EXPECT_EQ(sizes.size(), 2 * allElements().size());
  for (const auto& [key, counts] : sizes) {
    ASSERT_GE(counts.size(), 2U) << key.first << " " << key.second;
    EXPECT_LT(leastError(key.first, key.second, *counts.rbegin()),
              0.6 * leastError(key.first, key.second, *counts.begin()))
        << key.first << " " << key.second;
  }
}

TEST_F(WholePicture, HandlersRunBeyondTheStepOfTheSlivers) {
  double largestPlain = 0, plainError = 0, leastHandled = 1e9;
  int handled = 0;
  for (const ErrorCost& run : *runs) {
    if (run.mesh != "slivers" || run.motion != "swinging") continue;
    if (run.method == "verlet") {
      largestPlain = std::max(largestPlain, run.h);
      plainError = run.error;  // that of the mesh
    } else {
      ++handled;
      leastHandled = std::min(leastHandled, run.h);
      EXPECT_NEAR(run.error, plainError, 0.2 * plainError) << run.method;
    }
  }
  EXPECT_GE(handled, 2);
  EXPECT_GT(leastHandled, largestPlain);
}

TEST_F(WholePicture, TheCheapestIsNoSlowerThanAnyOtherThatIsAsGood) {
  const StudyTable& table = report->tables.back();
  EXPECT_EQ(table.name, "error_against_time_cheapest");
  int found = 0;
  for (const auto& row : table.rows) {
    if (std::get<std::string>(row[6]) == "none") continue;
    const double wanted = std::stod(std::get<std::string>(row[1])) / 100;
    EXPECT_LE(std::get<double>(row[8]), wanted);
    for (const ErrorCost& run : *runs) {
      const bool sameGroup = run.motion == std::get<std::string>(row[0]) &&
                             run.element == std::get<std::string>(row[3]) && run.mesh == std::get<std::string>(row[4]);
      EXPECT_TRUE(!sameGroup || run.error > wanted || run.seconds >= std::get<double>(row[9]));
    }
    ++found;
  }
  EXPECT_GE(found, 2);
}

}  // namespace
}  // namespace ringwatch
