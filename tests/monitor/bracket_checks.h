#pragma once
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include <ringwatch/base/infinity.h>
#include <ringwatch/body/discrete_forces.h>
#include <ringwatch/monitor/bounds/exchange_bound.h>
#include <ringwatch/monitor/bounds/factored_certificate.h>
#include <ringwatch/monitor/bounds/global_frequency.h>
#include <ringwatch/monitor/critical_step.h>
#include <ringwatch/monitor/incremental/run_bracket.h>
#include <tests/monitor/monitor_cases.h>

/// Checks of both sides of the critical step against dense eigenvalues, for bodies with forces of any kind.
namespace ringwatch::test {

/// Leaves room for the rounding of dense eigenvalues.
inline constexpr double exact = 1e-9;

/// The critical step of a dense eigenvalue (rad²/s²) by a limit of 2, s.
inline double stepOf(double lambda) { return 2 / std::sqrt(lambda); }

/// Both sides of a bracket hold the critical step of lambda.
template <class Bracket>
void expectHolds(const Bracket& bracket, double lambda, const std::string& what) {
  EXPECT_LE(bracket.safe, stepOf(lambda) * (1 + exact)) << what;
  EXPECT_GE(bracket.optimistic, stepOf(lambda) * (1 - exact)) << what;
}
inline void expectHolds(RunBracket& bracket, const NodeVectors& x, double lambda, const std::string& what) {
  const auto& found = bracket.evaluate(x, 2.0, std::nullopt, nullptr);
  ASSERT_TRUE(found.has_value()) << what;
  expectHolds(*found, lambda, what);
}

/// Weights, the exchange bound, a factorisation and the global eigenvalue at x hold the dense one, `largest`. Returns
/// the exchange bound, rad²/s².
inline double expectProofsHold(const Body& body, const NodeVectors& x, double largest, const std::string& what) {
  NodalBound weights(body);
  EXPECT_GE(weights.evaluate(x, 8).value, largest * (1 - exact)) << what;
  const ExchangeBound exchange = exchangeUpperBound(body, x, weights, 1.01 * largest, 1.01 * largest, 40);
  EXPECT_GE(exchange.upper.value, largest * (1 - exact)) << what;
  FactoredCertificate factored(body, x);
  EXPECT_TRUE(factored.certifies(largest * (1 + 1e-7))) << what;
  EXPECT_FALSE(factored.certifies(largest * (1 - 1e-7))) << what;
  const GlobalFrequency global = globalFrequency(body, x);
  EXPECT_TRUE(global.converged) << what;
  EXPECT_NEAR(global.lambda, largest, 1e-8 * largest) << what;
  return exchange.upper.value;
}

/// A certificate that has come to x proves lambda and verifies.
inline void expectProves(IncrementalNodalBound& bound, const NodeVectors& x, double lambda, const std::string& what) {
  ASSERT_GE(bound.update(x).value, lambda * (1 - exact)) << what;
  EXPECT_LE(bound.verify(x), exact) << what;
}
/// It does after it was relaxed and tightened to 5 % of lambda too.
inline void expectProvesTightened(IncrementalNodalBound& bound, const NodeVectors& x, double lambda,
                                  const std::string& what) {
  bound.relaxBound(LowerBound{lambda}, 0.05);
  if (bound.tightenBound(x, LowerBound{lambda}, 0.05)) expectProves(bound, x, lambda, what);
}

/// A path that turns, strains and shakes single nodes.
inline NodeVectors turningPath(const NodeVectors& X, double at, const NodeVectors& shake) {
  const Eigen::AngleAxisd turn(0.2 * at, Eigen::Vector3d(0.3, 1, 0.2).normalized());
  const Eigen::Matrix3d F =
      turn.toRotationMatrix() * Eigen::Vector3d(1 + 0.1 * std::sin(at), 1 - 0.2 * std::sin(1.3 * at), 1).asDiagonal();
  return F * X + std::sin(2.1 * at) * shake;
}

/// Counts how often the number of touching nodes changes.
class ToggleCount {
 public:
  void see(const Body& body, const NodeVectors& x) {
    const std::int64_t now = body.discreteForces()->contactState(x).touching;
    changes += now != touching_;
    touching_ = now;
  }
  std::int64_t changes = 0;

