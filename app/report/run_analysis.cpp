#include <ringwatch/app/report/run_analysis.h>

#include <algorithm>
#include <cmath>

#include <ringwatch/app/command/integrator_catalog.h>
#include <ringwatch/app/output/frames.h>
#include <ringwatch/app/scene/scene.h>
#include <ringwatch/base/error.h>
#include <ringwatch/handlers/handler.h>
#include <ringwatch/handlers/selection/certified_selection.h>
#include <ringwatch/integrators/integrator.h>
#include <ringwatch/meshes/mesh_io.h>
#include <ringwatch/monitor/critical_step.h>
#include <ringwatch/monitor/metrics/metrics.h>

namespace ringwatch {
namespace {

/// Certified selections take 20 µs an element and step.
constexpr std::size_t whatIfUpTo = 20000;

/// The rules of thumb of explicit codes, and the two proven sides beside them.
constexpr const char* rulesOfThumb[] = {"pressure-wave:min-height", "pressure-wave:volume-over-area",
                                        "pressure-wave:in-radius",  "pressure-wave:shortest-edge",
                                        "single-element",           "reduced-1-ring"};

}  // namespace

RunAnalysis analyseRun(const std::filesystem::path& folder, const std::filesystem::path& frame,
                       std::optional<double> safe, std::optional<double> optimistic, std::optional<double> taken) {
  RunAnalysis analysis;
  analysis.safe = safe;
  analysis.optimistic = optimistic;
  analysis.taken = taken;
  Scene scene = sceneOfRun(folder);
  MeshState state = loadVtuState(folder / frame, "displacement");
  analysis.elements = state.mesh.elementCount();
  const Body body = sceneBody(scene, std::move(state.mesh), 0);
  const IntegratorInfo* integrator = integratorCatalog().find(scene.method);
  if (!integrator || !(integrator->imaginaryLimit > 0) || std::isinf(integrator->imaginaryLimit)) {
    analysis.whyNoRules = analysis.whyNoWhatIf = "Left out: the integrator " + scene.method + " has no critical step.";
    return analysis;
  }
  const StepRule rule = stepRule(*integrator, scene.damping);
  // With a handler the run's bracket is that of the elements that it left explicit; in other modes there is half of
  // one.
  if (!scene.handler.empty() || !safe || !optimistic) {
    analysis.safe = analysis.optimistic = std::nullopt;
    if (analysis.elements <= bracketedElements && rule.proven()) {
      const CriticalStep bracket = criticalStep(body, state.x, rule);
      analysis.safe = bracket.safe;
      analysis.optimistic = bracket.optimistic;
    }
  }
  std::vector<MetricResult> metrics;
  for (const char* name : rulesOfThumb) metrics.push_back(evaluateMetric(name, body, state.x));
  analysis.distributions = distributionsOf(metrics, rule);
  for (const MetricResult& metric : metrics)
    analysis.rules.push_back({std::string(metric.info->name), std::string(metric.info->help),
                              std::string(stepSide(metric.direction)), rule(metric.lambda)});

  const HandlerOptions options;
  if (analysis.elements > whatIfUpTo) {
    analysis.whyNoWhatIf =
        "Left out for a mesh of more than 20 000 elements: ringwatch inspect DIR --frame 1 --step h "
        "computes it for a step.";
  } else if (!takesHandler(*integrator)) {
    analysis.whyNoWhatIf = "Left out: no handler goes with the integrator " + scene.method + ".";
  } else if (scene.damping.any()) {
    analysis.whyNoWhatIf = "Left out: handlers are chosen for undamped bodies, and this run is damped.";
  } else if (!analysis.safe || !(*analysis.safe > 0)) {
    analysis.whyNoWhatIf = "Left out: the run's first frame has no bracket of the whole body to start from.";
  } else {
    std::vector<double> steps;
    for (const double factor : {1.0, 1.1, 1.25, 1.5, 2.0, 3.0}) steps.push_back(factor * *analysis.safe);
    if (taken && *taken > 0) steps.push_back(*taken);
    std::sort(steps.begin(), steps.end());
    for (const double h : steps) {
      WhatIf row{h, 0, h <= *analysis.safe};
      if (!row.proven) {
        const double omega = (1 - options.margin) * integrator->imaginaryLimit / h;
        row.elements = chosenElements(selectCertified(body, state.x, omega * omega).chosen).size();
      }
      analysis.whatIf.push_back(row);
    }
  }
  return analysis;
}

}  // namespace ringwatch
