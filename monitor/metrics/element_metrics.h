#pragma once
#include <vector>

#include <ringwatch/body/body.h>

namespace ringwatch {

// Metrics of the elements' own tangents: [block][element], rad²/s², at positions x (3×N, m). Constrained degrees of
// freedom are left out; NaN where a tangent is not finite. J_e is an element's tangent scaled with the mesh's nodal
// masses, m_i^-½ K_ij m_j^-½; n the largest number of elements at a node.

/// lambda <= max_e lambda_e, each element with its own lumped mass (Fierz 2013, eq. 3.19 to 3.26): Theorem 3,
/// docs/theory/eigenvalue_bounds.md. The values are as computed, without a margin for rounding, as all in this file.
std::vector<std::vector<double>> singleElement(const Body& body, NodeVectorsView x);

/// lambda <= n max_e max(0, lambda_max(J_e)) (Shewchuk 2002; Fierz 2013, eq. 3.17): Theorem 3,
/// docs/theory/eigenvalue_bounds.md.
std::vector<std::vector<double>> shewchuk(const Body& body, NodeVectorsView x);

/// lambda >= max_e lambda_max(J_e), the other side of eq. 3.17, which needs the tangents of all other elements to be
/// positive semidefinite. Here it is proven for any (Theorem 10, docs/theory/rings_and_rayleigh.md): with v on the
/// nodes of e alone, another element takes away at most max(0, -lambda_min(J_e')) |v_i|² at each shared node i, so the
/// largest sum of these over the nodes of e is taken off.
std::vector<std::vector<double>> shewchukLower(const Body& body, NodeVectorsView x);

/// lambda <= n max_e max(0, lambda_max(K_e)) / min_i m_i: eq. 3.16 of Fierz 2013 (Fried 1972) for K, and the lumped
/// mass's own least eigenvalue. Theorem 3, docs/theory/eigenvalue_bounds.md.
std::vector<std::vector<double>> fried(const Body& body, NodeVectorsView x);

/// lambda >= max_e lambda_max(K_e) / max_i m_i: the lower side of eq. 3.16 for K, less what indefinite neighbours can
/// take away (`shewchukLower`), and the lumped mass's own largest eigenvalue. Theorem 10,
/// docs/theory/rings_and_rayleigh.md.
std::vector<std::vector<double>> friedLower(const Body& body, NodeVectorsView x);

}  // namespace ringwatch
