#include <ringwatch/app/run/runner.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include <ringwatch/app/command/integrator_catalog.h>
#include <ringwatch/app/command/progress.h>
#include <ringwatch/app/output/report.h>
#include <ringwatch/app/run/checkpoint.h>
#include <ringwatch/app/run/run_energies.h>
#include <ringwatch/app/run/run_output.h>
#include <ringwatch/app/run/run_recorder.h>
#include <ringwatch/app/run/run_scheme.h>
#include <ringwatch/app/run/run_watch.h>
#include <ringwatch/app/run/saved_result.h>
#include <ringwatch/app/run/step_policy.h>
#include <ringwatch/app/run/stopwatch.h>
#include <ringwatch/app/run/timed_loads.h>
#include <ringwatch/app/scene/scene_state.h>
#include <ringwatch/base/atomic_file.h>
#include <ringwatch/base/error.h>

namespace ringwatch {
namespace {

/// A run in progress.
class Run {
 public:
  Run(const Scene& scene, Body& body, const RunOptions& options)
      : scene_(scene),
        body_(body),
        options_(options),
        rule_(stepRule(*integratorCatalog().find(scene.method), scene.damping)),
        energies_(scene, body),
        steps_(scene),
        loads_(scene, body),
        progress_(options.progress),
        recorder_(scene, result_),
        watch_(scene, body, rule_, result_) {
    result_.notes = options.notes;
    result_.requireCertified = scene_.requireCertified;
    for (const Scene::Cut& cut : scene_.cuts)
      for (const MeshBlock& block : body_.mesh().blocks)
        if (block.type != elementTypeOf<Tet4>)
          throw InputError(fmt::format("{}: only tetrahedra of four nodes can be cut; the mesh has {}", cut.origin,
                                       elementInfo(block.type).name));
    recorder_.follow(body_.mesh());
    scheme_ = std::make_unique<RunScheme>(scene_, body_, result_);
    beginWatch();
  }

  RunResult go() {
    {
      const Stopwatch total(result_.wallTime);
      {
        const Stopwatch output(result_.outputTime);
        output_.emplace(scene_, body_, rule_, options_.folder);
      }
      if (options_.resume) {
        resume(*options_.resume);
        goOnFromCheckpoint();
      } else {
        state_ = sceneInitialState(scene_, scheme_->system());
        loads_.begin(state_.x);
      }
      advance();
      progress_.clear();
      finish();
    }
    result_.files.emplace_back("summary.json");
    nlohmann::ordered_json summary = summaryJson(scene_, body_, result_);
    summary["provenance"] = options_.provenance;
    writeFileAtomically(options_.folder / "summary.json", summary.dump(2) + "\n");
    std::error_code ignored;
    if (result_.reason == ExitReason::end) std::filesystem::remove(options_.folder / checkpointFile, ignored);
    return std::move(result_);
  }

 private:
  /// Steps until something ends the run.
  void advance() {
    for (std::int64_t k = result_.steps;; k = result_.steps) {
      if (loads_.any()) energies_.addExternalWork(loads_.setForces(state_.time, state_.x));
      // A rounding error in the sum of the steps must not add one.
      if (steps_.step() > 0 && state_.time >= scene_.end - 1e-3 * steps_.step())
        return end(ExitReason::end, "end time reached");
      if (options_.interrupt && options_.interrupt->load())
        return end(ExitReason::interrupted, fmt::format("interrupted before step {}", k));
      while (const Scene::Cut* due = cutDue()) cut(*due);
      if (checkpointDue()) checkpoint();

      const bool rowDue = k % scene_.historyEvery == 0;
      MonitorReport report = handleMore(observe(k, rowDue), rowDue);
      if (!isFinite(state_, body_.threads())) {
        recorder_.recordEvents(report, body_.mesh());
        return end(ExitReason::nonFinite, fmt::format("positions or velocities are not finite after step {}", k));
      }
      if (!chooseStep(report)) return recorder_.recordEvents(report, body_.mesh());
      if (loads_.any() && k == 0) energies_.setScale(loads_.energyScale(steps_.step()));
      energies_.check(k, state_.time);
      record(report, rowDue);
      if (report.verdict == Verdict::violated && watch_.monitors() &&
          (scene_.onViolation == OnViolation::stop || scene_.onViolation == OnViolation::handle))
        return end(ExitReason::violated, fmt::format("stopped before step {}, which is violated", k));
      if (!takeStep(report)) return;
      showProgress(report);
    }
  }

