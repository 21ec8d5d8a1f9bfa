#pragma once
#include <Eigen/Core>

/// Dense algebra that tests compare with, compiled once.
namespace ringwatch::test {

/// The largest absolute value of an eigenvalue of a square matrix.
double spectralRadius(const Eigen::MatrixXd& A);

/// A phi = lambda B phi with A symmetric and B positive definite; ascending, vectors of unit length in B.
struct GeneralizedEigen {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};
GeneralizedEigen generalizedEigen(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);

/// A⁻¹ B with partial pivoting.
Eigen::MatrixXd solve(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);

using LongMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
/// The highest eigenvalue of a symmetric matrix.
double highestEigenvalue(const LongMatrix& A);

/// Q of A = Q R.
Eigen::MatrixXd orthogonalFactor(const Eigen::MatrixXd& A);

}  // namespace ringwatch::test
