// Contact of surfaces: what its search and its forces take of a step, and what it adds to a certificate that is kept
// along a run. A bar of cubes of 1 cm cut into tetrahedra, on which a plate lies that presses and slides; about a tenth
// of the bar's surface nodes touch.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <bench/runs.h>
#include <bench/support.h>
#include <ringwatch/body/discrete_forces.h>
#include <ringwatch/integrators/body_system.h>
#include <ringwatch/integrators/symplectic_euler.h>
#include <ringwatch/meshes/surface.h>
#include <ringwatch/monitor/bounds/global_frequency.h>
#include <ringwatch/monitor/incremental/incremental_nodal_bound.h>

namespace ringwatch::bench {
namespace {

constexpr double cell = 0.01, young = 1e6, density = 1000;

Mesh barAndPlate(int n) {
  StackOptions options;
  options.lower.size = {5 * n * cell, n * cell, n * cell};
  options.lower.cells = {5 * n, n, n};
  options.lower.jitter = 0.15;
  options.upperSize = {0.9 * n * cell, 0.9 * n * cell, 2 * cell};
  options.upperCells = {n, n, 2};
  return generateStack(options);
}

/// edges: everything, and edges against edges.
enum class Touching { plate, everything, edges };

/// 1000 steps of symplectic Euler at half of the critical step, in turns with the same run without contact; certified
/// at every step by the certificate of threshold mode. error: largest difference of the sum of the contact's forces
/// from zero, over their largest.
void alongARun(benchmark::State& state, int n, Touching touching) {
  const Mesh mesh = barAndPlate(n);
  Body plain(mesh, makeMaterial("stvk", young, 0.3, density), {{}, Lumping::rowSum, 1});
  Body body(mesh, makeMaterial("stvk", young, 0.3, density), {{}, Lumping::rowSum, 1});
  const double sigma = globalFrequency(plain, mesh.X, 1e-6).lambda, h = 0.5 * 2 / std::sqrt(sigma);
  const std::vector<std::int32_t> surface = surfaceNodes(mesh);
  const auto of = [&](const char* set) {
    std::vector<std::int32_t> nodes;
    const auto& all = mesh.nodeSets.at(set);
    std::set_intersection(surface.begin(), surface.end(), all.begin(), all.end(), std::back_inserter(nodes));
    return nodes;
  };
  DiscreteForces forces(body.nodeCount());
  const auto add = [&](std::vector<std::int32_t> nodes, const std::vector<std::int32_t>& to) {
    constexpr double sharp = 20 * M_PI / 180;
    SurfaceContact contact = surfaceContact(mesh, std::move(nodes), to,
                                            touching == Touching::edges ? std::optional<double>(sharp) : std::nullopt);
    const double slow = M_PI / (40 * h);  // corners of the bar are lighter than what stands on them
    for (SurfaceContact::Edge& edge : contact.edges) {
      edge.mass = std::min(body.lumpedMass()[edge.nodes[0]], body.lumpedMass()[edge.nodes[1]]);
      edge.penalty = edge.mass * slow * slow;
    }
    for (const std::int32_t node : contact.nodes) {
      contact.penalty.push_back(body.lumpedMass()[node] * slow * slow);
      contact.damping.push_back(0);
    }
    forces.add(std::move(contact));
  };
  if (touching != Touching::plate) {
    add(surface, surface);
  } else {
    add(of("upper"), of("lower"));
    add(of("lower"), of("upper"));
  }
  body.setDiscreteForces(std::move(forces));
  const double wave = std::sqrt(young / density);
  State start;
  start.x = mesh.X;
  start.v = NodeVectors::Zero(3, start.x.cols());
  // A hundredth of the speed of waves.
  for (const std::int32_t node : mesh.nodeSets.at("upper"))
    start.v.col(node) = 0.01 * wave * Eigen::Vector3d(0.3, 0.1, -1);
  double stepTime = 0, contactStepTime = 0, proofTime = 0, contactProofTime = 0, searchTime = 0, error = 0, most = 0,
         workWithContact = 0;
  std::int64_t refused = 0, plainRefused = 0, rebuilds = 0, lists = 0, pairs = 0, edgePairs = 0;
  for (auto _ : state) {
    BodySystem plainSystem(plain), system(body);
    SymplecticEuler plainEuler, euler;
    State a = start, b = start;
    IncrementalNodalBound plainBound(plain), bound(body);
    stepTime = contactStepTime = proofTime = contactProofTime = searchTime = most = 0;
    refused = plainRefused = rebuilds = 0;
    for (int step = 0; step <= 400; ++step) {
      body.discreteForces()->setReach(2 * h * body.discreteForces()->largestSpeed(b.v));
      // The certificate alone: no force is asked for.
      const double t0 = cpuSeconds();
      const bool plainProven = plainBound.certify(a.x, 2 * sigma);
      const double t1 = cpuSeconds();
      body.discreteForces()->locate(b.x);
      const double located = cpuSeconds();
      const bool proven = bound.certify(b.x, 2 * sigma);
      const double t2 = cpuSeconds();
      plainEuler.step(plainSystem, a, h);
      const double t3 = cpuSeconds();
      euler.step(system, b, h);
      const double t4 = cpuSeconds();
      plainRefused += !plainProven;
      refused += !proven;
      if (step == 0) continue;  // what is made once
      proofTime += t1 - t0;
      searchTime += located - t1;
      contactProofTime += t2 - located;
      rebuilds += bound.statistics().rebuilds + bound.statistics().refreshes;
      stepTime += t3 - t2;
      contactStepTime += t4 - t3;
      const std::int64_t touchingNow = body.discreteForces()->contactState(b.x).touching;
      most = std::max(most, static_cast<double>(touchingNow));
      if (touchingNow == 0) continue;
      NodeVectors f = NodeVectors::Zero(3, b.x.cols());
      body.discreteForces()->addInternalForce(b.x, f);
      error = std::max(error, f.rowwise().sum().norm() / f.cwiseAbs().maxCoeff());
    }
    lists = 0;
    pairs = edgePairs = 0;
    for (const SurfaceSearch& one : body.discreteForces()->surfaces()) {
      lists += one.statistics().lists;
      pairs += one.statistics().pairs;
      edgePairs += one.statistics().edgePairs;
    }
    workWithContact = bound.spent().total() / plainBound.spent().total() - 1;
    state.SetIterationTime(stepTime + contactStepTime + proofTime + contactProofTime);
  }
  report(state, 400 * mesh.elementCount(), error);
  state.counters["step_ms"] = 1e3 * stepTime / 400;
  state.counters["contact_over_step"] = (searchTime + contactStepTime) / stepTime - 1;
  state.counters["search"] = searchTime / stepTime;
  state.counters["proof_ms"] = 1e3 * proofTime / 400;
  state.counters["proof_with_contact"] = contactProofTime / proofTime - 1;
  state.counters["work_with_contact"] = workWithContact;
  state.counters["touching"] = most;
  state.counters["surface_nodes"] = static_cast<double>(surface.size());
  state.counters["lists"] = static_cast<double>(lists);
  state.counters["pairs"] = static_cast<double>(pairs) / 400;
  state.counters["edge_pairs"] = static_cast<double>(edgePairs) / 400;
  state.counters["refused"] = static_cast<double>(refused);
  state.counters["plain_refused"] = static_cast<double>(plainRefused);
  state.counters["rebuilds"] = static_cast<double>(rebuilds);
}

}  // namespace
}  // namespace ringwatch::bench

int main(int argc, char** argv) {
  using namespace ringwatch::bench;
  for (const int n : {6, 15}) {
    const std::string size = std::to_string(5 * n * n * n * 6 / 1000) + "k";
    for (const auto& [name, touching] :
         {std::pair("plate", Touching::plate), std::pair("everything", Touching::everything),
          std::pair("edges", Touching::edges)})
      benchmark::RegisterBenchmark(("contact/" + std::string(name) + "/tet4/" + size).c_str(),
                                   [n, touching = touching](benchmark::State& state) { alongARun(state, n, touching); })
          ->UseManualTime()
          ->Iterations(1)
          ->Unit(benchmark::kMillisecond);
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
