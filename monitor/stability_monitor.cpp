#include <ringwatch/monitor/stability_monitor.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <ringwatch/base/archive.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/fnv.h>
#include <ringwatch/body/domain.h>
#include <ringwatch/monitor/element_cause.h>
#include <ringwatch/monitor/energy_check.h>
#include <ringwatch/monitor/incremental/part_bracket.h>
#include <ringwatch/monitor/incremental/run_bracket.h>

namespace ringwatch {

struct StabilityMonitor::Impl {
  Impl(const Body& b, const MonitorOptions& o)
      : body(b), options(o), tracker(o.clearObservations), energies(roundingEnergy(b)), bodyVersion(b.version()) {
    if (!b.domain().whole())
      ofPart.emplace(b, o.width, o.mode == MonitorMode::threshold);
    else if (o.mode != MonitorMode::metric)
      bracket.emplace(b, o.width, o.budget, o.steps, o.workInAdvance, o.every);
    if (!o.metric.empty()) metric = makeMetricEvaluator(o.metric, b);
  }

  const Body& body;
  Body::Workspace workspace;
  MonitorOptions options;
  std::optional<RunBracket> bracket;
  std::optional<PartBracket> ofPart;  // in place of it
  std::unique_ptr<MetricEvaluator> metric;
  MonitorReport report;
  EventTracker tracker;
  EnergyCheck energies;
  std::int64_t observations = 0, bodyVersion = 0;
  bool evaluatesNext = false;
  bool finite = true;        // the last state
  bool unknown = false;      // the last state had no tangent
  bool hadABracket = false;  // the best proof is for the first one alone

  /// What bytes must be of: the sizes of the body, the options that decide what is kept, and the width of packs, in
  /// which elements are stored.
  std::vector<std::int64_t> kind() const {
    std::vector<std::int64_t> numbers{static_cast<std::int64_t>(options.mode),
                                      options.every,
                                      static_cast<std::int64_t>(!options.metric.empty()),
                                      nativeWidth,
                                      body.nodeCount(),
                                      static_cast<std::int64_t>(body.constraints().components().size())};
    for (const auto& block : body.blocks()) numbers.push_back(block->elementCount());
    return numbers;
  }
  template <class Archive>
  void archive(Archive& a) {
    if (ofPart) throw InputError("saved state: is of a monitor of a whole body, not of a part of one");
    std::vector<std::int64_t> own = kind();
    a(own);
    if (own != kind()) throw InputError("saved state: is of another body, other options or another build");
    if (bracket) a(*bracket);
    a(options.firstObservationElements, report.step, report.time, report.h, report.fresh, report.evaluatedAt,
      report.bracket, report.certified, report.elementsRefreshed, report.spent, report.metricStep, report.verdict,
      report.newEvents, tracker, energies, observations, unknown, hadABracket);
    archiveVersion(a, bodyVersion, body.version());
  }

