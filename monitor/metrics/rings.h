#pragma once
#include <functional>
#include <vector>

#include <ringwatch/body/body.h>

namespace ringwatch {

/// Neighbourhoods of a node or an element (Fierz 2013, section 3.3.2 and 3.3.3). "At" a set of nodes are the elements
/// that hold at least one of them; R1(v) are those at node v, R1(e) those at the nodes of element e, R2 those at the
/// nodes of R1.
///
/// The first four are bodies of their own: K_R = Σ K_e and M_R = Σ M_e over the elements of the ring alone, so that
/// nodes on its rim are lighter and softer held than in the whole.
/// - vertex1 is a proven upper bound where all elements have the same number n of nodes: every element then lies in n
///   vertex rings, so Σ_v K_R(v) = n K and Σ_v M_R(v) = n M, and with l the largest lambda_max(M_R⁻¹ K_R) of all rings
///   n K = Σ_v K_R(v) ≼ l Σ_v M_R(v) = n l M. True for indefinite K_e too. With mixed elements the weights differ, and
///   nothing is proven. Theorem 4, docs/theory/eigenvalue_bounds.md.
/// - vertex2, element1 and element2 are estimates, as a rule pessimistic: rings that hold an element are then not
///   equally many for all of them, and Σ_R K_R is another body's matrix.
/// reduced2 is the principal submatrix of the whole M^-½ K M^-½ at the nodes of R1(e): by Cauchy's interlacing theorem
/// a proven lower bound, and never below reduced-1-ring, which is the same at the nodes of e. Theorem 9,
/// docs/theory/rings_and_rayleigh.md.
enum class RingKind { vertex1, vertex2, element1, element2, reduced2 };

/// Called now and then with the share that is done, 0 to 1, on the caller's thread.
using MetricProgress = std::function<void(double)>;

/// lambda_max, rad²/s², of each element's ring at positions x (3×N, m), [block][element]; of vertex rings the largest
/// of the element's nodes. Constrained degrees of freedom are left out. NaN where a tangent in the ring is not finite.
///
/// Blocks are cut from the assembled tangent; those between two nodes of a ring's rim are summed again over its
/// elements. vertex1 is solved densely and lifted by its rounding. The others take the Ritz value of a Lanczos
/// iteration with full orthogonalisation, run until its residual is below 3e-6 of it: an eigenvalue lies that close, in
/// practice within 1e-9. A Ritz value is a Rayleigh quotient, so reduced2 remains a lower bound however early it
/// stopped.
std::vector<std::vector<double>> ringEigenvalues(const Body& body, NodeVectorsView x, RingKind kind,
                                                 const MetricProgress& progress = {});

/// Whether all elements have the same number of nodes, so that vertex1 is an upper bound.
bool vertexRingsAreUpperBound(const Body& body);

}  // namespace ringwatch
