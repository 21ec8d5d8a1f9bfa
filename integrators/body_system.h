#pragma once
#include <ringwatch/body/body.h>
#include <ringwatch/body/discrete_forces.h>
#include <ringwatch/body/domain.h>
#include <ringwatch/integrators/integrator.h>

namespace ringwatch {

/// The diagonal block of row i, N/m.
inline const Eigen::Matrix3d& diagonalBlock(const BlockMatrix& K, std::size_t i) {
  std::size_t k = K.rowBegin[i];
  while (K.column[k] != static_cast<std::int32_t>(i)) ++k;  // every row holds its diagonal
  return K.block[k];
}

/// A body as a second-order system: m a = external force - internal force(x) - (alpha M + beta K(x)) v - what elements
/// that damp, dashpots, viscous contact and friction of its discrete forces resist with; constrained components get a =
/// 0, so that their prescribed velocity stays what it is in every scheme. Nodes of rigid bodies get the accelerations
/// of a rigid motion, without those that turning takes, which findTiedMotion() has. K is the exact tangent at x. Ghosts
/// of a part of a body (body/domain.h) get a = 0: they go where their owners say, by an exchange after each step.
class BodySystem final : public DifferentiableSystem {
 public:
  /// The body must outlive the system; call followMasses() where its masses change.
  explicit BodySystem(const Body& body, const RayleighDamping& damping = {})
      : body_(body), damping_(damping), inverseMass_(body.lumpedMass().cwiseInverse().transpose()) {}

