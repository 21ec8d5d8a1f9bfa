#pragma once
#include <cmath>
#include <limits>
#include <string>

#include <ringwatch/base/error.h>
#include <ringwatch/monitor/metrics/metrics.h>
#include <ringwatch/monitor/stability_monitor.h>
#include <tests/monitor/monitor_cases.h>

namespace ringwatch::test {

constexpr double limit = 2;  // of h·omega, as symplectic Euler's

/// Checks every metric and the bracket at a state; returns what went wrong, "" when nothing did.
inline std::string boundsFault(const Body& body, const NodeVectors& x) {
  std::string fault;
  const DenseTangent dense(body, x);
  if (!dense.finite()) {
    // The law is undefined here (an inverted element): then nothing may look like a bound.
    for (const MetricInfo& metric : allMetrics())
      if (metric.direction != Direction::estimate && std::isfinite(evaluateMetric(metric.name, body, x).lambda))
        fault += joinText(metric.name, " gives a number without a tangent; ");
    try {
      const CriticalStep step = criticalStep(body, x, limit);
      fault += joinText("safe = ", step.safe, " without a tangent; ");
    } catch (const NumericalError&) {
    }
    return fault;
  }
  // Constrained components stay in the metrics' matrices as zero rows, so that no value falls below 0.
  const double lambda = std::max(0.0, dense.largest());
  const double size = dense.matrix.rows() ? dense.matrix.cwiseAbs().maxCoeff() : 0;
  for (const MetricInfo& metric : allMetrics()) {
    const MetricResult result = evaluateMetric(metric.name, body, x);
    if (!std::isfinite(result.lambda)) fault += joinText(metric.name, " is ", result.lambda, "; ");
    if (result.direction == Direction::upperBound && !(result.lambda >= lambda * (1 - 1e-9) - 1e-12 * size))
      fault += joinText(metric.name, " = ", result.lambda, " is below ", lambda, "; ");
    if (result.direction == Direction::lowerBound && !(result.lambda <= lambda * (1 + 1e-9) + 1e-12 * size))
      fault += joinText(metric.name, " = ", result.lambda, " is above ", lambda, "; ");
    double most = -std::numeric_limits<double>::infinity();
    for (const auto& block : result.elementLambda)
      for (const double value : block) most = std::max(most, value);
    const auto controlling = result.elementLambda[result.controlling.block][result.controlling.element];
    if (most != result.lambda || controlling != most)
      fault += joinText(metric.name, ": its controlling element is not its largest; ");
  }
  const CriticalStep step = criticalStep(body, x, limit);
  const double exact = stepFor(lambda, limit);
  if (!(step.safe <= exact * (1 + 1e-9))) fault += joinText("safe = ", step.safe, " is above ", exact, "; ");
  if (!(step.optimistic >= exact * (1 - 1e-9)))
    fault += joinText("optimistic = ", step.optimistic, " is below ", exact, "; ");
  if (!(step.safe > 0)) fault += joinText("safe = ", step.safe, "; ");
  const double least = dense.matrix.rows() ? dense.eigenvalues()[0] : 0;
  if (!(step.lowestRing >= std::min(0.0, least) * (1 + 1e-9) - 1e-10 * size))
    fault += joinText("lowest ring ", step.lowestRing, " is below ", least, "; ");
  if (step.lowestRing < 0 && !(least < 0))
    fault += joinText("calls a tangent indefinite whose least eigenvalue is ", least, "; ");
  return fault;
}

}  // namespace ringwatch::test
