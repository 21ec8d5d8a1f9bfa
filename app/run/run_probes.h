#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <ringwatch/app/run/run_result.h>
#include <ringwatch/app/scene/scene.h>
#include <ringwatch/integrators/body_system.h>
#include <ringwatch/monitor/metrics/metrics.h>
#include <ringwatch/monitor/step_limit.h>

namespace ringwatch {

/// What the [[probe]] of a scene and output.reactions tell of the states of a run, over cuts of its body.
///
/// The reaction at a component that [[fix]] or [[move]] hold is r = f_int(x) + f_damping(x, v) - f_ext + m ẍ, all at
/// the state, with ẍ the central second difference, over the step that is taken from there, of the prescribed position:
/// with it the lumped momentum changes in a step of symplectic Euler without damping by what loads and reactions give
/// it.
class RunProbes {
 public:
  /// All of them must outlive this. Throws InputError for a selection without nodes or elements.
  RunProbes(const Scene& scene, const Body& body, const StepRule& rule);

  /// Whether a row is due at the state before step k.
  bool due(std::int64_t k) const { return scene_.probed() && k % scene_.probeEvery == 0; }
  /// Whether that takes the internal force.
  bool needsForce(std::int64_t k) const { return (reacts_ || forced_) && due(k); }
  /// The body is another one from here on. Throws InputError as the constructor.
  void follow();

  /// The columns of probes.csv behind `step` and `time_s`.
  const std::vector<ProbeColumn>& columns() const { return columns_; }
  /// The first row of probes.csv.
  std::string heading() const;
  /// The row of a state, whose velocity may not lag, before step k of h seconds. internalForce: as of Body::evaluate,
  /// 3×N, N, that of elements that damp in it, where needsForce(k).
  std::string row(std::int64_t k, const State& state, double h, const NodeVectors& internalForce, BodySystem& system);

 private:
  struct Target {
    std::vector<std::int32_t> nodes;
    std::vector<ElementRef> elements;
    Eigen::VectorXd mass;  // kg, that the elements give to each node; of energies
  };
  void nameColumns();
  /// The reactions at all nodes and, by [[fix]] and then [[move]], at each section's.
  void react(const State& state, double h, const NodeVectors& internalForce, BodySystem& system);
  void addValues(const Scene::Probe& probe, const Target& target, const State& state, double h,
                 std::vector<double>& values);
  /// Force, or torque about its centre, on a rigid body, as of the forces that were summed for the row.
  void addOfRigidBody(const Scene::Probe& probe, const State& state, double h, std::vector<double>& values) const;
  /// What holds or moves a rigid body puts on it, of the forces that were summed for a row before a step of h seconds.
  RigidBody::Load supportOf(const RigidBody& rigid, const State& state, double h) const;
  const MetricValues& metric(const std::string& name, NodeVectorsView x);

  const Scene& scene_;
  const Body& body_;
  const StepRule& rule_;
  bool reacts_ = false, forced_ = false;  // reactions, or forces on rigid bodies, are wanted
  std::vector<Target> targets_;           // of the probes
  std::vector<ProbeColumn> columns_;
  std::vector<std::int32_t> supports_;  // [3 * node + component]: the section that holds it, fixes first; -1: none
  NodeVectors reaction_, dampingForce_, force_;
  std::vector<Eigen::Vector3d> ofSections_;
  std::map<std::string, std::unique_ptr<MetricEvaluator>> metrics_;
  std::map<std::string, const MetricValues*> evaluated_;  // at the state of a row
  std::vector<std::vector<double>> strain_;               // J, of the elements at the state of a row; empty: not known
  std::vector<std::size_t> first_;                        // element of each block, for stresses
  std::vector<double> volume_;                            // m³, at rest, of all elements; likewise
  std::int64_t bodyVersion_ = -1;
};

}  // namespace ringwatch
