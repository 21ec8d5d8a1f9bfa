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

/// An integrator whose step is a composition. Scheme, the class that derives from it, has `composition` and
/// `description`, both static and constexpr.
template <class Scheme>
class CompositionIntegrator : public Integrator {
 public:
  /// A step for the damped oscillator in (omega x, v), see IntegratorInfo::amplification.
  static Eigen::Matrix2d amplification(double z, double dampingRatio) {
    const Composition& scheme = Scheme::composition;
    Eigen::Matrix2d T = Eigen::Matrix2d::Identity();
    for (std::size_t k = 0; k < scheme.drifts.size(); ++k) {
      T.row(0) += scheme.drifts[k] * z * T.row(1);
      if (k == scheme.kicks.size()) break;
      const double c = scheme.kicks[k] * z;
      T.row(1) = (1 - 2 * dampingRatio * c) * T.row(1) - c * T.row(0);
    }
    return T;
  }

  const IntegratorInfo& info() const override { return Scheme::description; }
  StepStatus step(SecondOrderSystem& system, State& state, double h) override {
    const Composition& scheme = Scheme::composition;
    double time = state.time;
    State before;  // where a drift can fail
    if (system.tiesNodes()) before = state;
    StepStatus status = kickAndDrift(system, state, 0, a_, scheme.drifts[0] * h);
    for (std::size_t k = 0; status.done && k < scheme.kicks.size(); ++k) {
      time += scheme.drifts[k] * h;
      system.acceleration(time, state.x, state.v, a_);
      status = kickAndDrift(system, state, scheme.kicks[k] * h, a_, scheme.drifts[k + 1] * h);
    }
    if (status.done)
      state.time += h;
    else
      state = std::move(before);
    return status;
  }

 private:
  NodeVectors a_;
};

}  // namespace ringwatch
