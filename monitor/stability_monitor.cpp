#include <ringwatch/monitor/stability_monitor.h>

#include <algorithm>
#include <cmath>

#include <ringwatch/base/backoff.h>
#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/base/error.h>
#include <ringwatch/meshes/all_finite.h>
#include <ringwatch/monitor/element_cause.h>
#include <ringwatch/monitor/exchange_bound.h>
#include <ringwatch/monitor/incremental_nodal_bound.h>
#include <ringwatch/monitor/lowest_mode.h>
#include <ringwatch/monitor/nodal_bound.h>
#include <ringwatch/monitor/rayleigh.h>
#include <ringwatch/monitor/top_mode.h>

namespace ringwatch {
namespace {

constexpr int energySettling = 20;  // observations before the energy balance is judged

/// criticalStep() that also adds up the element evaluations that it took.
CriticalStep bracketFromScratch(const Body& body, const NodeVectors& x, const StepRule& limit,
                                const std::optional<LanczosOptions>& lanczos, std::int64_t& evaluations);

/// Keeps both sides of the bracket along a run: the incremental nodal bound from above, a hot spot of the tracked mode
/// from below.
class Bracketer {
 public:
  Bracketer(const Body& body, double width)
      : body_(body),
        width_(width),
        nodal_(body, {.slack = slackOfWidth * width}),
        submatrix_(body, nodal_.weights()),
        ringNodes_(body, nodal_.weights()) {}