  void acceleration(double, const NodeVectors& x, const NodeVectors& v, NodeVectors& a) override {
    const NodeVectors& at = body_.domain().withGhosts(x);
    prepare(at, v, a, true);
    body_.resistingForce(at, v, internalForce_, workspace_,
                         [&](std::int64_t begin, std::int64_t end) { accelerate(internalForce_, a, begin, end); });
    constrain(at, a);
  }
  /// The acceleration where the internal force at x (3×N, N) is known, as from Body::evaluate. withElementDamping: it
  /// has the damping force of elements in it (StepEvaluation::velocities).
  void accelerationOfForce(const NodeVectors& internalForce, const NodeVectors& x, const NodeVectors& v, NodeVectors& a,
                           bool withElementDamping = false) {
    prepare(x, v, a, withElementDamping);
    parallelParts(a.cols(), threads(), nodesOfAThread,
                  [&](std::int64_t begin, std::int64_t end) { accelerate(internalForce, a, begin, end); });
    constrain(x, a);
  }
  /// Gives a state its acceleration from an evaluation of the body at its positions, and ends a step of
  /// Integrator::advance with it: one pass over the elements serves the scheme and whatever else was asked for.
  void complete(State& state, const StepEvaluation& evaluation) {
    accelerationOfForce(evaluation.internalForce, state.x, state.v, state.a, evaluation.velocities != nullptr);
    ringwatch::complete(*this, state);
  }
  bool tiesNodes() const override { return !body_.constraints().rigidBodies().empty(); }
  bool findTiedMotion(const State& state, double kick, const NodeVectors& a, double h) override {
    const std::vector<RigidBody>& bodies = body_.constraints().rigidBodies();
    tied_.resize(bodies.size());
    for (std::size_t r = 0; r < bodies.size(); ++r)
      if (!bodies[r].drift(state.x, state.v, kick, a, h, tied_[r].x, tied_[r].v)) return false;
    return true;
  }
  void placeTiedNodes(State& state) override {
    const std::vector<RigidBody>& bodies = body_.constraints().rigidBodies();
    for (std::size_t r = 0; r < bodies.size(); ++r)
      for (std::size_t k = 0; k < bodies[r].nodes().size(); ++k) {
        state.x.col(bodies[r].nodes()[k]) = tied_[r].x.col(static_cast<Eigen::Index>(k));
        state.v.col(bodies[r].nodes()[k]) = tied_[r].v.col(static_cast<Eigen::Index>(k));
      }
  }
  /// Damping force at x, C v and friction, 3×N, N.
  void dampingForce(const NodeVectors& x, const NodeVectors& v, NodeVectors& force) {
    dampingForceBesideElements(x, v, force);
    addElementDampingForce(x, v, force);
  }
  /// Adds the damping force of elements (Body::setElementDamping).
  void addElementDampingForce(const NodeVectors& x, const NodeVectors& v, NodeVectors& force) {
    body_.addElementDampingForce(x, v, force, workspace_);
  }
  /// The same without the damping force of elements.
  void dampingForceBesideElements(const NodeVectors& x, const NodeVectors& v, NodeVectors& force) {
    if (damping_.beta != 0) {
      const bool whole = body_.domain().whole();
      if (!whole) body_.domain().exchange(withGhosts_ = v);
      body_.tangentProduct(x, whole ? v : withGhosts_, force, workspace_, 0.0);
    } else
      force.setZero(3, x.cols());
    force = damping_.beta * force + damping_.alpha * v * body_.lumpedMass().asDiagonal();
    if (const DiscreteForces* discrete = body_.discreteForces()) discrete->addDampingForce(x, v, force);
  }
  /// Takes the masses of the body as they are now; an acceleration that is known of a state holds no longer.
  void followMasses() { inverseMass_ = body_.lumpedMass().cwiseInverse().transpose(); }
  int threads() const override { return body_.threads(); }
  bool velocityDependent() const override { return dampedBesideElements() || body_.elementDamping(); }
  const Eigen::VectorXd& mass() const override { return body_.lumpedMass(); }
  RayleighDamping damping() const override { return damping_; }
  void stiffnessProduct(const NodeVectors& x, const NodeVectors& u, NodeVectors& Ku) override {
    body_.tangentProduct(x, u, Ku, workspace_, 0.0);
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

  const Body& body() const { return body_; }
  /// The body at rest in the reference configuration, what is constrained or guided already moving.
  State initialState() const {
    State state;
    state.x = body_.mesh().X;
    state.v = NodeVectors::Zero(3, state.x.cols());
    body_.constraints().imposeVelocity(state.v);
    body_.constraints().imposeTied(state.x, state.v);
    return state;
  }

 private:
  bool dampedBesideElements() const {
    return damping_.any() || (body_.discreteForces() && body_.discreteForces()->damped());
  }
  /// withElementDamping: that of elements is in the internal force.
  void prepare(const NodeVectors& x, const NodeVectors& v, NodeVectors& a, bool withElementDamping) {
    addsDamping_ = dampedBesideElements() || (body_.elementDamping() && !withElementDamping);
    if (addsDamping_ && withElementDamping) dampingForceBesideElements(x, v, dampingForce_);
    if (addsDamping_ && !withElementDamping) dampingForce(x, v, dampingForce_);
    a.resize(3, x.cols());
  }
  /// The accelerations of some nodes, constraints aside.
  void accelerate(const NodeVectors& internalForce, NodeVectors& a, std::int64_t begin, std::int64_t end) const {
    const auto slice = [=](auto& vectors) { return vectors.middleCols(begin, end - begin); };
    const auto force = slice(body_.externalForce()) - slice(internalForce);
    if (addsDamping_)
      slice(a) = (force - slice(dampingForce_)) * slice(inverseMass_).asDiagonal();
    else
      slice(a) = force * slice(inverseMass_).asDiagonal();
  }

  /// Accelerations as constraints and rigid bodies leave them.
  void constrain(const NodeVectors& x, NodeVectors& a) const {
    body_.constraints().clearConstrained(a);
    body_.constraints().projectTied(x, a);
    // Ghosts go where their owners say.
    a.rightCols(a.cols() - body_.domain().owned(a.cols())).setZero();
  }

  struct TiedMotion {
    NodeVectors x, v;
  };

  const Body& body_;
  std::vector<TiedMotion> tied_;  // of each rigid body, of its nodes
  RayleighDamping damping_;
  Eigen::RowVectorXd inverseMass_;
  NodeVectors internalForce_, dampingForce_, withGhosts_;
  bool addsDamping_ = false;  // dampingForce_ is not in the internal force and counts
  Body::Workspace workspace_;
  SparseTangent tangent_;
};

}  // namespace ringwatch
