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

/// Energy of the whole body at a strain of 1e-12, J. Less is rounding, whose changes are as large as itself. Collective
/// (body/domain.h).
double roundingEnergy(const Body& body);

/// The energy balance of a run. Prescribed motion does work ∫ f · dx, f the internal force at moved nodes, summed by
/// the trapezoidal rule, and along the guide of a rigid body that of the forces on it; dead forces do f · (x - x at the
/// start). Damping takes ∫ v · C v dt, by the same rule; what of it acts at moved nodes their support has to bring up,
/// as work of its own. Moving obstacles do work on the nodes that they touch, of which what goes through damping and
/// friction is dissipated by their velocity against the nodes.
///
/// Of a part of a body (body/domain.h) it is that of the whole: works are summed along the run at each own node, and
/// over nodes exactly (Theorem 84, docs/theory/distribution.md), so that energies have the same bits for any partition.
class EnergyBalance {
 public:
  explicit EnergyBalance(const Body& body);

  /// Adds a state with its internal force (3×N, N), which is read only where motion is prescribed. Call it at every
  /// step then, else whenever wanted; the first call is the start.
  void record(const NodeVectors& x, const NodeVectors& internalForce);
  /// Adds a time (s) with positions x, velocities v (3×N, m and m/s) and the damping force C v (3×N, N) there. Call it
  /// at every step of a damped run. inForce: power, W, of damping that is part of the internal force of record(), and
  /// of the work at supports with it.
  void recordDamping(double time, const NodeVectors& x, const NodeVectors& v, const NodeVectors& dampingForce,
                     double inForce = 0);
  /// Adds a time (s) with the power of moving obstacles there. Call it at every step of a run with them, as
  /// recordDamping.
  void recordObstacles(double time, const DiscreteForces::ObstaclePower& power);
  /// Adds work, J, by a node, that record() does not know of.
  void addWork(std::int32_t node, double work) {
    if (node < owned_) work_[place(node)] += work;
  }
  /// Energies at the state that was recorded last: its positions x and velocities v (3×N, m and m/s), its strain energy
  /// (J), which a part of a body sums up itself. Collective.
  Energies energies(const NodeVectors& x, const NodeVectors& v, double strainEnergy);
  /// Both at once for a state whose force and strain energy are not known: one pass over the elements.
  Energies evaluate(const NodeVectors& x, const NodeVectors& v);

  template <class Archive>
  void archive(Archive& a) {
    a(started_, hasReference_, work_, dissipated_, referenceEnergy_, damping_, obstacles_, firstX_, supported_,
      guided_);
  }

 private:
  void recordGuided(const NodeVectors& x, const NodeVectors& internalForce);

  std::int32_t place(std::int64_t node) const { return work_.size() > 1 ? static_cast<std::int32_t>(node) : 0; }
  /// Σ a·b over nodes, by place.
  Eigen::VectorXd power(const NodeVectors& a, const NodeVectors& b) const;
  /// energies() but for the balance error.
  Energies sums(const NodeVectors& x, const NodeVectors& v, double strainEnergy) const;
  Energies sumsOfParts(const NodeVectors& x, const NodeVectors& v) const;

  const Body& body_;
  std::int32_t owned_;  // nodes
  bool started_ = false, hasReference_ = false;
  double referenceEnergy_ = 0;
  Eigen::VectorXd work_, dissipated_;  // J, of all nodes together or, of a part, of each own one
  struct DampingPower {
    double time = 0;
    Eigen::VectorXd all, atSupports;  // W, likewise

    template <class Archive>
    void archive(Archive& a) {
      a(time, all, atSupports);
    }
  };
  std::optional<DampingPower> damping_;  // of the last record
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
