#pragma once
#include <memory>
#include <optional>
#include <vector>

#include <ringwatch/app/run/run_result.h>
#include <ringwatch/app/scene/scene.h>
#include <ringwatch/distributed/halo.h>
#include <ringwatch/distributed/rank_monitor.h>
#include <ringwatch/distributed/rank_system.h>
#include <ringwatch/handlers/mass_scaling/mass_scaling.h>

namespace ringwatch {

/// The handler mass-scaling of a run on ranks. Its first choice adds mass to the whole body, on every rank alike. From
/// then on it divides steps, by a bound of all ranks: the same for any number of ranks and any partition (Theorem 94,
/// docs/theory/distribution.md). All but the constructors and const functions are collective.
class RankMassScaling {
 public:
  /// Chooses at rest for steps of h seconds; the mass goes to the whole body, which must live until begin().
  RankMassScaling(const Scene& scene, Body& whole, double h);
  ~RankMassScaling();
  /// Steps are those of the part from here on; all must outlive this. keepsWhole: the whole body lives as long, and
  /// handling() has the handler's figures.
  void begin(Ranks& ranks, Halo& halo, const RankBody& part, RankSystem& system, Integrator& integrator,
             bool keepsWhole);

  /// Whether the scheme itself takes the next step.
  bool stepsAsBase() const { return division_.neverDivided() && allHaveEnergy_; }
  /// Whether a report of steps of the last choice asks for another.
  bool wantsChoice(const MonitorReport& report) const {
    return report.fresh && (report.verdict != Verdict::certified || division_.asksForChoice());
  }
  /// Chooses into how many parts steps of h seconds are divided at x (3×N, m, ghosts as their owners have them), and
  /// tells the monitor.
  void choose(RankMonitor& monitor, NodeVectorsView x, double h);
  /// Takes a step of h seconds. Ghosts have the positions and velocities of their owners after the exchange that is
  /// under way then.
  void step(State& state, double h);
  /// Elements to whose nodes it gave mass.
  std::int64_t handledElements() const { return handling_.elements; }
  /// What it did so far.
  Handling handling() const;

 private:
  class PartSystem;
  bool endsWithoutEnergy(const NodeVectors& x);

  std::unique_ptr<Integrator> handler_;  // a MassScaling of the whole body, where that is kept
  StepDivision division_;
  StepDivision::Limit limit_;
  ElementFlags chosen_;  // of the whole body, until begin()
  bool allHaveEnergy_ = true;
  Handling handling_;
  Ranks* ranks_ = nullptr;
  Halo* halo_ = nullptr;
  const RankBody* part_ = nullptr;
  Integrator* integrator_ = nullptr;
  std::unique_ptr<PartSystem> system_;
  std::vector<ElementRef> handled_;  // of the part
};

}  // namespace ringwatch
