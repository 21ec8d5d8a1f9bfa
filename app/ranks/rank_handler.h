#pragma once
#include <memory>
#include <optional>
#include <span>
#include <string>

#include <ringwatch/app/run/run_result.h>
#include <ringwatch/app/scene/scene.h>
#include <ringwatch/distributed/halo.h>
#include <ringwatch/distributed/partition.h>
#include <ringwatch/distributed/rank_monitor.h>
#include <ringwatch/distributed/rank_system.h>

namespace ringwatch {

/// A handler of a run on ranks. Every rank makes the first choice on the whole body, alike, before it takes its part.
class RankHandler {
 public:
  virtual ~RankHandler() = default;

  /// What of a partition it needs otherwise: nodes that belong together.
  virtual void adapt(Partition&) {}
  /// Steps are those of a rank's part from here on. All must outlive this; the whole body, which it was made of, must
  /// do so where it is kept, and handling() has the figures of the whole then. Not collective.
  struct Place {
    Ranks& ranks;
    Halo& halo;
    const RankBody &part, &explicitPart;  // explicitPart(), or all of the part
    RankSystem& system;
    Integrator& integrator;
    bool keepsWhole;
  };
  virtual void begin(const Place& place) = 0;
  /// The part of the explicit elements on this rank, with the same nodes, for the monitor; nullptr where none leaves
  /// the explicit part. Of a partition that was adapted.
  virtual std::unique_ptr<RankBody> explicitPart(const Partition&, int /*rank*/, int /*threads*/) { return nullptr; }

  /// Whether the scheme itself takes the next step.
  virtual bool stepsAsBase() const = 0;
  /// Takes a step of h seconds. Ghosts have the positions and velocities of their owners after the exchange that is
  /// under way then. Where it fails on one rank it does on all, which know why. Collective.
  virtual StepStatus step(State& state, double h) = 0;
  /// Whether a report of steps of the last choice asks for another.
  virtual bool wantsChoice(const MonitorReport&) const { return false; }
  /// Chooses anew for steps of h seconds at x (3×N, m, ghosts as their owners have them), and tells the monitor.
  /// Collective.
  virtual void choose(RankMonitor&, NodeVectorsView /*x*/, double /*h*/) {}
  /// The event that begins in handled elements at the state that a report is of, x (3×N, m), if one does. Collective.
  virtual std::optional<MonitorEvent> watch(const MonitorReport&, NodeVectorsView /*x*/) { return std::nullopt; }
  /// All of these events so far.
  virtual std::span<const MonitorEvent> events() const { return {}; }
  /// As Handler::dissipated, J, of all ranks. Collective.
  virtual double dissipated() { return 0; }
  virtual std::int64_t handledElements() const = 0;
  /// What it did so far. Collective.
  virtual Handling handling() = 0;
};

/// The elements of a part, ascending, that are among chosen ones of the whole.
std::vector<ElementRef> elementsOfPart(const RankBody& part, const ElementFlags& chosen);

/// The handler of a scene, which has one, chosen at rest for steps of h seconds. May change masses of the whole body,
/// which must live until RankHandler::begin.
std::unique_ptr<RankHandler> makeRankHandler(const Scene& scene, Body& whole, double h);

}  // namespace ringwatch
