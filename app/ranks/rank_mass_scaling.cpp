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

void RankMassScaling::begin(Ranks& ranks, Halo& halo, const RankBody& part, RankSystem& system, Integrator& integrator,
                            bool keepsWhole) {
  ranks_ = &ranks;
  halo_ = &halo;
  part_ = &part;
  integrator_ = &integrator;
  system_ = std::make_unique<PartSystem>(halo, system);
  for (std::size_t b = 0; b < part.body().blocks().size(); ++b)
    for (std::int32_t e = 0; e < part.body().blocks()[b]->elementCount(); ++e) {
      const ElementRef inWhole = part.globalElement({b, e});
      if (chosen_[inWhole.block][inWhole.element]) handled_.push_back({b, e});
    }
  chosen_.clear();
  if (!keepsWhole) handler_.reset();
}

void RankMassScaling::choose(RankMonitor& monitor, NodeVectorsView x, double h) {
  const RankMonitor::Bound bound = monitor.boundFromScratch(x, StepDivision::sweeps);
  division_.choose(bound.highest, h, limit_);
  ++handling_.selections;
  handling_.evaluations += bound.evaluations;
  handling_.certified = division_.proven();
  monitor.setParts(division_.parts());
  integrator_->reset();
}

void RankMassScaling::step(State& state, double h) {
  division_.take(*integrator_, *system_, state, h, [this](const NodeVectors& x) { return endsWithoutEnergy(x); });
  system_->exchange(state);
}

/// Whether a handled element of a law without energy there ends at det F <= 0, on any rank.
bool RankMassScaling::endsWithoutEnergy(const NodeVectors& x) {
  if (allHaveEnergy_) return false;
  const NodeVectors& at = system_->withGhosts(x);
  double found = 0, determinants[lanes];
  for (const ElementRef e : handled_) {
    const ElementBlock& block = *part_->body().blocks()[e.block];
    const std::int32_t place = block.layout().batchOfElement[e.element];
    block.minimumDeterminantBatch(place / lanes, at.data(), determinants);
    if (!(determinants[place % lanes] > 0)) found = 1;
  }
  ranks_->largest({&found, 1});
  return found > 0;
}

Handling RankMassScaling::handling() const {
  Handling result = handling_;
  if (handler_) result.figures = static_cast<const MassScaling&>(*handler_).figuresWith(division_);
  return result;
}

}  // namespace ringwatch
