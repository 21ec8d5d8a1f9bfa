#pragma once
#include <cstdint>

#include <ringwatch/meshes/mesh.h>

namespace ringwatch {

/// x = y + translation + A (y - centre), m: a common motion of many nodes, and where it was fitted.
struct AffineMotion {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero(), translation = Eigen::Vector3d::Zero();
  Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
};

/// Nodes and their earlier positions, three numbers each; `count` is a multiple of 8, a node may come twice.
struct TrackedNodes {
  const std::int32_t* nodes;
  double* before;  // m
  std::size_t count;
};

/// The motion of `sample` of the nodes, spread evenly, by least squares. Any motion serves a bound; this leaves little.
AffineMotion fitAffineMotion(const TrackedNodes& tracked, const NodeVectors& x, std::size_t sample);

/// What a motion leaves of the nodes' moves to x: the middle of the residuals' box and how far any lies from it, m;
/// infinitely far when a number is not finite.
struct Residuals {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  double about = 0;
};
class ResidualsOf {
 public:
  explicit ResidualsOf(const AffineMotion& motion);
  /// With `store`, x becomes the position before.
  Residuals operator()(const TrackedNodes& tracked, const NodeVectors& x, bool store) const;

 private:
  typedef double Row8 __attribute__((vector_size(64)));
  // Eight nodes are three rows of eight numbers; what component each of them belongs to has its entries here.
  Row8 A_[3][3], translation_[3], centre_[3];
};

}  // namespace ringwatch
