#pragma once
#include <algorithm>
#include <functional>
#include <string>

#include <ringwatch/app/scene/scene.h>
#include <ringwatch/monitor/stability_monitor.h>

namespace ringwatch {

/// Chooses the steps of a run: the one that the scene fixes, or what the monitor proves.
class StepPolicy {
 public:
  /// The scene must outlive this.
  explicit StepPolicy(const Scene& scene) : scene_(scene), h_(scene.step.value_or(0)) {}

  /// s; 0 while none is chosen.
  double step() const { return h_; }
  std::optional<double> asked() const { return h_ > 0 ? std::optional(h_) : std::nullopt; }
  /// "auto" begins with that step (s), for which a handler chooses its elements, and does not pass it: the step is
  /// shortened where the elements that are left explicit need it, and grows again when they allow clearly more.
  void beginWith(double wanted) { wanted_ = first_ = h_ = wanted; }
  /// Sets the step to take at `time` by what a report says of the state, for "auto", "reduce-step" and "repeat".
  /// prove: gives the report a bracket of the state, from scratch. Returns why there is no step, "" where there is one.
  /// Throws InputError where "auto" begins with a step that is out of all proportion to the end.
  std::string choose(MonitorReport& report, double time, const std::function<void(MonitorReport&)>& prove);
  /// Gives a report of the state the chosen step: its verdict, and no alarm at a longer one that was not taken.
  void judge(MonitorReport& report) const;
  /// The step was shortened to end with the run.
  bool endsTheRun() const { return endsTheRun_; }
  /// What resume() needs. A run that goes back keeps its first step.
  nlohmann::ordered_json save() const { return {{"h", h_}, {"first", first_}, {"short_until", shortUntil_}}; }
  void resume(const nlohmann::ordered_json& saved) {
    h_ = saved.at("h").get<double>();
    first_ = std::max(first_, saved.at("first").get<double>());
    shortUntil_ = saved.at("short_until").get<double>();
  }
  /// Why steps of h seconds lead nowhere, beside the first one; "" where they do not.
  std::string faultOf(double h) const;
  /// Takes steps of h seconds from here on, and none that is longer before the time `until` (s).
  void take(double h, double until) {
    h_ = h;
    shortUntil_ = until;
  }
  /// Takes half the step; false where it would collapse.
  bool halve();

 private:
  /// The largest step (s) that a report allows; empty where it does not tell one of its state.
  std::optional<double> safeOf(const MonitorReport& report) const;
  /// The step (s), or a clearly longer one, of at most `most`, that a report allows.
  double lengthened(const MonitorReport& report, double most) const;

  const Scene& scene_;
  double h_, first_ = 0;
  double shortUntil_ = 0;         // s
  std::optional<double> wanted_;  // s, of "auto" with a handler
  bool endsTheRun_ = false;
};

}  // namespace ringwatch