  bool checkpointDue() const {
    return scene_.checkpointInterval && result_.steps > 0 && isFinite(state_, body_.threads()) &&
           state_.time >= static_cast<double>(checkpointsDue_ + 1) * *scene_.checkpointInterval - 1e-3 * steps_.step();
  }

  /// Writes what a resumed run goes on from, and goes on from there itself: monitor and energy balance begin again.
  void checkpoint() {
    scheme_->stepper().complete(state_);
    recordEnergies();
    energies_.beginBody();
    watch_.end();
    const double interval = *scene_.checkpointInterval, reached = state_.time + 1e-3 * steps_.step();
    // However many lie within a step.
    checkpointsDue_ = std::max(checkpointsDue_ + 1, static_cast<std::int64_t>(reached / interval));
    {
      const Stopwatch output(result_.outputTime);
      Checkpoint saved;
      saved.sceneFile = scene_.file;
      if (!scene_.meshFile.empty()) saved.meshFile = std::filesystem::absolute(scene_.meshFile);
      saved.scene = scene_.echo;
      saved.mesh = hashOf(body_.mesh());
      saved.state.time = state_.time;
      saved.state.x = state_.x;
      saved.state.v = state_.v;
      saved.parts = {{"result", savedResult(result_)},
                     {"energies", energies_.save()},
                     {"steps", steps_.save()},
                     {"watch", watch_.save()},
                     {"output", output_->save()},
                     {"checkpoints_due", checkpointsDue_},
                     {"last_verdict", static_cast<int>(lastVerdict_)}};
      writeCheckpoint(options_.folder, saved);
    }
    beginWatch();
    loads_.begin(state_.x);
    goOnFromCheckpoint();
  }

  void resume(const Checkpoint& saved) {
    if (saved.mesh != hashOf(body_.mesh()) || saved.state.x.cols() != body_.nodeCount() ||
        saved.state.v.cols() != body_.nodeCount())
      throw InputError(
          fmt::format("{}: the mesh is another one than when the checkpoint was written; begin the run again",
                      scene_.meshFile.empty() ? scene_.file.string() : scene_.meshFile.string()));
    state_.time = saved.state.time;
    state_.x = saved.state.x;
    state_.v = saved.state.v;
    watch_.end();
    resumeResult(saved.parts.at("result"), result_);
    energies_.resume(saved.parts.at("energies"));
    steps_.resume(saved.parts.at("steps"));
    watch_.resume(saved.parts.at("watch"));
    checkpointsDue_ = saved.parts.at("checkpoints_due").get<std::int64_t>();
    lastVerdict_ = static_cast<Verdict>(saved.parts.at("last_verdict").get<int>());
    beginWatch();
    loads_.begin(state_.x);
    loads_.setForces(state_.time, state_.x);
    output_->resume(saved.parts.at("output"), result_.steps);
  }

  /// What is done alike behind a checkpoint, by a run that goes on and by one that is resumed.
  void goOnFromCheckpoint() {
    state_.a.resize(3, 0);
    output_->certificates().forget();
    watch_.goOnWithEvents(result_.steps);
    recordEnergies();
  }

  /// Watches the body, or what its handler leaves explicit, from here on.
  void beginWatch() {
    Stepper& stepper = scheme_->stepper();
    watch_.begin(scheme_->handler(), stepper.metric(), stepper.mostSteps() == 1);
  }

  /// Lets the handler choose again, for the steps to come.
  void handleAgain() {
    watch_.end();  // it watches what the choice replaces
    scheme_->prepare(state_.x, steps_.step());
    state_.a.resize(3, 0);
    beginWatch();
  }

  /// Steps from number k on that may be taken before the state is observed.
  std::int64_t stepsToObservation(std::int64_t k) {
    std::int64_t count = scheme_->stepper().mostSteps();
    // The work of prescribed motion is done in every step.
    if (count == 1 || (scene_.energy && body_.constraints().moving())) return 1;
    const auto until = [k](std::int64_t every) { return every - k % every; };
    count = std::min(count, until(scene_.historyEvery));
    if (watch_.monitors()) count = std::min(count, until(scene_.every));
    const auto stepsTo = [this](double time) {
      return std::max<std::int64_t>(1,
                                    static_cast<std::int64_t>(std::ceil((time - state_.time) / steps_.step() - 1e-3)));
    };
    count = std::min(count, stepsTo(scene_.end));
    if (!scene_.step && state_.time + static_cast<double>(count) * steps_.step() > scene_.end * (1 + 1e-12))
      count = std::max<std::int64_t>(1, count - 1);  // the last step of "auto" is shortened to end at the end
    if (output_->nextFrame() < scene_.end) count = std::min(count, stepsTo(output_->nextFrame()));
    return count;
  }

