#pragma once
#include <cstdint>

#include <ringwatch/body/tangent_source.h>
#include <ringwatch/monitor/bounds.h>

namespace ringwatch {

/// An upper bound of the highest eigenvalue by Lanczos from a random start, and what it cost.
struct LanczosBound {
  ProbableUpperBound upper;
  Estimate ritz;          // the largest Ritz value, rad²/s²: at or below the truth but for rounding
  int products = 0;       // tangent products spent
  bool achieved = false;  // √(upper / ritz) - 1 <= width
};

/// With probability 1 - eta over the seeds, lambda_max(M⁻¹K(x)) over the free degrees of freedom lies at or below the
/// value (Kuczyński & Woźniakowski 1992; van Dorsselaer, Hochstenbach & van der Vorst 2001). A start uniform on the
/// sphere of n dimensions has |u·q₁| >= d = eta √(π/(2n)) for the top mode u but with probability eta; the Lanczos
/// vector p_k(A) q₁ has norm 1, so that |p_k(lambda)| <= 1/d: lambda is below the largest root of p_k(t) = 1/d:
/// Theorem 6, docs/theory/eigenvalue_bounds.md. Half of d is left to rounding. p_k is never formed: its ratios
/// p_j/p_(j-1) are positive right of all Ritz values (Sturm).
///
/// x: 3×N, m. width: relative, of the step, at which it stops, 1e-4 <= width < 1; the first that is narrow enough is
/// taken, since rounding spoils the argument once the top Ritz value has converged. eta: in (0, 0.5], and not so small
/// that d drowns in rounding. At most maxProducts tangent products; when these do not suffice, the bound holds all the
/// same and `achieved` is false. True for indefinite K, and for unconnected parts; 0 where nothing is free. NaN when
/// the tangent is not finite. With new seeds drawn until the value pleases, the probability is lost.
/// Throws InputError for width, eta or maxProducts out of range.
LanczosBound lanczosUpperBound(const TangentSource& source, NodeVectorsView x, double width = 0.01, double eta = 1e-9,
                               std::uint64_t seed = 1, int maxProducts = 1000);

}  // namespace ringwatch
