#pragma once
#include <cmath>

#include <ringwatch/integrators/integrator.h>

namespace ringwatch {

/// Symplectic Euler (Fierz 2013, eq. 2.72), v' = v + h a(x, v), x' = x + h v'. Stable for h·omega < 2.
///
/// With z = h·omega, trace 2 - z² - 2ξz and determinant 1 - 2ξz, so the Jury condition 1 + trace + det >= 0 binds:
/// z² + 4ξz <= 4, that is z <= 2 (√(1 + ξ²) - ξ). Theorems 28 and 29, docs/theory/integrators.md.
class SymplecticEuler final : public Integrator {
 public:
  static Eigen::Matrix2d amplification(double z, double dampingRatio) {
    const double keep = 1 - 2 * dampingRatio * z;
    return (Eigen::Matrix2d() << 1 - z * z, z * keep, -z, keep).finished();
  }
  static double dampedLimit(double xi) { return 2 / (std::sqrt(1 + xi * xi) + xi); }
  static constexpr IntegratorInfo description{.name = "symplectic-euler",
                                              .help = "first order, symplectic, one force a step",
                                              .order = 1,
                                              .forceEvaluations = 1,
                                              .imaginaryLimit = 2.0,
                                              .symplectic = true,
                                              .amplification = &amplification,
                                              .dampedLimit = &dampedLimit,
                                              .highestModeBinds = true,
                                              .runsOnGpu = true,
                                              .drifts = true};
  const IntegratorInfo& info() const override { return description; }
  StepStatus step(SecondOrderSystem& system, State& state, double h) override {
    const NodeVectors& a = accelerationOf(system, state);
    if (const StepStatus status = kickAndDrift(system, state, h, a, h); !status.done) return status;
    state.time += h;
    state.a.resize(3, 0);
    return {};
  }
  bool beginsWithAcceleration() const override { return true; }
};

}  // namespace ringwatch
