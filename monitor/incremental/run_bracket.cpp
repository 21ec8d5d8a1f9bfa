#include <ringwatch/monitor/incremental/run_bracket.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/base/rounding.h>
#include <ringwatch/body/discrete_forces.h>
#include <ringwatch/monitor/bounds/rayleigh.h>
#include <ringwatch/monitor/bounds/top_mode.h>
#include <ringwatch/monitor/critical_step.h>

namespace ringwatch {

RunBracket::RunBracket(const Body& body, double width, double budget, std::int64_t steps, double inAdvance,
                       std::int64_t every, const BracketPolicy& policy)
    : body_(body),
      policy_(policy),
      width_(width),
      slack_(policy.slackOfWidth * width),
      account_(body, budget, steps, inAdvance, every),
      nodal_(body, {.slack = policy.slackOfWidth * width}, &account_),
      exchange_(body, nodal_.weights(), account_),
      local_(body, nodal_.weights(), policy.localProducts, policy.localGap),
      scout_(body, nodal_.weights(), policy.localProducts, policy.localGap),
      stiff_(body, nodal_.weights()),
      localNodes_(policy.leastLocalNodes),
      ringNodes_(body, nodal_.weights()),
      softest_(body),
      cheapest_(Backoff::Gaps::fixed(policy.firstGap)),
      sharpening_(Backoff::Gaps::fixed(policy.sharpenGap)),
      sharpeningRestart_(Backoff::Gaps::fixed(policy.firstGap)),
      wholeMode_(policy.wholeMode),
      restart_(policy.restarts),
      search_(policy.searches),
      examination_(Backoff::Gaps::fixed(policy.firstGap)) {}

const std::optional<CriticalStep>& RunBracket::evaluate(NodeVectorsView x, const StepRule& limit,
                                                        std::optional<double> h, StepEvaluation* evaluation) {
  const DiscreteForces::ContactAt contact(body_.discreteForces(), x);
  account_.earn(uncertified_);
  follow(x, limit, h, evaluation);
  if (step_ && h && account_.limited()) prepareRest(x);
  ++observations_;
  return step_;
}

void RunBracket::adaptSlack() {
  if (!account_.limited()) return;
  const double load = account_.load(), least = policy_.slackOfWidth * width_;
  if (load > 1)
    slack_ *= 1 + policy_.widening * std::min(load - 1, 1.0);
  else
    slack_ *= 1 - policy_.narrowing * (1 - load);
  slack_ = std::clamp(slack_, least, std::max(least, policy_.mostSlack));
  nodal_.setSlack(slack_);
}

void RunBracket::charge(WorkOn what, double work) {
  if (!observed()) return;  // the first proof is free
  if (what == WorkOn::searches)
    account_.spendOnSearches(work);
  else if (forVerdict_)
    account_.spendOnVerdict(work);
  else
    account_.spendOnMode(work);
  spent_[what] += work;
}

bool RunBracket::affords(double work) const {
  return !observed() || account_.affordsForMode(work) || (forVerdict_ && account_.affordsForVerdict(work));
}

bool RunBracket::affordsSearch(double work) const { return !observed() || account_.affordsForSearches(work); }

const std::optional<CriticalStep>& RunBracket::follow(NodeVectorsView x, const StepRule& limit, std::optional<double> h,
                                                      StepEvaluation* evaluation) {
  const double sigma = nodal_.certifiedEigenvalue();  // that allowances belong to
  const double ceiling = h ? limit.lambdaFor(*h) : infinity;
  adaptSlack();
  UpperBound nodal{infinity}, upper{infinity};
  const bool turns = restRuns_ && rest_->started() && !exchange_.serves() && followsFromRest(x, evaluation, upper),
             moves = turns || (!h && follows(x, evaluation, upper));
  // Under a budget the weights are not updated while shares prove more than they did, and the step.
  bool skips = moves || (account_.limited() && exchange_.serves() && !uncertified_);
  if (skips && !moves) {
    upper = exchange_.update(x, nodal, evaluation);
    evaluation = nullptr;
    skips = upper.value < std::min(sigma, ceiling);
  }
  if (skips) {
    nodal_.skip(turns ? rest_->seen() : moves ? moved_->seen() : exchange_.certificate().seen());
    finite_ = !std::isnan(upper.value);
  } else {
    nodal_.setSecondary(exchange_.serves());
    nodal = nodal_.update(x, evaluation, ceiling);
    finite_ = std::isfinite(nodal.value);
  }
  statistics_ = nodal_.statistics();
  bracketed_ = true;
  if (!finite_) {
    forget();
    return step_;
  }
  if (!skips) upper.value = std::min(nodal.value, exchange_.update(x, nodal).value);
  uncertified_ = h && *h > safeStep(upper, limit);
  method_ = "rayleigh-quotient";
  LowerBound lower{0};
  const bool first = mode_.size() == 0, rebuilt = statistics_.rebuilds > 0;
  LowerBound followed{0};
  if (!first) {
    followed = lower = boundOfRegion(x);
    wholeMode_.tick();
    if (wholeMode_.due() && affords(WorkAccount::ofProducts(body_, policy_.productsOfFollowing + 1))) {
      const LowerBound whole = refreshMode(x, policy_.productsOfFollowing);
      // It helps when the region is better for it: the whole mode's own bound is of this observation alone.
      wholeMode_.tried(regionBound_.value > (1 + policy_.leastGain) * lower.value);
      lower = higher(lower, whole);
    }
    lower = boundWhereItRose(x, sigma, lower);
    if (moves) {
      if (examineRingAt(x, turns ? rest_->highestNode() : moved_->highestNode(), lower))
        local_.choose(mode_, localNodes_);
    }
    forVerdict_ = uncertified_;
    lower = boundWhereItTouches(x, lower);
    forVerdict_ = false;
  }
  // A bracket that is too wide is either side's fault: bound it from below again before moving the upper side.
  const double highest = moves ? above(lower, width_) : nodal_.highest(lower, width_);
  const bool wide = upper.value > highest;
  if (wide) restart_.tick();
  if (first || ((rebuilt || (wide && restart_.due())) && affords(workOfRestart()))) {
    const double before = lower.value;
    lower = first ? startMode(x) : restartMode(x);
    restart_.tried(regionBound_.value > (1 + policy_.helpfulRestart) * before);
  }
  if (lower.value > followed.value) nodal_.correctLowerBound(followed, lower);
  searchUnderCompression(x);
  if (!skips) {
    nodal_.relaxBound(lower, width_, ceiling);
    nodal.value = std::max(nodal.value, nodal_.certifiedEigenvalue());
  }
  if (!moves)
    upper.value = std::min(nodal.value, exchange_.narrow(x, nodal, nodal_.takeTight(), mode_, lower, width_).value);
  if (!skips && upper.value > nodal_.highest(lower, width_) && nodal_.tightenBound(x, lower, width_)) {
    statistics_.evaluated += nodal_.statistics().evaluated;
    nodal = nodal_.update(x);
    upper.value = std::min(upper.value, nodal.value);
    statistics_.evaluated += nodal_.statistics().evaluated;
  }
  statistics_.evaluated += turns   ? rest_->statistics().elements
                           : moves ? moved_->statistics().evaluated
                                   : exchange_.evaluated();
  if (!moves && !h && account_.incomeForMode() > 0)
    gain_ += std::max(std::sqrt(upper.value / lower.value) - 1, 0.0) * workOfStepBesideMoved();
  step_ = CriticalStep{safeStep(upper, limit),
                       optimisticOf(lower, limit),
                       local_.highestElement(),
                       moves                       ? "moved-nodal-bound"
                       : upper.value < nodal.value ? "incremental-exchange-bound"
                                                   : "incremental-nodal-bound",
                       method_,
                       lowestHere_.value,
                       lowestHere_.element};
  step_->discreteShare = local_.discreteShare();
  step_->dampingShare = local_.dampingShare();
  nodal_.noteFrom(lower);
  if (!step_->isBracket()) step_.reset();
  return step_;
}

void RunBracket::prepareRest(NodeVectorsView x) {
  const bool affordsMaking = !observed() || account_.affords(WorkAccount::ofRebuild(body_));
  if (!rest_ || !rest_->started()) {
    restRuns_ = false;
    if (affordsMaking && !restFailed_ && RestBound::serves(body_)) makeRest(x);
  } else if (!restRuns_) {
    leastCertified_ = std::min(leastCertified_, nodal_.certifiedEigenvalue());
    if (exchange_.serves() || !(nodal_.certifiedEigenvalue() > policy_.risen * leastCertified_)) return;
    // From the next observation on: this one shows it how the body has moved up to here.
    rest_->update(x, nullptr, infinity, 0);
    spendOnSweeps(account_.force());
    restRuns_ = true;
  } else if (restEndedEarly_ && affordsMaking) {
    makeRest(x);
    rest_->update(x, nullptr, infinity, 0);
  }
}

void RunBracket::makeRest(NodeVectorsView x) {
  const bool first = !observed(), known = first && x == body_.mesh().X;
  // Weights of the first observation are of some other state perhaps, which bears on the width alone.
  NodalBound weights = first ? nodal_.weights() : nodal_.weightsAtRest();
  if (first && !known) weights.evaluate(body_.mesh().X, 0);
  if (!known) statistics_.evaluated += weights.evaluations();
  if (!first) spendOnSweeps(WorkAccount::ofRebuild(body_));
  restEndedEarly_ = first && nodal_.endedEarly();
  leastCertified_ = nodal_.certifiedEigenvalue();
  std::function<double(ElementRef)> value;
  if (known) value = [this](ElementRef e) { return nodal_.value(e); };
  rest_.emplace(body_);
  rest_->start(std::move(weights), value);
}

void RunBracket::spendOnSweeps(double work) {
  Work sweeps;
  sweeps[WorkOn::sweeps] = work;
  account_.spend(sweeps);
  spent_ += sweeps;
}

bool RunBracket::followsFromRest(NodeVectorsView x, StepEvaluation*& evaluation, UpperBound& upper) {
  const double enough = above(local_.last(), width_), ofProof = uncertified_ ? account_.availableForProof() : 0,
               affordable = account_.available() + ofProof;
  upper =
      rest_->update(x, evaluation, enough, static_cast<std::int64_t>(affordable / WorkAccount::ofReferences(body_, 1)));
  evaluation = nullptr;
  Work work;
  work[WorkOn::tests] = WorkAccount::ofMotions(body_);
  work[WorkOn::evaluations] = WorkAccount::ofReferences(body_, rest_->statistics().elements) +
                              WorkAccount::ofBoundedNodes(body_, rest_->statistics().nodes);
  spent_ += work;
  const double onProof = std::min(work[WorkOn::evaluations], ofProof);
  account_.spendOnProof(onProof);
  work[WorkOn::evaluations] -= onProof;
  account_.spend(work);
  restFailed_ = upper.value == infinity;
  if (restFailed_) restRuns_ = false;
  return !restFailed_;
}

bool RunBracket::follows(NodeVectorsView x, StepEvaluation*& evaluation, UpperBound& upper) {
  const double start = WorkAccount::ofRebuild(body_), enough = above(local_.last(), width_);
  const bool starts = !moved_;
  if (starts) {
    if (gain_ < start) return false;
    moved_.emplace(body_);
  }
  upper = moved_->update(x, evaluation);
  evaluation = nullptr;
  // Evaluations take as much again, at most, as the step that is shorter for a bound above what is wanted.
  const double lost = (std::sqrt(upper.value / enough) - 1) * workOfStepBesideMoved(),
               all = static_cast<double>(body_.mesh().elementCount());
  if (lost > 0)
    upper = moved_->improve(x, enough,
                            static_cast<std::int64_t>(all * std::min(lost / WorkAccount::ofEvaluation(body_), 1.0)));
  const double work = WorkAccount::ofMotion(body_, moved_->statistics().evaluated, moved_->statistics().visited);
  spent_[WorkOn::evaluations] += work;
  ofMoved_ += work;
  // The weights, which rest, have proven that last. Of steps that become shorter it takes more.
  const double longer = std::sqrt(nodal_.certifiedEigenvalue() / upper.value),
               saved = (longer > 1 ? longer - 1 : 1 - 1 / longer) * workOfStepBesideMoved();
  gain_ = starts ? start : std::min(gain_ + saved - work, start);
  if (upper.value < infinity && gain_ > 0) return true;
  moved_.reset();
  gain_ = 0;
  return false;
}

double RunBracket::workOfStepBesideMoved() const {
  return account_.force() +
         (spent().total() - ofMoved_) / static_cast<double>(std::max<std::int64_t>(observations_, 1));
}

bool RunBracket::certify(NodeVectorsView x, const StepRule& limit, double h, StepEvaluation* evaluation) {
  const DiscreteForces::ContactAt contact(body_.discreteForces(), x);
  account_.earn(uncertified_);
  const double sigma = limit.lambdaFor(h);
  std::int64_t before = 0;
  const auto certified = [&] {
    bracketed_ = false;
    finite_ = true;
    searchUnderCompression(x);
    ++observations_;
    return true;
  };
  if (exchange_.proves(sigma)) {
    const bool proven = exchange_.certify(x, sigma, evaluation);
    evaluation = nullptr;
    nodal_.skip(exchange_.certificate().seen());
    statistics_ = nodal_.statistics();
    before = statistics_.evaluated = exchange_.evaluated();
    if (proven) return certified();
  }
  // What is certified goes beyond the budget no more than what is kept for proofs.
  if (cheapest_.due() && (!observed() || account_.affords(0) || account_.affordsForProof(0))) {
    nodal_.setSecondary(false);
    const bool proven = nodal_.certify(x, sigma, evaluation);
    evaluation = nullptr;
    statistics_ = nodal_.statistics();
    bracketed_ = false;
    if (proveByShares(x, sigma) || proven) return certified();
    before += statistics_.evaluated;
  }
  follow(x, limit, h, evaluation);
  ++observations_;
  statistics_.evaluated += before;
  const bool safe = step_ && h <= step_->safe;
  if (safe)
    cheapest_.tick();
  else
    cheapest_.restart();
  return safe;
}

bool RunBracket::proveByShares(NodeVectorsView x, double sigma) {
  const double work = exchange_.workOfProof();
  const bool wanted = observed() ? workOfProofs() - atShares_ >= work
                                 : nodal_.weights().last() > policy_.hardlyProven * sigma && work < infinity &&
                                       account_.affordsAtStart(work);
  const bool first = mode_.size() == 0;
  if (!wanted || (first && nodal_.highestElements(1).empty())) return false;
  const LowerBound lower = first ? startMode(x) : refreshMode(x, policy_.productsOfFollowing);
  const bool byShares = exchange_.proveFor(x, sigma, mode_, lower, !observed());
  statistics_.evaluated += exchange_.evaluated();
  atShares_ = workOfProofs();
  return byShares;
}

double RunBracket::workOfProofs() const {
  const Work all = spent();
  return all.total() - all[WorkOn::tests] - all[WorkOn::searches];
}

void RunBracket::proveFromScratch(NodeVectorsView x, const StepRule& limit) {
  if (!step_ || !finite_) return;
  try {
    best_ = criticalStep(body_, x, limit, {.evaluations = &statistics_.evaluated});
    bestAt_ = x;
    bestVersion_ = body_.version();
  } catch (const NumericalError&) {
    // From scratch there is no bracket, and the last one stays.
  }
}

void RunBracket::takeBest(NodeVectorsView x) {
  if (!best_) return;
  if (bestVersion_ != body_.version() || x != bestAt_) {
    best_.reset();
    bestAt_.resize(3, 0);
    return;
  }
  if (!step_) return;
  CriticalStep step = *step_;
  if (best_->safe > step.safe) {
    step.safe = best_->safe;
    step.safeBy = best_->safeBy;
  }
  if (best_->optimistic < step.optimistic) {
    step.optimistic = best_->optimistic;
    step.optimisticBy = best_->optimisticBy;
  }
  if (step.isBracket()) step_ = step;
}

void RunBracket::sharpen(NodeVectorsView x, const StepRule& limit, double h) {
  if (!step_ || h > step_->optimistic) return;
  uncertified_ = true;
  sharpening_.tick();
  LowerBound lower = local_.last();
  if (account_.limited()) {
    // The mode is searched and followed by turns: one that moves from place to place needs the one, one that is spread
    // out the other.
    const int products = policy_.productsOfFollowing;
    const double work = searchesNext_ ? WorkAccount::ofDiagonal(body_) : WorkAccount::ofProducts(body_, products + 1);
    if (!sharpening_.due() || !account_.affordsForVerdict(work)) return;
    sharpening_.tried(true);
    forVerdict_ = true;
    lower = searchesNext_ ? boundWhereItIsStiff(x, lower) : refreshMode(x, products);
    forVerdict_ = false;
    searchesNext_ = !searchesNext_;
  } else {
    const bool urgent = h > (1 - policy_.close) * step_->optimistic;
    if (!urgent && !sharpening_.due()) return;
    sharpening_.tried(true);
    const bool fromRings = sharpeningRestart_.due();
    if (fromRings) sharpeningRestart_.tried(true);
    sharpeningRestart_.tick();
    lower = fromRings ? restartMode(x) : refreshMode(x, policy_.restartProducts);
  }
  step_->optimistic = std::min(step_->optimistic, optimisticOf(lower, limit));
  if (!step_->isBracket()) step_.reset();
}

double RunBracket::optimisticOf(LowerBound lower, const StepRule& limit) const {
  return std::min(optimisticStep(lower, limit), optimisticStep(local_.last(), limit));
}

void RunBracket::nameGoverning(NodeVectorsView x) {
  if (!step_) return;
  local_.evaluate(x);  // of a region that has just been chosen nothing is known
  local_.searchHighest(x);
  step_->controlling = local_.highestElement();
  step_->discreteShare = local_.discreteShare();
  step_->dampingShare = local_.dampingShare();
}

void RunBracket::forget() {
  step_.reset();
  exchange_.forget();
  mode_.resize(3, 0);
  local_.choose(mode_, localNodes_);
  lowest_ = {0, {}};
  softest_.forget();
  least_ = {};
  search_.reset();
  searchedAt_ = 0;
}

void RunBracket::searchUnderCompression(NodeVectorsView x) {
  lowestHere_ = {0, {}};
  const double compression = nodal_.mostCompression();
  search_.tick();
  const double growth = account_.limited() ? policy_.growthUnderBudget : policy_.growthOfCompression;
  const bool grown = compression > growth * searchedAt_ && search_.since() >= policy_.searchGap;
  const int later = account_.limited() ? policy_.searchUnderBudget : policy_.laterSearch;
  const bool may = affordsSearch(WorkAccount::ofProducts(body_, later + 1));
  const bool search = compression > policy_.slightlyCompressed && (grown || search_.due()) && may;
  if (search) {
    const bool wide = !softest_.found() && affordsSearch(WorkAccount::ofProducts(body_, policy_.firstSearch + 1));
    const int products = wide ? policy_.firstSearch : later;
    charge(WorkOn::searches, WorkAccount::ofProducts(body_, products + 1));
    least_ = softest_.find(x, products);
    if (least_.value < 0) lowestHere_ = {least_.value, least_.element};
    search_.tried(grown);
    searchedAt_ = grown ? compression : std::max(searchedAt_, compression);
  } else if (!(compression > policy_.slightlyCompressed)) {
    least_ = {};
  }
  examination_.tick();
  if (!examination_.due() && !search) return;
  examination_.tried(true);
  // The lowest so far, the most compressed ones, and others by turns: one at least, and more as far as the budget goes.
  std::vector<ElementRef> chosen;
  if (lowest_.value < 0) chosen.push_back(lowest_.element);
  for (const ElementRef e : nodal_.mostCompressed(policy_.compressed, policy_.compressedRings)) {
    chosen.push_back(e);
    for (const ElementRef other : nodal_.compressedByTurns(policy_.compressed, 1, nextCompressed_))
      chosen.push_back(other);
  }
  lowest_ = {0, {}};
  if (least_.value < 0) lowest_ = {least_.value, least_.element};
  bool first = true;
  for (const ElementRef e : chosen) {
    if (!first && !affordsSearch(WorkAccount::ofRing(*body_.blocks()[e.block]))) break;
    first = false;
    if (!decomposeRing(x, e, WorkOn::searches)) continue;
    // Constrained components have eigenvalues of zero, to rounding.
    const double least = solver_.eigenvalues()[0] + constrainedRounding * solver_.eigenvalues().cwiseAbs().maxCoeff() +
                         ringNodes_.rounding();
    if (least < lowest_.value) lowest_ = {least, e};
    if (least < lowestHere_.value) lowestHere_ = {least, e};
  }
}

LowerBound RunBracket::boundWhereItRose(NodeVectorsView x, double sigma, LowerBound lower) {
  bool jumped = false;
  std::size_t observations = 0;
  for (const IncrementalNodalBound::NearLimit& near : nodal_.nearLimit()) {
    // One that is within its allowance is worth an evaluation when the bound there is above what is known from below.
    if (observations >= (near.fraction > 1 ? policy_.risenRings : 1) ||
        near.fraction * sigma < (1 + policy_.leastGain) * lower.value)
      break;
    if (!affords(WorkAccount::ofRing(*body_.blocks()[near.element.block]))) break;
    ++observations;
    jumped = examineRing(x, near.element, lower) || jumped;
  }
  if (jumped) local_.choose(mode_, localNodes_);
  return lower;
}

LowerBound RunBracket::boundWhereItIsStiff(NodeVectorsView x, LowerBound lower) {
  if (!searchStiffNodes(x, policy_.stiffNodes, lower)) return lower;
  local_.choose(mode_, localNodes_);
  return higher(lower, boundOfRegion(x));
}

bool RunBracket::searchStiffNodes(NodeVectorsView x, std::size_t nodes, LowerBound& lower) {
  charge(WorkOn::mode, WorkAccount::ofDiagonal(body_));
  bool jumped = false;
  NodeVectors start = NodeVectors::Zero(3, body_.nodeCount());
  for (const std::int32_t node : stiff_.find(x, nodes)) {
    if (local_.holds(node)) continue;
    start.setZero();
    start.col(node) = stiff_.diagonalAt(node).cwiseMax(0).cwiseSqrt();
    scout_.choose(start, policy_.nodesAround);
    const LowerBound bound = scout_.evaluate(x);
    if (scout_.part()) charge(WorkOn::mode, WorkAccount::ofRegion(*scout_.part(), scout_.products()));
    if (!(bound.value > lower.value)) continue;
    lower = bound;
    mode_ = scout_.mode();
    jumped = true;
  }
  if (jumped) method_ = "rayleigh-quotient";
  return jumped;
}

LowerBound RunBracket::boundWhereItTouches(NodeVectorsView x, LowerBound lower) {
  const DiscreteForces* discrete = body_.discreteForces();
  if (!discrete) return lower;
  std::map<std::int32_t, double> alone;  // by node
  discrete->forEachBlock(x, [&](std::int32_t i, std::int32_t j, const Eigen::Matrix3d& block) {
    if (i == j && body_.constraints().freeComponents(i) > 0) alone[i] += block.trace() / body_.lumpedMass()[i];
  });
  double highest = 0;
  std::int32_t node = -1;
  auto before = discreteAlone_.begin();
  for (const auto& [i, value] : alone) {
    while (before != discreteAlone_.end() && before->node < i) ++before;
    const double known = before != discreteAlone_.end() && before->node == i ? std::max(before->value, 0.0) : 0;
    const bool risen = value > (1 + policy_.leastGain) * known;
    if (!(value > highest) || !(risen || value > (1 + policy_.leastGain) * lower.value)) continue;
    highest = value;
    node = i;
  }
  discreteAlone_.clear();
  for (const auto& [i, value] : alone) discreteAlone_.push_back({value, i});
  // One ring is enough: the others at the node have the same contact.
  if (node < 0 || !examineRingAt(x, node, lower)) return lower;
  local_.choose(mode_, localNodes_);
  return higher(lower, boundOfRegion(x));
}

bool RunBracket::examineRingAt(NodeVectorsView x, std::int32_t node, LowerBound& lower) {
  const std::vector<ElementRef> elements = nodal_.weights().elementsAt(std::span<const std::int32_t>(&node, 1));
  return !elements.empty() && affords(WorkAccount::ofRing(*body_.blocks()[elements.front().block])) &&
         examineRing(x, elements.front(), lower);
}

bool RunBracket::examineRing(NodeVectorsView x, ElementRef e, LowerBound& lower) {
  if (!decomposeRing(x, e)) return false;
  const double value = topOfRing();
  if (!(value > lower.value)) return false;
  lower = {value};
  method_ = "reduced-1-ring";
  mode_.normalize();
  addTopOfRing(mode_);
  return true;
}

bool RunBracket::decomposeRing(NodeVectorsView x, ElementRef e, WorkOn what) {
  charge(what, WorkAccount::ofRing(*body_.blocks()[e.block]));
  const auto nodes = body_.blocks()[e.block]->nodesOf(e.element);
  ringNodes_.choose({nodes.begin(), nodes.end()});
  solver_ = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(ringNodes_.evaluate(x));  // see LowestModeSearch::find
  return solver_.info() == Eigen::Success;
}

double RunBracket::workOfRestart() const {
  return WorkAccount::ofAllRings(body_) + WorkAccount::ofProducts(body_, policy_.restartProducts + 1);
}

LowerBound RunBracket::boundOfRegion(NodeVectorsView x) {
  const Body* part = local_.part();
  const LowerBound lower =
      local_.evaluate(x, !part || affords(WorkAccount::ofRegion(*part, local_.productsOfImproving())));
  if (local_.part()) charge(WorkOn::mode, WorkAccount::ofRegion(*local_.part(), local_.products()));
  return lower;
}

bool RunBracket::regionIsDear() const {
  const Body* part = local_.part();
  return part && account_.limited() &&
         WorkAccount::ofRegion(*part, 2) >
             policy_.shareOfRegion * (account_.incomeForMode() + (uncertified_ ? account_.incomeForVerdict() : 0));
}

LowerBound RunBracket::restartMode(NodeVectorsView x) {
  charge(WorkOn::mode, workOfRestart());
  ReducedRing ring(body_);  // restarts are rare, and its pattern is as large as all the rest
  const TopMode top = findTopMode(ring, body_, x, mode_, policy_.firstProducts, policy_.restartProducts, false);
  method_ = top.method();
  statistics_.evaluated += body_.mesh().elementCount();
  return followMode(x, top.lower());
}

LowerBound RunBracket::startMode(NodeVectorsView x) {
  const std::vector<ElementRef> elements = nodal_.highestElements(policy_.highestRings);
  mode_ = NodeVectors::Zero(3, body_.nodeCount());
  LowerBound highest{0};
  method_ = "reduced-1-ring";
  for (const ElementRef e : elements) {
    if (!decomposeRing(x, e)) continue;
    const double value = topOfRing();
    if (!(value > highest.value)) continue;
    highest = {value};
    mode_.setZero();
    addTopOfRing(mode_);
  }
  statistics_.evaluated += static_cast<std::int64_t>(elements.size());
  if (nodal_.endedEarly()) searchStiffNodes(x, policy_.firstStiffNodes, highest);
  const int products = nodal_.endedEarly() ? policy_.productsOfEarlyEnd : policy_.firstProducts;
  const LowerBound quotient = rayleighLowerBound(body_, x, mode_, products);
  if (quotient.value > highest.value) method_ = "rayleigh-quotient";
  return followMode(x, higher(highest, quotient));
}

double RunBracket::topOfRing() const {
  return solver_.eigenvalues()[solver_.eigenvalues().size() - 1] -
         ringRounding * solver_.eigenvalues().cwiseAbs().maxCoeff() - ringNodes_.rounding();
}

void RunBracket::addTopOfRing(NodeVectors& mode) const {
  const auto top = solver_.eigenvectors().col(solver_.eigenvectors().cols() - 1);
  for (std::size_t k = 0; k < ringNodes_.nodes().size(); ++k)
    mode.col(ringNodes_.nodes()[k]) += top.segment<3>(static_cast<Eigen::Index>(3 * k));
}

LowerBound RunBracket::refreshMode(NodeVectorsView x, int products) {
  charge(WorkOn::mode, WorkAccount::ofProducts(body_, products + 1));
  return followMode(x, rayleighLowerBound(body_, x, mode_, products));
}

LowerBound RunBracket::followMode(NodeVectorsView x, LowerBound whole) {
  wholeMode_.restart();
  std::size_t most = policy_.mostLocalNodes;
  while (true) {
    local_.choose(mode_, localNodes_);
    if (localNodes_ > policy_.fewestLocalNodes && regionIsDear()) {
      most = localNodes_ = std::max(localNodes_ / 2, policy_.fewestLocalNodes);
      continue;
    }
    regionBound_ = boundOfRegion(x);
    const bool lost = regionBound_.value < (1 - policy_.lostInRegion) * whole.value;
    if (!lost || localNodes_ >= most) break;
    localNodes_ = std::min(2 * localNodes_, most);
  }
  if (regionBound_.value >= (1 - 0.25 * policy_.lostInRegion) * whole.value)
    localNodes_ = std::min(std::max(localNodes_ / 2, policy_.leastLocalNodes), most);
  return higher(whole, regionBound_);
}

}  // namespace ringwatch
