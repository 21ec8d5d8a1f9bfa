// Springs, dashpots and contact in the bracket: both sides against dense eigenvalues, from scratch and along runs with
// contact that comes and goes, and a bar against a penalty spring in closed form.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include <ringwatch/monitor/bounds/reduced_ring.h>
#include <ringwatch/monitor/stability_monitor.h>
#include <tests/monitor/bracket_checks.h>
#include <tests/monitor/discrete_cases.h>

namespace ringwatch {
namespace {

using test::addForces;
using test::cellStiffness;
using test::DenseTangent;
using test::exact;
using test::Hold;
using test::stepOf;
using test::Subdivision;

class DiscreteBoundsTest : public ::testing::TestWithParam<Subdivision> {};
INSTANTIATE_TEST_SUITE_P(Subdivisions, DiscreteBoundsTest, ::testing::ValuesIn(test::allSubdivisions()),
                         [](const auto& test) { return test::testName(test.param.name); });

TEST_P(DiscreteBoundsTest, HoldFromScratch) {
  int brackets = 0, governed = 0;
  for (const LawInfo& law : allLaws())
    for (const Hold hold : {Hold::nothing, Hold::components})
      for (const double share : {0.3, 10.0}) {
        Body body = test::boxBody(GetParam(), law.name);
        test::holdBody(body, hold);
        addForces(body, share * cellStiffness, 40 + brackets);
        for (const test::NamedState& state : test::deformedStates(body.mesh().X, 3)) {
          const DenseTangent dense(body, state.x);
          if (!dense.finite()) continue;
          const Eigen::VectorXd lambda = dense.eigenvalues();
          const double largest = lambda[lambda.size() - 1], least = lambda[0];
          if (!(largest > 0)) continue;
          const std::string what = joinText(law.name, ", ", test::holdName(hold), ", ", share, ", ", state.name);
          const CriticalStep step = criticalStep(body, state.x, 2.0);
          test::expectHolds(step, largest, what);
          if (step.lowestRing < 0) {
            ASSERT_GE(step.lowestRing, least - exact * largest) << what;
          }
          ReducedRing ring(body);
          ASSERT_LE(ring.evaluate(state.x).highest, largest * (1 + exact)) << what;
          governed += step.discreteShare > 0.5;
          ++brackets;
        }
      }
  EXPECT_GT(brackets, 90);
  EXPECT_GT(governed, 10);
}

TEST_P(DiscreteBoundsTest, HoldWithExchangeAndFactorisation) {
  Body body = test::boxBody(GetParam(), "stvk", {3, 2, 2});
  test::holdBody(body, Hold::face);
  addForces(body, cellStiffness, 9);
  const NodeVectors x = test::strained(body.mesh().X, 5, 0.05);
  const double largest = DenseTangent(body, x).largest();
  EXPECT_LT(test::expectProofsHold(body, x, largest, ""), 1.2 * largest);
}

/// A body that bounces, turns and strains, so that contact of single nodes comes and goes from state to state.
NodeVectors pathState(const NodeVectors& X, int step, const NodeVectors& shake) {
  const double at = 0.1 * step, edge = test::cellSize;
  const Eigen::AngleAxisd turn(0.02 * step, Eigen::Vector3d(0.3, 1, 0.2).normalized());
  const Eigen::Vector3d fall(0.3 * edge * std::sin(0.7 * at), 0.2 * edge * std::cos(at),
                             0.5 * edge * std::abs(std::sin(0.4 * at)));
  const Eigen::Matrix3d F =
      turn.toRotationMatrix() * Eigen::Vector3d(1 + 0.1 * std::sin(at), 1 - 0.1 * std::sin(1.3 * at), 1).asDiagonal();
  return (F * X + std::sin(2.1 * at) * shake).colwise() + fall;
}

TEST_P(DiscreteBoundsTest, HoldAlongRunsWithTogglingContact) {
  test::ContactRuns runs;
  for (const LawInfo& law : allLaws())
    for (const Hold hold : {Hold::nothing, Hold::components})
      for (const double share : {0.3, 3.0}) {
        Body body = test::boxBody(GetParam(), law.name);
        test::holdBody(body, hold);
        addForces(body, share * cellStiffness, 70 + static_cast<std::uint64_t>(10 * share));
        const NodeVectors shake = test::Random(12).nodeVectors(body.nodeCount(), 0.06 * test::cellSize);
        test::expectHoldsWhileContactToggles(
            body, 40, 0.05 * test::cellSize, 1.3, [&](int step) { return pathState(body.mesh().X, step, shake); },
            joinText(law.name, ", ", test::holdName(hold), ", ", share), runs);
      }
  EXPECT_EQ(runs.states, 40 * 4 * static_cast<std::int64_t>(allLaws().size()));
  EXPECT_GT(runs.toggled, runs.states / 6);
}

TEST_P(DiscreteBoundsTest, TheCertificateItselfHoldsAtEveryState) {
  std::int64_t states = 0;
  for (const double share : {0.3, 3.0}) {
    Body body = test::boxBody(GetParam(), "stvk");
    addForces(body, share * cellStiffness, 21);
    const NodeVectors& X = body.mesh().X;
    const NodeVectors shake = test::Random(12).nodeVectors(X.cols(), 0.06 * test::cellSize);
    for (const double budget : {infinity, 0.0}) {
      WorkAccount account(body, budget);
      IncrementalNodalBound bound(body, {}, &account);
      for (int step = 0; step < 80; ++step) {
        account.earn();
        const NodeVectors x = pathState(X, step, shake);
        const double lambda = DenseTangent(body, x).largest();
        const std::string what = joinText(share, ", ", budget, ", step ", step);
        test::expectProves(bound, x, lambda, what);
        test::expectProvesTightened(bound, x, lambda, what);
        ++states;
      }
    }
  }
  EXPECT_EQ(states, 320);
}

/// A bar of thin slices of hex8, held but along x, whose highest mode moves whole sections alike: a chain of masses m
/// and springs d with half masses at its ends. With a spring k at one end its highest eigenvalue is that of a mode that
/// decays into the bar, u_i = (-q)^i: (2d/m)(1 + √(1 + (k/d)²)).
struct Bar {
  static constexpr int slices = 40;
  double thickness = 1e-3, side = 1e-2, E = 30e3, rho = 1000;
  Body body = make();
  double d = E * side * side / 4 / thickness, m = rho * side * side * thickness / 4;  // of a node

