#include <ringwatch/app/run/run_repeats.h>

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include <ringwatch/app/output/report.h>
#include <ringwatch/app/run/checkpoint.h>
#include <ringwatch/base/archive.h>

namespace ringwatch {

void RunRepeats::keep() {
  kept_.reset();
  if (run_.scene.onViolation != OnViolation::repeat || run_.result.steps % run_.scene.every != 0) return;
  SavingArchive archive;
  run_.archive(archive);
  kept_ = {run_.state,        run_.result,         archive.take(),
           run_.steps.save(), run_.output->save(), prescribedVelocities(run_.body.constraints()),
           run_.lastVerdict};
}

void RunRepeats::noteCertified(const MonitorReport& report) {
  if (!kept_ || !report.fresh || report.verdict != Verdict::certified) return;
  if (!certified_ || certified_->result.steps != kept_->result.steps) fromThere_ = 0;
  certified_ = std::exchange(kept_, std::nullopt);
}

bool RunRepeats::goBack(const MonitorReport& report) {
  if (run_.scene.onViolation != OnViolation::repeat || run_.result.reason != ExitReason::end) return false;
  const bool finite = isFinite(run_.state, run_.body.threads());
  if (finite && (!report.fresh || report.verdict == Verdict::certified)) {
    noteCertified(report);
    return false;
  }
  // Before the first step, or with the certified one itself, there is nothing to drop.
  if (!certified_ || certified_->result.steps == report.step) return false;
  const std::int64_t from = certified_->result.steps;
  const double next = smallerStep(report);
  if (const std::string fault = run_.steps.faultOf(next); !fault.empty()) {
    run_.end(ExitReason::stepCollapsed, fault);
    return false;
  }
  if (fromThere_ == run_.scene.repeats) {
    run_.end(
        ExitReason::stepCollapsed,
        fmt::format(
            "went back to step {}, t = {:.6g} s, as often as monitor.repeats = {} allows, and with h = {:.6g} s it "
            "is still not certified at step {}",
            from, certified_->state.time, fromThere_, run_.steps.step(), report.step));
    return false;
  }
  ++fromThere_;
  MonitorEvent event{.kind = EventKind::repeated,
                     .step = from,
                     .time = certified_->state.time,
                     .value = next,
                     .h = run_.steps.step(),
                     .end = report.step};
  const RunResult::Repeats before = *run_.result.repeats;
  const double failed = run_.state.time;
  restore(*certified_);
  run_.steps.take(event.value, failed);
  run_.result.repeats = {before.count + 1, before.droppedSteps + report.step - from};
  run_.result.events.push_back({event, nullptr, eventText(event, run_.body.mesh())});
  return true;
}

bool RunRepeats::goBackFromEnd() {
  if (run_.scene.onViolation != OnViolation::repeat || !certified_ || certified_->result.steps == run_.result.steps)
    return false;
  run_.watch.evaluateNext();
  const MonitorReport report = run_.observe(run_.result.steps, false);
  if (goBack(report)) return true;
  run_.recordEvents(report);
  return false;
}

bool RunRepeats::returnToCertified() {
  if (!certified_ || certified_->result.steps == run_.result.steps) return false;
  restore(*certified_);
  return true;
}

/// The safe one where that state has a bracket, and it is smaller; not less than half, since a state that went unstable
/// says little of the one that it came from.
double RunRepeats::smallerStep(const MonitorReport& report) const {
  const double step = run_.steps.step(), half = 0.5 * step;
  const double safe = report.bracket && report.fresh ? run_.scene.safety * report.bracket->safe : half;
  return safe < step ? std::max(half, safe) : half;
}

void RunRepeats::restore(const Kept& kept) {
  const RunResult now = std::exchange(run_.result, kept.result);
  // What was computed in vain has taken its time.
  run_.result.forceTime = now.forceTime;
  run_.result.monitorTime = now.monitorTime;
  run_.result.outputTime = now.outputTime;
  run_.result.wallTime = now.wallTime;
  run_.state = kept.state;
  run_.steps.resume(kept.steps);
  run_.lastVerdict = kept.lastVerdict;
  resumeMotion(run_.body.constraints(), kept.moved);
  // The forces of that time: the next change of forces is counted from them.
  run_.loads.setForces(run_.state.time, run_.state.x, run_.energies.balance());
  LoadingArchive archive(kept.memory);
  run_.archive(archive);
  archive.end();
  run_.output->goBack(kept.output, run_.result.steps);
}

}  // namespace ringwatch
