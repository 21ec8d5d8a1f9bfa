#pragma once
#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include <ringwatch/body/body.h>

namespace ringwatch {

/// Elements that share nodes, with the nonlinear equation of the implicit-explicit step on their nodes. With their
/// internal force f_I, the state (x, v) and w = beta h²,
///   M u + f_I(x + w u) = M (a + c v) + f_I(x),   u = a' + c v,
/// of which ImplicitCluster solves the linear form with K̂ in the place of the tangent. The solution is a stationary
/// point of the incremental potential
///   Φ(u) = ½ (u - û)ᵀ M (u - û) + W_I(x + w u)/w,   û = a + c v + M⁻¹ f_I(x),
/// found by Newton's method with conjugate gradients that end at directions of negative curvature (Steihaug 1983) and a
/// line search in Φ (Nocedal & Wright 2006, section 7.1). So Φ never grows from its start, and positions x + w u at
/// which a law has no energy are never taken. Theorem 61, docs/theory/handlers.md.
class NewtonCluster {
 public:
  /// h: the step, s. w: s². tolerance: of the residual, relative to what it is for u = 0, both in the preconditioner's
  /// norm. mostProducts: of the tangent with vectors, for one step of Newton's method. The body must outlive the
  /// cluster.
  NewtonCluster(const Body& body, std::vector<ElementRef> elements, double h, double w, double tolerance,
                int mostProducts);

  const std::vector<std::int32_t>& nodes() const { return nodes_; }
  const std::vector<ElementRef>& elements() const { return elements_; }

  enum class Outcome { solved, noEnergy, notConverged };
  /// Solves for a' over the free components of the cluster's nodes and writes it into a (3×N, m/s²), where the
  /// acceleration by all forces at x stands. Otherwise a is as before: the elements have no energy where the search
  /// could begin, or it has taken its steps without coming to its tolerance. It also ends where no step along a
  /// direction of descent lowers Φ: at a minimum in a kink, or by rounding. c: 1/s.
  Outcome solve(NodeVectorsView x, NodeVectors& a, const NodeVectors& v, double c);

  /// Steps of Newton's method, products with the tangent, and searches that ended where Φ cannot be lowered, not at
  /// their tolerance.
  std::int64_t iterations() const { return iterations_; }
  std::int64_t products() const { return products_; }
  std::int64_t stalls() const { return stalls_; }
  /// What the scheme has taken from the energy of the elements so far, J. With f_n the elements' force of the step that
  /// leads from v_(n-½) to v_(n+½), the kinetic energy changes by -f_n · (x_(n+½) - x_(n-½)), x_(n+½) half way between
  /// x_n and x_(n+1): Σ f_n · (x_(n+½) - x_(n-½)) - W_I at the last of these + W_I at the first. Constrained
  /// components count with the elements' forces at the ends of steps, as EnergyBalance has what supports do.
  double dissipated() const;

 private:
  /// Φ, its gradient and the positions at u_; false where it is not finite.
  bool evaluate();
  /// ½ (u - û)ᵀ M (u - û).
  double kinetic(const NodeVectors& u) const;
  /// W_I half way between two steps, or at the step beside it where there is none, J.
  double energyNear(const NodeVectors& halfway) const;
  void refreshPreconditioner();
  void precondition(const NodeVectors& r, NodeVectors& z) const;
  template <class Visit>
  void forEachConstrained(const Visit& visit) const;
  void clearConstrained(NodeVectors& vectors) const;
  void removeTranslation(NodeVectors& direction) const;
  /// A direction of descent: (M + w K) p = -gradient to a share of its norm, or to where its curvature is negative.
  void findDirection(double reduction);
  enum class Progress { none, poor, good };
  /// Takes a share of the direction that lowers Φ, if one does.
  Progress searchAlong();

  double h_, w_, tolerance_;
  int mostProducts_;
  std::vector<ElementRef> elements_;
  std::vector<std::int32_t> nodes_;
  std::array<bool, 3> anyConstrained_{};
  Body part_;
  Body::Workspace workspace_;
  BlockMatrix blocks_;
  std::vector<Eigen::Matrix3d> inverses_;  // of the preconditioner
  double reference_ = 0;                   // norm that the tolerance is a share of
  // Of nodes_, 3×n.
  NodeVectors x_, moved_, target_, u_, gradient_, direction_, residual_, z_, p_, product_, before_;
  std::array<NodeVectors, 2> last_;  // solutions of the last two steps
  StepEvaluation evaluation_;
  bool moving_ = false;                          // whether constrained nodes move
  NodeVectors forceAtStep_ = NodeVectors(3, 0);  // f_I at x of the last step, where they do
  double stiffness_ = 0;                         // modulus × volume of the elements, J
  double potential_ = 0;
  double workAgainst_ = 0;                   // Σ f_n · (x_(n+½) - x_(n-½)), J
  double firstEnergy_ = 0;                   // W_I at the first half step, J
  double energyAtStep_ = 0;                  // W_I at x of the last step, J
  NodeVectors halfway_ = NodeVectors(3, 0);  // x_(n+½) of the last step
  int productsOfFirst_ = 0;                  // of the first system solved with a new preconditioner
  bool stale_ = true;
  std::int64_t iterations_ = 0, products_ = 0, stalls_ = 0;
};

}  // namespace ringwatch
