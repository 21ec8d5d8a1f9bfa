#pragma once
#include <memory>
#include <optional>
#include <string>

#include <ringwatch/app/run/run_energies.h>
#include <ringwatch/app/run/run_output.h>
#include <ringwatch/app/run/run_probes.h>
#include <ringwatch/app/run/run_recorder.h>
#include <ringwatch/app/run/run_rule.h>
#include <ringwatch/app/run/run_scheme.h>
#include <ringwatch/app/run/run_watch.h>
#include <ringwatch/app/run/runner.h>
#include <ringwatch/app/run/step_policy.h>
#include <ringwatch/app/run/stopwatch.h>
#include <ringwatch/app/run/timed_loads.h>

namespace ringwatch {

/// The parts of a run in progress, and what they do together at a state. The runner says when; cuts and checkpoints
/// (run_cuts.h, run_checkpoints.h) replace parts, which are therefore open to them.
class Simulation {
 public:
  /// The scheme is made and the body is watched; there are no output and no state yet. All arguments must outlive this.
  /// Throws InputError for a device that cannot be had.
  Simulation(const Scene& scene, Body& body, const RunOptions& options);

  /// The loads of the state's time act from here on.
  void setLoads();
  /// Observes the state before step k, and lets a handler choose again where the explicit part is not certified: one
  /// pass over the elements serves the scheme, the energy balance and, where it watches the whole body, the monitor.
  /// rowDue: the energies are wanted.
  MonitorReport observe(std::int64_t k, bool rowDue);
  /// False when the run has ended, which a state that is not finite makes it.
  bool acceptState(const MonitorReport& report);
  /// Chooses the step from a report of the state. False when none can be had, which ends the run.
  bool chooseStep(MonitorReport& report);
  /// Whether the energy ran away before step k.
  void checkEnergies(std::int64_t k);
  /// The scene wants no step that was proven unstable, and this one is.
  bool stopsAt(const MonitorReport& report) const;
  /// Writes what is due before a step: events, history, frame, certificates.
  void record(const MonitorReport& report, bool rowDue);
  /// The events of a report alone, where no step is taken.
  void recordEvents(const MonitorReport& report);
  /// Takes steps from the state, one or as many as are not to be observed. False when the first failed, which ends the
  /// run.
  bool takeStep(const MonitorReport& report);
  /// Completes the state, notes what the run has come to and ends its files. Of a run that failed, parts may be
  /// missing: its state stays as it is.
  void finish();

  /// The body that elements are named by and that the summary is of; nullptr where another process has it.
  Body* named() const { return options.part ? options.part->whole : &body; }
  /// Whether the state is finite, of all parts of a body. Collective.
  bool isFinite() const;
  /// The run ends here; text is one line.
  void end(ExitReason reason, std::string text);
  /// Watches the body, or what its handler leaves explicit, from here on.
  void beginWatch();
  /// What the parts know beyond state and result. Loading needs the same body, and its watch begun.
  template <class Archive>
  void archive(Archive& a) {
    a(state.a, state.lag, energies, loads, watch, recorder, output->certificates());
    if (ElementDamping* damping = body.elementDamping()) a(*damping);
  }
  /// The energies of the state, in a pass of their own.
  void recordEnergies();
  /// The same, and the velocities of the state no longer lag.
  void completeState();
  /// The bracket of the whole body, from scratch; empty where the state has none.
  std::optional<CriticalStep> criticalStepHere(std::int64_t* evaluations = nullptr) const;

  const Scene& scene;
  Body& body;
  const RunOptions& options;
  RunRule ruleOfSteps;
  const StepRule& rule = ruleOfSteps.rule();
  RunEnergies energies;
  StepPolicy steps;
  TimedLoads loads;
  RunResult result;
  Stopwatch total{result.wallTime};
  RunRecorder recorder;
  RunWatch watch;
  RunProbes probes;
  std::unique_ptr<RunScheme> scheme;
  std::optional<RunOutput> output;
  State state;
  Verdict lastVerdict = Verdict::notCertified;  // of the step that led to the state

 private:
  MonitorReport observeOnce(std::int64_t k, bool rowDue);
  MonitorReport handleMore(MonitorReport report, bool rowDue);
  /// Observes once more with the rule that is exact at the scene's step, where another one did not prove it.
  MonitorReport referToStep(MonitorReport report, bool rowDue);
  /// The handler chooses for the step at the state. False where it cannot, which ends the run.
  bool handleAgain();
  void askFor(bool rowDue, bool probesDue);
  void takeForce();
  void lookAhead();
  void evaluate();
  void takeEvaluation(bool rowDue);
  std::int64_t stepsToObservation(std::int64_t k);
  FrameState frameOf(const MonitorReport& report) const;
  /// The frames whose times lie within the step that was taken from a state, where the scene wants them there.
  void writeFramesBetween(State& begin, const MonitorReport& report);

  StepEvaluation evaluation_;
  Body::Workspace workspace_;
  bool stepperNeedsForce_ = false;
  bool dampingDue_ = false;
  bool rowDue_ = false;     // at the state that was observed last
  double preparedFor_ = 0;  // s, the step that the handler chose for
};

}  // namespace ringwatch
