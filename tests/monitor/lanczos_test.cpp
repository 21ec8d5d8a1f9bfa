// The Lanczos iteration against dense eigenvalues, and the residuals of its Ritz vectors.
#include <gtest/gtest.h>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/base/random.h>
#include <ringwatch/monitor/small/lanczos.h>

namespace ringwatch {
namespace {

constexpr int dimension = 30;

Eigen::MatrixXd randomSymmetric(std::uint64_t seed) {
  Eigen::MatrixXd A(dimension, dimension);
  for (Eigen::Index i = 0; i < A.size(); ++i) A.data()[i] = randomEntry(seed, static_cast<std::uint64_t>(i));
  return 0.5 * (A + A.transpose());
}

/// A unit vector, as a matrix of any shape with `dimension` entries.
Eigen::MatrixXd randomUnit(std::uint64_t seed, Eigen::Index rows) {
  Eigen::MatrixXd v(rows, dimension / rows);
  for (Eigen::Index i = 0; i < v.size(); ++i) v.data()[i] = randomEntry(seed, static_cast<std::uint64_t>(i));
  return v / v.norm();
}

/// `steps` of the iteration.
Lanczos<Eigen::MatrixXd> iterated(const Eigen::MatrixXd& A, const Eigen::MatrixXd& start, int steps) {
  Lanczos<Eigen::MatrixXd> lanczos;
  lanczos.begin(start);
  Eigen::MatrixXd product(start.rows(), start.cols());
  while (true) {
    product.reshaped() = A * lanczos.current().reshaped();
    lanczos.advance(product);
    if (lanczos.matrix().size() == steps) return lanczos;
    lanczos.extend(product);
  }
}

TEST(Lanczos, HasAllEigenvaluesAfterAsManySteps) {
  const Eigen::MatrixXd A = randomSymmetric(1);
  const Eigen::VectorXd exact = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(A).eigenvalues();
  const LanczosMatrix T = iterated(A, randomUnit(2, dimension), dimension).matrix();
  EXPECT_LE((Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(T.dense()).eigenvalues() - exact).norm(), 1e-13 * A.norm());
  EXPECT_LE(T.beta.back(), 1e-13 * A.norm()) << "there is no further vector";
}

TEST(Lanczos, RitzVectorsLeaveTheResidualThatTheMatrixTells) {
  const Eigen::MatrixXd A = randomSymmetric(3);
  for (const Eigen::Index rows : {1, 3, dimension}) {
    const auto lanczos = iterated(A, randomUnit(4, rows), 8);
    const LanczosMatrix& T = lanczos.matrix();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> ritz(T.dense());
    for (Eigen::Index k = 0; k < T.size(); ++k) {
      const Eigen::VectorXd u = lanczos.combine(ritz.eigenvectors().col(k)).reshaped();
      EXPECT_NEAR(u.norm(), 1, 1e-14);
      const double residual = (A * u - ritz.eigenvalues()[k] * u).norm();
      EXPECT_NEAR(residual, T.beta.back() * std::abs(ritz.eigenvectors()(T.size() - 1, k)), 1e-13 * A.norm());
    }
  }
}

TEST(Lanczos, RadiusBoundsTheMatrixWithTheBetaToCome) {
  for (std::uint64_t seed = 5; seed < 25; ++seed) {
    const Eigen::MatrixXd A = randomSymmetric(seed);
    LanczosMatrix T = iterated(A, randomUnit(seed + 100, dimension), 6).matrix();
    const double beta = T.beta.back(), radius = T.radius;
    T.append(0, 0);  // brings that beta into the matrix
    const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(T.dense()).eigenvalues();
    EXPECT_LE(values.cwiseAbs().maxCoeff(), std::max(radius, beta) * (1 + 1e-14));
    EXPECT_GE(radius, iterated(A, randomUnit(seed + 100, dimension), 5).matrix().radius);
    T.clear();
    EXPECT_EQ(T.size(), 0);
    EXPECT_EQ(T.radius, 0);
  }
}

}  // namespace
}  // namespace ringwatch
