#pragma once
#include <ringwatch/body/tangent_source.h>
#include <ringwatch/monitor/bounds.h>

namespace ringwatch {

/// A lower bound of the highest eigenvalue from a few tangent products: Lanczos from `start` (3×N, mass-scaled
/// coordinates, overwritten by the Ritz vector, of norm 1), then the Rayleigh quotient of that vector, which no
/// eigenvalue problem can make too large, less its rounding: that of the element tangents (TangentSource::formRounding)
/// and, for its sums, 1e-12 of the largest size of an eigenvalue that the iteration has seen, negative ones included.
/// products >= 1 tangent products are spent. start = 0 gives a bound of 0; so does one that is not finite, which
/// becomes 0. Unless nullptr, `seen` is the largest size of an eigenvalue that earlier calls have seen, for calls of
/// few products, which see little themselves; it is raised. Theorem 8, docs/theory/rings_and_rayleigh.md, and Theorem
/// 44, docs/theory/floating_point.md. The part of dashpots is known (LowerBound::dampingFrom).
LowerBound rayleighLowerBound(const TangentSource& source, NodeVectorsView x, NodeVectors& start, int products,
                              double* seen = nullptr);

}  // namespace ringwatch
