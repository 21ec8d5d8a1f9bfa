#pragma once
#include <string_view>

#include <ringwatch/monitor/bounds.h>
#include <ringwatch/monitor/bounds/reduced_ring.h>

namespace ringwatch {

/// Lower bounds of the highest eigenvalue: the highest reduced ring's, and the Rayleigh quotient of the mode. Theorems
/// 8 and 9, docs/theory/rings_and_rayleigh.md.
struct TopMode {
  LowerBound ring, quotient;
  bool byRing() const { return !(quotient.value > ring.value); }
  LowerBound lower() const { return higher(ring, quotient); }
  std::string_view method() const { return byRing() ? "reduced-1-ring" : "rayleigh-quotient"; }
};
/// Finds the top mode at positions x (3×N, m): evaluates all reduced rings, and sharpens the highest one's vector,
/// added to the mode tracked so far, by Lanczos. A tracked vector alone can miss a jump of the top mode; the ring's
/// alone can lie beside it. mode: 3×N, mass-scaled coordinates, empty at first; becomes the one found. products:
/// coldProducts tangent products the first time, warmProducts then. wantLowest: the rings' lowest eigenvalues too.
TopMode findTopMode(ReducedRing& ring, const TangentSource& source, NodeVectorsView x, NodeVectors& mode,
                    int coldProducts, int warmProducts, bool wantLowest);

}  // namespace ringwatch
