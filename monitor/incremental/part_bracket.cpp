#include <ringwatch/monitor/incremental/part_bracket.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/body/domain.h>
#include <ringwatch/monitor/incremental/run_bracket.h>

namespace ringwatch {
namespace {

/// Tangent products of the first search of the top mode, and of later ones from the vector that is kept.
constexpr int coldProducts = 40, warmProducts = 10;
/// Of a bracket from scratch: sweeps of the weights, tangent products.
constexpr int sweepsFromScratch = 24, productsFromScratch = 120;
/// The certified eigenvalue above the last renewal's from which all elements are evaluated again: 2.5 % of the step.
constexpr double mostRaised = 1.05;
/// Growth of compression that asks for a search: less than BracketPolicy's, whose rings are examined between searches.
constexpr double growthOfCompression = 1.1;
/// Left below the eigenvalue of a step that is to be proven, so that rounding does not make it less than the step.
constexpr double belowWanted = 1e-9;

/// The element that holds most of the sum at the first node where it is highest, numbered as in the whole.
ElementRef controllingElement(const Body& body, const NodalBound& weights) {
  Domain& domain = body.domain();
  std::int32_t top = -1;
  for (std::int32_t node = 0; node < domain.owned(body.nodeCount()) && top < 0; ++node)
    if (weights.nodal()[node] == weights.last()) top = node;
  const double own = top < 0 ? -infinity : -static_cast<double>(domain.nodeInWhole(top));
  double first = own;
  domain.largest({&first, 1});
  std::optional<ElementRef> highest;
  double most = -1;
  if (top >= 0 && own == first)
    for (const NodalBound::Incidence at : weights.incidences(top)) {
      const ElementRef e = weights.elementAt(at);
      const double share = weights.value(e) * weights.weight(at).trace();
      if (share > most) {
        most = share;
        highest = e;
      }
    }
  std::string none;
  return domain.firstFound(highest, none).value_or(ElementRef());
}

CriticalStep bracketOf(double safe, std::string_view safeBy, LowerBound lower, const StepRule& limit,
                       ElementRef controlling, const LowestMode& lowest) {
  return {safe,          optimisticStep(lower, limit), controlling,
          safeBy,        "rayleigh-quotient",          std::min(lowest.value, 0.0),
          lowest.element};
}

/// What the vector proves at x.
double quotientOf(PartMode& soft, NodeVectorsView x) { return -soft.bound(x).value; }

}  // namespace

PartBracket::PartBracket(const Body& body, double width, bool threshold)
    : body_(body),
      width_(width),
      threshold_(threshold),
      certificate_(body),
      mode_(body),
      soft_(body, PartMode::End::lowest),
      refreshes_(policy_.refreshes),
      rebuilds_(policy_.rebuilds),
      searches_(BracketPolicy{}.searches) {}

bool PartBracket::checkElements(NodeVectorsView x, StepEvaluation& evaluation) {
  std::vector<ElementRef> evaluated, raised;
  for (const RunCertificate::ElementOutside& outsider :
       certificate_.growBalls(x, certificate_.elementsOutsideBall(x, &evaluation)))
    evaluated.push_back(outsider.element);
  std::vector<RunCertificate::Reference> now;
  certificate_.evaluate(x, evaluated, false, now);
  bool finite = true;
  for (std::size_t i = 0; i < evaluated.size(); ++i) {
    // Values are kept in single precision.
    finite &= now[i].value <= static_cast<double>(std::numeric_limits<float>::max());
    if (now[i].value > certificate_.allowance(evaluated[i])) raised.push_back(evaluated[i]);
  }
  certificate_.raiseToValues(raised, policy_.raisedSlack * policy_.slack);
  const Domain& domain = body_.domain();
  evaluated_ = std::count_if(evaluated.begin(), evaluated.end(), [&](ElementRef e) { return domain.counts(e); });
  return finite;
}

void PartBracket::renew(NodeVectorsView x, bool newWeights, double wanted) {
  NodalBound& weights = certificate_.weights();
  if (newWeights) {
    weights.reset();
    weights.evaluate(x, policy_.sweeps, NodalBound::Start::rows, policy_.leastGain);
  } else {
    weights.evaluate(x, 0);
  }
  evaluated_ += weights.evaluations();
  const double tight = weights.last();
  started_ = std::isfinite(tight) && tight > 0;
  if (!started_) return;
  controlling_ = controllingElement(body_, weights);
  mode_.find(x, mode_.found() ? warmProducts : coldProducts);
  lower_ = mode_.bound(x);
  // Room for the elements: at least the policy's, and what the width of the bracket leaves.
  const double wide = 1 + policy_.targetOfWidth * width_;
  double sigma = std::max(tight * (1 + policy_.slack), wide * wide * lower_.value);
  if (tight <= wanted * (1 - policy_.proofMargin) && (threshold_ || wanted < sigma)) sigma = wanted * (1 - belowWanted);
  certificate_.setCertifiedEigenvalue(sigma);
  certificate_.distributeAllowances(x, newWeights);
  provenAtRebuild_ = sigma;
  compression_ = certificate_.mostCompression();
  body_.domain().largest({&compression_, 1});
}

void PartBracket::searchUnderCompression(NodeVectorsView x) {
  const BracketPolicy policy;
  searches_.tick();
  const bool known = lowest_.value < 0;
  if (known) lowest_.value = quotientOf(soft_, x);
  const bool grown = compression_ > growthOfCompression * searchedAt_ && searches_.since() >= policy.searchGap,
             lost = known && !(lowest_.value < 0);
  if (!(compression_ > policy.slightlyCompressed) || !(grown || lost || searches_.due())) return;
  soft_.find(x, known ? policy.laterSearch : policy.firstSearch);
  lowest_.value = quotientOf(soft_, x);
  if (lowest_.value < 0) lowest_.element = soft_.softestElement(x);
  searches_.tried(grown);
  searchedAt_ = grown ? compression_ : std::max(searchedAt_, compression_);
}

bool PartBracket::test(NodeVectorsView x, bool finite, bool due, StepEvaluation& evaluation,
                       const std::function<void()>& meanwhile) {
  certificate_.statistics() = {};
  evaluated_ = 0;
  bool tangentIsFinite = true;
  evaluation.arrival = body_.domain().arrival();
  if (due && started_)
    tangentIsFinite = checkElements(x, evaluation);
  else
    body_.evaluate(x, evaluation, workspace_);
  evaluation.arrival = nullptr;
  enum : std::size_t { needed, notFinite, tangentNotFinite, inverted, compression };
  // The reductions take no infinity.
  std::array<double, 5> told{sigma(), finite ? 0.0 : 1.0, tangentIsFinite ? 0.0 : 1.0,
                             -std::fmin(certificate_.statistics().leastDeterminant, 1e300),
                             certificate_.mostCompression()};
  body_.domain().largest(told, meanwhile);
  certificate_.setCertifiedEigenvalue(told[needed]);
  least_ = -told[inverted];
  compression_ = told[compression];
  if (told[notFinite] != 0 || told[tangentNotFinite] != 0 || !std::isfinite(sigma())) started_ = false;
  return told[notFinite] == 0;
}

void PartBracket::update(NodeVectorsView x, const StepRule& limit, std::optional<double> h) {
  refreshes_.tick();
  rebuilds_.tick();
  const double wanted = h ? limit.lambdaFor(*h) : 0;
  const auto proves = [&] { return !h || safeStep(UpperBound{sigma()}, limit) >= *h; };
  bool renewed = false;
  const auto tryRenewal = [&](bool newWeights) {
    renewed = true;
    renew(x, newWeights, wanted);
    return started_;
  };
  if (!started_) {
    tryRenewal(true);
    rebuilds_.restart();
  } else {
    if (!threshold_) lower_ = mode_.bound(x);
    const double before = sigma(), allowed = (1 + width_) * (1 + width_);
    const bool wide = !threshold_ && before > allowed * lower_.value;
    if ((before > mostRaised * provenAtRebuild_ || !proves()) && refreshes_.due())
      refreshes_.tried(tryRenewal(false) && sigma() <= (1 - policy_.helpfulRefresh) * before);
    if (started_ && !proves() && rebuilds_.due())
      rebuilds_.tried(tryRenewal(true) && proves());
    else if (started_ && wide && !renewed && rebuilds_.due(policy_.updatesOfChange))
      rebuilds_.tried(tryRenewal(true) && sigma() <= (1 - policy_.helpfulRebuild) * before);
  }
  step_.reset();
  certified_ = 0;
  if (!started_) {
    lowest_ = {};
    return;
  }
  searchUnderCompression(x);
  certified_ = safeStep(UpperBound{sigma()}, limit);
  // In threshold mode the other side tells how far an uncertified step is from instability.
  if (threshold_ && h && certified_ >= *h) return;
  if (threshold_ && !renewed) lower_ = mode_.bound(x);
  step_ = bracketOf(certified_, "incremental-nodal-bound", lower_, limit, controlling_, lowest_);
  if (!step_->isBracket()) step_.reset();
}

Body::LeastDeterminant PartBracket::leastDeterminant() const {
  if (least_ > 0) return {least_, {}};
  const UpdateStatistics& statistics = certificate_.statistics();
  std::optional<ElementRef> own;
  if (statistics.leastDeterminant == least_) own = statistics.leastDeterminantElement;
  std::string none;
  return {least_, body_.domain().firstFound(own, none).value_or(ElementRef())};
}

CriticalStep criticalStepOfParts(const Body& body, NodeVectorsView x, const StepRule& limit,
                                 std::int64_t& evaluations) {
  NodalBound weights(body);
  weights.setDomain(body.domain());
  const UpperBound highest = weights.evaluate(x, sweepsFromScratch);
  evaluations += weights.evaluations();
  if (!std::isfinite(highest.value))
    throw NumericalError("the tangent is not finite at these positions: there is no critical step");
  PartMode mode(body);
  mode.find(x, productsFromScratch);
  LowestMode lowest;
  double moved = x == body.mesh().X ? 0 : 1;  // at rest no element is soft
  body.domain().largest({&moved, 1});
  if (moved > 0) {
    PartMode soft(body, PartMode::End::lowest);
    soft.find(x, LowestModeSearch::usualProducts);
    lowest.value = quotientOf(soft, x);
    if (lowest.value < 0) lowest.element = soft.softestElement(x);
  }
  return bracketOf(safeStep(highest, limit), "nodal-bound", mode.bound(x), limit, controllingElement(body, weights),
                   lowest);
}

}  // namespace ringwatch
