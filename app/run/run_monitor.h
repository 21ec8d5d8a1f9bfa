#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <ringwatch/integrators/integrator.h>
#include <ringwatch/monitor/stability_monitor.h>

namespace ringwatch {

/// What watches the explicit elements of a run: a StabilityMonitor, or what stands for it where the body is a part of a
/// larger one (body/domain.h).
class RunMonitor {
 public:
  virtual ~RunMonitor() = default;
  /// As of StabilityMonitor. meanwhile: may be called once the force is evaluated, while other processes are waited
  /// for.
  virtual const MonitorReport& observe(std::int64_t step, const State& state, std::optional<double> h,
                                       StepEvaluation* evaluation, const std::function<void()>& meanwhile) = 0;
  virtual const MonitorReport& observeEnergies(const Energies& energies) = 0;
  virtual const std::vector<MonitorEvent>& events() const = 0;
  /// Whether the state that was observed last is finite; empty where it does not tell.
  virtual std::optional<bool> finite() const { return std::nullopt; }
  /// Evaluates the state that was observed last from scratch, for steps of h; nullptr where it leaves that to others.
  virtual const MonitorReport* prove(const State& /*state*/, double /*h*/) { return nullptr; }
  /// As of StabilityMonitor, which a run on a part of a body does without.
  virtual void evaluateNext() {}
  virtual std::string save() { return {}; }
  virtual void load(const std::string&) {}
};

}  // namespace ringwatch
