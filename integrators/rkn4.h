#pragma once
#include <ringwatch/integrators/integrator.h>

namespace ringwatch {

/// The three-stage Runge–Kutta–Nyström method of order four (Nyström 1925; Hairer, Nørsett & Wanner, Solving ODEs I,
/// table II.14.2):
///   k1 = a(t, x), k2 = a(t + h/2, x + h/2 v + h²/8 k1), k3 = a(t + h, x + h v + h²/2 k2),
///   x' = x + h v + h²/6 (k1 + 2 k2),  v' = v + h/6 (k1 + 4 k2 + k3).
/// On an undamped oscillator, with u = z²: trace 2 - u + u²/12, determinant 1 - u³/288 (dissipative), and 1 + trace +
/// det = 4 - u + u²/12 - u³/288 = 0 binds first, at z = 2.586518894519562. Theorem 28, docs/theory/integrators.md.
///
/// Velocity-dependent forces see the stage velocities v + h/2 k1 and v + h k2, which is all that three stages can know:
/// order two then (four stages would be needed for order four).
class RungeKuttaNystrom4 final : public Integrator {
 public:
  static Eigen::Matrix2d amplification(double z, double dampingRatio) {
    const double d = 2 * dampingRatio;
    // Rows that give (omega x, v) and the scaled accelerations k/omega from the state.
    const Eigen::RowVector2d X(1, 0), V(0, 1);
    const Eigen::RowVector2d k1 = -X - d * V;
    const Eigen::RowVector2d k2 = -(X + z / 2 * V + z * z / 8 * k1) - d * (V + z / 2 * k1);
    const Eigen::RowVector2d k3 = -(X + z * V + z * z / 2 * k2) - d * (V + z * k2);
    Eigen::Matrix2d T;
    T << X + z * V + z * z / 6 * (k1 + 2 * k2), V + z / 6 * (k1 + 4 * k2 + k3);
    return T;
  }
  static constexpr IntegratorInfo description{.name = "rkn4",
                                              .help = "Runge-Kutta-Nystrom, fourth order, three forces a step",
                                              .order = 4,
                                              .forceEvaluations = 3,
                                              .imaginaryLimit = 2.586518894519561549,
                                              .symplectic = false,
                                              .dampedOrder = 2,
                                              .amplification = &amplification};
  const IntegratorInfo& info() const override { return description; }
  StepStatus step(SecondOrderSystem& system, State& state, double h) override {
    const bool velocities = system.velocityDependent();
    const NodeVectors& k1 = accelerationOf(system, state);
    const auto stage = [&](double c, const NodeVectors& k) {
      x_.resizeLike(state.x);
      if (velocities) v_.resizeLike(state.v);
      updateNodes(system, state.x.cols(), [&](auto slice) {
        slice(x_) = slice(state.x) + c * slice(state.v) + (0.5 * c * c) * slice(k);
        if (velocities) slice(v_) = slice(state.v) + c * slice(k);
      });
    };
    stage(0.5 * h, k1);
    system.acceleration(state.time + 0.5 * h, x_, velocities ? v_ : state.v, k2_);
    stage(h, k2_);
    system.acceleration(state.time + h, x_, velocities ? v_ : state.v, k3_);
    updateNodes(system, state.x.cols(), [&](auto slice) {
      slice(state.x) += h * slice(state.v) + (h * h / 6) * (slice(k1) + 2 * slice(k2_));
      slice(state.v) += (h / 6) * (slice(k1) + 4 * slice(k2_) + slice(k3_));
    });
    state.time += h;
    state.a.resize(3, 0);
    return {};
  }
  bool beginsWithAcceleration() const override { return true; }

 private:
  NodeVectors x_, v_, k2_, k3_;
};

}  // namespace ringwatch