  double kineticEnergy() const { return 0.5 * (state_.v.colwise().squaredNorm() * body_.lumpedMass()).value(); }

  const Scene::Cut* cutDue() const {
    const std::size_t next = result_.cuts.size() + cutsMissed_;
    if (next == scene_.cuts.size() || state_.time < scene_.cuts[next].time - 1e-3 * steps_.step()) return nullptr;
    return &scene_.cuts[next];
  }

  /// Cuts the body, carries the state over and builds again what depends on the mesh.
  void cut(const Scene::Cut& wanted) {
    CutRecord record;
    record.step = result_.steps;
    record.time = state_.time;
    const auto handled = [this] { return scheme_->handler() ? scheme_->treatedElements() : 0; };
    record.elementsBefore = static_cast<std::int64_t>(body_.mesh().elementCount());
    scheme_->stepper().complete(state_);
    recordEnergies();
    if (wanted.criticalStep) record.before = criticalStepHere();
    record.kineticBefore = kineticEnergy();
    record.handledBefore = handled();
    {
      const Stopwatch watch(record.cutTime);
      const CutMesh made =
          cutMesh(body_.mesh(), wanted.surface, wanted.atRest ? body_.mesh().X : state_.x, wanted.snap);
      if (made.facesOpened == 0) {
        ++cutsMissed_;
        result_.notes.push_back(fmt::format("{}: at t = {:.6g} s it opens nothing: no face of the mesh lies within it",
                                            wanted.origin, state_.time));
        return;
      }
      moveTo(made, record);
      record.elementsCut = static_cast<std::int64_t>(made.elementsCut);
      record.nodesAdded = static_cast<std::int64_t>(made.nodesAdded);
      record.facesOpened = static_cast<std::int64_t>(made.facesOpened);
      record.area = made.area;
      record.atMost = optimisticStep(highestReducedRing(body_, state_.x, made.changed), rule_);
    }
    // The energy balance of the new body starts here, however long it is to the next row.
    recordEnergies();
    record.cutTime -= record.selectionTime;
    record.elementsAfter = static_cast<std::int64_t>(body_.mesh().elementCount());
    if (wanted.criticalStep) record.after = criticalStepHere();
    record.kineticAfter = kineticEnergy();
    record.handledAfter = handled();
    result_.cuts.push_back(record);
  }

  /// State and body become those of a mesh that was cut.
  void moveTo(const CutMesh& made, CutRecord& record) {
    watch_.end();
    const std::unique_ptr<RunScheme> before = std::move(scheme_);  // holds what its handler has chosen
    state_.x = carriedOver(made, state_.x);
    state_.v = carriedOver(made, state_.v);
    state_.a.resize(3, 0);
    body_ = sceneBody(scene_, made.mesh, body_.threads(), MaterialsBy::mesh);
    recorder_.follow(body_.mesh());
    body_.constraints().imposeVelocity(state_.v);
    energies_.beginBody();
    {
      const Stopwatch selection(record.selectionTime);
      scheme_ = std::make_unique<RunScheme>(scene_, body_, result_, state_.x, steps_.step(), made, *before);
    }
    if (const Handler* handler = scheme_->handler()) record.selectionCost = handler->selectionCost();
    beginWatch();
  }

  /// The bracket of the whole body, from scratch; empty where the state has none.
  std::optional<CriticalStep> criticalStepHere() const {
    try {
      return criticalStep(body_, state_.x, rule_);
    } catch (const NumericalError&) {
      return std::nullopt;
    }
  }

