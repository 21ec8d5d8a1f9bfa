#pragma once
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include <ringwatch/base/random.h>
#include <ringwatch/body/body.h>
#include <ringwatch/meshes/generators/generators.h>

namespace ringwatch::bench {

/// What a benchmark runs on: a jittered box of cubes of 1 cm, its nodes displaced by a smooth strain and some noise.
struct Case {
  std::string element;
  int elements;  // about so many
  std::string law;
  int threads;
  std::string rule = {};  // "": the element's first

  auto key() const { return std::tie(element, elements, law, threads, rule); }
  std::string name() const {
    return element + (rule.empty() ? "" : "-" + rule) + "/" + law + "/" + std::to_string(elements / 1000) +
           "k/threads:" + std::to_string(threads);
  }
};

struct Setup {
  Body body;
  NodeVectors x, v;
  Body::Workspace workspace;
};

/// split: elements a cell, one of the element's splits; 0 for its first.
inline Mesh makeMesh(const Case& c, int split = 0) {
  BarOptions options;
  options.element = c.element;
  options.jitter = 0.15;
  options.split = split;
  int perCell = std::max(1, split);
  for (const CellSubdivision& known : allCellSubdivisions())
    if (split == 0 && known.element == c.element) {
      perCell = known.elementsPerCell;
      break;
    }
  const int n = static_cast<int>(std::lround(std::cbrt(static_cast<double>(c.elements) / perCell)));
  options.cells = {n, n, n};
  options.size = {0.01 * n, 0.01 * n, 0.01 * n};
  return generateBar(options);
}

/// The setup of a case; the last one is kept, since benchmarks of one case follow one another.
inline Setup& setupOf(const Case& c) {
  static std::unique_ptr<Case> last;
  static std::unique_ptr<Setup> setup;
  if (last && last->key() == c.key()) return *setup;
  setup.reset();
  setup.reset(new Setup{
      Body(makeMesh(c), makeMaterial(c.law, 30e3, 0.3, 1000), {{{c.element, c.rule}}, Lumping::rowSum, c.threads}),
      {},
      {},
      {}});
  Random source(1);
  // Plain loops: GCC 12 at -O3 gives every entry of NullaryExpr with such a source the same number.
  const auto random = [&](Eigen::Index columns) {
    NodeVectors values(3, columns);
    for (Eigen::Index j = 0; j < columns; ++j)
      for (int i = 0; i < 3; ++i) values(i, j) = source.uniform(-1, 1);
    return values;
  };
  const NodeVectors& X = setup->body.mesh().X;
  Eigen::Matrix3d F;
  F << 1.1, 0.02, 0, -0.03, 0.95, 0.01, 0, 0.04, 1.02;
  setup->x = F * X + 2e-4 * random(X.cols());
  setup->v = random(X.cols());
  last = std::make_unique<Case>(c);
  return *setup;
}

/// What this machine's core does at best: the least times of a few rounds, measured once in every program.
struct Machine {
  double bytesPerSecond;  // read and written when copying 64 MiB
  double flopsPerSecond;  // of independent fused multiply-adds in packs
};
inline const Machine& machine() {
  static const Machine measured = [] {
    const auto seconds = [](const auto& work) {
      double least = 1e9;
      for (int round = 0; round < 15; ++round) {
        const auto begin = std::chrono::steady_clock::now();
        work();
        least = std::min(least, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
      }
      return least;
    };
    const std::vector<double> from(1 << 23, 1.0);
    std::vector<double> to(from.size());
    const double copied = seconds([&] {
      std::memcpy(to.data(), from.data(), from.size() * sizeof(double));
      benchmark::ClobberMemory();
    });
    constexpr int chains = 16, rounds = 100000;
    NativePack sum[chains];
    for (int i = 0; i < chains; ++i) sum[i] = NativePack(i);
    NativePack a(0.999999), b(1e-6);
    benchmark::DoNotOptimize(a);
    benchmark::DoNotOptimize(b);
    const double added = seconds([&] {
      for (int r = 0; r < rounds; ++r)
#pragma GCC unroll 16
        for (int i = 0; i < chains; ++i) sum[i] = sum[i] * a + b;
      benchmark::DoNotOptimize(sum);
    });
    return Machine{2.0 * static_cast<double>(from.size() * sizeof(double)) / copied,
                   2.0 * chains * rounds * NativePack::width / added};
  }();
  return measured;
}

/// What one element needs at least: operations counted in the kernel's own source, and bytes of a mesh that does not
/// fit into the cache; 0 where it does.
struct Need {
  double flops, bytes;
  double nanoseconds() const {
    return 1e9 * std::max(flops / machine().flopsPerSecond, bytes / machine().bytesPerSecond);
  }
};
/// Time over the floor, and what makes the floor.
inline void reportFloor(benchmark::State& state, std::size_t elements, const Need& need) {
  using benchmark::Counter;
  state.counters["flops"] = need.flops;
  state.counters["bytes"] = need.bytes;
  state.counters["floor_ns"] = need.nanoseconds();
  state.counters["over_floor"] = Counter(static_cast<double>(elements) * need.nanoseconds() * 1e-9,
                                         Counter::kIsIterationInvariantRate | Counter::kInvert);
}

/// Time over elements and the error of the result, beside one another.
inline void report(benchmark::State& state, std::size_t elements, double error) {
  using benchmark::Counter;
  state.counters["ns_per_element"] =
      Counter(static_cast<double>(elements) * 1e-9, Counter::kIsIterationInvariantRate | Counter::kInvert);
  state.counters["elements"] = static_cast<double>(elements);
  state.counters["error"] = error;
}

inline double relativeDifference(const NodeVectors& a, const NodeVectors& b) {
  return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
}

/// The main of a benchmark program.
inline int runBenchmarks(int argc, char** argv, void (*registerAll)()) {
  registerAll();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}

}  // namespace ringwatch::bench