  /// Unless nullptr, `evaluation` is filled in at x. Empty where the tangent is not finite, or where rounding
  /// makes the sides cross.
  const std::optional<CriticalStep>& evaluate(const NodeVectors& x, const StepRule& limit, StepEvaluation* evaluation) {
    const double sigma = nodal_.certifiedEigenvalue();  // that allowances belong to
    UpperBound upper = nodal_.update(x, evaluation);
    spent_ = nodal_.statistics();
    bracketed_ = true;
    finite_ = std::isfinite(upper.value);
    if (!finite_) {
      forget();
      return step_;
    }
    method_ = "rayleigh-quotient";
    LowerBound lower{0};
    const bool first = mode_.size() == 0, rebuilt = spent_.rebuilds > 0;
    if (!first) {
      lower = submatrix_.evaluate(x);
      wholeMode_.tick();
      if (wholeMode_.due()) {
        const LowerBound whole = refreshMode(x, warmProducts);
        // Seldom while the submatrix tells all.
        wholeMode_.tried(whole.value > 1.005 * lower.value);
        lower = {std::max(lower.value, whole.value)};
      }
      lower = boundWhereItRose(x, sigma, lower);
    }
    const double allowed = (1 + width_) * (1 + width_);
    // A bracket that is too wide is either side's fault: bound it from below again before moving the upper side.
    const bool wide = upper.value > allowed * lower.value;
    if (wide) restart_.tick();
    if (first || rebuilt || (wide && restart_.due())) {
      const double before = lower.value;
      lower = first ? startMode(x) : restartMode(x);
      // The submatrix is a part of the whole, its bound a little lower.
      restart_.tried(lower.value > 1.02 * before);
    }
    searchUnderCompression(x);
    nodal_.relaxBound(lower, width_);
    upper.value = std::max(upper.value, nodal_.certifiedEigenvalue());
    if (upper.value > allowed * lower.value && nodal_.tightenBound(x, lower, width_)) {
      spent_.evaluated += nodal_.statistics().evaluated;
      upper = nodal_.update(x);
      spent_.evaluated += nodal_.statistics().evaluated;
    }
    step_ = CriticalStep{safeStep(upper, limit),
                         optimisticStep(lower, limit),
                         submatrix_.highestElement(),
                         "lazy-nodal-bound",
                         method_,
                         lowest_.value,
                         lowest_.element};
    if (!step_->isBracket()) step_.reset();
    return step_;
  }
  /// Whether h is certified at x, in the cheapest way. While it is not, the bracket is kept, and some observations
  /// longer: then last() is fresh and `bracketed` true.
  bool judge(const NodeVectors& x, const StepRule& limit, double h, StepEvaluation* evaluation) {
    std::int64_t before = 0;
    if (sinceDoubt_ >= firstGap) {
      const bool certified = nodal_.certify(x, limit.lambdaFor(h), evaluation);
      evaluation = nullptr;
      spent_ = nodal_.statistics();
      bracketed_ = false;
      if (certified) {
        searchUnderCompression(x);
        return true;
      }
      before = spent_.evaluated;
    }
    evaluate(x, limit, evaluation);
    spent_.evaluated += before;
    const bool certified = step_ && h <= step_->safe;
    sinceDoubt_ = certified ? sinceDoubt_ + 1 : 0;
    return certified;
  }
  bool bracketed() const { return bracketed_; }
  /// Whether the tangent was finite when last evaluated.
  bool finite() const { return finite_; }
  /// Makes the best proof from scratch at x, which is kept for as long as the body stays there.
  void proveFromScratch(const NodeVectors& x, const StepRule& limit) {
    if (!step_ || !finite_) return;
    try {
      best_ = bracketFromScratch(body_, x, limit, std::nullopt, spent_.evaluated);
      bestAt_ = x;
      bestVersion_ = body_.version();
    } catch (const NumericalError&) {
      // From scratch there is no bracket, and the last one stays.
    }
  }
  /// Replaces either side of the last bracket by that of the proof from scratch, where it is of this x and better.
  void takeBest(const NodeVectors& x) {
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
  /// The optimistic side as sharp as it can be had, for a step that comes close to the limit.
  void sharpen(const NodeVectors& x, const StepRule& limit) {
    if (!step_) return;
    const LowerBound lower = sinceSharpened_++ % firstGap == 0 ? restartMode(x) : refreshMode(x, restartProducts);
    step_->optimistic = std::min(step_->optimistic, optimisticStep(lower, limit));
    if (!step_->isBracket()) step_.reset();
  }
  const UpdateStatistics& spent() const { return spent_; }
  /// Of the last evaluate().
  const std::optional<CriticalStep>& last() const { return step_; }
  /// Least eigenvalue of the reduced 1-rings and of the direction that were evaluated last, rad²/s².
  struct LowestRing {
    double value;
    ElementRef element;
  };
  const LowestRing& lowestRing() const { return lowest_; }

 private:
  /// The state has no tangent: nothing that is known of the modes can be carried over it.
  void forget() {
    step_.reset();
    mode_.resize(3, 0);
    submatrix_.choose(mode_);
    lowest_ = {0, {}};
    softest_.resize(3, 0);
    least_ = {};
    search_.reset();
    searchedAt_ = 0;
  }
  /// Only elements under compression can make the tangent indefinite. When there are some, their rings are evaluated
  /// now and then, and a direction of negative stiffness is searched in the whole body: at the first evaluation, when
  /// compression has grown since the last search, and else more and more seldom.
  void searchUnderCompression(const NodeVectors& x) {
    const double compression = nodal_.mostCompression();
    search_.tick();
    const bool grown = compression > growth * searchedAt_ && search_.since() >= firstGap;
    const bool search = compression > slightlyCompressed && (grown || search_.due());
    if (search) {
      least_ = findLowestMode(body_, x, softest_, softest_.cols() == 0 ? coldSearch : warmSearch);
      search_.tried(grown);
      searchedAt_ = grown ? compression : std::max(searchedAt_, compression);
    } else if (!(compression > slightlyCompressed)) {
      least_ = {};
    }
    if (++sinceCompressed_ < firstGap && !search) return;
    sinceCompressed_ = 0;
    const std::vector<ElementRef> all = nodal_.compressedElements(compressed);
    // The most compressed ones, the lowest so far, and others by turns.
    std::vector<ElementRef> chosen;
    for (std::size_t i = 0; i < all.size() && i < compressedRings; ++i) {
      chosen.push_back(all[i]);
      chosen.push_back(all[nextCompressed_++ % all.size()]);
    }
    if (lowest_.value < 0) chosen.push_back(lowest_.element);
    lowest_ = {0, {}};
    if (least_.value < 0) lowest_ = {least_.value, least_.element};
    for (const ElementRef e : chosen) {
      if (!decomposeRing(x, e)) continue;
      // Constrained components have eigenvalues of zero, to rounding.
      const double least = solver_.eigenvalues()[0] + 1e-10 * solver_.eigenvalues().cwiseAbs().maxCoeff();
      if (least < lowest_.value) lowest_ = {least, e};
    }
  }
  /// The top mode jumps to where an element has become stiffer than it had been: rings there are examined at once.
  LowerBound boundWhereItRose(const NodeVectors& x, double sigma, LowerBound lower) {
    bool jumped = false;
    std::size_t observations = 0;
    for (const IncrementalNodalBound::NearLimit& near : nodal_.nearLimit()) {
      // One that is within its allowance is worth an evaluation when the bound there is above what is known from below.
      if (observations >= (near.fraction > 1 ? risenRings : 1) || near.fraction * sigma < 1.005 * lower.value) break;
      ++observations;
      if (!decomposeRing(x, near.element)) continue;
      const double value = topOfRing();
      if (!(value > lower.value)) continue;
      lower = {value};
      method_ = "reduced-1-ring";
      jumped = true;
      mode_.normalize();
      addTopOfRing(mode_);
    }
    if (jumped) submatrix_.choose(mode_);
    return lower;
  }
  /// The reduced ring of one element into solver_; false when it fails.
  bool decomposeRing(const NodeVectors& x, ElementRef e) {
    const auto nodes = body_.blocks()[e.block]->nodesOf(e.element);
    ringNodes_.choose({nodes.begin(), nodes.end()});
    solver_.compute(ringNodes_.evaluate(x));
    return solver_.info() == Eigen::Success;
  }
  /// From the highest of all rings.
  LowerBound restartMode(const NodeVectors& x) {
    ReducedRing ring(body_);  // restarts are rare, and its pattern is as large as all the rest
    const TopMode top = findTopMode(ring, body_, x, mode_, coldProducts, restartProducts, false);
    method_ = top.method;
    spent_.evaluated += body_.mesh().elementCount();
    return followMode(x, top.lower);
  }
  /// At first, when the nodal bound is of now: from the highest of the rings where it is highest.
  LowerBound startMode(const NodeVectors& x) {
    const std::vector<ElementRef> hot = nodal_.highestElements(highestRings);
    mode_ = NodeVectors::Zero(3, body_.nodeCount());
    double highest = 0;
    for (const ElementRef e : hot) {
      if (!decomposeRing(x, e)) continue;
      const double value = topOfRing();
      if (!(value > highest)) continue;
      highest = value;
      mode_.setZero();
      addTopOfRing(mode_);
    }
    spent_.evaluated += static_cast<std::int64_t>(hot.size());
    const LowerBound quotient = rayleighLowerBound(body_, x, mode_, coldProducts);
    method_ = quotient.value > highest ? "rayleigh-quotient" : "reduced-1-ring";
    return followMode(x, {std::max(quotient.value, highest)});
  }
  /// Of the ring that was decomposed last: its highest eigenvalue, rounded down, and that one's vector.
  double topOfRing() const {
    return solver_.eigenvalues()[solver_.eigenvalues().size() - 1] -
           1e-12 * solver_.eigenvalues().cwiseAbs().maxCoeff();
  }
  void addTopOfRing(NodeVectors& mode) const {
    const auto top = solver_.eigenvectors().col(solver_.eigenvectors().cols() - 1);
    for (std::size_t k = 0; k < ringNodes_.nodes().size(); ++k)
      mode.col(ringNodes_.nodes()[k]) += top.segment<3>(static_cast<Eigen::Index>(3 * k));
  }
  LowerBound refreshMode(const NodeVectors& x, int products) {
    return followMode(x, rayleighLowerBound(body_, x, mode_, products));
  }
  LowerBound followMode(const NodeVectors& x, LowerBound whole) {
    submatrix_.choose(mode_);
    wholeMode_.restart();
    return {std::max(whole.value, submatrix_.evaluate(x).value)};
  }
  static constexpr double slackOfWidth = 1.6;
  static constexpr int coldProducts = 20, restartProducts = 8, warmProducts = 3;
  // Evaluations between two observations under compression, and of a step that is certified before it is judged
  // cheaply.
  static constexpr int firstGap = 10;
  static constexpr std::size_t compressedRings = 16, risenRings = 3, highestRings = 64;  // examined each time
  static constexpr double compressed = 0.05, slightlyCompressed = 1e-3;                  // of λ+2μ
  // Of the search for a negative direction: tangent products of the first and of the others, the growth of compression
  // that asks for one.
  static constexpr int coldSearch = 48, warmSearch = 12;
  static constexpr double growth = 1.5;

  const Body& body_;
  double width_;
  IncrementalNodalBound nodal_;
  LocalSubmatrix submatrix_;
  NodeSubmatrix ringNodes_;
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver_;
  NodeVectors mode_;
  std::string_view method_;
  UpdateStatistics spent_;
  bool bracketed_ = true, finite_ = true;
  int sinceDoubt_ = firstGap;  // observations in a row that certified the step asked about
  int sinceSharpened_ = 0, sinceCompressed_ = firstGap;
  // In evaluations: of the whole mode, restarts from all rings, searches for a negative direction.
  Backoff wholeMode_{{.first = 64, .last = 512, .factor = 2}}, restart_{{.first = firstGap, .last = 2560, .factor = 4}},
      search_{{.first = 80, .last = 2560, .factor = 2}};
  LowestRing lowest_{0, {}};
  std::size_t nextCompressed_ = 0;
  NodeVectors softest_;                      // the direction of the last search
  LowestMode least_;                         // what it proved
  double searchedAt_ = 0;                    // the compression then
  std::optional<CriticalStep> step_, best_;  // best_: from scratch, of positions bestAt_ and that version of the body
  NodeVectors bestAt_;
  std::int64_t bestVersion_ = 0;
};

void requireProof(const StepRule& rule) {
  if (!rule.proven())
    throw InputError(
        "limit: a bracket needs a proven rule, which damped runs have with symplectic-euler and verlet; use one of "
        "them, "
        "or a metric instead of the bracket");
}

}  // namespace

struct StabilityMonitor::Impl {
  Impl(const Body& b, const MonitorOptions& o)
      : body(b), options(o), tracker(o.clearObservations), bodyVersion(b.version()) {
    if (o.mode != MonitorMode::metric) bracketer.emplace(b, o.width);
    if (!o.metric.empty() && !o.metricElsewhere) metric = makeMetricEvaluator(o.metric, b);
    largestEnergy = roundingEnergy(b);
  }
  /// The metric's highest value at x, rad²/s².
  double metricLambda(const NodeVectors& x) {
    return options.metricElsewhere ? options.metricElsewhere(x) : metric->highest(x);
  }

