#include <ringwatch/verify/work_precision/error_against_time.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <numbers>
#include <utility>

#include <ringwatch/base/error.h>
#include <ringwatch/handlers/handler.h>
#include <ringwatch/integrators/body_system.h>
#include <ringwatch/integrators/stability_limit.h>
#include <ringwatch/meshes/generators/generators.h>
#include <ringwatch/monitor/bounds/global_frequency.h>
#include <ringwatch/verify/study_bodies.h>
#include <ringwatch/verify/work_precision/work_precision.h>

namespace ringwatch {
namespace {

constexpr double length = 0.2, width = 0.04;  // m
constexpr double frequencyTolerance = 1e-6;
using detail::highestEigenvalue, detail::nan;

struct Motion {
  std::string name, title;
  double end;      // s
  double pull;     // speed of the far end over the length, 1/s; 0: hangs and swings
  double gravity;  // m/s², downwards
  double poisson;  // 0 for the swinging bar: else its clamp has corners of infinite stress, where every mesh errs
  int firstProbe, lastProbe;             // tenths of the length where displacements are compared
  double quickReference, fullReference;  // allowed difference of the two finest references, three times the measured
};
const Motion motions[] = {{.name = "swinging",
                           .title = "Swinging StVK bar",
                           .end = 0.5,
                           .pull = 0,
                           .gravity = 1,
                           .poisson = 0,
                           .firstProbe = 0,
                           .lastProbe = 10,
                           .quickReference = 8e-3,
                           .fullReference = 2e-3},
                          {.name = "stretched",
                           .title = "Stretched StVK bar",
                           .end = 0.4,
                           .pull = 0.5,
                           .gravity = 0,
                           .poisson = 0.3,
                           .firstProbe = 3,
                           .lastProbe = 7,
                           .quickReference = 0.01,
                           .fullReference = 3e-3}};

/// cells: across; five times as many along.
Mesh barMesh(std::string_view element, int cells, bool slivers) {
  BarOptions options;
  options.size = {length, width, width};
  options.cells = {5 * cells, cells, cells};
  options.element = element;
  Mesh mesh = generateBar(options);
  if (!slivers) return mesh;
  // A few inner nodes pulled nine tenths of the way to their neighbours along x: flat elements all around.
  const double cell = width / cells;
  for (Eigen::Index i = 0; i < mesh.X.cols(); ++i) {
    const Eigen::Vector3d at = mesh.X.col(i) / cell;
    const bool middle = std::abs(at.y() - 0.5 * cells) < 1e-6 && std::abs(at.z() - 0.5 * cells) < 1e-6;
    const long along = std::lround(at.x());
    if (middle && along % 6 == 3 && along + 2 < 5 * cells) mesh.X(0, i) += 0.9 * cell;
  }
  return mesh;
}

Body barBody(const Motion& motion, std::string_view element, int cells, bool slivers) {
  Body body(barMesh(element, cells, slivers), makeMaterial("stvk", detail::young, motion.poisson, detail::density),
            {{}, Lumping::rowSum, 1});
  for (const std::int32_t n : body.mesh().nodeSets.at("x-min")) body.constraints().fix(n);
  if (motion.pull != 0)
    for (const std::int32_t n : body.mesh().nodeSets.at("x-max")) {
      body.constraints().fix(n);
      body.constraints().move(n, 0, motion.pull * length);
    }
  if (motion.gravity != 0) body.addBodyForce({0, 0, -motion.gravity});
  return body;
}

/// Stretching already as a whole, and growing thinner but at its ends, so that hardly a wave runs through the bar.
State startOf(const Motion& motion, const Body& body) {
  State state{0, body.mesh().X, NodeVectors::Zero(3, body.nodeCount())};
  state.v.row(0) = motion.pull * state.x.row(0);
  for (Eigen::Index i = 0; i < state.x.cols(); ++i)
    for (const int side : {1, 2})
      state.v(side, i) = -motion.poisson * motion.pull * std::sin(std::numbers::pi * state.x(0, i) / length) *
                         (state.x(side, i) - width / 2);
  body.constraints().imposeVelocity(state.v);
  return state;
}

/// The nodes on the bar's four long edges at tenths of its length, in one order for all meshes.
std::vector<std::int32_t> probesOf(const Motion& motion, const Mesh& mesh) {
  std::vector<std::int32_t> probes;
  for (int i = motion.firstProbe; i <= motion.lastProbe; ++i)
    for (int edge = 0; edge < 4; ++edge) {
      const Eigen::Vector3d at(0.1 * i * length, (edge & 1) * width, (edge >> 1) * width);
      Eigen::Index nearest = 0;
      const double distance = (mesh.X.colwise() - at).colwise().squaredNorm().minCoeff(&nearest);
      if (distance > 1e-16)
        throw InputError(joinText("the mesh has no node at ", at.x(), ", ", at.y(), ", ", at.z(), " m"));
      probes.push_back(nearest);
    }
  return probes;
}
NodeVectors atProbes(const NodeVectors& values, const std::vector<std::int32_t>& probes) {
  NodeVectors result(3, probes.size());
  for (std::size_t p = 0; p < probes.size(); ++p) result.col(p) = values.col(probes[p]);
  return result;
}

/// Positions at the probes that the error is measured from, m: at rest, or uniformly stretched.
NodeVectors uniformAtProbes(const Motion& motion, const Mesh& mesh, const std::vector<std::int32_t>& probes) {
  NodeVectors x = atProbes(mesh.X, probes);
  x.row(0) *= 1 + motion.pull * motion.end;
  return x;
}

/// Elements whose finest mesh is run too, by motions of some seconds each: the most used ones.
constexpr std::array<std::string_view, 2> withFinestMesh{"tet4", "hex8"};

/// A mesh of the study.
struct Choice {
  std::string element;
  int cells;
  bool slivers;
};
std::vector<Choice> choices(StudyEffort effort) {
  std::vector<Choice> all;
  const bool full = effort == StudyEffort::full;
  for (const ElementInfo& element : allElements())
    for (const int cells : {1, 2, 4, 8, 16}) {
      // Nodes between the corners count as cells; the finest mesh of each takes some seconds a motion.
      const int fineness = cells * element.order;
      if (fineness < 2 || fineness > (full ? 16 : 4)) continue;
      if (full && fineness == 16 && std::ranges::find(withFinestMesh, element.name) == withFinestMesh.end()) continue;
      all.push_back({std::string(element.name), cells, false});
    }
  for (const int cells : full ? std::vector<int>{2, 4, 8} : std::vector<int>{2}) all.push_back({"tet4", cells, true});
  return all;
}

/// Steps to try, s: shares of the stable one at rest, the first of which survives both motions, though this law
/// stiffens; implicit and partitioned schemes go beyond.
std::vector<double> stepsOf(const IntegratorInfo& info, double lambda, double end) {
  std::vector<double> steps;
  const double omega = std::sqrt(lambda);
  if (std::isinf(info.imaginaryLimit))
    for (const double z : {80.0, 20.0}) steps.push_back(z / omega);
  else if (info.partitioned)
    for (const double z : {8.0, 4.0}) steps.push_back(z / omega);
  else
    for (const double share : {0.75, 0.9, 0.45}) steps.push_back(share * info.imaginaryLimit / omega);
  for (double& h : steps) h = std::min(h, end);
  return steps;
}

using Progress = std::function<void(const std::string&)>;

/// Displacements at the end of a motion less the uniform part, at the probes, by a step so small that only the mesh's
/// error is left: a reference of cells across the bar.
NodeVectors referenceEnd(const Motion& motion, int cells, const Progress& progress) {
  if (progress) progress(joinText(motion.name, ": reference of ", 5 * cells, " x ", cells, " x ", cells, " hex20"));
  const Body body = barBody(motion, "hex20", cells, false);
  BodySystem system(body);
  State state = startOf(motion, body);
  // Stretching stiffens this law: half the step that is stable at rest.
  const auto steps =
      static_cast<std::int64_t>(std::ceil(motion.end * std::sqrt(highestEigenvalue(body, frequencyTolerance))));
  const std::unique_ptr<Integrator> integrator = makeIntegrator("verlet");
  for (std::int64_t k = 0; k < steps; ++k) integrator->step(system, state, motion.end / static_cast<double>(steps));
  if (!state.x.allFinite()) throw NumericalError(joinText(motion.name, ": the reference was lost"));
  const std::vector<std::int32_t> probes = probesOf(motion, body.mesh());
  return atProbes(state.x, probes) - uniformAtProbes(motion, body.mesh(), probes);
}

struct Reference {
  NodeVectors end;
  double error;  // by which the two finest differ, relative
};

/// All runs of a motion on one mesh that end with an error below one.
std::vector<ErrorCost> runsOn(const Choice& choice, const Motion& motion, const Reference& reference,
                              std::span<const IntegratorEntry> integrators) {
  constexpr std::int32_t mostImplicit = 150;  // nodes: beyond, factors cost more than any explicit run
  // Quadrature points: beyond, only schemes of one force a step and their first step, since the mesh's error rules.
  constexpr std::size_t mostPoints = 40000;
  const Body body = barBody(motion, choice.element, choice.cells, choice.slivers);
  BodySystem system(body);
  const double lambda = highestEigenvalue(body, frequencyTolerance);
  const std::vector<std::int32_t> probes = probesOf(motion, body.mesh());
  const NodeVectors uniform = uniformAtProbes(motion, body.mesh(), probes);
  WorkPrecisionCase c{motion.name,
                      motion.title,
                      system,
                      startOf(motion, body),
                      motion.end,
                      lambda,
                      {},
                      reference.error,
                      [&](const IntegratorInfo& info, double h) { return partitionForStep(body, {}, info, h); },
                      [&](const State& end) {
                        return (atProbes(end.x, probes) - uniform - reference.end).norm() / reference.end.norm();
                      }};
  std::vector<ErrorCost> runs;
  const auto keep = [&](const WorkPrecisionRun& run) {
    if (!run.reason.empty() || !(run.error < 1)) return;  // lost
    runs.push_back({motion.name, choice.element, choice.slivers ? "slivers" : "regular", run.integrator,
                    static_cast<std::int64_t>(body.mesh().elementCount()), run.h, run.error, run.seconds});
  };
  const bool large = body.mesh().elementCount() * body.blocks()[0]->rule().points.size() > mostPoints;
  for (const IntegratorEntry& entry : integrators) {
    const IntegratorInfo& info = *entry.info;
    if (!(info.imaginaryLimit > 0)) continue;
    const bool implicit = std::isinf(info.imaginaryLimit);
    if (info.partitioned && !choice.slivers) continue;
    if ((implicit || info.partitioned) && body.nodeCount() > mostImplicit) continue;
    if (large && info.forceEvaluations != 1) continue;
    WorkPrecisionOptions options;
    options.steps = stepsOf(info, lambda, motion.end);
    if (large) options.steps.resize(1);
    for (const WorkPrecisionRun& run : runWorkPrecision(c, {&entry, 1}, options)) keep(run);
  }
  if (!choice.slivers) return runs;
  // Handlers at the steps that the mesh would allow without its slivers.
  const double free =
      2 / std::sqrt(highestEigenvalue(barBody(motion, choice.element, choice.cells, false), frequencyTolerance));
  for (const HandlerEntry& entry : allHandlers())
    for (const double share : {0.9, 0.6, 0.3}) {
      const std::string name(entry.info->name);
      if (share * free <= 0.9 * 2 / std::sqrt(lambda)) continue;  // nothing to handle
      keep(runPrepared(c, name, share * free, [&](double step) {
        auto own = std::make_shared<Body>(barBody(motion, choice.element, choice.cells, true));
        auto handler = makeHandler(name, *own, makeIntegrator("verlet"));
        handler->prepare(own->mesh().X, step);
        return PreparedRun{std::move(handler), std::make_unique<BodySystem>(*own), own};
      }));
    }
  return runs;
}

/// Runs of one motion by element and kind of mesh.
using Groups = std::map<std::string, std::vector<ErrorCost>>;

StudyFigure errorFigure(const Motion& motion, const Groups& groups) {
  StudyFigure figure{"error_against_time_" + motion.name,
                     motion.title + ": error of mesh and integration against computing time",
                     "computing time, one thread (s)",
                     "relative error of the displacement",
                     true,
                     true,
                     {}};
  for (const auto& [name, own] : groups) {
    StudyFigure::Curve curve{name, {}, {}};
    for (const ErrorCost& run : paretoFront(own)) {
      curve.x.push_back(run.seconds);
      curve.y.push_back(run.error);
    }
    figure.curves.push_back(std::move(curve));
  }
  return figure;
}

/// The row of the cheapest of some runs with at most an error; a row without one is there for all of them together.
void addCheapest(const Motion& motion, const std::string& group, const std::string& label, double error,
                 const std::vector<ErrorCost>& of, StudyTable& table) {
  const ErrorCost* best = nullptr;
  for (const ErrorCost& run : of)
    if (run.error <= error && (!best || run.seconds < best->seconds)) best = &run;
  if (best)
    table.rows.push_back({motion.name, label, group, best->element, best->mesh, best->elements, best->method, best->h,
                          best->error, best->seconds});
  else if (group == "all")
    table.rows.push_back(
        {motion.name, label, group, std::string(), std::string(), std::int64_t{0}, std::string("none"), nan, nan, nan});
}

}  // namespace

std::vector<ErrorCost> paretoFront(std::vector<ErrorCost> runs) {
  std::erase_if(runs, [](const ErrorCost& run) { return !std::isfinite(run.error); });
  std::stable_sort(runs.begin(), runs.end(), [](const ErrorCost& a, const ErrorCost& b) {
    return a.seconds != b.seconds ? a.seconds < b.seconds : a.error < b.error;
  });
  std::vector<ErrorCost> front;
  for (const ErrorCost& run : runs)
    if (front.empty() || run.error < front.back().error) front.push_back(run);
  return front;
}

std::vector<ErrorCost> addErrorAgainstTime(std::span<const IntegratorEntry> integrators, StudyEffort effort,
                                           StudyReport& report,
                                           const std::function<void(const std::string&)>& progress) {
  const std::pair<const char*, double> wanted[] = {{"10 %", 1e-1}, {"1 %", 1e-2}, {"0.1 %", 1e-3}};
  const bool full = effort == StudyEffort::full;
  std::vector<ErrorCost> all;
  StudyTable cheapest{
      "error_against_time_cheapest",
      "Cheapest run for an error, of each element and of all",
      {"motion", "error", "among", "element", "mesh", "elements", "method", "h (s)", "error reached", "time (s)"},
      {}};
  for (const Motion& motion : motions) {
    const int finest = full ? 8 : 4;
    Reference reference{referenceEnd(motion, finest, progress), 0};
    reference.error = (referenceEnd(motion, finest / 2, progress) - reference.end).norm() / reference.end.norm();
    checkBelow(report, motion.name + ": the two finest references differ by", reference.error,
               full ? motion.fullReference : motion.quickReference);
    if (progress) progress(joinText(motion.name, ": the two finest references differ by ", reference.error));
    std::vector<ErrorCost> runs;
    for (const Choice& choice : choices(effort)) {
      if (progress)
        progress(joinText(motion.name, ": ", choice.cells, " cells of ", choice.element,
                          choice.slivers ? " with slivers" : ""));
      const std::vector<ErrorCost> more = runsOn(choice, motion, reference, integrators);
      runs.insert(runs.end(), more.begin(), more.end());
    }
    Groups groups;
    for (const ErrorCost& run : runs)
      groups[run.mesh == "regular" ? run.element : run.element + ", slivers"].push_back(run);
    report.figures.push_back(errorFigure(motion, groups));
    for (const auto& [label, error] : wanted) {
      if (error < reference.error) continue;  // below the error of the reference
      addCheapest(motion, "all", label, error, runs, cheapest);
      for (const auto& [name, own] : groups) addCheapest(motion, name, label, error, own, cheapest);
    }
    all.insert(all.end(), runs.begin(), runs.end());
  }
  report.tables.push_back(std::move(cheapest));
  return all;
}

}  // namespace ringwatch
