#include <ringwatch/app/run/run_watch.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include <ringwatch/app/run/stopwatch.h>
#include <ringwatch/body/domain.h>

namespace ringwatch {

RunWatch::RunWatch(const Scene& scene, const Body& body, StepRule rule, RunResult& result)
    : scene_(scene), body_(body), rule_(std::move(rule)), result_(result) {}

void RunWatch::begin(Handler* handler, bool everyState) {
  end();
  handler_ = handler;
  everyState_ = everyState;
  if (!scene_.monitored()) return;
  const Body& watched = handler_ ? handler_->explicitBody() : body_;
  if (watched.domain().whole() && watched.mesh().elementCount() == 0) return beginWithNothingExplicit();
  MonitorOptions wanted;
  wanted.limit = handler_ ? rule_.ofParts(handler_->partsOfStep()) : rule_;
  wanted.mode = scene_.mode;
  wanted.metric = scene_.metric;
  wanted.margin = scene_.margin;
  // Where not every state is seen, the monitor is asked only where it is to evaluate.
  wanted.every =
      everyState_ ? static_cast<int>(std::min<std::int64_t>(scene_.every, std::numeric_limits<int>::max())) : 1;
  if (scene_.budget) {
    wanted.budget = *scene_.budget;
    wanted.workInAdvance = 0;
  }
  wanted.stepFollows = !scene_.step && !scene_.holdsStep && !handler_;
  constexpr double endless = 1e15;  // steps
  if (scene_.step)
    wanted.steps = static_cast<std::int64_t>(std::min(std::ceil(scene_.end / *scene_.step), endless)) /
                   (everyState_ ? 1 : scene_.every);
  wanted.energyTolerance = scene_.energyTolerance;
  if (monitored_) wanted.firstObservationElements = 0;  // too dear at every choice of a handler
  monitored_ = true;
  monitor_.emplace(watched, wanted);
}

void RunWatch::beginWithNothingExplicit() {
  handlerProves_ = scene_.proves() && handler_->provesHandledPart();
  if (result_.handler->nothingExplicit) return;
  result_.handler->nothingExplicit = true;
  result_.notes.push_back(fmt::format("every element is handled: there is no explicit one to monitor. {}",
                                      handlerProves_
                                          ? "Steps are certified by what the handler proves of its own"
                                          : "That steps of the handled ones are stable is assumed, not proven"));
}

void RunWatch::end() {
  const auto close = [&](const std::vector<MonitorEvent>& events, bool handled) {
    for (RunEvent& told : result_.events)
      for (const MonitorEvent& known : events)
        if (told.event.handled == handled && known.kind == told.event.kind && known.step == told.event.step)
          told.event.end = known.end;
  };
  for (const GoingOn& one : goingOn_)
    if (monitor_ && one.comesAt)
      for (const MonitorEvent& known : monitor_->events())
        if (MonitorEvent& told = result_.events[one.event].event; known.kind == told.kind && known.step == *one.comesAt)
          told.end = known.end;
  goingOn_.clear();
  close(handledWatch_.events(), true);
  if (monitor_) close(monitor_->events(), false);
  monitor_.reset();
  handlerProves_ = false;
  handler_ = nullptr;
}

MonitorReport RunWatch::observe(std::int64_t k, const State& state, std::optional<double> h, StepEvaluation* evaluation,
                                const std::function<void()>& meanwhile) {
  MonitorReport report;
  report.step = k;
  report.time = state.time;
  report.h = h.value_or(0);
  if (!monitor_) {
    if (!handlerProves_) return report;
    report.fresh = k % scene_.every == 0;
    report.verdict = Verdict::certified;  // until complete() has asked the handler
    return report;
  }
  const Stopwatch watch(result_.monitorTime);
  if (!sees(k)) {
    report = lastReport_;
    report.step = k;
    report.time = state.time;
    report.fresh = false;
    report.newEvents.clear();
    return report;
  }
  if (evaluation) evaluation->wallTime = 0;
  report = monitor_->observe(k, state.time, state.x, state.v, h, evaluation, meanwhile);
  if (evaluation) {
    // The pass over the elements counts as the force's, which it serves too.
    result_.monitorTime -= evaluation->wallTime;
    result_.forceTime += evaluation->wallTime;
  }
  freshReports_ += report.fresh ? 1 : 0;
  if (!everyState_) lastReport_ = report;
  return report;
}

bool RunWatch::isFinite(const State& state) const {
  return monitor_ && everyState_ ? monitor_->stateIsFinite() : ringwatch::isFinite(state, body_.threads());
}

void RunWatch::complete(MonitorReport& report, const State& state, const std::optional<Energies>& energies) {
  if (!scene_.monitored()) return;
  const Stopwatch watch(result_.monitorTime);
  if (monitor_ && !handler_ && energies && sees(report.step))
    report.newEvents = monitor_->observeEnergies(*energies).newEvents;
  // A monitor begins anew with every choice of a handler, and would never come to judge.
  if (handler_ && energies)
    if (const auto event = handledWatch_.observeEnergies(*energies, report.step, state.time, scene_.energyTolerance))
      report.newEvents.push_back(*event);
  dropContinued(report);
  if (!handler_) return;
  if (const std::string news = handler_->news(); !news.empty())
    result_.notes.push_back(fmt::format("step {}, t = {:.6g} s: {}", report.step, state.time, news));
  if (body_.domain().whole()) nameElements(report);  // else they have the names of the whole
  if (report.step % scene_.every == 0 && isFinite(state)) watchHandled(report, state);
  checkHandled(report);
}

void RunWatch::goOnWithEvents(std::int64_t k) {
  goingOn_.clear();
  for (std::size_t i = 0; i < result_.events.size(); ++i)
    if (!result_.events[i].event.end) goingOn_.push_back({i});
  checkpointStep_ = k;
  sinceCheckpoint_ = 0;
}

void RunWatch::dropContinued(MonitorReport& report) {
  if (goingOn_.empty()) return;
  std::erase_if(report.newEvents, [&](const MonitorEvent& event) {
    for (GoingOn& one : goingOn_)
      if (!one.comesAt && result_.events[one.event].event.kind == event.kind) {
        one.comesAt = event.step;
        return true;
      }
    return false;
  });
  if (++sinceCheckpoint_ <= MonitorOptions{}.clearObservations) return;
  std::erase_if(goingOn_, [&](const GoingOn& one) {
    if (!one.comesAt) result_.events[one.event].event.end = checkpointStep_;
    return !one.comesAt;
  });
}

void RunWatch::watchHandled(MonitorReport& report, const State& state) {
  const bool certifiedBefore = handledWatch_.uncertifiedPart().empty();
  if (const auto event = handledWatch_.observe(*handler_, body_, report.step, state.time, state.x))
    report.newEvents.push_back(*event);
  if (const std::string& part = handledWatch_.uncertifiedPart(); certifiedBefore && !part.empty())
    result_.notes.push_back(fmt::format("step {}, t = {:.6g} s: {}", report.step, state.time, part));
}

void RunWatch::checkHandled(MonitorReport& report) const {
  if (handler_ && !handledWatch_.uncertifiedPart().empty() && report.verdict == Verdict::certified)
    report.verdict = Verdict::notCertified;
}

void RunWatch::nameElements(MonitorReport& report) const {
  if (report.bracket) {
    report.bracket->controlling = handler_->toParentElement(report.bracket->controlling);
    if (report.bracket->lowestRing < 0)
      report.bracket->lowestRingElement = handler_->toParentElement(report.bracket->lowestRingElement);
  }
  for (MonitorEvent& event : report.newEvents)
    if (event.element) event.element = handler_->toParentElement(*event.element);
}

}  // namespace ringwatch
