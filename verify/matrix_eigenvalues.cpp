#include <ringwatch/verify/matrix_eigenvalues.h>

#include <cmath>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/base/error.h>

namespace ringwatch {

Eigen::VectorXcd eigenvaluesOf(const Eigen::MatrixXd& A) {
  Eigen::MatrixXd similar = A;
  constexpr int attempts = 4;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    const Eigen::EigenSolver<Eigen::MatrixXd> solver(similar, false);
    if (solver.info() == Eigen::Success) return solver.eigenvalues();
    Eigen::VectorXd normal(A.rows());
    for (Eigen::Index i = 0; i < A.rows(); ++i) normal[i] = std::cos(1.0 + attempt + 2.0 * static_cast<double>(i));
    normal.normalize();
    similar -= 2 * normal * (normal.transpose() * similar).eval();
    similar -= 2 * (similar * normal).eval() * normal.transpose();
  }
  throw NumericalError(joinText("eigenvalues of a ", A.rows(), " by ", A.cols(), " matrix: the iteration failed"));
}

double denseEigenvalue(const Eigen::MatrixXd& K, const Eigen::VectorXd& mass) {
  const Eigen::Index components = K.rows() / mass.size();
  Eigen::VectorXd root(K.rows());
  for (Eigen::Index i = 0; i < root.size(); ++i) root[i] = 1 / std::sqrt(mass[i / components]);
  const Eigen::MatrixXd J = root.asDiagonal() * K * root.asDiagonal();
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(J, Eigen::EigenvaluesOnly).eigenvalues().maxCoeff();
}

}  // namespace ringwatch
