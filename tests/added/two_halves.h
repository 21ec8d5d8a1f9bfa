#pragma once
#include <ringwatch/integrators/integrator.h>

namespace ringwatch::test {

/// An integrator added from outside: two steps of symplectic Euler of half the size.
class TwoHalves final : public Integrator {
 public:
  static constexpr IntegratorInfo description{.name = "two-halves",
                                              .help = "symplectic Euler in two halves",
                                              .order = 1,
                                              .forceEvaluations = 2,
                                              .imaginaryLimit = 4,
                                              .symplectic = true};
  const IntegratorInfo& info() const override { return description; }
  StepStatus step(SecondOrderSystem& system, State& state, double h) override {
    for (int half = 0; half < 2; ++half) {
      system.acceleration(state.time, state.x, state.v, a_);
      state.v += 0.5 * h * a_;
      state.x += 0.5 * h * state.v;
      state.time += 0.5 * h;
    }
    return {};
  }

 private:
  NodeVectors a_;
};

}  // namespace ringwatch::test
