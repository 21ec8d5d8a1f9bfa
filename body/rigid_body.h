#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <ringwatch/meshes/mesh.h>

namespace ringwatch {

/// What is prescribed of the motion of a rigid body: the velocity of one of its points, in some components, and how it
/// turns.
struct RigidGuide {
  enum class Turning {
    free,
    aboutAxis,   ///< about `axis` alone, freely
    prescribed,  ///< with `angularVelocity`
  };
  std::array<bool, 3> components{};  ///< of the point's velocity that are prescribed
  Turning turning = Turning::free;
  Eigen::Vector3d axis = Eigen::Vector3d::Zero();  ///< in space, of any length, where it turns about one
  /// The point at rest, m; empty: the centre of mass. Another one goes with all three components, and stays where it is
  /// unless the turning is prescribed too.
  std::optional<Eigen::Vector3d> point = {};
  /// What is prescribed now, m/s and rad/s; zero in what is not.
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero(), angularVelocity = Eigen::Vector3d::Zero();

  bool holdsPoint() const { return components[0] && components[1] && components[2]; }
  bool any() const { return components[0] || components[1] || components[2] || turning != Turning::free; }
  /// Whether nothing of the motion is free.
  bool all() const { return holdsPoint() && turning == Turning::prescribed; }
  bool moves() const { return !velocity.isZero(0) || !angularVelocity.isZero(0); }
};

/// Nodes that keep their distances: a rigid body, whose mass and inertia are those of its nodes, with six degrees of
/// freedom. It has no state of its own. Positions and velocities of its nodes, a rigid motion of where they are at
/// rest, tell centre, rotation and momenta, so that a state of nodes is all that a scheme and a checkpoint have to
/// hold.
class RigidBody {
 public:
  /// nodes: ascending. X: 3×N, m, where nodes are at rest. lumpedMass: N numbers, kg. Throws InputError for fewer than
  /// three nodes, for nodes so near to one line that turning about it has next to no inertia, and for a guide without
  /// direction of its axis or with a point that does not go with the rest.
  RigidBody(std::string name, std::vector<std::int32_t> nodes, NodeVectorsView X, const Eigen::VectorXd& lumpedMass,
            RigidGuide guide = {});

  const std::string& name() const { return name_; }
  const std::vector<std::int32_t>& nodes() const { return nodes_; }
  double mass() const { return mass_; }  ///< kg
  /// About the centre of mass, where the nodes are at rest, kg m².
  const Eigen::Matrix3d& inertia() const { return inertia_; }
  const RigidGuide& guide() const { return guide_; }
  /// Prescribes other velocities, m/s and rad/s, of what is prescribed.
  void guideAt(const Eigen::Vector3d& velocity, const Eigen::Vector3d& angularVelocity);

  /// Where it is and how it moves.
  struct Motion {
    Eigen::Vector3d centre;                            ///< of mass, m
    Eigen::Matrix3d rotation;                          ///< from rest
    Eigen::Vector3d velocity;                          ///< of the centre, m/s
    Eigen::Vector3d angularVelocity, angularMomentum;  ///< rad/s; about the centre, kg m²/s
  };
  Motion motion(NodeVectorsView x, NodeVectorsView v) const;
  /// Force and torque about the centre of mass, N and N m, of forces at the nodes, 3×N.
  struct Load {
    Eigen::Vector3d force, torque;
  };
  Load load(NodeVectorsView x, NodeVectorsView forces) const;
  /// About a point, m.
  Load loadAbout(const Eigen::Vector3d& about, NodeVectorsView x, NodeVectorsView forces) const;
  Eigen::Vector3d point(NodeVectorsView x) const;     ///< where that of the guide is, m
  Eigen::Matrix3d rotation(NodeVectorsView x) const;  ///< from rest
  /// Force, N, and torque about the point of the guide, N m, by which what holds or moves the body keeps to the guide,
  /// where the forces at the nodes are these, 3×N, at velocities v. acceleration, angularAcceleration: of what is
  /// prescribed, m/s² and rad/s².
  Load support(NodeVectorsView x, NodeVectorsView v, NodeVectorsView forces, const Eigen::Vector3d& acceleration,
               const Eigen::Vector3d& angularAcceleration) const;

  /// Makes the velocities at its nodes those of the motion that the guide leaves free, with the momenta that go with
  /// it: the nearest ones, in the norm of the masses. Of accelerations, those of the forces that they belong to.
  /// Without a guide momenta stay.
  void project(NodeVectorsView x, NodeVectors& v) const;
  /// The same with what is prescribed as it is now: the nearest velocities that the body may have.
  void impose(NodeVectorsView x, NodeVectors& v) const;
  /// What the velocities that project() gives fall short of a rigid motion by at most, relative, in the norm of the
  /// masses. Theorem 62, docs/theory/rigid_bodies.md.
  double projectionRounding() const { return projectionRounding_; }

  /// Its nodes after h seconds of motion without forces, with the momenta of the velocities v + kick · a, and its
  /// velocities there: the discrete Moser-Veselov equation (Theorem 63, docs/theory/rigid_bodies.md), what is
  /// prescribed as it is now (Theorem 91). kick: s. One column a node, in the order of nodes(). False where it would
  /// turn by more than a right angle or so, for which the equation has no solution; then nothing is written.
  bool drift(NodeVectorsView x, NodeVectorsView v, double kick, NodeVectorsView a, double h, NodeVectors& positions,
             NodeVectors& velocities) const;

 private:
  Eigen::Vector3d pointOf(NodeVectorsView x, const Eigen::Vector3d& centre) const;
  /// Σ m v and Σ s × m v about a point, v(k) that of node number k of the body.
  template <class Velocity>
  void momenta(NodeVectorsView x, const Eigen::Vector3d& about, const Velocity& v, Eigen::Vector3d& linear,
               Eigen::Vector3d& angular) const;
  /// Velocity of the point with this momentum, zero in what is prescribed.
  Eigen::Vector3d freeVelocity(const Eigen::Vector3d& momentum) const;
  /// Angular velocity with this angular momentum about the point, where turning is free or about an axis; else zero.
  Eigen::Vector3d freeTurning(const Eigen::Vector3d& angularMomentum, const Eigen::Matrix3d& inertia) const;
  Eigen::Vector3d centreOf(NodeVectorsView x) const;
  Eigen::Matrix3d rotationOf(NodeVectorsView x, const Eigen::Vector3d& centre) const;
  /// Σ m s sᵀ of the arms s of the nodes from a point.
  Eigen::Matrix3d secondMoment(NodeVectorsView x, const Eigen::Vector3d& from) const;

  std::string name_;
  std::vector<std::int32_t> nodes_;
  std::vector<double> masses_;  // kg
  NodeVectors arms_;            // at rest, from the centre of mass, m
  double mass_ = 0, projectionRounding_ = 0;
  Eigen::Matrix3d inertia_;
  RigidGuide guide_;
  Eigen::Vector3d pointArm_;  // of the guide's point, as arms_
};

}  // namespace ringwatch
