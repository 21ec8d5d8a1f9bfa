#pragma once
#include <array>
#include <optional>
#include <vector>

#include <ringwatch/body/body.h>
#include <ringwatch/body/discrete_forces.h>

namespace ringwatch {

/// Energies at one state, J.
struct Energies {
  double kinetic = 0;
  double strain = 0;
  double externalWork = 0;  // by dead forces and by prescribed motion, since the start
  double balanceError = 0;  // kinetic + strain + dissipated - externalWork - (kinetic + strain at the start)
  double dissipated = 0;    // by damping, since the start
};

/// Energy of the whole body, J, below which there is rounding, whose changes are as large as itself: that at a strain
/// of 1e-12, or what the law's own rounding makes of such a strain. Collective (body/domain.h).
double roundingEnergy(const Body& body);

/// The energy balance of a run. Prescribed motion does work ∫ f · dx, f the internal force at moved nodes, summed by
/// the trapezoidal rule, and along the guide of a rigid body that of the forces on it; dead forces do f · (x - x at the
/// start). Damping takes ∫ d · dx, d the damping force, by the same rule; what of it acts at moved nodes their support
/// has to bring up, as part of the force there. Moving obstacles do work on the nodes that they touch, of which what
/// goes through damping and friction is dissipated by their velocity against the nodes.
///
/// Central differences, whose kicks over h change velocities by -h M⁻¹ (f + d) from v₋ to v₊, take h d · (v₋ + v₊)/2 in
/// a kick. With half of the kick before a state and half after it, that is this trapezoidal rule, since x moves by h v₊
/// between two states. So where f is linear ½ v₋ · M v₊ + strain energy + dissipated - external work stays the same to
/// rounding, whatever the damping.
///
/// Of a part of a body (body/domain.h) it is that of the whole: works are summed along the run at each own node, and
/// over nodes exactly (Theorem 84, docs/theory/distribution.md), so that energies have the same bits for any partition.
class EnergyBalance {
 public:
  explicit EnergyBalance(const Body& body);

  /// Adds a state with its internal and damping force (3×N, N), which is read only where motion is prescribed. Call it
  /// at every step then, else whenever wanted; the first call is the start.
  void record(const NodeVectors& x, const NodeVectors& resistingForce);
  /// Adds positions (3×N, m) with the damping force there (3×N, N), as the integrator's kicks have it. Call it at every
  /// step of a damped run.
  void recordDamping(const NodeVectors& x, const NodeVectors& dampingForce);
  /// Adds a time (s) with the power of moving obstacles there, at the velocities of the kicks. Call it at every step of
  /// a run with them.
  void recordObstacles(double time, const DiscreteForces::ObstaclePower& power);
  /// Adds work, J, by a node, that record() does not know of.
  void addWork(std::int32_t node, double work) {
    if (node < owned_) work_[place(node)] += work;
  }
  /// Energies at the state that was recorded last: its positions x and velocities v (3×N, m and m/s), its strain energy
  /// (J), which a part of a body sums up itself. Collective.
  Energies energies(const NodeVectors& x, const NodeVectors& v, double strainEnergy);
  /// Both at once for a state whose force and strain energy are not known, by one pass over the elements; damping that
  /// was recorded there resists at supports too.
  Energies evaluate(const NodeVectors& x, const NodeVectors& v);

  template <class Archive>
  void archive(Archive& a) {
    a(started_, hasReference_, work_, dissipated_, referenceEnergy_, dampedX_, dampingForce_, obstacles_, firstX_,
      supported_, guided_);
  }

 private:
  void recordGuided(const NodeVectors& x, const NodeVectors& resistingForce);

  std::int32_t place(std::int64_t node) const { return work_.size() > 1 ? static_cast<std::int32_t>(node) : 0; }
  /// Σ a·b over nodes, by place.
  Eigen::VectorXd products(const NodeVectors& a, const NodeVectors& b) const;
  /// energies() but for the balance error.
  Energies sums(const NodeVectors& x, const NodeVectors& v, double strainEnergy) const;
  Energies sumsOfParts(const NodeVectors& x, const NodeVectors& v) const;

  const Body& body_;
  std::int32_t owned_;  // nodes
  bool started_ = false, hasReference_ = false;
  double referenceEnergy_ = 0;
  Eigen::VectorXd work_, dissipated_;   // J, of all nodes together or, of a part, of each own one
  NodeVectors dampedX_, dampingForce_;  // of the last record; empty before it
  struct ObstaclePowerAt {
    double time;
    DiscreteForces::ObstaclePower power;
  };
  std::optional<ObstaclePowerAt> obstacles_;  // of the last record
  NodeVectors firstX_;
  /// Of the constrained components, in the order of Constraints::components(), at the last record.
  struct Supported {
    double x, force;
  };
  std::vector<Supported> supported_;
  /// Of the rigid bodies, in the order of Constraints::rigidBodies(), at the last record: the point of the guide, m,
  /// the rotation, and force and torque about the point that resist, N and N m.
  struct Guided {
    std::array<double, 3> point, force, torque;
    std::array<double, 9> rotation;
  };
  std::vector<Guided> guided_;
  StepEvaluation own_;
  Body::Workspace workspace_;
};

}  // namespace ringwatch
