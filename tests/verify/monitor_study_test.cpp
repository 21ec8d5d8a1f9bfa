// The study of the monitor as a whole: everything it claims holds, and it examined enough to say so.
#include <gtest/gtest.h>

#include <ringwatch/elements/registry.h>
#include <ringwatch/materials/registry.h>
#include <ringwatch/monitor/metrics/metrics.h>
#include <ringwatch/verify/monitor/monitor.h>

#include "report_tools.h"

namespace ringwatch {
namespace {

const StudyReport& quickReport() {
  static const StudyReport report = verifyMonitor(StudyEffort::quick);
  return report;
}

TEST(MonitorStudy, EveryClaimHolds) { test::expectHolds(quickReport()); }

TEST(MonitorStudy, CoversEveryElementAndLaw) {
  std::set<std::string> elements;
  std::set<std::pair<std::string, std::string>> pairs;
  for (const ElementInfo& element : allElements()) {
    elements.insert(std::string(element.name));
    if (element.order == 1)
      for (const LawInfo& law : allLaws()) pairs.insert({std::string(element.name), std::string(law.name)});
  }
  const StudyTable &bracket = test::tableOf(quickReport(), "bracket"), &drift = test::tableOf(quickReport(), "drift");
  EXPECT_EQ(test::textsOf(bracket, 0), elements);
  for (const auto& row : bracket.rows) EXPECT_GE(std::get<std::int64_t>(row[1]), 25);
  std::set<std::pair<std::string, std::string>> found;
  for (const auto& row : drift.rows) {
    found.insert({std::get<std::string>(row[0]), std::get<std::string>(row[1])});
    EXPECT_GE(std::get<std::int64_t>(row[2]), 2500);
  }
  EXPECT_EQ(found, pairs);
}

TEST(MonitorStudy, ComparesEveryMetricOnEveryMesh) {
  std::set<std::string> metrics;
  for (const MetricInfo& info : allMetrics()) metrics.insert(std::string(info.name));
  const StudyTable& table = test::tableOf(quickReport(), "metrics");
  EXPECT_EQ(test::textsOf(table, 1), metrics);
  const std::set<std::string> meshes = test::textsOf(table, 0);
  EXPECT_EQ(table.rows.size(), metrics.size() * meshes.size());
  EXPECT_EQ(test::textsOf(test::tableOf(quickReport(), "rest"), 0), meshes);
  EXPECT_EQ(test::textsOf(test::tableOf(quickReport(), "observed"), 0), meshes);
}

TEST(MonitorStudy, DrawsEveryHistory) {
  std::set<std::string> figures{"monitor-tetrahedron-poisson", "monitor-tetrahedron-shape"};
  for (const std::string& run : test::textsOf(test::tableOf(quickReport(), "histories"), 0))
    figures.insert("monitor-history-" + run);
  EXPECT_EQ(test::figureNames(quickReport()), figures);
  for (const StudyFigure& figure : quickReport().figures) EXPECT_GE(figure.curves.front().x.size(), 3u) << figure.name;
}

}  // namespace
}  // namespace ringwatch
