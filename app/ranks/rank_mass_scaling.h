#pragma once
#include <memory>
#include <optional>
#include <vector>

#include <ringwatch/app/ranks/rank_handler.h>
#include <ringwatch/handlers/mass_scaling/mass_scaling.h>

namespace ringwatch {

/// The handler mass-scaling of a run on ranks. Its first choice adds mass to the whole body, on every rank alike. From
/// then on it divides steps, by a bound of all ranks: the same for any number of ranks and any partition (Theorem 94,
/// docs/theory/distribution.md).
class RankMassScaling final : public RankHandler {
 public:
  /// Chooses at rest for steps of h seconds; the mass goes to the whole body, which must live until begin().
  RankMassScaling(const Scene& scene, Body& whole, double h);
  ~RankMassScaling() override;
  void begin(const Place& place) override;

  bool stepsAsBase() const override { return division_.neverDivided() && allHaveEnergy_; }
  bool wantsChoice(const MonitorReport& report) const override {
    return report.fresh && (report.verdict != Verdict::certified || division_.asksForChoice());
  }
  /// Chooses into how many parts steps are divided.
  void choose(RankMonitor& monitor, NodeVectorsView x, double h) override;
  StepStatus step(State& state, double h) override;
  std::int64_t handledElements() const override { return handling_.elements; }
  Handling handling() override;

 private:
  class PartSystem;
  bool endsWithoutEnergy(const NodeVectors& x);

  std::unique_ptr<Integrator> handler_;  // a MassScaling of the whole body, where that is kept
  StepDivision division_;
  StepDivision::Limit limit_;
  ElementFlags chosen_;  // of the whole body, until begin()
  bool allHaveEnergy_ = true;
  Handling handling_;
  std::optional<Place> place_;
  std::unique_ptr<PartSystem> system_;
  std::optional<LeastDeterminant> determinants_;  // of handled elements of the part
};

}  // namespace ringwatch
