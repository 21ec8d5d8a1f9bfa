#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/base/options.h>
#include <ringwatch/body/body.h>

namespace ringwatch {

class ClusterMatrix;

/// How the equations of a cluster are solved.
enum class ClusterSolver {
  automatic,          ///< Cholesky, and conjugate gradients for clusters of more than 100 nodes
  cholesky,           ///< factored once and turned with the cluster; again when its shape has changed
  conjugateGradients  ///< block-Jacobi preconditioned, from the solutions of the last two steps extrapolated
};
inline constexpr auto clusterSolverNames = nameTable<ClusterSolver>({
    {ClusterSolver::automatic, "auto", "by the size of each cluster"},
    {ClusterSolver::cholesky, "cholesky", "factored and turned with its elements"},
    {ClusterSolver::conjugateGradients, "cg", "conjugate gradients"},
});

struct ClusterOptions {
  ClusterSolver solver = ClusterSolver::automatic;
  /// Conjugate gradients end at this residual over the right-hand side, in the preconditioner's norm. They are in
  /// single precision from 1e-5 on.
  double tolerance = 2e-3;
  int iterations = 200;  ///< of conjugate gradients, at most
};

/// The options of handlers that solve clusters, for their tables.
inline constexpr auto clusterSolverChoices = clusterSolverNames.views();
inline constexpr std::array<std::string_view, 2> iterativeSolvers{"auto", "cg"};
inline constexpr OptionInfo solverOption{
    .name = "solver",
    .type = OptionType::text,
    .choices = clusterSolverChoices,
    .fallback = "auto",
    .help =
        "of the implicit equations: factored and turned with its elements, or conjugate gradients; auto by the size "
        "of each cluster"};
inline constexpr OptionInfo solverToleranceOption{
    .name = "tolerance",
    .range = {0, 1, false, true},
    .automatic = true,
    .fallback = "auto",
    .help = "of cg, relative; auto 2e-3, on a GPU 1e-8; of newton, auto 5e-4",
    .onlyWith = {"solver", iterativeSolvers}};
inline constexpr OptionInfo solverIterationsOption{.name = "iterations",
                                                   .type = OptionType::integer,
                                                   .range = {1, infinity, true, true},
                                                   .fallback = "200",
                                                   .help = "of cg, at most",
                                                   .onlyWith = {"solver", iterativeSolvers}};
/// An option of conjugate gradients of a handler that has other solvers which it is for.
constexpr OptionInfo withSolvers(OptionInfo option, std::span<const std::string_view> solvers) {
  option.onlyWith.values = solvers;
  return option;
}
inline constexpr std::array<std::string_view, 2> onFailureChoices{"stop", "reduce-step"};
/// What a run does when a step fails: it stops, or halves the step. Its runner reads it.
inline constexpr OptionInfo onFailureOption{.name = "on_failure",
                                            .type = OptionType::text,
                                            .choices = onFailureChoices,
                                            .fallback = "stop",
                                            .help = "when a step fails, stop the run or halve its step"};
inline constexpr std::array<std::string_view, 2> momentumChoices{"keep", "free"};
/// Whether handled elements may exert a torque on the whole.
inline constexpr OptionInfo momentumOption{
    .name = "momentum",
    .type = OptionType::text,
    .choices = momentumChoices,
    .fallback = "keep",
    .help =
        "angular, of handled elements that touch nothing held: kept by a rotation of each cluster, or left to drift"};
inline bool keepsMomentum(const Options& own) { return own.text("momentum") == momentumChoices[0]; }
/// Reads the options above, all of which are given.
ClusterOptions clusterOptionsOf(const Options& own);

/// Elements that share nodes, with the matrix M + w K̂ on their nodes: M the lumped mass of the whole body, K̂ the sum
/// of the elements' tangents at rest turned with them, K̂_e = s_e R_e K_e(X) R_eᵀ. R_e is the rotation of the element's
/// deformation gradient fitted to its nodes, identity for laws that are not objective; s_e >= 1 is the ratio of the
/// highest eigenvalues of K_e(x) and K_e(X), for laws that stiffen. K̂ is positive semidefinite in every state, which
/// the exact tangent is not.
///
/// The corotational law counts as one that does not stiffen: its tangent grows with stretch on spins alone, where K̂ has
/// nothing to scale.
///
/// K̂ is kept while the elements' rotations and stretches, seen from the rotating frame of the cluster, stay close to
/// those it was made for (ClusterMatrix tells how close). Beyond, it is made again for all elements where it is
/// factored, and the factor turns with the frame; for conjugate gradients only the elements that have turned are
/// changed. A cluster with constrained nodes, or of a law that is not objective, keeps the world's frame.
///
/// The momentum of components that no node of the cluster has constrained is exact to rounding, whatever the tolerance.
class ImplicitCluster {
 public:
  /// w: s². x: positions (3×N, m) to start from. The body must outlive the cluster. Throws NumericalError when K̂ is not
  /// finite.
  ImplicitCluster(const Body& body, std::vector<ElementRef> elements, double w, const NodeVectors& x,
                  const ClusterOptions& options);
  ImplicitCluster(ImplicitCluster&& other) noexcept;
  ~ImplicitCluster();

