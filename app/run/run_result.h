#pragma once
#include <exception>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include <ringwatch/app/output/exit_status.h>
#include <ringwatch/app/scene/scene_discrete.h>
#include <ringwatch/handlers/handler.h>
#include <ringwatch/monitor/stability_monitor.h>

namespace ringwatch {

/// Why a run ended.
enum class ExitReason {
  end,            ///< its end time was reached
  violated,       ///< the monitor said so and the scene says stop
  nonFinite,      ///< positions or velocities are no longer numbers
  stepCollapsed,  ///< reducing the step led to no step that can be certified
  stepFailed,     ///< the integrator could not take the step
  interrupted,    ///< from outside
  failed          ///< an error: no memory, a full disk, what could not be computed
};
inline constexpr auto exitReasonNames = nameTable<ExitReason>({
    {ExitReason::end, "end"},
    {ExitReason::violated, "violated"},
    {ExitReason::nonFinite, "non-finite"},
    {ExitReason::stepCollapsed, "step-collapsed"},
    {ExitReason::stepFailed, "step-failed"},
    {ExitReason::interrupted, "interrupted"},
    {ExitReason::failed, "failed"},
});
constexpr std::string_view exitReasonName(ExitReason reason) { return exitReasonNames.nameOf(reason); }

/// Thrown by a run that has begun and could not even write its summary.
class RunFailed : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};
/// Why a run stops before a step whose verdict is violated, and how it says so: no step is stable where the tangent is
/// not finite, and there is no bracket then.
ExitReason reasonToStop(const MonitorReport& report);
std::string textOfStop(const MonitorReport& report);

/// What an error that ended a run says, in one line.
std::string faultText(const std::exception& fault);

/// What a handler did in a run.
struct Handling {
  std::int64_t elements = 0;     // handled at the end
  std::int64_t selections = 0;   // how often they were chosen
  std::int64_t evaluations = 0;  // of single elements or rings, all selections together
  bool certified = false;        // the explicit part, at the last choice
  bool nothingExplicit = false;  // every element was handled, at some time
  std::vector<HandlerFigure> figures;
};

/// What a cut did to a run.
struct CutRecord {
  std::int64_t step = 0;
  double time = 0;                                     // s
  std::int64_t elementsBefore = 0, elementsAfter = 0;  // of the mesh
  std::int64_t elementsCut = 0, nodesAdded = 0, facesOpened = 0;
  double area = 0;    // opened, at rest, one side, m²
  double atMost = 0;  // s, what the changed elements leave of the critical step of the whole body, by their rings
  std::optional<CriticalStep> before, after;         // of the whole body there, whatever a handler does; where wanted
  double kineticBefore = 0, kineticAfter = 0;        // J; lumped masses move it a little
  std::int64_t handledBefore = 0, handledAfter = 0;  // elements
  Handler::SelectionCost selectionCost;              // again, by the handler
  double cutTime = 0, selectionTime = 0;             // s of wall time: of mesh and body, of the handler
};

/// An event, with what only the mesh of its time can say.
struct RunEvent {
  MonitorEvent event;
  nlohmann::ordered_json element;  // elementJson
  std::string text;                // eventText
};

/// An element that left a run by erosion.
struct ErodedElement {
  std::int64_t step = 0;
  double time = 0;                 // s
  nlohmann::ordered_json element;  // elementJson, of the mesh before
  std::string cause;               // "inverted", "step" or the measure of stress
  double value = 0;                // that met the criterion
  double strain = 0;               // J, that it took with it
};

/// A column of probes.csv.
struct ProbeColumn {
  std::string name, unit, help;
};

