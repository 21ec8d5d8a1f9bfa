#include <ringwatch/app/integrator_catalog.h>
#include <ringwatch/app/runner.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include <ringwatch/app/device_run.h>
#include <ringwatch/app/handled_watch.h>
#include <ringwatch/app/progress.h>
#include <ringwatch/app/report.h>
#include <ringwatch/app/run_energies.h>
#include <ringwatch/app/run_output.h>
#include <ringwatch/app/step_policy.h>
#include <ringwatch/base/atomic_file.h>
#include <ringwatch/base/error.h>
#include <ringwatch/integrators/body_system.h>
#include <ringwatch/integrators/split_body_system.h>
#include <ringwatch/verify/work_precision.h>

namespace ringwatch {
namespace {

using Clock = std::chrono::steady_clock;

/// Adds the time it lives to a total, s.
class Stopwatch {
 public:
  explicit Stopwatch(double& total) : total_(total), start_(Clock::now()) {}
  ~Stopwatch() { total_ += std::chrono::duration<double>(Clock::now() - start_).count(); }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  double& total_;
  Clock::time_point start_;
};

Verdict verdictFor(double h, const CriticalStep& bracket) {
  return h <= bracket.safe ? Verdict::certified : h <= bracket.optimistic ? Verdict::notCertified : Verdict::violated;
}

/// A run in progress.
class Run {
 public:
  Run(const Scene& scene, Body& body, const RunOptions& options)
      : scene_(scene),
        body_(body),
        options_(options),
        rule_(stepRule(*integratorCatalog().find(scene.method), scene.damping)),
        integrator_(integratorCatalog().make(scene.method)),
        energies_(scene, body),
        steps_(scene),
        progress_(options.progress) {
    result_.notes = options.notes;
    result_.requireCertified = scene_.requireCertified;
    for (const Scene::Cut& cut : scene_.cuts)
      for (const MeshBlock& block : body_.mesh().blocks)
        if (block.type != elementTypeOf<Tet4>)
          throw InputError(fmt::format("{}: only tetrahedra of four nodes can be cut; the mesh has {}", cut.origin,
                                       elementInfo(block.type).name));
    startHandler();
    if (handler_) prepareHandler(body_.mesh().X, *scene_.step);
    startDevice();
    startSystem();
    if (integrator_->info().partitioned) splitBody();
  }

  RunResult go() {
    {
      const Stopwatch total(result_.wallTime);
      {
        const Stopwatch output(result_.outputTime);
        output_.emplace(scene_, body_, rule_, options_.folder);
      }
      state_ = system_->initialState();
      advance();
      progress_.clear();
      finish();
    }
    result_.files.emplace_back("summary.json");
    writeFileAtomically(options_.folder / "summary.json", summaryJson(scene_, body_, result_).dump(2) + "\n");
    return std::move(result_);
  }

 private:
  /// Steps until something ends the run.
  void advance() {
    for (std::int64_t k = 0;; k = result_.steps) {
      // A rounding error in the sum of the steps must not add one.
      if (steps_.step() > 0 && state_.time >= scene_.end - 1e-3 * steps_.step())
        return end(ExitReason::end, "end time reached");
      if (options_.interrupt && options_.interrupt->load())
        return end(ExitReason::interrupted, fmt::format("interrupted before step {}", k));
      while (result_.cuts.size() + cutsMissed_ < scene_.cuts.size() &&
             state_.time >= scene_.cuts[result_.cuts.size() + cutsMissed_].time - 1e-3 * steps_.step())
        cut(scene_.cuts[result_.cuts.size() + cutsMissed_]);

      const bool rowDue = k % scene_.historyEvery == 0;
      MonitorReport report = handleMore(k, observe(k, rowDue));
      looks_ += report.fresh ? 1 : 0;
      if (!state_.x.allFinite() || !state_.v.allFinite()) {
        keepEvents(report);
        return end(ExitReason::nonFinite, fmt::format("positions or velocities are not finite after step {}", k));
      }
      if (!chooseStep(report)) return keepEvents(report);
      energies_.judge(k, state_.time);
      record(report, rowDue);
      if (report.verdict == Verdict::violated && monitor_ &&
          (scene_.onViolation == OnViolation::stop || scene_.onViolation == OnViolation::handle))
        return end(ExitReason::violated, fmt::format("stopped before step {}, which is violated", k));
      if (!takeStep(report)) return;
      showProgress(report);
    }
  }

