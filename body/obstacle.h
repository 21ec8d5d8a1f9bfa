#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include <ringwatch/meshes/mesh.h>

namespace ringwatch {

/// A rigid obstacle by its signed distance, which is negative where a node is inside of it.
class Obstacle {
 public:
  /// The distance g at a point, m; its gradient, a unit vector that points out of the obstacle; and its second
  /// derivative, 1/m. Zero gradient where there is none, as in the middle of a sphere.
  struct Surface {
    double gap;
    Eigen::Vector3d normal;
    Eigen::Matrix3d curvature;
  };

  virtual ~Obstacle() = default;
  /// At a point of the obstacle's own frame, m: that of its place at time zero.
  virtual Surface at(const Eigen::Vector3d& point) const = 0;
  /// Of some nodes at x, 3×N, against the obstacle moved by `displacement`, m: the places in `nodes` of those with a
  /// distance of at most `gap`, m, ascending, and by rounding of some that are hardly farther. near: has room for all.
  /// Returns how many there are. It takes less than a call of at() for each.
  virtual std::size_t within(double gap, NodeVectorsView x, std::span<const std::int32_t> nodes,
                             const Eigen::Vector3d& displacement, std::int32_t* near) const = 0;
};

/// The half-space below a plane through `point` with the outward direction `normal`. Throws InputError unless the
/// normal is finite and has a length.
std::unique_ptr<Obstacle> planeObstacle(const Eigen::Vector3d& point, const Eigen::Vector3d& normal);
/// A ball, or with `hollow` all that is outside of it. radius: m, > 0.
std::unique_ptr<Obstacle> sphereObstacle(const Eigen::Vector3d& centre, double radius, bool hollow);
/// A cylinder about an axis through `point`, of any length or with flat ends at length/2 on either side of the point;
/// with `hollow`, of any length alone, all that is outside of it. radius and length: m, > 0.
std::unique_ptr<Obstacle> cylinderObstacle(const Eigen::Vector3d& point, const Eigen::Vector3d& axis, double radius,
                                           std::optional<double> length, bool hollow);
/// A box along the axes with the edge lengths `size`, m, > 0. A node inside is pushed out of the nearest face.
std::unique_ptr<Obstacle> boxObstacle(const Eigen::Vector3d& centre, const Eigen::Vector3d& size);

/// What obstacles of all kinds are made of.
struct ObstacleParameters {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< m
  Eigen::Vector3d normal = Eigen::Vector3d::Zero(), axis = Eigen::Vector3d::Zero(), size = Eigen::Vector3d::Zero();
  double radius = 0;                  ///< m
  std::optional<double> length = {};  ///< m
  bool hollow = false;
};

/// A kind of obstacle, as scenes name it. needs, takes: parameters by name; `point` serves all kinds.
struct ObstacleKind {
  std::string_view name;
  std::string_view help;
  std::vector<std::string_view> needs, takes;
  std::unique_ptr<Obstacle> (*make)(const ObstacleParameters&);
};
const std::vector<ObstacleKind>& allObstacleKinds();

}  // namespace ringwatch
