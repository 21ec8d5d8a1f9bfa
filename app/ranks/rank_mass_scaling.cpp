#include <ringwatch/app/ranks/rank_mass_scaling.h>

#include <algorithm>

#include <ringwatch/app/command/integrator_catalog.h>

namespace ringwatch {

/// The part's equations of motion within a step, where no exchange has brought the positions of ghosts.
class RankMassScaling::PartSystem final : public SecondOrderSystem {
 public:
  PartSystem(Halo& halo, RankSystem& system) : halo_(halo), system_(system) {}
  void acceleration(double time, const NodeVectors& x, const NodeVectors& v, NodeVectors& a) override {
    system_.acceleration(time, withGhosts(x), v, a);
  }
  bool velocityDependent() const override { return system_.velocityDependent(); }
  int threads() const override { return system_.threads(); }
  /// Positions with ghosts as their owners have them.
  const NodeVectors& withGhosts(const NodeVectors& x) {
    x_ = x;
    halo_.exchange(x_);
    return x_;
  }
  void exchange(State& state) {
    if (velocityDependent())
      halo_.begin(state.x, state.v);
    else
      halo_.begin(state.x);
  }

 private:
  Halo& halo_;
  RankSystem& system_;
  NodeVectors x_;
};

RankMassScaling::RankMassScaling(const Scene& scene, Body& whole, double h) {
  auto handler = std::make_unique<MassScaling>(whole, integratorCatalog().make(scene.method), scene.handlerOptions);
  handler->prepare(whole.mesh().X, h);
  handling_.elements = static_cast<std::int64_t>(handler->elements().size());
  handling_.certified = handler->certified();
  handling_.selections = 1;
  handling_.evaluations = handler->selectionCost().evaluations;
  division_ = handler->division();
  limit_ = handler->limit();
  chosen_ = handler->chosen();
  allHaveEnergy_ = handler->allHaveEnergy();
  handler_ = std::move(handler);
}

RankMassScaling::~RankMassScaling() = default;

void RankMassScaling::begin(const Place& place) {
  place_.emplace(place);
  system_ = std::make_unique<PartSystem>(place.halo, place.system);
  determinants_.emplace(place.part.body(), elementsOfPart(place.part, chosen_));
  chosen_.clear();
  if (!place.keepsWhole) handler_.reset();
}

void RankMassScaling::choose(RankMonitor& monitor, NodeVectorsView x, double h) {
  const RankMonitor::Bound bound = monitor.boundFromScratch(x, StepDivision::sweeps);
  division_.choose(bound.highest, h, limit_);
  ++handling_.selections;
  handling_.evaluations += bound.evaluations;
  handling_.certified = division_.proven();
  monitor.setParts(division_.parts());
  place_->integrator.reset();
}

StepStatus RankMassScaling::step(State& state, double h) {
  division_.take(place_->integrator, *system_, state, h, [this](const NodeVectors& x) { return endsWithoutEnergy(x); });
  system_->exchange(state);
  return {};
}

/// Whether a handled element of a law without energy there ends at det F <= 0, on any rank.
bool RankMassScaling::endsWithoutEnergy(const NodeVectors& x) {
  if (allHaveEnergy_) return false;
  const auto least = determinants_->at(system_->withGhosts(x));
  double found = least && !(least->value > 0) ? 1 : 0;
  place_->ranks.largest({&found, 1});
  return found > 0;
}

Handling RankMassScaling::handling() {
  Handling result = handling_;
  if (handler_) result.figures = static_cast<const MassScaling&>(*handler_).figuresWith(division_);
  return result;
}

}  // namespace ringwatch
