#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include <ringwatch/body/body.h>
#include <ringwatch/handlers/handler.h>
#include <ringwatch/handlers/imex/cluster_pcg.h>

namespace ringwatch {

/// Newmark's method in the two-step form of the implicit-explicit step, by its dissipation α: forces are those at
/// x + α h v + β h² a, β = (1 + α)²/4. Theorem 34, docs/theory/handlers.md.
struct ImplicitScheme {
  double h;                     // s
  double dissipation;           // α, 0 to 1: 0 is the trapezoidal rule, 1 implicit Euler
  double stiffnessDamping = 0;  // Rayleigh's, s, of linear equations: half a step of it is implicit (Theorem 64)
  double beta() const { return 0.25 * (1 + dissipation) * (1 + dissipation); }
  double w() const { return beta() * h * h + 0.5 * h * stiffnessDamping; }  // s²
  double c() const { return dissipation * h / w(); }                        // 1/s
};

/// Elements that share nodes, with the nonlinear equation of the implicit-explicit step on their nodes. With their
/// internal force f_I, the state (x, v), the acceleration ã by all other forces, w = beta h² and c = α/(beta h),
///   M u + f_I(x + w u) = M (ã + c v),   u = a' + c v,
/// of which ImplicitCluster solves the linear form with K̂ in the place of the tangent. The solution is a stationary
/// point of the incremental potential
///   Φ(u) = ½ (u - û)ᵀ M (u - û) + W_I(x + w u)/w,   û = ã + c v,
/// found from the last two solutions, extrapolated. A step of the search solves with the tangent of an earlier state,
/// kept in single precision and turned with the cluster, as long as that brings the gradient down; else with the
/// tangent itself, by Newton's method with conjugate gradients that end at directions of negative curvature (Steihaug
/// 1983) and a line search in Φ (Nocedal & Wright 2006, section 7.1). A search may end with a step by the kept tangent
/// at whose end nothing is evaluated, where the last ones have left so little over that it is at its tolerance; with
/// implicit Euler none does, Φ never grows from its start, and positions at which a law has no energy are never taken.
/// Theorem 61, docs/theory/handlers.md. With α < 1 these are not where the step ends. A step that would end where a law
/// has no energy, or whose search fails, is taken by implicit Euler instead, whose x + w u is its end: Theorem 69.
class NewtonCluster {
 public:
  /// tolerance: of the residual, relative to what it is for u = 0, both in the preconditioner's norm. mostProducts: of
  /// the tangent with vectors, for one step of Newton's method. The body must outlive the cluster.
  NewtonCluster(const Body& body, std::vector<ElementRef> elements, ImplicitScheme scheme, double tolerance,
                int mostProducts);

  const std::vector<std::int32_t>& nodes() const { return nodes_; }
  const std::vector<ElementRef>& elements() const { return elements_; }
  /// That solve() takes: one, or those of the body in clusters that are large enough. Results have the same bits.
  int threads() const { return part_.threads(); }

  enum class Outcome { solved, noEnergy, notConverged };
  /// Solves for a' over the free components of the cluster's nodes and writes it into a (3×N, m/s²), where the
  /// acceleration at x by all forces but its own stands. Otherwise a is as before: the elements have no energy where
  /// the search could begin, or it has taken its steps without coming to its tolerance. It also ends where no step
  /// along a direction of descent lowers Φ: at a minimum in a kink, or by rounding.
  Outcome solve(NodeVectorsView x, NodeVectors& a, const NodeVectors& v);
  /// The same; tells in words what went wrong, "" for nothing.
  std::string_view solveOrTell(NodeVectorsView x, NodeVectors& a, const NodeVectors& v);

  /// Steps of the search, products with the tangent, kept or not, searches that ended where Φ cannot be lowered, not at
  /// their tolerance, and steps that implicit Euler took.
  std::int64_t iterations() const { return iterations_; }
  std::int64_t products() const { return products_; }
  std::int64_t stalls() const { return stalls_; }
  std::int64_t eulerSteps() const { return eulerSteps_; }

