#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <ringwatch/app/run/handled_watch.h>
#include <ringwatch/app/run/run_result.h>
#include <ringwatch/app/scene/scene.h>
#include <ringwatch/integrators/integrator.h>

namespace ringwatch {

/// What a run knows of the stability of its states: a monitor watches the elements that are explicit, the handler
/// those that it handles. Reports name elements of the body. Adds its times and notes to the result of the run.
class RunWatch {
 public:
  /// All of them must outlive the watch; a cut may replace the body's contents between end() and begin().
  RunWatch(const Scene& scene, const Body& body, StepRule rule, RunResult& result);

  /// Watches the body as it is from here on, or what a handler (nullptr: none) leaves explicit of it. everyState: the
  /// states come one by one; else they come at least where the scene wants the monitor.
  void begin(Handler* handler, bool everyState);
  /// Nothing is watched until the next begin(); the ends of events are known now.
  void end();

  /// Whether steps get a verdict: not without the scene's wish, nor when every element is handled and the handler does
  /// not prove its steps either.
  bool monitors() const { return monitor_ || handlerProves_; }
  /// Whether observe() fills in an evaluation of the whole body in its own pass.
  bool sharesPass() const { return monitor_ && (!handler_ || &handler_->explicitBody() == &body_); }
  /// Observes the state before step k of h seconds (empty while none is chosen). evaluation: as of
  /// StabilityMonitor::observe; nullptr unless sharesPass(). meanwhile: as of it, too.
  MonitorReport observe(std::int64_t k, const State& state, std::optional<double> h, StepEvaluation* evaluation,
                        const std::function<void()>& meanwhile);
  /// Whether the state that was observed last is finite, of all parts of a body.
  bool isFinite(const State& state) const;
  /// Makes the next observation one of the very state, where every state is seen.
  void evaluateNext() {
    if (monitor_) monitor_->evaluateNext();
  }
  /// Adds to the report what the energies of the state (empty: not known) and the handled elements say.
  void complete(MonitorReport& report, const State& state, const std::optional<Energies>& energies);
  /// A step is certified only with the handled parts that need a proof of their own.
  void checkHandled(MonitorReport& report) const;
  /// After end() and begin() at a checkpoint, at step k: events that go on are told once. One that does not come again
  /// in as many observations as end an event has ended here.
  void goOnWithEvents(std::int64_t k);
  /// What resume() needs; call it after end().
  nlohmann::ordered_json save() const { return {{"fresh_reports", freshReports_}}; }
  /// Goes on from what save() gave; call it before begin().
  void resume(const nlohmann::ordered_json& saved) {
    freshReports_ = saved.at("fresh_reports").get<std::int64_t>();
    monitored_ = true;
  }
  /// All that is known, of the monitor too, of a run without handler whose every state is seen. Loading needs begin()
  /// of the same body before it.
  template <class Archive>
  void archive(Archive& a) {
    a(monitored_, freshReports_, goingOn_, checkpointStep_, sinceCheckpoint_);
    std::string monitor;
    if constexpr (!Archive::loads)
      if (monitor_) monitor = monitor_->save();
    a(monitor);
    if constexpr (Archive::loads)
      if (monitor_) monitor_->load(monitor);
  }
  /// Reports that were made of the very state, so far.
  std::int64_t freshReports() const { return freshReports_; }

 private:
  /// Whether the monitor sees the state before step k: not between its observations, where a run does not show every
  /// state.
  bool sees(std::int64_t k) const { return everyState_ || k % scene_.every == 0; }
  void dropContinued(MonitorReport& report);
  void watchHandled(MonitorReport& report, const State& state);
  void beginWithNothingExplicit();
  void nameElements(MonitorReport& report) const;

  const Scene& scene_;
  const Body& body_;
  StepRule rule_;
  RunResult& result_;
  Handler* handler_ = nullptr;
  bool everyState_ = true;
  bool monitored_ = false;  // a monitor has been made
  std::optional<StabilityMonitor> monitor_;
  bool handlerProves_ = false;  // every element is handled, and proven by the handler
  HandledWatch handledWatch_;
  MonitorReport lastReport_;  // where not every state is seen: of the last one that was
  std::int64_t freshReports_ = 0;
  /// An event from before a checkpoint that has not ended.
  struct GoingOn {
    std::size_t event = 0;                     // of the result
    std::optional<std::int64_t> comesAt = {};  // the step at which the monitor of now has told it again
  };
  std::vector<GoingOn> goingOn_;
  std::int64_t checkpointStep_ = 0;
  int sinceCheckpoint_ = 0;  // observations
};

}  // namespace ringwatch
