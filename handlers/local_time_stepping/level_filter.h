#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <ringwatch/body/body.h>
#include <ringwatch/handlers/imex/implicit_cluster.h>
#include <ringwatch/handlers/local_time_stepping/chebyshev_filter.h>
#include <ringwatch/handlers/selection/selection.h>

namespace ringwatch {

/// Elements of one level below the coarsest.
struct FineLevel {
  ElementFlags elements;
  /// Averages the forces of this level and the deeper ones over a step of the level above, in filter.steps evaluations.
  ChebyshevFilter filter;
  double step;  // of the level above, s
};

/// The average of the forces of fine elements over a coarse step, E_0 in
///   a = E_0 (a_0 + Σ_(k>=1) a_k),   E_(k-1) = Q_k(B_k) E_k,   B_k = τ_(k-1)² E_k M⁻¹ Σ_(i>=k) K_i,   k = 1 … n,
/// a_k the acceleration by the elements of level k, Q_k the filter of level k, E_n = 1 or, with implicit elements,
/// E_n = (1 + M⁻¹ w K̂)⁻¹. By the three-term recursion of the filters with forces in place of products with K_k: every
/// law and every rotation is seen where the nodes are (products with a tangent that is frozen over the step would spoil
/// the angular momentum). E_0 is symmetric in the product of M for a frozen tangent, and 1 for translations, so that
/// momentum is kept. Theorem 36, docs/theory/handlers.md.
///
/// Each level's elements are a body of their own on the nodes that it or a deeper level touches. Nodes are numbered
/// from the deepest level up, so that a level's nodes are the first ones of all levels above.
class LevelFilter {
 public:
  /// implicit: elements for which no level is fine enough, evaluated with the last level, which may have no other; w:
  /// s². x: positions of the whole body, 3×N, m. Masses and constraints are copied from the body.
  LevelFilter(const Body& body, std::vector<FineLevel> levels, const ElementFlags& implicit, double w,
              const NodeVectors& x, const ClusterOptions& options);

  /// The nodes of the body that fine elements touch.
  const std::vector<std::int32_t>& nodes() const { return nodes_; }
  /// x: positions of nodes(), 3×n, m. a: the acceleration, m/s², by all that is not fine, at the same nodes; becomes
  /// that of the whole, averaged. Constrained components of a must be and stay zero. Returns why not, "" when all is
  /// well: an implicit matrix that is not definite, or an average far larger than what it averages, which no tangent
  /// within the filters' range gives.
  std::string apply(const NodeVectors& x, NodeVectors& a);

  const std::vector<ImplicitCluster>& clusters() const { return clusters_; }

 private:
  struct Level {
    FineLevel fine;
    std::optional<Body> body;
    Eigen::Index count = 0;  // nodes that this or a deeper level touches
    Body::Workspace workspace;
    NodeVectors force;
    NodeVectors base;  // acceleration by this and deeper levels where the recursion of this level starts
    NodeVectors now;   // and at its current positions
    NodeVectors x, u, before, residual, answer;
  };
  void number(const Body& body, const ElementFlags& implicit);
  Body partOf(const Body& body, const ElementFlags& elements, Eigen::Index count) const;
  void evaluate(std::size_t level, const NodeVectors& x, bool first);
  bool average(std::size_t level, const NodeVectors& x, const NodeVectors& a, NodeVectors& result);

  std::vector<Level> levels_;
  std::vector<std::int32_t> nodes_;
  Eigen::VectorXd mass_, inverseMass_;
  std::vector<Eigen::Index> held_;  // constrained components, ascending
  std::vector<ImplicitCluster> clusters_;
  NodeVectors sum_;
};

}  // namespace ringwatch
