// The study of the monitor as a whole: everything it claims holds, and it looked at enough to say so.
#include <gtest/gtest.h>

#include <algorithm>

#include <ringwatch/verify/monitor.h>

namespace ringwatch {
namespace {

const StudyReport& quickReport() {
  static const StudyReport report = verifyMonitor(StudyEffort::quick);
  return report;
}
const StudyTable& table(const std::string& name) {
  const auto& tables = quickReport().tables;
  const auto found = std::find_if(tables.begin(), tables.end(), [&](const StudyTable& t) { return t.name == name; });
  EXPECT_NE(found, tables.end()) << name;
  return *found;
}

TEST(MonitorStudy, EveryClaimHolds) {
  for (const StudyCheck& check : quickReport().checks)
    EXPECT_TRUE(check.passed) << check.name << ": measured " << check.measured << ", expected " << check.expected
                              << ", tolerance " << check.tolerance;
}

TEST(MonitorStudy, LooksAtEveryElementAndLaw) {
  std::int64_t trials = 0;
  for (const auto& row : table("bracket").rows) {
    EXPECT_GE(std::get<std::int64_t>(row[1]), 25);
    trials += std::get<std::int64_t>(row[1]);
  }
  EXPECT_GE(trials, 150);
  EXPECT_EQ(table("drift").rows.size(), 16u);
  for (const auto& row : table("drift").rows) EXPECT_GE(std::get<std::int64_t>(row[2]), 2500);
}

TEST(MonitorStudy, TablesAreRectangularAndFiguresHavePoints) {
  for (const StudyTable& t : quickReport().tables)
    for (const auto& row : t.rows) EXPECT_EQ(row.size(), t.columns.size()) << t.name;
  EXPECT_GE(quickReport().figures.size(), 7u);
  for (const StudyFigure& figure : quickReport().figures) EXPECT_GE(figure.curves.front().x.size(), 3u) << figure.name;
}

}  // namespace
}  // namespace ringwatch
