#pragma once
#include <optional>

#include <ringwatch/app/run/energy_runaway.h>
#include <ringwatch/app/run/run_result.h>
#include <ringwatch/app/scene/scene.h>
#include <ringwatch/integrators/body_system.h>

namespace ringwatch {

/// The energies of a run, over cuts of its body, and whether they ran away.
class RunEnergies {
 public:
  /// least: an energy, J, below which none is a measure (roundingEnergy). Scene and body must outlive this.
  RunEnergies(const Scene& scene, const Body& body, double least);

  /// Whether a state must be recorded. Prescribed motion, damping and moving obstacles do work in every step, so theirs
  /// need every step.
  bool needs(bool rowDue) const {
    return scene_.energy && (rowDue || body_.constraints().moving() || damped() || scene_.movesObstacles());
  }
  /// The internal force of the state is needed too.
  bool needsForce(bool rowDue) const { return needs(rowDue) && body_.constraints().moving(); }
  /// Whether recordDamping() must be called before record().
  bool needsDamping(bool rowDue) const { return needs(rowDue) && (damped() || scene_.movesObstacles()); }
  /// Records what damping and moving obstacles do at a state whose velocities are those of the kicks there: one that
  /// lags does so still.
  void recordDamping(const State& state, BodySystem& system);
  /// Records a state, which may not lag, with what was evaluated of it; with a row, its strain energy as well.
  void record(const State& state, const StepEvaluation& evaluation, bool rowDue);
  /// Of the body, for work that record() does not know of.
  EnergyBalance& balance() { return *balance_; }
  /// What the handler of the body has dissipated, J (Handler::dissipated), as of the next record. What is gone does not
  /// come back: what a handler adds to the energy is an error of the balance.
  void setDissipatedByHandler(double energy) {
    if (!(energy <= byHandler_)) byHandler_ = energy;
  }
  /// Finds the error by which the energies recorded last are judged, the less of two where every step so far, the last
  /// one of h (s), was certified. Central differences keep ½ v₋·M v₊ + V, v₋ and v₊ the velocities half a step before
  /// and after the state, with its accelerations; ½ v·M v + V goes up and down by as much as (h ω/2)² of it though the
  /// step is stable (Hairer, Lubich, Wanner 2003, Geometric numerical integration illustrated by the Störmer-Verlet
  /// method). Without a proof that h ω < 2 the former tells nothing: it stays as it is in a run that is lost.
  void judge(const State& state, double h, bool certified);
  /// The body is another one from here on. What the one before has come to is kept.
  void beginBody();
  /// Energy, J, that left with what the body before had and this one has not.
  void dissipate(double energy) { before_.dissipated += energy; }
  /// What resume() needs; call it after beginBody().
  nlohmann::ordered_json save() const;
  void resume(const nlohmann::ordered_json& saved);
  template <class Archive>
  void archive(Archive& a) {
    a(*balance_, before_, byHandler_, last_, lastError_, runaway_, firstHalfStep_);
  }
  /// The energies at the state recorded last, all bodies together; empty unless a row was due.
  const std::optional<Energies>& last() const { return last_; }

  /// Energies, J, below that are no measure of the balance.
  void setScale(double energy) { runaway_.setScale(energy); }
  /// The last energies for the monitor's check: an error within the tolerance is none.
  std::optional<Energies> checked() const {
    return judged_ ? std::optional(runaway_.forgiven(*judged_, scene_.energyTolerance)) : std::nullopt;
  }

  /// Checks the last energies, before step number `step`.
  void check(std::int64_t step, double time) {
    if (judged_) runaway_.check(*judged_, step, time);
  }
  /// The moment at which the energy ran away, as far as is known; empty where it did not.
  const std::optional<RunResult::Moment>& runaway() const { return runaway_.moment(); }

 private:
  bool damped() const { return scene_.damps() || (body_.discreteForces() && body_.discreteForces()->damped()); }

  const Scene& scene_;
  const Body& body_;
  std::optional<EnergyBalance> balance_;
  Energies before_;       // what the bodies before have come to
  double byHandler_ = 0;  // J, of the body now
  std::optional<Energies> last_;
  std::optional<Energies> judged_;
  /// Of the first state with a row, what the energy lacks to the one that is kept, over h or h². Empty for schemes that
  /// keep no such energy, and where a handler or a device steps.
  std::optional<double> firstHalfStep_;
  double lastError_ = 0;                                        // J, of the balance, the last one that was a number
  NodeVectors besideElements_, dampingForce_, resistingForce_;  // of the state, N
  EnergyRunaway runaway_;
};

}  // namespace ringwatch
