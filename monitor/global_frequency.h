#pragma once
#include <ringwatch/body/body.h>

namespace ringwatch {

/// Highest eigenvalue of M⁻¹K over the free degrees of freedom, by Spectra's implicitly restarted Lanczos on
/// matrix-free tangent products.
struct GlobalFrequency {
  bool converged = false;
  double lambda = 0;  // rad²/s²; only when converged
  NodeVectors mode;   // displacement of the mode, mass-normalised, 3×N; only when converged
  int products = 0;   // tangent products spent
};
/// tolerance: relative, on the eigenvalue's residual. Works for any state, indefinite K included.
GlobalFrequency globalFrequency(const Body& body, const NodeVectors& x, double tolerance = 1e-10,
                                int maxRestarts = 3000);

}  // namespace ringwatch