 private:
  std::int64_t touching_ = -1;
};

/// What happened along runs with contact that comes and goes.
struct ContactRuns {
  std::int64_t states = 0, toggled = 0, proven = 0, governed = 0;
};
/// Follows stateAt(step) with a bracket and with proofs of one step: `ceiling` times the dense eigenvalue may be
/// proven, and what is proven verifies; an eigenvalue just too low is refused. At every third state contact counts
/// within `reach`, m.
template <class StateAt>
void expectHoldsWhileContactToggles(Body& body, int steps, double reach, double ceiling, StateAt stateAt,
                                    const std::string& of, ContactRuns& runs) {
  RunBracket bracket(body, 0.05, infinity);
  // One proof that is always refused would have the other wait for its turn.
  IncrementalNodalBound threshold(body), refused(body);
  ToggleCount toggles;
  for (int step = 0; step < steps; ++step) {
    const NodeVectors x = stateAt(step);
    body.discreteForces()->setReach(step % 3 == 0 ? reach : 0);
    const DenseTangent dense(body, x);
    ASSERT_TRUE(dense.finite());
    const double lambda = dense.largest();
    const std::string what = joinText(of, ", step ", step);
    expectHolds(bracket, x, lambda, what);
    EXPECT_FALSE(refused.certify(x, lambda * (1 - 1e-6))) << what;
    if (threshold.certify(x, ceiling * lambda)) {
      EXPECT_LE(threshold.verify(x), exact) << what;
      ++runs.proven;
    }
    toggles.see(body, x);
    ++runs.states;
  }
  runs.toggled += toggles.changes;
}

/// Contact that comes and goes within the reach costs no proof: after the first certificate no step is refused and none
/// is swept again. pressed(by) is how the upper nodes move where they are pressed on by a length, m.
template <class Press>
void expectTogglingCostsNoProof(Body body, const Press& pressed) {
  body.discreteForces()->setReach(0.06 * cellSize);
  body.discreteForces()->setDampingFactor(0);
  const double sigma = 1.3 * DenseTangent(body, body.mesh().X).largest();
  IncrementalNodalBound bound(body);
  ToggleCount toggles;
  for (int step = 0; step < 60; ++step) {
    NodeVectors x = body.mesh().X;
    for (const std::int32_t node : body.mesh().nodeSets.at("upper"))
      x.col(node) += pressed(0.03 * cellSize * (1 + std::sin(1.3 * step)));
    ASSERT_TRUE(bound.certify(x, sigma)) << step;
    if (step > 0) {
      EXPECT_EQ(bound.statistics().rebuilds + bound.statistics().refreshes, 0) << step;
    }
    toggles.see(body, x);
  }
  EXPECT_GT(toggles.changes, 15);
}

/// Brackets along stateAt(body, step) have the same bits for any number of threads of bodyOn(threads).
template <class BodyOn, class StateAt>
void expectSameBitsForAnyThreads(const BodyOn& bodyOn, StateAt stateAt) {
  std::vector<std::pair<double, double>> expected;
  for (const int threads : {1, 2, 4}) {
    Body body = bodyOn(threads);
    RunBracket bracket(body, 0.05, infinity);
    std::vector<std::pair<double, double>> sides;
    for (int step = 0; step < 12; ++step) {
      const auto& found = bracket.evaluate(stateAt(body, step), 2.0, std::nullopt, nullptr);
      ASSERT_TRUE(found.has_value());
      sides.emplace_back(found->safe, found->optimistic);
    }
    if (threads == 1) expected = sides;
    EXPECT_EQ(sides, expected) << threads;
  }
}

}  // namespace ringwatch::test
