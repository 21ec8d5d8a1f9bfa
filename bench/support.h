#pragma once
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <tuple>

#include <ringwatch/base/random.h>
#include <ringwatch/body/body.h>
#include <ringwatch/meshes/generators.h>

namespace ringwatch::bench {

/// What a benchmark runs on: a jittered box of cubes of 1 cm, its nodes displaced by a smooth strain and some noise.
struct Case {
  std::string element;
  int elements;  // about so many
  std::string law;
  int threads;

  auto key() const { return std::tie(element, elements, law, threads); }
  std::string name() const {
    return element + "/" + law + "/" + std::to_string(elements / 1000) + "k/threads:" + std::to_string(threads);
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
  for (const CellSplit& known : allCellSplits())
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
  setup.reset(
      new Setup{Body(makeMesh(c), makeMaterial(c.law, 30e3, 0.3, 1000), {{}, Lumping::rowSum, c.threads}), {}, {}, {}});
  Random source(1);
  const auto random = [&] { return source.uniform(-1, 1); };
  const NodeVectors& X = setup->body.mesh().X;
  Eigen::Matrix3d F;
  F << 1.1, 0.02, 0, -0.03, 0.95, 0.01, 0, 0.04, 1.02;
  setup->x = F * X + 2e-4 * NodeVectors::NullaryExpr(3, X.cols(), random);
  setup->v = NodeVectors::NullaryExpr(3, X.cols(), random);
  last = std::make_unique<Case>(c);
  return *setup;
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

}  // namespace ringwatch::bench
