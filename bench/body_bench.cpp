// Force, tangent and energy passes, ns an element, each with the largest relative difference from a plain reference,
// and the floor of the machine in the same run.
#include <algorithm>
#include <chrono>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <bench/needs.h>
#include <bench/support.h>
#include <ringwatch/base/median.h>
#include <tests/support/scalar_reference.h>

namespace ringwatch::bench {
namespace {

/// Calls visit(ScalarReference) for a case.
template <class Visit>
void withReference(const Case& c, const Setup& setup, const Visit& visit) {
  test::withScalarReference(setup.body.mesh(), makeMaterial(c.law, 30e3, 0.3, 1000), setup.body.blocks()[0]->rule(),
                            visit);
}

void force(benchmark::State& state, const Case& c) {
  Setup& s = setupOf(c);
  NodeVectors f, expected;
  for (auto _ : state) {
    s.body.internalForce(s.x, f, s.workspace);
    benchmark::DoNotOptimize(f.data());
    benchmark::ClobberMemory();
  }
  withReference(c, s, [&](const auto& reference) { reference.force(s.x, expected); });
  report(state, s.body.mesh().elementCount(), relativeDifference(f, expected));
  reportFloor(state, s.body.mesh().elementCount(), needOf(c, s, Pass::force));
}

void tangentProduct(benchmark::State& state, const Case& c) {
  Setup& s = setupOf(c);
  NodeVectors Kv, expected;
  for (auto _ : state) {
    s.body.tangentProduct(s.x, s.v, Kv, s.workspace);
    benchmark::DoNotOptimize(Kv.data());
    benchmark::ClobberMemory();
  }
  withReference(c, s, [&](const auto& reference) { reference.tangentProduct(s.x, s.v, expected); });
  report(state, s.body.mesh().elementCount(), relativeDifference(Kv, expected));
  reportFloor(state, s.body.mesh().elementCount(), needOf(c, s, Pass::product));
}

void energy(benchmark::State& state, const Case& c) {
  Setup& s = setupOf(c);
  double value = 0, expected = 0;
  for (auto _ : state) {
    value = s.body.energy(s.x, s.workspace);
    benchmark::DoNotOptimize(std::as_const(value));
  }
  withReference(c, s, [&](const auto& reference) { expected = reference.energy(s.x); });
  report(state, s.body.mesh().elementCount(), std::abs(value - expected) / expected);
}

void elementTangents(benchmark::State& state, const Case& c) {
  Setup& s = setupOf(c);
  for (auto _ : state)
    s.body.forEachTangentBatch(s.x,
                               [](std::size_t, std::int32_t, const NativePack* K) { benchmark::DoNotOptimize(K); });
  // Error: Σ K_e v against the reference product.
  NodeVectors Kv = NodeVectors::Zero(3, s.x.cols()), expected;
  const ElementBlock& block = *s.body.blocks()[0];
  for (std::int32_t e = 0; e < block.elementCount(); ++e) {
    const auto nodes = block.nodesOf(e);
    Eigen::VectorXd v(3 * nodes.size());
    for (std::size_t a = 0; a < nodes.size(); ++a) v.segment<3>(static_cast<Eigen::Index>(3 * a)) = s.v.col(nodes[a]);
    const Eigen::VectorXd Kev = s.body.elementTangent({0, e}, s.x) * v;
    for (std::size_t a = 0; a < nodes.size(); ++a) Kv.col(nodes[a]) += Kev.segment<3>(static_cast<Eigen::Index>(3 * a));
  }
  withReference(c, s, [&](const auto& reference) { reference.tangentProduct(s.x, s.v, expected); });
  report(state, s.body.mesh().elementCount(), relativeDifference(Kv, expected));
  reportFloor(state, s.body.mesh().elementCount(), needOf(c, s, Pass::tangent));
}

double productError(const Case& c, const Setup& s, const Eigen::SparseMatrix<double>& K) {
  NodeVectors Kv(3, s.x.cols()), expected;
  Kv.reshaped() = K * s.v.reshaped();
  withReference(c, s, [&](const auto& reference) { reference.tangentProduct(s.x, s.v, expected); });
  return relativeDifference(Kv, expected);
}

/// The sparse matrix from scratch, pattern included.
void assembleTangent(benchmark::State& state, const Case& c) {
  Setup& s = setupOf(c);
  Eigen::SparseMatrix<double> K;
  for (auto _ : state) {
    K = s.body.assembleTangent(s.x);
    benchmark::DoNotOptimize(K.valuePtr());
  }
  report(state, s.body.mesh().elementCount(), productError(c, s, K));
}

/// The sparse matrix again, its pattern kept.
void reassembleTangent(benchmark::State& state, const Case& c) {
  Setup& s = setupOf(c);
  SparseTangent K;
  s.body.assembleTangent(s.x, K);
  for (auto _ : state) {
    s.body.assembleTangent(s.x, K);
    benchmark::DoNotOptimize(K.matrix.valuePtr());
    benchmark::ClobberMemory();
  }
  const auto elements = static_cast<double>(s.body.mesh().elementCount());
  report(state, s.body.mesh().elementCount(), productError(c, s, K.matrix));
  reportFloor(state, s.body.mesh().elementCount(), needOf(c, s, Pass::assembly));
  state.counters["pattern_bytes"] = static_cast<double>(K.blocks.patternBytes()) / elements;
  state.counters["value_bytes"] = static_cast<double>(K.blocks.valueBytes()) / elements;
}

/// Node and edge blocks only, their pattern kept.
void reassembleBlocks(benchmark::State& state, const Case& c) {
  Setup& s = setupOf(c);
  SparseTangent K;
  s.body.assembleTangent(s.x, K);
  for (auto _ : state) {
    s.body.assembleBlocks(s.x, K.blocks);
    benchmark::DoNotOptimize(K.blocks.block.data());
    benchmark::ClobberMemory();
  }
  report(state, s.body.mesh().elementCount(), productError(c, s, K.matrix));
}

/// The baseline: the same law, one element after the other in plain doubles.
void scalarForce(benchmark::State& state, const Case& c) {
  Setup& s = setupOf(c);
  NodeVectors f, expected;
  s.body.internalForce(s.x, expected, s.workspace);
  withReference(c, s, [&](const auto& reference) {
    for (auto _ : state) {
      reference.force(s.x, f);
      benchmark::DoNotOptimize(f.data());
      benchmark::ClobberMemory();
    }
  });
  report(state, s.body.mesh().elementCount(), relativeDifference(f, expected));
}

/// The damping forces of elements, in plain doubles, one element after the other.
NodeVectors plainDampingForce(const Setup& s, const DampingConstants& damping) {
  const ElementBlock& block = *s.body.blocks()[0];
  const Material& material = block.material();
  const int n = block.nodesPerElement();
  const NodeVectors& X = s.body.mesh().X;
  const double lambda = damping.volumeViscosity - 2.0 / 3 * damping.shearViscosity;
  NodeVectors force = NodeVectors::Zero(3, X.cols());
  for (std::int32_t e = 0; e < block.elementCount(); ++e) {
    const auto nodes = block.nodesOf(e);
    double volume = 0, rest = 0, rate = 0, dN[maxElementNodes][3];
    Eigen::Matrix<double, 3, Eigen::Dynamic> w = Eigen::MatrixXd::Zero(3, n), mean = w;
    const auto addPoint = [&](double weight, const Eigen::Matrix<double, 3, Eigen::Dynamic>& g) {
      Eigen::Matrix3d F = Eigen::Matrix3d::Zero(), dF = F;
      for (int a = 0; a < n; ++a) {
        F += (s.x.col(nodes[a]) - s.x.col(nodes[0])) * g.col(a).transpose();
        dF += (s.v.col(nodes[a]) - s.v.col(nodes[0])) * g.col(a).transpose();
      }
      const Eigen::Matrix3d half = F.transpose() * dF;
      const Eigen::Matrix3d S =
          lambda * half.trace() * Eigen::Matrix3d::Identity() + damping.shearViscosity * (half + half.transpose());
      volume += weight * F.determinant();
      for (int a = 0; a < n; ++a) {
        w.col(a) += weight * F.determinant() * F.inverse().transpose() * g.col(a);
        force.col(nodes[a]) += weight * F * S * g.col(a);
      }
    };
    const bool uniform = block.rule().uniformStrain;
    for (const QuadraturePoint& point : uniform ? block.element().massRule.points : block.rule().points) {
      block.element().shapeGradient(point.xi, dN);
      Eigen::Matrix<double, 3, Eigen::Dynamic> g(3, n);
      for (int a = 0; a < n; ++a) g.col(a) << dN[a][0], dN[a][1], dN[a][2];
      Eigen::Matrix3d J = Eigen::Matrix3d::Zero();
      for (int a = 0; a < n; ++a) J += (X.col(nodes[a]) - X.col(nodes[0])) * g.col(a).transpose();
      const double weight = point.weight * J.determinant();
      g = J.inverse().transpose() * g;
      rest += weight;
      mean += weight * g;
      if (!uniform) addPoint(weight, g);
    }
    if (uniform) addPoint(rest, mean / rest);
    for (int a = 0; a < n; ++a) rate += w.col(a).dot(s.v.col(nodes[a])) / volume;
    const double length = std::cbrt(rest), speed = material.waveSpeed(), density = material.density * rest / volume;
    double pressure = -density * length * damping.linearBulk * speed * rate;
    if (rate < 0) pressure += density * std::pow(damping.quadraticBulk * length * rate, 2);
    for (int a = 0; a < n; ++a) force.col(nodes[a]) -= pressure * w.col(a);
  }
  return force;
}

/// A body with damping, where the setup has one without.
Setup damped(const Case& c, const DampingConstants& damping) {
  Setup& plain = setupOf(c);
  ElementRules rules;
  if (!c.rule.empty()) rules[c.element] = c.rule;
  Setup s{Body(plain.body.mesh(), makeMaterial(c.law, 30e3, 0.3, 1000), {rules, Lumping::rowSum, c.threads}),
          plain.x,
          plain.v,
          {}};
  s.body.setElementDamping({damping});
  return s;
}

/// The damping force of elements alone, which comes on top of `force` where it is not part of its pass.
void dampingForce(benchmark::State& state, const Case& c, const DampingConstants& damping) {
  Setup s = damped(c, damping);
  NodeVectors f = NodeVectors::Zero(3, s.x.cols());
  for (auto _ : state) {
    s.body.addElementDampingForce(s.x, s.v, f, s.workspace);
    benchmark::DoNotOptimize(f.data());
    benchmark::ClobberMemory();
  }
  f.setZero();
  s.body.addElementDampingForce(s.x, s.v, f, s.workspace);
  report(state, s.body.mesh().elementCount(), relativeDifference(f, plainDampingForce(s, damping)));
}
/// Internal force with bulk viscosity and without in one loop, pass by pass, so that both see the same machine;
/// `over_force`: by how much the median is dearer, in per cent.
void forceWithBulkViscosity(benchmark::State& state, const Case& c) {
  const DampingConstants damping{0.06, 1.2, 0, 0, 0};
  Setup s = damped(c, damping);
  NodeVectors f, elastic;
  std::vector<double> with, without;
  const auto seconds = [](const auto& work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  };
  for (auto _ : state) {
    without.push_back(seconds([&] { s.body.internalForce(s.x, elastic, s.workspace); }));
    with.push_back(seconds([&] { s.body.resistingForce(s.x, s.v, f, s.workspace); }));
    state.SetIterationTime(with.back());
    benchmark::DoNotOptimize(f.data());
    benchmark::ClobberMemory();
  }
  NodeVectors expected;
  withReference(c, s, [&](const auto& reference) { reference.force(s.x, expected); });
  expected += plainDampingForce(s, damping);
  report(state, s.body.mesh().elementCount(), relativeDifference(f, expected));
  state.counters["over_force"] = 100 * (median(with) / median(without) - 1);
}
void bulkViscosity(benchmark::State& state, const Case& c) { dampingForce(state, c, {0.06, 1.2, 0, 0, 0}); }
void kelvinVoigt(benchmark::State& state, const Case& c) { dampingForce(state, c, {0, 0, 1, 2, 0}); }

/// Beside the kernels of the usual rule: those of hexahedra of uniform strain.
void registerUniformStrain(int elements, const std::string& law) {
  const Case c{"hex8", elements, law, 1, "uniform-strain"};
  const auto add = [&](const char* pass, void (*run)(benchmark::State&, const Case&)) {
    benchmark::RegisterBenchmark((std::string(pass) + "/" + c.name()).c_str(),
                                 [=](benchmark::State& state) { run(state, c); })
        ->UseRealTime()
        ->Unit(benchmark::kMicrosecond);
  };
  add("force", force);
  add("energy", energy);
  add("tangent_product", tangentProduct);
  if (law != "stvk") return;
  benchmark::RegisterBenchmark(("force_with_bulk_viscosity/" + c.name()).c_str(),
                               [=](benchmark::State& state) { forceWithBulkViscosity(state, c); })
      ->UseManualTime()
      ->Unit(benchmark::kMicrosecond);
}

/// The machine's best, as rows.
void floorRow(benchmark::State& state, const char* name, double value) {
  for (auto _ : state) benchmark::ClobberMemory();
  state.counters[name] = value;
}

void registerAll() {
  benchmark::RegisterBenchmark("floor/copy_bandwidth", [](benchmark::State& state) {
    floorRow(state, "bytes_per_second", machine().bytesPerSecond);
  })->Iterations(1);
  benchmark::RegisterBenchmark("floor/multiply_add_peak", [](benchmark::State& state) {
    floorRow(state, "flops_per_second", machine().flopsPerSecond);
  })->Iterations(1);
  for (const int elements : {5000, 100000})
    for (const LawInfo& law : allLaws()) registerUniformStrain(elements, std::string(law.name));
  for (const ElementInfo& element : allElements())
    for (const int elements : {5000, 100000})
      for (const LawInfo& law : allLaws())
        for (const int threads : {1, 2}) {
          const Case c{std::string(element.name), elements, std::string(law.name), threads};
          const auto add = [&](const char* pass, void (*run)(benchmark::State&, const Case&)) {
            benchmark::RegisterBenchmark((std::string(pass) + "/" + c.name()).c_str(),
                                         [=](benchmark::State& state) { run(state, c); })
                ->UseRealTime()
                ->Unit(benchmark::kMicrosecond);
          };
          add("force", force);
          if (threads == 1) add("scalar_force", scalarForce);
          if (law.name == "stvk") {
            benchmark::RegisterBenchmark(("force_with_bulk_viscosity/" + c.name()).c_str(),
                                         [=](benchmark::State& state) { forceWithBulkViscosity(state, c); })
                ->UseManualTime()
                ->Unit(benchmark::kMicrosecond);
            add("bulk_viscosity", bulkViscosity);
            add("kelvin_voigt", kelvinVoigt);
          }
          add("tangent_product", tangentProduct);
          add("energy", energy);
          add("element_tangents", elementTangents);
          add("assemble_tangent", assembleTangent);
          add("reassemble_tangent", reassembleTangent);
          add("reassemble_blocks", reassembleBlocks);
        }
}

}  // namespace
}  // namespace ringwatch::bench

int main(int argc, char** argv) { return ringwatch::bench::runBenchmarks(argc, argv, ringwatch::bench::registerAll); }
