// The nodal bound that moves with a body: proven at every state of random paths by dense eigenvalues and by its own
// statements, and what it costs where a body only turns or stretches evenly.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
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
        const NodeVectors x = test::pathState(X, static_cast<double>(step) / steps, 2, shake);
        const DenseTangent dense(body, x);
        ASSERT_TRUE(dense.finite());
        const double lambda = dense.largest();
        const std::string what = joinText(law.name, ", ", test::holdName(hold), ", step ", step);
        StepEvaluation evaluation;
        const bool withForce = step % 4 > 1;
        ASSERT_GE(bound.update(x, withForce ? &evaluation : nullptr).value, lambda * (1 - rounding)) << what;
        if (withForce) test::expectForce(body, x, evaluation, what);
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
      const NodeVectors x = turn.toRotationMatrix() * X;
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

/// Anchored under stress, and moved far from there with large balls: every term of the transport counts.
TEST_P(MovedBoundTest, HoldsFarFromAnAnchorUnderStress) {
  for (const char* law : {"stvk", "neo-hookean"}) {
    Body body = test::boxBody(GetParam(), law);
    const NodeVectors& X = body.mesh().X;
    test::Random random(4);
    const NodeVectors shake = random.nodeVectors(X.cols(), 0.1 * test::cellSize);
    MovedBound bound(body, {.slack = 0.6});
    for (int step = 0; step <= 30; ++step) {
      const double at = step / 30.0;
      const Eigen::Vector3d stretches = (1 - at) * Eigen::Vector3d(1.4, 1, 0.85) + at * Eigen::Vector3d(0.85, 1.5, 1.1);
      const NodeVectors x = stretches.asDiagonal() * X + at * std::sin(8 * at) * shake;
      ASSERT_GE(bound.update(x).value, DenseTangent(body, x).largest() * (1 - rounding)) << law << step;
      EXPECT_LE(bound.verify(x), rounding) << law << step;
    }
  }
}

/// By the 9×9 matrix of the form tr(G S(F) Gᵀ) - (1+η) tr(G S(A) Gᵀ T Tᵀ) of dF = G, row by row.
TEST(MovedMajorant, BoundsTheGrowthOfTheGeometricStiffness) {
  const Lame constants{6e5, 4e5};
  test::Random random(8);
  for (int trial = 0; trial < 2000; ++trial) {
    Matrix3<NativePack> A, F, T;
    Eigen::Matrix3d a, f, t;
    for (int i = 0; i < 9; ++i) {
      a(i / 3, i % 3) = (i % 4 == 0) + random.uniform(-0.4, 0.4);
      t(i / 3, i % 3) = (i % 4 == 0) + random.uniform(-0.4, 0.4);
    }
    f = t * a;
    for (int i = 0; i < 9; ++i) {
      A.m[i] = NativePack(a(i / 3, i % 3));
      T.m[i] = NativePack(t(i / 3, i % 3));
      F.m[i] = NativePack(f(i / 3, i % 3));
    }
    const double eta = random.uniform(0, 0.3);
    const auto stressOf = [&](const Eigen::Matrix3d& gradient) -> Eigen::Matrix3d {
      const Eigen::Matrix3d E = 0.5 * (gradient.transpose() * gradient - Eigen::Matrix3d::Identity());
      return constants.lambda * E.trace() * Eigen::Matrix3d::Identity() + 2 * constants.mu * E;
    };
    const Eigen::Matrix3d now = stressOf(f), before = stressOf(a), stretch = t * t.transpose();
    Eigen::Matrix<double, 9, 9> form;
    for (int i = 0; i < 9; ++i)
      for (int j = 0; j < 9; ++j)
        form(i, j) =
            (i / 3 == j / 3 ? now(i % 3, j % 3) : 0) - (1 + eta) * stretch(i / 3, j / 3) * before(i % 3, j % 3);
    const double exact = Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 9, 9>>(form).eigenvalues()[8];
    EXPECT_GE(geometricGrowth(constants, F, A, T, NativePack(eta), 0)[0], exact - 1e-6) << trial;
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
      const NodeVectors x = test::pathState(X, 0.05 * step, 2, shake);
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
