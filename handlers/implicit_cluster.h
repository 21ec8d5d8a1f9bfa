#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/SparseCholesky>

#include <ringwatch/body/body.h>

namespace ringwatch {

/// How the equations of a cluster are solved.
enum class ClusterSolver {
  automatic,          ///< Cholesky, and conjugate gradients for clusters of more than 400 nodes
  cholesky,           ///< factored once and turned with the cluster; anew when its shape has changed
  conjugateGradients  ///< block-Jacobi preconditioned, in the form with one synchronisation an iteration
};

struct ClusterOptions {
  ClusterSolver solver = ClusterSolver::automatic;
  double tolerance = 1e-8;  ///< of conjugate gradients: residual over right-hand side, in the preconditioner's norm
  int iterations = 200;     ///< of conjugate gradients, at most
};

/// Elements that share nodes, with the matrix M + w K̂ on their nodes: M the lumped mass of the whole body, K̂ the sum
/// of the elements' tangents at rest turned with them, K̂_e = s_e R_e K_e(X) R_eᵀ. R_e is the rotation of the element's
/// deformation gradient fitted to its nodes, identity for laws that are not objective; s_e >= 1 is the ratio of the
/// highest eigenvalues of K_e(x) and K_e(X), for laws that stiffen. K̂ is positive semidefinite in every state, which
/// the exact tangent is not.
///
/// K̂ is kept while the elements' rotations and stretches, seen from the rotating frame of the cluster, stay close to
/// those it was made for; the factor turns with that frame. A cluster with constrained nodes, or of a law that is
/// not objective, keeps the world's frame.
class ImplicitCluster {
 public:
  /// w: s². x: positions (3×N, m) to start from. The body must outlive the cluster. Throws NumericalError when K̂ is not
  /// finite.
  ImplicitCluster(const Body& body, std::vector<ElementRef> elements, double w, const NodeVectors& x,
                  const ClusterOptions& options);

  const std::vector<std::int32_t>& nodes() const { return nodes_; }
  const std::vector<ElementRef>& elements() const { return elements_; }

  /// Makes K̂ follow the positions x (3×N, m). False, with K̂ as it was, when it would not be finite.
  bool follow(const NodeVectors& x);
  /// Solves (M + w K̂) (a' + c v) = M (a + c v) for a' over the free components of the cluster's nodes and writes it
  /// into a (3×N, m/s²); constrained components of a' are those of a. False when conjugate gradients do not converge; a
  /// is then as before. c: 1/s.
  bool solve(NodeVectors& a, const NodeVectors& v, double c);

  std::int64_t factorisations() const { return factorisations_; }
  std::int64_t iterations() const { return iterations_; }
  /// M + w K̂ as a dense matrix over the cluster's nodes in the world's frame, constrained rows and columns included.
  Eigen::MatrixXd matrix() const;

 private:
  struct Element {
    ElementRef ref;
    std::vector<std::int32_t> local;  // positions in nodes_
    Eigen::MatrixXd rest;             // K_e(X), N/m
    Eigen::MatrixXd restShape;        // n×3: F = Σ x_a restShape_a, fitted to the nodes
    double restHighest = 0;           // N/m
    bool objective = true;
    Eigen::Matrix3d F, R;   // in the cluster's frame: F at the last look, R that K̂ was made for
    double stretch = 0;     // |F|² that K̂ was made for
    double stiffening = 1;  // s_e
  };
  Eigen::Matrix3d gradientOf(const Element& e, const NodeVectors& x) const;
  Eigen::Matrix3d frameOf(const NodeVectors& x) const;
  bool remake(const NodeVectors& x);
  void makePattern();
  bool factor();
  bool solveByConjugateGradients();
  void multiply(const Eigen::VectorXd& p, Eigen::VectorXd& Ap) const;
  void clearConstrained(Eigen::VectorXd& u) const;

  const Body& body_;
  double w_;
  ClusterOptions options_;
  std::vector<ElementRef> elements_;
  std::vector<Element> items_;
  std::vector<std::int32_t> nodes_;
  std::vector<std::uint8_t> constrained_;  // by local component
  bool anyConstrained_ = false, turns_ = true;
  Eigen::MatrixXd frameShape_;  // n×3 of all nodes, mass-weighted
  Eigen::Matrix3d frame_ = Eigen::Matrix3d::Identity();
  Eigen::VectorXd mass_;  // by local component

  // M + w K̂ in the cluster's frame: blocks by row for products, and its factor over the free components.
  std::vector<std::int32_t> rowBegin_, column_;
  std::vector<Eigen::Matrix3d> block_;
  std::vector<std::vector<std::int32_t>> position_;  // [element][a * n + b]
  std::vector<Eigen::Matrix3d> preconditioner_;      // inverse diagonal blocks
  Eigen::MatrixXd denseInverse_;                     // of small clusters
  Eigen::SparseMatrix<double> sparse_;               // of others, lower triangle
  std::unique_ptr<Eigen::SimplicialLLT<Eigen::SparseMatrix<double>, Eigen::Lower>> sparseFactor_;
  Eigen::VectorXd right_, u_, r_, z_, p_, q_, s_;
  std::int64_t factorisations_ = 0, iterations_ = 0;
};

/// Elements that share a node, directly or through others of the list, are in one cluster (union-find). Clusters by
/// their first element, elements ascending.
std::vector<std::vector<ElementRef>> clustersOf(const Body& body, const std::vector<ElementRef>& elements);

}  // namespace ringwatch
