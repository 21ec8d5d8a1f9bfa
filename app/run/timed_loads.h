#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include <ringwatch/app/scene/scene.h>
#include <ringwatch/app/scene/scene_pressure.h>
#include <ringwatch/integrators/integrator.h>
#include <ringwatch/monitor/energy_balance.h>

namespace ringwatch {

/// The forces and motions of a scene that follow tables or expressions of time, its rotations, pressures and moving
/// obstacles, on its body. Forces have the value of the time of a state; a prescribed velocity has its mean over the
/// step to come, so that positions at the ends of steps are exact.
class TimedLoads {
 public:
  /// The body of the scene, with its constant loads. Both must outlive this.
  TimedLoads(const Scene& scene, Body& body);
  /// Those of a part of that body, whose nodes have these numbers in the whole; without pressures and obstacles. The
  /// part must outlive this, the body of the whole need not.
  TimedLoads(const TimedLoads& whole, Body& part, std::span<const std::int32_t> globalNodes);

  bool any() const { return !forces_.empty() || !motions_.empty() || !pressures_.empty() || scene_.movesObstacles(); }
  /// Kinetic energy, J, that the forces at their largest give the loaded nodes in a step of h seconds, and that of the
  /// moved nodes at their largest velocity: where a load begins with nothing, energies below that are no measure of a
  /// balance whose work is summed from state to state. Collective (body/domain.h).
  double energyScale(double h) const;
  /// The work of the forces counts from a state on.
  void begin(const NodeVectors& x);
  /// Puts obstacles where they are at a time (s), and sets the body's forces to those of that time at positions x (3×N,
  /// m). Adds to the balance what the work of the forces, by the trapezoidal rule from state to state, has gained on
  /// `force now · displacement since begin()`: the work that it knows.
  void setForces(double time, const NodeVectors& x, EnergyBalance& balance);
  /// Sets the prescribed velocities, of body and state, for the step from its time of h seconds. Adds the kinetic
  /// energy that the supports give to the balance.
  void setVelocities(State& state, double h, EnergyBalance& balance);

  template <class Archive>
  void archive(Archive& a) {
    a(first_, last_);
  }

 private:
  struct Force {
    std::vector<Eigen::Vector3d> values;  // N, at the nodes of `nodes_` with the same place; zero elsewhere
    const TimeTable* table;
  };
  struct Pressure {
    std::vector<PressedFace> faces;
    const Scene::Pressure* load;
  };
  struct Motion {
    std::vector<std::int32_t> nodes;
    const Scene::Move* move;
    bool guided;  // of a rigid body with some freedom
  };
  void guide(const Motion& motion, State& state, double h, EnergyBalance& balance);

  const Scene& scene_;
  Body& body_;
  std::vector<std::int32_t> nodes_;        // loaded, ascending
  std::vector<std::int32_t> placeOf_;      // of a node in nodes_; empty without pressures
  std::vector<Eigen::Vector3d> constant_;  // N, that is always there
  std::vector<Force> forces_;
  std::vector<Pressure> pressures_;
  std::vector<Motion> motions_;
  std::vector<Eigen::Vector3d> first_, last_;  // positions of the loaded nodes, m
};

}  // namespace ringwatch