  /// For "handle": more elements where the explicit part is no longer certified, and another report of what is left.
  MonitorReport handleMore(MonitorReport report, bool rowDue) {
    if (!scheme_->handler() || !watch_.monitors() || scene_.onViolation != OnViolation::handle || !report.fresh ||
        report.verdict == Verdict::certified || !(steps_.step() > 0) || !state_.x.allFinite())
      return report;
    {
      const Stopwatch watch(result_.monitorTime);
      handleAgain();
    }
    MonitorReport more = observe(report.step, rowDue);
    // Those of the explicit elements are of a choice that no step was taken with.
    for (const MonitorEvent& event : report.newEvents)
      if (event.handled) more.newEvents.push_back(event);
    return more;
  }

  void end(ExitReason reason, std::string text) {
    result_.reason = reason;
    result_.reasonText = std::move(text);
  }

  /// Observes the state before step k: one pass over the elements serves the scheme, the energy balance and, where it
  /// watches the whole body, the monitor.
  MonitorReport observe(std::int64_t k, bool rowDue) {
    const bool shared = watch_.sharesPass();
    askFor(rowDue);
    if (!shared) evaluate();
    // With "auto" the first step is chosen from the first bracket.
    MonitorReport report = watch_.observe(k, state_, steps_.asked(), shared ? &evaluation_ : nullptr);
    takeEvaluation(rowDue);
    watch_.complete(report, state_, energies_.checked());
    return report;
  }
  /// The energies of the state, in a pass of their own.
  void recordEnergies() {
    askFor(true);
    evaluate();
    takeEvaluation(true);
  }
  /// What the pass over the elements of the whole body is to give at this state.
  void askFor(bool rowDue) {
    stepperNeedsForce_ = scheme_->stepper().needsForce(state_);
    evaluation_.wantsForce = stepperNeedsForce_ || energies_.needsForce(rowDue);
    evaluation_.wantsEnergy = scene_.energy && rowDue;
  }
  void evaluate() {
    if (!evaluation_.wantsForce && !evaluation_.wantsEnergy) return;
    const Stopwatch force(result_.forceTime);
    body_.evaluate(state_.x, evaluation_, workspace_);
  }
  void takeEvaluation(bool rowDue) {
    const Stopwatch force(result_.forceTime);
    if (stepperNeedsForce_) scheme_->stepper().takeForce(state_, evaluation_);
    energies_.record(state_, evaluation_, scheme_->system(), rowDue);
  }

  /// Chooses the step from a state. False when none can be had.
  bool chooseStep(MonitorReport& report) {
    const std::string fault = steps_.choose(report, state_.time, [this](MonitorReport& fresh) {
      const Stopwatch watch(result_.monitorTime);
      fresh.bracket = criticalStepHere();
      fresh.fresh = true;
      fresh.elementsRefreshed = static_cast<std::int64_t>(body_.mesh().elementCount());
    });
    if (!fault.empty()) {
      end(ExitReason::stepCollapsed, fault);
      return false;
    }
    if (steps_.endsTheRun()) output_->leaveOut(report.step);
    report.h = steps_.step();
    // A step that was shortened in time was not taken: the monitor's alarm at the longer one is no event of the run.
    if (report.bracket) report.verdict = verdictFor(report.h, *report.bracket);
    watch_.checkHandled(report);
    if (report.verdict != Verdict::violated)
      std::erase_if(report.newEvents, [](const MonitorEvent& event) { return event.kind == EventKind::violated; });
    return true;
  }

  void record(const MonitorReport& report, bool rowDue) {
    const Stopwatch output(result_.outputTime);
    output_->open();
    recorder_.record(report, body_.mesh());
    output_->certificates().record(report, state_, result_.worst == Verdict::violated);
    if (rowDue) {
      HistoryRow row;
      row.step = report.step;
      row.time = state_.time;
      row.h = report.h;
      row.bracket = report.bracket;
      row.energies = energies_.last();
      row.elementsRefreshed = watch_.monitors() && report.fresh ? report.elementsRefreshed : 0;
      row.handledElements = scheme_->treatedElements();
      row.metricStep = report.metricStep;
      if (watch_.monitors()) row.verdict = report.verdict;
      output_->writeRow(row);
    }
    if (output_->frameDue(state_.time, report.h)) output_->writeFrame(report.step, state_, frameOf(report));
  }

  FrameState frameOf(const MonitorReport& report) {
    FrameState frame;
    frame.time = state_.time;
    frame.h = steps_.step();
    if (watch_.monitors()) {
      frame.verdict = report.verdict;
      if (scene_.proves()) {
        frame.safe = report.bracket ? report.bracket->safe : report.certified;
        if (report.bracket) frame.optimistic = report.bracket->optimistic;
      }
    }
    if (const Handler* handler = scheme_->handler()) frame.handled = handler->elements();
    return frame;
  }

