// The block nodal bound: true for any weights, so also for those kept from another state.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/monitor/bounds/nodal_bound.h>
#include <ringwatch/monitor/bounds/nodal_weights.h>
#include <tests/monitor/monitor_cases.h>
#include <tests/support/random.h>

namespace ringwatch {
namespace {

using test::DenseTangent;
using test::Hold;
using test::Subdivision;
using Start = NodalBound::Start;

TEST(NodalBound, HoldsWithWeightsOfAnyOtherState) {
  for (const Subdivision& subdivision : test::allSubdivisions())
    for (const Hold hold : {Hold::nothing, Hold::face, Hold::components})
      for (const Start start : {Start::rows, Start::diagonal}) {
        Body body = test::boxBody(subdivision, "stvk");
        test::holdBody(body, hold);
        NodalBound bound(body);
        for (const std::uint64_t seed : {1u, 2u})
          for (const test::NamedState& state : test::deformedStates(body.mesh().X, seed))
            for (const int sweeps : {0, 1, 3}) {
              const double lambda = DenseTangent(body, state.x).largest();
              EXPECT_GE(bound.evaluate(state.x, sweeps, start).value, lambda * (1 - 1e-9))
                  << subdivision.name << ", " << test::holdName(hold) << ", " << state.name << ", " << sweeps
                  << " sweeps";
            }
      }
}

TEST(NodalBound, SweepsTightenIt) {
  for (const Subdivision& subdivision : test::allSubdivisions()) {
    const Body body = test::boxBody(subdivision, "linear", {3, 3, 3});
    const double lambda = DenseTangent(body, body.mesh().X).largest();
    double before = infinity;
    for (const int sweeps : {0, 1, 5, 20}) {
      NodalBound bound(body);
      const double value = bound.evaluate(body.mesh().X, sweeps).value;
      EXPECT_LE(value, before) << subdivision.name << ", " << sweeps;
      // A sweep evaluates only where it changes something.
      const std::int64_t elements = body.mesh().elementCount();
      EXPECT_GE(bound.evaluations(), elements) << subdivision.name;
      EXPECT_LE(bound.evaluations(), elements * (sweeps + 1)) << subdivision.name;
      before = value;
    }
    EXPECT_LE(before, 1.35 * lambda) << subdivision.name;
  }
}

TEST(NodalBound, IsTightOnRegularMeshesAfterTwelveSweeps) {
  // Of the critical step, on bars of all elements; what sweeps can reach depends on the weights that they start from.
  for (const Subdivision& subdivision : test::allSubdivisions())
    for (const double jitter : {0.0, 0.2}) {
      const Body body = test::boxBody(subdivision, "stvk", {6, 3, 3}, jitter);
      const double lambda = DenseTangent(body, body.mesh().X).largest();
      NodalBound bound(body);
      EXPECT_GE(std::sqrt(lambda / bound.evaluate(body.mesh().X, 1).value), 0.82) << subdivision.name;
      bound.reset();
      EXPECT_GE(std::sqrt(lambda / bound.evaluate(body.mesh().X, 12).value), 0.90) << subdivision.name;
    }
}

TEST(NodalBound, RoundsByTheNormOfTheInverseFactor) {
  test::Random random(1);
  for (int i = 0; i < 100; ++i) {
    CholeskyFactor<double> L;
    for (double& entry : L.m) entry = random.uniform(0.1, 1);
    Eigen::Matrix3d full;
    full << L.m[0], 0, 0, L.m[5], L.m[1], 0, L.m[4], L.m[3], L.m[2];
    double w[6];
    invertFactor(L, w);
    const double free[3] = {1, 1, 1}, held[3] = {1, 1, 0}, T = 3;
    const Eigen::Matrix3d inverse = full.inverse();
    EXPECT_GE(scaledRounding(L, w, T, free), T * inverse.squaredNorm() * (1 - 1e-13));
    EXPECT_GE(scaledRounding(L, w, T, held), T * inverse.topRows(2).squaredNorm() * (1 - 1e-13));
  }
}

TEST(NodalBound, IsTheLargestNodalValueOfASweep) {
  const Body body = test::boxBody(test::allSubdivisions()[0], "stvk");
  NodalBound bound(body);
  const double value = bound.evaluate(body.mesh().X, 0).value;
  double most = 0;
  for (std::int32_t i = 0; i < body.nodeCount(); ++i) most = std::max(most, bound.nodal()[i]);
  EXPECT_EQ(value, most);
}

TEST(NodalBound, StartsFromScratchAfterReset) {
  const Body body = test::boxBody(test::allSubdivisions()[0], "stvk");
  const NodeVectors& X = body.mesh().X;
  const NodeVectors pulled = Eigen::Vector3d(1.5, 1, 1).asDiagonal() * X;
  NodalBound bound(body), other(body);
  const double first = bound.evaluate(X, 3).value;
  other.evaluate(pulled, 3);
  EXPECT_NE(other.evaluate(X, 3).value, first);
  other.reset();
  EXPECT_EQ(other.evaluate(X, 3).value, first);
}

TEST(NodalBound, RecoversFromAStateWithoutTangent) {
  const Body body = test::boxBody(test::allSubdivisions()[0], "neo-hookean");
  const NodeVectors& X = body.mesh().X;
  const NodeVectors inverted = Eigen::Vector3d(-0.5, 1, 1).asDiagonal() * X;
  NodalBound bound(body), fresh(body);
  bound.evaluate(X, 3);
  EXPECT_TRUE(std::isnan(bound.evaluate(inverted, 3).value));
  EXPECT_EQ(bound.evaluate(X, 3).value, fresh.evaluate(X, 3).value);
}

}  // namespace
}  // namespace ringwatch
