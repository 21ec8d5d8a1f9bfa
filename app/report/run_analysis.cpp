#include <ringwatch/app/report/run_analysis.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>

#include <ringwatch/app/command/integrator_catalog.h>
#include <ringwatch/app/output/frames.h>
#include <ringwatch/app/scene/scene.h>
#include <ringwatch/app/scene/scene_discrete.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/handlers/handler.h>
#include <ringwatch/handlers/selection/selection.h>
#include <ringwatch/integrators/body_system.h>
#include <ringwatch/integrators/integrator.h>
#include <ringwatch/meshes/mesh_io.h>
#include <ringwatch/monitor/critical_step.h>
#include <ringwatch/monitor/metrics/metrics.h>

namespace ringwatch {
namespace {

/// Certified selections take 20 µs an element and step.
constexpr std::size_t whatIfUpTo = 20000;
/// Up to here handlers are tried at every step of the table, else at one.
constexpr std::size_t manyTrialsUpTo = 3000;

/// The rules of thumb of explicit codes, and the two proven sides beside them.
constexpr const char* rulesOfThumb[] = {"pressure-wave:min-height", "pressure-wave:volume-over-area",
                                        "pressure-wave:in-radius",  "pressure-wave:shortest-edge",
                                        "single-element",           "reduced-1-ring"};

/// Wall time of a step, s: the least mean of a few batches, as other programs disturb the rest. Infinite where a step
/// fails.
double secondsOfStep(Integrator& integrator, const Body& body, const NodeVectors& x, double h) {
  using Clock = std::chrono::steady_clock;
  BodySystem system(body);
  State state;
  state.x = x;
  state.v = NodeVectors::Zero(3, x.cols());
  double best = infinity;
  std::int64_t batch = 1;  // the first one alone warms up
  for (int k = 0; k < 5; ++k) {
    const Clock::time_point begin = Clock::now();
    for (std::int64_t i = 0; i < batch; ++i)
      if (!integrator.step(system, state, h).done) return infinity;
    const double seconds = std::chrono::duration<double>(Clock::now() - begin).count() / static_cast<double>(batch);
    if (k > 0) best = std::min(best, seconds);
    batch = std::clamp<std::int64_t>(static_cast<std::int64_t>(4e-3 / std::max(seconds, 1e-7)), 1, 50);
  }
  return best;
}

/// Every handler that keeps the integrator's accuracy, from the state at a step h. explicitCost: wall time per
/// simulated time of the integrator alone at the safe step.
std::vector<HandlerTrial> tryHandlers(const AnalysedState& state, double h, double explicitCost) {
  std::vector<HandlerTrial> trials;
  for (const HandlerEntry& entry : allHandlers()) {
    const HandlerInfo& info = *entry.info;
    if (info.relaxes) continue;
    HandlerTrial trial;
    trial.handler = std::string(info.name);
    try {
      Body body = copyOf(state.body);
      const double mass = body.totalMass();
      const auto handler = entry.make(body, makeIntegrator(state.integrator.name), optionsFor(info, {}));
      handler->prepare(state.x, h);
      if (info.addsMass) {
        trial.addedMass = body.totalMass() - mass;
        trial.addedShare = *trial.addedMass / mass;
      }
      const double seconds = secondsOfStep(*handler, body, state.x, h);
      if (std::isfinite(seconds))
        trial.gain = explicitCost / (seconds / h);
      else
        trial.whyNot = "its steps fail from this state";
    } catch (const std::runtime_error& fault) {
      trial.whyNot = fault.what();
    }
    trials.push_back(std::move(trial));
  }
  return trials;
}

void addWhatIf(const AnalysedState& state, RunAnalysis& analysis) {
  const double safe = *analysis.safe;
  const bool small = analysis.elements <= manyTrialsUpTo;
  // Largest of the table; the trial of larger meshes is at the step taken, or else at twice the safe one.
  std::vector<double> steps;
  for (const double factor : small ? std::vector{1.0, 1.1, 1.25, 1.5, 2.0, 3.0} : std::vector{1.0, 1.25, 2.0})
    steps.push_back(factor * safe);
  const bool takenIsLarger = state.taken && *state.taken > safe;
  if (state.taken && *state.taken > 0) steps.push_back(*state.taken);
  std::sort(steps.begin(), steps.end());
  steps.erase(std::unique(steps.begin(), steps.end()), steps.end());

  const auto explicitly = makeIntegrator(state.integrator.name);
  const double explicitCost = secondsOfStep(*explicitly, state.body, state.x, safe) / safe;
  for (const double h : steps) {
    WhatIf row;
    row.h = h;
    row.proven = h <= safe;
    if (!row.proven) {
      row.way = elementsInTheWay(state.body, state.x, state.integrator, h);
      if (!row.way.badlyShaped.empty()) row.badNumbers = row.way.badNumbersText(state.body.mesh());
      if (small ? h >= 1.5 * safe || h == state.taken : takenIsLarger ? h == *state.taken : h == 2 * safe)
        row.trials = tryHandlers(state, h, explicitCost);
    }
    analysis.whatIf.push_back(std::move(row));
  }
}

}  // namespace

const WhatIf* RunAnalysis::inTheWay() const {
  for (const WhatIf& row : whatIf)
    if (taken && row.h == *taken && !row.proven) return &row;
  return nullptr;
}

RunAnalysis analyseState(const AnalysedState& state) {
  RunAnalysis analysis;
  analysis.safe = state.safe;
  analysis.optimistic = state.optimistic;
  analysis.taken = state.taken;
  analysis.elements = state.body.mesh().elementCount();
  std::vector<MetricResult> metrics;
  for (const char* name : rulesOfThumb) metrics.push_back(evaluateMetric(name, state.body, state.x));
  analysis.distributions = distributionsOf(metrics, state.rule);
  for (const MetricResult& metric : metrics)
    analysis.rules.push_back({std::string(metric.info->name), std::string(metric.info->help),
                              std::string(stepSide(metric.direction)), state.rule(metric.lambda)});

  if (analysis.elements > whatIfUpTo)
    analysis.whyNoWhatIf =
        "Left out for a mesh of more than 20 000 elements: ringwatch inspect with --step h computes it for a step.";
  else if (!takesHandler(state.integrator))
    analysis.whyNoWhatIf = "Left out: no handler goes with the integrator " + std::string(state.integrator.name) + ".";
  else if (state.body.discreteForces())
    analysis.whyNoWhatIf = "Left out: handlers are chosen for bodies without springs, dashpots and contact.";
  else if (state.damped)
    analysis.whyNoWhatIf = "Left out: handlers are chosen for undamped bodies, and this run is damped.";
  else if (!analysis.safe || !(*analysis.safe > 0))
    analysis.whyNoWhatIf = "Left out: there is no bracket of the whole body at this state to start from.";
  else
    addWhatIf(state, analysis);
  return analysis;
}

RunAnalysis analyseRun(const std::filesystem::path& folder, const std::filesystem::path& frame,
                       std::optional<double> safe, std::optional<double> optimistic, std::optional<double> taken) {
  Scene scene = sceneOfRun(folder);
  MeshState state = loadVtuState(folder / frame, "displacement");
  Body body = sceneBody(scene, std::move(state.mesh), 0);
  const IntegratorInfo* integrator = integratorCatalog().find(scene.method);
  if (!integrator || !(integrator->imaginaryLimit > 0) || std::isinf(integrator->imaginaryLimit)) {
    RunAnalysis analysis;
    analysis.elements = body.mesh().elementCount();
    analysis.whyNoRules = analysis.whyNoWhatIf = "Left out: the integrator " + scene.method + " has no critical step.";
    return analysis;
  }
  if (body.discreteForces())
    for (const PvdEntry& entry : framesOfRun(folder))
      if (entry.file == frame) placeObstacles(scene, entry.time, *body.discreteForces());
  const StepRule rule = sceneStepRule(scene, body);
  // With a handler the run's bracket is that of the elements that it left explicit; in other modes there is half of
  // one.
  if (!scene.handler.empty() || !safe || !optimistic) {
    safe = optimistic = std::nullopt;
    if (body.mesh().elementCount() <= bracketedElements && rule.proven()) {
      const CriticalStep bracket = criticalStep(body, state.x, rule);
      safe = bracket.safe;
      optimistic = bracket.optimistic;
    }
  }
  return analyseState({body, state.x, *integrator, rule, scene.damping.any(), safe, optimistic, taken});
}

}  // namespace ringwatch
