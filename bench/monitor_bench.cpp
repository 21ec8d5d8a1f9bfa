// Metrics and bracket of the critical step, ns an element, each with how far its step is from the true one, and dense
// eigenvalues element by element as the baseline; then what a monitor costs along a run, over the step it watches.
#include <malloc.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include <bench/runs.h>
#include <bench/support.h>
#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/base/median.h>
#include <ringwatch/integrators/body_system.h>
#include <ringwatch/integrators/symplectic_euler.h>
#include <ringwatch/monitor/bounds/global_frequency.h>
#include <ringwatch/monitor/bounds/lanczos_bound.h>
#include <ringwatch/monitor/bounds/reduced_ring.h>
#include <ringwatch/monitor/critical_step.h>
#include <ringwatch/monitor/incremental/incremental_nodal_bound.h>
#include <ringwatch/monitor/incremental/moved_bound.h>
#include <ringwatch/monitor/incremental/rest_bound.h>
#include <ringwatch/monitor/incremental/run_certificate.h>
#include <ringwatch/monitor/incremental/work_account.h>
#include <ringwatch/monitor/metrics/metrics.h>
#include <ringwatch/monitor/stability_monitor.h>

namespace ringwatch::bench {
namespace {

/// Highest eigenvalue of M⁻¹K of the case's body at its state, computed once a mesh.
double trueLambda(const Case& c, const Setup& s) {
  static std::map<std::tuple<std::string, int, std::string>, double> known;
  const auto [entry, isNew] = known.try_emplace({c.element, c.elements, c.law}, 0.0);
  if (isNew) {
    const GlobalFrequency global = globalFrequency(s.body, s.x, 1e-8);
    entry->second = global.converged ? global.lambda : std::numeric_limits<double>::quiet_NaN();
  }
  return entry->second;
}
/// Relative error of the step that belongs to lambda: negative is pessimistic.
double stepError(double lambda, double exact) { return std::sqrt(exact / lambda) - 1; }

void metric(benchmark::State& state, const Case& c, std::string_view name) {
  Setup& s = setupOf(c);
  double lambda = 0;
  for (auto _ : state) {
    lambda = evaluateMetric(name, s.body, s.x).lambda;
    benchmark::DoNotOptimize(std::as_const(lambda));
  }
  report(state, s.body.mesh().elementCount(), stepError(lambda, trueLambda(c, s)));
}

/// An explicit step, symplectic Euler: force and update. Its error column is how far the state has moved at all:
/// nothing, so that every step costs the same.
void explicitStep(benchmark::State& state, const Case& c) {
  Setup& s = setupOf(c);
  timeSteps(state, s);
  // Force pass: 88 bytes of geometry and places a tetrahedron, positions and forces of its nodes' share; the update
  // reads x, v, f, 1/m and the external force, and writes x and v.
  const double nodes = static_cast<double>(s.body.nodeCount()) / static_cast<double>(s.body.mesh().elementCount());
  if (c.element == "tet4") reportFloor(state, s.body.mesh().elementCount(), {0, 88 + nodes * (48 + 7 * 24 - 16)});
}

/// All reduced 1-rings from element tangents, as a run needs them: patterns kept from the observation before.
void reducedRings(benchmark::State& state, const Case& c) {
  Setup& s = setupOf(c);
  const double lambda = timeReducedRings(state, s);
  report(state, s.body.mesh().elementCount(), stepError(lambda, trueLambda(c, s)));
}

void bracket(benchmark::State& state, const Case& c) {
  Setup& s = setupOf(c);
  CriticalStep step{};
  for (auto _ : state) {
    step = criticalStep(s.body, s.x, 2.0);
    benchmark::DoNotOptimize(std::as_const(step));
  }
  report(state, s.body.mesh().elementCount(), step.safe / step.optimistic - 1);
}

/// The baseline: an eigenvalue solver on each element's dense, mass-scaled tangent.
void denseEigenvalues(benchmark::State& state, const Case& c) {
  Setup& s = setupOf(c);
  const ElementBlock& block = *s.body.blocks()[0];
  const int n = block.element().nodes;
  double largest = 0;
  for (auto _ : state) {
    largest = 0;
    for (std::int32_t e = 0; e < block.elementCount(); ++e) {
      Eigen::MatrixXd K = s.body.elementTangent({0, e}, s.x);
      std::vector<double> mass(n);
      s.body.elementLumpedMass({0, e}, mass.data());
      for (int i = 0; i < 3 * n; ++i)
        for (int j = 0; j < 3 * n; ++j) K(i, j) /= std::sqrt(mass[i / 3] * mass[j / 3]);
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(K, Eigen::EigenvaluesOnly);
      largest = std::max(largest, solver.eigenvalues()[3 * n - 1]);
    }
    benchmark::DoNotOptimize(std::as_const(largest));
  }
  report(state, s.body.mesh().elementCount(), stepError(largest, trueLambda(c, s)));
}

/// The bound by Lanczos from scratch, 1 % of the step at eta = 1e-9.
void lanczos(benchmark::State& state, const Case& c) {
  Setup& s = setupOf(c);
  LanczosBound bound;
  for (auto _ : state) {
    bound = lanczosUpperBound(s.body, s.x);
    benchmark::DoNotOptimize(std::as_const(bound));
  }
  report(state, s.body.mesh().elementCount(), stepError(bound.upper.value, trueLambda(c, s)));
  state.counters["products"] = bound.products;
}

/// The baseline: the global eigenvalue from scratch.
void spectra(benchmark::State& state, const Case& c) {
  Setup& s = setupOf(c);
  GlobalFrequency global;
  for (auto _ : state) {
    global = globalFrequency(s.body, s.x, 1e-6);
    benchmark::DoNotOptimize(std::as_const(global));
  }
  report(state, s.body.mesh().elementCount(), stepError(global.lambda, trueLambda(c, s)));
  state.counters["products"] = global.products;
}

/// Of a regular grid's cells, by which the nodes of a bar are moved unless it is regular.
constexpr double jittered = 0.22;
/// A bar five times as long as wide, of cubes of 1 cm.
Mesh makeBar(const Case& c, int elementsPerCell, double jitter) {
  BarOptions options;
  options.element = c.element;
  options.split = elementsPerCell;
  options.jitter = jitter;
  const int n = static_cast<int>(std::lround(std::cbrt(c.elements / (5.0 * std::max(1, elementsPerCell)))));
  options.cells = {5 * n, n, n};
  options.size = {0.05 * n, 0.01 * n, 0.01 * n};
  return generateBar(options);
}

/// Bytes that are allocated.
double heapInUse() {
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd);
}

/// A bar pulled at one end by `rate` of its length a second, which turns by `turn` rad/s to begin with, watched at
/// every step in the pass that computes the force; what that takes more than the same run without a monitor, by turns
/// of some steps each, over the latter's time. h: of the critical step at rest.
struct Pull {
  std::string name;
  double rate;
  double h;
  double turn = 0;
  int steps = 1000;
};
struct Watch {
  std::string name;
  MonitorMode mode;
  double budget;
  int every = 1;
};
/// The bar at rest, with its ends held and moved.
Body pulledBar(const Case& c, int split, double jitter, const Pull& pull) {
  Body body(makeBar(c, split, jitter), makeMaterial(c.law, 30e3, 0.3, 1000), {{}, Lumping::rowSum, c.threads});
  const Eigen::Vector3d size = body.mesh().X.rowwise().maxCoeff();
  const double length = size[0];
  for (std::int32_t i = 0; i < body.nodeCount(); ++i) {
    if (body.mesh().X(0, i) < 1e-9) body.constraints().fix(i);
    if (body.mesh().X(0, i) > length - 1e-9) {
      body.constraints().fix(i);
      const Eigen::Vector3d arm = body.mesh().X.col(i) - 0.5 * size;
      const Eigen::Vector3d velocity(pull.rate * length, -pull.turn * arm[2], pull.turn * arm[1]);
      for (int k = 0; k < 3; ++k)
        if (k == 0 || pull.turn != 0) body.constraints().move(i, k, velocity[k]);
    }
  }
  return body;
}

/// besideScratch: the last bracket is compared with the best one from scratch.
void watchedRun(benchmark::State& state, const Case& c, int split, double jitter, const Watch& watch, const Pull& pull,
                bool besideScratch = false) {
  Body body = pulledBar(c, split, jitter, pull);
  BodySystem system(body), plainSystem(body);
  SymplecticEuler integrator, plainIntegrator;
  MonitorOptions options;
  options.mode = watch.mode;
  options.budget = watch.budget;
  options.every = watch.every;
  options.steps = pull.steps;
  options.workInAdvance = 0;
  if (watch.mode == MonitorMode::metric) options.metric = "reduced-1-ring";
  const double h = pull.h * 2 / std::sqrt(globalFrequency(body, body.mesh().X, 1e-6).lambda);
  // Fierz 2013 evaluates only now and then; so does a metric here, for it costs the same at every observation.
  const int steps = watch.mode == MonitorMode::metric ? 20 : pull.steps;
  double stepTime = 0, watchTime = 0, startTime = 0, refreshed = 0, certified = 0;
  std::vector<double> width;
  Work spent;
  std::optional<CriticalStep> lastBracket;
  NodeVectors lastPositions;
  for (auto _ : state) {
    State at = system.initialState(), plain = at;
    StepEvaluation evaluation;
    {
      Body::Workspace workspace;
      body.evaluate(at.x, evaluation, workspace);
    }
    system.complete(at, evaluation);
    plainIntegrator.step(plainSystem, plain, h);
    const double heap = heapInUse();
    StabilityMonitor monitor(body, options);
    stepTime = watchTime = refreshed = certified = 0;
    width.clear();
    spent = {};
    constexpr int turn = 20;  // steps between two looks at the clock, which are system calls; divides all runs
    double before = cpuSeconds();
    for (int step = 0; step <= steps; ++step) {
      const MonitorReport& now = monitor.observe(step, at.time, at.x, at.v, h, &evaluation);
      if (step == 0) startTime = cpuSeconds() - before;  // from scratch, once a run
      if (step == steps) {
        lastBracket = now.bracket;
        lastPositions = at.x;
      }
      system.complete(at, evaluation);
      integrator.advance(system, at, h);
      if (step > 0) {
        refreshed += static_cast<double>(now.elementsRefreshed);
        spent += now.spent;
        certified += now.verdict == Verdict::certified;
        if (now.bracket && now.fresh) width.push_back(now.bracket->safe / now.bracket->optimistic - 1);
      }
      if (step % turn != 0) continue;
      const double begin = cpuSeconds();
      if (step > 0) watchTime += begin - before;
      for (int k = step == 0 ? 1 : turn; k > 0; --k) plainIntegrator.step(plainSystem, plain, h);
      before = cpuSeconds();
      if (step > 0) stepTime += before - begin;
    }
    watchTime -= stepTime;
    state.counters["bytes"] = (heapInUse() - heap) / static_cast<double>(body.mesh().elementCount());
    state.SetIterationTime(stepTime + watchTime + startTime);
    if (!at.x.allFinite()) {
      state.SkipWithError("the run is lost: positions are not finite");
      return;
    }
    if (besideScratch && lastBracket) {
      const CriticalStep best = criticalStep(body, lastPositions, options.limit);
      state.counters["scratch_width"] = best.safe / best.optimistic - 1;
      state.counters["safe_to_scratch"] = lastBracket->safe / best.safe - 1;
      state.counters["optimistic_to_scratch"] = lastBracket->optimistic / best.optimistic - 1;
    }
  }
  const auto elements = static_cast<double>(body.mesh().elementCount());
  state.counters["elements"] = elements;
  state.counters["step_ns"] = 1e9 * stepTime / steps / elements;
  state.counters["monitor_ns"] = 1e9 * watchTime / steps / elements;
  state.counters["over_step"] = watchTime / stepTime;
  state.counters["start_in_steps"] = startTime / (stepTime / steps);
  state.counters["refreshed"] = refreshed / steps / elements;
  state.counters["certified"] = certified / steps;
  // Counted, in steps a step: what of over_step went where.
  for (std::size_t i = 0; i < worksOn; ++i) state.counters[joinText("on_", workNames[i])] = spent.of[i] / steps;
  state.counters["counted"] = spent.total() / steps;
  if (!width.empty()) {
    std::sort(width.begin(), width.end());  // the widest first
    state.counters["median_width"] = width[width.size() / 2];
    state.counters["worst_width"] = width.front();
  }
}

/// How far an upper bound that is kept along a run lies above the highest eigenvalue, in the step, and what it takes
/// over the step's force: that of validity balls with a budget of 0.1, the nodal bound that moves with the body, which
/// may evaluate a five hundredth of the elements exactly each step, or that at rest, which evaluates nothing.
enum class Kept { balls, moved, rest };
constexpr auto keptNames = nameTable<Kept>({{Kept::balls, "balls"}, {Kept::moved, "moved"}, {Kept::rest, "rest"}});
void keptBound(benchmark::State& state, const Case& c, int split, const Pull& pull, Kept by) {
  Body body = pulledBar(c, split, jittered, pull);
  BodySystem system(body);
  SymplecticEuler integrator;
  const double h = pull.h * 2 / std::sqrt(globalFrequency(body, body.mesh().X, 1e-6).lambda);
  constexpr int looks = 10, partOfElements = 500;
  double kept = 0, force = 0, visited = 0, evaluated = 0;
  std::vector<double> above;
  for (auto _ : state) {
    WorkAccount account(body, 0.1);
    IncrementalNodalBound balls(body, {}, &account);
    MovedBound moving(body);
    RestBound resting(body);
    if (by == Kept::rest) {
      NodalBound weights(body);
      weights.evaluate(body.mesh().X, 12);
      resting.start(std::move(weights));
    }
    State at = system.initialState();
    StepEvaluation evaluation, plain;
    Body::Workspace workspace;
    kept = force = visited = evaluated = 0;
    above.clear();
    for (int step = 0; step <= pull.steps; ++step) {
      const double begin = cpuSeconds();
      double bound;
      if (by == Kept::rest) {
        bound = resting.update(at.x, &evaluation, 0, body.mesh().elementCount() / partOfElements).value;
      } else if (by == Kept::moved) {
        moving.update(at.x, &evaluation);
        bound = moving.improve(at.x, 0, body.mesh().elementCount() / partOfElements).value;
      } else {
        account.earn();
        bound = balls.update(at.x, &evaluation).value;
      }
      const double between = cpuSeconds();
      body.evaluate(at.x, plain, workspace);
      const double end = cpuSeconds();
      if (step > 0) {
        kept += between - begin - (end - between);
        force += end - between;
        visited += static_cast<double>(moving.statistics().visited);
        // Of those that are not updated it is zero.
        evaluated += static_cast<double>(moving.statistics().evaluated + balls.statistics().evaluated);
      }
      if (step % (pull.steps / looks) == 0)
        above.push_back(1 - std::sqrt(globalFrequency(body, at.x, 1e-4).lambda / bound));
      system.complete(at, evaluation);
      integrator.advance(system, at, h);
    }
    state.SetIterationTime(kept + force);
  }
  const double elements = static_cast<double>(body.mesh().elementCount()) * pull.steps;
  std::sort(above.begin(), above.end());
  state.counters["below_exact_median"] = above[above.size() / 2];
  state.counters["below_exact_most"] = above.back();
  state.counters["over_force"] = kept / force;
  state.counters["visited"] = visited / elements;
  state.counters["evaluated"] = evaluated / elements;
}

/// Evaluations of so many elements after a force of the whole body, or looks whether their balls can grow, in units of
/// WorkAccount an element: beside each other, or anywhere. What the account counts for it.
void singleElements(benchmark::State& state, const Case& c, int split, int count, bool beside, bool growth) {
  constexpr int samples = 41;
  const Body body(makeBar(c, split, jittered), makeMaterial(c.law, 30e3, 0.3, 1000), {{}, Lumping::rowSum, c.threads});
  NodeVectors x = body.mesh().X;
  x.row(0) *= 1.02;  // so that gradients are not those of the reference
  RunCertificate certificate(body);
  certificate.weights().reset();
  certificate.weights().evaluate(x, 2, NodalBound::Start::rows, 0.01, SweepTarget{});
  certificate.setCertifiedEigenvalue(certificate.weights().last() * 1.2);
  certificate.distributeAllowances(x, true);
  const auto elements = static_cast<std::int32_t>(body.mesh().elementCount());
  Random random(1);
  StepEvaluation force;
  Body::Workspace workspace;
  std::vector<RunCertificate::Reference> results;
  std::vector<double> forces, singles;
  double counted = 0;
  for (auto _ : state)
    for (int sample = 0; sample < samples; ++sample) {
      std::vector<ElementRef> chosen;
      const std::int32_t start = random.index(elements - count);
      for (int k = 0; k < count; ++k) chosen.push_back({0, beside ? start + k : random.index(elements)});
      const double before = cpuSeconds();
      body.evaluate(x, force, workspace);
      const double between = cpuSeconds();
      if (growth)
        certificate.growBalls(x, chosen);
      else
        certificate.evaluate(x, chosen, false, results);
      singles.push_back(cpuSeconds() - between);
      forces.push_back(between - before);
      counted = growth ? WorkAccount::ofGrowth(body, chosen) : WorkAccount::ofEvaluation(body, chosen);
    }
  state.counters["units"] = median(std::move(singles)) / median(std::move(forces)) * WorkAccount::ofForce(body) / count;
  state.counters["counted"] = counted / count;
}

/// Registers a run, which is made once and times itself.
void addRun(const std::string& name, std::function<void(benchmark::State&)> run) {
  benchmark::RegisterBenchmark(name.c_str(), std::move(run))
      ->UseManualTime()
      ->Iterations(1)
      ->Unit(benchmark::kMillisecond);
}
const Pull slowPull{"slow", 0.1, 0.5}, fastPull{"fast", 0.8, 0.5}, twist{"twist", 0, 0.5, 1.5},
    compression{"compression", -0.3, 0.5};

/// A pull of 80 % a second, eight times slower, and by a step that leaves less room, for every budget.
void addWatchedRuns(const Case& c) {
  constexpr double unlimited = infinity;
  for (const Pull& pull : {fastPull, slowPull, Pull{"slow_close", 0.1, 0.9}, twist, compression})
    for (const Watch& watch :
         {Watch{"bracket_no_limit", MonitorMode::bracket, unlimited}, Watch{"bracket_1", MonitorMode::bracket, 1},
          Watch{"bracket_0.3", MonitorMode::bracket, 0.3}, Watch{"bracket_0.1", MonitorMode::bracket, 0.1},
          Watch{"threshold", MonitorMode::threshold, unlimited}, Watch{"metric", MonitorMode::metric, unlimited}})
      for (const CellSubdivision& split : allCellSubdivisions()) {
        if (split.element != c.element || split.centre) continue;
        if (watch.mode == MonitorMode::metric && pull.name != "fast") continue;
        addRun(joinText("watched/", watch.name, "/", pull.name, "/", split.elementsPerCell, "_a_cell/", c.name()),
               [c, watch, pull, cut = split.elementsPerCell](benchmark::State& state) {
                 watchedRun(state, c, cut, jittered, watch, pull);
               });
      }
}

/// As much as pyramids of 100 000 elements bear.
constexpr double tableJitter = 0.2;

/// The runs of bench/monitor_table.py.
void addRunsOfTables() {
  const auto add = [](const Case& c, int cut, double jitter, const Watch& watch, const Pull& pull) {
    addRun(joinText("table/", watch.name, "/", pull.name, "/", cut, "_a_cell/", jitter > 0 ? "jittered" : "regular",
                    "/", c.name()),
           [=](benchmark::State& state) { watchedRun(state, c, cut, jitter, watch, pull, true); });
  };
  const Watch usual{"bracket_0.1", MonitorMode::bracket, 0.1};
  for (const auto& [element, cut] : {std::pair{"tet4", 5}, {"tet4", 6}, {"hex8", 1}, {"wedge6", 2}, {"pyramid5", 6}}) {
    const Case large{element, 100000, "stvk", 1};
    for (const Pull& pull : {slowPull, Pull{"slower", 0.01, 0.5, 0, 10000}, fastPull, twist, compression})
      add(large, cut, tableJitter, usual, pull);
    add(large, cut, tableJitter, {"bracket_0", MonitorMode::bracket, 0}, slowPull);
    add(large, cut, tableJitter, {"bracket_0.3", MonitorMode::bracket, 0.3}, fastPull);
    add(large, cut, tableJitter, {"threshold", MonitorMode::threshold, 0.1}, {"slow_close", 0.1, 0.8});
    for (const char* law : {"stvk", "neo-hookean", "corotational"})
      for (const double jitter : {0.0, tableJitter}) add({element, 20000, law, 1}, cut, jitter, usual, slowPull);
  }
}

/// Runs of which each n-th step is watched.
void addSeldomWatched() {
  for (const int every : {1, 2, 5, 10, 30})
    for (const auto& [elements, watch] :
         {std::pair{20000, Watch{"bracket_no_limit", MonitorMode::bracket, infinity, every}},
          {100000, Watch{"bracket_0.1", MonitorMode::bracket, 0.1, every}}})
      for (const Pull& pull : {slowPull, fastPull})
        for (const int cut : {5, 6}) {
          const Case c{"tet4", elements, "stvk", 1};
          addRun(
              joinText("every/", every, "/", watch.name, "/", pull.name, "/", cut, "_a_cell/", c.name()),
              [=, watched = watch](benchmark::State& state) { watchedRun(state, c, cut, tableJitter, watched, pull); });
        }
}

void addSingleElements() {
  for (const auto& [element, split] : {std::pair{"tet4", 5}, {"hex8", 1}, {"wedge6", 2}})
    for (const bool growth : {false, true})
      for (const bool beside : {true, false})
        for (const auto& [elements, count] :
             {std::pair{5000, 1}, {5000, 64}, {100000, 1}, {100000, 8}, {100000, 64}, {100000, 512}}) {
          const Case c{element, elements, "stvk", 1};
          benchmark::RegisterBenchmark(joinText("singles/", growth ? "growth" : "evaluation",
                                                beside ? "/beside" : "/far", "/", count, "/", c.name())
                                           .c_str(),
                                       [=, cut = split, chosen = count](benchmark::State& state) {
                                         singleElements(state, c, cut, chosen, beside, growth);
                                       })
              ->Iterations(1);
        }
}

void addKeptBounds() {
  for (const auto& [element, cut] : {std::pair{"tet4", 5}, {"tet4", 6}, {"hex8", 1}, {"wedge6", 2}, {"pyramid5", 6}})
    for (const char* law : {"stvk", "neo-hookean"})
      for (Pull pull : {slowPull, fastPull, twist})
        for (const auto& kept : keptNames) {
          const Case c{element, 20000, law, 1};
          pull.steps = 400;
          addRun(joinText("kept/", kept.name, "/", pull.name, "/", cut, "_a_cell/", c.name()),
                 [=, of = cut, by = kept.value](benchmark::State& state) { keptBound(state, c, of, pull, by); });
        }
}

void registerAll() {
  addRunsOfTables();
  addKeptBounds();
  addSingleElements();
  addSeldomWatched();
  for (const ElementInfo& element : allElements())
    for (const int elements : {5000, 20000, 100000})
      for (const int threads : {1, 2}) {
        const Case c{std::string(element.name), elements, "stvk", threads};
        const auto add = [&](std::string_view what, const auto& run) {
          benchmark::RegisterBenchmark((std::string(what) + "/" + c.name()).c_str(), run)
              ->UseRealTime()
              ->Unit(benchmark::kMicrosecond);
        };
        if (elements == 20000) {  // watched runs alone have this size
          if (threads == 1) addWatchedRuns(c);
          continue;
        }
        for (const MetricInfo& info : allMetrics())
          // The larger rings cost a hundred times as much an element, whatever the size of the mesh.
          if (elements <= 5000 || info.name.find("-ring") == std::string_view::npos || info.name == "reduced-1-ring")
            add(info.name, [c, name = info.name](benchmark::State& state) { metric(state, c, name); });
        add("step", [c](benchmark::State& state) { explicitStep(state, c); });
        add("reduced_rings_again", [c](benchmark::State& state) { reducedRings(state, c); });
        add("bracket", [c](benchmark::State& state) { bracket(state, c); });
        add("lanczos", [c](benchmark::State& state) { lanczos(state, c); });
        add("spectra", [c](benchmark::State& state) { spectra(state, c); });
        if (threads != 1) continue;
        add("dense_eigenvalues", [c](benchmark::State& state) { denseEigenvalues(state, c); });
        addWatchedRuns(c);
      }
}

}  // namespace
}  // namespace ringwatch::bench

int main(int argc, char** argv) { return ringwatch::bench::runBenchmarks(argc, argv, ringwatch::bench::registerAll); }
