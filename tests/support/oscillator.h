#pragma once
#include <cmath>

#include <ringwatch/integrators/integrator.h>

namespace ringwatch::test {

/// ẍ = -ω² x in every component of every node: the problem that stability limits are stated for.
class Oscillator final : public SecondOrderSystem {
 public:
  explicit Oscillator(double omega) : omega_(omega) {}
  void acceleration(double, const NodeVectors& x, const NodeVectors&, NodeVectors& a) override {
    a = -omega_ * omega_ * x;
    ++evaluations;
  }
  double energy(const State& s) const { return 0.5 * (s.v.squaredNorm() + omega_ * omega_ * s.x.squaredNorm()); }
  int evaluations = 0;

 private:
  double omega_;
};

/// Mathematical pendulum, ẍ = -sin x: nonlinear, conservative, reversible.
class Pendulum final : public SecondOrderSystem {
 public:
  void acceleration(double, const NodeVectors& x, const NodeVectors&, NodeVectors& a) override {
    a = -x.array().sin().matrix();
  }
  static double energy(const State& s) { return 0.5 * s.v.squaredNorm() - s.x.array().cos().sum(); }
};

/// One node with position and velocity along the first axis.
inline State oneNode(double x, double v) {
  State s;
  s.x = NodeVectors::Zero(3, 1);
  s.v = s.x;
  s.x(0, 0) = x;
  s.v(0, 0) = v;
  return s;
}

}  // namespace ringwatch::test
