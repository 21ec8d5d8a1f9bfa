#include <ringwatch/verify/plane_element.h>

#include <cmath>

#include <Eigen/LU>

namespace ringwatch {

PlaneElement planeElement(const PlaneShape& shape, double young, double poisson, double density) {
  const double mu = young / (2 * (1 + poisson)), lambda = young * poisson / ((1 + poisson) * (1 - 2 * poisson));
  Eigen::Matrix3d C;
  C << lambda + 2 * mu, lambda, 0, lambda, lambda + 2 * mu, 0, 0, 0, mu;
  const int n = shape.nodes;
  PlaneElement element{Eigen::MatrixXd::Zero(2 * n, 2 * n), Eigen::VectorXd::Zero(n)};
  const auto addPoint = [&](const Eigen::MatrixXd& N, const Eigen::MatrixXd& dN, double weight) {  // n×1, n×2
    const Eigen::Matrix2d J = shape.X.leftCols(n) * dN;
    const double area = J.determinant() * weight;
    const Eigen::MatrixXd G = dN * J.inverse();
    Eigen::MatrixXd B = Eigen::MatrixXd::Zero(3, 2 * n);
    for (int a = 0; a < n; ++a) {
      B(0, 2 * a) = B(2, 2 * a + 1) = G(a, 0);
      B(1, 2 * a + 1) = B(2, 2 * a) = G(a, 1);
    }
    element.tangent += area * B.transpose() * C * B;
    element.mass += density * area * N.col(0);
  };
  if (n == 3) {
    Eigen::MatrixXd dN(3, 2);
    dN << -1, -1, 1, 0, 0, 1;
    addPoint(Eigen::MatrixXd::Constant(3, 1, 1.0 / 3), dN, 0.5);
    return element;
  }
  constexpr int signs[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  const double gauss = 1 / std::sqrt(3.0);
  for (const auto& at : signs) {
    const double r = gauss * at[0], s = gauss * at[1];
    Eigen::MatrixXd N(4, 1), dN(4, 2);
    for (int a = 0; a < 4; ++a) {
      const int i = signs[a][0], j = signs[a][1];
      N(a, 0) = 0.25 * (1 + i * r) * (1 + j * s);
      dN(a, 0) = 0.25 * i * (1 + j * s);
      dN(a, 1) = 0.25 * j * (1 + i * r);
    }
    addPoint(N, dN, 1);
  }
  return element;
}

}  // namespace ringwatch
