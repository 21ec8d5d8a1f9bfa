#pragma once
#include <cstdint>
#include <vector>

#include <ringwatch/meshes/mesh.h>

namespace ringwatch {

/// Degrees of freedom that do not follow forces: fixed ones stay, moved ones run at a prescribed constant velocity.
/// Both leave the stability problem.
class Constraints {
 public:
  explicit Constraints(std::size_t nodeCount)
      : constrained_(3 * nodeCount, 0), velocity_(NodeVectors::Zero(3, static_cast<Eigen::Index>(nodeCount))) {}

  /// Fixes a component (0, 1, 2) of a node.
  void fix(std::int32_t node, int component) { move(node, component, 0.0); }
  void fix(std::int32_t node) {
    for (int c = 0; c < 3; ++c) fix(node, c);
  }
  /// Moves a component of a node at `velocity`, m/s.
  void move(std::int32_t node, int component, double velocity) {
    constrained_[3 * static_cast<std::size_t>(node) + static_cast<std::size_t>(component)] = 1;
    velocity_(component, node) = velocity;
    any_ = true;
    moving_ = moving_ || velocity != 0;
  }

  bool any() const { return any_; }
  bool moving() const { return moving_; }
  bool isConstrained(std::int32_t node, int component) const {
    return constrained_[3 * static_cast<std::size_t>(node) + static_cast<std::size_t>(component)] != 0;
  }
  /// Components of a node that follow forces, 0 to 3.
  int freeComponents(std::int32_t node) const {
    return 3 - isConstrained(node, 0) - isConstrained(node, 1) - isConstrained(node, 2);
  }
  /// Prescribed velocities, 3×N, m/s; zero where nothing is prescribed.
  const NodeVectors& velocity() const { return velocity_; }

  /// Zeroes the constrained components of a 3×N array.
  void clearConstrained(NodeVectors& values) const {
    if (!any_) return;
    double* p = values.data();
    for (std::size_t i = 0; i < constrained_.size(); ++i)
      if (constrained_[i]) p[i] = 0;
  }
  /// Gives constrained components of a velocity field their prescribed values.
  void imposeVelocity(NodeVectors& v) const {
    if (!any_) return;
    for (std::size_t i = 0; i < constrained_.size(); ++i)
      if (constrained_[i]) v.data()[i] = velocity_.data()[i];
  }

 private:
  std::vector<std::uint8_t> constrained_;
  NodeVectors velocity_;
  bool any_ = false;
  bool moving_ = false;
};

}  // namespace ringwatch
