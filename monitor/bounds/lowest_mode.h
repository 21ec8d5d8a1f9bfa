#pragma once
#include <ringwatch/body/body.h>

namespace ringwatch {

/// A direction u in which the tangent is soft, and what it proves.
struct LowestMode {
  /// uᵀKu / uᵀMu, rad²/s², raised by its rounding: the least eigenvalue of M⁻¹K(x) over the free components is at or
  /// below it. Negative: K(x) is indefinite. Not negative: nothing is proven. NaN where the tangent is not finite.
  /// Theorem 11, docs/theory/rings_and_rayleigh.md.
  double value = 0;
  ElementRef element;  // with the least uᵀK_e u
  int products = 0;    // tangent products spent
};

/// Searches for a direction in which K(x) is negative, at positions x (3×N, m). A congruence keeps the signs of the
/// eigenvalues, so the search is made on S K S with S = 1/√(Σ_e tr|K_e,aa|) at each node, whose spectrum does not
/// depend on the sizes of the elements: Lanczos with full orthogonalisation from `start` (3×N, of any size; random when
/// empty; becomes the direction in the coordinates of S K S), at most maxProducts >= 1 tangent products, fewer once a
/// direction is clearly negative. Directions with more than about (3 / maxProducts)² of the stiffest one's size are
/// found; finer ones can be missed.
LowestMode findLowestMode(const Body& body, const NodeVectors& x, NodeVectors& start, int maxProducts);

}  // namespace ringwatch
