#pragma once
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <ringwatch/monitor/critical_step.h>
#include <ringwatch/monitor/energy_balance.h>
#include <ringwatch/monitor/event.h>
#include <ringwatch/monitor/incremental/work_account.h>
#include <ringwatch/monitor/metrics/metrics.h>
#include <ringwatch/monitor/step_limit.h>

namespace ringwatch {

/// What is kept along a run.
enum class MonitorMode {
  bracket,    ///< both sides of the critical step, at every observation
  threshold,  ///< only whether the step taken is certified: cheapest. While it is not, both sides, to tell how far
  metric      ///< neither: a metric with a margin, which proves nothing
};
inline constexpr auto monitorModeNames = nameTable<MonitorMode>({
    {MonitorMode::bracket, "bracket", "both proven sides at every observation"},
    {MonitorMode::threshold, "threshold", "only whether the step is certified, which is cheapest", "certify"},
    {MonitorMode::metric, "metric", "the metric alone"},
});
constexpr std::string_view monitorModeName(MonitorMode mode) { return monitorModeNames.nameOf(mode); }

struct MonitorOptions {
  StepRule limit = 2.0;  ///< the integrator's largest stable h·omega on the imaginary axis, or, for a damped
                         ///< run, the rule that makes a step of the highest eigenvalue
  MonitorMode mode = MonitorMode::bracket;
  std::string metric = {};  ///< Fierz 2013's way: a metric with a margin, e.g. "reduced-1-ring"; "" for none
  double margin = 0.1;      ///< of the metric's step: h_metric (1 - margin)
  int every = 1;            ///< steps between evaluations
  double width = 0.05;      ///< of the bracket, relative to the step, that the proven side is steered to
  /// What the bracket may take after the first observation, for both sides and for searches, as a share of a step's own
  /// work, counted (WorkAccount); 0: the tests of balls and one bound from below; from 100 on: no limit. When it is
  /// used up the proof stays and the bracket becomes wider. Telling whether h is proven unstable, while it is not
  /// proven stable, may take more in small bodies: up to six steps' work.
  double budget = 0.1;
  /// Of the run, as far as known: with a budget the first observation goes beyond the proof of h where all of it takes
  /// no more than three tenths of the budget of so many steps. What it leaves out follows in the run, when the budget
  /// affords it.
  std::int64_t steps = 0;
  /// Before so much is taken there is no limit in bodies of up to some 8000 tetrahedra or 1000 hexahedra, whose
  /// brackets would be wide for the sake of milliseconds; units of WorkAccount: some 0.2 s.
  double workInAdvance = 5e7;
  /// The steps follow what is proven, so that a wide bracket costs more of them: what saves more work than it takes
  /// goes beyond the budget, unless that is 0.
  bool stepFollows = false;
  double energyTolerance = 0.1;  ///< balance error over the largest energy so far that is reported
  int clearObservations = 20;    ///< observations in a row without it that end an event; see EventTracker
  /// Where the step that is chosen lies between the sides of the first bracket, or none is chosen and the bracket is
  /// wider than `width`, the first observation takes the best proof there is, that of criticalStep(), in bodies of up
  /// to this many elements; 0 for none. It costs 0.005 to 0.05 ms a tet4 and 0.1 ms a hex8 on one thread, once. Later
  /// observations use the bound that is kept along the run.
  std::int64_t firstObservationElements = 10000;
};

enum class Verdict {
  certified,     ///< h <= safe: proven stable for the tangent at this state
  notCertified,  ///< safe < h <= optimistic: neither proven stable nor proven unstable
  violated       ///< h > optimistic: proven above the critical step of the tangent at this state; or positions,
                 ///< velocities or the tangent are not finite, so that there is no bracket and no step helps
};
inline constexpr auto verdictNames = nameTable<Verdict>({
    {Verdict::certified, "certified"},
    {Verdict::notCertified, "not-certified"},
    {Verdict::violated, "violated"},
});
constexpr std::string_view verdictName(Verdict verdict) { return verdictNames.nameOf(verdict); }
/// What a bracket says of a step of h seconds.
constexpr Verdict verdictFor(double h, const CriticalStep& bracket) {
  return h <= bracket.safe ? Verdict::certified : h <= bracket.optimistic ? Verdict::notCertified : Verdict::violated;
}

/// What a bracket says of steps of h seconds from its state on: of an indefinite tangent none is certified.
constexpr Verdict verdictOfState(double h, const CriticalStep& bracket) {
  const Verdict verdict = verdictFor(h, bracket);
  return verdict == Verdict::certified && bracket.lowestRing < 0 ? Verdict::notCertified : verdict;
}

/// What the monitor knows after a step.
struct MonitorReport {
  std::int64_t step = 0;
  double time = 0;                      // s
  double h = 0;                         // s, the step the run takes; 0 while none is chosen
  bool fresh = false;                   // evaluated at this very state; else `every` steps have not passed
  std::int64_t evaluatedAt = 0;         // step whose state bracket, certified and metricStep are of
  std::optional<CriticalStep> bracket;  // in threshold mode only while the step is not certified; never for a state
                                        // whose positions, velocities or tangent are not finite
  double certified = 0;                 // s, the largest step proven at that state; 0 for none
  std::int64_t elementsRefreshed = 0;   // element evaluations spent at this observation
  Work spent;                           // at this observation, over a step's own work, counted; nothing at the first
  std::optional<double> metricStep;     // s, an estimate, margin applied
  Verdict verdict = Verdict::notCertified;
  std::vector<MonitorEvent> newEvents;  // begun at this step
};

/// Keeps the bracket of the critical step current along a run. Reports; never stops a run itself. The safe side is the
/// block nodal bound, kept by an incremental certificate (Theorem 14, docs/theory/incremental_certificate.md), the
/// optimistic one a Rayleigh quotient or a reduced ring (Theorems 8 and 9, docs/theory/rings_and_rayleigh.md). Both are
/// for the tangent at the state observed, and stable means what Theorem 27, docs/theory/integrators.md, says.
///
/// The body may be a part of a larger one (body/domain.h): then all that observes is collective, all processes get the
/// same report, which names elements of the whole, but for elementsRefreshed, of which each has its own; and the bits
/// of the report are those for any other number of processes and any partition (Theorem 80,
/// docs/theory/distribution.md).
///
///   Body body(loadMesh("bar.msh"), makeMaterial("stvk", 30e3, 0.3, 1000));
///   StabilityMonitor monitor(body, {.limit = 2.0});  // of symplectic Euler
///   // in the time loop, before each step:
///   const MonitorReport& report = monitor.observe(step, time, x, v, h);
///   for (const MonitorEvent& event : report.newEvents) std::puts(eventText(event, body.mesh()).c_str());
///   if (report.verdict == Verdict::violated && report.bracket) h = report.bracket->safe;
class StabilityMonitor {
 public:
  /// The body must outlive the monitor. Throws InputError for an unknown metric, a margin outside [0, 1), every or
  /// clearObservations < 1, a bracket wanted by a rule that is not proven, or a metric on a part of a body.
  StabilityMonitor(const Body& body, const MonitorOptions& options);
  ~StabilityMonitor();

