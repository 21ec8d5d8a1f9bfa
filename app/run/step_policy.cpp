#include <ringwatch/app/run/step_policy.h>

#include <algorithm>

#include <fmt/format.h>

#include <ringwatch/base/error.h>

namespace ringwatch {

std::string StepPolicy::faultOf(double h) const {
  constexpr double collapse = 1e-6;  // of the first step: a run that needs less goes nowhere
  return h > collapse * first_ ? std::string() : fmt::format("no step can be certified: reduced to {:.3g} s", h);
}

std::string StepPolicy::choose(MonitorReport& report, double time, const std::function<void(MonitorReport&)>& prove) {
  const bool automatic = !scene_.step && !(scene_.holdsStep && h_ > 0),
             reduce = scene_.onViolation == OnViolation::reduceStep || scene_.onViolation == OnViolation::repeat;
  const bool tooLong = scene_.proves() ? report.verdict != Verdict::certified
                                       : report.metricStep.has_value() && !(h_ <= *report.metricStep);
  const double before = h_;
  if (wanted_) {
    const std::optional<double> safe = safeOf(report);
    h_ = safe && h_ > *safe ? std::min(*wanted_, scene_.safety * *safe) : lengthened(report, *wanted_);
  } else if (automatic ? (report.fresh || (reduce && tooLong)) : (reduce && tooLong)) {
    if (scene_.proves() && !report.fresh) prove(report);
    const double safe = safeOf(report).value_or(0);
    double next = scene_.safety * safe;
    if (!(next > 0)) next = 0.5 * h_;  // nothing can be certified: keep reducing
    if (!automatic) next = std::min(next, h_);
    // Evaluated at this state, the step is certified after all.
    if (report.bracket && !automatic && h_ <= safe) next = h_;
    h_ = std::min(next, scene_.end);
    if (first_ <= 0) first_ = h_;
  } else if (reduce && time >= shortUntil_) {
    h_ = lengthened(report, scene_.step.value_or(first_));
  }
  if (h_ != before)
    if (std::string fault = faultOf(h_); !fault.empty()) return fault;
  if (automatic && first_ == h_)
    if (const std::string fault = tooMany("steps", h_, scene_.end); !fault.empty())
      throw InputError(fmt::format("{}: integrator.end: \"auto\" begins with {}", scene_.file.string(), fault));
  endsTheRun_ = automatic && h_ > scene_.end - time;
  if (endsTheRun_) h_ = scene_.end - time;
  if (first_ <= 0) first_ = h_;
  return {};
}

void StepPolicy::judge(MonitorReport& report) const {
  report.h = h_;
  if (report.bracket) report.verdict = verdictFor(h_, *report.bracket);
  // A step that was shortened in time was not taken: the monitor's alarm at the longer one is no event of the run.
  if (report.verdict != Verdict::violated)
    std::erase_if(report.newEvents, [](const MonitorEvent& event) { return event.kind == EventKind::violated; });
}

std::optional<double> StepPolicy::safeOf(const MonitorReport& report) const {
  if (!scene_.proves()) return report.metricStep;
  if (!report.fresh || !report.bracket) return std::nullopt;
  return report.bracket->safe;
}

double StepPolicy::lengthened(const MonitorReport& report, double most) const {
  // A handler chooses its elements again at every other step, and a scheme keeps its energy best at one step.
  constexpr double clearlyMore = 1.2;
  const double next = std::min(most, scene_.safety * safeOf(report).value_or(0));
  return next > clearlyMore * h_ ? next : h_;
}

bool StepPolicy::halve() {
  if (!faultOf(0.5 * h_).empty()) return false;
  h_ *= 0.5;
  return true;
}

}  // namespace ringwatch
