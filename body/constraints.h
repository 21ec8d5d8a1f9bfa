#pragma once
#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <ringwatch/base/error.h>
#include <ringwatch/body/rigid_body.h>
#include <ringwatch/meshes/mesh.h>

namespace ringwatch {

/// Counts the changes of the object that it is a member of. Assignment to that object counts as a change, so that the
/// number grows with every change and never returns to a value that it had.
class ChangeCount {
 public:
  ChangeCount() = default;
  ChangeCount(const ChangeCount&) = default;
  ChangeCount& operator=(const ChangeCount& other) {
    value_ = std::max(value_, other.value_) + 1;
    return *this;
  }
  ~ChangeCount() = default;
  void add() { ++value_; }
  std::int64_t value() const { return value_; }

 private:
  std::int64_t value_ = 0;
};

/// Degrees of freedom that do not follow forces: fixed ones stay, moved ones run at a prescribed constant velocity.
/// Both leave the stability problem. Nodes that are tied follow forces together, as rigid bodies.
class Constraints {
 public:
  explicit Constraints(std::size_t nodeCount)
      : constrained_(3 * nodeCount, 0), velocity_(NodeVectors::Zero(3, nodeCount)) {}

  /// Fixes a component (0, 1, 2) of a node.
  void fix(std::int32_t node, int component) { move(node, component, 0.0); }
  void fix(std::int32_t node) {
    for (int c = 0; c < 3; ++c) fix(node, c);
  }
  /// Moves a component of a node at `velocity`, m/s. Throws InputError for a node that is tied.
  void move(std::int32_t node, int component, double velocity) {
    if (isTied(node)) throw InputError(joinText("node ", node, " is of a rigid body: its motion cannot be prescribed"));
    const std::int64_t i = 3 * std::int64_t{node} + component;
    if (!constrained_[i]) {
      version_.add();
      constrained_[i] = 1;
      components_.push_back(i);
    }
    velocity_(component, node) = velocity;
    moving_ = moving_ || velocity != 0;
  }

  /// Ties nodes to a rigid body. Those of a body whose guide leaves nothing free follow their constraints instead,
  /// which they must have. Throws InputError for a node of another body, for one whose motion is prescribed, and for
  /// one of a body without freedom whose motion is not.
  void tie(RigidBody body) {
    const int free = body.guide().all() ? 0 : 3;
    for (const std::int32_t node : body.nodes())
      if (freeComponents(node) != free || isTied(node))
        throw InputError(joinText("rigid body ", body.name(), ": node ", node,
                                  isTied(node) ? " is of another rigid body"
                                  : free == 0  ? " has no prescribed motion"
                                               : " has a prescribed motion"));
    if (free == 0) {
      prescribedBodies_.push_back(std::move(body));
      return;
    }
    tied_.resize(constrained_.size() / 3, 0);
    for (const std::int32_t node : body.nodes()) tied_[static_cast<std::size_t>(node)] = 1;
    moving_ = moving_ || body.guide().moves();
    rigidBodies_.push_back(std::move(body));
    version_.add();
  }
  /// Those with nodes that are tied.
  const std::vector<RigidBody>& rigidBodies() const { return rigidBodies_; }
  /// Those of which nothing is free.
  const std::vector<RigidBody>& prescribedBodies() const { return prescribedBodies_; }
  /// One of either, by its name.
  const RigidBody& rigidBody(const std::string& name) const {
    for (const std::vector<RigidBody>* bodies : {&rigidBodies_, &prescribedBodies_})
      for (const RigidBody& body : *bodies)
        if (body.name() == name) return body;
    throw InputError(joinText("there is no rigid body ", name));
  }
  /// RigidBody::guideAt of the tied one with a name.
  void guide(const std::string& name, const Eigen::Vector3d& velocity, const Eigen::Vector3d& angularVelocity) {
    for (RigidBody& body : rigidBodies_)
      if (body.name() == name) body.guideAt(velocity, angularVelocity);
    moving_ = moving_ || !velocity.isZero(0) || !angularVelocity.isZero(0);
  }
  bool isTied(std::int32_t node) const { return !tied_.empty() && tied_[static_cast<std::size_t>(node)] != 0; }
  /// RigidBody::project of all: velocities at x become those of motions that are free where nodes are tied. Both 3×N.
  void projectTied(NodeVectorsView x, NodeVectors& v) const {
    for (const RigidBody& body : rigidBodies_) body.project(x, v);
  }
  /// RigidBody::impose of all.
  void imposeTied(NodeVectorsView x, NodeVectors& v) const {
    for (const RigidBody& body : rigidBodies_) body.impose(x, v);
  }

  /// Whether single components are constrained.
  bool any() const { return !components_.empty(); }
  /// Whether components or rigid bodies are moved.
  bool moving() const { return moving_; }
  bool isConstrained(std::int32_t node, int component) const {
    return constrained_[3 * static_cast<std::size_t>(node) + static_cast<std::size_t>(component)] != 0;
  }
  /// The constrained components, 3 * node + component, in the order in which they were constrained.
  const std::vector<std::int64_t>& components() const { return components_; }
  /// Components of a node that follow forces, 0 to 3.
  int freeComponents(std::int32_t node) const {
    return 3 - isConstrained(node, 0) - isConstrained(node, 1) - isConstrained(node, 2);
  }
  /// Grows whenever the set of free components or of tied nodes changes; prescribed velocities do not count.
  std::int64_t version() const { return version_.value(); }
  /// Prescribed velocities, 3×N, m/s; zero where nothing is prescribed.
  const NodeVectors& velocity() const { return velocity_; }

  /// Zeroes the constrained components of a 3×N array.
  void clearConstrained(NodeVectors& values) const {
    for (const std::int64_t i : components_) values.data()[i] = 0;
  }
  /// Gives constrained components of a velocity field their prescribed values.
  void imposeVelocity(NodeVectors& v) const {
    for (const std::int64_t i : components_) v.data()[i] = velocity_.data()[i];
  }

 private:
  std::vector<std::uint8_t> constrained_;  // a flag for every component of every node
  std::vector<std::int64_t> components_;   // those that are set
  NodeVectors velocity_;
  std::vector<std::uint8_t> tied_;  // a flag for every node; empty without rigid bodies
  std::vector<RigidBody> rigidBodies_, prescribedBodies_;
  bool moving_ = false;
  ChangeCount version_;
};

}  // namespace ringwatch
