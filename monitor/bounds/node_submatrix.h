#pragma once
#include <span>
#include <vector>

#include <ringwatch/monitor/bounds/nodal_bound.h>

namespace ringwatch {

/// M^-½ K M^-½ cut to a few nodes: a principal submatrix, so by Cauchy's interlacing theorem its eigenvalues lie
/// between the least and the largest of the whole (Theorem 9, docs/theory/rings_and_rayleigh.md). Its cost does not
/// grow with the mesh.
class NodeSubmatrix {
 public:
  /// `incidences` knows the elements at each node.
  NodeSubmatrix(const TangentSource& source, const NodalBound& incidences) : source_(source), incidences_(incidences) {}

  /// nodes: in any order. Masses and free components are those of now; evaluate() follows them when they change.
  void choose(std::vector<std::int32_t> nodes);
  /// Ascending; rows and columns of the matrix are 3·position + component.
  const std::vector<std::int32_t>& nodes() const { return nodes_; }
  /// The submatrix at positions x (3×N, m), rad²/s²; rows and columns of constrained components are zero.
  const Eigen::MatrixXd& evaluate(NodeVectorsView x);
  /// What eigenvalues of the matrix err by when element tangents do, rad²/s²: Σ_i τ_i/m_i (Theorem 42,
  /// docs/theory/floating_point.md). Of the last evaluation.
  double rounding() const { return rounding_; }

 private:
  /// An element's degrees of freedom that are chosen and free: which of its own, which row, and 1/√m.
  struct Part {
    int count = 0;
    int own[3 * maxElementNodes], row[3 * maxElementNodes];
    double scale[3 * maxElementNodes];
    double inverseMass[maxElementNodes] = {};  // of its nodes that are chosen and not held in all components
  };
  void addDiscrete(const DiscreteForces& discrete, NodeVectorsView x);
  struct BlockParts {
    std::vector<std::int32_t> elements;
    std::vector<Part> parts;
  };
  const TangentSource& source_;
  const NodalBound& incidences_;
  std::vector<std::int32_t> nodes_;
  std::vector<BlockParts> blocks_;
  Eigen::MatrixXd matrix_;
  double rounding_ = 0;
  std::int64_t sourceVersion_ = 0;  // when the parts were made
};

}  // namespace ringwatch