  const Body& body;
  Body::Workspace workspace;
  MonitorOptions options;
  std::optional<Bracketer> bracketer;
  std::unique_ptr<MetricEvaluator> metric;
  MonitorReport report;
  EventTracker tracker;
  double largestEnergy = 0;
  std::int64_t observations = 0, energyObservations = 0, bodyVersion = 0;
  bool unknown = false;            // the last state had no tangent
  bool provenFromScratch = false;  // the first bracket was

  /// Reports an event when it begins; step, time and cause are filled in.
  void present(MonitorEvent event, const NodeVectors& x) {
    if (!tracker.isNew(event.kind)) return;
    event.step = report.step;
    event.time = report.time;
    if (event.element) event.cause = elementCause(body, x, *event.element);
    report.newEvents.push_back(tracker.begin(event));
  }
  void absent(EventKind kind) { tracker.absent(kind, report.step); }
  void tellInverted(const Body::LeastDeterminant& least, const NodeVectors& x) {
    if (least.value > 0)
      absent(EventKind::inverted);
    else
      present({.kind = EventKind::inverted, .value = least.value, .element = least.element}, x);
  }
  /// Nothing is known of this state: what was known of an earlier one is dropped, and the next finite one is evaluated.
  void forget() {
    report.bracket.reset();
    report.metricStep.reset();
    report.certified = 0;
    unknown = true;
  }
  /// Bracket, certified step and metric at x.
  void evaluate(const NodeVectors& x, std::optional<double> h, StepEvaluation* evaluation) {
    report.fresh = true;
    report.evaluatedAt = report.step;
    bodyVersion = body.version();
    unknown = false;
    if (bracketer) {
      bool certified = false, bracketed = true;
      if (options.mode == MonitorMode::threshold && h) {
        certified = bracketer->judge(x, options.limit, *h, evaluation);
        bracketed = bracketer->bracketed();
      } else {
        bracketer->evaluate(x, options.limit, evaluation);
      }
      if (!provenFromScratch && bracketed) {
        provenFromScratch = true;
        if (static_cast<std::int64_t>(body.mesh().elementCount()) <= options.firstObservationElements)
          bracketer->proveFromScratch(x, options.limit);
      }
      if (bracketed) {
        bracketer->takeBest(x);
        certified = bracketer->last() && (!h || *h <= bracketer->last()->safe);
      }
      // Where the step is not certified, the optimistic side decides between "not certified" and "violated": it is made
      // sharp at every observation: else a mode that has moved on would say so late.
      if (!certified) bracketer->sharpen(x, options.limit);
      report.bracket.reset();
      if (bracketed) report.bracket = bracketer->last();
      report.certified = !bracketed ? *h : report.bracket ? report.bracket->safe : 0;
      const UpdateStatistics& spent = bracketer->spent();
      report.elementsRefreshed = spent.evaluated;
      unknown = !bracketer->finite();
      // An element that inverts leaves its ball first, so the elements evaluated are all that can have inverted. Where
      // the tangent is not finite the evaluation has ended early.
      const Body::LeastDeterminant least =
          unknown ? body.leastDeterminant(x)
                  : Body::LeastDeterminant{spent.leastDeterminant, spent.leastDeterminantElement};
      tellInverted(least, x);
      const Bracketer::LowestRing& lowest = bracketer->lowestRing();
      if (lowest.value < 0)
        present({.kind = EventKind::indefinite, .value = lowest.value, .element = lowest.element}, x);
      else
        absent(EventKind::indefinite);
    }
    if (!options.metric.empty()) {
      report.metricStep = (1 - options.margin) * options.limit(metricLambda(x));
      report.elementsRefreshed += static_cast<std::int64_t>(body.mesh().elementCount());
      tellInverted(body.leastDeterminant(x), x);
    }
  }
};

StabilityMonitor::StabilityMonitor(const Body& body, const MonitorOptions& options) {
  if (!options.metric.empty() && !findMetric(options.metric))
    evaluateMetric(options.metric, body, body.mesh().X);  // throws
  if (!(options.margin >= 0 && options.margin < 1))
    throw InputError(joinText("margin = ", options.margin, ": must be >= 0 and < 1"));
  if (options.every < 1) throw InputError(joinText("every = ", options.every, ": must be >= 1"));
  if (options.clearObservations < 1)
    throw InputError(joinText("clearObservations = ", options.clearObservations, ": must be >= 1"));
  if (options.mode == MonitorMode::metric && options.metric.empty())
    throw InputError("mode = metric: needs a metric; name one, or choose bracket or threshold");
  if (!(options.width > 0 && options.width < 1))
    throw InputError(joinText("width = ", options.width, ": must be > 0 and < 1"));
  // The step at lambda = 1 rad²/s² is the limit itself.
  if (!(options.limit(1) > 0))
    throw InputError(joinText("limit = ", options.limit(1),
                              ": an integrator that is never stable cannot be monitored; choose another"));
  if (!(options.energyTolerance > 0))
    throw InputError(joinText("energyTolerance = ", options.energyTolerance, ": must be > 0"));
  if (options.mode != MonitorMode::metric) requireProof(options.limit);
  impl_ = std::make_unique<Impl>(body, options);
}
StabilityMonitor::~StabilityMonitor() = default;

const std::vector<MonitorEvent>& StabilityMonitor::events() const { return impl_->tracker.events(); }
const MonitorOptions& StabilityMonitor::options() const { return impl_->options; }

const MonitorReport& StabilityMonitor::observe(std::int64_t step, double time, const NodeVectors& x,
                                               const NodeVectors& v, std::optional<double> h,
                                               StepEvaluation* evaluation) {
  Impl& m = *impl_;
  m.body.checkNodal("x", x);
  m.body.checkNodal("v", v);
  if (h && (!(*h > 0) || !std::isfinite(*h)))
    throw InputError(joinText("h = ", *h, " s: must be > 0 and finite; pass std::nullopt while no step is chosen"));
  MonitorReport& report = m.report;
  report.step = step;
  report.time = time;
  report.h = h.value_or(0);
  report.newEvents.clear();
  report.fresh = false;
  report.elementsRefreshed = 0;

  const bool finite = allFinite(x, m.body.threads()) && allFinite(v, m.body.threads());
  const bool due =
      finite && (m.observations++ % m.options.every == 0 || m.unknown || m.bodyVersion != m.body.version());
  if (evaluation && (!due || !m.bracketer)) {
    m.body.evaluate(x, *evaluation, m.workspace);
    evaluation = nullptr;
  }
  if (!finite) {
    m.present({.kind = EventKind::nonFinite}, x);
    m.forget();
    report.verdict = Verdict::violated;
    return report;
  }
  if (due) m.evaluate(x, h, evaluation);
  if (m.unknown)
    m.present({.kind = EventKind::nonFinite, .tangent = true}, x);
  else
    m.absent(EventKind::nonFinite);
  // A metric with a margin proves nothing: it can only say that the step is above what it recommends.
  const bool above = h && report.bracket && !(*h <= report.bracket->optimistic);
  report.verdict = m.bracketer && h && *h <= report.certified ? Verdict::certified
                   : above || m.unknown                       ? Verdict::violated
                                                              : Verdict::notCertified;
  if (above) {
    const CriticalStep& b = *report.bracket;
    m.present({.kind = EventKind::violated, .value = *h / b.optimistic, .h = *h, .element = b.controlling}, x);
  } else if (m.bracketer) {
    m.absent(EventKind::violated);
  }
  return report;
}

const MonitorReport& StabilityMonitor::observeEnergies(const Energies& energies) {
  Impl& m = *impl_;
  m.largestEnergy =
      std::max({m.largestEnergy, energies.kinetic + std::abs(energies.strain), std::abs(energies.externalWork)});
  const double share = m.largestEnergy > 0 ? std::abs(energies.balanceError) / m.largestEnergy : 0;
  // Schemes whose velocities are half a step behind, symplectic Euler for one, are off by 1/n of the energy at step n
  // of a run that starts under load.
  const bool settled = m.energyObservations++ >= energySettling;
  if (settled && share > m.options.energyTolerance)
    m.present({.kind = EventKind::energyBalance, .value = share}, m.body.mesh().X);
  else
    m.absent(EventKind::energyBalance);
  return m.report;
}

CriticalStep criticalStep(const Body& body, const NodeVectors& x, const StepRule& limit,
                          const std::optional<LanczosOptions>& lanczos) {
  std::int64_t evaluations = 0;
  return bracketFromScratch(body, x, limit, lanczos, evaluations);
}

namespace {
CriticalStep bracketFromScratch(const Body& body, const NodeVectors& x, const StepRule& limit,
                                const std::optional<LanczosOptions>& lanczos, std::int64_t& evaluations) {
  requireProof(limit);
  body.checkNodal("x", x);
  constexpr int products = 20, sweeps = 12, iterations = 60, searchProducts = 48;
  constexpr double aim = 1.01, narrow = 1.02;    // in lambda: 0.5 % and 1 % of the step
  constexpr std::int64_t mostBytes = 4LL << 30;  // beyond, the nodal bound has to do
  ReducedRing ring(body);
  NodeVectors mode;
  const TopMode top = findTopMode(ring, body, x, mode, products, products, true);
  const LowerBound lower = top.lower;
  NodalBound weights(body);
  UpperBound upper = weights.evaluate(x, sweeps, NodalBound::Start::rootOfStiffness);
  if (!std::isfinite(upper.value))
    throw NumericalError("the tangent is not finite at these positions: there is no critical step");
  std::string_view safeBy = "nodal-bound";
  evaluations += static_cast<std::int64_t>(body.mesh().elementCount()) + weights.evaluations();
  if (upper.value > narrow * lower.value && exchangeBoundBytes(body) <= mostBytes) {
    const ExchangeBound split =
        exchangeUpperBound(body, x, weights, aim * lower.value, narrow * lower.value, iterations);
    evaluations += split.decompositions;
    if (split.upper.value < upper.value) {
      upper = split.upper;
      safeBy = "split-bound";
    }
  }
  CriticalStep step{
      safeStep(upper, limit), optimisticStep(lower, limit), ring.last().highestElement, safeBy, top.method,
      ring.last().lowest,     ring.last().lowestElement};
  if (!step.isBracket())
    throw NumericalError(joinText("the sides of the bracket cross by rounding: safe ", step.safe, " s, optimistic ",
                                  step.optimistic, " s"));
  // At rest there is no stress that could make the tangent indefinite.
  if (!(step.lowestRing < 0) && x != body.mesh().X) {
    NodeVectors direction;
    const LowestMode lowest = findLowestMode(body, x, direction, searchProducts);
    if (lowest.value < 0) {
      step.lowestRing = lowest.value;
      step.lowestRingElement = lowest.element;
    }
  }
  if (lanczos) {
    const LanczosBound bound = lanczosUpperBound(body, x, lanczos->width, lanczos->eta, lanczos->seed);
    step.probable = {limit(bound.upper.value), bound.upper.eta, bound.products};
  }
  return step;
}
}  // namespace

}  // namespace ringwatch
