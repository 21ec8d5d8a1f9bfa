#include <ringwatch/handlers/handler.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include <ringwatch/base/error.h>
#include <ringwatch/base/parallel.h>
#include <ringwatch/body/domain.h>
#include <ringwatch/handlers/imex/implicit_cluster.h>

namespace ringwatch {

bool takesHandler(const IntegratorInfo& info) {
  return info.imaginaryLimit == 2 && info.forceEvaluations == 1 && info.symplectic && !info.adaptive &&
         !info.partitioned;
}

bool HandlerInfo::takes(Selection selection) const {
  return std::ranges::find(selections, selection) != selections.end();
}

double marginFor(const HandlerInfo& info, const Body& body) {
  double margin = defaultMargin;
  if (info.marginOfLaw)
    for (const auto& block : body.blocks()) margin = std::max(margin, info.marginOfLaw(block->material().lawName()));
  return margin;
}

HandlerOptions optionsFor(const HandlerInfo& info, const HandlerOptions& options) {
  HandlerOptions result{
      info.takes(options.selection) ? options.selection : info.selections.front(), options.margin, {}, options.damping};
  // Those that others depend on come first.
  for (const bool dependent : {false, true})
    for (const OptionInfo& option : info.options) {
      const OptionValue* value = options.own.find(option.name);
      if (!value || option.onlyWith.option.empty() == dependent) continue;
      Options with = result.own;
      if (optionFault(info.options, with.set(option.name, *value), option.name).empty()) result.own = std::move(with);
    }
  return result;
}

Handler::Handler(const HandlerInfo& info, Body& body, std::unique_ptr<Integrator> base, HandlerOptions options)
    : body_(body), base_(std::move(base)), options_(std::move(options)), info_(info), chosen_(noElements(body.mesh())) {
  if (!takesHandler(base_->info())) {
    std::string names;
    for (const IntegratorEntry& entry : coreIntegrators())
      if (takesHandler(*entry.info)) names += joinText(names.empty() ? "" : " and ", entry.info->name);
    throw InputError(joinText("handlers work on ", names, ", not on \"", base_->info().name, "\""));
  }
  if (!body_.constraints().rigidBodies().empty()) throw InputError("handlers take no rigid bodies");
  if (!info.takes(options_.selection)) {
    std::string names;
    for (const Selection one : info.selections)
      names += joinText(names.empty() ? "" : " or ", selectionNames.nameOf(one));
    throw InputError(
        joinText(info.name, ": selection \"", selectionNames.nameOf(options_.selection), "\": must be ", names));
  }
  if (!options_.margin) options_.margin = marginFor(info, body);
  if (!(margin() >= 0 && margin() < 1)) throw InputError(joinText("margin ", margin(), ": must be >= 0 and < 1"));
  if (options_.damping.alpha != 0 && !info.takesMassDamping)
    throw InputError(joinText(info.name, " works without mass-proportional damping"));
  if (options_.damping.beta != 0 && !info.takesStiffnessDamping)
    throw InputError(joinText(info.name, " works without stiffness-proportional damping"));
  options_.own = completed(info.name, info.options, options_.own);
}

void Handler::prepare(const NodeVectors& x, double h) { prepareFor(x, h, {}); }

void Handler::prepare(const NodeVectors& x, double h, const CutMesh& cut, const Handler& before) {
  inherit(before);
  chosen_ = carriedOver(cut, before.chosen_);
  selection_ = before.selection_;
  selection_.carryOver(cut);
  if (options_.selection == Selection::certified) {
    // What stands beside the cut may be given back.
    const std::vector<bool> near = touchedNodes(body_, cut.changed);
    for (const ElementRef e : chosenElements(chosen_))
      for (const std::int32_t node : nodesOf(e))
        if (near[node]) chosen_[e.block][e.element] = false;
  }
  prepareFor(x, h, cut.changed);
}

void Handler::prepareFor(const NodeVectors& x, double h, const ElementFlags& candidates) {
  if (!(h > 0) || !std::isfinite(h)) throw InputError(joinText("step ", h, " s: must be > 0 and finite"));
  candidates_ = candidates;
  ElementFlags chosen = choose(x, h, chosen_);
  h_ = h;
  certified_ = options_.selection != Selection::fierzRing;
  handle(std::move(chosen), x);
}

void Handler::prepareAs(const Handler& other, const NodeVectors& x) {
  h_ = other.h_;
  certified_ = other.certified_;
  handle(other.chosen_, x);
}

void Handler::prepareAsPart(const Handler& whole, const Body* explicitPart) {
  inherit(whole);
  h_ = whole.h_;
  certified_ = whole.certified_;
  selectionCost_ = whole.selectionCost_;
  ofPart_ = explicitPart;
  handled_ = whole.handled_;
  ElementFlags chosen = noElements(body_.mesh());
  for (std::size_t b = 0; b < chosen.size(); ++b)
    for (std::size_t e = 0; e < chosen[b].size(); ++e) {
      const ElementRef there = body_.domain().inWhole({b, e});
      chosen[b][e] = whole.chosen_[there.block][there.element];
    }
  handle(std::move(chosen), body_.mesh().X);
}

void Handler::handle(ElementFlags chosen, const NodeVectors& x) {
  chosen_ = std::move(chosen);
  elements_ = chosenElements(chosen_);
  if (body_.domain().whole()) handled_ = static_cast<std::int64_t>(elements_.size());
  determinants_.emplace(body_, elements_);
  reset();
  if (handled_ > 0) take(x, h_, chosen_);
}

double Handler::dissipated() const {
  ExactSum sum;
  for (const HandledWork& work : works_) sum.add(work.dissipated());
  body_.domain().sum({&sum, 1});
  return dissipatedBefore_ + sum.value();
}

void Handler::closeWork() {
  dissipatedBefore_ = dissipated();
  works_.clear();
}

void Handler::countWork(double h) {
  closeWork();
  if (body_.domain().whole())
    works_.emplace_back(body_, elements_, h, body_.threads());
  else
    for (const std::vector<ElementRef>& elements : clustersOf(body_, elements_))
      works_.emplace_back(body_, elements, h, 1);
}

ElementFlags Handler::chooseFor(const NodeVectors& x, double lambda, const ElementFlags& keep) {
  if (options_.selection == Selection::certified) {
    const ElementFlags chosen = selection_.choose(body_, x, lambda, keep).chosen;
    selectionCost_ = {selection_.evaluatedElements(), selection_.last().evaluations};
    return chosen;
  }
  const bool rings = options_.selection == Selection::fierzRing;
  ElementFlags chosen =
      rings ? selectByReducedRing(body_, x, lambda, candidates_) : selectBySingleElement(body_, x, lambda);
  const std::size_t count =
      rings && !candidates_.empty() ? chosenElements(candidates_).size() : body_.mesh().elementCount();
  selectionCost_.elements = selectionCost_.evaluations = static_cast<std::int64_t>(count);
  for (std::size_t b = 0; b < keep.size(); ++b)
    for (std::size_t e = 0; e < keep[b].size(); ++e) chosen[b][e] = chosen[b][e] || keep[b][e];
  return chosen;
}

const CertifiedSelection* Handler::certificate() const {
  return options_.selection == Selection::certified ? &selection_.last() : nullptr;
}

double largestEigenvalueFor(double h, double margin, double limit, const RayleighDamping& damping) {
  if (!damping.any()) {
    const double omega = (1 - margin) * limit / h;
    return omega * omega;
  }
  const double room = 1 - 0.5 * h * damping.alpha;
  if (!(room > 0))
    throw InputError(joinText("step ", h, " s: mass-proportional damping of ", damping.alpha,
                              " 1/s needs a step below ", 2 / damping.alpha, " s"));
  const double withMargin = 1 - margin;
  return withMargin * withMargin * room / (0.25 * h * h + 0.5 * h * damping.beta);
}

namespace {
void requirePrepared(double h, double prepared) {
  if (h != prepared) throw InputError(joinText("step ", h, " s: the handler was prepared for ", prepared, " s"));
}
}  // namespace

StepStatus Handler::step(SecondOrderSystem& system, State& state, double h) {
  if (handled_ > 0) requirePrepared(h, h_);
  return stepsAsBase() ? base_->step(system, state, h) : handledStep(system, state, h);
}

StepStatus Handler::advance(SecondOrderSystem& system, State& state, double h) {
  if (handled_ > 0) requirePrepared(h, h_);
  return stepsAsBase() ? base_->advance(system, state, h) : handledStep(system, state, h);
}

bool Handler::beginsWithAcceleration() const {
  return stepsAsBase() ? base_->beginsWithAcceleration() : handledBeginsWithAcceleration();
}

StepStatus Handler::baseStep(SecondOrderSystem& system, State& state, double h, const std::string& fault) {
  before_ = state;
  for (HandledWork& work : works_) work.mark();
  ghostsAreThere_ = baseAcceleration_.cols() == 0;
  state.a.swap(baseAcceleration_);
  const StepStatus status = base_->step(system, state, h);
  state.a.swap(baseAcceleration_);
  state.a.resize(3, 0);
  if (status.done && fault.empty()) return status;
  takeBack(state);
  return status.done ? StepStatus{false, fault} : status;
}

void Handler::takeBack(State& state) {
  state = before_;
  for (HandledWork& work : works_) work.revert();
  reset();
}

std::optional<Body::LeastDeterminant> Handler::leastHandledDeterminant(const NodeVectors& x) const {
  return explicitPart_ || ofPart_ ? leastDeterminantOfChosen(x) : std::nullopt;
}

std::optional<Body::LeastDeterminant> Handler::leastDeterminantOfChosen(const NodeVectors& x) const {
  return determinants_ ? determinants_->at(x) : std::nullopt;
}

void Handler::detach(const ElementFlags& chosen, const Eigen::VectorXd& mass) {
  inverseMass_ = body_.lumpedMass().cwiseInverse();
  if (ofPart_) return;
  const ElementFlags left = complement(chosen);
  numbers_ = elementNumbers(left);
  if (mass.size() == 0)
    explicitPart_.emplace(body_, left);
  else
    explicitPart_.emplace(partWithMass(left, mass));
}

void Handler::explicitAcceleration(const NodeVectors& x, NodeVectors& a) {
  const NodeVectors& at = std::exchange(ghostsAreThere_, false) ? x : body_.domain().withGhosts(x);
  explicitBody().internalForce(at, explicitForce_, explicitWorkspace_);
  a.resize(3, x.cols());
  const auto accelerate = [&](Eigen::Index i) {
    a.col(i) = (body_.externalForce().col(i) - explicitForce_.col(i)) * inverseMass_[i];
  };
  parallelFor(0, x.cols(), body_.threads(), accelerate, nodesOfAThread);
  body_.constraints().clearConstrained(a);
  a.rightCols(a.cols() - body_.domain().owned(a.cols())).setZero();
}

Body Handler::partWithMass(const ElementFlags& elements, const Eigen::VectorXd& mass) const {
  std::vector<std::int32_t> nodes(body_.mesh().nodeCount());
  std::iota(nodes.begin(), nodes.end(), 0);
  Body part = bodyOf(body_, elements, nodes, mass);
  part.constraints() = body_.constraints();
  return part;
}

ElementRef Handler::toParentElement(ElementRef part) const {
  if (!explicitPart_) return part;
  return {part.block, numbers_[part.block][part.element]};
}

}  // namespace ringwatch
