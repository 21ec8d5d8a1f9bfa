#pragma once
#include <ringwatch/monitor/metrics/element_metrics.h>
#include <ringwatch/monitor/metrics/metrics.h>

namespace ringwatch::test {

/// A metric added from outside: twice each element's own eigenvalue.
inline MetricValues doubled(const Body& body, NodeVectorsView x, const MetricProgress&) {
  MetricValues values = singleElement(body, x);
  for (auto& block : values)
    for (double& value : block) value *= 2;
  return values;
}
inline constexpr MetricEntry doubledMetric{{"doubled", "twice the element's own", Direction::upperBound}, doubled};

}  // namespace ringwatch::test
