// The one mesh of Fierz 2013 that can be rebuilt exactly (table 3.2): 5×5×5 cells of 1 cm, five tetrahedra
// a cell, E = 1 Pa, ν = 0.45, ρ = 1 kg/m³. Tolerances are half a unit in the last digit given.
#include <gtest/gtest.h>

#include <ringwatch/base/error.h>
#include <ringwatch/monitor/bounds/global_frequency.h>
#include <ringwatch/monitor/metrics/metrics.h>
#include <ringwatch/monitor/stability_monitor.h>
#include <tests/monitor/monitor_cases.h>

namespace ringwatch {
namespace {

class RegularCube : public ::testing::Test {
 protected:
  static Body makeBody() {
    BarOptions options;
    options.element = "tet4";
    options.split = 5;
    return Body(generateCube(0.05, 5, options), makeMaterial("linear", 1, 0.45, 1), test::onThreads(1));
  }
  double metric(std::string_view name) const { return evaluateMetric(name, body_, body_.mesh().X).lambda; }
  /// (true - estimate) / true of omega, in per cent.
  double difference(std::string_view name) const { return 100 * (1 - std::sqrt(metric(name)) / omega_); }

  const Body body_ = makeBody();
  const double omega_ = std::sqrt(globalFrequency(body_, body_.mesh().X).lambda);
};

TEST_F(RegularCube, HasItsNodesAndElements) {
  EXPECT_EQ(body_.nodeCount(), 216);
  EXPECT_EQ(body_.mesh().elementCount(), 625u);
  EXPECT_NEAR(body_.volume(), 0.05 * 0.05 * 0.05, 1e-17);
}
TEST_F(RegularCube, GlobalFrequency) { EXPECT_NEAR(omega_, 704.90, 0.005); }
TEST_F(RegularCube, SingleElement) { EXPECT_NEAR(difference("single-element"), -29.2, 0.05); }
TEST_F(RegularCube, PressureWave) { EXPECT_NEAR(difference("pressure-wave"), 4.3, 0.05); }
TEST_F(RegularCube, ReducedRing) { EXPECT_NEAR(difference("reduced-1-ring"), 0.16, 0.005); }
TEST_F(RegularCube, Shewchuk) {
  // This row of Fierz 2013 is consistent with a difference in omega².
  EXPECT_NEAR(100 * (1 - metric("shewchuk") / (omega_ * omega_)), -3062, 0.5);
}
TEST_F(RegularCube, LiesInTheBracket) {
  const CriticalStep step = criticalStep(body_, body_.mesh().X, 2);
  EXPECT_LE(step.safe, 2 / omega_);
  EXPECT_GE(step.optimistic, 2 / omega_ * (1 - 1e-12));
  EXPECT_GE(step.safe, 0.95 * 2 / omega_);
}

}  // namespace
}  // namespace ringwatch
