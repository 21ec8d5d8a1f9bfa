#include <ringwatch/extensions/modal_filter/filtered_stiffness.h>

#include <cmath>

#include <ringwatch/base/eigen_instances.h>

namespace ringwatch {

FilteredStiffness filterModes(const Eigen::Matrix<double, 12, 12>& K, const Eigen::Vector4d& allowance) {
  Eigen::Matrix<double, 12, 1> root;
  for (int d = 0; d < 12; ++d) root[d] = std::sqrt(allowance[d / 3]);
  const Eigen::Matrix<double, 12, 12> scaled =
      root.cwiseInverse().asDiagonal() * (0.5 * (K + K.transpose())) * root.cwiseInverse().asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(Eigen::MatrixXd{scaled});
  FilteredStiffness result;
  result.kept.setZero();
  for (int k = 11; k >= 6; --k) {  // six more are rigid
    const double mu = eigen.eigenvalues()[k];
    const Eigen::Matrix<double, 12, 1> b = root.cwiseProduct(eigen.eigenvectors().col(k));
    result.kept += std::min(mu, 1.0) * b * b.transpose();
    if (!(mu > 1)) continue;
    result.mode.col(result.modes) = b;
    result.compliance[result.modes++] = 1 / (mu - 1);
  }
  return result;
}

}  // namespace ringwatch
