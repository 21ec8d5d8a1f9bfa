#pragma once
#include <vector>

#include <ringwatch/body/body.h>

namespace ringwatch {

/// Numbers c_a, m, with L ≼ diag(c_a) for the matrix L_ab = Σ_q w_q g_qa·g_qb of each element, rounded up:
/// [block][(batch * n + a) * lanes + lane]. c_a = Σ_b |L_ab| u_b / u_a holds for every u > 0; some steps of the power
/// method choose u so that the nodes' sums over their masses come close to each other (Theorem 97,
/// docs/theory/moved_majorants.md). Zero at nodes that are held.
std::vector<std::vector<double>> laplacianMajorants(const Body& body);

}  // namespace ringwatch
