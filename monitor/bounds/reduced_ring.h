#pragma once
#include <vector>

#include <ringwatch/body/tangent_source.h>

namespace ringwatch {

/// The reduced 1-ring of an element: rows and columns of M^-½ K M^-½ at the element's own nodes, cut from the assembled
/// node and edge blocks (Fierz 2013, section 3.4). A principal submatrix, so by Cauchy's interlacing theorem its
/// largest eigenvalue never exceeds that of the whole, and its least one is never below: both are proven one-sided
/// bounds. Theorem 9, docs/theory/rings_and_rayleigh.md.
class ReducedRing {
 public:
  explicit ReducedRing(const TangentSource& source) : source_(source) {}

  struct Result {
    std::vector<std::vector<double>> largest;  // [block][element], rad²/s²
    double highest = 0;                        // largest of all, lowered by rounding: a proven lower bound
    ElementRef highestElement;
    double lowest = 0;  // least eigenvalue of any ring, when wanted
    ElementRef lowestElement;
  };
  /// All rings at positions x (3×N, m).
  const Result& evaluate(NodeVectorsView x, bool wantLowest = false);
  /// The last evaluation.
  const Result& last() const { return result_; }
  /// The top eigenvector of one ring of the last evaluation, put into a 3×N vector, in mass-scaled coordinates.
  NodeVectors topVector(ElementRef element) const;

 private:
  const TangentSource& source_;
  BlockMatrix matrix_;  // as assembled
  NodeVectors scale_;   // 1/√m, 0 where constrained
  TangentSource::Workspace workspace_;
  Result result_;
};

}  // namespace ringwatch
