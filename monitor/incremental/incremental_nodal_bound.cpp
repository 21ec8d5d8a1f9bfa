#include <ringwatch/monitor/incremental/incremental_nodal_bound.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <ringwatch/base/infinity.h>
#include <ringwatch/monitor/incremental/local_update.h>

namespace ringwatch {

IncrementalNodalBound::IncrementalNodalBound(const Body& body, const RebuildPolicy& policy, WorkAccount* account)
    : body_(body),
      policy_(policy),
      account_(account),
      state_(body),
      bodyVersion_(body.version()),
      rebuilds_(policy.rebuilds),
      refreshes_(policy.refreshes),
      lowerings_(policy.lowerings) {}

double IncrementalNodalBound::workOfOne() const {
  return WorkAccount::ofEvaluation(body_) / static_cast<double>(body_.mesh().elementCount());
}

SweepTarget IncrementalNodalBound::firstTarget(double most, double ample) const {
  const double evaluations = policy_.forcesOfFirstSweeps * WorkAccount::ofForce(body_) / workOfOne();
  // One sweep at least: weights that were not swept are a third off.
  const double leastEvaluations = static_cast<double>(body_.mesh().elementCount()) + 1;
  return {policy_.enoughOfCeiling * most, std::max(evaluations, leastEvaluations), policy_.leastGainAtFirst, ample};
}

void IncrementalNodalBound::rebuild(NodeVectorsView x, const SweepTarget& enough) {
  NodalBound& weights = state_.weights();
  state_.renewMajorants(x);
  weights.reset();  // weights that are swept along get stuck at a front that moves through the mesh
  weights.evaluate(x, policy_.sweeps, NodalBound::Start::rows, policy_.leastGain, enough);
  state_.statistics().evaluated += weights.evaluations();
  state_.statistics().work[WorkOn::sweeps] += workOfOne() * static_cast<double>(weights.evaluations());
  endedEarly_ = weights.last() <= std::max(enough.value, enough.ample);
  tight_ = endedEarly_ ? 0 : static_cast<double>(weights.last());
  ++state_.statistics().rebuilds;
  sinceRebuild_ = -state_.statistics().work.besideTests();
  rebuilds_.restart();
  tightOverLower_ = 0;
}

NodalBound IncrementalNodalBound::weightsAtRest() const {
  NodalBound weights(body_);
  weights.evaluate(body_.mesh().X, policy_.sweeps, NodalBound::Start::rows, policy_.leastGain);
  return weights;
}

void IncrementalNodalBound::start(NodeVectorsView x, double sigma, bool newWeights) {
  const bool first = !started_;
  state_.setCertifiedEigenvalue(sigma);
  started_ = std::isfinite(sigma);
  if (started_) state_.distributeAllowances(x, newWeights);
  // Before there is a proof nothing can be earned for it.
  if (first) state_.statistics().work = {};
}

IncrementalNodalBound::Outcome IncrementalNodalBound::follow(NodeVectorsView x, bool mayRaise, double ceiling,
                                                             StepEvaluation* evaluation) {
  std::vector<ElementRef> changed = state_.elementsOutsideBall(x, evaluation);
  const std::vector<std::int32_t> exceeding = state_.followDiscreteForces(x);
  if (limited() && mayRaise) changed = raiseForMost(x, changed, ceiling);
  if (!evaluate(x, changed)) return Outcome::notFinite;
  const Work before = state_.statistics().work;
  const Outcome outcome = mend(x, mayRaise, exceeding, changed);
  Work& work = state_.statistics().work;
  const double evaluations = work[WorkOn::evaluations] - before[WorkOn::evaluations];
  work[WorkOn::evaluations] -= evaluations;
  work[WorkOn::repairs] += evaluations;
  return outcome;
}

std::vector<ElementRef> IncrementalNodalBound::raiseForMost(NodeVectorsView x, const std::vector<ElementRef>& outside,
                                                            double ceiling) {
  std::vector<RunCertificate::ElementOutside> violating = state_.growBalls(x, outside);
  // The neediest first, of which there are few before a raise serves the rest.
  std::make_heap(violating.begin(), violating.end());
  const double top = ceiling / certifiedEigenvalue();
  std::vector<ElementRef> evaluated;
  std::vector<std::size_t> counts(body_.blocks().size(), 0);  // of evaluated, by block
  const auto workOf = [&](ElementRef e) {
    return WorkAccount::ofEvaluation(*body_.blocks()[e.block], counts[e.block]);
  };
  double needed = 0;
  for (; !violating.empty(); std::pop_heap(violating.begin(), violating.end()), violating.pop_back()) {
    const RunCertificate::ElementOutside* const outsider = &violating.front();
    const double own = workOf(outsider->element);
    const bool far = outsider->need > policy_.mostRaise, forProof = outsider->need > top;
    const double overdraft = far ? account_->overdraft() : 0;
    // A raise would cost more than a few evaluations.
    const bool few = needed + own <= policy_.evaluationsForRaise * WorkAccount::ofMove(body_);
    if (outsider->need == infinity || few || affords(needed + own - overdraft))
      needed += own;
    else if (forProof && account_->affordsForProof(ofProof_ + own))
      ofProof_ += own;
    else
      break;
    evaluated.push_back(outsider->element);
    ++counts[outsider->element.block];
  }
  if (violating.empty()) return evaluated;
  state_.moveTo(std::max(violating.front().need, policy_.raise) * certifiedEigenvalue());
  ++state_.statistics().raises;
  for (const RunCertificate::ElementOutside& refused : violating) {
    account_->refuse(workOf(refused.element));
    ++counts[refused.element.block];
  }
  account_->ballsGrow();
  state_.growBalls(violating);
  return evaluated;
}

bool IncrementalNodalBound::evaluate(NodeVectorsView x, const std::vector<ElementRef>& elements) {
  nearLimit_.clear();
  const double noted = limited() ? std::min(policy_.nearLimit, notedFrom_ / certifiedEigenvalue()) : policy_.nearLimit;
  std::vector<RunCertificate::Reference> now;
  state_.evaluate(x, elements, false, now);
  for (std::size_t i = 0; i < elements.size(); ++i) {
    // Values are kept in single precision.
    if (!(now[i].value <= static_cast<double>(std::numeric_limits<float>::max()))) return false;
    const double allowance = state_.allowance(elements[i]), value = now[i].value;
    const double fraction = allowance > 0 ? value / allowance : value > 0 ? infinity : 0;
    if (fraction > noted) nearLimit_.push_back({fraction, elements[i]});
  }
  std::sort(nearLimit_.begin(), nearLimit_.end(), [](const NearLimit& a, const NearLimit& b) {
    return a.fraction != b.fraction ? a.fraction > b.fraction : a.element < b.element;
  });
  return true;
}

IncrementalNodalBound::Outcome IncrementalNodalBound::mend(NodeVectorsView x, bool mayRaise,
                                                           const std::vector<std::int32_t>& exceeding,
                                                           std::vector<ElementRef>& changed) {
  const auto end =
      std::find_if(nearLimit_.begin(), nearLimit_.end(), [](const NearLimit& near) { return near.fraction <= 1; });
  const auto violations = static_cast<std::size_t>(end - nearLimit_.begin()) + exceeding.size();
  const bool many =
      static_cast<double>(violations) > policy_.tooManyViolations * static_cast<double>(body_.mesh().elementCount());
  if (many && affords(WorkAccount::ofRebuild(body_))) return Outcome::tooManyViolations;
  // Raising is all that is left once an update was refused, and to the bound, under a budget.
  bool updates = !many;
  std::vector<ElementRef> raised;
  const auto update = [&](ElementRef e) {
    updates = updates && (!mayRaise || affords(0));
    const std::vector<ElementRef> updated =
        updates ? localUpdate(state_, x, e, policy_, mayRaise) : std::vector<ElementRef>();
    changed.insert(changed.end(), updated.begin(), updated.end());
    updates = !updated.empty();
    return updates;
  };
  for (auto near = nearLimit_.begin(); near != end; ++near) {
    if (state_.value(near->element) <= state_.allowance(near->element)) continue;  // a neighbour's update served it
    if (!update(near->element)) raised.push_back(near->element);
  }
  // Elements at a node make room for what its discrete forces have come to, where there are any.
  std::vector<std::int32_t> raisedNodes;
  for (const std::int32_t node : exceeding) {
    if (!state_.exceeds(node)) continue;
    const std::vector<ElementRef> elements = state_.weights().elementsAt({&node, 1});
    if (elements.empty() || !update(elements.front())) raisedNodes.push_back(node);
  }
  state_.raiseToValues(raised, policy_.raisedSlack * policy_.slack);
  std::erase_if(raisedNodes, [&](std::int32_t node) { return !state_.exceeds(node); });
  state_.raiseForNodes(raisedNodes, policy_.raisedSlack * policy_.slack);
  return mayRaise || (raised.empty() && raisedNodes.empty()) ? Outcome::held : Outcome::refused;
}

void IncrementalNodalBound::beginCounting() {
  if (account_) {
    Work others = state_.statistics().work;
    others[WorkOn::sweeps] -= ofProof_;
    account_->spend(others);
    account_->spendOnProof(ofProof_);
  }
  ofProof_ = 0;
  spent_ += state_.statistics().work;
  sinceRebuild_ += state_.statistics().work.besideTests();
  state_.statistics() = {};
}

void IncrementalNodalBound::skip(std::span<const ExchangeCertificate::Seen> seen) {
  beginCounting();
  nearLimit_.clear();
  for (const ExchangeCertificate::Seen& element : seen)
    state_.note(element.element, element.determinant, element.negative);
}

void IncrementalNodalBound::refresh(NodeVectorsView x, double wanted) {
  state_.renewMajorants(x);
  const bool turned = state_.rotateWithBody(x, policy_);
  NodalBound& weights = state_.weights();
  weights.evaluate(x, 0);
  state_.statistics().evaluated += weights.evaluations();
  state_.statistics().work[WorkOn::sweeps] += WorkAccount::ofEvaluation(body_);
  ++state_.statistics().refreshes;
  const double tight = weights.last();
  const double sigma = std::min(tight * (1 + policy_.slack), certifiedEigenvalue());
  start(x, tight <= wanted * (1 - policy_.proofMargin) ? wanted : sigma, turned);
}

void IncrementalNodalBound::followBody() {
  if (bodyVersion_ == body_.version()) return;
  bodyVersion_ = body_.version();
  started_ = false;
  // The next attempt must not wait for its turn.
  rebuilds_.reset();
}

UpperBound IncrementalNodalBound::update(NodeVectorsView x, StepEvaluation* evaluation, double ceiling) {
  beginCounting();
  followBody();
  rebuilds_.tick();
  refreshes_.tick();
  lowerings_.tick();
  if (!started_ && evaluation) body_.evaluate(x, *evaluation, workspace_);
  if (secondary_) ceiling = infinity;
  // A proof that is lost has no ceiling; under a budget it is made again when that affords it.
  const double wanted = ceiling;
  if (started_ && certifiedEigenvalue() > ceiling) ceiling = infinity;
  const bool first = !started_;
  const Outcome outcome = started_ ? follow(x, true, ceiling, evaluation) : Outcome::tooManyViolations;
  if (outcome == Outcome::tooManyViolations) {
    // A first proof of the step that is taken is enough to begin with, unless the budget affords all of it.
    if (first && std::isfinite(ceiling) && !(limited() && account_->affordsAtStart(WorkAccount::ofRebuild(body_))))
      rebuild(x, firstTarget(ceiling / (1 + policy_.slack), 0));
    else
      rebuild(x);
    start(x, state_.weights().last() * (1 + policy_.slack));
  } else if (outcome == Outcome::notFinite) {
    start(x, std::numeric_limits<double>::quiet_NaN());
  }
  if (outcome != Outcome::held) return {certifiedEigenvalue()};
  if (limited()) {
    const double work = WorkAccount::ofEvaluation(body_) + WorkAccount::ofDistribution(body_, false);
    const bool ofWidth = affords(work);  // what is saved for the width will do too
    if (certifiedEigenvalue() > wanted && refreshes_.due() && (ofWidth || account_->affordsForProof(work))) {
      const double before = state_.statistics().work.total();
      refresh(x, wanted);
      refreshes_.tried(certifiedEigenvalue() <= wanted);
      if (!ofWidth) ofProof_ = state_.statistics().work.total() - before;
    }
    return {certifiedEigenvalue()};
  }
  // What had been proven of the step is worth more than the account has.
  if (certifiedEigenvalue() > ceiling && refreshes_.due()) {
    refresh(x, ceiling);
    refreshes_.tried(certifiedEigenvalue() <= ceiling);
  }
  if (certifiedEigenvalue() > ceiling && rebuilds_.due()) {
    rebuild(x);
    start(x, state_.weights().last() * (1 + policy_.slack));
    rebuilds_.tried(certifiedEigenvalue() <= ceiling);
  }
  return {certifiedEigenvalue()};
}

bool IncrementalNodalBound::certify(NodeVectorsView x, double sigma, StepEvaluation* evaluation) {
  beginCounting();
  followBody();
  rebuilds_.tick();
  refreshes_.tick();
  lowerings_.tick();
  bool sweep = false;
  if (started_ && certifiedEigenvalue() <= sigma) {
    const Outcome outcome = follow(x, false, certifiedEigenvalue(), evaluation);
    if (!affords(0))
      ofProof_ = state_.statistics().work[WorkOn::evaluations] + state_.statistics().work[WorkOn::repairs];
    // Weights that ended early have cost as much since as those would that did not: so at most twice the least is
    // spent.
    const bool lost = outcome == Outcome::tooManyViolations;
    sweep = endedEarly_ && (lost || (outcome == Outcome::held && sinceRebuild_ >= WorkAccount::ofRebuild(body_)));
    if (outcome == Outcome::held && !sweep) return true;
    // A certificate that was refused holds for a larger eigenvalue.
    started_ = outcome == Outcome::refused;
    if (outcome == Outcome::notFinite) return false;
    // What is lost at many elements at once the weights that there are may prove again.
    if (lost && refreshes_.due()) {
      state_.setCertifiedEigenvalue(infinity);
      started_ = true;
    }
  } else if (evaluation) {
    body_.evaluate(x, *evaluation, workspace_);
  }
  if (started_ && refreshes_.due()) {
    refresh(x, sigma);
    refreshes_.tried(certifiedEigenvalue() <= sigma);
    if (certifiedEigenvalue() <= sigma) return true;
  }
  // From scratch, but not at every step while it keeps failing.
  if (!sweep && !rebuilds_.due()) return false;
  const double ample = policy_.enoughOfWanted * sigma;
  rebuild(x, sweep ? SweepTarget{} : limited() ? firstTarget(sigma, ample) : SweepTarget{.ample = ample});
  const double tight = state_.weights().last();
  const bool proven = tight <= sigma * (1 - policy_.proofMargin);
  rebuilds_.tried(proven);
  if (sweep && proven) rebuilds_.reset();  // it was not for a proof that keeps failing
  // What was found serves update() in any case.
  start(x, proven ? sigma : tight * (1 + policy_.slack));
  return proven;
}

double IncrementalNodalBound::withRoom(LowerBound lower, double width, double share) const {
  const double own = above(lower, share * width);
  return limited() ? std::max(own, tightOverLower_ * (1 + share * policy_.slack) * lower.value) : own;
}

double IncrementalNodalBound::highest(LowerBound lower, double width) {
  if (tightOverLower_ == 0 && lower.value > 0) tightOverLower_ = state_.weights().last() / lower.value;
  // Weights that ended early say nothing of what others would give, once the budget affords others.
  const bool forAll = limited() && endedEarly_ && rebuilds_.due() && affords(WorkAccount::ofRebuild(body_));
  return forAll ? above(lower, width) : withRoom(lower, width, 1);
}

void IncrementalNodalBound::relaxBound(LowerBound lower, double width, double ceiling) {
  if (!started_ || certifiedEigenvalue() >= withRoom(lower, width, policy_.relaxBelow)) return;
  const double target = withRoom(lower, width, policy_.targetOfWidth);
  // A proof of the step that is taken is worth more than room.
  const double most = certifiedEigenvalue() <= ceiling ? std::min(target, ceiling) : target;
  if (most != target && !(most > policy_.raise * certifiedEigenvalue())) return;
  state_.moveTo(most);
  if (account_) account_->ballsGrow();
}

bool IncrementalNodalBound::tightenBound(NodeVectorsView x, LowerBound lower, double width) {
  if (!started_ || !(lower.value > 0)) return false;
  if (certifiedEigenvalue() <= highest(lower, width)) return false;
  state_.releaseDiscreteForces(x);
  const double target = std::max({withRoom(lower, width, policy_.targetOfWidth),
                                  tightOverLower_ * (1 + policy_.leastSlack * policy_.slack) * lower.value,
                                  (1 + policy_.leastSlack * policy_.slack) * state_.leastForDiscreteForces()});
  if (target < (1 - policy_.leastLowering) * certifiedEigenvalue() && lowerings_.due() &&
      affords(WorkAccount::ofLowering(body_))) {
    lowerings_.tried(lowerings_.since() >= policy_.soon);
    beginCounting();
    state_.moveTo(target);
    return true;
  }
  const double risen = certifiedEigenvalue() / (tightOverLower_ * (1 + policy_.slack) * lower.value);
  const bool drifted = endedEarly_ || risen > policy_.drifted;
  const bool rebuilding =
      rebuilds_.due(drifted ? 0 : policy_.updatesOfChange) && affords(WorkAccount::ofRebuild(body_));
  const bool refreshing =
      drifted && refreshes_.due() &&
      (!limited() || (risen > policy_.tooHigh &&
                      affords(WorkAccount::ofEvaluation(body_) + WorkAccount::ofDistribution(body_, true))));
  if (!rebuilding && !refreshing) return false;
  beginCounting();
  const double before = certifiedEigenvalue();
  if (!rebuilding) {
    refresh(x, 0);
    refreshes_.tried(certifiedEigenvalue() <= (1 - policy_.helpfulRefresh) * before);
    return true;
  }
  rebuild(x);
  const double rebuilt = state_.weights().last() * (1 + policy_.slack);
  rebuilds_.tried(rebuilt <= (1 - policy_.helpfulRebuild) * before);
  start(x, rebuilt);
  return true;
}

std::vector<ElementRef> IncrementalNodalBound::highestElements(std::size_t count) {
  return started_ ? state_.highestElements(count) : std::vector<ElementRef>();
}

}  // namespace ringwatch
