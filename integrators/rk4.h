#pragma once
#include <ringwatch/integrators/integrator.h>

namespace ringwatch {

/// The classical Runge–Kutta method of order four on y = (x, v), ẏ = (v, a(t, x, v)) (Fierz 2013, eq. 2.74, with h,
/// not h/2, in the fourth stage). Neither symplectic nor a Nyström method.
///
/// R(w) = 1 + w + w²/2 + w³/6 + w⁴/24. On the imaginary axis |R(iz)|² = 1 - z⁶/72 + z⁸/576, so that z <= 2√2 = 2.8284.
/// On the real axis R(-z) = 1 gives z <= 2.7853; Fierz 2013's 2.78 is that value. Damping is treated to full order.
/// Theorem 28, docs/theory/integrators.md.
class RungeKutta4 final : public Integrator {
 public:
  static Eigen::Matrix2d amplification(double z, double dampingRatio) {
    const Eigen::Matrix2d A = (Eigen::Matrix2d() << 0, z, -z, -2 * dampingRatio * z).finished();
    const Eigen::Matrix2d I = Eigen::Matrix2d::Identity();
    return I + A * (I + A / 2 * (I + A / 3 * (I + A / 4)));
  }
  static constexpr IntegratorInfo description{
      .name = "rk4",
      .help = "classical Runge-Kutta, fourth order, four forces a step",
      .order = 4,
      .forceEvaluations = 4,
      .imaginaryLimit = 2.8284271247461900976,
      .symplectic = false,
      .dampedOrder = 4,
      .amplification = &amplification,
      .realLimit = 2.785293563405282,
  };
  const IntegratorInfo& info() const override { return description; }
  StepStatus step(SecondOrderSystem& system, State& state, double h) override {
    const NodeVectors& a = accelerationOf(system, state);
    stage(system, state, 0.5 * h, state.v, a, v2_, a2_);
    stage(system, state, 0.5 * h, v2_, a2_, v3_, a3_);
    stage(system, state, h, v3_, a3_, v4_, a4_);
    updateNodes(system, state.x.cols(), [&](auto slice) {
      slice(state.x) += (h / 6) * (slice(state.v) + 2 * (slice(v2_) + slice(v3_)) + slice(v4_));
      slice(state.v) += (h / 6) * (slice(a) + 2 * (slice(a2_) + slice(a3_)) + slice(a4_));
    });
    state.time += h;
    state.a.resize(3, 0);
    return {};
  }
  bool beginsWithAcceleration() const override { return true; }

 private:
  /// Velocity and acceleration of a stage at time + c, reached with the slopes of the stage before.
  void stage(SecondOrderSystem& system, const State& state, double c, const NodeVectors& velocity,
             const NodeVectors& acceleration, NodeVectors& v, NodeVectors& a) {
    x_.resizeLike(state.x);
    v.resizeLike(state.v);
    updateNodes(system, state.x.cols(), [&](auto slice) {
      slice(x_) = slice(state.x) + c * slice(velocity);
      slice(v) = slice(state.v) + c * slice(acceleration);
    });
    system.acceleration(state.time + c, x_, v, a);
  }
  NodeVectors x_, v2_, v3_, v4_, a2_, a3_, a4_;
};

}  // namespace ringwatch
