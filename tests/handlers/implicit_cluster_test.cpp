// The matrix of an implicit cluster against assembled tangents, kept current along motions, and what its solvers leave.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/handlers/imex/cluster_matrix.h>
#include <ringwatch/handlers/imex/implicit_cluster.h>
#include <tests/handlers/handler_cases.h>

namespace ringwatch {
namespace {

Body boxOf(std::string_view element, std::string_view law, std::array<int, 3> cells, double size = 0.1,
           double poisson = test::poisson) {
  return Body(test::gridMesh(element, cells, {size, size, size}),
              makeMaterial(law, test::young, poisson, test::density), {{}, Lumping::rowSum, 1});
}

using test::everyElement;

ClusterOptions optionsOf(ClusterSolver solver, double tolerance = 1e-10) {
  ClusterOptions options;
  options.solver = solver;
  options.tolerance = tolerance;
  options.iterations = 2000;
  return options;
}

/// w such that w λ is some ten for elements of a hundredth of a metre.
double wOf(const Body& body, const Eigen::MatrixXd& K) { return 20 / test::denseHighest(body, K, body.lumpedMass()); }

Eigen::MatrixXd massOf(const Body& body) {
  Eigen::MatrixXd M = Eigen::MatrixXd::Zero(3 * body.nodeCount(), 3 * body.nodeCount());
  for (Eigen::Index d = 0; d < M.rows(); ++d) M(d, d) = body.lumpedMass()[d / 3];
  return M;
}

Eigen::Matrix3d turnBy(double angle) {
  return Eigen::AngleAxisd(angle, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
}

// At rest and turned as a whole, for every element and law, in packs that are not full.
TEST(ImplicitCluster, HasTheTurnedTangentOfAllElements) {
  for (const ElementInfo& element : allElements())
    for (const LawInfo& law : allLaws()) {
      Body body = boxOf(element.name, law.name, {2, 1, 1});
      const Eigen::MatrixXd K(body.assembleTangent(body.mesh().X));
      const double w = wOf(body, K);
      const Eigen::MatrixXd M = massOf(body), A = M + w * K;
      for (const ClusterSolver solver : {ClusterSolver::cholesky, ClusterSolver::conjugateGradients}) {
        ImplicitCluster cluster(body, everyElement(body), w, body.mesh().X, optionsOf(solver));
        EXPECT_LE((cluster.matrix() - A).norm(), 1e-12 * A.norm()) << element.name << " " << law.name;
        const bool objective = law.objective;
        const Eigen::Matrix3d Q = objective ? turnBy(2) : Eigen::Matrix3d::Identity();
        Eigen::MatrixXd turn = Eigen::MatrixXd::Zero(A.rows(), A.rows());
        for (Eigen::Index i = 0; i < A.rows(); i += 3) turn.block<3, 3>(i, i) = Q;
        ASSERT_TRUE(cluster.follow(turnBy(2) * body.mesh().X));
        EXPECT_LE((cluster.matrix() - turn * A * turn.transpose()).norm(), 1e-12 * A.norm())
            << element.name << " " << law.name;
      }
    }
}

// Fixed nodes keep the world's frame, so that elements turn one by one.
TEST(ImplicitCluster, IsTheSameAfterManyPartialChanges) {
  for (const char* law : {"corotational", "stvk"}) {
    Body body = boxOf("tet4", law, {5, 5, 5});
    for (const std::int32_t n : body.mesh().nodeSets.at("x-min")) body.constraints().fix(n);
    const NodeVectors& X = body.mesh().X;
    const double w = 1e-6;
    ImplicitCluster cluster(body, everyElement(body), w, X, optionsOf(ClusterSolver::conjugateGradients));
    // Twisted to and fro about x: the held end hardly turns.
    const auto twisted = [&](double angle) {
      NodeVectors x = X;
      for (Eigen::Index i = 0; i < x.cols(); ++i)
        x.col(i) = Eigen::AngleAxisd(angle * X(0, i) / 0.1, Eigen::Vector3d::UnitX()) * Eigen::Vector3d(X.col(i));
      return x;
    };
    const Eigen::MatrixXd M = massOf(body);
    double largest = 0;
    for (int i = 1; i <= 200; ++i) {
      const NodeVectors x = twisted(1.5 * std::sin(0.05 * i));
      ASSERT_TRUE(cluster.follow(x));
      if (i % 20 != 0) continue;
      const Eigen::MatrixXd fresh =
          ImplicitCluster(body, everyElement(body), w, x, optionsOf(ClusterSolver::cholesky)).matrix();
      const double off = (cluster.matrix() - fresh).norm() / (fresh - M).norm();
      EXPECT_LE(off, 0.25) << law << " " << i;  // some 0.2 rad, and what it does to the largest blocks
      largest = std::max(largest, off);
    }
    EXPECT_GT(largest, 1e-6);
    // A turn of everything leaves nothing of what has been added and taken away.
    const NodeVectors far = turnBy(1) * X;
    ASSERT_TRUE(cluster.follow(far));
    const Eigen::MatrixXd fresh =
        ImplicitCluster(body, everyElement(body), w, far, optionsOf(ClusterSolver::cholesky)).matrix();
    EXPECT_LE((cluster.matrix() - fresh).norm(), 1e-12 * fresh.norm()) << law;
  }
}

TEST(ImplicitCluster, SeesPositionsThatAreNotNumbersAtOnce) {
  Body body = boxOf("tet4", "corotational", {5, 5, 5});
  body.constraints().fix(0);
  for (const ClusterSolver solver : {ClusterSolver::cholesky, ClusterSolver::conjugateGradients})
    for (int still = 0; still < 6; ++still) {
      ImplicitCluster cluster(body, everyElement(body), 1e-6, body.mesh().X, optionsOf(solver));
      NodeVectors x = body.mesh().X;
      for (int i = 0; i < still; ++i) ASSERT_TRUE(cluster.follow(x));
      const Eigen::MatrixXd before = cluster.matrix();
      x(1, 77) = std::numeric_limits<double>::quiet_NaN();
      EXPECT_FALSE(cluster.follow(x));
      EXPECT_EQ(cluster.matrix(), before);
    }
}

struct SolveCase {
  double tolerance;  // single precision from 1e-5
  double size;       // m: nodal masses from 1e-19 kg
  int held;          // components of one node
};
class ImplicitClusterSolve : public ::testing::TestWithParam<SolveCase> {};
INSTANTIATE_TEST_SUITE_P(All, ImplicitClusterSolve,
                         ::testing::Values(SolveCase{1e-2, 0.1, 0}, SolveCase{1e-3, 0.1, 1}, SolveCase{1e-5, 0.1, 3},
                                           SolveCase{1e-4, 1e-6, 0}, SolveCase{1e-5, 100, 2}, SolveCase{1e-9, 0.1, 1},
                                           SolveCase{1e-12, 1e-6, 3}),
                         [](const auto& test) {
                           return "to_" + test::testName(test.param.tolerance) + "_size_" +
                                  test::testName(test.param.size) + "_held_" + std::to_string(test.param.held);
                         });

TEST_P(ImplicitClusterSolve, LeavesTheResidualThatIsAllowedAndNoMomentum) {
  const SolveCase c = GetParam();
  Body body = boxOf("tet4", "corotational", {5, 4, 4}, c.size);
  for (int k = 0; k < c.held; ++k) body.constraints().fix(17, k);
  const NodeVectors& X = body.mesh().X;
  const Eigen::MatrixXd K(body.assembleTangent(X));
  const double w = wOf(body, K);
  ImplicitCluster cluster(body, everyElement(body), w, X, optionsOf(ClusterSolver::conjugateGradients, c.tolerance));
  const Eigen::MatrixXd A = cluster.matrix();
  const Eigen::VectorXd m = massOf(body).diagonal();
  const auto norm = [&](const Eigen::VectorXd& r) {  // the preconditioner's
    double sum = 0;
    for (Eigen::Index i = 0; i < r.size(); i += 3) {
      Eigen::Matrix3d D = A.block<3, 3>(i, i);
      Eigen::Vector3d part = r.segment<3>(i);
      for (int k = 0; k < 3; ++k)
        if (body.constraints().isConstrained(i / 3, k)) {
          D.row(k).setZero();
          D.col(k).setZero();
          D(k, k) = 1;
          part[k] = 0;
        }
      sum += part.dot(D.inverse() * part);
    }
    return std::sqrt(sum);
  };
  test::Random random(5);
  const NodeVectors a0 = random.nodeVectors(X.cols(), 3), change = random.nodeVectors(X.cols(), 0.2),
                    v = random.nodeVectors(X.cols(), 1e-3);
  const double rate = 40;
  for (int step = 0; step < 4; ++step) {  // from nothing, from the last solution, and extrapolated
    NodeVectors a = a0 + step * change;
    for (int k = 0; k < c.held; ++k) a(k, 17) = 0;
    const Eigen::VectorXd before = (a + rate * v).reshaped();
    ASSERT_TRUE(cluster.solve(a, v, rate));
    const Eigen::VectorXd u = (a + rate * v).reshaped(), right = m.cwiseProduct(before);
    // The translation that mends momentum may add as much as the tolerance again.
    EXPECT_LE(norm(A * u - right), 2 * c.tolerance * norm(right)) << step;
    for (int k = c.held; k < 3; ++k) {
      double sum = 0, most = 0;
      for (Eigen::Index d = k; d < u.size(); d += 3) {
        sum += m[d] * (u[d] - before[d]);
        most += m[d] * std::abs(before[d]);
      }
      EXPECT_LE(std::abs(sum), 1e-13 * most) << step << " " << k;
    }
  }
}

// Conjugate gradients solve what strains the cluster: how fast it moves, and falls, is nothing to them.
TEST(ImplicitCluster, SolvesAFastBodyAsWellAsOneAtRest) {
  const Body body = boxOf("tet4", "corotational", {5, 4, 4}, 0.1);
  const NodeVectors& X = body.mesh().X;
  const double w = wOf(body, Eigen::MatrixXd(body.assembleTangent(X))), rate = 40;
  test::Random random(6);
  const NodeVectors a0 = random.nodeVectors(X.cols(), 3), v0 = random.nodeVectors(X.cols(), 1e-3);
  const auto solved = [&](double speed, ClusterSolver solver) {
    ImplicitCluster cluster(body, everyElement(body), w, X, optionsOf(solver, 1e-3));
    NodeVectors a = a0, v = v0;
    a.row(2).array() -= 10;
    v.row(2).array() -= speed;
    EXPECT_TRUE(cluster.solve(a, v, rate));
    return a;
  };
  const NodeVectors exact = solved(0, ClusterSolver::cholesky);
  for (const double speed : {0.0, 1e3}) {
    const NodeVectors error = solved(speed, ClusterSolver::conjugateGradients) - exact;
    EXPECT_LE(error.norm(), 3e-3 * a0.norm()) << speed;
  }
}

// Why K̂ needs no stiffening for the corotational law: see cluster_matrix.cpp.
TEST(ImplicitCluster, CorotationalTangentsDoNotExceedThatAtRest) {
  test::Random random(8);
  for (const double poisson : {0.0, 0.3, 0.45, 0.49}) {
    const Corotational law{makeMaterial("corotational", test::young, poisson, test::density).restModuli()};
    const double highest = 3 * law.constants.lambda + 2 * law.constants.mu;
    int tried = 0;
    for (int trial = 0; trial < 400; ++trial) {
      Eigen::Vector3d stretch;
      for (int i = 0; i < 3; ++i) stretch[i] = random.uniform(0.3, 2.5);
      std::sort(stretch.begin(), stretch.end());
      if (3 * (stretch[0] + stretch[1]) < 2 * (stretch.sum() - 3)) continue;
      ++tried;
      const Eigen::Matrix3d F = turnBy(random.uniform(0, 3)) * stretch.asDiagonal() * turnBy(random.uniform(0, 3));
      Matrix3<double> f;
      for (int i = 0; i < 9; ++i) f(i / 3, i % 3) = F(i / 3, i % 3);
      const auto linearization = law.linearize(f);
      Eigen::Matrix<double, 9, 9> C;
      for (int j = 0; j < 9; ++j) {
        Matrix3<double> dF = Matrix3<double>::zero();
        dF.m[j] = 1;
        const Matrix3<double> dP = linearization(dF);
        for (int i = 0; i < 9; ++i) C(i, j) = dP.m[i];
      }
      EXPECT_LE(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(Eigen::MatrixXd(C)).eigenvalues()[8],
                (1 + 1e-9) * highest);
    }
    EXPECT_GE(tried, 200);
  }
}

}  // namespace
}  // namespace ringwatch
