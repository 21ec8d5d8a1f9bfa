#pragma once
#include <Eigen/Dense>

#include <ringwatch/base/matrix3.h>
#include <ringwatch/base/random.h>

namespace ringwatch::test {

/// Random numbers and matrices from a seed, the same on every machine.
class Random : public ringwatch::Random {
 public:
  using ringwatch::Random::Random;
  /// Entries uniform in [-scale, scale].
  Eigen::Matrix3d matrix(double scale) {
    return Eigen::Matrix3d::NullaryExpr([&] { return uniform(-scale, scale); });
  }
  Eigen::Vector3d vector(double scale) {
    return Eigen::Vector3d::NullaryExpr([&] { return uniform(-scale, scale); });
  }
  /// A rotation about any axis by any angle.
  Eigen::Matrix3d rotation() {
    Eigen::Vector4d q;
    do {
      q = Eigen::Vector4d::NullaryExpr([&] { return uniform(-1, 1); });
    } while (q.squaredNorm() > 1 || q.squaredNorm() < 1e-2);
    return Eigen::Quaterniond(q).normalized().toRotationMatrix();
  }
  Eigen::Matrix3Xd nodeVectors(Eigen::Index count, double scale) {
    return Eigen::Matrix3Xd::NullaryExpr(3, count, [&] { return uniform(-scale, scale); });
  }
};

/// Eigen's matrix as the kernels' and back.
template <class S = double>
Matrix3<S> toMatrix3(const Eigen::Matrix3d& a) {
  Matrix3<S> r;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) r(i, j) = S(a(i, j));
  return r;
}
inline Eigen::Matrix3d toEigen(const Matrix3<double>& a) {
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(a.m);
}

}  // namespace ringwatch::test
