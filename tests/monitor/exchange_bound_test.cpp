// The bound by shared stiffness: true for every target and after every iteration, and tight where no weights are.
#include <gtest/gtest.h>

#include <ringwatch/base/error.h>
#include <ringwatch/monitor/bounds/exchange_bound.h>
#include <ringwatch/monitor/small/packed_lowest.h>
#include <tests/monitor/monitor_cases.h>

namespace ringwatch {
namespace {

using test::DenseTangent;
using test::Hold;
using test::Subdivision;

TEST(PackedJacobi, IsEigensOwnDecomposition) {
  test::Random random(21);
  for (const int n : {1, 2, 3, 12, 15, 24})
    for (int repeat = 0; repeat < 30; ++repeat) {
      std::vector<Eigen::MatrixXd> matrices;
      const std::size_t entries = n * n;
      AlignedVector<NativePack> A(entries), VT(entries);
      for (int lane = 0; lane < lanes; ++lane) {
        // Any, of low rank, already diagonal, zero.
        const int kind = random.index(4), rank = kind == 1 ? std::min(n, 2) : n;
        Eigen::MatrixXd B = Eigen::MatrixXd::NullaryExpr(n, rank, [&] { return random.uniform(-1, 1); });
        Eigen::MatrixXd M = kind == 0 ? Eigen::MatrixXd(B + B.transpose()) : Eigen::MatrixXd(B * B.transpose());
        if (kind == 2) M = Eigen::MatrixXd(M.diagonal().asDiagonal());
        if (kind == 3 && repeat % 3 == 0) M.setZero();
        matrices.push_back(M);
        for (int i = 0; i < n * n; ++i) A[i].set(lane, M(i / n, i % n));
      }
      const NativePack left = diagonalize<0>(A.data(), VT.data(), n, 1e-12, 30);
      for (int lane = 0; lane < lanes; ++lane) {
        const Eigen::MatrixXd& M = matrices[lane];
        Eigen::MatrixXd V(n, n);
        Eigen::VectorXd values(n);
        for (int i = 0; i < n; ++i) {
          values[i] = A[i * n + i][lane];
          for (int j = 0; j < n; ++j) V(j, i) = VT[i * n + j][lane];
        }
        const double size = 1 + M.norm();
        EXPECT_LE(left[lane], 1e-11 * size);
        EXPECT_LE((V.transpose() * V - Eigen::MatrixXd::Identity(n, n)).norm(), 1e-12) << n;
        EXPECT_LE((V * values.asDiagonal() * V.transpose() - M).norm(), 1e-11 * size) << n;
        std::sort(values.begin(), values.end());
        EXPECT_LE((values - Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(M).eigenvalues()).norm(), 1e-11 * size) << n;
      }
    }
}

TEST(PackedJacobi, SaysHowFarItGot) {
  constexpr int n = 12;
  test::Random random(22);
  AlignedVector<NativePack> A(n * n), VT(n * n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j <= i; ++j) A[i * n + j] = A[j * n + i] = NativePack(random.uniform(-1, 1));
  Eigen::MatrixXd M(n, n);
  for (int i = 0; i < n * n; ++i) M(i / n, i % n) = A[i][0];
  const double least = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(M).eigenvalues()[0];
  const double left = diagonalize<n>(A.data(), VT.data(), n, 0.0, 1)[0];
  EXPECT_GT(left, 1e-6);
  double found = A[0][0];
  for (int i = 1; i < n; ++i) found = std::min(found, A[i * n + i][0]);
  EXPECT_LE(std::abs(found - least), left);
}

// Theorem 13 (c): the bound is below the least eigenvalue, what is left is no lower than it was, and most is taken.
TEST(PackedLowest, BoundsTheLeastEigenvalueAndTakesMostOfWhatIsNegative) {
  test::Random random(23);
  for (const int n : {4, 12, 15, 18, 24, 30})
    for (const int negatives : {0, 1, 3, 6})
      for (int repeat = 0; repeat < 10; ++repeat) {
        if (negatives >= n) continue;
        AlignedVector<NativePack> A(n * n), M(n * n);
        std::vector<Eigen::MatrixXd> before;
        NativePack enough, step(1e-4);
        for (int lane = 0; lane < lanes; ++lane) {
          const Eigen::MatrixXd B = Eigen::MatrixXd::NullaryExpr(n, n, [&] { return random.uniform(-1, 1); });
          const Eigen::MatrixXd Q = B.householderQr().householderQ();
          Eigen::VectorXd values = Eigen::VectorXd::NullaryExpr(n, [&] { return random.uniform(0, 1); });
          for (int k = 0; k < negatives; ++k) values[k] = -random.uniform(1e-3, 3e-2);
          before.push_back(Q * values.asDiagonal() * Q.transpose());
          for (int i = 0; i < n * n; ++i) M[i].set(lane, before.back()(i / n, i % n));
          enough.set(lane, random.uniform(1, 5) * std::max(1e-3, -values.minCoeff()));
        }
        const LowestPart<NativePack> part = removeLowestPart<0>(A.data(), M.data(), n, enough, step);
        for (int lane = 0; lane < lanes; ++lane) {
          const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(before[lane]).eigenvalues();
          EXPECT_LE(part.least[lane], values[0] + 1e-13);
          Eigen::MatrixXd after(n, n);
          for (int i = 0; i < n * n; ++i) after(i / n, i % n) = M[i][lane];
          const Eigen::VectorXd left = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(after).eigenvalues();
          EXPECT_GE(left[0], values[0] - 1e-13);
          if (values[0] >= 0) {
            EXPECT_GE(part.least[lane], 0);
            EXPECT_EQ(part.square[lane], 0);
          } else {
            EXPECT_GE(part.least[lane], 1.3 * values[0]);
            EXPECT_NEAR(part.square[lane], values.cwiseMin(0).squaredNorm(), 0.9 * values.cwiseMin(0).squaredNorm());
            EXPECT_TRUE(negatives != 1 || left[0] >= 0.1 * values[0]);
          }
        }
      }
}

// Where the shift is not enough nothing is claimed, and nothing is taken from what is not a number.
TEST(PackedLowest, ClaimsNothingWithoutAProof) {
  constexpr int n = 12;
  AlignedVector<NativePack> A(n * n), M(n * n);
  for (int i = 0; i < n * n; ++i) M[i] = NativePack(i % (n + 1) ? 0.0 : i == 0 ? -1.0 : 1.0);
  M[1].set(1, std::nan(""));
  M[n].set(1, std::nan(""));
  const LowestPart<NativePack> part = removeLowestPart<n>(A.data(), M.data(), n, NativePack(0.5), NativePack(0.0));
  for (int lane = 0; lane < 2; ++lane) {
    EXPECT_EQ(part.least[lane], -std::numeric_limits<double>::infinity());
    EXPECT_EQ(part.square[lane], 0);
  }
}

TEST(ExchangeBound, HoldsForAnyTargetAfterAnyIteration) {
  int states = 0, tried = 0;
  for (const Subdivision& subdivision : test::allSubdivisions())
    for (const LawInfo& law : allLaws())
      for (const Hold hold : {Hold::nothing, Hold::face, Hold::components}) {
        Body body = test::boxBody(subdivision, law.name);
        test::holdBody(body, hold);
        for (const test::NamedState& state : test::deformedStates(body.mesh().X, 6)) {
          const DenseTangent dense(body, state.x);
          ++states;
          if (!dense.finite()) continue;
          ++tried;
          const double lambda = dense.largest();
          NodalBound weights(body);
          weights.evaluate(state.x, 2);
          for (const double share : {0.0, 0.7, 1.001, 2.0})
            for (const int iterations : {1, 4, 12}) {
              const ExchangeBound bound = exchangeUpperBound(body, state.x, weights, share * lambda, 0, iterations);
              EXPECT_GE(bound.upper.value, lambda * (1 - 1e-10))
                  << subdivision.name << ", " << law.name << ", " << test::holdName(hold) << ", " << state.name
                  << ", share " << share << ", " << iterations << " iterations";
              EXPECT_EQ(bound.iterations, iterations);
            }
        }
      }
  EXPECT_GE(4 * tried, 3 * states);
}

TEST(ExchangeBound, IsWithinOnePercentOnRegularGrids) {
  for (const Subdivision& subdivision : test::allSubdivisions())
    for (const double jitter : {0.0, 0.2}) {
      const Body body = test::boxBody(subdivision, "stvk", {3, 3, 3}, jitter);
      const NodeVectors& X = body.mesh().X;
      const double lambda = DenseTangent(body, X).largest();
      NodalBound weights(body);
      weights.evaluate(X, 12);
      const ExchangeBound bound = exchangeUpperBound(body, X, weights, 1.01 * lambda, 1.02 * lambda, 60);
      EXPECT_GE(bound.upper.value, lambda) << subdivision.name;
      EXPECT_LE(bound.upper.value, 1.02 * lambda) << subdivision.name << ", jitter " << jitter;
      EXPECT_LT(bound.iterations, 60) << subdivision.name;
    }
}

// Just below the truth the bound has nowhere to go but to it. Elements whose matrices were definite at first lose that
// on the way: they are seen again.
TEST(ExchangeBound, HoldsForTargetsBelowTheTruthAfterManyIterations) {
  for (const Subdivision& subdivision : test::allSubdivisions()) {
    const Body body = test::boxBody(subdivision, "stvk", {4, 2, 2}, 0.2);
    const NodeVectors& X = body.mesh().X;
    const double lambda = DenseTangent(body, X).largest();
    NodalBound weights(body);
    weights.evaluate(X, 2);
    for (const double share : {0.5, 0.9, 0.99}) {
      const ExchangeBound bound = exchangeUpperBound(body, X, weights, share * lambda, 0, 60);
      EXPECT_GE(bound.upper.value, lambda) << subdivision.name << ", " << share;
      if (share > 0.9) {
        EXPECT_LE(bound.upper.value, 1.1 * lambda) << subdivision.name;
      }
    }
  }
}

// Kept from state to state, whatever lies between two of them, with any target, however few iterations.
TEST(KeptExchangeBound, HoldsAtEveryStateItIsMovedTo) {
  for (const Subdivision& subdivision : test::allSubdivisions())
    for (const Hold hold : {Hold::nothing, Hold::components}) {
      Body body = test::boxBody(subdivision, "stvk");
      test::holdBody(body, hold);
      NodalBound weights(body);
      weights.evaluate(body.mesh().X, 2);
      KeptExchangeBound kept(body);
      test::Random random(31);
      for (const test::NamedState& state : test::deformedStates(body.mesh().X, 6))
        for (const int iterations : {1, 3}) {
          const double lambda = DenseTangent(body, state.x).largest(), sigma = random.uniform(0, 1.5) * lambda;
          const ExchangeBound bound = kept.evaluate(state.x, weights, sigma, 0, iterations);
          EXPECT_GE(bound.upper.value, lambda * (1 - 1e-10))
              << subdivision.name << ", " << test::holdName(hold) << ", " << state.name << ", " << iterations;
          EXPECT_EQ(bound.iterations, iterations);
        }
      // What is no longer held is seen.
      body.constraints() = Constraints(body.nodeCount());
      const double lambda = DenseTangent(body, body.mesh().X).largest();
      EXPECT_GE(kept.evaluate(body.mesh().X, weights, lambda, 0, 1).upper.value, lambda) << subdivision.name;
    }
}

TEST(KeptExchangeBound, FollowsWithTwoIterationsAState) {
  double worst = 0;
  for (const Subdivision& subdivision : test::allSubdivisions()) {
    const Body body = test::boxBody(subdivision, "stvk", {3, 3, 3}, 0);
    NodeVectors x = body.mesh().X;
    NodalBound weights(body);
    weights.evaluate(x, 12);
    KeptExchangeBound kept(body);
    for (int state = 0; state < 20; ++state) {
      const double lambda = DenseTangent(body, x).largest();
      const ExchangeBound bound = kept.evaluate(x, weights, 1.01 * lambda, 1.02 * lambda, state == 0 ? 60 : 2);
      EXPECT_GE(bound.upper.value, lambda) << subdivision.name << ", " << state;
      worst = std::max(worst, bound.upper.value / lambda);
      x.row(0) *= 1.002;
    }
  }
  EXPECT_LE(worst, 1.05);  // measured: 1.0245
}

TEST(ExchangeBound, StopsWhereItIsAccepted) {
  const Body body = test::boxBody(test::allSubdivisions()[0], "stvk", {3, 3, 3}, 0);
  const NodeVectors& X = body.mesh().X;
  const double lambda = DenseTangent(body, X).largest();
  NodalBound weights(body);
  weights.evaluate(X, 5);
  int before = 0;
  for (const double accept : {1.3, 1.1, 1.03}) {
    const ExchangeBound bound = exchangeUpperBound(body, X, weights, 1.01 * lambda, accept * lambda, 100);
    EXPECT_LE(bound.upper.value, accept * lambda);
    EXPECT_GT(bound.iterations, before);
    EXPECT_LE(bound.decompositions, bound.iterations * static_cast<std::int64_t>(body.mesh().elementCount()));
    before = bound.iterations;
  }
}

TEST(ExchangeBound, IsInfiniteWithoutATangent) {
  const Body body = test::boxBody(test::allSubdivisions()[0], "neo-hookean");
  const NodeVectors& X = body.mesh().X;
  NodalBound weights(body);
  weights.evaluate(X, 1);
  const NodeVectors inverted = Eigen::Vector3d(-0.5, 1, 1).asDiagonal() * X;
  EXPECT_TRUE(std::isinf(exchangeUpperBound(body, inverted, weights, 1e6, 0, 5).upper.value));
}

TEST(ExchangeBound, IsTheSameForAnyNumberOfThreads) {
  double one = 0;
  for (const int threads : {1, 2, 3}) {
    const Body body = test::boxBody(test::allSubdivisions()[0], "stvk", {4, 3, 3}, 0.1, 3, threads);
    NodalBound weights(body);
    const double value = weights.evaluate(body.mesh().X, 3).value;
    const double bound = exchangeUpperBound(body, body.mesh().X, weights, 0.8 * value, 0, 8).upper.value;
    if (threads == 1) one = bound;
    EXPECT_EQ(bound, one);
  }
}

}  // namespace
}  // namespace ringwatch
