#pragma once
#include <cmath>

#include <ringwatch/integrators/integrator.h>

namespace ringwatch {

/// Explicit Euler, x' = x + h v, v' = v + h a(x, v). Unstable for every undamped oscillator; here to show it.
///
/// With z = h·omega, trace 2 - 2ξz and determinant 1 - 2ξz + z²: stable for z <= 2ξ when ξ <= 1, for
/// z <= 2 (ξ - √(ξ² - 1)) above (the Jury conditions |det| <= 1, |trace| <= 1 + det).
class ExplicitEuler final : public Integrator {
 public:
  static Eigen::Matrix2d amplification(double z, double dampingRatio) {
    return (Eigen::Matrix2d() << 1, z, -z, 1 - 2 * dampingRatio * z).finished();
  }
  static double dampedLimit(double xi) { return xi <= 1 ? 2 * xi : 2 / (xi + std::sqrt(xi * xi - 1)); }
  static constexpr IntegratorInfo description{.name = "explicit-euler",
                                              .help = "first order, never stable without damping",
                                              .order = 1,
                                              .forceEvaluations = 1,
                                              .imaginaryLimit = 0.0,
                                              .symplectic = false,
                                              .amplification = &amplification,
                                              .dampedLimit = &dampedLimit};
  const IntegratorInfo& info() const override { return description; }
  StepStatus step(SecondOrderSystem& system, State& state, double h) override {
    const NodeVectors& a = accelerationOf(system, state);
    updateNodes(system, state.x.cols(), [&](auto slice) {
      slice(state.x) += h * slice(state.v);
      slice(state.v) += h * slice(a);
    });
    state.time += h;
    state.a.resize(3, 0);
    return {};
  }
  bool beginsWithAcceleration() const override { return true; }
};

}  // namespace ringwatch
