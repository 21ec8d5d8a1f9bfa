#pragma once
#include <cmath>

#include <ringwatch/integrators/integrator.h>

namespace ringwatch {

/// Störmer–Verlet in velocity form (central differences), v½ = v + h/2 a(x), x' = x + h v½, v' = v½ + h/2 a(x', v½).
/// Stable for h·omega < 2. The acceleration at x' serves the next step too: one force a step.
///
/// Velocity-dependent forces lag half a step: from step to step v½ follows v½' = v½ + h a(x', v½), central differences
/// with lagged damping, of order one in the damping and stable for h·omega <= 2 (√(1 + ξ²) - ξ) like symplectic Euler,
/// to which that recursion is equal (Belytschko, Liu, Moran, Elkhodary 2014, section 6.6). Theorem 29,
/// docs/theory/integrators.md.
class StormerVerlet final : public Integrator {
 public:
  /// A step in (omega x, v½), which is similar to one in (omega x, v).
  static Eigen::Matrix2d amplification(double z, double dampingRatio) {
    const double keep = 1 - 2 * dampingRatio * z;
    return (Eigen::Matrix2d() << 1 - z * z, z * keep, -z, keep).finished();
  }
  static double dampedLimit(double xi) { return 2 / (std::sqrt(1 + xi * xi) + xi); }
  static constexpr IntegratorInfo description{.name = "verlet",
                                              .help = "second order, symplectic, one force a step",
                                              .order = 2,
                                              .forceEvaluations = 1,
                                              .imaginaryLimit = 2.0,
                                              .symplectic = true,
                                              .reversible = true,
                                              .amplification = &amplification,
                                              .dampedLimit = &dampedLimit,
                                              .highestModeBinds = true,
                                              .drifts = true};
  const IntegratorInfo& info() const override { return description; }
  StepStatus step(SecondOrderSystem& system, State& state, double h) override {
    const StepStatus status = advance(system, state, h);
    if (status.done) complete(system, state);
    return status;
  }
  StepStatus advance(SecondOrderSystem& system, State& state, double h) override {
    const NodeVectors& a = accelerationOf(system, state);
    if (const StepStatus status = kickAndDrift(system, state, 0.5 * h, a, h); !status.done) return status;
    state.time += h;
    state.a.resize(3, 0);
    state.lag = 0.5 * h;
    return {};
  }
  bool beginsWithAcceleration() const override { return true; }
};

}  // namespace ringwatch
