#include <ringwatch/monitor/metrics/stiff_elements.h>

#include <ringwatch/monitor/metrics/metrics.h>

namespace ringwatch {

std::vector<ElementRef> stiffElements(const Body& body, NodeVectorsView x, double h, double limit) {
  const MetricResult own = evaluateMetric("single-element", body, x);
  const double allowed = (limit / h) * (limit / h);
  std::vector<ElementRef> elements;
  for (std::size_t b = 0; b < own.elementLambda.size(); ++b)
    for (std::size_t e = 0; e < own.elementLambda[b].size(); ++e)
      if (!(own.elementLambda[b][e] <= allowed)) elements.push_back({b, e});
  return elements;
}

}  // namespace ringwatch
