// Metrics and bracket of the critical step, ns an element, each with how far its step is from the true one, and dense
// eigenvalues element by element as the peer.
#include <tuple>
#include <utility>

#include <Eigen/Eigenvalues>

#include <bench/support.h>
#include <ringwatch/monitor/global_frequency.h>
#include <ringwatch/monitor/metrics.h>
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

void bracket(benchmark::State& state, const Case& c) {
  Setup& s = setupOf(c);
  CriticalStep step{};
  for (auto _ : state) {
    step = criticalStep(s.body, s.x, 2.0);
    benchmark::DoNotOptimize(std::as_const(step));
  }
  report(state, s.body.mesh().elementCount(), step.safe / step.optimistic - 1);
}

/// The peer: an eigenvalue solver on each element's dense, mass-scaled tangent.
void denseEigenvalues(benchmark::State& state, const Case& c) {
  Setup& s = setupOf(c);
  const ElementBlock& block = *s.body.blocks()[0];
  const int n = block.element().nodes;
  double largest = 0;
  for (auto _ : state) {
    largest = 0;
    for (std::int32_t e = 0; e < block.elementCount(); ++e) {
      Eigen::MatrixXd K = s.body.elementTangent({0, e}, s.x);
      std::vector<double> mass(static_cast<std::size_t>(n));
      s.body.elementLumpedMass({0, e}, mass.data());
      for (int i = 0; i < 3 * n; ++i)
        for (int j = 0; j < 3 * n; ++j)
          K(i, j) /= std::sqrt(mass[static_cast<std::size_t>(i / 3)] * mass[static_cast<std::size_t>(j / 3)]);
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(K, Eigen::EigenvaluesOnly);
      largest = std::max(largest, solver.eigenvalues()[3 * n - 1]);
    }
    benchmark::DoNotOptimize(std::as_const(largest));
  }
  report(state, s.body.mesh().elementCount(), stepError(largest, trueLambda(c, s)));
}

void registerAll() {
  for (const ElementInfo& element : allElements())
    for (const int elements : {5000, 100000})
      for (const int threads : {1, 2}) {
        const Case c{std::string(element.name), elements, "stvk", threads};
        const auto add = [&](std::string_view what, const auto& run) {
          benchmark::RegisterBenchmark((std::string(what) + "/" + c.name()).c_str(), run)
              ->UseRealTime()
              ->Unit(benchmark::kMicrosecond);
        };
        for (const MetricInfo& info : allMetrics())
          // The larger rings cost a hundred times as much an element, whatever the size of the mesh.
          if (elements <= 5000 || info.name.find("-ring") == std::string_view::npos || info.name == "reduced-1-ring")
            add(info.name, [c, name = info.name](benchmark::State& state) { metric(state, c, name); });
        add("bracket", [c](benchmark::State& state) { bracket(state, c); });
        if (threads == 1) add("dense_eigenvalues", [c](benchmark::State& state) { denseEigenvalues(state, c); });
      }
}

}  // namespace
}  // namespace ringwatch::bench

int main(int argc, char** argv) {
  ringwatch::bench::registerAll();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