  /// What depends on the masses and on which elements are explicit.
  void startSystem() {
    system_.emplace(body_, scene_.damping);
    state_.a.resize(3, 0);
    closeEvents();
    monitor_.reset();
    if (!scene_.monitored()) return;
    const Body& watched = handler_ ? handler_->explicitBody() : body_;
    if (watched.mesh().elementCount() == 0) {
      if (result_.handler->selections == 1)
        result_.notes.emplace_back("every element is handled: there is no explicit one to monitor");
      return;
    }
    MonitorOptions wanted;
    wanted.limit = rule_;
    wanted.mode = scene_.mode;
    wanted.metric = scene_.metric;
    wanted.margin = scene_.margin;
    // A run on a GPU calls it only where it is to look.
    wanted.every =
        device_ ? 1 : static_cast<int>(std::min<std::int64_t>(scene_.every, std::numeric_limits<int>::max()));
    wanted.energyTolerance = scene_.energyTolerance;
    if (monitored_) wanted.firstLookElements = 0;  // too dear at every choice of a handler
    monitored_ = true;
    if (device_ && device_->hasRings())  // it is at the state that the monitor looks at
      wanted.metricElsewhere = [this](const NodeVectors&) { return device_->highestRing(); };
    monitor_.emplace(watched, wanted);
  }

  /// Moves the steps to a GPU, when the scene wants that.
  void startDevice() {
    if (scene_.device == RunDevice::cpu) return;
    std::string reason = scene_.noDevice.empty() ? whyNoDevice() : scene_.noDevice;
    if (reason.empty()) {
      try {
        // A handler's monitor watches the explicit elements, the GPU's rings would be those of all.
        const MetricInfo* metric = findMetric(scene_.metric);
        device_ =
            makeDeviceRun(body_, BodySystem(body_).initialState(), metric != nullptr && metric->runsOnGpu && !handler_);
        handOver();
        return;
      } catch (const InputError& fault) {
        device_.reset();
        reason = fault.what();
      }
    }
    if (scene_.device == RunDevice::cuda)
      throw InputError(fmt::format("{}: \"cuda\": {}; set it to \"cpu\" or \"auto\"", scene_.deviceOrigin, reason));
    result_.notes.push_back(fmt::format("device = \"auto\": the steps are taken on the CPU, since {}", reason));
  }

  /// Steps from number k on that the GPU may take before the state is observed.
  std::int64_t stepsUntilLook(std::int64_t k) const {
    // The work of prescribed motion is done in every step.
    if (scene_.energy && body_.constraints().moving()) return 1;
    const auto until = [k](std::int64_t every) { return every - k % every; };
    constexpr std::int64_t most = 256;  // an interrupt is not to wait longer, nor the certificate to be renewed
    std::int64_t count = std::min(most, until(scene_.historyEvery));
    if (monitor_) count = std::min(count, until(scene_.every));
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

  void startHandler() {
    if (scene_.handler.empty()) return;
    auto handler = makeHandler(scene_.handler, body_, std::move(integrator_), scene_.handlerOptions);
    handler_ = handler.get();
    integrator_ = std::move(handler);
  }

  void prepareHandler(const NodeVectors& x, double h) {
    handler_->prepare(x, h);
    noteChoice();
    handOver();
  }

  void noteChoice() {
    if (!result_.handler) result_.handler.emplace();
    result_.handler->elements = static_cast<std::int64_t>(handler_->elements().size());
    result_.handler->certified = handler_->certified();
    ++result_.handler->selections;
    result_.handler->evaluations += handler_->judged().evaluations;
  }

  /// The handler's elements, to a GPU that takes the steps.
  void handOver() {
    if (device_ && handler_)
      device_->handle(handler_->elements(), result_.handler->selections > 1 ? steps_.step() : *scene_.step,
                      scene_.handlerOptions);
  }

  double kineticEnergy() const { return 0.5 * (state_.v.colwise().squaredNorm() * body_.lumpedMass()).value(); }

  /// Cuts the body, carries the state over and builds again what depends on the mesh.
  void cut(const Scene::Cut& wanted) {
    CutRecord record;
    record.step = result_.steps;
    record.time = state_.time;
    const auto handled = [&] { return handler_ ? static_cast<std::int64_t>(handler_->elements().size()) : 0; };
    record.elementsBefore = static_cast<std::int64_t>(body_.mesh().elementCount());
    completeState();
    askFor(true);
    evaluateForBooks();
    keepBooks(true);
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
      const Handler* const before = handler_;
      const std::unique_ptr<Integrator> integratorBefore = std::move(integrator_);  // its choice is carried over
      // All of these hold on to the body or to vectors of its size.
      closeEvents();
      monitor_.reset();
      split_.reset();
      system_.reset();
      handler_ = nullptr;
      state_.x = carriedOver(made, state_.x);
      state_.v = carriedOver(made, state_.v);
      body_ = sceneBody(scene_, made.mesh, body_.threads());
      body_.constraints().imposeVelocity(state_.v);
      integrator_ = integratorCatalog().make(scene_.method);
      energies_.beginBody();
      startHandler();
      if (handler_) {
        const Stopwatch selection(record.selectionTime);
        handler_->prepare(state_.x, steps_.step(), made, *before);
        noteChoice();
        record.judged = handler_->judged();
      }
      startSystem();
      if (integrator_->info().partitioned) splitBody();
      record.elementsCut = static_cast<std::int64_t>(made.elementsCut);
      record.nodesAdded = static_cast<std::int64_t>(made.nodesAdded);
      record.facesOpened = static_cast<std::int64_t>(made.facesOpened);
      record.area = made.area;
      record.atMost = optimisticStep(highestReducedRing(body_, state_.x, made.changed), rule_);
    }
    // The books of the new body start here, however long it is to the next row.
    askFor(true);
    evaluateForBooks();
    keepBooks(true);
    record.cutTime -= record.selectionTime;
    record.elementsAfter = static_cast<std::int64_t>(body_.mesh().elementCount());
    if (wanted.criticalStep) record.after = criticalStepHere();
    record.kineticAfter = kineticEnergy();
    record.handledAfter = handled();
    result_.cuts.push_back(record);
  }

