#pragma once
#include <cstdint>
#include <functional>
#include <optional>

#include <nlohmann/json.hpp>

#include <ringwatch/integrators/integrator.h>
#include <ringwatch/monitor/stability_monitor.h>

namespace ringwatch {

/// A run in progress, before a step.
struct RunMoment {
  std::int64_t step = 0;
  double time = 0, end = 0;                               // s
  double h = 0;                                           // s, the step to be taken
  const std::optional<CriticalStep>& bracket;             // at the last observation
  std::optional<Verdict> verdict;                         // empty without a monitor
  std::int64_t handled = 0;                               // elements
  const State& state;                                     // velocities may lag (State::lag)
  double forceTime = 0, monitorTime = 0, outputTime = 0;  // s of wall time so far
  /// summary.json as it would be now; all rows of history.csv are in the file then.
  const std::function<nlohmann::ordered_json()>& summary;
};

/// Told of a run before each of its steps.
class RunListener {
 public:
  virtual ~RunListener() = default;
  virtual void observe(const RunMoment& moment) = 0;
};

}  // namespace ringwatch
