#include <cmath>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <ringwatch/base/error.h>
#include <ringwatch/monitor/bounds/global_frequency.h>
#include <ringwatch/monitor/critical_step.h>
#include <ringwatch/monitor/metrics/metrics.h>
#include <ringwatch/python/arrays.h>
#include <ringwatch/python/held.h>
#include <ringwatch/python/results.h>
#include <ringwatch/python/signatures.h>

namespace ringwatch::python {
namespace {

/// The side of the critical step on which a metric's step lies.
std::string_view sideOf(Direction frequency) {
  return frequency == Direction::upperBound ? "safe" : frequency == Direction::lowerBound ? "optimistic" : "estimate";
}

py::object metricResult(const MetricResult& metric, const StepRule& rule) {
  static const ResultType& type = *new ResultType("Metric", 5);
  py::list blocks;
  for (const std::vector<double>& lambda : metric.elementLambda) {
    std::vector<double> steps;
    steps.reserve(lambda.size());
    for (const double value : lambda) steps.push_back(rule(value));
    blocks.append(ownedArray(std::move(steps)));
  }
  return type(text(metric.info->name), text(sideOf(metric.direction)), real(rule(metric.lambda)),
              pairOf(metric.controlling), py::tuple(blocks));
}

py::object inspect(HeldBody& held, const py::object& positions, double limit, const std::vector<std::string>& names,
                   bool exact, double width) {
  static const ResultType& type = *new ResultType("Inspection", 10);
  const Body& body = held.body;
  if (!(limit > 0) || !std::isfinite(limit))
    throw InputError(joinText("limit = ", limit, ": must be > 0 and finite, an integrator's largest stable h omega"));
  const NodeVectorsView x =
      positions.is_none() ? NodeVectorsView(body.mesh().X) : nodalOf("x", positions, body.nodeCount());
  for (const std::string& name : names) metricDirection(name, body);  // throws before anything is computed
  const StepRule rule(limit);
  CriticalStep step;
  ElementCause cause;
  GlobalFrequency global;
  std::vector<MetricResult> metrics;
  reading(held, [&] {
    step = criticalStep(body, x, rule, {.width = width});
    cause = elementCause(body, x, step.controlling);
    if (exact) global = globalFrequency(body, x);
    for (const std::string& name : names) metrics.push_back(evaluateMetric(name, body, x));
  });
  if (exact && !global.converged)
    throw NumericalError(joinText("the global eigenvalue did not converge after ", global.products,
                                  " tangent products; the bracket holds without it"));
  py::dict named;
  for (const MetricResult& metric : metrics) named[text(metric.info->name)] = metricResult(metric, rule);
  return type(real(step.safe), real(step.optimistic), exact ? real(rule(global.lambda)) : py::object(py::none()),
              elementResult(body.mesh(), step.controlling), causeResult(cause), text(step.safeBy),
              text(step.optimisticBy), negativeOrNone(step), real(limit), std::move(named));
}

}  // namespace

void bindInspect(py::module_& module) {
  bindFunction(module, "inspect", &inspect,
               "The critical step of a body at positions x ((N, 3), m; at rest without them), as `ringwatch inspect` "
               "gives it.\n\nlimit: the integrator's largest stable h omega. metrics: names, for the steps of all "
               "elements. exact: also the\ncritical step itself, by a global eigenvalue. width: optimistic over safe "
               "step, less 1, that is narrow "
               "enough; more is\nfaster. Raises InputError; "
               "NumericalError where the tangent is not finite.",
               "", py::arg("body"), py::arg("x") = py::none(), py::kw_only(), py::arg("limit") = 2.0,
               py::arg("metrics") = std::vector<std::string>{"reduced-1-ring"}, py::arg("exact") = false,
               py::arg("width") = CriticalStepOptions{}.width);
  bindFunction(
      module, "metric_names",
      [] {
        py::list names;
        for (const MetricInfo& info : allMetrics()) names.append(text(info.name));
        return py::tuple(names);
      },
      "The metrics, as `ringwatch help metrics` lists them.", "");
}

}  // namespace ringwatch::python
