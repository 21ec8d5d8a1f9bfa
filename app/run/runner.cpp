#include <ringwatch/app/run/run_summary.h>
#include <ringwatch/app/run/runner.h>

#include <chrono>
#include <functional>

#include <fmt/format.h>

#include <ringwatch/app/output/progress.h>
#include <ringwatch/app/output/report.h>
#include <ringwatch/app/run/checkpoint.h>
#include <ringwatch/app/run/run_checkpoints.h>
#include <ringwatch/app/run/run_cuts.h>
#include <ringwatch/app/run/run_erosion.h>
#include <ringwatch/app/run/run_forecast.h>
#include <ringwatch/app/run/run_listener.h>
#include <ringwatch/app/run/run_repeats.h>
#include <ringwatch/app/run/simulation.h>
#include <ringwatch/app/run/stopwatch.h>
#include <ringwatch/app/scene/saved_json.h>
#include <ringwatch/app/scene/scene_state.h>
#include <ringwatch/base/atomic_file.h>
#include <ringwatch/base/error.h>
#include <ringwatch/body/domain.h>

namespace ringwatch {
namespace {

class Runner {
 public:
  Runner(const Scene& scene, Body& body, const RunOptions& options)
      : run_(scene, body, options),
        cuts_(run_),
        erosion_(run_),
        checkpoints_(run_),
        repeats_(run_),
        progress_(options.progress) {}

  RunResult go() {
    orFail([this] {
      begin();
      step();
    });
    progress_.clear();
    if (run_.result.reason == ExitReason::interrupted)
      if (std::string note = checkpoints_.howToGoOn(); !note.empty()) run_.result.notes.push_back(std::move(note));
    orFail([this] { run_.finish(); });
    // Of a fault of one of several processes; the events are known to the first one alone.
    if (!run_.named()) {
      if (run_.result.reason != ExitReason::failed || std::filesystem::exists(run_.options.folder / "summary.json"))
        return std::move(run_.result);
      run_.result.notes.emplace_back("the events are left out: the first rank alone knew of them");
    }
    run_.result.files.emplace_back("summary.json");
    const std::filesystem::path file = run_.options.folder / "summary.json";
    try {
      writeFileAtomically(file, jsonText(labelledJson(summary())));
    } catch (const std::exception& fault) {
      const std::string text = dynamic_cast<const InputError*>(&fault)
                                   ? fault.what()
                                   : fmt::format("cannot write {}: {}", file.string(), faultText(fault));
      throw RunFailed(run_.result.reason == ExitReason::failed ? run_.result.reasonText + "; " + text : text);
    }
    std::error_code ignored;
    if (!run_.result.canGoOn()) std::filesystem::remove(run_.options.folder / checkpointFile, ignored);
    return std::move(run_.result);
  }

 private:
  /// An error ends a run that has begun as any other reason does; before that it is the caller's.
  template <class Work>
  void orFail(const Work& work) {
    try {
      work();
    } catch (const std::exception& fault) {
      if (!run_.output || (!run_.output->isOpen() && (!stepping_ || !dynamic_cast<const NumericalError*>(&fault))))
        throw;
      if (run_.result.reason != ExitReason::failed)
        run_.end(ExitReason::failed, fmt::format("{}step {}: {}", run_.options.part ? run_.options.part->process : "",
                                                 run_.result.steps, faultText(fault)));
    }
  }

  void begin() {
    {
      const Stopwatch output(run_.result.outputTime);
      run_.body.domain().together(
          [this] { run_.output.emplace(run_.scene, run_.body, run_.rule, run_.options.folder, run_.options.part); });
      run_.output->probesBegin(run_.probes.heading());
    }
    if (run_.options.resume) return checkpoints_.resume(*run_.options.resume);
    run_.state = run_.options.part ? run_.options.part->begin : sceneInitialState(run_.scene, run_.scheme->system());
    run_.loads.begin(run_.state.x);
  }

