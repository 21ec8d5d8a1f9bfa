#include <ringwatch/monitor/stability_monitor.h>

#include <algorithm>
#include <cmath>

#include <ringwatch/base/error.h>
#include <ringwatch/monitor/nodal_bound.h>
#include <ringwatch/monitor/rayleigh.h>
#include <ringwatch/monitor/reduced_ring.h>

namespace ringwatch {
namespace {

/// Both sides of the bracket from the current shapes and top vector; used by the monitor at every evaluation and by
/// criticalStep once.
class Bracketer {
 public:
  explicit Bracketer(const Body& body) : ring_(body), bound_(body), body_(body) {}

  const CriticalStep& evaluate(const NodeVectors& x, double limit) {
    const ReducedRing::Result& rings = ring_.evaluate(x, true);
    // A tracked vector alone can miss a jump of the top mode: the hottest ring's own vector is mixed in every time.
    const bool warm = top_.size() > 0;
    NodeVectors vector = ring_.topVector(rings.highestElement);
    if (warm) vector += (vector.cwiseProduct(top_).sum() < 0 ? -1.0 : 1.0) * top_;
    const LowerBound quotient = rayleighLowerBound(body_, x, vector, warm ? warmProducts : coldProducts);
    top_ = vector;
    const bool byRing = !(quotient.value > rings.highest);
    const LowerBound lower{byRing ? rings.highest : quotient.value};

    // Shapes follow the deformation with a few sweeps; when the bracket stays wide they start afresh, from either start.
    UpperBound upper = bound_.evaluate(x, warm ? warmSweeps : coldSweeps);
    const bool tired = warm && ++sinceFresh_ >= freshEvery;
    for (const NodalBound::Start start : {NodalBound::Start::stiffness, NodalBound::Start::rootOfStiffness}) {
      if (!(upper.value > wideBracket * lower.value) || (warm && !tired)) break;
      sinceFresh_ = 0;
      NodalBound other(bound_);
      other.reset();
      const UpperBound value = other.evaluate(x, coldSweeps, start);
      if (!(value.value < upper.value)) continue;
      upper = value;
      bound_ = std::move(other);
    }
    step_ = {safeStep(upper, limit), optimisticStep(lower, limit), rings.highestElement, "nodal-bound",
             byRing ? "reduced-1-ring" : "rayleigh-quotient", rings.lowest, rings.lowestElement};
    return step_;
  }
  const ReducedRing& ring() const { return ring_; }

 private:
  static constexpr int coldSweeps = 20, warmSweeps = 3;
  static constexpr int coldProducts = 20, warmProducts = 4;
  static constexpr double wideBracket = 1.06;  // in lambda: 3 % of the step
  static constexpr int freshEvery = 10;        // evaluations between two attempts to start afresh

  ReducedRing ring_;
  NodalBound bound_;
  const Body& body_;
  NodeVectors top_;
  int sinceFresh_ = freshEvery;
  CriticalStep step_{};
};

std::string elementText(const Body& body, ElementRef e) {
  const MeshBlock& block = body.mesh().blocks[static_cast<std::size_t>(e.block)];
  std::string text = joinText(elementInfo(block.type).name, " element ", e.block, ":", e.element, " (nodes");
  for (int a = 0; a < block.nodesPerElement(); ++a) text += joinText(" ", block.element(static_cast<std::size_t>(e.element))[a]);
  return text + ")";
}

}  // namespace

std::string_view verdictName(Verdict verdict) {
  switch (verdict) {
    case Verdict::certified: return "certified";
    case Verdict::notCertified: return "not-certified";
    case Verdict::violated: return "violated";
  }
  return "";
}

std::string_view eventName(EventKind kind) {
  switch (kind) {
    case EventKind::violated: return "violated";
    case EventKind::energyBalance: return "energy-balance";
    case EventKind::inverted: return "inverted";
    case EventKind::nonFinite: return "non-finite";
    case EventKind::indefinite: return "indefinite";
  }
  return "";
}

struct StabilityMonitor::Impl {
  Impl(const Body& b, const MonitorOptions& o) : body(b), options(o), bracketer(b) {}

  const Body& body;
  MonitorOptions options;
  Bracketer bracketer;
  MonitorReport report;
  std::vector<MonitorEvent> events;
  bool active[5] = {};  // by EventKind: going on at the last observation
  double largestEnergy = 0;
  std::int64_t observations = 0;

