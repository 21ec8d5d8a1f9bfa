// The nodal bound that moves with a body: proven at every state of random paths by dense eigenvalues and by its own
// statements, and what it costs where a body only turns or stretches evenly.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <ringwatch/base/error.h>
#include <ringwatch/monitor/incremental/moved_bound.h>
#include <tests/monitor/monitor_cases.h>

namespace ringwatch {
namespace {

using test::DenseTangent;
using test::Hold;
using test::Subdivision;

/// Leaves room for the rounding of dense eigenvalues.
constexpr double rounding = 1e-9;

class MovedBoundTest : public ::testing::TestWithParam<Subdivision> {};
INSTANTIATE_TEST_SUITE_P(Subdivisions, MovedBoundTest, ::testing::ValuesIn(test::allSubdivisions()),
                         [](const auto& test) { return test::testName(test.param.name); });

/// A turn about a skew axis, a stretch and back, and a shake of single nodes; `at` in [0, 1].
NodeVectors pathState(const NodeVectors& X, double at, const NodeVectors& shake) {
  const double stretch = at < 0.6 ? 1 + 0.5 * at : at < 0.8 ? 1.3 - 1.5 * (at - 0.6) : 1;
  const Eigen::AngleAxisd turn(2 * at, Eigen::Vector3d(1, 2, 3).normalized());
  return turn * (Eigen::Vector3d(stretch, 1 - 0.2 * at, 1).asDiagonal() * X) + std::sin(20 * at) * shake;
}

TEST_P(MovedBoundTest, HoldsAtEveryStateOfAPath) {
  for (const LawInfo& law : allLaws())
    for (const Hold hold : {Hold::nothing, Hold::face, Hold::components}) {
      Body body = test::boxBody(GetParam(), law.name);
      test::holdBody(body, hold);
      const NodeVectors& X = body.mesh().X;
      test::Random random(12);
      const NodeVectors shake = random.nodeVectors(X.cols(), 0.05 * test::cellSize);
      MovedBound bound(body);
      constexpr int steps = 40;
      std::int64_t visited = 0;
      for (int step = 0; step <= steps; ++step) {
        const NodeVectors x = pathState(X, static_cast<double>(step) / steps, shake);
        const DenseTangent dense(body, x);
        ASSERT_TRUE(dense.finite());
        const double lambda = dense.largest();
        const std::string what = joinText(law.name, ", ", test::holdName(hold), ", step ", step);
        StepEvaluation evaluation;
        const bool withForce = step % 4 > 1;
        ASSERT_GE(bound.update(x, withForce ? &evaluation : nullptr).value, lambda * (1 - rounding)) << what;
        if (withForce) {
          NodeVectors expected;
          Body::Workspace workspace;
          body.internalForce(x, expected, workspace);
          EXPECT_TRUE(evaluation.internalForce == expected) << what;
        }
        if (step > 0) {
          EXPECT_LE(bound.verify(x), rounding) << what;
        }
        visited += bound.statistics().visited;
        const double before = bound.bound();
        if (step % 7 == 6) {
          ASSERT_GE(bound.improve(x, 0, body.mesh().elementCount()).value, lambda * (1 - rounding)) << what;
          EXPECT_LE(bound.verify(x), rounding) << what;
          EXPECT_LE(bound.bound(), before * (1 + MovedBoundPolicy{}.mostGrowth)) << what;
        }
      }
      EXPECT_TRUE(visited > 0 || law.tangentIsConstant) << law.name;
    }
}

TEST_P(MovedBoundTest, TurnsWithABodyThatEvaluatesNothing) {
  for (const LawInfo& law : allLaws()) {
    if (!law.objective) continue;
    Body body = test::boxBody(GetParam(), law.name);
    const NodeVectors& X = body.mesh().X;
    MovedBound bound(body);
    const double atRest = bound.update(X).value;
    double highest = 0;
    for (int step = 1; step <= 50; ++step) {
      const Eigen::AngleAxisd turn(0.06 * step, Eigen::Vector3d(3, 1, 2).normalized());
      const NodeVectors x = turn * X;
      highest = std::max(highest, bound.update(x).value);
      EXPECT_EQ(bound.statistics().evaluated, 0) << law.name;
      EXPECT_LE(bound.verify(x), rounding) << law.name;
    }
    // What η and the balls take of the first room, and what is stored with 16 bits.
    const double room = (1 + MovedBoundPolicy{}.slack) * (1 + MovedBoundPolicy{}.slack);
    EXPECT_LE(highest, room * atRest) << law.name;
  }
}

TEST(MovedBound, FollowsAnEvenStretchOfStVenantKirchhoff) {
  BarOptions bar;
  bar.cells = {3, 2, 2};
  for (std::size_t k = 0; k < 3; ++k) bar.size[k] = 0.01 * bar.cells[k];
  bar.jitter = 0.2;
  Body body(generateBar(bar), makeMaterial("stvk", 1e6, 0.3, 1000));
  const NodeVectors& X = body.mesh().X;
  MovedBound bound(body);
  const double looseAtRest = bound.update(X).value / DenseTangent(body, X).largest();
  for (int step = 1; step <= 30; ++step) {
    const NodeVectors x = Eigen::Vector3d(1 + 0.01 * step, 1, 1).asDiagonal() * X;
    const double value = bound.update(x).value;
    EXPECT_EQ(bound.statistics().evaluated, 0);
    // The largest stretch and the stress count in all directions, along and across the pull.
    EXPECT_LE(value, 1.45 * looseAtRest * DenseTangent(body, x).largest()) << step;
  }
}

TEST(MovedBound, DoesNotDependOnThreads) {
  BarOptions bar;
  bar.cells = {12, 4, 4};
  for (std::size_t k = 0; k < 3; ++k) bar.size[k] = 0.01 * bar.cells[k];
  bar.jitter = 0.2;
  std::vector<double> expected;
  for (const int threads : {1, 2, 5}) {
    Body body(generateBar(bar), makeMaterial("neo-hookean", 1e6, 0.3, 1000), {{}, Lumping::rowSum, threads});
    const NodeVectors& X = body.mesh().X;
    test::Random random(5);
    const NodeVectors shake = random.nodeVectors(X.cols(), 0.0005);
    MovedBound bound(body);
    std::vector<double> values;
    for (int step = 0; step <= 20; ++step) {
      const NodeVectors x = pathState(X, 0.05 * step, shake);
      values.push_back(bound.update(x).value);
      values.push_back(bound.improve(x, 0, 200).value);
    }
    if (threads == 1) expected = values;
    EXPECT_EQ(values, expected) << threads;
  }
}

TEST(MovedBound, CertifiesAStepAsLongAsItIsSafe) {
  Body body = test::boxBody(test::allSubdivisions().front(), "stvk");
  const NodeVectors& X = body.mesh().X;
  const double sigma = 1.5 * DenseTangent(body, X).largest();
  MovedBound bound(body);
  bool stiffer = false;
  for (int step = 0; step <= 60; ++step) {
    const NodeVectors x = (1 + 0.01 * step) * X;
    const double lambda = DenseTangent(body, x).largest();
    const bool certified = bound.certify(x, sigma);
    if (lambda > sigma * (1 + rounding)) {
      stiffer = true;
      EXPECT_FALSE(certified) << step;
    } else if (lambda < 0.7 * sigma) {
      EXPECT_TRUE(certified) << step;
    }
  }
  EXPECT_TRUE(stiffer);
}

TEST(MovedBound, StartsAgainWithOtherMassesOrSupports) {
  Body body = test::boxBody(test::allSubdivisions().front(), "stvk");
  const NodeVectors& X = body.mesh().X;
  MovedBound bound(body);
  bound.update(X);
  test::holdBody(body, Hold::face);
  EXPECT_GE(bound.update(X).value, DenseTangent(body, X).largest() * (1 - rounding));
  EXPECT_GT(bound.statistics().evaluated, 0);
  for (int step = 1; step < 5; ++step) {
    const NodeVectors x = (1 + 0.02 * step) * X;
    EXPECT_GE(bound.update(x).value, DenseTangent(body, x).largest() * (1 - rounding));
    EXPECT_LE(bound.verify(x), rounding);
  }
}

TEST(MovedBound, SaysWhereAStateHasNoTangentAndGoesOnAfterIt) {
  Body body = test::boxBody(test::allSubdivisions().front(), "neo-hookean");
  const NodeVectors& X = body.mesh().X;
  MovedBound bound(body);
  bound.update(X);
  NodeVectors x = X;
  x(0, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(bound.update(x).value));
  EXPECT_FALSE(bound.certify(x, infinity));
  EXPECT_GE(bound.update(X).value, DenseTangent(body, X).largest() * (1 - rounding));
}

}  // namespace
}  // namespace ringwatch
