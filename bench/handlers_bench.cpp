// A step of a handler against the explicit steps that it replaces, on Fierz 2013's cube (docs/handlers.md): ms a step
// of 0.4 ms, its share of four steps of Verlet at 0.1 ms in the same run, and the mean error in mm against 0.05 ms.
#include <algorithm>
#include <cmath>
#include <ctime>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include <bench/support.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/base/random.h>
#include <ringwatch/handlers/handler.h>
#include <ringwatch/handlers/imex/implicit_cluster.h>
#include <ringwatch/integrators/body_system.h>
#include <ringwatch/meshes/generators/generators.h>
#include <ringwatch/meshes/modify/cut.h>
#include <ringwatch/monitor/bounds/global_frequency.h>
#include <ringwatch/verify/fierz2013/fierz2013.h>

namespace ringwatch::bench {
namespace {

constexpr double target = 4e-4;  // s

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

void imex(benchmark::State& state, const Deformation& d, const HandlerOptions& options) {
  const NodeVectors exact = runVerlet(d, 8).x;
  double best = infinity, reference = best, error = 0, handled = 0;
  for (auto _ : state) {
    reference = std::min(reference, runVerlet(d, 4).seconds);
    Body body = d.body();
    const auto handler = makeHandler("imex", body, makeIntegrator("verlet"), options);
    handler->prepare(body.mesh().X, target);
    const Ran own = run(d, body, *handler, 1);
    state.SetIterationTime(own.seconds);
    best = std::min(best, own.seconds);
    error = (own.x - exact).colwise().norm().mean();
    handled = static_cast<double>(handler->elements().size());
  }
  state.counters["ms_a_step"] = 1e3 * best;
  state.counters["of_four_explicit"] = best / reference;
  state.counters["error_mm"] = 1e3 * error;
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
  for (const Deformation& d : allDeformations(0.3)) {
    if (d.mesh != "cube") continue;
    for (const double tolerance : {2e-3, 1e-8}) {
      const HandlerOptions options{.own = {{"tolerance", tolerance}}};
      const std::string name = "imex/" + std::string(d.mode) + (d.byForce ? "/force" : "/position") +
                               (tolerance < 1e-5 ? "/tolerance:1e-8" : "");
      benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) { imex(state, d, options); })
          ->UseManualTime()
          ->Iterations(3);
    }
  }
}

}  // namespace
}  // namespace ringwatch::bench

int main(int argc, char** argv) { return ringwatch::bench::runBenchmarks(argc, argv, ringwatch::bench::registerAll); }
