// What the bracket promises of a run: at 0.99 of `safe` a linear-elastic body stays bounded, at 1.02 of `optimistic` it
// does not.
#include <gtest/gtest.h>

#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/integrators/body_system.h>
#include <ringwatch/integrators/stormer_verlet.h>
#include <ringwatch/integrators/symplectic_euler.h>
#include <ringwatch/meshes/quality.h>
#include <ringwatch/monitor/stability_monitor.h>
#include <tests/monitor/monitor_cases.h>

namespace ringwatch {
namespace {

/// Moves an inner node until one of its tetrahedra has a dihedral angle below 1°, all volumes staying positive.
Mesh withSlivers(Mesh mesh) {
  const MeshBlock& block = mesh.blocks[0];
  const auto volumes = [&](const NodeVectors& x) {
    double least = infinity;
    for (std::size_t e = 0; e < block.elementCount(); ++e) least = std::min(least, elementQuality(block, e, x).volume);
    return least;
  };
  const auto angle = [&](const NodeVectors& x) {
    double least = 180;
    for (std::size_t e = 0; e < block.elementCount(); ++e)
      least = std::min(least, elementQuality(block, e, x).minDihedral);
    return least;
  };
  const std::int32_t node = 13;  // the middle one of 3×3×3
  const Eigen::Vector3d from = mesh.X.col(node),
                        direction = Eigen::Vector3d(1, 0.45, 0.2).normalized() * test::cellSize;
  double inside = 0, outside = 2;
  NodeVectors x = mesh.X;
  while (angle(x) > 0.7 || !(volumes(x) > 0)) {
    const double t = 0.5 * (inside + outside);
    x.col(node) = from + t * direction;
    (volumes(x) > 0 ? inside : outside) = t;
  }
  mesh.X = x;
  return mesh;
}

struct RunCase {
  std::string name;
  Mesh mesh;
  bool held;
};
std::vector<RunCase> runCases() {
  const test::Subdivision six{"", "tet4", 6, "", 0}, five{"", "tet4", 5, "", 0}, hexes{"", "hex8", 1, "", 0};
  const Mesh slivers = withSlivers(test::box(six, {2, 2, 2}, 0.1));
  return {{"tets", test::box(six, {2, 2, 1}), false},
          {"tets_held", test::box(five, {3, 1, 1}), true},
          {"hexes", test::box(hexes, {2, 2, 2}), false},
          {"hexes_held", test::box(hexes, {3, 2, 1}), true},
          {"slivers", slivers, false},
          {"slivers_held", slivers, true}};
}

class BoundedRun : public ::testing::TestWithParam<RunCase> {
 protected:
  BoundedRun() : body_(GetParam().mesh, makeMaterial("linear", test::young, 0.4, test::density), test::onThreads(1)) {
    if (GetParam().held) test::holdBody(body_, test::Hold::face);
    step_ = criticalStep(body_, body_.mesh().X, SymplecticEuler::description.imaginaryLimit);
  }
  /// Random velocities, and displacements of a fifth of what they cover in a step: a mode near the limit swings between
  /// energies that differ by (1 + c) / (1 - c), c = h omega / 2, and must not be all there is at the start.
  State start() const {
    State state{0, body_.mesh().X, test::randomVelocities(body_, 0.01, 3)};
    state.x += test::randomVelocities(body_, 0.002 * step_.safe, 4);
    return state;
  }
  double energy(const State& state) {
    return 0.5 * (state.v.colwise().squaredNorm() * body_.lumpedMass())(0, 0) + body_.energy(state.x, workspace_);
  }

  Body body_;
  Body::Workspace workspace_;
  CriticalStep step_;
};
INSTANTIATE_TEST_SUITE_P(Meshes, BoundedRun, ::testing::ValuesIn(runCases()),
                         [](const auto& test) { return test.param.name; });

TEST_P(BoundedRun, StaysBoundedBelowSafe) {
  const double h = 0.99 * step_.safe;
  BodySystem system(body_);
  SymplecticEuler integrator;
  State state = start();
  const double initial = energy(state);
  // Symplectic Euler keeps T + W - h/2 f·v of a linear system exactly, W and f the strain energy and its gradient.
  const auto kept = [&] {
    NodeVectors f;
    body_.internalForce(state.x, f, workspace_);
    return energy(state) - 0.5 * h * f.cwiseProduct(state.v).sum();
  };
  const double invariant = kept();
  double most = 0;
  for (int step = 1; step <= 100000; ++step) {
    integrator.step(system, state, h);
    if (step % 37 == 0) most = std::max(most, energy(state));
  }
  EXPECT_LE(most, 10 * initial);
  EXPECT_GE(most, 0.1 * initial);
  EXPECT_NEAR(kept(), invariant, 1e-7 * initial);
}

TEST_P(BoundedRun, BlowsUpAboveOptimistic) {
  const double h = 1.02 * step_.optimistic;
  for (const std::string_view name : {SymplecticEuler::description.name, StormerVerlet::description.name}) {
    const auto integrator = makeIntegrator(name);
    BodySystem system(body_);
    State state = start();
    const double initial = energy(state);
    for (int step = 0; step < 300; ++step) integrator->step(system, state, h);
    EXPECT_FALSE(energy(state) < 1e10 * initial) << name;
  }
}

TEST(BoundedRun, SliversAreSlivers) {
  int found = 0;
  for (const RunCase& run : runCases()) {
    if (run.name.find("slivers") == std::string::npos) continue;
    ++found;
    double least = 180;
    const auto qualities = meshQuality(run.mesh);
    for (const ElementQuality& quality : qualities[0]) {
      least = std::min(least, quality.minDihedral);
      EXPECT_GT(quality.volume, 0);
    }
    EXPECT_LT(least, 1);
  }
  EXPECT_GT(found, 0);
}

}  // namespace
}  // namespace ringwatch