  /// The bracket of the whole body, from scratch; empty where the state has none.
  std::optional<CriticalStep> criticalStepHere() const {
    try {
      return criticalStep(body_, state_.x, rule_);
    } catch (const NumericalError&) {
      return std::nullopt;
    }
  }

  /// The monitor sees the explicit elements under numbers of their own.
  void nameElements(MonitorReport& report) const {
    if (report.bracket) {
      report.bracket->controlling = handler_->wholeElement(report.bracket->controlling);
      report.bracket->lowestRingElement = handler_->wholeElement(report.bracket->lowestRingElement);
    }
    for (MonitorEvent& event : report.newEvents)
      if (event.element) event.element = handler_->wholeElement(*event.element);
  }

  /// For "handle": more elements where the explicit rest is no longer certified, and another look at what is left.
  MonitorReport handleMore(std::int64_t k, MonitorReport report) {
    if (!handler_ || !monitor_ || scene_.onViolation != OnViolation::handle || !report.fresh ||
        report.verdict == Verdict::certified || !(steps_.step() > 0) || !state_.x.allFinite())
      return report;
    {
      const Stopwatch watch(result_.monitorTime);
      prepareHandler(state_.x, steps_.step());
      startSystem();
    }
    MonitorReport more = observe(k, k % scene_.historyEvery == 0);
    // Those of the explicit elements are of a choice that no step was taken with.
    for (const MonitorEvent& event : report.newEvents)
      if (event.handled) more.newEvents.push_back(event);
    return more;
  }

  void end(ExitReason reason, std::string text) {
    result_.reason = reason;
    result_.reasonText = std::move(text);
  }

  /// Partitioned schemes get the elements whose own critical step is too small as their stiff part.
  void splitBody() {
    const std::vector<ElementRef> stiff = stiffElementsAt(body_, integrator_->info(), *scene_.step);
    split_.emplace(body_, stiff, scene_.damping);
    stiffElements_ = static_cast<std::int64_t>(stiff.size());
    result_.notes.push_back(
        fmt::format("{}: {} of {} elements are in the stiff part, by their own critical step at rest", scene_.method,
                    stiff.size(), body_.mesh().elementCount()));
  }

  /// What the pass over the elements of the whole body is to give at this state.
  void askFor(bool rowDue) {
    const bool beginsStep = !device_ && !split_ && integrator_->beginsWithAcceleration() && state_.a.cols() == 0;
    evaluation_.wantsForce = beginsStep || state_.lag != 0 || energies_.needsForce(rowDue);
    evaluation_.wantsEnergy = scene_.energy && rowDue;
  }
  /// Gives the state the acceleration that was evaluated.
  void takeAcceleration() {
    if (!evaluation_.wantsForce || device_ || split_) return;
    if (integrator_->beginsWithAcceleration() || state_.lag != 0) system_->complete(state_, evaluation_);
  }
  /// Energies of the state before the step, after its evaluation.
  void keepBooks(bool rowDue) {
    const Stopwatch force(result_.forceTime);
    energies_.record(state_, evaluation_, *system_, rowDue);
  }

