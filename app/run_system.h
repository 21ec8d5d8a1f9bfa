#pragma once
#include <ringwatch/integrators/body_system.h>

namespace ringwatch {

/// A body as a system that remembers its last evaluation: when the energy books or the integrator ask for the force at
/// positions where the other one has just had it, it is not computed again, whichever scheme runs.
class RunSystem final : public DifferentiableSystem {
 public:
  /// remember: false passes every call through, for runs that keep no energy books.
  RunSystem(const Body& body, bool remember) : system_(body), remember_(remember) {}

  void acceleration(double time, const NodeVectors& x, const NodeVectors& v, NodeVectors& a) override {
    if (!remember_) {
      system_.acceleration(time, x, v, a);
      return;
    }
    evaluate(time, x, v);
    a = a_;
  }
  /// Internal force at x, 3×N, N. Only when remembering.
  const NodeVectors& internalForce(double time, const NodeVectors& x, const NodeVectors& v) {
    evaluate(time, x, v);
    return system_.lastInternalForce();
  }
  State initialState() const { return system_.initialState(); }

  const Eigen::VectorXd& mass() const override { return system_.mass(); }
  void stiffnessProduct(const NodeVectors& x, const NodeVectors& u, NodeVectors& Ku) override {
    system_.stiffnessProduct(x, u, Ku);
  }
  Eigen::SparseMatrix<double> stiffness(const NodeVectors& x) override { return system_.stiffness(x); }
  bool isConstrained(std::int32_t node, int component) const override { return system_.isConstrained(node, component); }

 private:
  void evaluate(double time, const NodeVectors& x, const NodeVectors& v) {
    // Bit by bit: forces depend on positions alone, and NaN never equals itself.
    if (x_.size() == x.size() && (x_.array() == x.array()).all()) return;
    system_.acceleration(time, x, v, a_);
    x_ = x;
  }

  BodySystem system_;
  bool remember_;
  NodeVectors x_, a_;
};

}  // namespace ringwatch
