#include <ringwatch/handlers/local_time_stepping/local_time_stepping.h>

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/body/nodes_of.h>
#include <ringwatch/handlers/angular_momentum.h>
#include <ringwatch/materials/st_venant_kirchhoff.h>
#include <ringwatch/monitor/bounds/reduced_ring.h>

namespace ringwatch {
namespace {

/// Of the stabilised filters: the least N over the largest, which is 0 without damping, where the filter takes all
/// force from some modes. With a shift c = 0 it costs 1.3 % of the range for 2 substeps and 1.7 % for many.
constexpr double damping = 0.05;

/// Each level more costs some of the range of those above it.
constexpr std::size_t mostFineLevels = 3;

/// Of the steps of a level to those of the next, that plans try.
const std::vector<int> ratios{2, 3, 4, 5, 6, 8, 12, 16, 24, 32, 48, 64, 128, 256, 512, 1024, 2048, 4096};

/// c_k by the ceiling. Where levels meet each has only some of a node's elements, thus needs only some of its mass.
constexpr double coarseShare = 0.85;

/// An element's share of one evaluation beyond its own force, in elements: calls and sums over nodes of a small part.
constexpr double callCost = 20, implicitCost = 60;

}  // namespace

double marginOfLocalTimeStepping(std::string_view law) {
  constexpr double stiffening = 0.3;
  return law == StVenantKirchhoff::name ? stiffening : defaultMargin;
}

/// The base scheme's view of the body.
class LocalTimeStepping::Averaged final : public SecondOrderSystem {
 public:
  Averaged(LocalTimeStepping& owner, double h) : owner_(owner), h_(h) {}
  void acceleration(double, const NodeVectors& x, const NodeVectors& v, NodeVectors& a) override {
    owner_.averagedAcceleration(x, v, h_, a);
  }
  int threads() const override { return owner_.body_.threads(); }
  bool velocityDependent() const override { return owner_.dissipation_ != 0 || owner_.options_.damping.alpha != 0; }