  /// Evaluates the state before step k: one pass over the elements serves the scheme, the energy books and, where it
  /// watches the whole body, the monitor.
  MonitorReport observe(std::int64_t k, bool rowDue) {
    askFor(rowDue);
    const bool shared = monitor_ && !handler_ && !device_;
    MonitorReport report;
    if (shared) {
      report = observeExplicit(k, &evaluation_);
    } else {
      evaluateForBooks();
      report = observeExplicit(k, nullptr);
    }
    takeAcceleration();
    keepBooks(rowDue);
    if (monitor_ && energies_.last() && monitorSees(k)) {
      const Stopwatch watch(result_.monitorTime);
      report.newEvents = monitor_->observeEnergies(*energies_.last()).newEvents;
    }
    if (handler_) nameElements(report);
    if (!handler_ || !scene_.monitored()) return report;
    if (k % scene_.every == 0 && state_.x.allFinite()) {
      const Stopwatch watch(result_.monitorTime);
      const bool certifiedBefore = handledWatch_.uncertifiedPart().empty();
      if (const auto event = handledWatch_.observe(*handler_, body_, k, state_.time, state_.x))
        report.newEvents.push_back(*event);
      if (const std::string& part = handledWatch_.uncertifiedPart(); certifiedBefore && !part.empty())
        result_.notes.push_back(fmt::format("step {}, t = {:.6g} s: {}", k, state_.time, part));
    }
    judgeHandled(report);
    return report;
  }
  /// Between its looks the monitor does not see the states of a run on a GPU.
  bool monitorSees(std::int64_t k) const { return !device_ || k % scene_.every == 0; }
  /// The velocity of a state that is used other than by observe() must not lag.
  void completeState() {
    if (!device_ && !split_) complete(*system_, state_);
  }
  void evaluateForBooks() {
    if (!evaluation_.wantsForce && !evaluation_.wantsEnergy) return;
    const Stopwatch force(result_.forceTime);
    body_.evaluate(state_.x, evaluation_, workspace_);
  }

  /// A step is certified only with the handled parts that need a proof of their own.
  void judgeHandled(MonitorReport& report) const {
    if (!handledWatch_.uncertifiedPart().empty() && report.verdict == Verdict::certified)
      report.verdict = Verdict::notCertified;
  }

  MonitorReport observeExplicit(std::int64_t k, StepEvaluation* evaluation) {
    if (!monitor_) {
      MonitorReport report;
      report.step = k;
      report.time = state_.time;
      report.h = steps_.step();
      return report;
    }
    const Stopwatch watch(result_.monitorTime);
    evaluation_.wallTime = 0;
    if (!monitorSees(k)) {
      lastReport_.step = k;
      lastReport_.time = state_.time;
      lastReport_.fresh = false;
      lastReport_.newEvents.clear();
      return lastReport_;
    }
    // With "auto" the first step is chosen from the first bracket.
    MonitorReport report = monitor_->observe(k, state_.time, state_.x, state_.v, steps_.asked(), evaluation);
    // The pass over the elements counts as the force's, which it serves too.
    result_.monitorTime -= evaluation_.wallTime;
    result_.forceTime += evaluation_.wallTime;
    if (device_) lastReport_ = report;
    return report;
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
    judgeHandled(report);
    if (report.verdict != Verdict::violated)
      std::erase_if(report.newEvents, [](const MonitorEvent& event) { return event.kind == EventKind::violated; });
    return true;
  }

  void keepEvents(const MonitorReport& report) {
    for (const MonitorEvent& event : report.newEvents) {
      result_.events.push_back({event, elementJson(body_.mesh(), event.element), eventText(event, body_.mesh())});
      if (event.kind == EventKind::violated && !result_.firstViolated) result_.firstViolated = {event.step, event.time};
    }
  }

  void record(const MonitorReport& report, bool rowDue) {
    const Stopwatch output(result_.outputTime);
    output_->open();
    keepEvents(report);
    if (rowDue) {
      HistoryRow row;
      row.step = report.step;
      row.time = state_.time;
      row.h = report.h;
      row.bracket = report.bracket;
      row.energies = energies_.last();
      row.elementsRefreshed = monitor_ && report.fresh ? report.elementsRefreshed : 0;
      row.handledElements = handler_ ? static_cast<std::int64_t>(handler_->elements().size()) : stiffElements_;
      row.metricStep = report.metricStep;
      if (monitor_) row.verdict = report.verdict;
      output_->writeRow(row);
    }
    if (output_->frameDue(state_.time, report.h)) output_->writeFrame(report.step, state_, frameOf(report));
  }

