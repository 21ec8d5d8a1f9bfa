#pragma once
#include <ringwatch/distributed/rank_body.h>
#include <ringwatch/integrators/body_system.h>

namespace ringwatch {

/// The equations of motion at a rank's owned nodes; ghosts have no acceleration: they move as their owners say, by an
/// exchange after each step. For schemes of one force a step, which begin with the acceleration of the state.
class RankSystem final : public SecondOrderSystem {
 public:
  /// The part must outlive the system.
  explicit RankSystem(const RankBody& part, const RayleighDamping& damping = {})
      : part_(part), system_(part.body(), damping) {}

  void acceleration(double time, const NodeVectors& x, const NodeVectors& v, NodeVectors& a) override {
    system_.acceleration(time, x, v, a);
    stopGhosts(a);
  }
  /// The acceleration where the internal force at x is known; BodySystem's.
  void accelerationOfForce(const NodeVectors& internalForce, const NodeVectors& x, const NodeVectors& v,
                           NodeVectors& a) {
    system_.accelerationOfForce(internalForce, x, v, a);
    stopGhosts(a);
  }
  bool velocityDependent() const override { return system_.velocityDependent(); }
  int threads() const override { return system_.threads(); }
  BodySystem& ofBody() { return system_; }

 private:
  void stopGhosts(NodeVectors& a) const { a.rightCols(part_.ghostNodes()).setZero(); }

  const RankBody& part_;
  BodySystem system_;
};

}  // namespace ringwatch
