#include <ringwatch/monitor/incremental/incremental_nodal_bound.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <ringwatch/monitor/incremental/local_update.h>

namespace ringwatch {
namespace {

/// An eigenvalue that lies above a lower bound by a share of the width, relative in the step.
double above(LowerBound lower, double width) { return (1 + width) * (1 + width) * lower.value; }

}  // namespace

IncrementalNodalBound::IncrementalNodalBound(const Body& body, const RebuildPolicy& policy)
    : body_(body),
      policy_(policy),
      state_(body),
      bodyVersion_(body.version()),
      rebuilds_(policy.rebuilds),
      lowerings_(policy.lowerings) {}

void IncrementalNodalBound::rebuild(NodeVectorsView x) {
  NodalBound& weights = state_.weights();
  weights.reset();  // weights that are swept along get stuck at a front that moves through the mesh
  weights.evaluate(x, policy_.sweeps, NodalBound::Start::rootOfStiffness, policy_.leastGain);
  state_.statistics().evaluated += weights.evaluations();
  ++state_.statistics().rebuilds;
  rebuilds_.restart();
  tightOverLower_ = 0;
}

void IncrementalNodalBound::start(NodeVectorsView x, double sigma) {
  state_.setCertifiedEigenvalue(sigma);
  started_ = std::isfinite(sigma);
  if (started_) state_.distributeAllowances(x);
}

IncrementalNodalBound::Outcome IncrementalNodalBound::follow(NodeVectorsView x, bool mayRaise,
                                                             StepEvaluation* evaluation) {
  nearLimit_.clear();
  std::vector<ElementRef> changed = state_.elementsOutsideBall(x, evaluation);
  std::vector<RunCertificate::Reference> now;
  state_.evaluate(x, changed, false, now);
  for (std::size_t i = 0; i < changed.size(); ++i) {
    if (!std::isfinite(now[i].value)) return Outcome::notFinite;
    const double allowance = state_.allowance(changed[i]), value = now[i].value;
    const double fraction = allowance > 0 ? value / allowance : value > 0 ? std::numeric_limits<double>::infinity() : 0;
    if (fraction > policy_.nearLimit) nearLimit_.push_back({fraction, changed[i]});
  }
  std::sort(nearLimit_.begin(), nearLimit_.end(), [](const NearLimit& a, const NearLimit& b) {
    return a.fraction != b.fraction ? a.fraction > b.fraction : a.element < b.element;
  });
  const auto end =
      std::find_if(nearLimit_.begin(), nearLimit_.end(), [](const NearLimit& near) { return near.fraction <= 1; });
  if (static_cast<double>(end - nearLimit_.begin()) >
      policy_.tooManyViolations * static_cast<double>(body_.mesh().elementCount()))
    return Outcome::tooManyViolations;
  for (auto near = nearLimit_.begin(); near != end; ++near) {
    if (state_.value(near->element) <= state_.allowance(near->element)) continue;  // a neighbour's update served it
    const std::vector<ElementRef> updated = localUpdate(state_, x, near->element, policy_, mayRaise);
    if (updated.empty()) return Outcome::refused;
    changed.insert(changed.end(), updated.begin(), updated.end());
  }
  state_.ballsChanged(changed);
  return Outcome::held;
}

void IncrementalNodalBound::followBody() {
  if (bodyVersion_ == body_.version()) return;
  bodyVersion_ = body_.version();
  started_ = false;
  // The next attempt must not wait for its turn.
  rebuilds_.reset();
}

UpperBound IncrementalNodalBound::update(NodeVectorsView x, StepEvaluation* evaluation) {
  state_.statistics() = {};
  followBody();
  rebuilds_.tick();
  lowerings_.tick();
  if (!started_ && evaluation) body_.evaluate(x, *evaluation, workspace_);
  const Outcome outcome = started_ ? follow(x, true, evaluation) : Outcome::tooManyViolations;
  if (outcome == Outcome::tooManyViolations || outcome == Outcome::refused) {
    rebuild(x);
    start(x, state_.weights().last() * (1 + policy_.slack));
  } else if (outcome == Outcome::notFinite) {
    start(x, std::numeric_limits<double>::quiet_NaN());
  }
  return {certifiedEigenvalue()};
}

bool IncrementalNodalBound::certify(NodeVectorsView x, double sigma, StepEvaluation* evaluation) {
  state_.statistics() = {};
  followBody();
  rebuilds_.tick();
  lowerings_.tick();
  if (started_ && certifiedEigenvalue() <= sigma) {
    const Outcome outcome = follow(x, false, evaluation);
    if (outcome == Outcome::held) return true;
    started_ = false;
    if (outcome == Outcome::notFinite) return false;
  } else if (evaluation) {
    body_.evaluate(x, *evaluation, workspace_);
  }
  // From scratch, but not at every step while it keeps failing.
  if (!rebuilds_.due()) return false;
  rebuild(x);
  const double tight = state_.weights().last();
  const bool proven = tight <= sigma * (1 - policy_.proofMargin);
  rebuilds_.tried(proven);
  // What was found serves update() in any case.
  start(x, proven ? sigma : tight * (1 + policy_.slack));
  return proven;
}

void IncrementalNodalBound::relaxBound(LowerBound lower, double width) {
  if (started_ && certifiedEigenvalue() < above(lower, policy_.relaxBelow * width))
    state_.raise(above(lower, policy_.targetOfWidth * width));
}

bool IncrementalNodalBound::tightenBound(NodeVectorsView x, LowerBound lower, double width) {
  if (!started_ || !(lower.value > 0)) return false;
  if (certifiedEigenvalue() <= above(lower, width)) return false;
  if (tightOverLower_ == 0) tightOverLower_ = state_.weights().last() / lower.value;
  const double target = std::max(above(lower, policy_.targetOfWidth * width),
                                 tightOverLower_ * (1 + policy_.leastSlack * policy_.slack) * lower.value);
  if (target < (1 - policy_.leastLowering) * certifiedEigenvalue() && lowerings_.due()) {
    lowerings_.tried(lowerings_.since() >= policy_.soon);
    state_.lower(target);
    return true;
  }
  const bool drifted = certifiedEigenvalue() > policy_.drifted * tightOverLower_ * (1 + policy_.slack) * lower.value;
  if (!rebuilds_.due(drifted ? 0 : policy_.updatesOfChange)) return false;
  state_.statistics() = {};
  const double before = certifiedEigenvalue();
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
