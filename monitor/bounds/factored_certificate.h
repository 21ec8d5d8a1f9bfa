#pragma once
#include <ringwatch/body/tangent_source.h>

namespace ringwatch {

/// Whether sigma M - K(x) is positive definite over the free degrees of freedom, so that lambda_max(M⁻¹K) < sigma: a
/// proof without probability, by the pivots of a sparse LDLᵀ factorisation. `false` proves nothing. Theorem 5,
/// docs/theory/eigenvalue_bounds.md.
///
/// With A = sigma I - M^-½ K M^-½ and n rows, positive computed pivots prove A + E ≻ 0 with
/// |E| <= γ_(n+2)/(1 - γ_(n+2)) trace(A), γ_k = k u/(1 - k u) (Rump 2006, for Cholesky; a third factor in each product
/// here; Theorem 41, docs/theory/floating_point.md). So A less four times that, and less 1e-12 of the norm of the
/// scaled tangent for its own rounding, is what gets factored: a sigma closer to the truth than that is not certified.
///
/// x: 3×N, m. sigma: rad²/s². True where nothing is free and sigma > 0; false when the tangent or sigma is not finite.
/// Costs 50 to 5000 tangent products, and memory for the factor: for a box of n nodes about 9 n^(4/3) numbers.
bool certifiesFrequency(const TangentSource& source, NodeVectorsView x, double sigma);

/// Whether a step h (s) is proven stable at x for an integrator whose largest stable h·omega is `limit`.
/// Throws InputError unless h > 0 and limit > 0.
bool certifies(const TangentSource& source, NodeVectorsView x, double h, double limit);

}  // namespace ringwatch
