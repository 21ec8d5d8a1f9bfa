#pragma once
#include <ringwatch/integrators/body_system.h>

namespace ringwatch {

/// A body as a system that remembers its last evaluation: when the energy books or the integrator ask for the force at
/// positions where the other one has just had it, it is not computed again, whichever scheme runs.
class RunSystem final : public DifferentiableSystem {
 public:
  /// remember: false passes every call through, for runs that keep no energy books.
  RunSystem(const Body& body, const RayleighDamping& damping, bool remember)
      : system_(body, damping), remember_(remember) {}

  void acceleration(double time, const NodeVectors& x, const NodeVectors& v, NodeVectors& a) override {
    if (!remember_) {
      system_.acceleration(time, x, v, a);
      return;
    }
    evaluate(time, x, v);
    a = a_;
  }
  bool velocityDependent() const override { return system_.velocityDependent(); }
  /// Internal force at x, 3×N, N. Only when remembering.
  const NodeVectors& internalForce(double time, const NodeVectors& x, const NodeVectors& v) {
    evaluate(time, x, v);
    return system_.lastInternalForce();
  }
  /// Damping force C v, 3×N, N; empty without damping. Only when remembering.
  const NodeVectors& dampingForce(double time, const NodeVectors& x, const NodeVectors& v) {
    evaluate(time, x, v);
    return system_.lastDampingForce();
  }
  State initialState() const { return system_.initialState(); }

  const Eigen::VectorXd& mass() const override { return system_.mass(); }
  RayleighDamping damping() const override { return system_.damping(); }
  void stiffnessProduct(const NodeVectors& x, const NodeVectors& u, NodeVectors& Ku) override {
    system_.stiffnessProduct(x, u, Ku);
  }
  Eigen::SparseMatrix<double> stiffness(const NodeVectors& x) override { return system_.stiffness(x); }
  void stiffnessDiagonal(const NodeVectors& x, std::vector<Eigen::Matrix3d>& blocks) override {
    system_.stiffnessDiagonal(x, blocks);
  }
  bool isConstrained(std::int32_t node, int component) const override { return system_.isConstrained(node, component); }

 private:
  void evaluate(double time, const NodeVectors& x, const NodeVectors& v) {
    // Bit by bit: NaN never equals itself. Velocities count where forces depend on them.
    const auto same = [](const NodeVectors& a, const NodeVectors& b) {
      return a.size() == b.size() && (a.array() == b.array()).all();
    };
    if (same(x_, x) && (!velocityDependent() || same(v_, v))) return;
    system_.acceleration(time, x, v, a_);
    x_ = x;
    if (velocityDependent()) v_ = v;
  }

  BodySystem system_;
  bool remember_;
  NodeVectors x_, v_, a_;
};

}  // namespace ringwatch
