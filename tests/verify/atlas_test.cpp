// Step rules of other solvers against the exact step: on shapes and meshes, and judged.
#include <gtest/gtest.h>

#include <cmath>

#include <ringwatch/base/error.h>
#include <ringwatch/meshes/generators/generators.h>
#include <ringwatch/monitor/critical_step.h>
#include <ringwatch/monitor/metrics/metrics.h>
#include <ringwatch/verify/monitor/monitor_histories.h>
#include <ringwatch/verify/step_rules/atlas.h>
#include <ringwatch/verify/step_rules/judge.h>

#include "report_tools.h"

namespace ringwatch {
namespace {

/// A number of a table by the text of its first column.
double numberIn(const StudyTable& table, const std::string& row, const std::string& column) {
  for (const auto& cells : table.rows)
    for (std::size_t c = 1; std::get<std::string>(cells[0]) == row && c < cells.size(); ++c)
      if (table.columns[c] == column) return std::get<double>(cells[c]);
  ADD_FAILURE() << row << ", " << column;
  return std::nan("");
}

TEST(VerifyAtlas, HoldsAndMeetsClosedForms) {
  const StudyReport report = verifyAtlas(StudyEffort::quick);
  test::expectHolds(report);
  const auto at = [&](const std::string& mesh, const std::string& column) {
    return numberIn(test::tableOf(report, "step-rules"), mesh, column);
  };
  // Cubes of 2 cm, c = 36.69 m/s: edges and heights are 545.1 us, the diameter √3 of it, CalculiX's rule 0.767 of it.
  const double speed = std::sqrt(1e6 * 0.7 / (1.3 * 0.4) / 1000), edge = 1e6 * 0.02 / speed;
  const double exact = at("hex8", "exact (us)");
  EXPECT_NEAR(at("hex8", "shortest edge"), edge / exact, 6e-4);
  EXPECT_NEAR(at("hex8", "diameter"), std::sqrt(3) * edge / exact, 6e-4);
  EXPECT_NEAR(at("hex8", "CalculiX"), 0.76689 * edge / exact, 6e-4);
  EXPECT_NEAR(at("hex8", "dilatational"), edge / std::sqrt(3) / exact, 6e-4);
  EXPECT_NEAR(at("hex8", "V / max A"), edge / exact, 6e-4);
  EXPECT_NEAR(at("hex8", "nodal"), edge / exact, 6e-4);
  EXPECT_NEAR(at("wedge6", "CalculiX") / at("wedge6", "V / max A"), 0.76689 / 2, 2e-3);

  // Of a linear tetrahedron with heights h_a and c the speed of pressure waves, (2 c/h)² <= lambda <= 4 c² Σ 1/h_a²: a
  // corner that moves along its height alone has the frequency 2 c/h, and λ (tr H)² + 2 μ |sym H|² <= (λ + 2 μ) Σ
  // 1/h_a² for gradients H of nodes that move by 1 in all. So the least height is above the exact step, by 2 at most,
  // the dilatational rule below, V / max A = h/3 by 2/3 at most, and the in-radius, 1 / Σ 1/h_a, below.
  const StudyTable &unsafe = test::tableOf(report, "unsafe"), &largest = test::tableOf(report, "largest");
  constexpr double ofPrinted = 5e-4;
  for (const char* family : {"tetrahedra", "slivers", "caps", "spades", "flat wedges", "spires", "spears", "spindles",
                             "spikes", "splinters"}) {
    SCOPED_TRACE(family);
    EXPECT_EQ(numberIn(unsafe, family, "least height (%)"), 100);
    EXPECT_LE(numberIn(largest, family, "least height"), 2 + ofPrinted);
    EXPECT_LE(numberIn(largest, family, "V / max A"), 2.0 / 3 + ofPrinted);
    EXPECT_EQ(numberIn(unsafe, family, "dilatational (%)"), 0);
    EXPECT_EQ(numberIn(unsafe, family, "in-radius (%)"), 0);
  }
}

TEST(Judge, FindsTheWorstOfAnUnsafeRuleAndNothingInASafeOne) {
  JudgeOptions options;
  options.shapesOfFamily = 3;
  options.elements = {"tet4", "wedge6"};
  BarOptions bar;
  bar.cells = {3, 1, 1};
  options.meshes.emplace_back("bar", generateBar(bar));
  const auto times = [](double factor) {
    return [factor](const Mesh& mesh, double young, double poisson, double density) {
      const Body body(mesh, makeMaterial("linear", young, poisson, density));
      return factor * stepFor(evaluateMetric("single-element", body, mesh.X).lambda, 2);
    };
  };
  const Judgement safe = judgeRule(times(1), options);
  test::expectHolds(safe.report);
  EXPECT_FALSE(safe.worst);
  const Judgement unsafe = judgeRule(times(2), options);
  EXPECT_FALSE(unsafe.report.passed());
  ASSERT_TRUE(unsafe.worst);
  const StudyTable& table = test::tableOf(unsafe.report, "judge");
  for (const char* family : {"tetrahedra", "splinters", "wedges"}) {
    EXPECT_NEAR(numberIn(table, family, "largest step over exact"), 2, 1e-6) << family;
  }
  const Body worst(unsafe.worst->mesh,
                   makeMaterial("linear", unsafe.worst->young, unsafe.worst->poisson, unsafe.worst->density));
  const CriticalStep bracket = criticalStep(worst, worst.mesh().X, 2);
  EXPECT_LE(bracket.safe, unsafe.worst->exact * (1 + 1e-9));
  EXPECT_GE(bracket.optimistic, unsafe.worst->exact * (1 - 1e-9));
  EXPECT_NEAR(unsafe.worst->given / unsafe.worst->exact, 2, 1e-6);
  options.histories = true;
  options.shapesOfFamily = 0;
  const Judgement moved = judgeRule([](const Mesh&, double, double, double) { return 1e-9; }, options);
  EXPECT_EQ(test::tableOf(moved.report, "judge").rows.size(), 1 + detail::monitorHistories(StudyEffort::quick).size());
  EXPECT_TRUE(moved.report.passed());
}

TEST(Judge, RefusesWhatItCannotJudge) {
  const auto one = [](const Mesh&, double, double, double) { return 1.0; };
  JudgeOptions quadratic;
  quadratic.elements = {"hex20"};
  EXPECT_THROW(judgeRule(one, quadratic), InputError);
  for (const double given : {0.0, -1.0, std::nan(""), HUGE_VAL})
    EXPECT_THROW(judgeRule([given](const Mesh&, double, double, double) { return given; }, {}), InputError) << given;
}

}  // namespace
}  // namespace ringwatch
