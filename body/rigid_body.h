#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <ringwatch/meshes/mesh.h>

namespace ringwatch {

/// Nodes that keep their distances: a rigid body, whose mass and inertia are those of its nodes, with six degrees of
/// freedom. It has no state of its own. Positions and velocities of its nodes, a rigid motion of where they are at
/// rest, tell centre, rotation and momenta, so that a state of nodes is all that a scheme and a checkpoint have to
/// hold.
class RigidBody {
 public:
  /// nodes: ascending. X: 3×N, m, where nodes are at rest. lumpedMass: N numbers, kg. Throws InputError for fewer than
  /// three nodes, and for nodes so near to one line that turning about it has next to no inertia.
  RigidBody(std::string name, std::vector<std::int32_t> nodes, NodeVectorsView X, const Eigen::VectorXd& lumpedMass);

  const std::string& name() const { return name_; }
  const std::vector<std::int32_t>& nodes() const { return nodes_; }
  double mass() const { return mass_; }  ///< kg
  /// About the centre of mass, where the nodes are at rest, kg m².
  const Eigen::Matrix3d& inertia() const { return inertia_; }

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

  /// Makes the velocities at its nodes those of the rigid motion with their linear and angular momentum: the rigid
  /// velocities that are nearest, in the norm of the masses. Of accelerations, those of the forces that they belong to.
  void project(NodeVectorsView x, NodeVectors& v) const;
  /// What the velocities that project() gives fall short of a rigid motion by at most, relative, in the norm of the
  /// masses. Theorem 62, docs/theory/rigid_bodies.md.
  double projectionRounding() const { return projectionRounding_; }

  /// Its nodes after h seconds of free motion with the momenta of the velocities v + kick · a, and its velocities
  /// there: the discrete Moser-Veselov equation (Theorem 63, docs/theory/rigid_bodies.md). kick: s. One column a node,
  /// in the order of nodes(). False where it would turn by more than a right angle or so, for which the equation has no
  /// solution; then nothing is written.
  bool drift(NodeVectorsView x, NodeVectorsView v, double kick, NodeVectorsView a, double h, NodeVectors& positions,
             NodeVectors& velocities) const;

 private:
  Eigen::Vector3d centreOf(NodeVectorsView x) const;
  Eigen::Matrix3d rotationOf(NodeVectorsView x, const Eigen::Vector3d& centre) const;
  /// Σ m s sᵀ of the arms s of the nodes, about the centre.
  Eigen::Matrix3d secondMoment(NodeVectorsView x, const Eigen::Vector3d& centre) const;

  std::string name_;
  std::vector<std::int32_t> nodes_;
  std::vector<double> masses_;  // kg
  NodeVectors arms_;            // at rest, from the centre of mass, m
  double mass_ = 0, projectionRounding_ = 0;
  Eigen::Matrix3d inertia_;
};

}  // namespace ringwatch
