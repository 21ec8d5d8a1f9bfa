#pragma once
#include <ringwatch/integrators/integrator.h>

namespace ringwatch {

/// Explicit Euler, x' = x + h v, v' = v + h a(x, v). Unstable for every undamped oscillator; here to show it.
class ExplicitEuler final : public Integrator {
 public:
  static constexpr IntegratorInfo description{"explicit-euler", "first order, never stable without damping", 1, 1, 0.0, false};
  const IntegratorInfo& info() const override { return description; }
  StepStatus step(SecondOrderSystem& system, State& state, double h) override {
    system.acceleration(state.time, state.x, state.v, a_);
    state.x += h * state.v;
    state.v += h * a_;
    state.time += h;
    return {};
  }

 private:
  NodeVectors a_;
};

}  // namespace ringwatch
