#pragma once
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <ringwatch/app/ranks/rank_handler.h>
#include <ringwatch/handlers/imex/imex.h>

namespace ringwatch {

/// The handler imex of a run on ranks, with nonlinear equations. Clusters of handled elements are chosen once, on the
/// whole body, and each is solved by one rank, which owns all of its nodes: positions are those of one process, to the
/// last bit, for any number of ranks (Theorem 96, docs/theory/distribution.md).
class RankImex final : public RankHandler {
 public:
  /// Chooses at rest for steps of h seconds. The whole body must live until begin(). Throws InputError where the
  /// equations are linear, which depends on the laws, and where no element is left to the explicit part.
  RankImex(const Scene& scene, Body& whole, double h);
  ~RankImex() override;

  void adapt(Partition& partition) override;
  std::unique_ptr<RankBody> explicitPart(const Partition& partition, int rank, int threads) override;
  void begin(const Place& place) override;
  bool stepsAsBase() const override { return handling_.elements == 0; }
  StepStatus step(State& state, double h) override;
  std::optional<MonitorEvent> watch(const MonitorReport& report, NodeVectorsView x) override;
  std::span<const MonitorEvent> events() const override { return tracker_.events(); }
  double dissipated() override;
  std::int64_t handledElements() const override { return handling_.elements; }
  Handling handling() override;

 private:
  class System;

  double h_;
  const Body* whole_;              // until begin()
  std::unique_ptr<Imex> handler_;  // of the whole body, until begin()
  NewtonSettings settings_;
  Handling handling_;
  std::optional<Place> place_;
  std::vector<NewtonCluster> clusters_;
  std::vector<HandledWork> works_;  // by cluster
  std::vector<bool> freeOfTorque_;  // by cluster
  std::optional<LeastDeterminant> determinants_;
  std::unique_ptr<System> system_;
  NodeVectors baseAcceleration_ = NodeVectors(3, 0);  // State::a of the scheme on that system
  State before_;                                      // the step that is being taken
  EventTracker tracker_;
};

}  // namespace ringwatch