  /// Records an event when it begins; it may be reported again after it has ended.
  void tell(EventKind kind, bool now, double value, std::optional<ElementRef> element, const std::string& what) {
    bool& before = active[static_cast<int>(kind)];
    if (now && !before) {
      MonitorEvent event{kind, report.step, report.time, value, element,
                         joinText("step ", report.step, ", t = ", report.time, " s: ", what)};
      if (element) event.text += ", " + elementText(body, *element);
      report.newEvents.push_back(event);
      events.push_back(std::move(event));
    }
    before = now;
  }
};

StabilityMonitor::StabilityMonitor(const Body& body, const MonitorOptions& options) {
  if (!options.metric.empty() && !findMetric(options.metric)) evaluateMetric(options.metric, body, body.mesh().X);  // throws
  if (!(options.margin >= 0 && options.margin < 1)) throw InputError(joinText("margin = ", options.margin, ": must be >= 0 and < 1"));
  if (options.every < 1) throw InputError(joinText("every = ", options.every, ": must be >= 1"));
  if (!(options.limit > 0)) throw InputError(joinText("limit = ", options.limit, ": an integrator that is never stable cannot be monitored; choose another"));
  impl_ = std::make_unique<Impl>(body, options);
}
StabilityMonitor::~StabilityMonitor() = default;

const std::vector<MonitorEvent>& StabilityMonitor::events() const { return impl_->events; }
const MonitorOptions& StabilityMonitor::options() const { return impl_->options; }

const MonitorReport& StabilityMonitor::observe(std::int64_t step, double time, const NodeVectors& x, const NodeVectors& v,
                                               double h, const Energies* energies) {
  Impl& m = *impl_;
  MonitorReport& report = m.report;
  report.step = step;
  report.time = time;
  report.h = h;
  report.newEvents.clear();
  report.fresh = false;

  const bool finite = x.allFinite() && v.allFinite();
  m.tell(EventKind::nonFinite, !finite, 0, std::nullopt, "positions or velocities are not finite");
  if (!finite) {
    report.verdict = Verdict::violated;
    return report;
  }
  if (energies) {
    m.largestEnergy = std::max({m.largestEnergy, energies->kinetic + std::abs(energies->strain), std::abs(energies->externalWork)});
    const double share = m.largestEnergy > 0 ? std::abs(energies->balanceError) / m.largestEnergy : 0;
    m.tell(EventKind::energyBalance, share > m.options.energyTolerance, share, std::nullopt,
           joinText("energy balance is off by ", 100 * share, " % of the largest energy so far"));
  }
  if (m.observations++ % m.options.every == 0) {
    report.fresh = true;
    const Body::LeastDeterminant least = m.body.leastDeterminant(x);
    m.tell(EventKind::inverted, !(least.value > 0), least.value, least.element, joinText("inverted, det F = ", least.value));
    if (m.options.bracket) {
      report.bracket = m.bracketer.evaluate(x, m.options.limit);
      m.tell(EventKind::indefinite, report.bracket->lowestRing < 0, report.bracket->lowestRing, report.bracket->lowestRingElement,
             joinText("tangent indefinite, eigenvalue ", report.bracket->lowestRing, " rad2/s2: no step cures that"));
    }
    if (!m.options.metric.empty()) {
      const double lambda = m.options.bracket && m.options.metric == "reduced-1-ring"
                                ? m.bracketer.ring().last().highest
                                : evaluateMetric(m.options.metric, m.body, x).lambda;
      report.metricStep = (1 - m.options.margin) * stepFor(lambda, m.options.limit);
    }
  }
  if (report.bracket) {
    const CriticalStep& b = *report.bracket;
    report.verdict = h <= b.safe ? Verdict::certified : h <= b.optimistic ? Verdict::notCertified : Verdict::violated;
    m.tell(EventKind::violated, report.verdict == Verdict::violated, h / b.optimistic, b.controlling,
           joinText("violated: h = ", h, " s is above the critical step, which is at most ", b.optimistic, " s"));
  } else if (report.metricStep) {
    // A metric with a margin proves nothing: it can only say that the step is above what it recommends.
    report.verdict = Verdict::notCertified;
  }
  return report;
}

CriticalStep criticalStep(const Body& body, const NodeVectors& x, double limit) { return Bracketer(body).evaluate(x, limit); }

}  // namespace ringwatch
