// The study of the monitor as a whole: everything it claims holds, and it examined enough to say so.
#include <gtest/gtest.h>

#include <ringwatch/elements/registry.h>
#include <ringwatch/materials/registry.h>
#include <ringwatch/monitor/metrics/metrics.h>
#include <ringwatch/verify/monitor/monitor.h>

#include "criteria.h"
#include "report_tools.h"

namespace ringwatch {
namespace {

const StudyReport& quickReport() {
  static const StudyReport report = verifyMonitor(StudyEffort::quick);
  return report;
}

TEST(MonitorStudy, EveryClaimHolds) {
  using test::Basis;
  constexpr double ofTheReference = 1e-9;  // the error of what proven sides are compared with
  test::expectCriteria(quickReport(),
                       {{"*: violations of the bracket in * trials", 0, Basis::theory},
                        {"violations of the incremental nodal bound in * element and state trials", 0, Basis::theory},
                        {"tetrahedron: relative difference to the closed form", 1.5e-13, Basis::rounding},
                        {"*: the exact value converged", 0, Basis::theory},
                        {"* is pessimistic: its step over the exact one", ofTheReference, Basis::theory},
                        {"* is optimistic: the exact step over its own", ofTheReference, Basis::theory},
                        {"*: safe over exact", ofTheReference, Basis::theory},
                        {"*: exact over optimistic", ofTheReference, Basis::theory},
                        {"*: optimistic over exact", 1.4e-3, Basis::measured},
                        {"*: safe over exact, at least", 0.01, Basis::measured},  // iterated until it is within 1 %
                        // Runs of 4000 steps, bisected to 1.2e-5.
                        {"*: safe over observed", 2.4e-5, Basis::theory},
                        {"*: observed over optimistic", 2.4e-5, Basis::theory},
                        {"*: observed over exact", 2.4e-5, Basis::rounding},
                        {"*: exact values outside of the bracket", 0, Basis::theory},
                        {"*: alarms while the exact step allows h", 0, Basis::theory},
                        {"*: step at which it is said indefinite, before the energy is off", 0, Basis::theory},
                        {"*: steps from the first violated to an energy off by 10 %", 0, Basis::theory}});
}

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
  test::expectWellFormed(quickReport());
  std::set<std::string> figures{"monitor-tetrahedron-poisson", "monitor-tetrahedron-shape"};
  for (const std::string& run : test::textsOf(test::tableOf(quickReport(), "histories"), 0))
    figures.insert("monitor-history-" + run);
  EXPECT_EQ(test::figureNames(quickReport()), figures);
  for (const StudyFigure& figure : quickReport().figures) EXPECT_GE(figure.curves.front().x.size(), 3u) << figure.name;
}

}  // namespace
}  // namespace ringwatch
