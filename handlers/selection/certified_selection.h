#pragma once
#include <cstdint>
#include <vector>

#include <ringwatch/handlers/selection/selection.h>
#include <ringwatch/monitor/bounds/nodal_bound.h>

namespace ringwatch {

/// Factors of the weights D_(e,a) of a body's elements, [block][element * nodes of an element + a].
using NodalWeights = std::vector<std::vector<NodalBound::Factor>>;

/// A set of elements without which the explicit part is proven stable.
struct CertifiedSelection {
  ElementFlags chosen;
  UpperBound explicitPart;  // of the highest eigenvalue of M⁻¹ Σ K_e over the elements not chosen, rad²/s²; <= lambda
  /// Σ l_e D_e at each node over the elements not chosen, N/m: the explicit part's stiffness is below this
  /// block-diagonal matrix, and it below lambda M.
  std::vector<Eigen::Matrix3d> nodalSums;
  NodalWeights weights;          // D_e of the elements not chosen
  std::int64_t evaluations = 0;  // tangents and eigenvalues of single elements that it took
};

/// The smallest set found whose removal brings the block nodal bound of the explicit part, on the whole lumped mass, to
/// lambda or below: with K_e ≼ l_e D_e for each remaining element and lambda_max(Σ l_e D_e) <= lambda m_i at every node
/// i, the explicit part is proven stable at the step limit/√lambda, for the tangent at x. Greedy: the node with the
/// highest value hands over the element with the largest share of it, until no node value is too high, with weights D_e
/// swept again as the worst ones leave; then elements that fit into the slack T_i = lambda m_i - Σ l_e D_e of their
/// nodes come back, with D_e = T_i. keep: elements that stay chosen whatever the bound says, e.g. those chosen so far;
/// may be empty. outside: Σ l_e D_e at each node over elements that are not in the body and stay as they are, N/m,
/// below lambda M; it counts in all sums. Empty for none. Theorem 31, docs/theory/handlers.md. Throws InputError unless
/// lambda > 0, NumericalError when the tangent is not finite.
CertifiedSelection selectCertified(const Body& body, const NodeVectors& x, double lambda, const ElementFlags& keep = {},
                                   const std::vector<Eigen::Matrix3d>& outside = {});

}  // namespace ringwatch