  /// Steps until something ends the run.
  void step() {
    stepping_ = true;
    stepsAtStart_ = run_.result.steps;
    for (std::int64_t k = run_.result.steps;; k = run_.result.steps) {
      run_.setLoads();
      // A rounding error in the sum of the steps must not add one.
      if (run_.steps.step() > 0 && run_.state.time >= run_.scene.end - 1e-3 * run_.steps.step()) {
        if (repeats_.goBackFromEnd()) continue;
        if (run_.result.reason == ExitReason::end) run_.end(ExitReason::end, "end time reached");
        return;
      }
      if (run_.options.interrupt && run_.options.interrupt->load()) {
        repeats_.returnToCertified();
        checkpoints_.writeAsItIs();
        return run_.end(ExitReason::interrupted, fmt::format("interrupted before step {}", run_.result.steps));
      }
      if (run_.options.checkpoint && run_.options.checkpoint->exchange(false)) {
        const bool wentBack = repeats_.returnToCertified();
        checkpoints_.writeAsItIs();
        if (run_.named()) progress_.tell(checkpoints_.whatCame(), !checkpoints_.isOfNow());
        if (wentBack) continue;
      }
      cuts_.makeThoseDue();
      if (!erosion_.makeDue(k)) return;
      if (checkpoints_.due()) checkpoints_.write();

      repeats_.keep();
      const bool rowDue = k % run_.scene.historyEvery == 0;
      MonitorReport report = run_.observe(k, rowDue);
      if (repeats_.goBack(report)) continue;
      if (!run_.acceptState(report)) return run_.recordEvents(report);
      const bool goesOn = run_.chooseStep(report);
      run_.checkEnergies(k);
      if (!goesOn) return run_.recordEvents(report);
      // One that was shortened before the first step is certified now.
      repeats_.noteCertified(report);
      run_.record(report, rowDue);
      tellListener(report);
      if (run_.stopsAt(report)) return run_.end(reasonToStop(report), textOfStop(report));
      if (!run_.takeStep(report)) return;
      forecast(report);
      showProgress(report);
    }
  }

  nlohmann::ordered_json summary() {
    run_.total.lap();
    const Body& body = run_.named() ? *run_.named() : run_.body;
    nlohmann::ordered_json json = summaryJson(run_.scene, body, run_.result);
    json["provenance"] = run_.options.provenance;
    if (run_.options.provenance.is_object())
      json["provenance"]["mesh_hash"] = fmt::format("{:016x}", hashOf(body.mesh()));
    if (!run_.named())
      for (const char* key : {"mesh", "mass", "body", "materials", "provenance"})
        json[key] = run_.options.part->ofWhole[key];
    return json;
  }

  void tellListener(const MonitorReport& report) {
    if (!run_.options.listener) return;
    const std::function<nlohmann::ordered_json()> soFar = [this] {
      run_.output->flush();
      run_.result.time = run_.state.time;
      return summary();
    };
    run_.options.listener->observe({report.step, run_.state.time, run_.scene.end, report.h, report.bracket,
                                    run_.watch.monitors() ? std::optional(report.verdict) : std::nullopt,
                                    run_.scheme->treatedElements(), run_.state, run_.result.forceTime,
                                    run_.result.monitorTime, run_.result.outputTime, soFar});
  }

  void forecast(const MonitorReport& report) {
    if (!run_.options.progress) return;
    const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    const std::string told = forecast_.observe(
        {elapsed, run_.result.steps - stepsAtStart_, run_.state.time, run_.scene.end, run_.steps.step()},
        [&]() -> std::string {
          if (!report.bracket) return run_.scene.proves() ? "" : "the monitor's metric";
          if (report.bracket->discreteShare > 0.5) return "a spring or contact, with its damping and friction,";
          return elementText(run_.named()->mesh(), report.bracket->controlling);
        });
    if (!told.empty()) progress_.tell(told, false);
  }

  void showProgress(const MonitorReport& report) {
    const bool onTerminal = progress_.due();
    if (!onTerminal && !logIsDue()) return;
    const double time = run_.state.time, end = run_.scene.end, h = run_.steps.step();
    const std::string text = fmt::format("step {} of about {:.0f}, t = {:.4g} of {:.4g} s, h = {:.4g} s{}{}, {} left",
                                         report.step, static_cast<double>(report.step) + (end - time) / h, time, end, h,
                                         report.bracket ? fmt::format(", safe {:.4g} s", report.bracket->safe) : "",
                                         run_.watch.monitors() ? fmt::format(", {}", verdictName(report.verdict)) : "",
                                         RunForecast::durationText(forecast_.left()));
    if (onTerminal)
      progress_.show(text, 0);
    else
      progress_.tell(text, false);
  }

  /// Launchers of several processes hand on standard error through a pipe, so that no terminal shows the progress.
  bool logIsDue() {
    const auto now = std::chrono::steady_clock::now();
    if (!run_.options.part || !run_.options.progress || now - logged_ < std::chrono::seconds(30)) return false;
    logged_ = now;
    return true;
  }

  Simulation run_;
  RunCuts cuts_;
  RunErosion erosion_;
  RunCheckpoints checkpoints_;
  RunRepeats repeats_;
  ProgressLine progress_;
  RunForecast forecast_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point logged_ = start_;
  std::int64_t stepsAtStart_ = 0;
  bool stepping_ = false;
};

}  // namespace

RunResult runScene(const Scene& scene, Body& body, const RunOptions& options) {
  requireCuttable(scene, body.mesh());
  return Runner(scene, body, options).go();
}

}  // namespace ringwatch
