#pragma once
#include <cstdint>

#include <ringwatch/base/archive.h>
#include <ringwatch/body/tangent_source.h>

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

/// The S below: 1/√(Σ_e tr|K_e,aa|) of every node, zero in constrained components.
NodeVectors scaleForSigns(const TangentSource& source, NodeVectorsView x, TangentSource::Workspace& workspace);

/// An element and its uᵀK_e u.
struct SoftElement {
  double form;
  ElementRef element;
};
/// The one with the least.
SoftElement softestElement(const TangentSource& source, NodeVectorsView x, const NodeVectors& u);

/// Searches for a direction in which K(x) is negative. A congruence keeps the signs of the eigenvalues, so the search
/// is made on S K S with S = 1/√(Σ_e tr|K_e,aa|) at each node, whose spectrum does not depend on the sizes of the
/// elements: Lanczos with full orthogonalisation. Directions with more than about (3 / maxProducts)² of the stiffest
/// one's size are found; finer ones can be missed. Later searches start from the last direction and, since any S keeps
/// the signs, from its S, which is that of the state now and then.
class LowestModeSearch {
 public:
  /// The source must outlive the search.
  explicit LowestModeSearch(const TangentSource& source) : source_(source) {}

  /// Tangent products that find what is coarse enough to matter, where nothing is known of the direction.
  static constexpr int usualProducts = 48;

  /// Searches in the state x, with at most maxProducts >= 1 tangent products, fewer once a direction is
  /// clearly negative.
  LowestMode find(NodeVectorsView x, int maxProducts);
  /// Whether there is a direction to start from; the first search starts from a random one.
  bool found() const { return direction_.cols() > 0; }
  void forget() {
    direction_.resize(3, 0);
    scale_.resize(3, 0);
  }

  template <class Archive>
  void archive(Archive& a) {
    a(direction_, scale_, sinceScale_);
    archiveVersion(a, sourceVersion_, source_.version());
  }

 private:
  void takeScale(NodeVectorsView x);
  /// Searches between two computations of S, which evaluate every element's tangent.
  static constexpr int scaleGap = 8;

  const TangentSource& source_;
  TangentSource::Workspace workspace_;
  NodeVectors direction_;  // in the coordinates of S K S
  NodeVectors scale_;      // S; 0 for constrained components
  int sinceScale_ = 0;
  std::int64_t sourceVersion_ = 0;  // of scale_
};

}  // namespace ringwatch
