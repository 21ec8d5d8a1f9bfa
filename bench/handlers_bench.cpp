// A step of a handler against the explicit steps that it replaces, on Fierz 2013's cube and bar (docs/handlers.md): ms
// a step of 0.4 ms, its share of four steps of Verlet at 0.1 ms, median of turns of both, and the mean error in mm
// against 0.05 ms. Preparing, in plain steps.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include <bench/support.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/base/median.h>
#include <ringwatch/base/parallel.h>
#include <ringwatch/base/random.h>
#include <ringwatch/extensions/extensions.h>
#include <ringwatch/extensions/fierz2013/fierz2013.h>
#include <ringwatch/handlers/handler.h>
#include <ringwatch/handlers/imex/implicit_cluster.h>
#include <ringwatch/integrators/body_system.h>
#include <ringwatch/meshes/generators/generators.h>
#include <ringwatch/meshes/modify/cut.h>
#include <ringwatch/monitor/bounds/global_frequency.h>

namespace ringwatch::bench {
namespace {

constexpr double target = 4e-4;  // s
constexpr int turns = 5;         // of a handler and of Verlet

double threadSeconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Ran {
  NodeVectors x;
  double seconds;  // a target step
};
Ran run(const Deformation& d, Body& body, Integrator& integrator, int substeps) {
  const auto frames = static_cast<int>(std::lround(d.end() / target));
  BodySystem system(body);
  State state = system.initialState();
  double seconds = 0;
  for (int k = 0; k < frames; ++k) {
    d.prescribeMotion(body, k * target, target);
    body.constraints().imposeVelocity(state.v);
    const double start = threadSeconds();
    for (int i = 0; i < substeps; ++i) integrator.step(system, state, target / substeps);
    seconds += threadSeconds() - start;
  }
  return {state.x, seconds / frames};
}
Ran runVerlet(const Deformation& d, int substeps) {
  Body body = d.body();
  return run(d, body, *makeIntegrator("verlet"), substeps);
}

/// A slit into a bent bar of 5 n³ cells: the certified choice after it, from scratch or with the proof that is kept.
/// Slivers at the slit are handled, and all others hold at half of the critical step.
void choiceAfterCut(benchmark::State& state, int n, bool kept) {
  constexpr double length = 0.5, angle = 0.6;
  BarOptions options;
  options.size = {length, 0.1, 0.1};
  options.cells = {5 * n, n, n};
  options.jitter = 0.05;
  const Mesh mesh = generateBar(options);
  const Material material = makeMaterial("corotational", 30e3, 0.3, 1000);
  const CutMesh cut =
      cutMesh(mesh, CutSurface::swept({{0.25, -0.01, 0.07}, {0.25, 0.11, 0.07}}, {0, 0, 0.06}), mesh.X, 0.01);
  const Body before(mesh, material, {{}, Lumping::rowSum, 1}), after(cut.mesh, material, {{}, Lumping::rowSum, 1});
  NodeVectors x = mesh.X;
  for (Eigen::Index i = 0; i < x.cols(); ++i) {
    const double arm = length / angle - mesh.X(2, i), turn = angle * mesh.X(0, i) / length;
    x(0, i) = arm * std::sin(turn);
    x(2, i) = length / angle - arm * std::cos(turn);
  }
  const NodeVectors xAfter = carriedOver(cut, x);
  const double lambda = 4 * globalFrequency(before, mesh.X).lambda;
  IncrementalSelection atRest;
  atRest.choose(before, mesh.X, lambda, noElements(mesh));
  const double elements = static_cast<double>(cut.mesh.elementCount());
  for (auto _ : state) {
    IncrementalSelection selection;
    if (kept) selection = atRest;
    const double start = threadSeconds();
    if (kept) selection.carryOver(cut);
    const CertifiedSelection& made = selection.choose(after, xAfter, lambda, noElements(cut.mesh));
    state.SetIterationTime(threadSeconds() - start);
    state.counters["elements"] = elements;
    state.counters["evaluated"] = static_cast<double>(selection.evaluatedElements());
    state.counters["evaluations"] = static_cast<double>(made.evaluations);
    state.counters["chosen"] = static_cast<double>(chosenElements(made.chosen).size());
    state.counters["rest_of_lambda"] = made.explicitPart.value / lambda;
  }
}

void handled(benchmark::State& state, const Deformation& d, std::string_view name, const HandlerOptions& options) {
  const int substeps = name == "modal-filter" ? 2 : 1;  // as in Fierz 2013
  const NodeVectors exact = runVerlet(d, 8).x;
  std::vector<double> seconds, ratios, preparing;
  double error = 0, elements = 0;
  for (auto _ : state) {
    const double reference = runVerlet(d, 4).seconds;
    Body body = d.body();
    const auto handler = makeHandler(name, body, makeIntegrator("verlet"), options);
    const double start = threadSeconds();
    handler->prepare(body.mesh().X, target / substeps);
    preparing.push_back(4 * (threadSeconds() - start) / reference);
    const Ran own = run(d, body, *handler, substeps);
    state.SetIterationTime(own.seconds);
    seconds.push_back(own.seconds);
    ratios.push_back(own.seconds / reference);
    error = (own.x - exact).colwise().norm().mean();
    elements = static_cast<double>(handler->elements().size());
  }
  state.counters["ms_a_step"] = 1e3 * median(seconds);
  state.counters["of_four_explicit"] = median(ratios);
  state.counters["preparing_steps"] = median(preparing);
  state.counters["error_mm"] = 1e3 * error;
  state.counters["handled"] = elements;
}

/// Steps of a handler on all threads that there are against one, in turns, by elapsed time: a bar of 117 000 jittered
/// tetrahedra that turns, at so many times its critical step.
void threads(benchmark::State& state, std::string_view name, const HandlerOptions& options, double factor) {
  BarOptions bar;
  bar.size = {0.6, 0.18, 0.18};
  bar.cells = {60, 18, 18};
  bar.split = 6;
  bar.jitter = 0.2;
  const Mesh mesh = generateBar(bar);
  constexpr int steps = 20;
  const auto seconds = [&](int threads, double& handled) {
    Body body(mesh, makeMaterial("corotational", 30e3, 0.3, 1000), {{}, Lumping::rowSum, threads});
    const double h = factor * 2 / std::sqrt(globalFrequency(body, mesh.X, 1e-3).lambda);
    const auto handler = makeHandler(name, body, makeIntegrator("verlet"), options);
    handler->prepare(mesh.X, h);
    handled = static_cast<double>(handler->elements().size());
    BodySystem system(body);
    State now = system.initialState();
    for (Eigen::Index i = 0; i < now.v.cols(); ++i)
      now.v.col(i) = Eigen::Vector3d(0, 5, 10).cross(Eigen::Vector3d(mesh.X.col(i)));
    for (int k = 0; k < 3; ++k) handler->step(system, now, h);
    const auto start = std::chrono::steady_clock::now();
    for (int k = 0; k < steps; ++k) handler->step(system, now, h);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / steps;
  };
  std::vector<double> ratios, all;
  double handled = 0;
  const int most = threadCount(0);
  for (auto _ : state) {
    const double one = seconds(1, handled), many = seconds(most, handled);
    state.SetIterationTime(many);
    all.push_back(many);
    ratios.push_back(one / many);
  }
  state.counters["threads"] = most;
  state.counters["ms_a_step"] = 1e3 * median(all);
  state.counters["times_as_fast_as_one"] = median(ratios);
  state.counters["handled"] = handled;
}

/// One solve with a cluster of jittered tetrahedra, its matrix kept, and what a turn of all of them costs on top.
void cluster(benchmark::State& state, ClusterSolver solver, int cells, double condition) {
  BarOptions bar;
  bar.size = {0.01 * cells, 0.01 * cells, 0.01 * cells};
  bar.cells = {cells, cells, cells};
  bar.jitter = 0.2;
  Body body(generateBar(bar), makeMaterial("corotational", 30e3, 0.3, 1000), {{}, Lumping::rowSum, 1});
  body.constraints().fix(0);  // so that its frame does not turn
  const NodeVectors& X = body.mesh().X;
  std::vector<ElementRef> all;
  for (std::int32_t e = 0; e < body.blocks()[0]->elementCount(); ++e) all.push_back({0, e});
  ClusterOptions options;
  options.solver = solver;
  ImplicitCluster cluster(body, all, condition / globalFrequency(body, X, 1e-6).lambda, X, options);
  Random random(1);
  NodeVectors first(3, X.cols()), second(3, X.cols()), a;
  for (Eigen::Index i = 0; i < first.size(); ++i) {
    first.data()[i] = random.uniform(-1, 1);
    second.data()[i] = random.uniform(-1, 1);
  }
  first.col(0).setZero();
  second.col(0).setZero();
  const NodeVectors v = NodeVectors::Zero(3, X.cols());
  double step = 0;
  for (auto _ : state) {
    a = std::cos(0.1 * step) * first + std::sin(0.07 * step) * second;
    const double start = threadSeconds();
    cluster.follow(X);
    cluster.solve(a, v, 0);
    state.SetIterationTime(threadSeconds() - start);
    ++step;
  }
  state.counters["iterations"] = static_cast<double>(cluster.iterations()) / step;
  double best = infinity;
  for (int i = 1; i <= 10; ++i) {
    const NodeVectors x = Eigen::AngleAxisd(0.5 * i, Eigen::Vector3d::UnitX()).toRotationMatrix() * X;
    const double start = threadSeconds();
    if (!cluster.follow(x)) throw NumericalError("the turned matrix is not finite");
    if (i > 5) best = std::min(best, threadSeconds() - start);  // before, what stood still is not examined every time
  }
  state.counters["rotated_us"] = 1e6 * best;
  state.counters["nodes"] = static_cast<double>(X.cols());
}

void registerAll() {
  for (const double condition : {10.0, 400.0})
    for (const int cells : {1, 2, 3, 4, 5, 7, 9})
      for (const ClusterSolver solver : {ClusterSolver::cholesky, ClusterSolver::conjugateGradients}) {
        const std::string name = joinText("cluster/", solver == ClusterSolver::cholesky ? "cholesky/" : "cg/",
                                          "condition:", condition, "/cells:", cells);
        benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
          cluster(state, solver, cells, condition);
        })->UseManualTime();
      }
  for (const int n : {6, 12})
    for (const bool kept : {false, true})
      benchmark::RegisterBenchmark(joinText("choice_after_cut/", kept ? "kept" : "scratch", "/cells:", n).c_str(),
                                   [=](benchmark::State& state) { choiceAfterCut(state, n, kept); })
          ->UseManualTime()
          ->Unit(benchmark::kMillisecond);
  for (const double factor : {1.2, 2.0})
    for (const HandlerEntry& entry : allHandlers()) {
      const std::string_view handler = entry.info->name;
      benchmark::RegisterBenchmark(joinText("threads/", handler, "/factor:", factor).c_str(),
                                   [=](benchmark::State& state) { threads(state, handler, {}, factor); })
          ->UseManualTime()
          ->Unit(benchmark::kMillisecond)
          ->Iterations(3);
    }
  for (const Deformation& d : allDeformations(0.3)) {
    const auto add = [&](std::string_view name, const HandlerOptions& options, std::string_view with) {
      benchmark::RegisterBenchmark(
          joinText("step/", name, with, "/", d.mesh, "/", d.mode, d.byForce ? "/force" : "/position").c_str(),
          [=](benchmark::State& state) { handled(state, d, name, options); })
          ->UseManualTime()
          ->Iterations(turns);
    };
    for (const HandlerEntry& entry : allHandlers()) add(entry.info->name, {}, "");
    add("imex", {.own = {{"solver", "linear"}}}, "-linear");
    add("fe-pbd", {.own = {{"energy_limit", 0.0}}}, "-relaxed");
    if (d.mesh == "cube") add("imex", {.own = {{"solver", "linear"}, {"tolerance", 1e-8}}}, "-linear-to-1e-8");
  }
}

}  // namespace
}  // namespace ringwatch::bench

int main(int argc, char** argv) {
  ringwatch::registerExtensions();
  return ringwatch::bench::runBenchmarks(argc, argv, ringwatch::bench::registerAll);
}