  const std::vector<std::int32_t>& nodes() const { return nodes_; }
  const std::vector<ElementRef>& elements() const { return elements_; }

  /// Makes K̂ follow the positions x (3×N, m). False, with K̂ as it was, when it would not be finite.
  bool follow(const NodeVectors& x);
  /// Solves (M + w K̂) (a' + c v) = M (a + c v) for a' over the free components of the cluster's nodes and writes it
  /// into a (3×N, m/s²); constrained components of a' are those of a. False when conjugate gradients do not converge; a
  /// is then as before. c: 1/s.
  bool solve(NodeVectors& a, const NodeVectors& v, double c);

  /// How many times the matrix has changed.
  std::int64_t factorisations() const { return factorisations_; }
  std::int64_t iterations() const { return iterations_; }
  /// M + w K̂ as a dense matrix over the cluster's nodes in the world's frame, constrained rows and columns included.
  Eigen::MatrixXd matrix() const;

 private:
  Eigen::Matrix3d frameOf(const NodeVectors& x) const;
  bool factor();
  bool solveByConjugateGradients();
  void subtractProduct(const Eigen::VectorXd& p);
  /// Takes the translation, m/s², out of right_, but along directions that a node is held in.
  Eigen::Vector3d takeTranslation();

  double w_;
  ClusterOptions options_;
  std::vector<ElementRef> elements_;
  std::vector<std::int32_t> nodes_;
  std::vector<std::uint8_t> constrained_;  // by local component
  std::array<bool, 3> anyConstrained_{};   // by component
  bool rotates_ = true;
  Eigen::MatrixXd frameShape_;  // n×3 of all nodes, mass-weighted
  Eigen::Matrix3d frame_ = Eigen::Matrix3d::Identity();
  Eigen::VectorXd mass_;  // by local component
  std::unique_ptr<ClusterMatrix> matrix_;

  struct Iterative;
  std::unique_ptr<Iterative> iterative_;  // of conjugate gradients
  // The factor over the free components.
  Eigen::MatrixXd denseInverse_;        // of small clusters
  Eigen::SparseMatrix<double> sparse_;  // of others, lower triangle
  std::vector<std::ptrdiff_t> place_;   // of the entries as factor() visits them
  std::unique_ptr<Eigen::SimplicialLLT<Eigen::SparseMatrix<double>, Eigen::Lower>> sparseFactor_;
  Eigen::VectorXd right_, u_, prescribed_;
  std::int64_t factorisations_ = 0, iterations_ = 0;
};

/// Elements that share a node, directly or through others of the list, are in one cluster (union-find). Clusters by
/// their first element, elements ascending.
std::vector<std::vector<ElementRef>> clustersOf(const Body& body, const std::vector<ElementRef>& elements);

}  // namespace ringwatch
