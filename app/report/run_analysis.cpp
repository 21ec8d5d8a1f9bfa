#include <ringwatch/app/report/run_analysis.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>

#include <fmt/format.h>

#include <ringwatch/app/output/frames.h>
#include <ringwatch/app/scene/capabilities.h>
#include <ringwatch/app/scene/integrator_catalog.h>
#include <ringwatch/app/scene/scene.h>
#include <ringwatch/app/scene/scene_discrete.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/base/parallel.h>
#include <ringwatch/base/sort_unique.h>
#include <ringwatch/handlers/handler.h>
#include <ringwatch/handlers/selection/selection.h>
#include <ringwatch/integrators/body_system.h>
#include <ringwatch/integrators/integrator.h>
#include <ringwatch/meshes/adjacency.h>
#include <ringwatch/meshes/mesh_io.h>
#include <ringwatch/monitor/critical_step.h>
#include <ringwatch/monitor/metrics/metrics.h>
#include <ringwatch/monitor/metrics/wave_metrics.h>

namespace ringwatch {
namespace {

/// Certified selections take 20 µs an element and step.
constexpr std::size_t whatIfUpTo = 20000;
/// Up to here handlers are tried at every step of the table, else at one.
constexpr std::size_t manyTrialsUpTo = 3000;

/// The rules of thumb of explicit codes, length over wave speed, and the two proven sides beside them.
struct WaveRule {
  const char* metric;
  CharacteristicLength length;
};
constexpr WaveRule waveRules[] = {{"pressure-wave:min-height", CharacteristicLength::minHeight},
                                  {"pressure-wave:volume-over-area", CharacteristicLength::volumeOverArea},
                                  {"pressure-wave:in-radius", CharacteristicLength::inRadius},
                                  {"pressure-wave:shortest-edge", CharacteristicLength::shortestEdge},
                                  {"pressure-wave:cell-diameter", CharacteristicLength::cellDiameter}};
constexpr const char* metricOfRings = "reduced-1-ring";
constexpr const char* provenSides[] = {"single-element", metricOfRings};

/// Wall time of a step, s: the least mean of a few batches, as other programs disturb the rest. Infinite where a step
/// fails.
double secondsOfStep(Integrator& integrator, const Body& body, const RayleighDamping& damping, const NodeVectors& x,
                     double h) {
  using Clock = std::chrono::steady_clock;
  BodySystem system(body, damping);
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
/// simulated time of the integrator alone at the safe step, with the monitor.
std::vector<HandlerTrial> tryHandlers(const AnalysedState& state, double h, double explicitCost) {
  std::vector<HandlerTrial> trials;
  for (const HandlerEntry& entry : allHandlers()) {
    const HandlerInfo& info = *entry.info;
    if (info.relaxes) continue;
    HandlerTrial trial;
    trial.handler = std::string(info.name);
    trial.whyNot = dampingRefusedBy(info, state.damping).second;
    if (!trial.whyNot.empty()) {
      trials.push_back(std::move(trial));
      continue;
    }
    try {
      Body body = copyOf(state.body);
      const double mass = body.totalMass();
      const auto handler =
          entry.make(body, makeIntegrator(state.integrator.name), optionsFor(info, {.damping = state.damping}));
      handler->prepare(state.x, h);
      if (info.addsMass) {
        trial.addedMass = body.totalMass() - mass;
        trial.addedShare = *trial.addedMass / mass;
      }
      const double seconds = secondsOfStep(*handler, body, state.damping, state.x, h);
      if (std::isfinite(seconds))
        trial.gain = explicitCost / ((seconds + state.monitorSeconds) / h);
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
  const double explicitCost =
      (secondsOfStep(*explicitly, state.body, state.damping, state.x, safe) + state.monitorSeconds) / safe;
  for (const double h : steps) {
    WhatIf row;
    row.h = h;
    row.proven = h <= safe;
    if (!row.proven) {
      row.way = elementsInTheWay(state.body, state.x, state.integrator, state.damping, h);
      if (!row.way.badlyShaped.empty()) row.badNumbers = numbersText(row.way.badlyShaped, state.body.mesh());
      if (small ? h >= 1.5 * safe || h == state.taken : takenIsLarger ? h == *state.taken : h == 2 * safe)
        row.trials = tryHandlers(state, h, explicitCost);
    }
    analysis.whatIf.push_back(std::move(row));
  }
}

/// Of a few steps the elements whose own step is smaller. steps: s, of the field `name`, of all elements of the mesh,
/// whose shapes are as it is.
void countInTheWay(RunAnalysis& analysis, const Mesh& mesh, std::string name, const std::vector<double>& steps) {
  analysis.countedBy = std::move(name);
  const double least = std::ranges::min(steps, {}, [](double step) { return step > 0 ? step : infinity; });
  // Springs and contact may leave less than the elements; multiples of that say nothing of these.
  const double base = analysis.safe && *analysis.safe > 0.5 * least ? *analysis.safe : least;
  if (!(base > 0) || !std::isfinite(base)) {
    analysis.whyNoWhatIf = "Left out: no element has a step in this state.";
    return;
  }
  std::vector<double> table;
  for (const double factor : {1.0, 1.1, 1.25, 1.5, 2.0, 3.0}) table.push_back(factor * base);
  if (analysis.taken && *analysis.taken > 0) table.push_back(*analysis.taken);
  sortUnique(table);
  // Of more than these the shapes are not told: they take a microsecond each.
  constexpr std::size_t shapesUpTo = 50000;
  const std::vector<std::size_t> first = blockOffsets(mesh);
  for (const double h : table) {
    WhatIf row;
    row.h = h;
    row.proven = analysis.safe && h <= *analysis.safe;
    for (std::size_t b = 0; !row.proven && b < mesh.blocks.size(); ++b)
      for (std::size_t e = 0; e < mesh.blocks[b].elementCount(); ++e)
        if (!(steps[first[b] + e] >= h))
          row.way.all.push_back({static_cast<std::int32_t>(b), static_cast<std::int32_t>(e)});
    row.shapesKnown = row.way.all.size() <= shapesUpTo;
    if (row.shapesKnown) row.way.addShapes(mesh);
    if (!row.way.badlyShaped.empty()) row.badNumbers = numbersText(row.way.badlyShaped, mesh);
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
  analysis.monitorSeconds = state.monitorSeconds;
  std::vector<MetricResult> metrics;
  for (const WaveRule& wave : waveRules) metrics.push_back(evaluateMetric(wave.metric, state.body, state.x));
  for (const char* name : provenSides) metrics.push_back(evaluateMetric(name, state.body, state.x));
  analysis.distributions = distributionsOf(metrics, state.rule);
  for (const MetricResult& metric : metrics)
    analysis.rules.push_back({std::string(metric.info->name), std::string(metric.info->help),
                              std::string(stepSide(metric.direction)),
                              stepBy(metric.direction, metric.lambda, state.rule)});

  analysis.whyNoHandlers = whyNoHandlers(state.body, state.integrator);
  if (analysis.whyNoHandlers.empty()) analysis.whyNoHandlers = state.whyNoHandlers;
  analysis.couldTakeHandler = analysis.whyNoHandlers.empty();
  const bool bracketed = analysis.safe && *analysis.safe > 0;
  if (analysis.couldTakeHandler && !bracketed) {
    analysis.whyNoHandlers = "there is no bracket of the whole body at this state to start from";
  } else if (analysis.couldTakeHandler && analysis.elements > whatIfUpTo) {
    analysis.whyNoHandlers = "it takes too long for a mesh of more than 20 000 elements";
  }
  if (analysis.whyNoHandlers.empty()) {
    addWhatIf(state, analysis);
  } else {
    const FrameField field = stepField(metrics.back(), state.rule);
    countInTheWay(analysis, state.body.mesh(), field.name, field.values);
  }
  return analysis;
}

RunAnalysis analyseFrame(const AnalysedFrame& state) {
  const Mesh& mesh = state.frame.mesh;
  RunAnalysis analysis;
  analysis.safe = state.safe;
  analysis.optimistic = state.optimistic;
  analysis.taken = state.taken;
  analysis.elements = mesh.elementCount();
  analysis.shapesAt = "in that state";
  analysis.whyNoHandlers = "it takes too long for a mesh of more than 20 000 elements";
  std::vector<ElementSteps> steps;
  const std::vector<std::size_t> first = blockOffsets(mesh);
  const auto addRule = [&](const MetricInfo& info, Direction side, std::vector<double> values) {
    const double least = std::ranges::min(values, {}, [](double step) { return step > 0 ? step : infinity; });
    analysis.rules.push_back({std::string(info.name), std::string(info.help), std::string(stepSide(side)), least});
    steps.push_back({std::string(info.name), std::move(values)});
  };
  for (const WaveRule& wave : waveRules) {
    std::vector<double> values(analysis.elements);
    for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
      const MeshBlock& block = mesh.blocks[b];
      const ElementInfo& info = elementInfo(block.type);
      const auto count = static_cast<std::size_t>(info.nodes);
      parallelFor(0, static_cast<std::int64_t>(block.elementCount()), 0, [&](std::int64_t e) {
        const std::size_t i = first[b] + static_cast<std::size_t>(e);
        const double length = characteristicLength(info, mesh.X, {block.element(e), count}, wave.length);
        const double speed = state.waveSpeeds[state.materialOfElement.empty() ? 0 : state.materialOfElement[i]];
        values[i] = state.rule(std::pow(2 * speed / length, 2));
      });
    }
    addRule(*findMetric(wave.metric), Direction::estimate, std::move(values));
  }
  // The frame's own steps: a metric's, each with the side on which it errs in its name.
  std::string ring;
  const std::vector<double>* ringSteps = nullptr;
  for (const FrameField& field : state.frame.cells)
    for (const MetricInfo& info : allMetrics())
      for (const Direction side : {Direction::upperBound, Direction::lowerBound, Direction::estimate})
        if (field.name == stepFieldName(info, side)) {
          addRule(info, side, field.values);
          if (!ringSteps || info.name == metricOfRings) ring = field.name, ringSteps = &field.values;
        }
  analysis.distributions = distributionsOf(std::move(steps));
  if (ringSteps)
    countInTheWay(analysis, mesh, ring, *ringSteps);
  else
    analysis.whyNoWhatIf = "Left out: the frame has no step of elements; output.fields = [\"critical_step\"] adds it.";
  return analysis;
}

namespace {

/// Whether an integrator has a step that stability limits.
bool hasLimit(const IntegratorInfo* info) {
  return info && info->imaginaryLimit > 0 && !std::isinf(info->imaginaryLimit);
}
RunAnalysis withoutLimit(const Scene& scene, std::size_t elements) {
  RunAnalysis analysis;
  analysis.elements = elements;
  analysis.whyNoRules = analysis.whyNoWhatIf = "Left out: the integrator " + scene.method + " has no critical step.";
  return analysis;
}

}  // namespace

RunAnalysis analyseRun(const std::filesystem::path& folder, const std::filesystem::path& frame,
                       std::optional<double> safe, std::optional<double> optimistic, std::optional<double> taken,
                       double monitorSeconds) {
  const Scene scene = sceneOfRun(folder);
  const std::vector<PvdEntry> frames = framesOfRun(folder);
  const auto entry = std::ranges::find(frames, frame, &PvdEntry::file);
  if (entry == frames.end()) throw InputError(fmt::format("{}: run.pvd does not list it", (folder / frame).string()));
  BodyState state = bodyOfFrame(scene, folder, *entry, 0);
  Body& body = state.body;
  const IntegratorInfo* integrator = integratorCatalog().find(scene.method);
  if (!hasLimit(integrator)) return withoutLimit(scene, body.mesh().elementCount());
  // What elements say of the step is tight at the step that the state has, as in inspect.
  const StepRule rule =
      body.mesh().elementCount() <= bracketedElements
          ? ruleAtOwnStep(scene, body, DampingRates::atRest, ownStepTolerance, stepOfTopMode(body, state.x)).rule
          : sceneStepRule(scene, body);
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
  return analyseState(
      {body, state.x, *integrator, rule, scene.damping, safe, optimistic, taken, whyNoHandlers(scene), monitorSeconds});
}

RunAnalysis analyseLargeRun(const std::filesystem::path& folder, const VtuFrame& frame) {
  const Scene scene = sceneOfRun(folder);
  const IntegratorInfo* integrator = integratorCatalog().find(scene.method);
  if (!hasLimit(integrator)) return withoutLimit(scene, frame.mesh.elementCount());
  const auto value = [&](const std::string& name) -> std::optional<double> {
    const auto found = frame.values.find(name);
    return found == frame.values.end() || !std::isfinite(found->second) ? std::nullopt : std::optional(found->second);
  };
  AnalysedFrame state{frame, {}, {}, stepRule(*integrator, scene.damping), {}, {}, value(labelled("step (s)"))};
  // With a handler the run's bracket is that of the elements that it left explicit.
  if (scene.handler.empty()) {
    state.safe = value(labelled("safe step (s)"));
    state.optimistic = value(labelled("optimistic step (s)"));
  }
  for (const SceneMaterial& material : scene.materials)
    state.waveSpeeds.push_back(makeMaterial(material.model, material.parameters, material.density).waveSpeed());
  for (const FrameField& field : frame.cells)
    if (field.name == "material") state.materialOfElement.assign(field.values.begin(), field.values.end());
  RunAnalysis analysis = analyseFrame(state);
  analysis.couldTakeHandler = whyNoHandlers(scene).empty();
  return analysis;
}

}  // namespace ringwatch
