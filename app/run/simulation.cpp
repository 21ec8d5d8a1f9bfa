#include <ringwatch/app/run/simulation.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include <ringwatch/app/run/stopwatch.h>
#include <ringwatch/app/scene/body_notes.h>
#include <ringwatch/app/scene/scene_discrete.h>
#include <ringwatch/base/error.h>
#include <ringwatch/body/discrete_forces.h>
#include <ringwatch/body/domain.h>
#include <ringwatch/handlers/angular_momentum.h>

namespace ringwatch {
namespace {

/// Shares of a step that are rounding of times.
constexpr double sameTime = 1e-6;

double kineticEnergy(const Body& body, const NodeVectors& v) {
  return 0.5 * v.colwise().squaredNorm().dot(body.lumpedMass().transpose());
}

}  // namespace

Simulation::Simulation(const Scene& s, Body& b, const RunOptions& o)
    : scene(s),
      body(b),
      options(o),
      ruleOfSteps(s, b),
      energies(s, b, roundingEnergy(b)),
      steps(s),
      loads(o.part ? std::move(*o.part->loads) : TimedLoads(s, b)),
      recorder(s, result),
      watch(s, b, rule, result),
      probes(s, b, rule) {
  result.probes = probes.columns();
  result.notes = options.notes;
  result.requireCertified = scene.requireCertified;
  result.proving = scene.proves();
  if (body.discreteForces()) result.discrete = RunResult::Discrete{};
  if (scene.onViolation == OnViolation::repeat) result.repeats = RunResult::Repeats{};
  for (std::string& note : notesOfBracket(scene, body)) result.notes.push_back(std::move(note));
  if (named()) recorder.follow(named()->mesh());
  if (!scene.handler.empty() && !scene.step) {
    const double wanted =
        scene.handlerStep ? *scene.handlerStep : scene.handlerFactor * criticalStep(body, body.mesh().X, rule).safe;
    steps.beginWith(std::min(wanted, scene.end));
  }
  preparedFor_ = steps.step();
  scheme = std::make_unique<RunScheme>(scene, body, result, preparedFor_, options.part);
  beginWatch();
}

void Simulation::beginWatch() {
  if (body.elementDamping()) body.elementDamping()->forgetRates();
  if (output) output->certificates().forget();  // what was observed last may be of another body
  Stepper& stepper = scheme->stepper();
  watch.begin(scheme->handler(), stepper.mostSteps() == 1);
}

bool Simulation::handleAgain() {
  watch.end();  // it watches what the choice replaces
  preparedFor_ = steps.step();
  const double before = kineticEnergy(body, state.v);
  const Eigen::VectorXd mass = body.lumpedMass();
  try {
    scheme->prepare(state.x, preparedFor_);
  } catch (const NumericalError& fault) {
    end(ExitReason::stepFailed,
        fmt::format("step {}: the handler cannot choose again: {}", result.steps, fault.what()));
    return false;
  }
  // Mass that is added comes with the velocity of its node. It must not push a body that nothing holds.
  if (mass != body.lumpedMass()) {
    if (!body.constraints().any()) keepMomenta(body, mass, state.x, state.v);
    energies.balance().addWork(0, kineticEnergy(body, state.v) - before);
  }
  state.a.resize(3, 0);
  beginWatch();
  return true;
}

std::int64_t Simulation::stepsToObservation(std::int64_t k) {
  std::int64_t count = scheme->stepper().mostSteps();
  // The work of prescribed motion is done in every step.
  if (count == 1 || (scene.energy && body.constraints().moving())) return 1;
  const auto until = [k](std::int64_t every) { return every - k % every; };
  count = std::min(count, until(scene.historyEvery));
  if (watch.monitors()) count = std::min(count, until(scene.every));
  if (scene.probed()) count = std::min(count, until(scene.probeEvery));
  const auto stepsTo = [this](double time) {
    return std::max<std::int64_t>(1, static_cast<std::int64_t>(std::ceil((time - state.time) / steps.step() - 1e-3)));
  };
  count = std::min(count, stepsTo(scene.end));
  if (!scene.step && state.time + static_cast<double>(count) * steps.step() > scene.end * (1 + 1e-12))
    count = std::max<std::int64_t>(1, count - 1);  // the last step of "auto" is shortened to end at the end
  if (output->nextFrame() < scene.end) count = std::min(count, stepsTo(output->nextFrame()));
  return count;
}

std::optional<CriticalStep> Simulation::criticalStepHere(std::int64_t* evaluations) const {
  try {
    return criticalStep(body, state.x, rule, {.evaluations = evaluations});
  } catch (const NumericalError&) {
    return std::nullopt;
  }
}

MonitorReport Simulation::handleMore(MonitorReport report, bool rowDue) {
  if (!scheme->handler() || !watch.monitors() || scene.onViolation != OnViolation::handle || !report.fresh ||
      (report.verdict == Verdict::certified && !scheme->handler()->asksForChoice()) || !(steps.step() > 0) ||
      !watch.isFinite(state))
    return report;
  {
    const Stopwatch measured(result.monitorTime);
    if (!handleAgain()) return report;
  }
  MonitorReport more = observeOnce(report.step, rowDue);
  // Those of the explicit elements are of a choice that no step was taken with.
  for (const MonitorEvent& event : report.newEvents)
    if (event.handled) more.newEvents.push_back(event);
  return more;
}

MonitorReport Simulation::referToStep(MonitorReport report, bool rowDue) {
  if (!ruleOfSteps.isOfLongerStep() || !report.fresh || report.verdict == Verdict::certified || !watch.isFinite(state))
    return report;
  {
    const Stopwatch measured(result.monitorTime);
    watch.end();
    ruleOfSteps.referToStep(body);
    beginWatch();
    watch.goOnWithEvents(report.step);
  }
  return observeOnce(report.step, rowDue);
}

MonitorReport Simulation::observeOnce(std::int64_t k, bool rowDue) {
  const bool shared = watch.sharesPass();
  askFor(rowDue, probes.needsForce(k));
  lookAhead();
  if (!shared) evaluate();
  // With "auto" the first step is chosen from the first bracket.
  MonitorReport report =
      watch.observe(k, state, steps.asked(), shared ? &evaluation_ : nullptr, [this] { takeForce(); });
  takeEvaluation(rowDue);
  watch.complete(report, state, energies.checked());
  return report;
}

/// Contact that can begin before the next observation counts in what is proven now. Nodes may become twice as fast.
/// Damping that depends on velocities counts as they are.
void Simulation::lookAhead() {
  if (watch.monitors()) body.followDampingRates(state.x, state.v);
  DiscreteForces* discrete = body.discreteForces();
  if (!discrete || !discrete->hasContact() || !watch.monitors()) return;
  constexpr double faster = 2;
  discrete->setReach(faster * static_cast<double>(scene.every) * steps.step() * discrete->largestSpeed(state.v));
}

void Simulation::recordEnergies() {
  askFor(true, false);
  evaluate();
  takeEvaluation(true);
}

void Simulation::completeState() {
  recordEnergies();  // first, since damping is of the velocities that lag
  scheme->stepper().complete(state);
}

void Simulation::askFor(bool rowDue, bool probesDue) {
  stepperNeedsForce_ = scheme->stepper().needsForce(state);
  evaluation_.wantsForce = stepperNeedsForce_ || energies.needsForce(rowDue) || probesDue;
  evaluation_.wantsEnergy = scene.energy && rowDue && body.domain().whole();  // else the balance sums it up
  evaluation_.velocities = body.elementDamping() ? &state.v : nullptr;
  dampingDue_ = energies.needsDamping(rowDue);
}

void Simulation::evaluate() {
  if (!evaluation_.wantsForce && !evaluation_.wantsEnergy) return;
  const Stopwatch force(result.forceTime);
  body.domain().finish();
  body.evaluate(state.x, evaluation_, workspace_);
}

void Simulation::takeForce() {
  const Stopwatch force(result.forceTime);
  if (std::exchange(dampingDue_, false)) energies.recordDamping(state, scheme->system());
  if (std::exchange(stepperNeedsForce_, false)) scheme->stepper().takeForce(state, evaluation_);
}

void Simulation::takeEvaluation(bool rowDue) {
  takeForce();
  const Stopwatch force(result.forceTime);
  if (const Handler* handler = scheme->handler(); handler && scene.energy && rowDue)
    energies.setDissipatedByHandler(handler->dissipated());
  energies.record(state, evaluation_, rowDue);
  energies.judge(state, steps.step(), result.certified());
}

void Simulation::setLoads() {
  if (loads.any()) loads.setForces(state.time, state.x, energies.balance());
}

bool Simulation::acceptState(const MonitorReport& report) {
  if (result.reason != ExitReason::end) return false;
  const bool finite = watch.monitors() ? watch.isFinite(state) : isFinite();
  if (!finite)
    end(ExitReason::nonFinite, fmt::format("positions or velocities are not finite after step {}", report.step));
  return finite;
}

void Simulation::checkEnergies(std::int64_t k) {
  if (loads.any() && k == 0) energies.setScale(loads.energyScale(steps.step()));
  energies.check(k, state.time);
}

bool Simulation::stopsAt(const MonitorReport& report) const {
  return report.verdict == Verdict::violated && watch.monitors() &&
         (scene.onViolation == OnViolation::stop || scene.onViolation == OnViolation::handle);
}

bool Simulation::isFinite() const {
  double isNot = ownFinite(body, state.x) && ownFinite(body, state.v) ? 0 : 1;
  body.domain().largest({&isNot, 1});
  return isNot == 0;
}

bool Simulation::chooseStep(MonitorReport& report) {
  std::string fault;
  const auto choose = [&] {
    fault = steps.choose(report, state.time, [this](MonitorReport& fresh) {
      const Stopwatch measured(result.monitorTime);
      fresh.fresh = true;
      fresh.elementsRefreshed = 0;
      fresh.bracket = criticalStepHere(&fresh.elementsRefreshed);
    });
  };
  // The first step of "auto" may be out of all proportion to the end, which one process tells for all.
  if (steps.step() > 0)
    choose();
  else
    body.domain().together(choose);
  if (!fault.empty()) {
    end(ExitReason::stepCollapsed, fault);
    return false;
  }
  if (steps.endsTheRun()) output->leaveOut(report.step);
  if (scheme->handler() && !scene.step && steps.step() != preparedFor_) {
    {
      const Stopwatch measured(result.monitorTime);
      if (!handleAgain()) return false;
      watch.goOnWithEvents(report.step);
    }
    MonitorReport fresh = observeOnce(report.step, rowDue_);
    std::erase_if(report.newEvents, [](const MonitorEvent& event) { return !event.handled; });
    fresh.newEvents.insert(fresh.newEvents.begin(), report.newEvents.begin(), report.newEvents.end());
    report = std::move(fresh);
  }
  steps.judge(report);
  watch.checkHandled(report);
  return true;
}

void Simulation::record(const MonitorReport& report, bool rowDue) {
  const Stopwatch measured(result.outputTime);
  if (!output->isOpen()) body.domain().together([this] { output->open(); });
  if (named()) recorder.record(report, named()->mesh());
  recorder.recordDiscrete(report, body, state.x);
  if (body.domain().whole()) recorder.recordReasons(report, body, state, rule);
  output->certificates().record(report, state, result.worst == Verdict::violated);
  if (rowDue) {
    HistoryRow row;
    row.step = report.step;
    row.time = state.time;
    row.h = report.h;
    row.bracket = report.bracket;
    row.energies = energies.last();
    ExactSum refreshed;  // small whole numbers
    if (watch.monitors() && report.fresh) refreshed.add(static_cast<double>(report.elementsRefreshed));
    body.domain().sum({&refreshed, 1});
    row.elementsRefreshed = static_cast<std::int64_t>(refreshed.value());
    row.handledElements = scheme->treatedElements();
    row.erodedElements = static_cast<std::int64_t>(result.eroded.size());
    row.repeats = result.repeats ? result.repeats->count : 0;
    row.metricStep = report.metricStep;
    if (watch.monitors()) row.verdict = report.verdict;
    output->writeRow(row);
  }
  if (probes.due(report.step))
    output->writeProbes(probes.row(report.step, state, report.h, evaluation_.internalForce, scheme->system()));
  if (output->frameDue(state.time, scene.exactTimes ? sameTime * report.h : report.h)) {
    body.domain().exchange(state.v);
    output->writeFrame(report.step, state, frameOf(report));
  }
}

void Simulation::writeFramesBetween(State& begin, const MonitorReport& report) {
  const Stopwatch measured(result.outputTime);
  body.domain().finish();
  body.domain().exchange(begin.v);
  const double h = state.time - begin.time;
  FrameState frame = frameOf(report);
  while (output->nextFrame() < state.time - sameTime * h) {
    // The parabola through both positions with the velocity of the first.
    frame.time = output->nextFrame();
    const double s = (frame.time - begin.time) / h;
    const NodeVectors rest = state.x - begin.x - h * begin.v;
    output->writeFrameBetween(begin.x + (s * h) * begin.v + (s * s) * rest, begin.v + (2 * s / h) * rest, frame);
  }
}

FrameState Simulation::frameOf(const MonitorReport& report) const {
  FrameState frame;
  frame.time = state.time;
  frame.h = steps.step();
  if (watch.monitors()) {
    frame.verdict = report.verdict;
    if (scene.proves()) {
      frame.safe = report.bracket ? report.bracket->safe : report.certified;
      if (report.bracket) frame.optimistic = report.bracket->optimistic;
    }
  }
  if (const Handler* handler = scheme->handler()) frame.handled = handler->elements();
  return frame;
}

bool Simulation::takeStep(const MonitorReport& report) {
  const Stopwatch force(result.forceTime);
  if (loads.any()) loads.setVelocities(state, steps.step(), energies.balance());
  const bool between = scene.exactTimes && output->nextFrame() < state.time + steps.step() * (1 - sameTime);
  State begin;
  if (between) begin = state;
  const auto take = [this](std::int64_t count) {
    const double lambda = watch.monitors() && scene.proves() ? rule.lambdaFor(steps.step()) : 0;
    return scheme->stepper().step(state, steps.step(), count, lambda);
  };
  Stepper::Taken taken = take(stepsToObservation(result.steps));
  while (taken.steps == 0 && scheme->handler() && scene.reduceOnFailure && steps.halve()) {
    result.notes.push_back(
        fmt::format("step {}: {}; the step is halved to {:.6g} s", report.step, taken.fault, steps.step()));
    if (!handleAgain()) return false;
    taken = take(1);
  }
  if (taken.steps == 0) {
    end(ExitReason::stepFailed, fmt::format("step {} failed: {}", report.step, taken.fault));
    return false;
  }
  if (between) writeFramesBetween(begin, report);
  recorder.countSteps(taken.steps, steps.step());
  if (watch.monitors()) recorder.countVerdict(report, taken.steps, watch.freshReports() <= 1);
  lastVerdict = report.verdict;
  return true;
}

MonitorReport Simulation::observe(std::int64_t k, bool rowDue) {
  rowDue_ = rowDue;
  return handleMore(referToStep(observeOnce(k, rowDue), rowDue), rowDue);
}

void Simulation::recordEvents(const MonitorReport& report) {
  if (named()) recorder.recordEvents(report, named()->mesh());
}

void Simulation::end(ExitReason reason, std::string text) {
  result.reason = reason;
  result.reasonText = std::move(text);
}

void Simulation::finish() {
  const bool whole = result.reason != ExitReason::failed;
  if (whole) scheme->stepper().complete(state);
  result.time = state.time;
  result.x = state.x;
  const bool finite = whole && isFinite();
  if (result.reason == ExitReason::end && !finite)
    end(ExitReason::nonFinite, fmt::format("positions or velocities are not finite after step {}", result.steps));
  // Nothing is known of the last state but what was known of the step that led to it.
  MonitorReport report;
  report.verdict = lastVerdict;
  report.certified = std::numeric_limits<double>::quiet_NaN();
  const FrameState last = whole ? frameOf(report) : FrameState();
  watch.end();
  if (named()) recorder.noteWhatIsNotCertified(named()->mesh());
  if (whole) {
    if (result.discrete && result.discrete->governed > 0 && !scene.contacts.empty())
      result.discrete->room = penaltyRoom(scene, body, result.largestStep);
    if (const Handler* handler = scheme->handler())
      result.handler->figures = scheme->stepper().figures(handler->figures());
    if (std::string note = scheme->stepper().note(); !note.empty()) result.notes.push_back(std::move(note));
    if (options.part) result.traffic = options.part->sent(result.steps);
    if (scene.frameInterval) body.domain().exchange(state.v);
  }
  result.runaway = energies.runaway();
  const Stopwatch measured(result.outputTime);
  output->finish(result, state, whole && finite ? &last : nullptr);
  recorder.completeReasons(body);
}

}  // namespace ringwatch
