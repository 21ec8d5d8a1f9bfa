// The data set of nonlinear runs: every bracket and certificate holds, and tables, files and figures belong together.
#include <gtest/gtest.h>

#include <algorithm>

#include <ringwatch/verify/histories/histories.h>

#include "report_tools.h"

namespace ringwatch {
namespace {

const StudyReport& historiesReport() {
  static const StudyReport report = verifyHistories(StudyEffort::quick);
  return report;
}

TEST(HistoriesStudy, EveryClaimHolds) { test::expectHolds(historiesReport(), 6); }

TEST(HistoriesStudy, HasAFileForEachPoint) {
  std::set<std::string> files;
  for (const StudyFile& file : historiesReport().files) {
    EXPECT_FALSE(file.bytes.empty()) << file.name;
    EXPECT_TRUE(files.insert(file.name).second) << file.name;
  }
  EXPECT_EQ(files, test::textsOf(test::tableOf(historiesReport(), "points"), 9));
}

TEST(HistoriesStudy, CountsThePointsOfEachRun) {
  const StudyTable& points = test::tableOf(historiesReport(), "points");
  std::int64_t all = 0;
  for (const auto& run : test::tableOf(historiesReport(), "runs").rows) {
    const auto own =
        std::count_if(points.rows.begin(), points.rows.end(), [&](const auto& p) { return p[0] == run[0]; });
    EXPECT_EQ(own, std::get<std::int64_t>(run[8])) << std::get<std::string>(run[0]);
    EXPECT_GE(own, 3);
    all += own;
  }
  EXPECT_EQ(all, static_cast<std::int64_t>(points.rows.size()));
}

TEST(HistoriesStudy, SaysAViolationNoEarlierThanTheExactStepShowsIt) {
  // Of a run whose step is proven too large an exact step of that state lies below it.
  for (const auto& run : test::tableOf(historiesReport(), "runs").rows) {
    const auto violated = std::get<std::int64_t>(run[10]);
    if (violated < 0) continue;
    for (const auto& point : test::tableOf(historiesReport(), "points").rows) {
      if (point[0] != run[0] || std::get<std::int64_t>(point[1]) != violated) continue;
      EXPECT_LT(test::numberAt(point, 4), test::numberAt(point, 3)) << test::textAt(run, 0);
    }
  }
}

}  // namespace
}  // namespace ringwatch
