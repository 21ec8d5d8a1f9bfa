// Lanczos' iteration against dense decompositions, from products and by shift and invert.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/monitor/small/symmetric_eigenpairs.h>
#include <tests/support/random.h>

namespace ringwatch {
namespace {

constexpr Eigen::Index size = 60;

/// Symmetric, eigenvalues of both signs.
Eigen::MatrixXd indefinite() {
  test::Random random(4);
  const Eigen::MatrixXd A = Eigen::MatrixXd::NullaryExpr(size, size, [&] { return random.uniform(-1, 1); });
  return (A + A.transpose()) / 10;
}
Eigen::VectorXd denseEigenvalues(const Eigen::MatrixXd& A) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(A, Eigen::EigenvaluesOnly).eigenvalues();
}

TEST(SymmetricEigenpairs, FindsTheHighestFromProducts) {
  const Eigen::MatrixXd A = indefinite();
  const auto product = [&](const double* in, double* out) {
    Eigen::VectorXd::Map(out, size) = A * Eigen::VectorXd::Map(in, size);
  };
  const SymmetricEigenpairs found = highestEigenpairs(size, product, {.wanted = 3, .basis = 20});
  ASSERT_TRUE(found.converged);
  const Eigen::VectorXd exact = denseEigenvalues(A).tail(3);
  EXPECT_LE((found.values - exact).norm(), 1e-13 * exact.norm());
  EXPECT_LE((A * found.vectors - found.vectors * found.values.asDiagonal()).norm(), 1e-9);
}

TEST(SymmetricEigenpairs, FindsTheNearestToAShiftAndCountsThoseBelow) {
  const Eigen::MatrixXd A = indefinite();
  const Eigen::VectorXd exact = denseEigenvalues(A);
  for (const double shift : {-10.0, -0.3, 0.01, 0.4, 10.0}) {
    const SymmetricEigenpairs found = nearestEigenpairs(A.sparseView(), shift, {.wanted = 4, .basis = 24});
    ASSERT_TRUE(found.converged) << shift;
    EXPECT_EQ(found.below, (exact.array() < shift).count()) << shift;
    EXPECT_TRUE(std::is_sorted(found.values.begin(), found.values.end()));
    Eigen::VectorXd distance = (exact.array() - shift).abs();
    std::sort(distance.begin(), distance.end());
    EXPECT_NEAR((found.values.array() - shift).abs().maxCoeff(), distance[3], 1e-12) << shift;
    EXPECT_LE((A * found.vectors - found.vectors * found.values.asDiagonal()).norm(), 1e-8) << shift;
  }
}

TEST(SymmetricEigenpairs, SaysThatItDoesNotConvergeOnWhatIsNotANumber) {
  const auto product = [](const double*, double* out) { Eigen::VectorXd::Map(out, size).setConstant(NAN); };
  EXPECT_FALSE(highestEigenpairs(size, product, {}).converged);
}

}  // namespace
}  // namespace ringwatch
