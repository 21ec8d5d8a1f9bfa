#pragma once
#include <ringwatch/body/body.h>
#include <ringwatch/integrators/integrator.h>

namespace ringwatch {

/// The diagonal block of row i, N/m.
inline const Eigen::Matrix3d& diagonalBlock(const BlockMatrix& K, std::size_t i) {
  auto k = static_cast<std::size_t>(K.rowBegin[i]);
  while (K.column[k] != static_cast<std::int32_t>(i)) ++k;  // every row holds its diagonal
  return K.block[k];
}

/// A body as a second-order system: m a = external force - internal force(x) - (alpha M + beta K(x)) v; constrained
/// components get a = 0, so that their prescribed velocity stays what it is in every scheme. K is the exact tangent at
/// x.
class BodySystem final : public DifferentiableSystem {
 public:
  /// The body must outlive the system.
  explicit BodySystem(const Body& body, const RayleighDamping& damping = {})
      : body_(body), damping_(damping), inverseMass_(body.lumpedMass().cwiseInverse()) {}

  void acceleration(double, const NodeVectors& x, const NodeVectors& v, NodeVectors& a) override {
    if (!taken_) body_.internalForce(x, internalForce_, workspace_);
    taken_ = false;
    if (!damping_.any()) {
      a = (body_.externalForce() - internalForce_) * inverseMass_.asDiagonal();  // in one pass
    } else {
      if (damping_.beta != 0)
        body_.tangentProduct(x, v, dampingForce_, workspace_);
      else
        dampingForce_.setZero(3, x.cols());
      dampingForce_ = damping_.beta * dampingForce_ + damping_.alpha * v * body_.lumpedMass().asDiagonal();
      a = (body_.externalForce() - internalForce_ - dampingForce_) * inverseMass_.asDiagonal();
    }
    body_.constraints().clearConstrained(a);
  }
  /// Takes over the internal force, 3×N, N, at the positions of the next call of acceleration, which then does not
  /// compute it: what StabilityMonitor::observe hands out. `force` gets an older array in exchange.
  void takeForce(NodeVectors& force) {
    internalForce_.swap(force);
    taken_ = true;
  }
  bool velocityDependent() const override { return damping_.any(); }
  const Eigen::VectorXd& mass() const override { return body_.lumpedMass(); }
  RayleighDamping damping() const override { return damping_; }
  void stiffnessProduct(const NodeVectors& x, const NodeVectors& u, NodeVectors& Ku) override {
    body_.tangentProduct(x, u, Ku, workspace_);
  }
  Eigen::SparseMatrix<double> stiffness(const NodeVectors& x) override {
    body_.assembleTangent(x, tangent_);
    return tangent_.matrix;
  }
  void stiffnessDiagonal(const NodeVectors& x, std::vector<Eigen::Matrix3d>& blocks) override {
    body_.assembleBlocks(x, tangent_.blocks);
    blocks.resize(tangent_.blocks.rowBegin.size() - 1);
    for (std::size_t i = 0; i < blocks.size(); ++i) blocks[i] = diagonalBlock(tangent_.blocks, i);
  }
  bool isConstrained(std::int32_t node, int component) const override {
    return body_.constraints().isConstrained(node, component);
  }
  /// Internal force of the last evaluation, 3×N, N: an observer need not compute it again. Without the damping force.
  const NodeVectors& lastInternalForce() const { return internalForce_; }
  /// Damping force C v of the last evaluation, 3×N, N; empty without damping.
  const NodeVectors& lastDampingForce() const { return dampingForce_; }

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
  RayleighDamping damping_;
  Eigen::VectorXd inverseMass_;
  NodeVectors internalForce_, dampingForce_;
  bool taken_ = false;
  Body::Workspace workspace_;
  SparseTangent tangent_;
};

}  // namespace ringwatch
