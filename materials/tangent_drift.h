#pragma once
#include <limits>

namespace ringwatch {

/// Coefficients of a law's bound on how fast its tangent ∂P/∂F grows away from a deformation gradient F, Pa. For
/// |F' - F| <= δ (Frobenius): the square root of the quadratic form of ∂P/∂F plus `negative` |dF|² grows by at most
/// √kappa δ |dF|, and the rest by at most (linear δ + quadratic δ²) |dF|². Holds for δ <= radius; radius < 0: never. No
/// eigenvalue of ∂P/∂F at F is below -negative. Theorem 16, docs/theory/incremental_certificate.md, has the use,
/// docs/theory/tangent_drift.md the coefficients of each law.
template <class S>
struct TangentDriftCoefficients {
  S kappa, linear, quadratic, negative;
  S radius = S(std::numeric_limits<double>::infinity());
};

}  // namespace ringwatch
