// What the monitor says does not depend on the number of threads, to the last bit.
#include <gtest/gtest.h>

#include <ringwatch/base/error.h>
#include <ringwatch/monitor/bounds/global_frequency.h>
#include <ringwatch/monitor/bounds/nodal_bound.h>
#include <ringwatch/monitor/bounds/reduced_ring.h>
#include <ringwatch/monitor/energy_balance.h>
#include <ringwatch/monitor/metrics/metrics.h>
#include <ringwatch/monitor/stability_monitor.h>
#include <tests/monitor/monitor_cases.h>

namespace ringwatch {
namespace {

/// Everything that the monitor computes of a body at a state, as numbers.
std::vector<double> everything(const test::Subdivision& subdivision, int threads) {
  // Enough elements and nodes that every loop is cut into several pieces.
  Body body = test::boxBody(subdivision, "stvk", {10, 7, 7}, 0.2, 3, threads);
  test::holdBody(body, test::Hold::face);
  test::Random random(11);
  const NodeVectors x = Eigen::Vector3d(1.3, 0.95, 0.95).asDiagonal() * body.mesh().X +
                        random.nodeVectors(body.nodeCount(), 0.05 * test::cellSize);
  const NodeVectors v = random.nodeVectors(body.nodeCount(), 1);
  std::vector<double> numbers;
  for (const MetricInfo& metric : allMetrics()) {
    const MetricResult result = evaluateMetric(metric.name, body, x);
    numbers.push_back(result.lambda);
    numbers.push_back(result.controlling.element);
    for (const auto& block : result.elementLambda) numbers.insert(numbers.end(), block.begin(), block.end());
  }
  NodalBound bound(body);
  numbers.push_back(bound.evaluate(x, 3).value);
  numbers.insert(numbers.end(), bound.nodal().begin(), bound.nodal().begin() + body.nodeCount());
  ReducedRing ring(body);
  const ReducedRing::Result& rings = ring.evaluate(x, true);
  numbers.insert(numbers.end(), {rings.highest, rings.lowest, double(rings.highestElement.element),
                                 double(rings.lowestElement.element)});
  const GlobalFrequency global = globalFrequency(body, x, 1e-6);
  EXPECT_TRUE(global.converged);
  numbers.push_back(global.lambda);
  EnergyBalance balance(body);
  const Energies energies = balance.evaluate(x, v);
  numbers.insert(numbers.end(), {energies.kinetic, energies.strain});
  MonitorOptions options;
  options.metric = "reduced-1-ring";
  StabilityMonitor monitor(body, options);
  for (int step = 0; step < 5; ++step) {
    const MonitorReport& report = monitor.observe(step, 0, x + step * 1e-4 * v, v, 1e-3);
    monitor.observeEnergies(energies);
    numbers.insert(numbers.end(),
                   {report.bracket->safe, report.bracket->optimistic, double(report.bracket->controlling.element),
                    report.bracket->lowestRing, *report.metricStep, double(report.verdict)});
  }
  return numbers;
}

class Threads : public ::testing::TestWithParam<test::Subdivision> {};
INSTANTIATE_TEST_SUITE_P(Subdivisions, Threads, ::testing::ValuesIn(test::allSubdivisions()),
                         [](const auto& test) { return test::testName(test.param.name); });

TEST_P(Threads, DoNotChangeABit) {
  const std::vector<double> one = everything(GetParam(), 1);
  EXPECT_EQ(everything(GetParam(), 2), one);
  EXPECT_EQ(everything(GetParam(), 3), one);
}

}  // namespace
}  // namespace ringwatch
