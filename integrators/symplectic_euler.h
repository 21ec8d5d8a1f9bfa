#pragma once
#include <ringwatch/integrators/integrator.h>

namespace ringwatch {

/// Symplectic Euler (the source's eq. 2.72), v' = v + h a(x, v), x' = x + h v'. Stable for h·omega < 2.
class SymplecticEuler final : public Integrator {
 public:
  static constexpr IntegratorInfo description{"symplectic-euler", "first order, symplectic, one force a step", 1, 1, 2.0, true};
  const IntegratorInfo& info() const override { return description; }
  StepStatus step(SecondOrderSystem& system, State& state, double h) override {
    system.acceleration(state.time, state.x, state.v, a_);
    state.v += h * a_;
    state.x += h * state.v;
    state.time += h;
    return {};
  }

 private:
  NodeVectors a_;
};

}  // namespace ringwatch
