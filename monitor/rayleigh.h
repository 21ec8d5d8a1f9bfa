#pragma once
#include <ringwatch/body/body.h>
#include <ringwatch/monitor/bounds.h>

namespace ringwatch {

/// A lower bound of the highest eigenvalue from a few tangent products: Lanczos from `start` (3×N, mass-scaled
/// coordinates, overwritten by the Ritz vector, of norm 1), then the Rayleigh quotient of that vector, which no eigenvalue
/// problem can make too large. products >= 1 tangent products are spent. start = 0 gives a bound of 0.
LowerBound rayleighLowerBound(const Body& body, const NodeVectors& x, NodeVectors& start, int products);

}  // namespace ringwatch
