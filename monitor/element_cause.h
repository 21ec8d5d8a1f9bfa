#pragma once
#include <string>

#include <ringwatch/body/body.h>
#include <ringwatch/meshes/quality.h>

namespace ringwatch {

/// Why an element allows only a small step: its departure from rest, and its shape at rest.
struct ElementCause {
  bool finite = true;                           // the deformation gradients; where not, the next three say nothing
  double leastDeterminant = 1;                  // det F, least over the quadrature points
  double largestStretch = 1, leastStretch = 1;  // singular values of F, over the quadrature points
  ElementShape shape;                           // at rest; quadratic elements by their corners
  /// The shape alone makes the step small.
  bool badlyShaped() const;
};

/// The cause at positions x (3×N, m). element: numbered as in the whole body. Collective (body/domain.h).
ElementCause elementCause(const Body& body, NodeVectorsView x, ElementRef element);

/// In a few words: the largest departure from rest ("inverted, det F = -0.31", "stretched 1.6", "compressed
/// to 0.62", from 5 % on), and a bad shape ("needle, 0.4° dihedral", "small"); "well shaped, unstrained" when it is
/// neither, "not finite" for positions that are not.
std::string causeText(const ElementCause& cause);

}  // namespace ringwatch