  /// Reports an event when it begins; step, time and cause are filled in.
  void present(MonitorEvent event, NodeVectorsView x) {
    if (!tracker.isNew(event.kind)) return;
    event.step = report.step;
    event.time = report.time;
    if (event.element && !(event.discreteShare > 0.5)) event.cause = elementCause(body, x, *event.element);
    report.newEvents.push_back(tracker.begin(event));
  }
  void absent(EventKind kind) { tracker.absent(kind, report.step); }
  void tellInverted(const Body::LeastDeterminant& least, NodeVectorsView x) {
    if (least.value > 0)
      absent(EventKind::inverted);
    else
      present({.kind = EventKind::inverted, .value = least.value, .element = least.element}, x);
  }
  /// lowest: a value, rad²/s², and an element.
  template <class Lowest>
  void tellIndefinite(const Lowest& lowest, NodeVectorsView x) {
    if (lowest.value < 0)
      present({.kind = EventKind::indefinite, .value = lowest.value, .element = lowest.element}, x);
    else
      absent(EventKind::indefinite);
  }
  /// Nothing is known of this state: what was known of an earlier one is dropped, and the next finite one is evaluated.
  void forget() {
    report.bracket.reset();
    report.metricStep.reset();
    report.certified = 0;
    unknown = true;
  }
  /// Bracket, certified step and metric at x.
  void evaluate(NodeVectorsView x, std::optional<double> h, StepEvaluation* evaluation) {
    report.fresh = true;
    report.evaluatedAt = report.step;
    bodyVersion = body.version();
    unknown = false;
    if (ofPart) {
      ofPart->update(x, options.limit, h);
      unknown = !ofPart->finite();
      report.bracket = ofPart->last();
      report.certified = ofPart->certified();
      report.elementsRefreshed = ofPart->evaluated();
      tellInverted(ofPart->leastDeterminant(), x);
      tellIndefinite(ofPart->lowest(), x);
    }
    if (bracket) {
      bool certified = false, bracketed = true;
      const Work before = bracket->spent();
      if (options.mode == MonitorMode::threshold && h) {
        certified = bracket->certify(x, options.limit, *h, evaluation);
        bracketed = bracket->bracketed();
      } else {
        bracket->evaluate(x, options.limit, options.stepFollows ? std::nullopt : h, evaluation);
      }
      if (!hadABracket && bracketed) {
        hadABracket = true;
        // Where no step is chosen a narrow bracket is enough: what is left to gain is worth less than it costs. A step
        // that is chosen hangs on it while it lies between the sides.
        const std::optional<CriticalStep>& known = bracket->last();
        const bool wanted = known && (h ? *h > known->safe && *h <= known->optimistic
                                        : known->optimistic > (1 + options.width) * known->safe);
        if (wanted && static_cast<std::int64_t>(body.mesh().elementCount()) <= options.firstObservationElements)
          bracket->proveFromScratch(x, options.limit);
      }
      if (bracketed) {
        bracket->takeBest(x);
        certified = bracket->last() && (!h || *h <= bracket->last()->safe);
      }
      // Where the step is not certified, the optimistic side decides between "not certified" and "violated".
      if (!certified && h && !options.stepFollows) bracket->sharpen(x, options.limit, *h);
      const Work after = bracket->spent();
      for (std::size_t i = 0; i < worksOn; ++i)
        report.spent.of[i] = (after.of[i] - before.of[i]) / bracket->workOfStep();
      report.bracket.reset();
      if (bracketed) report.bracket = bracket->last();
      report.certified = !bracketed ? *h : report.bracket ? report.bracket->safe : 0;
      const UpdateStatistics& statistics = bracket->statistics();
      report.elementsRefreshed = statistics.evaluated;
      unknown = !bracket->finite();
      // An element that inverts leaves its ball first, so those looked at are all that can be inverted. Where
      // the tangent is not finite the evaluation has ended early.
      const Body::LeastDeterminant least =
          unknown ? body.leastDeterminant(x, Body::Among::whereInversionIsAnError)
                  : Body::LeastDeterminant{statistics.leastDeterminant, statistics.leastDeterminantElement};
      tellInverted(least, x);
      tellIndefinite(bracket->lowestRing(), x);
    }
    if (!options.metric.empty()) {
      report.metricStep = (1 - options.margin) * options.limit(metric->highest(x));
      report.elementsRefreshed += static_cast<std::int64_t>(body.mesh().elementCount());
      tellInverted(body.leastDeterminant(x, Body::Among::whereInversionIsAnError), x);
    }
  }
};

StabilityMonitor::StabilityMonitor(const Body& body, const MonitorOptions& options) {
  if (!options.metric.empty() && !body.domain().whole())
    throw InputError(joinText("metric = ", options.metric, ": is not computed on a part of a body; leave it out"));
  if (!options.metric.empty() && !findMetric(options.metric))
    evaluateMetric(options.metric, body, body.mesh().X);  // throws
  if (!(options.margin >= 0 && options.margin < 1))
    throw InputError(joinText("margin = ", options.margin, ": must be >= 0 and < 1"));
  if (options.every < 1) throw InputError(joinText("every = ", options.every, ": must be >= 1"));
  if (!(options.budget >= 0)) throw InputError(joinText("budget = ", options.budget, ": must be >= 0"));
  if (!(options.workInAdvance >= 0))
    throw InputError(joinText("workInAdvance = ", options.workInAdvance, ": must be >= 0"));
  if (options.steps < 0) throw InputError(joinText("steps = ", options.steps, ": must be >= 0"));
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

std::string StabilityMonitor::save() const {
  SavingArchive archive;
  impl_->archive(archive);
  return sealed(archive.take());
}

void StabilityMonitor::load(std::string_view saved) {
  const std::optional<std::string_view> bytes = unsealed(saved);
  if (!bytes) throw InputError("saved monitor: is damaged");
  LoadingArchive archive(*bytes);
  impl_->archive(archive);
  archive.end();
}

bool StabilityMonitor::stateIsFinite() const { return impl_->finite; }

void StabilityMonitor::evaluateNext() { impl_->evaluatesNext = true; }

const MonitorReport& StabilityMonitor::observe(std::int64_t step, double time, NodeVectorsView x, NodeVectorsView v,
                                               std::optional<double> h, StepEvaluation* evaluation,
                                               const std::function<void()>& meanwhile) {
  Impl& m = *impl_;
  m.body.checkNodal("x", x);
  m.body.checkNodal("v", v);
  if (h && (!(*h > 0) || !std::isfinite(*h)))
    throw InputError(joinText("h = ", *h, " s: must be > 0 and finite; give none while no step is chosen"));
  MonitorReport& report = m.report;
  report.step = step;
  report.time = time;
  report.h = h.value_or(0);
  report.newEvents.clear();
  report.fresh = false;
  report.elementsRefreshed = 0;
  report.spent = {};

  m.finite = ownFinite(m.body, x) && ownFinite(m.body, v);
  const bool asked = std::exchange(m.evaluatesNext, false),
             wanted = m.observations % m.options.every == 0 || asked || m.unknown || m.bodyVersion != m.body.version();
  if (m.ofPart) {
    StepEvaluation nothing;
    nothing.wantsForce = false;
    m.finite = m.ofPart->test(x, m.finite, wanted, evaluation ? *evaluation : nothing, meanwhile);
  }
  m.observations += m.finite ? 1 : 0;
  const bool due = m.finite && wanted;
  if (evaluation && !m.ofPart && (!due || !m.bracket)) {
    m.body.evaluate(x, *evaluation, m.workspace);
    evaluation = nullptr;
  }
  if (!m.finite) {
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
  // Without a bracket the step may be certified all the same, in threshold mode. A metric with a margin proves nothing:
  // it can only say that the step is above what it recommends.
  const bool proves = m.bracket || m.ofPart;
  report.verdict = m.unknown                               ? Verdict::violated
                   : h && report.bracket                   ? verdictFor(*h, *report.bracket)
                   : proves && h && *h <= report.certified ? Verdict::certified
                                                           : Verdict::notCertified;
  if (h && report.bracket && report.verdict == Verdict::violated) {
    CriticalStep& b = *report.bracket;
    // What governs is searched now and then, and the optimistic side may have been sharpened since: an event that
    // begins names what governs at its own state.
    if (report.fresh && m.bracket && m.tracker.isNew(EventKind::violated)) {
      m.bracket->nameGoverning(x);
      b.controlling = m.bracket->last()->controlling;
      b.discreteShare = m.bracket->last()->discreteShare;
    }
    m.present({.kind = EventKind::violated,
               .value = *h / b.optimistic,
               .h = *h,
               .discreteShare = b.discreteShare,
               .element = b.controlling},
              x);
  } else if (proves) {
    m.absent(EventKind::violated);
  }
  return report;
}

const MonitorReport& StabilityMonitor::observeEnergies(const Energies& energies) {
  Impl& m = *impl_;
  if (const auto share = m.energies.observe(energies, m.report.step, m.options.energyTolerance))
    m.present({.kind = EventKind::energyBalance, .value = *share}, m.body.mesh().X);
  else
    m.absent(EventKind::energyBalance);
  return m.report;
}

}  // namespace ringwatch
