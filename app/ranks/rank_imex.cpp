#include <ringwatch/app/ranks/rank_imex.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include <ringwatch/app/command/integrator_catalog.h>
#include <ringwatch/base/error.h>
#include <ringwatch/body/nodes_of.h>
#include <ringwatch/handlers/angular_momentum.h>
#include <ringwatch/handlers/imex/solve_clusters.h>

namespace ringwatch {
/// The equations of motion at the part's owned nodes with the accelerations that the clusters allow.
class RankImex::System final : public SecondOrderSystem {
 public:
  /// explicitPart: of the elements that are not handled.
  System(RankImex& owner, const RankBody& explicitPart) : owner_(owner), explicit_(explicitPart) {}

  /// ghostsAreThere: at the positions that the first acceleration is asked for.
  void beginStep(bool ghostsAreThere) {
    ghostsAreThere_ = ghostsAreThere;
    failed_.reset();
  }
  const std::optional<ClusterFault>& failed() const { return failed_; }

  void acceleration(double, const NodeVectors& x, const NodeVectors& v, NodeVectors& a) override {
    const NodeVectors& at = ghostsAreThere_ ? x : withGhosts(x);
    ghostsAreThere_ = false;
    explicit_.body().internalForce(at, force_, workspace_);
    owner_.place_->system.accelerationOfForce(force_, at, v, a);
    for (HandledWork& work : owner_.works_) work.begin(at, a);
    const auto failed =
        solveClusters(owner_.place_->part.body(), owner_.clusters_, owner_.freeOfTorque_, at, v, owner_.h_, a, reasons_,
                      [&](std::size_t k) { return owner_.clusters_[k].solveOrTell(at, a, v); });
    if (failed && !failed_) failed_ = failed;
    for (HandledWork& work : owner_.works_) work.end(v, a);
  }
  int threads() const override { return owner_.place_->part.body().threads(); }
  bool velocityDependent() const override { return owner_.settings_.scheme.c() != 0; }

 private:
  const NodeVectors& withGhosts(const NodeVectors& x) {
    x_ = x;
    owner_.place_->halo.exchange(x_);
    return x_;
  }