  /// Makes the next observation evaluate its state, whatever `every` says: the last one of a run.
  void evaluateNext();
  /// Observes positions x (3×N, m) and velocities v (3×N, m/s) before step number `step` of size h (s) is taken from
  /// them; h is empty while no step is chosen, and then no step is checked. Unless nullptr, `evaluation` is filled in
  /// at x: the monitor tests the elements in the one pass that computes what it asks for. When masses or constraints of
  /// the body have changed, everything is evaluated from scratch. The report is valid until the next call. Throws
  /// InputError when x or v is not 3×N, or h is not positive and finite. On a part of a body ghosts of x may be under
  /// way to it (Domain::begin); meanwhile, unless empty, may be called once `evaluation` is filled in, while other
  /// processes are waited for.
  const MonitorReport& observe(std::int64_t step, double time, NodeVectorsView x, NodeVectorsView v,
                               std::optional<double> h, StepEvaluation* evaluation = nullptr,
                               const std::function<void()>& meanwhile = {});
  /// Whether positions and velocities were finite at the last observation.
  bool stateIsFinite() const;
  /// Checks the energies (of an EnergyBalance) of the state that was observed last. Returns the same report, with the
  /// event that has begun, if one has.
  const MonitorReport& observeEnergies(const Energies& energies);
  /// All events so far.
  const std::vector<MonitorEvent>& events() const;
  const MonitorOptions& options() const;

  /// All that the monitor has come to know, as bytes. A monitor of the same options and the same body that load()s them
  /// goes on with the bits of this one. Only the same build of the library reads them. Some 100 bytes a tet4. Throws
  /// InputError on a part of a body.
  std::string save() const;
  /// Throws InputError where bytes are damaged, or are of other options, of a body of other sizes or of packs of
  /// another width; what was known before is lost then.
  void load(std::string_view saved);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace ringwatch
