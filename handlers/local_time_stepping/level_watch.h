#pragma once
#include <memory>
#include <vector>

#include <ringwatch/handlers/selection/selection.h>
#include <ringwatch/monitor/incremental/moved_bound.h>

namespace ringwatch {

/// Watches some elements of a body with a limit of their own along a run, at little cost (MovedBound): those
/// of a level of smaller steps. Theorem 97, docs/theory/moved_majorants.md; its use: Theorem 36,
/// docs/theory/handlers.md.
class LevelWatch {
 public:
  /// mass: by node of the body, kg, > 0 where the elements have nodes. lambda: rad²/s².
  LevelWatch(const Body& body, const ElementFlags& elements, const Eigen::VectorXd& mass, double lambda, int substeps);

  /// Whether lambda is proven at positions x (3×N of the body, m).
  bool certifies(const NodeVectors& x);
  /// MovedBound::verify at positions x, for tests.
  double verify(const NodeVectors& x) const { return bound_->verify(x(Eigen::all, nodes_)); }
  /// Steps of these elements in one of the run.
  int substeps() const { return substeps_; }

 private:
  std::vector<std::int32_t> nodes_;
  std::unique_ptr<Body> part_;  // stays at its address, which the bound holds
  std::unique_ptr<MovedBound> bound_;
  double lambda_;
  int substeps_;
  NodeVectors x_;
};

}  // namespace ringwatch