  RankImex& owner_;
  const RankBody& explicit_;
  bool ghostsAreThere_ = false;
  std::optional<ClusterFault> failed_;
  std::vector<std::string_view> reasons_;
  NodeVectors x_, force_;
  Body::Workspace workspace_;
};

RankImex::RankImex(const Scene& scene, Body& whole, double h)
    : h_(h),
      whole_(&whole),
      handler_(std::make_unique<Imex>(whole, integratorCatalog().make(scene.method), scene.handlerOptions)),
      tracker_(MonitorOptions{}.clearObservations) {
  const std::string file = scene.file.string();
  const auto settings = handler_->newtonSettings(h);
  if (!settings)
    throw InputError(file +
                     ": handler.method: \"imex\" is distributed over ranks with nonlinear equations alone, and for "
                     "these laws it takes linear ones; set handler.solver = \"newton\"");
  settings_ = *settings;
  handler_->prepare(whole.mesh().X, h);
  handling_.elements = static_cast<std::int64_t>(handler_->elements().size());
  handling_.certified = handler_->certified();
  handling_.selections = 1;
  handling_.evaluations = handler_->selectionCost().evaluations;
  if (handler_->explicitBody().mesh().elementCount() == 0)
    throw InputError(file +
                     ": integrator.step: the handler takes every element, which is not distributed over ranks; take a "
                     "smaller step, or run the scene with one process, without mpirun");
}

RankImex::~RankImex() = default;

void RankImex::adapt(Partition& partition) {
  for (const std::vector<ElementRef>& elements : clustersOf(*whole_, handler_->elements()))
    keepTogether(partition, nodesOfElements(*whole_, elements));
}

std::unique_ptr<RankBody> RankImex::explicitPart(const Partition& partition, int rank, int threads) {
  if (stepsAsBase()) return nullptr;
  auto part = std::make_unique<RankBody>(handler_->explicitBody(), partition, rank, threads);
  part->nameElementsBy(elementNumbers(complement(handler_->chosen())));
  return part;
}

void RankImex::begin(const Place& place) {
  place_.emplace(place);
  const Body& body = place.part.body();
  const std::vector<ElementRef> handled = elementsOfPart(place.part, handler_->chosen());
  handler_.reset();
  for (std::vector<ElementRef>& elements : clustersOf(body, handled)) {
    works_.emplace_back(body, elements, h_, 1);
    const NewtonCluster& cluster = clusters_.emplace_back(body, std::move(elements), settings_.scheme,
                                                          settings_.tolerance, settings_.mostProducts);
    freeOfTorque_.push_back(settings_.keepsMomentum && isFreeOfTorque(body, cluster.elements(), cluster.nodes()));
  }
  determinants_.emplace(body, handled);
  system_ = std::make_unique<System>(*this, place.explicitPart);
}

StepStatus RankImex::step(State& state, double h) {
  before_ = state;
  for (HandledWork& work : works_) work.mark();
  system_->beginStep(baseAcceleration_.cols() == 0);
  state.a.swap(baseAcceleration_);
  place_->integrator.step(*system_, state, h);
  state.a.swap(baseAcceleration_);
  state.a.resize(3, 0);
  std::optional<ElementRef> failed;  // the first element of the cluster
  std::string reason;
  if (const std::optional<ClusterFault>& fault = system_->failed()) {
    const std::vector<ElementRef>& elements = clusters_[fault->cluster].elements();
    failed = place_->part.globalElement(elements.front());
    reason = fault->text(elements.size(), *failed);
  }
  Ranks& ranks = place_->ranks;
  if (const std::optional<ElementRef> first = ranks.first(failed)) {
    state = before_;
    for (HandledWork& work : works_) work.revert();
    baseAcceleration_.resize(3, 0);
    place_->integrator.reset();
    return {false, ranks.shareText(reason, ranks.firstWhere(failed == first))};
  }
  place_->halo.begin(state.x);
  return {};
}

std::optional<MonitorEvent> RankImex::watch(const MonitorReport& report, NodeVectorsView x) {
  // Largest of all ranks: minus the least determinant, and whether one is not a number.
  const auto least = determinants_->at(x);
  std::array<double, 2> told{-std::numeric_limits<double>::infinity(), 0};
  if (least) told = {std::isnan(least->value) ? 0 : -least->value, std::isnan(least->value) ? 1.0 : 0.0};
  const double own = told[0];
  place_->ranks.largest(told);
  if (told[1] != 0) return std::nullopt;  // positions are not finite, which the monitor tells
  std::optional<ElementRef> mine;
  if (least && own == told[0]) mine = place_->part.globalElement(least->element);
  const std::optional<ElementRef> element = place_->ranks.first(mine);
  const auto allowsInversion = [&] {
    return place_->part.body().blocks()[element->block]->material().info().allowsInversion;
  };
  if (!element || told[0] < 0 || allowsInversion()) {
    tracker_.absent(EventKind::inverted, report.step);
    return std::nullopt;
  }
  if (!tracker_.isNew(EventKind::inverted)) return std::nullopt;
  return tracker_.begin({.kind = EventKind::inverted,
                         .step = report.step,
                         .time = report.time,
                         .value = -told[0],
                         .handled = true,
                         .element = element});
}

double RankImex::dissipated() {
  ExactSum sum;
  for (const HandledWork& work : works_) sum.add(work.dissipated());
  place_->ranks.sum({&sum, 1});
  return sum.value();
}

Handling RankImex::handling() {
  NewtonCounts counts;
  for (const NewtonCluster& cluster : clusters_) counts.add(cluster);
  std::array<std::int64_t*, 5> numbers{&counts.clusters, &counts.iterations, &counts.products, &counts.stalls,
                                       &counts.eulerSteps};
  std::array<ExactSum, numbers.size()> sums;
  for (std::size_t i = 0; i < numbers.size(); ++i) sums[i].add(static_cast<double>(*numbers[i]));
  place_->ranks.sum(sums);
  for (std::size_t i = 0; i < numbers.size(); ++i) *numbers[i] = static_cast<std::int64_t>(sums[i].value());
  counts.largestNodes = -place_->ranks.least(-counts.largestNodes);
  Handling result = handling_;
  result.figures = counts.figures();
  return result;
}

}  // namespace ringwatch
