#pragma once
#include <limits>
#include <type_traits>

#include <ringwatch/base/math.h>
#include <ringwatch/base/rounding.h>
#include <ringwatch/materials/tangent_drift.h>

/// The arithmetic of validity balls: one source for CPU and CUDA threads.
namespace ringwatch {

/// What an element's highest eigenvalue l_e = lambda_max(D_e⁻¹K_e) can have grown to, N/m, when its deformation
/// gradients F_q have moved from the reference gradients F0_q at which it was evaluated:
///   l_e <= value + linear δ + quadratic δ²   for   max_q |F_q - F0_q| <= δ <= radius,
/// in Frobenius norms. TangentDriftOf (body/element_operators.h) has the inequality, each law its coefficients.
template <class S>
struct TangentGrowthOf {
  S value, linear, quadratic;
  S radius;  ///< of the inequality; < 0: nothing is known

  /// The bound of l_e at a distance δ; infinite beyond the radius, and where δ is NaN.
  RINGWATCH_INLINE S at(S distance) const {
    return select(distance <= radius, value + distance * (linear + distance * quadratic),
                  S(std::numeric_limits<double>::infinity()));
  }
};
using TangentGrowth = TangentGrowthOf<double>;

/// The growth by the law's drift at F0 and the strain norm bound b_e = lambda_max(D_e⁻¹ Σ_q w_q BᵀB).
RINGWATCH_INLINE TangentGrowth growthOf(const TangentDriftCoefficients<double>& drift, double value,
                                        double strainNorm) {
  return {value,
          2 * math::sqrt((value + strainNorm * drift.negative) * drift.kappa * strainNorm) + strainNorm * drift.linear,
          strainNorm * (drift.kappa + drift.quadratic), drift.radius};
}

/// Radius of the validity ball |F_q - F0_q| <= r within which l_e stays within an allowance and no F_q inverts; -1
/// where the value itself exceeds the allowance. inversionDistance: TangentDriftOf's.
template <class S>
RINGWATCH_INLINE S validityRadius(const TangentGrowthOf<S>& growth, const std::type_identity_t<S>& inversionDistance,
                                  const std::type_identity_t<S>& allowance) {
  const S gap = allowance - growth.value, room = select(gap >= S(0.0), gap, S(0.0));
  const S denominator = growth.linear + math::sqrt(growth.linear * growth.linear + S(4.0) * growth.quadratic * room);
  const auto grows = denominator > S(0.0);
  const S radius =
      select(grows, S(2.0) * room / select(grows, denominator, S(1.0)), S(std::numeric_limits<double>::infinity()));
  // An element that inverts must be outside its ball before it does.
  return select(gap >= S(0.0), math::min(radius, math::min(growth.radius, inversionDistance)) * S(1 - radiusRounding),
                S(-1.0));
}

}  // namespace ringwatch
