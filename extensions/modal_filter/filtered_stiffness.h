#pragma once
#include <Eigen/Core>

namespace ringwatch {

/// A tetrahedron's stiffness in two parts, K = K' + Σ_k (1/compliance_k) b_k b_kᵀ: what a step can take, and the modes
/// that were filtered out of it. Degrees of freedom 3·node + component, in the element's frame.
struct FilteredStiffness {
  Eigen::Matrix<double, 12, 12> kept;                                                 // K', N/m
  Eigen::Matrix<double, 12, 6> mode = Eigen::Matrix<double, 12, 6>::Zero();           // b_k, √(N/m)
  Eigen::Matrix<double, 6, 1> compliance = Eigen::Matrix<double, 6, 1>::Constant(1);  // of the first `modes`
  int modes = 0;
};

/// The modal filter (Fierz 2013, section 4.1.1) with the mass where it belongs: with K φ_k = μ_k T φ_k and Φᵀ T Φ = I,
///   K' = T Φ min(M, 1) Φᵀ T,   so that 0 ≼ K' ≼ T and K' = K on every mode with μ_k <= 1.
/// Theorem 39, docs/theory/handlers.md.
/// T = diag(allowance), N/m by node, is the stiffness that the step allows this element at its nodes: ω²_max m_a with
/// the element's own lumped mass for Fierz 2013's choice. (Fierz 2013's Φᵀ Λ' Φ has neither the mass nor the order of
/// the factors that its eq. 4.1 asks for.) b_k = T φ_k and 1/compliance_k = μ_k - 1 for the others. Allowances must be
/// > 0.
FilteredStiffness filterModes(const Eigen::Matrix<double, 12, 12>& K, const Eigen::Vector4d& allowance);

}  // namespace ringwatch
