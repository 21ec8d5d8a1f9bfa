#include <ringwatch/distributed/rank_monitor.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/base/rounding.h>
#include <ringwatch/body/nodes_of.h>
#include <ringwatch/meshes/all_finite.h>

namespace ringwatch {
namespace {

/// Tangent products of the first search of the top mode, and of later ones from the vector that is kept.
constexpr int coldProducts = 40, warmProducts = 10;
/// Of a bracket that is all that is wanted: sweeps of the weights, tangent products.
constexpr int inspectionSweeps = 24, inspectionProducts = 120;
/// The certified eigenvalue above the last renewal's from which all elements are evaluated again: 2.5 % of the step.
constexpr double mostRaised = 1.05;
/// Left below the eigenvalue of a step that is to be proven, so that rounding does not make it less than the step.
constexpr double belowWanted = 1e-9;

}  // namespace

RankMonitor::RankMonitor(Ranks& ranks, Halo& halo, const RankBody& part, const RankMonitorOptions& options)
    : ranks_(ranks),
      halo_(halo),
      part_(part),
      options_(options),
      certificate_(part.body()),
      mode_(ranks, halo, part),
      tracker_(options.clearObservations),
      energies_(part.roundingEnergy()),
      refreshes_(policy_.refreshes),
      rebuilds_(policy_.rebuilds) {
  if (options_.mode == MonitorMode::metric) throw InputError("mode = metric: is not distributed over ranks");
  if (!options_.limit.proven()) throw InputError("the step rule proves nothing, so that no step can be certified");
  certificate_.weights().setRest(this);
}

double RankMonitor::largest(double own) {
  ranks_.largest({&own, 1});
  return own;
}

RankMonitor::Found RankMonitor::checkElements(NodeVectorsView x, StepEvaluation& evaluation) {
  Found found;
  std::vector<ElementRef> outside = certificate_.elementsOutsideBall(x, &evaluation);
  std::vector<ElementRef> evaluated;
  for (const RunCertificate::Leaver& leaver : certificate_.growBalls(x, outside)) evaluated.push_back(leaver.element);
  std::vector<RunCertificate::Reference> now;
  certificate_.evaluate(x, evaluated, false, now);
  std::vector<ElementRef> raised;
  for (std::size_t i = 0; i < evaluated.size(); ++i) {
    // Values are kept in single precision.
    if (!(now[i].value <= static_cast<double>(std::numeric_limits<float>::max()))) found.finite = false;
    if (now[i].value <= certificate_.allowance(evaluated[i])) continue;
    raised.push_back(evaluated[i]);
    certificate_.setAllowance(evaluated[i],
                              certificate_.value(evaluated[i]) * (1 + policy_.raisedSlack * policy_.slack));
    certificate_.fitBall(evaluated[i]);
  }
  cost_.evaluated += static_cast<std::int64_t>(evaluated.size());
  report_.elementsRefreshed +=
      std::count_if(evaluated.begin(), evaluated.end(), [this](ElementRef e) { return part_.counts(e); });
  for (const std::int32_t node : nodesOfElements(part_.body(), raised))
    if (node < part_.ownedNodes())
      found.need = std::max(found.need, largestEigenvalue(certificate_.sumOfAllowances(node)) *
                                            (1 + allowanceRounding) / part_.body().lumpedMass()[node]);
  return found;
}

bool RankMonitor::renew(NodeVectorsView x, bool newWeights, double wanted) {
  NodalBound& weights = certificate_.weights();
  if (newWeights) {
    weights.reset();
    weights.evaluate(x, policy_.sweeps, NodalBound::Start::rows, policy_.leastGain);
    ++cost_.rebuilds;
  } else {
    weights.evaluate(x, 0);
    ++cost_.refreshes;
  }
  cost_.evaluated += weights.evaluations();
  report_.elementsRefreshed += weights.evaluations();
  const double tight = weights.last();
  started_ = std::isfinite(tight) && tight > 0;
  if (!started_) return false;
  nameControlling(tight);
  mode_.find(x, mode_.found() ? warmProducts : coldProducts);
  lower_ = mode_.bound(x);
  // Room for the elements: at least the policy's, and what the width of the bracket leaves.
  const double wide = 1 + policy_.targetOfWidth * options_.width;
  double sigma = std::max(tight * (1 + policy_.slack), wide * wide * lower_.value);
  if (tight <= wanted * (1 - policy_.proofMargin) && (options_.mode == MonitorMode::threshold || wanted < sigma))
    sigma = wanted * (1 - belowWanted);
  certificate_.setCertifiedEigenvalue(sigma);
  certificate_.distributeAllowances(x, newWeights);
  provenAtRebuild_ = sigma;
  return true;
}

/// The element that holds most of the sum at the first node where it is highest.
void RankMonitor::nameControlling(double bound) {
  const NodalBound& weights = certificate_.weights();
  std::int32_t top = -1;
  for (std::int32_t node = 0; node < part_.ownedNodes() && top < 0; ++node)
    if (weights.nodal()[node] == bound) top = node;
  const std::int64_t none = std::numeric_limits<std::int64_t>::max();
  const bool mine = ranks_.least(top < 0 ? none : part_.globalNode(top)) == (top < 0 ? -1 : part_.globalNode(top));
  std::optional<ElementRef> highest;
  double most = -1;
  if (mine)
    for (const NodalBound::Incidence at : weights.incidences(top)) {
      const ElementRef e = weights.elementAt(at);
      const double share = weights.value(e) * weights.weight(at).trace();
      if (share > most) {
        most = share;
        highest = part_.globalElement(e);
      }
    }
  controlling_ = ranks_.first(highest).value_or(ElementRef());
}

void RankMonitor::present(MonitorEvent event, NodeVectorsView x) {
  if (!tracker_.isNew(event.kind)) return;
  event.step = report_.step;
  event.time = report_.time;
  if (event.element) {
    const std::optional<ElementRef> local = part_.localElement(*event.element);
    const int holder = ranks_.firstWhere(local.has_value());
    ElementCause cause;
    if (ranks_.rank() == holder) cause = elementCause(part_.body(), x, *local, part_.meanElementVolume());
    if (holder < ranks_.size()) {
      ranks_.share(&cause, sizeof cause, holder);
      event.cause = cause;
    }
  }
  report_.newEvents.push_back(tracker_.begin(event));
}

const MonitorReport& RankMonitor::observe(std::int64_t step, double time, NodeVectorsView x, NodeVectorsView v,
                                          std::optional<double> h, StepEvaluation& evaluation, int& asked,
                                          const std::function<void()>& meanwhile) {
  const Body& body = part_.body();
  report_.step = step;
  report_.time = time;
  report_.h = h.value_or(0);
  report_.newEvents.clear();
  report_.elementsRefreshed = 0;
  certificate_.statistics() = {};
  const bool finiteHere = allFinite(NodeVectorsView(x.data(), part_.ownedNodes()), body.threads()) &&
                          allFinite(NodeVectorsView(v.data(), part_.ownedNodes()), body.threads());
  const bool due = observations_++ % options_.every == 0 || unknown_;
  const bool checks = due && started_;
  Found found;
  evaluation.arrival = halo_.arrival();
  if (checks)
    found = checkElements(x, evaluation);
  else
    body.evaluate(x, evaluation, workspace_);
  evaluation.arrival = nullptr;
  enum : std::size_t { need, notFinite, tangentNotFinite, inverted, wish };
  std::array<double, 5> told{found.need, finiteHere ? 0.0 : 1.0, found.finite ? 0.0 : 1.0,
                             -std::min(certificate_.statistics().leastDeterminant, 1e300), static_cast<double>(asked)};
  ranks_.beginLargest(told);
  if (meanwhile) meanwhile();
  ranks_.finishLargest();
  asked = static_cast<int>(told[wish]);
  finite_ = told[notFinite] == 0;
  report_.fresh = due && finite_;
  if (!finite_) {
    present({.kind = EventKind::nonFinite}, x);
    started_ = false;
    unknown_ = true;
    report_.bracket.reset();
    report_.certified = 0;
    report_.verdict = Verdict::violated;
    return report_;
  }
  if (due) {
    report_.evaluatedAt = step;
    refreshes_.tick();
    rebuilds_.tick();
    const double wanted = h ? lambdaFor(*h) : 0;
    if (started_ && (told[tangentNotFinite] != 0 || std::isnan(told[need]))) started_ = false;
    bool renewed = false;
    if (!started_) {
      renewed = renew(x, true, wanted);
      rebuilds_.restart();
    } else {
      if (told[need] > certificate_.certifiedEigenvalue()) {
        certificate_.setCertifiedEigenvalue(told[need]);
        ++cost_.raises;
      }
      const auto sigma = [&] { return certificate_.certifiedEigenvalue(); };
      if (options_.mode == MonitorMode::bracket) lower_ = mode_.bound(x);
      const double allowed = (1 + options_.width) * (1 + options_.width);
      const bool proves = !h || certifiedStep() >= *h;
      const bool risen = sigma() > mostRaised * provenAtRebuild_;
      const bool wide = options_.mode == MonitorMode::bracket && sigma() > allowed * lower_.value;
      if ((risen || !proves) && refreshes_.due()) {
        const double before = sigma();
        renewed = renew(x, false, wanted);
        refreshes_.tried(renewed && sigma() <= (1 - policy_.helpfulRefresh) * before);
      }
      if (started_ && h && certifiedStep() < *h && rebuilds_.due()) {
        renewed = renew(x, true, wanted);
        rebuilds_.tried(renewed && certifiedStep() >= *h);
      } else if (started_ && wide && !renewed && rebuilds_.due(policy_.updatesOfChange)) {
        const double before = sigma();
        renewed = renew(x, true, wanted);
        rebuilds_.tried(renewed && sigma() <= (1 - policy_.helpfulRebuild) * before);
      }
    }
    unknown_ = !started_;
    report_.bracket.reset();
    report_.certified = 0;
    if (started_) {
      report_.certified = certifiedStep();
      // In threshold mode the other side tells how far an uncertified step is from instability.
      const bool certified = h && report_.certified >= *h;
      const bool both = options_.mode == MonitorMode::bracket || !certified;
      if (both && !renewed && options_.mode == MonitorMode::threshold) lower_ = mode_.bound(x);
      if (both) setBracket();
    }
    if (-told[inverted] <= 0) {
      std::optional<ElementRef> least;
      if (certificate_.statistics().leastDeterminant == -told[inverted])
        least = part_.globalElement(certificate_.statistics().leastDeterminantElement);
      present({.kind = EventKind::inverted, .value = -told[inverted], .element = ranks_.first(least)}, x);
    } else {
      tracker_.absent(EventKind::inverted, step);
    }
  }
  if (unknown_)
    present({.kind = EventKind::nonFinite, .tangent = true}, x);
  else
    tracker_.absent(EventKind::nonFinite, step);
  report_.verdict = unknown_                       ? Verdict::violated
                    : h && report_.bracket         ? verdictFor(*h, *report_.bracket)
                    : h && *h <= report_.certified ? Verdict::certified
                                                   : Verdict::notCertified;
  if (h && report_.bracket && report_.verdict == Verdict::violated)
    present({.kind = EventKind::violated,
             .value = *h / report_.bracket->optimistic,
             .h = *h,
             .element = report_.bracket->controlling},
            x);
  else
    tracker_.absent(EventKind::violated, step);
  return report_;
}

const MonitorReport& RankMonitor::observeEnergies(const Energies& energies) {
  if (const auto share = energies_.observe(energies, report_.step, options_.energyTolerance))
    present({.kind = EventKind::energyBalance, .value = *share}, NodeVectorsView(nullptr, 0));
  else
    tracker_.absent(EventKind::energyBalance, report_.step);
  return report_;
}

const MonitorReport& RankMonitor::prove(NodeVectorsView x, double h) {
  report_.bracket.reset();
  report_.certified = 0;
  if (renew(x, true, lambdaFor(h))) {
    report_.certified = certifiedStep();
    setBracket();
  }
  unknown_ = !started_;
  report_.fresh = true;
  report_.evaluatedAt = report_.step;
  return report_;
}

void RankMonitor::setParts(int n) {
  parts_ = n;
  unknown_ = true;
}

CriticalStep RankMonitor::bracketFromScratch(NodeVectorsView x) {
  NodalBound& weights = certificate_.weights();
  weights.reset();
  started_ = false;
  const UpperBound highest = weights.evaluate(x, inspectionSweeps);
  if (!std::isfinite(highest.value)) return bracketOf(std::numeric_limits<double>::quiet_NaN());
  nameControlling(weights.last());
  mode_.reset();
  mode_.find(x, inspectionProducts);
  lower_ = mode_.bound(x);
  CriticalStep bracket = bracketOf(parts_ * safeStep(highest, options_.limit));
  bracket.safeBy = "nodal-bound";
  return bracket;
}

void RankMonitor::setBracket() {
  const CriticalStep bracket = bracketOf(certifiedStep());
  if (bracket.isBracket()) report_.bracket = bracket;
}

CriticalStep RankMonitor::bracketOf(double safe) const {
  CriticalStep bracket{};
  bracket.safe = safe;
  bracket.optimistic = parts_ * optimisticStep(lower_, options_.limit);
  bracket.controlling = bracket.lowestRingElement = controlling_;
  bracket.safeBy = "incremental-nodal-bound";
  bracket.optimisticBy = "rayleigh-quotient";
  return bracket;
}

double RankMonitor::verify(NodeVectorsView x) {
  double excess = -1;
  const Body& body = part_.body();
  for (std::size_t b = 0; b < body.blocks().size(); ++b)
    for (std::int32_t e = 0; e < body.blocks()[b]->elementCount(); ++e) {
      std::int32_t elements[lanes];
      std::fill(elements, elements + lanes, -1);
      elements[0] = e;
      double value[lanes];
      evaluateElements(body, certificate_.weights(), x, static_cast<std::int32_t>(b), elements, value, nullptr);
      if (value[0] > 0) excess = std::max(excess, value[0] / certificate_.allowance({b, e}) - 1);
    }
  for (std::int32_t node = 0; node < part_.ownedNodes(); ++node)
    excess = std::max(excess, largestEigenvalue(certificate_.sumOfAllowances(node) / body.lumpedMass()[node]) /
                                      certificate_.certifiedEigenvalue() -
                                  1);
  ranks_.largest({&excess, 1});
  return excess;
}

}  // namespace ringwatch
