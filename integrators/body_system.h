#pragma once
#include <ringwatch/body/body.h>
#include <ringwatch/integrators/integrator.h>

namespace ringwatch {

/// A body as a second-order system: m a = external force - internal force(x); constrained components get a = 0, so that
/// their prescribed velocity stays what it is in every scheme.
class BodySystem final : public SecondOrderSystem {
 public:
  explicit BodySystem(const Body& body) : body_(body), inverseMass_(body.lumpedMass().cwiseInverse()) {}

  void acceleration(double, const NodeVectors& x, const NodeVectors&, NodeVectors& a) override {
    body_.internalForce(x, internalForce_, workspace_);
    a = (body_.externalForce() - internalForce_) * inverseMass_.asDiagonal();
    body_.constraints().clearConstrained(a);
  }
  /// Internal force of the last evaluation, 3×N, N: an observer need not compute it again.
  const NodeVectors& lastInternalForce() const { return internalForce_; }

  const Body& body() const { return body_; }
  /// At rest in the reference configuration, constrained components already moving.
  State initialState() const {
    State state;
    state.x = body_.mesh().X;
    state.v = NodeVectors::Zero(3, state.x.cols());
    body_.constraints().imposeVelocity(state.v);
    return state;
  }

 private:
  const Body& body_;
  Eigen::VectorXd inverseMass_;
  NodeVectors internalForce_;
  Body::Workspace workspace_;
};

}  // namespace ringwatch