  FrameState frameOf(const MonitorReport& report) const {
    FrameState frame;
    frame.time = state_.time;
    frame.h = steps_.step();
    if (monitor_) {
      frame.verdict = report.verdict;
      if (scene_.proves()) {
        frame.safe = report.bracket ? report.bracket->safe : report.certified;
        if (report.bracket) frame.optimistic = report.bracket->optimistic;
      }
    }
    if (handler_) frame.handled = handler_->elements();
    return frame;
  }

  /// One step, or on a GPU up to `count`: `count` becomes what was taken, and a step that fails after others is tried
  /// again by the next call.
  StepStatus tryStep(std::int64_t& count) {
    if (split_) return integrator_->step(*split_, state_, steps_.step());
    if (!device_) return integrator_->advance(*system_, state_, steps_.step());
    const DeviceRun::Taken taken =
        device_->step(state_, steps_.step(), count, monitor_ && scene_.proves() ? rule_.lambdaFor(steps_.step()) : 0);
    count = taken.steps;
    return {taken.steps > 0 || taken.fault.empty(), taken.fault};
  }

  bool takeStep(const MonitorReport& report) {
    const Stopwatch force(result_.forceTime);
    std::int64_t taken = 1;
    if (device_) taken = stepsUntilLook(result_.steps);
    StepStatus status = tryStep(taken);
    while (!status.done && handler_ && scene_.reduceOnFailure && steps_.halve()) {
      result_.notes.push_back(
          fmt::format("step {}: {}; the step is halved to {:.6g} s", report.step, status.reason, steps_.step()));
      prepareHandler(state_.x, steps_.step());
      startSystem();
      taken = 1;
      status = tryStep(taken);
    }
    if (!status.done) {
      end(ExitReason::stepFailed, fmt::format("step {} failed: {}", report.step, status.reason));
      return false;
    }
    result_.smallestStep = result_.steps == 0 ? steps_.step() : std::min(result_.smallestStep, steps_.step());
    result_.largestStep = std::max(result_.largestStep, steps_.step());
    result_.steps += taken;
    if (monitor_) {
      result_.worst = std::max(result_.worst.value_or(Verdict::certified), report.verdict);
      result_.violatedStepTaken = result_.violatedStepTaken || report.verdict == Verdict::violated;
      if (scene_.proves()) countCertified(report, taken);
    }
    lastVerdict_ = report.verdict;
    return true;
  }

  void countCertified(const MonitorReport& report, std::int64_t taken) {
    result_.watchedSteps += taken;
    if (report.verdict == Verdict::certified) {
      result_.certifiedSteps += taken;
      if (looks_ <= 1) result_.firstLookSteps += taken;
    }
    if (!report.fresh || !report.bracket || !(report.bracket->safe > 0)) return;
    const double safe = report.bracket->safe;
    if (!result_.safeSeen) result_.safeSeen = {safe, safe};
    result_.safeSeen->least = std::min(result_.safeSeen->least, safe);
    result_.safeSeen->largest = std::max(result_.safeSeen->largest, safe);
  }

  void showProgress(const MonitorReport& report) {
    if (!progress_.due()) return;
    progress_.show(fmt::format("step {} of about {:.0f}, t = {:.4g} of {:.4g} s, h = {:.4g} s{}{}", report.step,
                               static_cast<double>(report.step) + (scene_.end - state_.time) / steps_.step(),
                               state_.time, scene_.end, steps_.step(),
                               report.bracket ? fmt::format(", safe {:.4g} s", report.bracket->safe) : "",
                               monitor_ ? fmt::format(", {}", verdictName(report.verdict)) : ""),
                   state_.time / scene_.end);
  }

  /// A GPU solves the clusters in its own way.
  std::vector<HandlerFigure> handlerFigures() const {
    std::vector<HandlerFigure> figures = handler_->figures();
    if (!device_) return figures;
    std::erase_if(figures, [](const HandlerFigure& figure) { return figure.ofHost; });
    for (HandlerFigure& figure : device_->figures()) figures.push_back(std::move(figure));
    return figures;
  }

