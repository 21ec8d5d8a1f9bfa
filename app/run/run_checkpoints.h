#pragma once
#include <cstdint>

#include <ringwatch/app/run/checkpoint.h>
#include <ringwatch/app/run/simulation.h>

namespace ringwatch {

/// The checkpoints of a run: writes them when they are due, and begins a run at one.
class RunCheckpoints {
 public:
  /// The simulation must outlive this.
  explicit RunCheckpoints(Simulation& simulation) : run_(simulation) {}

  /// Whether one is due at the state.
  bool due() const;
  /// Writes what a resumed run goes on from, and goes on from there itself: monitor and energy balance begin again.
  void write();
  /// Begins the run, whose output is there, at a checkpoint. Throws InputError where the mesh is another one.
  void resume(const Checkpoint& saved);
  /// How an interrupted run can go on; "" where the scene has no checkpoints.
  std::string howToGoOn() const;

 private:
  void goOn();

  Simulation& run_;
  std::int64_t count_ = 0;  // whole intervals that the last one ended
};

}  // namespace ringwatch
