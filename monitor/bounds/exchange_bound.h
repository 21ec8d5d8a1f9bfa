#pragma once
#include <cstdint>

#include <ringwatch/body/tangent_source.h>
#include <ringwatch/monitor/bounds.h>
#include <ringwatch/monitor/bounds/nodal_bound.h>

namespace ringwatch {

/// A proven upper bound of the highest eigenvalue of M⁻¹K by sharing stiffness among elements. With A_e the element
/// tangents in mass-scaled coordinates and any symmetric P_e on the nodes of element e with
///   Σ_e P_e = sigma I - Σ_e A_e   (assembled),   eps_e = max(0, -lambda_min(P_e)),
/// P_e + eps_e I ≽ 0 sums up to   lambda_max(M⁻¹K) <= sigma + max_i Σ_(e∋i) eps_e.
/// The block nodal bound is the special case P_e = block diagonal - A_e; here neighbours also exchange the stiffness
/// between two nodes that they share, which closes the gap that every choice of weights leaves on regular grids.
///
/// The P_e are found by minimising Σ |P_e's negative part|² over the affine set: a step removes the negative parts and
/// spreads what is then missing from the sum evenly over the elements that share a block (a projection), accelerated
/// after Nesterov (Beck & Teboulle 2009) and restarted when the sum rises (O'Donoghue & Candès 2015). Every iterate
/// gives a bound; the best counts. An element is left alone while its least eigenvalue cannot have sunk below zero,
/// which the norms of its changes tell (Weyl). Theorem 12, docs/theory/exchange.md; that iterates keep the sum:
/// Theorem 13.
struct ExchangeBound {
  UpperBound upper;
  int iterations = 0;
  std::int64_t decompositions = 0;  // of element matrices: nearly all of the cost
};

/// x: 3×N, m. weights: evaluated at x; the start. sigma: rad²/s², best just above the truth; any value gives a bound.
/// accept: stops when the bound is at or below it. Memory: 18 n² numbers an element of n nodes, exchangeBoundBytes.
/// The value is infinite when the tangent is not finite.
ExchangeBound exchangeUpperBound(const TangentSource& source, NodeVectorsView x, const NodalBound& weights,
                                 double sigma, double accept, int maxIterations);
/// Memory that it needs, bytes.
std::int64_t exchangeBoundBytes(const TangentSource& source);

}  // namespace ringwatch
