#pragma once
#include <ringwatch/monitor/bounds.h>
#include <ringwatch/monitor/bounds/node_submatrix.h>

namespace ringwatch {

/// A lower bound of the highest eigenvalue from a few tangent products: Lanczos from `start` (3×N, mass-scaled
/// coordinates, overwritten by the Ritz vector, of norm 1), then the Rayleigh quotient of that vector, which no
/// eigenvalue problem can make too large, less its rounding: 1e-12 of the largest size of an eigenvalue that the
/// iteration has seen, negative ones included. products >= 1 tangent products are spent. start = 0 gives a bound of 0;
/// so does one that is not finite, which becomes 0. Theorem 8, docs/theory/rings_and_rayleigh.md; the 1e-12 is asserted
/// (docs/theory/floating_point.md).
LowerBound rayleighLowerBound(const TangentSource& source, const NodeVectors& x, NodeVectors& start, int products);

/// A lower bound of the highest eigenvalue from the few nodes where a tracked mode moves most. Theorems 8 and 9,
/// docs/theory/rings_and_rayleigh.md.
class LocalSubmatrix {
 public:
  LocalSubmatrix(const TangentSource& source, const NodalBound& incidences) : submatrix_(source, incidences) {}

  /// Chooses the nodes where `mode` (3×N, mass-scaled coordinates) is largest, and starts from it.
  void choose(const NodeVectors& mode);
  /// The bound at positions x (3×N, m), by a few power iterations from the last vector.
  LowerBound evaluate(const NodeVectors& x);
  /// The element that held most of the last vector's energy.
  ElementRef highestElement() const { return submatrix_.mostOfLast(); }

 private:
  NodeSubmatrix submatrix_;
  Eigen::VectorXd vector_;  // 3 a node
};

}  // namespace ringwatch
