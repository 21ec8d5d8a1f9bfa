#pragma once
#include <Eigen/Core>

#include <ringwatch/materials/rotation.h>

namespace ringwatch {

/// closestRotation for Eigen's matrices.
inline Eigen::Matrix3d rotationOf(const Eigen::Matrix3d& F) {
  Matrix3<double> f;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) f(i, j) = F(i, j);
  const Matrix3<double> r = closestRotation(f);
  Eigen::Matrix3d R;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) R(i, j) = r(i, j);
  return R;
}

}  // namespace ringwatch