  void finish() {
    completeState();
    result_.time = state_.time;
    if (result_.reason == ExitReason::end && (!state_.x.allFinite() || !state_.v.allFinite()))
      end(ExitReason::nonFinite, fmt::format("positions or velocities are not finite after step {}", result_.steps));
    closeEvents();
    noteWhatIsNotCertified();
    if (handler_) result_.handler->figures = handlerFigures();
    if (device_) result_.notes.push_back(device_->summary());
    result_.runaway = energies_.runaway();
    const Stopwatch output(result_.outputTime);
    output_->finish(result_, state_, frameOf(lastOfAll()));
  }

  /// Nothing is known of the last state but what was known of the step that led to it.
  MonitorReport lastOfAll() const {
    MonitorReport report;
    report.verdict = lastVerdict_;
    report.certified = std::numeric_limits<double>::quiet_NaN();
    return report;
  }

  void noteWhatIsNotCertified() {
    if (result_.energyOff())
      result_.notes.emplace_back("the energy balance was off (see the events), so the run is not called stable");
    if (result_.watchedSteps == 0 || result_.certified()) return;
    std::string note = fmt::format("certified steps: {} of {}", result_.certifiedSteps, result_.watchedSteps);
    if (result_.safeSeen && scene_.step) {
      // Rounded down, so that the number as it is printed is certified.
      const double unit = std::pow(10, std::floor(std::log10(result_.safeSeen->least)) - 3);
      note += fmt::format(
          "; the safe step was {:.4g} to {:.4g} s along the run: a step of {:.4g} s would have been "
          "certified in these states",
          result_.safeSeen->least, result_.safeSeen->largest, std::floor(result_.safeSeen->least / unit) * unit);
    }
    if (static_cast<std::int64_t>(body_.mesh().elementCount()) > MonitorOptions{}.firstLookElements)
      note += fmt::format("; on more than {} elements inspect may prove a larger step than the run's first look",
                          MonitorOptions{}.firstLookElements);
    result_.notes.push_back(note);
  }

  void closeEvents() {
    const auto close = [&](const std::vector<MonitorEvent>& events, bool handled) {
      for (RunEvent& told : result_.events)
        for (const MonitorEvent& known : events)
          if (told.event.handled == handled && known.kind == told.event.kind && known.step == told.event.step)
            told.event.end = known.end;
    };
    close(handledWatch_.events(), true);
    if (monitor_) close(monitor_->events(), false);
  }

  const Scene& scene_;
  Body& body_;
  const RunOptions& options_;
  StepRule rule_;
  std::unique_ptr<Integrator> integrator_;
  Handler* handler_ = nullptr;  // the same, where it is one
  std::optional<BodySystem> system_;
  StepEvaluation evaluation_;
  Body::Workspace workspace_;
  std::optional<SplitBodySystem> split_;  // for partitioned schemes
  std::unique_ptr<DeviceRun> device_;     // when the steps are taken on a GPU
  HandledWatch handledWatch_;
  MonitorReport lastReport_;  // then: of the monitor's last look
  std::int64_t stiffElements_ = 0;
  RunEnergies energies_;
  StepPolicy steps_;
  std::size_t cutsMissed_ = 0;
  ProgressLine progress_;
  std::optional<StabilityMonitor> monitor_;
  std::optional<RunOutput> output_;
  State state_;
  bool monitored_ = false;  // a monitor has been made
  std::int64_t looks_ = 0;  // of monitors
  Verdict lastVerdict_ = Verdict::notCertified;
  RunResult result_;
};

}  // namespace

bool RunResult::energyOff() const {
  return std::any_of(events.begin(), events.end(),
                     [](const RunEvent& told) { return told.event.kind == EventKind::energyBalance; });
}

ExitStatus RunResult::exitStatus() const {
  const bool ended = reason == ExitReason::end || reason == ExitReason::interrupted;
  if (!ended || violatedStepTaken || runaway || energyOff()) return ExitStatus::unstable;
  if (requireCertified && !certified()) return ExitStatus::unstable;
  if (reason == ExitReason::interrupted) return ExitStatus::interrupted;
  return neverCertified() ? ExitStatus::notCertified : ExitStatus::done;
}

std::string_view RunResult::verdict() const {
  if (reason == ExitReason::nonFinite || runaway || energyOff()) return "unstable";
  if (violatedStepTaken || reason == ExitReason::violated) return "violated";
  return worst ? verdictName(*worst) : "unmonitored";
}

RunResult runScene(const Scene& scene, Body& body, const RunOptions& options) { return Run(scene, body, options).go(); }

}  // namespace ringwatch
