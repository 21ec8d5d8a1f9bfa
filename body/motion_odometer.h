#pragma once
#include <cstdint>
#include <vector>

#include <ringwatch/base/aligned.h>
#include <ringwatch/meshes/mesh.h>

namespace ringwatch {

/// Adds up how far nodes move from call to call, but for an affine motion of all: with positions y before and x after,
///   x_i = y_i + t + A y_i + r_i   for any t and A,
/// `turned` grows by |A| (Frobenius), and every run of neighbouring nodes adds up its own part of the r_i: their middle
/// as a vector and how far they lie about it. t and A are fitted to some of the nodes. One streaming pass over the
/// positions tells for all elements at once how much their deformation gradients can have changed: in every call
///   ΔF = A F + Σ_a r_a ⊗ ∂N_a/∂X,   Σ_a ∂N_a/∂X = 0,   hence for any vector T
///   |F - F0| <= turned max|F| + γ max_a (|middle_a - T| + about_a),   γ = Σ_a |∂N_a/∂X|,
/// with the runs of the element's nodes.
class MotionOdometer {
 public:
  struct Course {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();  // m
    double about = 0;                                  // m
  };
  /// order: every node once, neighbours in space near one another; runs are cut from it.
  MotionOdometer(const std::vector<std::int32_t>& order, int threads);

  std::int32_t runOf(std::int32_t node) const { return runOf_[static_cast<std::size_t>(node)]; }
  /// Goes on to positions x (3×N, m); the first call begins at zero. Positions that are not finite make `about`
  /// infinite for good: differences of readings then fail every comparison.
  void advance(const NodeVectors& x);
  /// How many times it has gone on.
  std::int64_t advances() const { return advances_; }
  double turned() const { return turned_; }
  /// Of each run.
  const std::vector<Course>& courses() const { return courses_; }

 private:
  std::int64_t advances_ = 0;
  double turned_ = 0;
  std::vector<Course> courses_;
  std::vector<std::int32_t> runOf_;    // by node
  std::vector<std::int32_t> nodes_;    // run after run, each filled up to a multiple of 8 with its last node
  std::vector<std::size_t> runBegin_;  // runs + 1: into nodes_
  AlignedVector<double> before_;       // 3 numbers for each of nodes_
  int threads_;
};

}  // namespace ringwatch
