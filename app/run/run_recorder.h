#pragma once
#include <cstdint>
#include <vector>

#include <ringwatch/app/run/run_result.h>
#include <ringwatch/app/scene/scene.h>

namespace ringwatch {

/// How narrow a bracket is wanted of the reasons of a run of so many steps (CriticalStepOptions::width): as narrow as
/// usual where the search takes at most a tenth of the work of the steps, or next to nothing.
double widthOfReasons(const Body& body, std::int64_t steps);

/// Writes what a run observes and does into its result.
class RunRecorder {
 public:
  /// Scene and result must outlive the recorder.
  RunRecorder(const Scene& scene, RunResult& result) : scene_(scene), result_(result) {}

  /// The mesh from here on, whose blocks name their materials.
  void follow(const Mesh& mesh);
  /// A report of the monitor, before a step from its state: its events, and which material limits the bracket.
  void record(const MonitorReport& report, const Mesh& mesh);
  /// What springs and contact are like at the state x of a report, where there are any.
  void recordDiscrete(const MonitorReport& report, const Body& body, NodeVectorsView x);
  /// Why the step is small at the state of a report, where it is the least so far. Keeps that state.
  void recordReasons(const MonitorReport& report, const Body& body, const State& state, const StepRule& rule);
  /// The bracket of the state that was kept, from scratch, and what would make its step larger; where cuts or erosion
  /// have changed the body since, nothing is known of it. The body then counts its damping for that step.
  void completeReasons(Body& body);
  /// The events alone, where no step is taken.
  void recordEvents(const MonitorReport& report, const Mesh& mesh);
  /// Steps of h (s) that were taken.
  void countSteps(std::int64_t taken, double h);
  /// What the monitor said of the steps that were taken; first: nothing but its first observation was known.
  void countVerdict(const MonitorReport& report, std::int64_t taken, bool first);
  /// Why the run is called neither stable nor certified, for its notes.
  void noteWhatIsNotCertified(const Mesh& mesh);

  /// The state that was kept, for a checkpoint without the memory of the parts.
  nlohmann::ordered_json save() const;
  void resume(const nlohmann::ordered_json& saved);
  template <class Archive>
  void archive(Archive& a) {
    a(leastX_, leastV_, leastElements_);
  }

 private:
  void recordGoverning(const MonitorReport& report);

  const Scene& scene_;
  RunResult& result_;
  std::vector<int> materialOfBlock_;  // empty where there is one
  NodeVectors leastX_, leastV_;       // of the least safe step; velocities where elements damp
  std::int64_t leastElements_ = 0;    // that its body had
};

}  // namespace ringwatch
