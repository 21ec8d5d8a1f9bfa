// The element study itself: every check passes, and what is deficient is shown as deficient.
#include <gtest/gtest.h>

#include <string>

#include <ringwatch/elements/registry.h>
#include <ringwatch/verify/elements.h>

namespace ringwatch {
namespace {

const StudyReport& report() {
  static const StudyReport made = verifyElements(StudyEffort::quick);
  return made;
}
const StudyTable& table(const std::string& name) {
  for (const StudyTable& t : report().tables)
    if (t.name == name) return t;
  throw std::runtime_error("no table " + name);
}

TEST(ElementStudy, EveryCheckPasses) {
  for (const StudyCheck& check : report().checks)
    EXPECT_TRUE(check.passed) << check.name << ": " << check.measured << " against " << check.expected << " ± "
                              << check.tolerance;
  EXPECT_TRUE(report().passed());
}

TEST(ElementStudy, CoversEveryElementAndRule) {
  std::size_t rules = 0;
  for (const ElementInfo& element : allElements()) rules += element.rules.size();
  EXPECT_EQ(table("rank").rows.size(), rules);
  EXPECT_EQ(table("shapes").rows.size(), allElements().size());
}

TEST(ElementStudy, ShowsTheDeficientRules) {
  int deficient = 0;
  for (const auto& row : table("rank").rows) {
    const std::string rule = std::get<std::string>(row[0]) + " " + std::get<std::string>(row[1]);
    const std::int64_t expected = rule == "wedge6 source" ? 1 : rule == "hex20 gauss-2x2x2" ? 6 : 0;
    EXPECT_EQ(std::get<std::int64_t>(row[4]), expected) << rule;
    deficient += std::get<std::string>(row[7]) == "deficient";
  }
  EXPECT_EQ(deficient, 2);
}

TEST(ElementStudy, TablesAreRectangularAndFiguresHaveCurves) {
  for (const StudyTable& t : report().tables) {
    EXPECT_FALSE(t.rows.empty()) << t.name;
    for (const auto& row : t.rows) EXPECT_EQ(row.size(), t.columns.size()) << t.name;
  }
  EXPECT_EQ(report().figures.size(), 3u);
  for (const StudyFigure& figure : report().figures) {
    EXPECT_FALSE(figure.curves.empty());
    for (const auto& curve : figure.curves) {
      EXPECT_FALSE(curve.x.empty());
      EXPECT_EQ(curve.x.size(), curve.y.size());
    }
  }
}

}  // namespace
}  // namespace ringwatch
