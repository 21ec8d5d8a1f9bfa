#pragma once
#include <ringwatch/distributed/halo.h>
#include <ringwatch/distributed/rank_system.h>

namespace ringwatch {

/// Takes the steps of an explicit scheme on a rank's part: the scheme itself, and one exchange of ghosts behind it, of
/// positions, and of velocities too where forces depend on them. Collective.
class RankStepper {
 public:
  /// All of them must outlive the stepper. Throws InputError for a scheme that does not begin its steps with the
  /// acceleration of the state and take no other, and for stiffness-proportional damping.
  RankStepper(Halo& halo, RankSystem& system, Integrator& integrator);

  /// Whether takeForce wants the internal force of the state.
  bool needsForce(const State& state) const { return state.lag != 0 || state.a.cols() == 0; }
  /// Gives the state its acceleration from the internal force there (3×N, N), and ends the lag of its velocity.
  void takeForce(State& state, const NodeVectors& internalForce);
  /// Advances the state by h seconds; its velocity may lag. Ghosts are where their owners have them then.
  StepStatus step(State& state, double h);
  /// The same, and comes back while the exchange is under way: RankMonitor::observe, a pass with Halo::arrival() and
  /// Halo::finish() end it. Until then the state must stay where it is.
  StepStatus beginStep(State& state, double h);
  /// Ends the lag of the state's velocity, and the exchange.
  void complete(State& state);

 private:
  Halo& halo_;
  RankSystem& system_;
  Integrator& integrator_;
};

}  // namespace ringwatch
