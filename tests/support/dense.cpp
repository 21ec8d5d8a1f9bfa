#include "dense.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>

namespace ringwatch::test {

double spectralRadius(const Eigen::MatrixXd& A) {
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(A, false);
  EXPECT_EQ(solver.info(), Eigen::Success);
  return solver.eigenvalues().cwiseAbs().maxCoeff();
}

GeneralizedEigen generalizedEigen(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) {
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(A, B);
  EXPECT_EQ(solver.info(), Eigen::Success);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

Eigen::MatrixXd solve(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) { return A.partialPivLu().solve(B); }

double highestEigenvalue(const LongMatrix& A) {
  const Eigen::SelfAdjointEigenSolver<LongMatrix> solver(A, Eigen::EigenvaluesOnly);
  EXPECT_EQ(solver.info(), Eigen::Success);
  return static_cast<double>(solver.eigenvalues().tail<1>()[0]);
}

Eigen::MatrixXd orthogonalFactor(const Eigen::MatrixXd& A) {
  return Eigen::HouseholderQR<Eigen::MatrixXd>(A).householderQ();
}

}  // namespace ringwatch::test
