#pragma once
#include <span>
#include <utility>

#include <ringwatch/integrators/integrator.h>

namespace ringwatch {

/// A composition of drifts x += d h v and kicks v += k h a(t, x, v), in the order d0 k0 d1 k1 … d_s.
///
/// Velocity-dependent forces: every kick takes the velocity from before it, so a scheme is of order one in the damping
/// whatever its order without.
struct Composition {
  std::span<const double> drifts;  // one more than kicks
  std::span<const double> kicks;
};

/// Advances a state by a composition; `a` is scratch memory.
inline StepStatus stepComposition(const Composition& scheme, SecondOrderSystem& system, State& state, double h,
                                  NodeVectors& a) {
  double time = state.time;
  State before;  // where a drift can fail
  if (system.tiesNodes()) before = state;
  StepStatus status = kickAndDrift(system, state, 0, a, scheme.drifts[0] * h);
  for (std::size_t k = 0; status.done && k < scheme.kicks.size(); ++k) {
    time += scheme.drifts[k] * h;
    system.acceleration(time, state.x, state.v, a);
    status = kickAndDrift(system, state, scheme.kicks[k] * h, a, scheme.drifts[k + 1] * h);
  }
  if (status.done)
    state.time += h;
  else
    state = std::move(before);
  return status;
}

/// Its step for the damped oscillator in (omega x, v), see IntegratorInfo::amplification.
inline Eigen::Matrix2d compositionAmplification(const Composition& scheme, double z, double dampingRatio) {
  Eigen::Matrix2d T = Eigen::Matrix2d::Identity();
  for (std::size_t k = 0; k < scheme.drifts.size(); ++k) {
    T.row(0) += scheme.drifts[k] * z * T.row(1);
    if (k == scheme.kicks.size()) break;
    const double c = scheme.kicks[k] * z;
    T.row(1) = (1 - 2 * dampingRatio * c) * T.row(1) - c * T.row(0);
  }
  return T;
}

}  // namespace ringwatch
