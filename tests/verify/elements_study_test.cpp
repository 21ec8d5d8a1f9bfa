// The element study: its criteria, and what is deficient is shown as deficient.
#include <gtest/gtest.h>

#include <string>

#include <ringwatch/elements/registry.h>
#include <ringwatch/verify/elements/elements.h>

#include "report_tools.h"

namespace ringwatch {
namespace {

const StudyReport& elementsReport() {
  static const StudyReport made = verifyElements(StudyEffort::quick);
  return made;
}

TEST(ElementStudy, HoldsElementsToTheirCriteria) { test::expectHolds(elementsReport()); }

TEST(ElementStudy, CoversEveryElementAndRule) {
  std::set<std::string> elements, rules;
  for (const ElementInfo& element : allElements()) {
    elements.insert(std::string(element.name));
    for (const QuadratureRule& rule : element.rules)
      rules.insert(std::string(element.name) + " " + std::string(rule.name));
  }
  std::set<std::string> ranked;
  for (const auto& row : test::tableOf(elementsReport(), "rank").rows)
    ranked.insert(std::get<std::string>(row[0]) + " " + std::get<std::string>(row[1]));
  EXPECT_EQ(ranked, rules);
  EXPECT_EQ(test::textsOf(test::tableOf(elementsReport(), "shapes"), 0), elements);
  EXPECT_EQ(test::textsOf(test::tableOf(elementsReport(), "derivatives"), 0), elements);
  EXPECT_EQ(test::textsOf(test::tableOf(elementsReport(), "convergence"), 0), elements);
  EXPECT_EQ(test::textsOf(test::tableOf(elementsReport(), "frequencies"), 1), elements);
}

TEST(ElementStudy, ShowsTheDeficientRules) {
  std::set<std::string> deficient;
  for (const auto& row : test::tableOf(elementsReport(), "rank").rows) {
    const std::string rule = std::get<std::string>(row[0]) + " " + std::get<std::string>(row[1]);
    const std::int64_t expected = rule == "wedge6 fierz2013" ? 1 : rule == "hex20 gauss-2x2x2" ? 6 : 0;
    EXPECT_EQ(std::get<std::int64_t>(row[4]), expected) << rule;
    if (std::get<std::string>(row[7]) == "deficient") deficient.insert(rule);
  }
  EXPECT_EQ(deficient, (std::set<std::string>{"wedge6 fierz2013", "hex20 gauss-2x2x2"}));
}

TEST(ElementStudy, DrawsWhatItMeasured) {
  EXPECT_EQ(test::figureNames(elementsReport()),
            (std::set<std::string>{"elements-error-size", "elements-tip-error-size", "elements-tip-error-time"}));
  for (const StudyFigure& figure : elementsReport().figures)
    for (const StudyFigure::Curve& curve : figure.curves) EXPECT_GE(curve.x.size(), 2u) << figure.name;
}

}  // namespace
}  // namespace ringwatch
