#include <ringwatch/monitor/critical_step.h>

#include <algorithm>
#include <cmath>

#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/body/discrete_forces.h>
#include <ringwatch/body/domain.h>
#include <ringwatch/monitor/bounds/exchange_bound.h>
#include <ringwatch/monitor/bounds/lowest_mode.h>
#include <ringwatch/monitor/bounds/nodal_bound.h>
#include <ringwatch/monitor/bounds/top_mode.h>
#include <ringwatch/monitor/incremental/part_bracket.h>

namespace ringwatch {
namespace {

// Tangent products for the top mode; sweeps of the nodal bound, which gain little after.
constexpr int products = 20, firstSweeps = 1, sweeps = 12;

}  // namespace

void requireProof(const StepRule& rule) {
  if (!rule.proven())
    throw InputError(
        "limit: a bracket needs a proven rule, which damped runs have with symplectic-euler and verlet; use one of "
        "them, or a metric instead of the bracket");
}

CriticalStep criticalStep(const Body& body, NodeVectorsView x, const StepRule& limit,
                          const CriticalStepOptions& options) {
  requireProof(limit);
  body.checkNodal("x", x);
  if (!(options.width >= 0) || !std::isfinite(options.width))
    throw InputError(joinText("width = ", options.width, ": must be >= 0, e.g. 0.05 for 5 %"));
  if (!body.domain().whole()) {
    if (options.lanczos)
      throw InputError("a step that is safe with a probability: is not computed on a part of a body");
    std::int64_t spent = 0;
    const CriticalStep step = criticalStepOfParts(body, x, limit, options.evaluations ? *options.evaluations : spent);
    if (!step.isBracket()) throw NumericalError("the sides of the bracket cross by rounding");
    return step;
  }
  const auto count = [&](std::int64_t spent) {
    if (options.evaluations) *options.evaluations += spent;
  };
  const auto tell = [&](UpperBound upper, double optimistic) {
    if (options.listener && std::isfinite(upper.value)) options.listener(safeStep(upper, limit), optimistic);
  };
  NodalBound weights(body);
  UpperBound upper = weights.evaluate(x, firstSweeps);
  count(weights.evaluations());
  if (!std::isfinite(upper.value))
    throw NumericalError("the tangent is not finite at these positions: there is no critical step");
  tell(upper, infinity);
  ReducedRing ring(body);
  NodeVectors mode;
  const TopMode top = findTopMode(ring, body, x, mode, products, products, true);
  count(static_cast<std::int64_t>(body.mesh().elementCount()));
  const LowerBound lower = top.lower();
  // Of the quotient it is known what dashpots give, which can say more of the step than a higher eigenvalue.
  const double optimistic = std::min(optimisticStep(lower, limit), optimisticStep(top.quotient, limit));
  tell(upper, optimistic);
  const double enough = (1 + options.width) * (1 + options.width) * lower.value;
  if (upper.value > enough) {
    const SweepTarget target{.ample = enough, .leastOfRest = 0.5};
    upper.value = std::min(upper.value, weights.evaluate(x, sweeps, NodalBound::Start::rows, 0, target).value);
    count(weights.evaluations());
    tell(upper, optimistic);
  }
  std::string_view safeBy = "nodal-bound";
  if (ExchangePolicy::worth(body, upper, lower, options.width)) {
    const ExchangeBound exchange = exchangeUpperBound(body, x, weights, lower, options.width);
    count(exchange.decompositions);
    if (exchange.upper.value < upper.value) {
      upper = exchange.upper;
      safeBy = "exchange-bound";
    }
  }
  CriticalStep step{safeStep(upper, limit), optimistic,         ring.last().highestElement, safeBy,
                    top.method(),           ring.last().lowest, ring.last().lowestElement};
  step.dampingShare = top.quotient.dampingShare();
  if (body.discreteForces() && lower.value > 0 && mode.squaredNorm() > 0) {
    const NodeVectors v = mode * body.lumpedMass().cwiseSqrt().cwiseInverse().asDiagonal();
    step.discreteShare = body.discreteForces()->form(x, v) / (lower.value * mode.squaredNorm());
  }
  if (!weights.poorlyConditioned().empty()) {
    step.poorlyConditioned = weights.poorlyConditioned().size();
    step.worstConditioned = weights.poorlyConditioned().front().element;
  }
  if (!step.isBracket())
    throw NumericalError(joinText("the sides of the bracket cross by rounding: safe ", step.safe, " s, optimistic ",
                                  step.optimistic, " s"));
  // At rest only springs can have a stress that makes the tangent indefinite.
  if (!step.indefinite() && (x != body.mesh().X || body.discreteForces())) {
    const LowestMode lowest = LowestModeSearch(body).find(x, LowestModeSearch::usualProducts);
    if (lowest.value < 0) {
      step.lowestRing = lowest.value;
      step.lowestRingElement = lowest.element;
    }
  }
  if (options.lanczos) {
    const LanczosBound bound =
        lanczosUpperBound(body, x, options.lanczos->width, options.lanczos->eta, options.lanczos->seed);
    step.probable = {limit(bound.upper.value), bound.upper.eta, bound.products};
  }
  return step;
}

}  // namespace ringwatch