 private:
  LocalTimeStepping& owner_;
  double h_;
};

LocalTimeStepping::LocalTimeStepping(Body& body, std::unique_ptr<Integrator> base, HandlerOptions options)
    : EnergyLimitedHandler(description, body, std::move(base), std::move(options)),
      stabilised_(options_.own.text("variant") == variants[0]),
      levelLimit_(options_.own.integer("levels")),
      dissipation_(options_.own.number("dissipation")),
      keepsMomentum_(keepsMomentum(options_.own)),
      cluster_(clusterOptionsOf(options_.own)) {
  // Imex takes over without damping alone.
  if (!options_.damping.any()) limitEnergy(options_.own.number("energy_limit"));
}

double LocalTimeStepping::deepest(double h) const { return std::pow(4.0, levelLimit_) * allowedLambda(h); }

std::vector<LocalTimeStepping::Level> LocalTimeStepping::plan(const std::vector<std::vector<double>>& lambdas,
                                                              double h) const {
  std::vector<double> sorted;
  for (const auto& block : lambdas) sorted.insert(sorted.end(), block.begin(), block.end());
  std::sort(sorted.begin(), sorted.end());
  const auto count = static_cast<double>(sorted.size());
  const double marginFactor = allowedLambda(h) * h * h / 4;  // (1 - margin)²
  const auto below = [&](double lambda) {
    return static_cast<double>(std::upper_bound(sorted.begin(), sorted.end(), lambda) - sorted.begin());
  };
  const double deep = count - below(deepest(h));
  const double weights[]{stabilised_ ? topWeight(h) : 1, 1}, share = stabilised_ ? coarseShare : 0,
                                                             least = stabilised_ ? damping : 0;
  // Ceilings only scale the filters: their range over that of p small steps, [ratio][whether inner].
  std::vector<double> ranges;
  for (const int p : ratios)
    for (const double weight : weights)
      ranges.push_back(chebyshevFilter(p, 1, share, weight, least).range / (1.0 * p * p));

  struct Step {
    int substeps;
    double ceiling;
  };
  std::vector<Step> best, steps{{1, 4}};
  double leastCost = infinity;
  const auto extend = [&](const auto& self, double cost, double counted) -> void {  // every ascending choice of steps
    if (cost >= leastCost) return;
    const auto [substeps, ceiling] = steps.back();
    const double own = std::max(0.0, below(ceiling * marginFactor * substeps * substeps / (h * h)) - counted),
                 left = count - counted - own, total = cost + substeps * (own + (substeps > 1 ? callCost : 0));
    const double whole = total + substeps * implicitCost * left;
    if ((left <= deep || substeps == 1 << levelLimit_) && whole < leastCost) {
      leastCost = whole;
      best = steps;
    }
    if (steps.size() > mostFineLevels) return;
    for (std::size_t p = 0; p < ratios.size() && substeps * ratios[p] <= 1 << levelLimit_; ++p) {
      steps.push_back({substeps * ratios[p], ceiling * ranges[2 * p + (steps.size() > 1)]});
      self(self, total, counted + own);
      steps.pop_back();
    }
  };
  extend(extend, 0, 0);

  std::vector<Level> levels;
  for (std::size_t k = 0; k < best.size(); ++k) {
    const auto [substeps, ceiling] = best[k];
    Level& level = levels.emplace_back();
    level.substeps = substeps;
    level.lambda = ceiling * marginFactor * substeps * substeps / (h * h);
    level.massShare = k + 1 < best.size() && stabilised_ ? share : 1;
    if (k > 0)
      level.filter = chebyshevFilter(substeps / best[k - 1].substeps, best[k - 1].ceiling, share * best[k - 1].ceiling,
                                     weights[k > 1], least);
  }
  return levels;
}

double LocalTimeStepping::topWeight(double h) const {
  return (1 + 2 * dissipation_) / (1 - 0.5 * h * options_.damping.alpha);
}

Eigen::VectorXd LocalTimeStepping::massBeside(const ElementFlags& finer, double share) const {
  Eigen::VectorXd mass = body_.lumpedMass();
  for (const ElementRef e : chosenElements(finer))
    for (const std::int32_t node : body_.blocks()[e.block]->nodesOf(e.element))
      mass[node] = share * body_.lumpedMass()[node];
  return mass;
}

ElementFlags LocalTimeStepping::finerThan(const Level& level, const ElementFlags& left, const NodeVectors& x,
                                          ElementFlags finer, std::int64_t& evaluations) const {
  if (options_.selection != Selection::certified) {
    const ElementFlags high = selectByReducedRing(body_, x, level.lambda);
    evaluations += static_cast<std::int64_t>(body_.mesh().elementCount());
    for (std::size_t b = 0; b < finer.size(); ++b)
      for (std::size_t e = 0; e < finer[b].size(); ++e) finer[b][e] = finer[b][e] || (high[b][e] && left[b][e]);
    return finer;
  }
  // What leaves takes mass away from its neighbours, which may make them leave too.
  const auto numbers = elementNumbers(left);
  for (std::size_t count = chosenElements(finer).size();;) {
    const Body rest = partWithMass(left, massBeside(finer, level.massShare));
    ElementFlags keep = noElements(rest.mesh());
    for (std::size_t b = 0; b < numbers.size(); ++b)
      for (std::size_t i = 0; i < numbers[b].size(); ++i) keep[b][i] = finer[b][numbers[b][i]];
    const CertifiedSelection selection = selectCertified(rest, x, level.lambda, keep);
    evaluations += selection.evaluations;
    for (const ElementRef e : chosenElements(selection.chosen)) finer[e.block][numbers[e.block][e.element]] = true;
    const std::size_t now = chosenElements(finer).size();
    if (now == count) return finer;
    count = now;
  }
}

ElementFlags LocalTimeStepping::choose(const NodeVectors& x, double h, const ElementFlags& keep) {
  levels_.clear();
  watches_.clear();
  ElementFlags chosen = Handler::choose(x, h, keep);
  if (imex() || chosenElements(chosen).empty()) return chosen;
  ReducedRing rings(body_);
  std::vector<std::vector<double>> lambdas = rings.evaluate(x).largest;
  idealShare_ = smallest_ = 0;
  double count = 0;
  for (auto& block : lambdas)
    for (double& lambda : block) {
      if (std::isnan(lambda)) lambda = infinity;
      const double steps = std::sqrt(lambda / allowedLambda(h));
      idealShare_ += std::max(1.0, steps);
      smallest_ = std::max(smallest_, steps);
      ++count;
    }
  idealShare_ /= count;
  // The estimate may be below what the selection proves: elements that the last level cannot have are taken for
  // stiffer, and the plan is made again.
  constexpr int attempts = 30;
  std::int64_t evaluations = selectionCost().evaluations;
  for (int attempt = 0;; ++attempt) {
    std::vector<Level> levels = plan(lambdas, h);
    ElementFlags left = complement(noElements(body_.mesh()));
    for (std::size_t k = 0; k < levels.size(); ++k) {
      Level& level = levels[k];
      // Level 0 has the limit of the whole choice, in every plan.
      ElementFlags finer = finerThan(level, left, x, k == 0 ? chosen : noElements(body_.mesh()), evaluations);
      if (k == 0) chosen = finer;
      level.elements = left;
      for (const ElementRef e : chosenElements(finer)) level.elements[e.block][e.element] = false;
      left = std::move(finer);
    }
    bool again = false;
    if (levels.back().substeps < 1 << levelLimit_)
      for (const ElementRef e : chosenElements(left)) {
        double& lambda = lambdas[e.block][e.element];
        if (!(lambda <= deepest(h))) continue;
        lambda = std::max(lambda, levels.back().lambda) * 1.1;
        again = true;
      }
    if (again && attempt < attempts) continue;
    noteSelectionCost({static_cast<std::int64_t>(body_.mesh().elementCount()), evaluations});
    implicit_ = std::move(left);
    levels_ = std::move(levels);
    const bool deep = !chosenElements(implicit_).empty();
    while (!deep && levels_.size() > 1 && chosenElements(levels_.back().elements).empty()) levels_.pop_back();
    return chosen;
  }
}

void LocalTimeStepping::takeOwn(const NodeVectors& x, double h, const ElementFlags& chosen) {
  std::vector<FineLevel> fine;
  for (std::size_t k = 1; k < levels_.size(); ++k)
    fine.push_back({levels_[k].elements, levels_[k].filter, h / levels_[k - 1].substeps});
  const Level& last = levels_.back();
  const double marginFactor = allowedLambda(h) * h * h / 4, step = h / last.substeps,
               ceiling = last.lambda * step * step / marginFactor;
  if (fine.empty()) fine.push_back({noElements(body_.mesh()), {}, h});
  // A tenth more than at rest: K̂ is kept while elements turn by a few hundredths (ImplicitCluster).
  constexpr double lag = 1.1;
  const double weight = lag * (levels_.size() == 1 ? topWeight(h) : 1);
  filter_.emplace(body_, std::move(fine), implicit_, weight * step * step / ceiling, x, cluster_);
  detach(chosen, massBeside(chosen, levels_.front().massShare));

  std::vector<std::int32_t> position(body_.nodeCount(), -1);
  for (std::size_t i = 0; i < filter_->nodes().size(); ++i)
    position[filter_->nodes()[i]] = static_cast<std::int32_t>(i);
  fineClusters_.clear();
  for (const auto& elements : clustersOf(body_, chosenElements(chosen))) {
    FineCluster& cluster = fineClusters_.emplace_back();
    cluster.nodes = nodesOfElements(body_, elements);
    for (const std::int32_t node : cluster.nodes) cluster.places.push_back(position[node]);
    cluster.freeOfTorque = keepsMomentum_ && isFreeOfTorque(body_, elements, cluster.nodes);
  }
  countWork(h);
}

void LocalTimeStepping::addStrainVelocity(const NodeVectors& x, const NodeVectors& v, double share) {
  const auto& nodes = filter_->nodes();
  for (const FineCluster& one : fineClusters_) {
    const auto& cluster = one.places;
    double mass = 0;
    Eigen::Vector3d centre = Eigen::Vector3d::Zero(), drift = Eigen::Vector3d::Zero();
    for (const std::int32_t i : cluster) {
      const std::int32_t node = nodes[i];
      const double m = body_.lumpedMass()[node];
      mass += m;
      centre += m * x.col(node);
      drift += m * v.col(node);
    }
    centre /= mass;
    drift /= mass;
    Eigen::Vector3d angular = Eigen::Vector3d::Zero();
    Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
    for (const std::int32_t i : cluster) {
      const std::int32_t node = nodes[i];
      const double m = body_.lumpedMass()[node];
      const Eigen::Vector3d arm = x.col(node) - centre;
      angular += m * arm.cross(v.col(node));
      inertia += m * (arm.squaredNorm() * Eigen::Matrix3d::Identity() - arm * arm.transpose());
    }
    const Eigen::Vector3d spin = inertia.inverse() * angular;  // of a tetrahedron at least, so not singular
    for (const std::int32_t i : cluster) {
      const std::int32_t node = nodes[i];
      fineX_.col(i) += share * (v.col(node) - drift - spin.cross(x.col(node) - centre));
    }
  }
}

void LocalTimeStepping::averagedAcceleration(const NodeVectors& x, const NodeVectors& v, double h, NodeVectors& a) {
  explicitAcceleration(x, a);
  work().begin(x, a);
  const auto& nodes = filter_->nodes();
  const Eigen::Index n = nodes.size();
  fineX_.resize(3, n);
  fineA_.resize(3, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    fineX_.col(i) = x.col(nodes[i]);
    fineA_.col(i) = a.col(nodes[i]);
  }
  if (dissipation_ != 0) addStrainVelocity(x, v, dissipation_ * h);
  std::string fault = filter_->apply(fineX_, fineA_);
  if (fault_.empty()) fault_ = std::move(fault);
  for (Eigen::Index i = 0; i < n; ++i) fineA_.col(i).swap(a.col(nodes[i]));
  // The coarse elements have no torque about x, but the average of their forces has.
  for (const FineCluster& cluster : fineClusters_)
    if (cluster.freeOfTorque) keepAngularMomentum(body_, cluster.nodes, x, v, h, fineA_(Eigen::all, cluster.places), a);
  work().end(v, a);
  // The damping is counted with that of the run.
  if (options_.damping.alpha == 0) return;
  a -= options_.damping.alpha * v;
  body_.constraints().clearConstrained(a);
}

StepStatus LocalTimeStepping::ownStep(SecondOrderSystem& system, State& state, double h) {
  if (system.velocityDependent() && options_.damping.alpha == 0)
    throw InputError("local-time-stepping: the system has damping that the handler was not made for");
  Averaged averaged(*this, h);
  fault_.clear();
  return baseStep(averaged, state, h, fault_);
}

void LocalTimeStepping::giveUp() {
  EnergyLimitedHandler::giveUp();
  levels_.clear();
  watches_.clear();
}

std::string LocalTimeStepping::uncertifiedPart(const NodeVectors& x) {
  if (watches_.empty()) {
    const double marginFactor = (1 - margin()) * (1 - margin());
    ElementFlags finer = implicit_;
    for (std::size_t k = levels_.size(); k-- > 1;) {
      const Level& level = levels_[k];
      const auto elements = chosenElements(level.elements);
      if (!elements.empty())
        watches_.emplace_back(body_, level.elements, massBeside(finer, level.massShare), level.lambda / marginFactor,
                              level.substeps);
      for (const ElementRef e : elements) finer[e.block][e.element] = true;
    }
  }
  for (LevelWatch& watch : watches_)
    if (!watch.certifies(x))
      return joinText("the elements that take ", watch.substeps(), " steps in each are no longer proven stable");
  return {};
}

std::int64_t LocalTimeStepping::evaluations() const {
  const auto count = [](const ElementFlags& flags) { return static_cast<std::int64_t>(chosenElements(flags).size()); };
  std::int64_t sum = levels_.empty() ? 0 : levels_.back().substeps * count(implicit_);
  for (const Level& level : levels_) sum += level.substeps * count(level.elements);
  return sum;
}

std::vector<HandlerFigure> LocalTimeStepping::figures() const {
  std::vector<HandlerFigure> result{{"implicit_steps", static_cast<double>(imexSteps())}};
  if (levels_.empty()) return result;
  for (const Level& level : levels_)
    result.push_back({joinText("elements_at_step_over_", level.substeps),
                      static_cast<double>(chosenElements(level.elements).size())});
  const auto count = static_cast<double>(body_.mesh().elementCount());
  result.push_back({"implicit_elements", static_cast<double>(chosenElements(implicit_).size())});
  result.push_back({"evaluations_an_element_and_step", static_cast<double>(evaluations()) / count});
  result.push_back({"ideal_speed_up", smallest_ / idealShare_});
  result.push_back({"speed_up_in_evaluations", smallest_ * count / static_cast<double>(evaluations())});
  return result;
}

}  // namespace ringwatch
