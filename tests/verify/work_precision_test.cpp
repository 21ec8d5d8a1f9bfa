// The study behind `ringwatch compare`: references that converge or say so, errors of known order, counted cost, and
// who is cheapest.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include <ringwatch/base/error.h>
#include <ringwatch/integrators/body_system.h>
#include <ringwatch/meshes/generators/generators.h>
#include <ringwatch/monitor/bounds/global_frequency.h>
#include <ringwatch/verify/work_precision/work_precision.h>

#include "report_tools.h"

namespace ringwatch {
namespace {

const State unit{0, NodeVectors::Ones(3, 1), NodeVectors::Zero(3, 1)};

WorkPrecisionCase swing(Oscillator& oscillator, double end) {
  return {"oscillator",
          "Oscillator",
          oscillator,
          unit,
          end,
          1,
          NodeVectors::Constant(3, 1, oscillator.exact(end, 1, 0)[0]),
          0,
          {}};
}

TEST(WorkPrecision, ReferenceConvergesToTheClosedForm) {
  for (const double dampingRatio : {0.0, 0.2}) {
    Oscillator oscillator(1, dampingRatio);
    const ConvergedMotion motion = convergedMotion(oscillator, unit, 20, 1, 1e-10);
    EXPECT_NEAR(motion.x(0, 0), oscillator.exact(20, 1, 0)[0], 1e-9);
    EXPECT_LE(motion.change, 1e-10);
    EXPECT_LT(motion.h, 0.4);
  }
}

/// Pushes away, faster and faster: no end to converge to in double precision.
class Runaway final : public SecondOrderSystem {
 public:
  void acceleration(double, const NodeVectors& x, const NodeVectors&, NodeVectors& a) override {
    a = x.cwiseAbs2().cwiseProduct(x);
  }
};
TEST(WorkPrecision, SaysSoWhenThereIsNoReference) {
  Runaway system;
  EXPECT_THROW(convergedMotion(system, unit, 20, 1), NumericalError);
}

/// Accelerates by what rounding of forces in balance leaves.
class Balanced final : public SecondOrderSystem {
 public:
  explicit Balanced(double left) : left_(left) {}
  void acceleration(double, const NodeVectors& x, const NodeVectors&, NodeVectors& a) override {
    a = NodeVectors::Constant(x.rows(), x.cols(), left_);
  }

 private:
  double left_;
};
TEST(WorkPrecision, SaysSoWhenNothingMoves) {
  State start = unit;
  start.v.setZero();
  for (const double left : {0.0, 1e-17}) {
    Balanced system(left);
    const ConvergedMotion motion = convergedMotion(system, start, 20, 1);
    EXPECT_FALSE(motion.moves) << left;
    EXPECT_EQ(motion.change, 0) << left;
  }
  Balanced pushed(1e-6);
  EXPECT_TRUE(convergedMotion(pushed, start, 20, 1).moves);
}

TEST(WorkPrecision, ErrorsFallByTheOrderAndCostIsCounted) {
  Oscillator oscillator;
  const WorkPrecisionCase c = swing(oscillator, 20);
  WorkPrecisionOptions options;
  options.steps = {0.1, 0.05};
  int announced = 0;
  options.progress = [&](const std::string&, double share) {
    EXPECT_GE(share, 0);
    EXPECT_LT(share, 1);
    ++announced;
  };
  const std::vector<WorkPrecisionRun> runs = runWorkPrecision(c, coreIntegrators(), options);
  ASSERT_EQ(runs.size(), 2 * coreIntegrators().size());
  EXPECT_EQ(announced, static_cast<int>(runs.size()));
  for (std::size_t i = 0; i < coreIntegrators().size(); ++i) {
    const IntegratorInfo& info = *coreIntegrators()[i].info;
    const WorkPrecisionRun &coarse = runs[2 * i], &fine = runs[2 * i + 1];
    EXPECT_EQ(coarse.integrator, info.name);
    EXPECT_EQ(fine.reason, "");
    if (info.imaginaryLimit > 0) {
      EXPECT_NEAR(std::log2(coarse.error / fine.error), info.order, 0.2) << info.name;
    }
    EXPECT_NEAR(fine.forces, 400 * info.forceEvaluations, 1) << info.name;  // Verlet starts with one more
    EXPECT_EQ(fine.products, 0);
    EXPECT_GT(fine.seconds, 0);
  }
}

TEST(WorkPrecision, LostRunsHaveNoError) {
  Oscillator oscillator;
  const WorkPrecisionCase c = swing(oscillator, 4000);
  WorkPrecisionOptions options;
  options.steps = {8};
  for (const WorkPrecisionRun& run : runWorkPrecision(c, coreIntegrators(), options)) {
    EXPECT_TRUE(std::isnan(run.error)) << run.integrator;
    EXPECT_THAT(run.reason, ::testing::HasSubstr("not finite")) << run.integrator;
  }
}

TEST(WorkPrecision, CheapestIsTheOneThatReachesTheErrorForLeast) {
  const std::vector<WorkPrecisionRun> runs{{"fast", 1, 5e-3, 1, 100, 0, 0, {}},
                                           {"few", 1, 9e-3, 2, 10, 5, 0, {}},
                                           {"good", 1, 1e-4, 7, 500, 0, 0, {}},
                                           {"lost", 1, std::nan(""), 0.1, 1, 0, 0, "lost"}};
  const std::vector<CheapestRuns> cheapest = cheapestRuns(runs);
  ASSERT_EQ(cheapest.size(), 3u);
  EXPECT_EQ(cheapest[0].byTime->integrator, "fast");
  EXPECT_EQ(cheapest[0].byForces->integrator, "few");
  EXPECT_EQ(cheapest[1].byTime->integrator, "good");
  EXPECT_EQ(cheapest[2].byTime, nullptr);
}

TEST(WorkPrecision, ReportHoldsTablesAndPictures) {
  StudyReport report;
  int cases = 0;
  addStandardCases(coreIntegrators().subspan(2, 1), 2, 0.02, report,
                   [&](const WorkPrecisionCase& c, const std::vector<WorkPrecisionRun>& runs) {
                     ++cases;
                     EXPECT_LT(c.referenceError, 1e-8);
                     ASSERT_FALSE(runs.empty());
                     EXPECT_LT(runs.back().error, 0.3 * runs.front().error) << c.name;
                   });
  EXPECT_EQ(cases, 3);
  test::expectHolds(report, 0);  // it only measures
  std::set<std::string> tables, figures;
  for (const std::string name : {"oscillator", "bar", "slivers"}) {
    tables.insert({name + "_runs", name + "_cheapest"});
    figures.insert({"work_precision_" + name + "_time", "work_precision_" + name + "_forces"});
  }
  EXPECT_EQ(test::tableNames(report), tables);
  EXPECT_EQ(test::figureNames(report), figures);
}

TEST(WorkPrecision, RefinedBarComparesBothSides) {
  StudyReport report;
  addRefinedBar([] { return makeIntegrator("verlet"); }, 1, report);  // stable at one step a millisecond on 10 cells
  ASSERT_EQ(report.tables.size(), 1u);
  ASSERT_EQ(report.tables[0].rows.size(), 1u);
  EXPECT_EQ(std::get<std::int64_t>(report.tables[0].rows[0][0]), 60);
  EXPECT_EQ(report.figures[0].curves.size(), 2u);
}

}  // namespace
}  // namespace ringwatch
