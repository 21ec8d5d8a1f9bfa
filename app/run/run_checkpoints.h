#pragma once
#include <cstdint>
#include <string>
#include <vector>

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
  /// Writes all that a resumed run needs to go on with the bits of this one, of which nothing changes: monitor and
  /// energy balance go along. Some 100 bytes a tet4, where write() takes 48 a node. Of a part of a body it is write().
  void writeAsItIs();
  /// What came of the last writeAsItIs(), in one line, and whether there is a checkpoint of it.
  const std::string& whatCame() const { return told_; }
  bool isOfNow() const { return asItIs_; }
  /// Begins the run, whose output is there, at a checkpoint. Throws InputError where the mesh is another one, or where
  /// what the checkpoint holds is not of this scene.
  void resume(const Checkpoint& saved);
  /// How an interrupted run can go on.
  std::string howToGoOn() const;

 private:
  /// Why this run has no checkpoint of its state now, "" where it has.
  std::string whyNone() const;
  /// What both kinds of checkpoints hold. Collective.
  Checkpoint saved();
  /// Returns the bytes of what the first process has written.
  std::size_t writeAndBeginAgain();
  void resumeParts(const Checkpoint& saved);
  void goOn();

  Simulation& run_;
  std::int64_t count_ = 0;  // whole intervals that the last one ended
  std::string told_;
  bool asItIs_ = false;  // the last writeAsItIs() has written one
};

}  // namespace ringwatch
