#pragma once
#include <ringwatch/monitor/bounds/mass_scaled_operator.h>

namespace ringwatch {

/// Highest eigenvalue of M⁻¹K over the free degrees of freedom, by Spectra's implicitly restarted Lanczos on
/// matrix-free tangent products, in units in which the eigenvalue is near 1.
struct GlobalFrequency {
  static constexpr double usualTolerance = 1e-10;
  static constexpr int mostRestarts = 3000;

  bool converged = false;  // as the residual of the pair that was found says
  double lambda = 0;       // rad²/s²; only when converged
  NodeVectors mode;        // displacement of the mode, mass-normalised, 3×N; only when converged
  int products = 0;        // tangent products spent
};
/// x: 3×N, m. tolerance: of the residual |A u - lambda u|, A = M^-½ K M^-½ and |u| = 1, relative to lambda. Works for
/// any state, indefinite K included. product: K(x) v, where others compute it. Throws InputError when x is not 3×N.
GlobalFrequency globalFrequency(const TangentSource& source, NodeVectorsView x,
                                double tolerance = GlobalFrequency::usualTolerance,
                                int maxRestarts = GlobalFrequency::mostRestarts, const TangentProduct& product = {});

}  // namespace ringwatch