 private:
  /// The gradient of Φ and the positions at u_, and Φ where it is wanted or tells whether there is one; false where
  /// that is not finite.
  bool evaluate(bool wantsPotential);
  /// ½ (u - û)ᵀ M (u - û).
  double kinetic(const NodeVectors& u) const;
  /// Makes u_ the solution by a scheme, from the state that solve() has taken in. v: of all nodes.
  Outcome search(const ImplicitScheme& scheme, const NodeVectors& v);
  /// Where a search begins: at the guess, or at rest. endsThere: the step ends at x + w u, so that Φ at the guess must
  /// not be above Φ at rest. False where there is no energy.
  bool beginSearch(bool endsThere);
  /// Φ at u = 0.
  double potentialAtRest();
  /// Begins at u_, with the motion of the centre of mass and of constrained components as it will be.
  bool begin(bool wantsPotential);
  /// Begins at the last two solutions, extrapolated.
  bool beginAsBefore(bool wantsPotential);
  /// Whether the step by u_ ends where a law has no energy.
  bool endsWithoutEnergy(const NodeVectors& v);
  /// Σ m v: of velocities the momentum.
  Eigen::Vector3d weightedByMass(const NodeVectors& v) const;
  /// Adds a translation to vectors in components that no node has constrained, so that their momentum is `momentum`.
  void setMomentum(NodeVectors& vectors, const Eigen::Vector3d& momentum) const;
  /// Keeps the tangent at the positions of u_.
  void refreshTangent();
  void layOutKept();
  /// Turns it as the cluster has turned since.
  void turnTangent();
  /// The vectors, times a factor, in the frame of the tangent that is kept.
  void turnBack(const NodeVectors& vectors, double factor, Eigen::VectorXd& turned) const;
  void precondition(const NodeVectors& r, NodeVectors& z) const;
  /// In the preconditioner's norm.
  double squaredNorm(const NodeVectors& r);
  template <class Visit>
  void forEachConstrained(const Visit& visit) const;
  /// Calls visit(node) for all of nodes_, which must treat each alone.
  template <class Visit>
  void forEachNode(const Visit& visit) const;
  /// Σ a·b.
  double inner(const NodeVectors& a, const NodeVectors& b) const;
  void clearConstrained(NodeVectors& vectors) const;
  /// A direction of descent: (M + w K) p = -gradient to a share of its norm, or to where its curvature is negative.
  void findDirection(double reduction);
  /// The same with the tangent that is kept; false where that gives none.
  bool findKeptDirection(double reduction);
  enum class KeptStep { failed, descended, atTolerance };
  /// A step of the search by the tangent that is kept. It is at its tolerance unseen where `wanted`, of the gradient's
  /// norm, is more than such steps leave; it has failed, and u_ is as before, where it does not halve the gradient.
  /// norm: of the gradient, squared.
  KeptStep stepByKept(double norm, double wanted, bool endsThere);
  enum class Progress { none, poor, good };
  /// Takes a share of the direction that lowers Φ, if one does.
  Progress searchAlong();

  ImplicitScheme scheme_;
  double tolerance_;
  double w_ = 0, c_ = 0;  // of the search
  int mostProducts_;
  std::vector<ElementRef> elements_;
  std::vector<std::int32_t> nodes_;
  std::array<bool, 3> anyConstrained_{};
  Body part_;
  Body::Workspace workspace_;
  // The tangent that is kept: M + w K at the positions shape_, in a frame that turns.
  BlockMatrix blocks_;
  UpperBlocks matrix_;
  std::vector<std::int64_t> placeOfKept_;  // in blocks_
  std::optional<ClusterPcg<float>> kept_;
  Eigen::VectorXd right_, solution_;
  std::vector<Eigen::Matrix3d> inverses_;  // of the preconditioner
  Eigen::Matrix3d frame_ = Eigen::Matrix3d::Identity();
  bool turns_ = false;    // no node is constrained, and the laws turn with their elements
  int furtherSteps_ = 0;  // beyond the first of their searches, since it was made
  double scale_ = 0;      // what the tolerance is a share of: the gradient's norm at u = 0 when last looked at, squared
  double leftOver_ = 1;   // by its steps, of the gradient's norm, of late
  int unseen_ = 0;        // searches that have ended without a look
  // Of nodes_, 3×n.
  NodeVectors x_, others_, shape_, moved_, target_, u_, gradient_, direction_, residual_, z_, p_, product_, before_;
  std::array<NodeVectors, 2> last_;  // solutions of the last two steps
  StepEvaluation evaluation_;
  double stiffness_ = 0;      // modulus × volume of the elements, J
  bool endsAnywhere_ = true;  // all laws have an energy beyond inversion
  double potential_ = 0;
  bool hasPotential_ = false;  // potential_ is that at u_
  int productsOfFirst_ = 0;    // of the first system solved with a new preconditioner
  bool stale_ = true;
  std::int64_t iterations_ = 0, products_ = 0, stalls_ = 0, eulerSteps_ = 0;
};

/// What clusters have come to, for the figures of a handler.
struct NewtonCounts {
  std::int64_t clusters = 0, largestNodes = 0;
  std::int64_t iterations = 0, products = 0, stalls = 0, eulerSteps = 0;  // as NewtonCluster counts them

  void add(const NewtonCluster& cluster);
  /// Those of the other parts of a body. Collective.
  void addOthers(Domain& domain);
  std::vector<HandlerFigure> figures() const;
};

}  // namespace ringwatch
