#pragma once
#include <cstdint>

#include <ringwatch/body/body.h>
#include <ringwatch/monitor/nodal_bound.h>

namespace ringwatch {

/// b_e = lambda_max(D_e⁻¹ Σ_q w_q BᵀB), rounded up, of any elements of a block, one a lane (-1: none): norms[lane]. The
/// change of the tangent's moduli times b_e bounds the change of l_e. weights: those of the body.
void strainNormBounds(const Body& body, const NodalBound& weights, std::int32_t block, const std::int32_t* elements,
                      double* norms);

}  // namespace ringwatch