  bool takeStep(const MonitorReport& report) {
    const Stopwatch force(result_.forceTime);
    if (loads_.any()) energies_.addExternalWork(loads_.setVelocities(state_, steps_.step()));
    const auto take = [this](std::int64_t count) {
      const double lambda = watch_.monitors() && scene_.proves() ? rule_.lambdaFor(steps_.step()) : 0;
      return scheme_->stepper().step(state_, steps_.step(), count, lambda);
    };
    Stepper::Taken taken = take(stepsToObservation(result_.steps));
    while (taken.steps == 0 && scheme_->handler() && scene_.reduceOnFailure && steps_.halve()) {
      result_.notes.push_back(
          fmt::format("step {}: {}; the step is halved to {:.6g} s", report.step, taken.fault, steps_.step()));
      handleAgain();
      taken = take(1);
    }
    if (taken.steps == 0) {
      end(ExitReason::stepFailed, fmt::format("step {} failed: {}", report.step, taken.fault));
      return false;
    }
    recorder_.countSteps(taken.steps, steps_.step());
    if (watch_.monitors()) recorder_.countVerdict(report, taken.steps, watch_.freshReports() <= 1);
    lastVerdict_ = report.verdict;
    return true;
  }

  void showProgress(const MonitorReport& report) {
    if (!progress_.due()) return;
    progress_.show(fmt::format("step {} of about {:.0f}, t = {:.4g} of {:.4g} s, h = {:.4g} s{}{}", report.step,
                               static_cast<double>(report.step) + (scene_.end - state_.time) / steps_.step(),
                               state_.time, scene_.end, steps_.step(),
                               report.bracket ? fmt::format(", safe {:.4g} s", report.bracket->safe) : "",
                               watch_.monitors() ? fmt::format(", {}", verdictName(report.verdict)) : ""),
                   state_.time / scene_.end);
  }

  void finish() {
    scheme_->stepper().complete(state_);
    result_.time = state_.time;
    if (result_.reason == ExitReason::end && !isFinite(state_, body_.threads()))
      end(ExitReason::nonFinite, fmt::format("positions or velocities are not finite after step {}", result_.steps));
    const FrameState last = frameOf(lastReport());
    watch_.end();
    if (result_.reason == ExitReason::interrupted && scene_.checkpointInterval)
      result_.notes.push_back(
          checkpointsDue_ > 0
              ? fmt::format("ringwatch run --resume {} goes on from its last checkpoint", options_.folder.string())
              : "there was no checkpoint yet to go on from");
    recorder_.noteWhatIsNotCertified(body_.mesh());
    if (const Handler* handler = scheme_->handler())
      result_.handler->figures = scheme_->stepper().figures(handler->figures());
    if (std::string note = scheme_->stepper().note(); !note.empty()) result_.notes.push_back(std::move(note));
    result_.runaway = energies_.runaway();
    const Stopwatch output(result_.outputTime);
    output_->finish(result_, state_, last);
  }

  /// Nothing is known of the last state but what was known of the step that led to it.
  MonitorReport lastReport() const {
    MonitorReport report;
    report.verdict = lastVerdict_;
    report.certified = std::numeric_limits<double>::quiet_NaN();
    return report;
  }

  const Scene& scene_;
  Body& body_;
  const RunOptions& options_;
  StepRule rule_;
  RunEnergies energies_;
  StepPolicy steps_;
  TimedLoads loads_;
  ProgressLine progress_;
  RunResult result_;
  RunRecorder recorder_;
  RunWatch watch_;
  std::unique_ptr<RunScheme> scheme_;
  std::optional<RunOutput> output_;
  State state_;
  StepEvaluation evaluation_;
  Body::Workspace workspace_;
  bool stepperNeedsForce_ = false;
  std::size_t cutsMissed_ = 0;
  std::int64_t checkpointsDue_ = 0;  // whole intervals that the last one ended
  Verdict lastVerdict_ = Verdict::notCertified;
};

}  // namespace

RunResult runScene(const Scene& scene, Body& body, const RunOptions& options) { return Run(scene, body, options).go(); }

}  // namespace ringwatch
