// Contact of surfaces in the bracket: both sides against dense eigenvalues, from scratch and along runs in which two
// bodies meet, slide and part, and two cubes against one another in closed form.
#include <gtest/gtest.h>

#include <cmath>

#include <ringwatch/meshes/surface.h>
#include <ringwatch/monitor/bounds/reduced_ring.h>
#include <tests/monitor/bracket_checks.h>

namespace ringwatch {
namespace {

using test::DenseTangent;
using test::exact;
using test::stepOf;

/// Of the order of a cell's own stiffness, N/m.
constexpr double stiffnessOfACell = test::young * test::cellSize;

/// Two boxes of 2 × 2 × 1 cells and 1 × 2 × 1 larger ones, all of whose surfaces touch one another.
Body twoBodies(std::string_view element, double penalty, std::uint64_t seed, int threads = 1, int cells = 2) {
  StackOptions options;
  options.lower.element = element;
  options.lower.size = {0.02, 0.02, 0.01};
  options.lower.cells = {cells, cells, 1};
  options.lower.jitter = 0.2;
  options.lower.seed = seed;
  options.upperSize = {0.014, 0.018, 0.012};
  options.upperCells = {cells - 1, cells, 1};
  options.gap = 2e-4;
  Body body(generateStack(options), makeMaterial("stvk", test::young, test::poisson, test::density),
            {{}, Lumping::rowSum, threads});
  test::Random random(seed);
  DiscreteForces forces(body.nodeCount());
  const std::vector<std::int32_t> surface = surfaceNodes(body.mesh());
  SurfaceContact contact = surfaceContact(body.mesh(), surface, surface);
  for (std::size_t k = 0; k < contact.nodes.size(); ++k) {
    contact.penalty.push_back(penalty * random.uniform(0.5, 1));
    contact.damping.push_back(1e-4 * penalty * random.uniform(0, 1));
    contact.split[k] = std::exp(random.uniform(-0.7, 0.7));
  }
  forces.add(std::move(contact));
  if (random.index(2) == 0) forces.setDampingFactor(random.uniform(0, 3e3));
  body.setDiscreteForces(std::move(forces));
  return body;
}

/// The upper body comes down, slides and turns, and leaves; both shake.
NodeVectors meeting(const Body& body, int step, const NodeVectors& shake) {
  const double at = 0.1 * step, edge = test::cellSize;
  const Eigen::Vector3d centre(0.01, 0.01, 0.016);
  const Eigen::AngleAxisd turn(0.08 * std::sin(0.9 * at), Eigen::Vector3d(0.3, 1, 0.2).normalized());
  const Eigen::Vector3d shift(0.25 * edge * std::sin(0.7 * at), 0.2 * edge * std::sin(1.1 * at),
                              0.06 * edge - 0.2 * edge * std::abs(std::sin(0.8 * at)));
  NodeVectors x = body.mesh().X;
  for (const std::int32_t node : body.mesh().nodeSets.at("upper"))
    x.col(node) = turn * (x.col(node) - centre) + centre + shift;
  return x + std::sin(2.1 * at) * shake;
}

TEST(SurfaceContactBounds, HoldFromScratch) {
  int brackets = 0, governed = 0;
  for (const char* element : {"tet4", "hex8"})
    for (const double share : {0.3, 3.0, 10.0})
      for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        Body body = twoBodies(element, share * stiffnessOfACell, seed);
        const NodeVectors shake = test::Random(seed).nodeVectors(body.nodeCount(), 0.05 * test::cellSize);
        const NodeVectors x = meeting(body, 10 + static_cast<int>(seed), shake);
        ASSERT_GT(body.discreteForces()->contactState(x).touching, 0);
        const Eigen::VectorXd lambda = DenseTangent(body, x).eigenvalues();
        const double largest = lambda[lambda.size() - 1];
        const std::string what = joinText(element, ", ", share, ", ", seed);
        const CriticalStep step = criticalStep(body, x, 2.0);
        test::expectHolds(step, largest, what);
        EXPECT_LE(step.optimistic, 1.1 * stepOf(largest)) << what;
        if (step.lowestRing < 0) {
          ASSERT_GE(step.lowestRing, lambda[0] - exact * largest) << what;
        }
        ReducedRing ring(body);
        ASSERT_LE(ring.evaluate(x).highest, largest * (1 + exact)) << what;
        test::expectProofsHold(body, x, largest, what);
        governed += step.discreteShare > 0.5;
        ++brackets;
      }
  EXPECT_EQ(brackets, 48);
  EXPECT_GT(governed, 10);
}

TEST(SurfaceContactBounds, HoldAlongRunsWithTogglingContact) {
  test::ContactRuns runs;
  for (const char* element : {"tet4", "hex8"})
    for (const double share : {0.1, 1.0, 5.0}) {
      Body body = twoBodies(element, share * stiffnessOfACell, 5);
      const NodeVectors shake = test::Random(12).nodeVectors(body.nodeCount(), 0.04 * test::cellSize);
      test::expectHoldsWhileContactToggles(
          body, 80, 0.02 * test::cellSize, 5, [&](int step) { return meeting(body, step, shake); },
          joinText(element, ", ", share), runs);
    }
  EXPECT_EQ(runs.states, 480);
  EXPECT_GT(runs.toggled, runs.states / 6);
  EXPECT_GT(runs.proven, 15);
}

TEST(SurfaceContactBounds, TheCertificateItselfHoldsAtEveryState) {
  for (const double share : {0.3, 3.0}) {
    Body body = twoBodies("tet4", share * stiffnessOfACell, 9);
    const NodeVectors shake = test::Random(12).nodeVectors(body.nodeCount(), 0.04 * test::cellSize);
    IncrementalNodalBound bound(body);
    for (int step = 0; step < 80; ++step) {
      const NodeVectors x = meeting(body, step, shake);
      const double lambda = DenseTangent(body, x).largest();
      const std::string what = joinText(share, ", step ", step);
      test::expectProves(bound, x, lambda, what);
      test::expectProvesTightened(bound, x, lambda, what);
    }
  }
}

TEST(SurfaceContactBounds, TogglingCostsNoProof) {
  test::expectTogglingCostsNoProof(twoBodies("hex8", 0.02 * stiffnessOfACell, 4),
                                   [](double by) { return Eigen::Vector3d(0, 0, -by); });
}

// Two equal cubes of one hexahedron, rigid against their contact of matching nodes: each pair of nodes is a spring of
// the penalty of both, and the highest mode of contact is that of masses M/8 on 2k between them, λ = 2 · 2k/(M/8).
TEST(SurfaceContactBounds, OfMatchingCubesInClosedForm) {
  StackOptions options;
  options.lower.element = "hex8";
  options.lower.size = options.upperSize = {0.01, 0.01, 0.01};
  Body body(generateStack(options), makeMaterial("linear", 1e-3, 0, 1000));
  const std::vector<std::int32_t> surface = surfaceNodes(body.mesh());
  SurfaceContact contact = surfaceContact(body.mesh(), surface, surface);
  constexpr double k = 100;
  contact.penalty.assign(surface.size(), k);
  contact.damping.assign(surface.size(), 0);
  DiscreteForces forces(body.nodeCount());
  forces.add(std::move(contact));
  body.setDiscreteForces(std::move(forces));
  NodeVectors x = body.mesh().X;
  for (const std::int32_t node : body.mesh().nodeSets.at("upper")) x(2, node) -= 1e-4;
  EXPECT_EQ(body.discreteForces()->contactState(x).touching, 8);
  const double mass = 1000 * 1e-6 / 8, expected = 4 * k / mass;
  const CriticalStep step = criticalStep(body, x, 2.0);
  const double h = stepOf(expected);
  EXPECT_NEAR(globalFrequency(body, x).lambda, expected, 1e-4 * expected);
  EXPECT_LE(step.safe, h * (1 + 1e-4));
  EXPECT_GE(step.safe, h * (1 - 1e-3));
  EXPECT_NEAR(step.optimistic, h, 1e-3 * h);
  EXPECT_GT(step.discreteShare, 0.9);
}

/// Two boxes with an edge towards each other, which cross; nodes touch faces as well.
Body crossedBodies(std::string_view element, double penalty, std::uint64_t seed) {
  StackOptions options;
  options.lower.element = element;
  options.lower.size = options.upperSize = {0.02, 0.02, 0.02};
  options.lower.cells = options.upperCells = {2, 2, 1};
  Mesh mesh = generateStack(options);
  const double half = 0.01 * std::sqrt(2.0);
  for (const std::string name : {"lower", "upper"}) {
    const bool lower = name == "lower";
    const Eigen::AngleAxisd tip(M_PI / 4, lower ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitY());
    const auto& nodes = mesh.nodeSets.at(name);
    const Eigen::Vector3d centre = mesh.X(Eigen::all, nodes).rowwise().mean();
    for (const std::int32_t node : nodes)
      mesh.X.col(node) = tip * (mesh.X.col(node) - centre) + Eigen::Vector3d(0, 0, lower ? -half : half + 2e-4);
  }
  Body body(std::move(mesh), makeMaterial("stvk", test::young, test::poisson, test::density), {{}, Lumping::rowSum, 1});
  test::Random random(seed);
  const std::vector<std::int32_t> surface = surfaceNodes(body.mesh());
  SurfaceContact contact = surfaceContact(body.mesh(), surface, surface, 0.35);
  contact.penalty.assign(surface.size(), penalty);
  contact.damping.assign(surface.size(), 1e-4 * penalty);
  for (SurfaceContact::Edge& edge : contact.edges) {
    edge.penalty = penalty * random.uniform(0.5, 1);
    edge.damping = 1e-4 * penalty * random.uniform(0, 1);
    edge.mass = std::exp(random.uniform(-0.7, 0.7));
  }
  DiscreteForces forces(body.nodeCount());
  forces.add(std::move(contact));
  if (random.index(2) == 0) forces.setDampingFactor(random.uniform(0, 3e3));
  body.setDiscreteForces(std::move(forces));
  return body;
}

/// The upper body slides along the edges, presses and leaves; both shake.
NodeVectors crossing(const Body& body, int step, const NodeVectors& shake) {
  const double at = 0.1 * step, edge = test::cellSize;
  NodeVectors x = body.mesh().X;
  for (const std::int32_t node : body.mesh().nodeSets.at("upper"))
    x.col(node) += Eigen::Vector3d(0.3 * edge * std::sin(0.7 * at), 0.4 * edge * std::sin(1.1 * at),
                                   0.06 * edge - 0.25 * edge * std::abs(std::sin(0.8 * at)));
  return x + std::sin(2.1 * at) * shake;
}

TEST(EdgeContactBounds, HoldAlongRunsWithTogglingContact) {
  test::ContactRuns runs;
  for (const char* element : {"tet4", "hex8"})
    for (const double share : {0.3, 3.0}) {
      Body body = crossedBodies(element, share * stiffnessOfACell, 7);
      const NodeVectors shake = test::Random(12).nodeVectors(body.nodeCount(), 0.03 * test::cellSize);
      const std::string what = joinText(element, ", ", share);
      for (int step = 0; step < 60; ++step) {
        const NodeVectors x = crossing(body, step, shake);
        const CriticalStep scratch = criticalStep(body, x, 2.0);
        test::expectHolds(scratch, DenseTangent(body, x).largest(), joinText(what, ", step ", step));
        runs.governed += scratch.discreteShare > 0.5;
      }
      test::expectHoldsWhileContactToggles(
          body, 60, 0.02 * test::cellSize, 5, [&](int step) { return crossing(body, step, shake); }, what, runs);
    }
  EXPECT_EQ(runs.states, 240);
  EXPECT_GT(runs.toggled, runs.states / 12);
  EXPECT_GT(runs.proven, 15);
  EXPECT_GT(runs.governed, 5);
}

TEST(EdgeContactBounds, TogglingCostsNoProof) {
  test::expectTogglingCostsNoProof(crossedBodies("hex8", 0.02 * stiffnessOfACell, 4),
                                   [](double by) { return Eigen::Vector3d(0.005, 0.005, -by); });
}

TEST(SurfaceContactBounds, SameBitsForAnyNumberOfThreads) {
  test::expectSameBitsForAnyThreads([](int threads) { return twoBodies("tet4", stiffnessOfACell, 5, threads, 6); },
                                    [shake = NodeVectors()](const Body& body, int step) mutable {
                                      if (step == 0)
                                        shake = test::Random(12).nodeVectors(body.nodeCount(), 0.02 * test::cellSize);
                                      return meeting(body, 2 * step, shake);
                                    });
}

}  // namespace
}  // namespace ringwatch