  Body make() const {
    Body made(test::gridMesh("hex8", {slices, 1, 1}, {slices * thickness, side, side}),
              makeMaterial("linear", E, 0, rho));
    for (std::int32_t i = 0; i < made.nodeCount(); ++i) {
      made.constraints().fix(i, 1);
      made.constraints().fix(i, 2);
    }
    return made;
  }
  std::vector<std::int32_t> end() const {
    std::vector<std::int32_t> nodes;
    for (std::int32_t i = 0; i < body.nodeCount(); ++i)
      if (body.mesh().X(0, i) > (slices - 0.5) * thickness) nodes.push_back(i);
    return nodes;
  }
  double expected(double k) const { return 2 * d / m * (1 + std::sqrt(1 + k / d * (k / d))); }
};

TEST(DiscreteForcesInClosedForm, BarAgainstAPenaltySpring) {
  for (const double ratio : {0.5, 1.0, 3.0, 10.0})
    for (const bool contact : {false, true}) {
      Bar bar;
      const double k = ratio * bar.d;
      DiscreteForces forces(bar.body.nodeCount());
      const std::vector<std::int32_t> end = bar.end();
      ASSERT_EQ(end.size(), 4U);
      if (contact) {
        // A wall that the end has run into by a hundredth of a slice, with the penalty in part as damping.
        forces.add(planeObstacle({(Bar::slices - 0.01) * bar.thickness, 0, 0}, {-1, 0, 0}));
        forces.add(PenaltyContact{.obstacle = 0,
                                  .nodes = end,
                                  .penalty = std::vector<double>(4, 0.75 * k),
                                  .damping = std::vector<double>(4, 0.25 * k / 3e3)});
        forces.setDampingFactor(3e3);
      } else {
        std::vector<Spring> springs;
        for (const std::int32_t node : end)
          springs.push_back({.node = node, .direction = Eigen::Vector3d(1, 0, 0), .stiffness = k});
        forces.add(springs);
      }
      bar.body.setDiscreteForces(std::move(forces));
      const NodeVectors& X = bar.body.mesh().X;
      const GlobalFrequency global = globalFrequency(bar.body, X);
      ASSERT_TRUE(global.converged);
      EXPECT_NEAR(global.lambda, bar.expected(k), 1e-8 * bar.expected(k)) << ratio << contact;
      const CriticalStep step = criticalStep(bar.body, X, 2.0);
      const double h = stepOf(bar.expected(k));
      test::expectHolds(step, bar.expected(k), "");
      EXPECT_GE(step.safe, 0.94 * h);
      EXPECT_LE(step.optimistic, 1.01 * h);
      // A quarter of the energy at the end, of one half mass, grows to nearly all of it.
      if (ratio >= 3) {
        EXPECT_GT(step.discreteShare, 0.5);
      }
      if (ratio <= 0.5) {
        EXPECT_LT(step.discreteShare, 0.5);
      }
    }
}

TEST(DiscreteForcesInClosedForm, LocalModesHoldTheOtherEndsOfSprings) {
  // Two far corners joined by a spring that governs: the region has one of them, and the bound must not exceed.
  Body body = test::boxBody(test::allSubdivisions()[0], "stvk", {4, 1, 1});
  DiscreteForces forces(body.nodeCount());
  const std::int32_t last = body.nodeCount() - 1;
  const double length = (body.mesh().X.col(last) - body.mesh().X.col(0)).norm();
  forces.add(std::vector<Spring>{{.node = 0, .other = last, .length = length, .stiffness = 20 * cellStiffness}});
  body.setDiscreteForces(std::move(forces));
  const NodeVectors& X = body.mesh().X;
  const double lambda = DenseTangent(body, X).largest();
  RunBracket bracket(body, 0.05, infinity);
  for (int step = 0; step < 5; ++step) {
    const NodeVectors x = Eigen::Vector3d(1 + 0.001 * step, 1, 1).asDiagonal() * X;
    test::expectHolds(bracket, x, DenseTangent(body, x).largest(), "");
  }
  EXPECT_GT(lambda, 0);
}

// A body that falls, whose highest mode is elsewhere until its lower nodes touch: at the first state at which they do
// the step is known to be violated, and contact named, though the tracked mode was another one and no search was due.
TEST(DiscreteForces, ContactThatBeginsIsNamedAtOnce) {
  constexpr int touches = 7;
  for (const Subdivision& subdivision : test::allSubdivisions()) {
    Body body = test::boxBody(subdivision, "stvk", {6, 2, 2});
    const NodeVectors& X = body.mesh().X;
    DiscreteForces forces(body.nodeCount());
    const double fall = 0.1 * test::cellSize, low = X.row(2).minCoeff();
    PenaltyContact contact;
    contact.obstacle = forces.add(planeObstacle({0, 0, low - (touches - 0.5) * fall}, {0, 0, 1}));
    contact.nodes.resize(body.nodeCount());
    std::iota(contact.nodes.begin(), contact.nodes.end(), 0);
    contact.penalty.assign(body.nodeCount(), 30 * cellStiffness);
    contact.damping.assign(body.nodeCount(), 0);
    forces.add(std::move(contact));
    body.setDiscreteForces(std::move(forces));
    const double h = 0.8 * stepOf(DenseTangent(body, X).largest());  // certified along a run
    const NodeVectors v = NodeVectors::Zero(3, X.cols());
    for (const double budget : {infinity, 0.1}) {
      StabilityMonitor monitor(body, {.budget = budget, .workInAdvance = 0});
      for (int step = 0; step <= touches; ++step) {
        const NodeVectors x = X.colwise() - Eigen::Vector3d(0, 0, step * fall);
        const MonitorReport& report = monitor.observe(step, step, x, v, h);
        if (step < touches) {
          EXPECT_EQ(report.verdict, Verdict::certified) << subdivision.name << step;
          continue;
        }
        const double critical = stepOf(DenseTangent(body, x).largest());
        ASSERT_LT(critical, 0.9 * h) << subdivision.name;
        EXPECT_EQ(report.verdict, Verdict::violated) << subdivision.name;
        ASSERT_TRUE(report.bracket.has_value());
        EXPECT_GE(report.bracket->optimistic, critical * (1 - exact)) << subdivision.name;
        EXPECT_LE(report.bracket->optimistic, (budget == infinity ? 1.1 : 1.3) * critical) << subdivision.name;
        ASSERT_EQ(report.newEvents.size(), 1U) << subdivision.name;
        EXPECT_EQ(report.newEvents[0].kind, EventKind::violated);
        EXPECT_GT(report.newEvents[0].discreteShare, 0.5) << subdivision.name;
      }
    }
  }
}

TEST(DiscreteForces, SameBitsForAnyNumberOfThreads) {
  test::expectSameBitsForAnyThreads(
      [](int threads) {
        Body body = test::boxBody(test::allSubdivisions()[0], "stvk", {6, 4, 4}, 0.2, 3, threads);
        addForces(body, cellStiffness, 5);
        return body;
      },
      [shake = NodeVectors()](const Body& body, int step) mutable {
        if (step == 0) shake = test::Random(12).nodeVectors(body.nodeCount(), 0.06 * test::cellSize);
        return pathState(body.mesh().X, step, shake);
      });
}

}  // namespace
}  // namespace ringwatch