/// What came of a run.
struct RunResult {
  struct Moment {
    std::int64_t step;
    double time;  // s
  };
  ExitReason reason = ExitReason::end;
  std::string reasonText;                    // one line
  std::int64_t steps = 0;                    // taken
  double time = 0;                           // s, reached
  NodeVectors x;                             // positions there, 3×N, m
  double smallestStep = 0, largestStep = 0;  // s, of the steps taken
  std::optional<Verdict> worst;              // of the steps taken; empty when nothing was monitored
  bool violatedStepTaken = false;
  std::int64_t watchedSteps = 0;           // taken with a monitor that proves something
  std::int64_t certifiedSteps = 0;         // of those
  std::int64_t firstObservationSteps = 0;  // of those, on what the monitor's first observation alone had proven
  struct Range {
    double least, largest;
  };
  std::optional<Range> safeSeen;  // s, the safe sides of the brackets of states from which a step was taken
  bool requireCertified = false;  // the scene's monitor.require_certified
  bool proving = true;            // the scene's monitor is to prove steps
  /// Of the least safe side of a state from which a step was taken, before one that was proven unstable: stepReasons()
  /// with its step and time, completed at the end of the run; null for none, and with a handler.
  nlohmann::ordered_json why = nullptr;
  std::optional<Moment> firstViolated;  // the monitor first said violated
  std::optional<Moment> runaway;        // energy became more than was put in, by more than runawayShare, for good
  std::vector<RunEvent> events;
  std::optional<Handling> handler;  // empty without one
  std::vector<CutRecord> cuts;
  std::vector<ErodedElement> eroded;
  std::vector<ProbeColumn> probes;
  /// How often the run went back, and the steps that were dropped by it, where the scene wants that.
  struct Repeats {
    std::int64_t count = 0, droppedSteps = 0;
  };
  std::optional<Repeats> repeats;
  /// Which materials hold the elements that control the bracket, where the scene has several.
  struct Governing {
    std::vector<std::int64_t> observations;  // by material, of which the controlling element was of it
    std::optional<double> leastSafe;         // s, of all observations
    int atLeastSafe = 0;                     // the material of the controlling element there
  };
  std::optional<Governing> governing;
  /// What springs and contact came to, where the scene has them.
  struct Discrete {
    std::int64_t governed = 0;            // observations of which they set the step
    std::optional<double> leastSafe;      // s, of these
    std::int64_t mostTouching = 0;        // nodes and obstacles
    double deepest = 0, deepestTime = 0;  // m, s
    std::int32_t deepestNode = -1;
    std::size_t deepestObstacle = 0;
    std::optional<PenaltyRoom> room;
  };
  std::optional<Discrete> discrete;
  double forceTime = 0, monitorTime = 0, outputTime = 0, wallTime = 0;  // s
  /// What ranks have told each other, since the run began or was resumed: sums over them.
  struct Traffic {
    int ranks = 1;
    std::int64_t exchanges = 0, messages = 0, bytes = 0;  // exchanges: of each rank
    std::int64_t bytesByModel = 0;                        // of the steps: 24 a ghost node
    std::optional<double> hidden;                         // share of the bytes that had come behind work; empty of none
    double waited = 0;                                    // s, for the others, of the rank that waited longest
  };
  std::optional<Traffic> traffic;  // empty of one process
  std::size_t frames = 0;
  std::vector<std::string> files;  // written, relative to the folder
  std::vector<std::string> notes;

  /// Reached its end, took no step that was proven unstable, kept its energy in balance, and was certified unless
  /// nothing was to prove it: exitStatus() is ExitStatus::done.
  bool stable() const { return exitStatus() == ExitStatus::done; }
  /// A checkpoint of it is worth keeping.
  bool canGoOn() const { return reason == ExitReason::interrupted || reason == ExitReason::failed; }
  /// An event of the kind happened, whether it ended or not.
  bool happened(EventKind kind) const;
  /// Every step that was watched was certified, and there was one: safe for the highest frequency. Where a tangent was
  /// indefinite, which is an event, no more is proven.
  bool certified() const { return watchedSteps > 0 && certifiedSteps == watchedSteps; }
  /// Nothing beyond the monitor's first observation was certified, though there was more; or nothing could be, of a
  /// handler's steps that had no explicit element.
  bool neverCertified() const {
    return (certifiedSteps < watchedSteps && certifiedSteps <= firstObservationSteps) ||
           (handler && handler->nothingExplicit && watchedSteps == 0 && steps > 0 && proving);
  }
  bool energyOff() const { return happened(EventKind::energyBalance); }
  ExitStatus exitStatus() const;
  /// "certified", "not-certified", "violated", "unstable" or "unmonitored": what the run as a whole may be called.
  std::string_view verdict() const;
};

/// Energy beyond what was put in, over its measure (EnergyScale), that counts as a runaway.
inline constexpr double runawayShare = 0.1;

}  // namespace ringwatch
