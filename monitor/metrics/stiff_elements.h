#pragma once
#include <vector>

#include <ringwatch/body/body.h>

namespace ringwatch {

/// Elements that alone, on their own lumped mass, would have a critical step below h (s) at positions x (3×N, m):
/// lambda_e > (limit/h)². All others together have their highest frequency at or below limit/h on the whole body's
/// mass: K_e <= lambda_e M_e for each of them, and their M_e add up to at most M. So the split is proven, for the
/// tangent at x and up to the rounding of lambda_e; it is not the smallest one. Theorem 32, docs/theory/handlers.md.
std::vector<ElementRef> stiffElements(const Body& body, NodeVectorsView x, double h, double limit);

}  // namespace ringwatch
