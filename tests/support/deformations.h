#pragma once
#include <string>
#include <vector>

#include <tests/support/random.h>

namespace ringwatch::test {

/// A deformation gradient with a word on where it comes from.
struct Deformation {
  std::string kind;
  Eigen::Matrix3d F;
};

/// Rotation times stretch times rotation, with the given singular values (a negative one inverts).
inline Eigen::Matrix3d withSingularValues(Random& random, const Eigen::Vector3d& s) {
  return random.rotation() * s.asDiagonal() * random.rotation();
}

/// Deformations near rest, strained, turned, and (when wanted) inverted, `count` of each.
inline std::vector<Deformation> deformations(std::uint64_t seed, int count, bool inverted) {
  Random random(seed);
  std::vector<Deformation> result;
  for (int i = 0; i < count; ++i) {
    result.push_back({"near rest", Eigen::Matrix3d::Identity() + random.matrix(1e-6)});
    result.push_back({"small strain", Eigen::Matrix3d::Identity() + random.matrix(1e-2)});
    result.push_back({"large strain", withSingularValues(random, {random.uniform(0.3, 3), random.uniform(0.3, 3),
                                                                  random.uniform(0.3, 3)})});
    result.push_back({"rotated", random.rotation()});
    result.push_back({"rotated and strained", random.rotation() * (Eigen::Matrix3d::Identity() + random.matrix(0.1))});
    // The smallest singular value counts negative; kept apart from the second, so that the closest rotation is smooth.
    if (inverted)
      result.push_back({"inverted", withSingularValues(random, {random.uniform(1, 2), random.uniform(0.7, 1),
                                                                -random.uniform(0.1, 0.4)})});
  }
  return result;
}

}  // namespace ringwatch::test
