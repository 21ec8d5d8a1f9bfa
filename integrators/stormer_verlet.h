#pragma once
#include <ringwatch/integrators/integrator.h>

namespace ringwatch {

/// Störmer–Verlet in velocity form (central differences), v½ = v + h/2 a(x), x' = x + h v½, v' = v½ + h/2 a(x', v½).
/// Stable for h·omega < 2. The acceleration at x' serves the next step too: one force a step.
class StormerVerlet final : public Integrator {
 public:
  static constexpr IntegratorInfo description{"verlet", "second order, symplectic, one force a step", 2, 1, 2.0, true};
  const IntegratorInfo& info() const override { return description; }
  StepStatus step(SecondOrderSystem& system, State& state, double h) override {
    if (!fresh_) system.acceleration(state.time, state.x, state.v, a_);
    state.v += (0.5 * h) * a_;
    state.x += h * state.v;
    state.time += h;
    system.acceleration(state.time, state.x, state.v, a_);
    state.v += (0.5 * h) * a_;
    fresh_ = true;
    return {};
  }
  void reset() override { fresh_ = false; }

 private:
  NodeVectors a_;
  bool fresh_ = false;
};

}  // namespace ringwatch
