#pragma once
#include <span>
#include <vector>

#include <ringwatch/monitor/nodal_bound.h>

namespace ringwatch {

/// M^-½ K M^-½ cut to a few nodes: a principal submatrix, so by Cauchy's interlacing theorem its eigenvalues lie
/// between the least and the largest of the whole. Its cost does not grow with the mesh.
class NodeSubmatrix {
 public:
  /// `incidences` knows the elements at each node.
  NodeSubmatrix(const Body& body, const NodalBound& incidences) : body_(body), incidences_(incidences) {}

  void choose(std::vector<std::int32_t> nodes);
  /// Ascending; rows and columns of the matrix are 3·position + component.
  const std::vector<std::int32_t>& nodes() const { return nodes_; }
  /// At positions x (3×N, m), rad²/s²; rows and columns of constrained components are zero.
  const Eigen::MatrixXd& evaluate(const NodeVectors& x);
  /// The element whose part of the last matrix has the largest quadratic form with v (3 a node).
  ElementRef mostOf(const Eigen::VectorXd& v) const;

 private:
  struct Part {
    ElementRef element;
    int count;                           // of its nodes that are chosen
    std::ptrdiff_t at[maxElementNodes];  // their positions
    std::size_t first;                   // of its matrix in parts_
  };
  const Body& body_;
  const NodalBound& incidences_;
  std::vector<std::int32_t> nodes_;
  std::vector<std::vector<std::int32_t>> elements_;  // [block], those at the nodes
  Eigen::MatrixXd matrix_;
  std::vector<Part> parts_;
  std::vector<double> entries_;  // 3·count × 3·count a part
};

}  // namespace ringwatch
