#include <ringwatch/app/run/run_result.h>

#include <algorithm>
#include <new>

#include <fmt/format.h>

namespace ringwatch {

ExitReason reasonToStop(const MonitorReport& report) {
  return report.bracket ? ExitReason::violated : ExitReason::nonFinite;
}

std::string textOfStop(const MonitorReport& report) {
  return report.bracket ? fmt::format("stopped before step {}, which is violated", report.step)
                        : fmt::format("stopped before step {}: the tangent is not finite", report.step);
}

std::string faultText(const std::exception& fault) {
  return dynamic_cast<const std::bad_alloc*>(&fault) ? "out of memory; use a smaller mesh or more memory"
                                                     : fault.what();
}

bool RunResult::happened(EventKind kind) const {
  return std::ranges::any_of(events, [&](const RunEvent& told) { return told.event.kind == kind; });
}

ExitStatus RunResult::exitStatus() const {
  const bool ended = reason == ExitReason::end || reason == ExitReason::interrupted;
  if (!ended || violatedStepTaken || runaway || energyOff()) return ExitStatus::unstable;
  if (requireCertified && !certified()) return ExitStatus::unstable;
  if (reason == ExitReason::interrupted) return ExitStatus::interrupted;
  return neverCertified() ? ExitStatus::notCertified : ExitStatus::done;
}

std::string_view RunResult::verdict() const {
  if (reason == ExitReason::nonFinite || reason == ExitReason::stepFailed || runaway || energyOff()) return "unstable";
  if (violatedStepTaken || reason == ExitReason::violated) return "violated";
  // The state that it ended in has no step that could be certified.
  if (worst == Verdict::certified && reason == ExitReason::stepCollapsed) return verdictName(Verdict::notCertified);
  return worst ? verdictName(*worst) : "unmonitored";
}

}  // namespace ringwatch
