#include <ringwatch/app/ranks/rank_run.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <ringwatch/app/command/integrator_catalog.h>
#include <ringwatch/app/command/progress.h>
#include <ringwatch/app/command/provenance.h>
#include <ringwatch/app/output/report.h>
#include <ringwatch/app/ranks/rank_frames.h>
#include <ringwatch/app/ranks/rank_handler.h>
#include <ringwatch/app/ranks/rank_threads.h>
#include <ringwatch/app/ranks/together.h>
#include <ringwatch/app/run/checkpoint.h>
#include <ringwatch/app/run/energy_runaway.h>
#include <ringwatch/app/run/run_output.h>
#include <ringwatch/app/run/run_recorder.h>
#include <ringwatch/app/run/saved_result.h>
#include <ringwatch/app/run/step_policy.h>
#include <ringwatch/app/run/stopwatch.h>
#include <ringwatch/app/run/timed_loads.h>
#include <ringwatch/app/scene/body_notes.h>
#include <ringwatch/app/scene/capabilities.h>
#include <ringwatch/app/scene/scene_state.h>
#include <ringwatch/base/archive.h>
#include <ringwatch/base/atomic_file.h>
#include <ringwatch/base/error.h>
#include <ringwatch/distributed/halo.h>
#include <ringwatch/distributed/partition.h>
#include <ringwatch/distributed/rank_body.h>
#include <ringwatch/distributed/rank_energies.h>
#include <ringwatch/distributed/rank_monitor.h>
#include <ringwatch/distributed/rank_stepper.h>

namespace ringwatch {
namespace {

/// What is asked of a run from outside, as RankMonitor::observe takes it.
enum Wish : int { nothing = 0, checkpointWish = 1, endWish = 2 };

/// A line of progress now and then, where no terminal shows one: launchers hand on standard error through a pipe.
class ProgressLog {
 public:
  explicit ProgressLog(bool wanted) : wanted_(wanted) {}
  bool due() {
    const Clock::time_point now = Clock::now();
    if (!wanted_ || now - last_ < std::chrono::seconds(30)) return false;
    last_ = now;
    return true;
  }

 private:
  using Clock = std::chrono::steady_clock;
  bool wanted_;
  Clock::time_point last_ = Clock::now();
};

class RankRun {
 public:
  RankRun(Ranks& ranks, const RankRunRequest& request) : ranks_(ranks), request_(request), log_(first()) {}

  ExitStatus go(const std::function<void(const std::string&)>& print) {
    begin();
    try {
      step();
      finish();
    } catch (const OtherRankFailed&) {
      throw;
    } catch (const std::exception& fault) {
      if (knownToAll_) throw;
      fail(fault);
    }
    auto status = static_cast<int>(result_.exitStatus());
    if (first()) {
      try {
        writeSummary();
        if (!request_.quiet) print(summaryText(scene_, *whole_, result_, request_.folder));
      } catch (const std::exception& fault) {
        if (result_.reason != ExitReason::interrupted)
          endAll(ranks_, fault.what(), ExitStatus::unstable);  // else the terminal may be what is gone
      }
    }
    ranks_.share(&status, sizeof status, 0);  // of the first rank, which knows of all events
    return static_cast<ExitStatus>(status);
  }

 private:
  bool first() const { return ranks_.rank() == 0; }
  /// What the monitor sees of the part: all of it, or the explicit elements.
  const RankBody& watched() const { return explicitPart_ ? *explicitPart_ : *part_; }

  /// Ends all ranks for a fault that this one has alone, as far as it knows. What a run that has begun came to is
  /// written before, by the first rank or by one that finds no summary.
  [[noreturn]] void fail(const std::exception& fault) {
    const std::string text = fmt::format("step {}: {}", result_.steps, faultText(fault));
    if (!outputIsOpen_) endAll(ranks_, text, ExitStatus::badInput);
    end(ExitReason::failed, fmt::format("{}, {}", ranks_.name(), text));
    result_.time = state_.time;
    try {
      if (first()) {
        output_->flush();
        result_.files.emplace_back("history.csv");
        recorder_->noteWhatIsNotCertified(whole_->mesh());
      } else {
        result_.notes.emplace_back("the events are left out: the first rank alone knew of them");
      }
      if (first() || !std::filesystem::exists(request_.folder / "summary.json")) writeSummary();
    } catch (const std::exception&) {
      // The line on standard error is all that is left.
    }
    endAll(ranks_, text, ExitStatus::unstable);
  }

  /// together(), of a run that has begun.
  template <class Work>
  void orAllThrow(const Work& work) {
    knownToAll_ = true;
    together(ranks_, work);
    knownToAll_ = false;
  }

  /// Every rank reads the scene and makes the whole body, and keeps its part.
  void begin() {
    std::optional<Checkpoint> saved;
    std::optional<TimedLoads> allLoads;
    State all;
    together(ranks_, [&] {
      if (!request_.resumed.empty()) {
        saved = readCheckpoint(request_.resumed);
        if (!saved->parts.contains("ranks"))
          throw InputError(fmt::format("{}: was written by a run of one process; go on with it without mpirun",
                                       (request_.resumed / checkpointFile).string()));
        if (!request_.scene.empty()) requireSameScene(*saved, readScene(request_.scene, {}), request_.resumed);
        scene_ = sceneOf(*saved);
      } else {
        scene_ = readScene(request_.scene, request_.overrides);
      }
      requireTaken(scene_, SceneUse::ranks);
      Mesh mesh = sceneMesh(scene_, result_.notes);
      const int threads = threadsOfRank(ranks_, request_.threads, mesh);
      whole_ = std::make_unique<Body>(sceneBody(scene_, std::move(mesh), threads));
      for (std::string& note : bodyNotes(*whole_)) result_.notes.push_back(std::move(note));
      if (saved) {
        requireSameMesh(*saved, scene_, *whole_);
        resumeMotion(whole_->constraints(), saved->parts.at("moved").get<std::vector<double>>());
      }
      rule_ = sceneStepRule(scene_, *whole_);
      all = sceneInitialState(scene_, BodySystem(*whole_, scene_.damping));
      if (saved) all = saved->state;
      allLoads.emplace(scene_, *whole_);
      if (!scene_.handler.empty()) handler_ = makeRankHandler(scene_, *whole_, *scene_.step);
    });
    Partition partition = cutTogether(ranks_, whole_->mesh());
    together(ranks_, [&] {
      const int threads = threadsOfRank(ranks_, request_.threads, whole_->mesh());
      if (handler_) {
        handler_->adapt(partition);
        explicitPart_ = handler_->explicitPart(partition, ranks_.rank(), threads);
      }
      part_ = std::make_unique<RankBody>(*whole_, partition, ranks_.rank(), threads);
      loads_.emplace(*allLoads, part_->body(), part_->globalNodes());
      state_.time = all.time;
      state_.x.resize(3, part_->body().nodeCount());
      state_.v.resize(3, part_->body().nodeCount());
      for (std::int32_t i = 0; i < part_->body().nodeCount(); ++i) {
        state_.x.col(i) = all.x.col(part_->globalNode(i));
        state_.v.col(i) = all.v.col(part_->globalNode(i));
      }
      integrator_ = integratorCatalog().make(scene_.method);
      halo_ = std::make_unique<Halo>(ranks_, watched());
      system_ = std::make_unique<RankSystem>(*part_, scene_.damping);
      stepper_ = std::make_unique<RankStepper>(*halo_, *system_, *integrator_);
      steps_.emplace(scene_);
      recorder_.emplace(scene_, result_);
      if (handler_) handler_->begin({ranks_, *halo_, *part_, watched(), *system_, *integrator_, first()});
      ofWhole_ = summaryJson(scene_, *whole_, result_);
      ofWhole_["provenance"] = provenanceOf(request_.command, request_.scene);
      ofWhole_["provenance"]["mesh_hash"] = fmt::format("{:016x}", hashOf(whole_->mesh()));
      if (first())
        recorder_->follow(whole_->mesh());
      else
        whole_.reset();  // the first rank names elements by it
      result_.requireCertified = scene_.requireCertified;
      result_.proving = scene_.proves();
      runaway_.emplace(part_->roundingEnergy());
    });
    moving_ = ranks_.least(part_->body().constraints().moving() || !scene_.moves.empty() ? 0 : 1) == 0;
    frames_ = std::make_unique<RankFrames>(ranks_, *part_);
    together(ranks_, [&] {
      output_.emplace(scene_, first() ? whole_.get() : nullptr, part_->body(), *frames_, rule_, request_.folder);
    });
    noteWhatIsOfRanks();
    beginWatch();
    if (saved) resume(*saved);
    loads_->begin(state_.x);
  }

  void noteWhatIsOfRanks() {
    if (!request_.resumed.empty()) return;  // they are in the saved result
    result_.notes.push_back("the run was shared among ranks");
    if (scene_.device == RunDevice::automatic)
      result_.notes.emplace_back("device = \"auto\": ranks take their steps on the CPU");
    if (scene_.frameInterval && std::ranges::count(scene_.fields, "critical_step") > 0)
      result_.notes.emplace_back("frames of ranks are without critical_step, which is not distributed");
  }

  void beginWatch() {
    monitor_ = std::make_unique<RankMonitor>(ranks_, *halo_, watched(),
                                             RankMonitorOptions{.limit = rule_,
                                                                .mode = scene_.mode,
                                                                .every = static_cast<int>(std::min<std::int64_t>(
                                                                    scene_.every, std::numeric_limits<int>::max())),
                                                                .energyTolerance = scene_.energyTolerance});
    balance_ = std::make_unique<RankEnergyBalance>(ranks_, *part_, moving_);
    balanceBegins_ = true;
  }

  bool damped() const { return scene_.damping.any(); }
  bool energiesNeeded(bool rowDue) const { return scene_.energy && (rowDue || moving_ || damped()); }
  /// Takes energies of nodes that this rank owns into the balance.
  auto toBalance() {
    return [this](std::int32_t node, double work) {
      if (node < part_->ownedNodes()) balance_->addWork(node, work);
    };
  }

  void step() {
    for (std::int64_t k = result_.steps;; k = result_.steps) {
      wish_ = nothing;
      if (loads_->any()) loads_->setForces(state_.time, state_.x, toBalance());
      // A rounding error in the sum of the steps must not add one.
      if (steps_->step() > 0 && state_.time >= scene_.end - 1e-3 * steps_->step())
        return end(ExitReason::end, "end time reached");
      const bool rowDue = k % scene_.historyEvery == 0;
      MonitorReport report = observe(k, rowDue);
      if (handler_ && scene_.onViolation == OnViolation::handle && monitor_->stateIsFinite() &&
          handler_->wantsChoice(report))
        report = chooseAgain(k, rowDue);
      if (monitor_->stateIsFinite() && checkpointDue()) {
        writeCheckpointAndGoOn();
        report = observe(k, rowDue);
      }
      if (wish_ == endWish) {
        if (monitor_->stateIsFinite()) writeCheckpointOfSignal();
        return end(ExitReason::interrupted, fmt::format("interrupted before step {}", k));
      }
      if (wish_ == checkpointWish && monitor_->stateIsFinite()) writeCheckpointOfSignal();
      if (!monitor_->stateIsFinite()) {
        end(ExitReason::nonFinite, fmt::format("positions or velocities are not finite after step {}", k));
        return recordEvents(report);
      }
      if (!chooseStep(report)) return recordEvents(report);
      if (loads_->any() && k == 0) runaway_->setScale(energyScale());
      if (energies_) runaway_->check(*energies_, k, state_.time);
      record(report, rowDue);
      if (report.verdict == Verdict::violated &&
          (scene_.onViolation == OnViolation::stop || scene_.onViolation == OnViolation::handle))
        return end(reasonToStop(report), textOfStop(report));
      if (!takeStep(report)) return;
      showProgress(report);
    }
  }

  /// The handler divides steps anew, and what was observed is no event of a step that is taken.
  MonitorReport chooseAgain(std::int64_t k, bool rowDue) {
    {
      const Stopwatch measured(result_.monitorTime);
      handler_->choose(*monitor_, state_.x, steps_->step());
    }
    const std::string events = eventsBefore_;
    resumeEvents(events);
    MonitorReport report = observe(k, rowDue);
    eventsBefore_ = events;
    return report;
  }

  MonitorReport observe(std::int64_t k, bool rowDue) {
    const Stopwatch measured(result_.monitorTime);
    // A handler of elements that the monitor does not see evaluates its own.
    const bool stepperNeedsForce = !explicitPart_ && stepper_->needsForce(state_);
    evaluation_.wantsForce = stepperNeedsForce || (energiesNeeded(true) && moving_ && !explicitPart_);
    // A state may be observed again: what was asked at it before still holds.
    if (request_.checkpoint->exchange(false)) wish_ = std::max<int>(wish_, checkpointWish);
    if (request_.interrupt->load()) wish_ = endWish;
    eventsBefore_ = savedEvents();
    evaluation_.wallTime = 0;
    MonitorReport report =
        monitor_->observe(k, state_.time, state_.x, state_.v, steps_->asked(), evaluation_, wish_, [&] {
          const Stopwatch force(result_.forceTime);
          if (stepperNeedsForce) stepper_->takeForce(state_, evaluation_.internalForce);
        });
    // The pass over the elements counts as the force's, which it serves too.
    result_.monitorTime -= evaluation_.wallTime;
    result_.forceTime += evaluation_.wallTime;
    freshReports_ += report.fresh ? 1 : 0;
    recordEnergies(rowDue);
    if (energies_)
      report.newEvents = monitor_->observeEnergies(runaway_->forgiven(*energies_, scene_.energyTolerance)).newEvents;
    if (handler_ && report.step % scene_.every == 0 && monitor_->stateIsFinite())
      if (const auto event = handler_->watch(report, state_.x)) report.newEvents.push_back(*event);
    return report;
  }

  void recordEnergies(bool rowDue) {
    energies_.reset();
    const bool wanted = rowDue || balanceBegins_;
    balanceBegins_ = false;
    if (!energiesNeeded(wanted)) return;
    if (explicitPart_ && moving_) part_->body().internalForce(state_.x, allForce_, workspace_);
    balance_->record(state_.x, explicitPart_ ? allForce_ : evaluation_.internalForce);
    if (damped()) {
      system_->ofBody().dampingForce(state_.x, state_.v, dampingForce_);
      balance_->recordDamping(state_.time, state_.v, dampingForce_);
    }
    if (wanted) energies_ = energiesNow();
  }

  /// Of the state that was recorded last. Collective.
  Energies energiesNow() {
    Energies now = balance_->energies(state_.x, state_.v);
    now.externalWork += before_.externalWork;
    now.dissipated += before_.dissipated;
    now.balanceError += before_.balanceError;
    if (handler_) {
      // As RunEnergies::setDissipatedByHandler: what is gone does not come back.
      const double energy = handler_->dissipated();
      if (!(energy <= byHandler_)) byHandler_ = energy;
      now.dissipated += byHandler_;
      now.balanceError += byHandler_;
    }
    return now;
  }

  double energyScale() {
    ExactSum sum;
    loads_->energyScale(steps_->step(), [&](std::int32_t node, double energy) {
      if (node < part_->ownedNodes()) sum.add(energy);
    });
    ranks_.sum({&sum, 1});
    return sum.value();
  }

  bool chooseStep(MonitorReport& report) {
    std::string fault;
    const auto choose = [&] {
      fault = steps_->choose(report, state_.time, [this](MonitorReport& fresh) {
        const MonitorReport& proven = monitor_->prove(state_.x, steps_->step());
        fresh.bracket = proven.bracket;
        fresh.fresh = true;
        fresh.elementsRefreshed = proven.elementsRefreshed;
      });
    };
    if (steps_->step() > 0) {
      choose();
    } else {
      // The first step of "auto" may be out of all proportion to the end, which all ranks find and one tells.
      orAllThrow(choose);
    }
    if (!fault.empty()) {
      end(ExitReason::stepCollapsed, fault);
      return false;
    }
    if (steps_->endsTheRun()) output_->leaveOut(report.step);
    steps_->judge(report);
    return true;
  }

  void recordEvents(const MonitorReport& report) {
    if (first()) recorder_->recordEvents(report, whole_->mesh());
  }

  void record(const MonitorReport& report, bool rowDue) {
    const Stopwatch measured(result_.outputTime);
    if (!outputIsOpen_) orAllThrow([this] { output_->open(); });
    outputIsOpen_ = true;
    if (first()) recorder_->record(report, whole_->mesh());
    if (rowDue) {
      ExactSum refreshed;  // small whole numbers
      refreshed.add(report.fresh ? static_cast<double>(report.elementsRefreshed) : 0.0);
      ranks_.sum({&refreshed, 1});
      HistoryRow row;
      row.step = report.step;
      row.time = state_.time;
      row.h = report.h;
      row.bracket = report.bracket;
      row.energies = energies_;
      row.elementsRefreshed = static_cast<std::int64_t>(refreshed.value());
      row.handledElements = handler_ ? handler_->handledElements() : 0;
      row.verdict = report.verdict;
      output_->writeRow(row);
    }
    if (output_->frameDue(state_.time, report.h)) output_->writeFrame(report.step, stateOfFrame(), frameOf(report));
  }

  /// Ghosts have the velocities of their owners there.
  State stateOfFrame() {
    State state;
    state.time = state_.time;
    state.x = state_.x;
    state.v = state_.v;
    halo_->exchange(state.v);
    return state;
  }

  FrameState frameOf(const MonitorReport& report) const {
    FrameState frame;
    frame.time = state_.time;
    frame.h = steps_->step();
    frame.verdict = report.verdict;
    frame.safe = report.bracket ? report.bracket->safe : report.certified;
    if (report.bracket) frame.optimistic = report.bracket->optimistic;
    return frame;
  }

  bool takeStep(const MonitorReport& report) {
    const Stopwatch force(result_.forceTime);
    if (loads_->any()) loads_->setVelocities(state_, steps_->step(), toBalance());
    const StepStatus status = handler_ && !handler_->stepsAsBase() ? handler_->step(state_, steps_->step())
                                                                   : stepper_->beginStep(state_, steps_->step());
    if (!status.done) {
      end(ExitReason::stepFailed, fmt::format("step {} failed: {}", report.step, status.reason));
      return false;
    }
    recorder_->countSteps(1, steps_->step());
    recorder_->countVerdict(report, 1, freshReports_ <= 1);
    lastVerdict_ = report.verdict;
    return true;
  }

  void showProgress(const MonitorReport& report) {
    if (!first() || request_.quiet) return;
    const bool onTerminal = progress_.due();
    if (!onTerminal && !log_.due()) return;
    const double time = state_.time, h = steps_->step();
    const std::string text = fmt::format(
        "step {} of about {:.0f}, t = {:.4g} of {:.4g} s, h = {:.4g} s{}, {}", report.step,
        static_cast<double>(report.step) + (scene_.end - time) / h, time, scene_.end, h,
        report.bracket ? fmt::format(", safe {:.4g} s", report.bracket->safe) : "", verdictName(report.verdict));
    if (onTerminal)
      progress_.show(text, time / scene_.end);
    else
      progress_.tell(text, false);
  }

  bool checkpointDue() const {
    return scene_.checkpointInterval && result_.steps > 0 &&
           state_.time >= static_cast<double>(checkpoints_ + 1) * *scene_.checkpointInterval - 1e-3 * steps_->step();
  }

  /// Monitor and balance begin again there, in the run that goes on as in one that is resumed; the events go along.
  void writeCheckpointAndGoOn() {
    const double reached = state_.time + 1e-3 * steps_->step();
    // However many lie within a step.
    checkpoints_ = std::max(checkpoints_ + 1, static_cast<std::int64_t>(reached / *scene_.checkpointInterval));
    before_ = writeCheckpoint();
    state_.a.resize(3, 0);
    beginWatch();
    resumeEvents(eventsBefore_);
    loads_->begin(state_.x);
  }

  /// Of a signal: nothing of this run changes. One that goes on from it begins monitor and balance again.
  void writeCheckpointOfSignal() {
    std::string reason = whyNot(scene_, Feature::savedStates);
    if (reason.empty() && result_.steps == 0) reason = "no step was taken yet";
    if (reason.empty()) writeCheckpoint();
    if (!first()) return;
    const std::string text = reason.empty()
                                 ? fmt::format("step {}, t = {:.6g} s: checkpoint written to {}", result_.steps,
                                               state_.time, (request_.folder / checkpointFile).string())
                                 : fmt::format("there is no checkpoint of step {}: {}", result_.steps, reason);
    if (wish_ == checkpointWish) return progress_.tell(text, !reason.empty());
    result_.notes.push_back(reason.empty() ? fmt::format("ringwatch run --resume {}, by mpirun, goes on from here",
                                                         request_.folder.string())
                                           : text);
  }

  std::string savedEvents() {
    SavingArchive archive;
    monitor_->archiveEvents(archive);
    return archive.take();
  }
  void resumeEvents(const std::string& saved) {
    LoadingArchive archive(saved);
    monitor_->archiveEvents(archive);
    archive.end();
  }

  /// Of the state that was observed last, with what was known before that: it is observed again. Returns the energies
  /// for a balance that begins here. Collective.
  Energies writeCheckpoint() {
    const Stopwatch measured(result_.outputTime);
    Energies totals;  // what a balance that begins here does not know
    if (scene_.energy) {
      totals = energiesNow();
      totals.kinetic = totals.strain = 0;
    }
    total_.lap();
    Checkpoint saved;
    saved.state.time = state_.time;
    saved.state.x = gathered(ranks_, *part_, state_.x);
    saved.state.v = gathered(ranks_, *part_, state_.v);
    const NodeVectors velocities = gathered(ranks_, *part_, part_->body().constraints().velocity());
    if (!first()) return totals;
    std::vector<double> moved;
    if (moving_)
      for (const std::int64_t i : whole_->constraints().components()) moved.push_back(velocities.data()[i]);
    saved.sceneFile = scene_.file;
    if (!scene_.meshFile.empty()) saved.meshFile = std::filesystem::absolute(scene_.meshFile);
    saved.scene = scene_.echo;
    saved.mesh = hashOf(whole_->mesh());
    saved.parts = {{"ranks", true},
                   {"result", savedResult(result_)},
                   {"before", energiesJson(totals)},
                   {"runaway", runaway_->save()},
                   {"steps", steps_->save()},
                   {"fresh_reports", freshReports_},
                   {"output", output_->save()},
                   {"moved", std::move(moved)},
                   {"checkpoints_due", checkpoints_},
                   {"last_verdict", std::string(verdictName(lastVerdict_))}};
    saved.memory = eventsBefore_;
    ringwatch::writeCheckpoint(request_.folder, saved);
    return totals;
  }

  void resume(const Checkpoint& saved) {
    resumeResult(saved.parts.at("result"), scene_, static_cast<std::size_t>(saved.state.x.cols()), result_);
    resumedAt_ = result_.steps;
    before_ = energiesOfJson(saved.parts.at("before"));
    runaway_->resume(saved.parts.at("runaway"));
    steps_->resume(saved.parts.at("steps"));
    freshReports_ = saved.parts.at("fresh_reports").get<std::int64_t>();
    checkpoints_ = saved.parts.at("checkpoints_due").get<std::int64_t>();
    lastVerdict_ = savedVerdict(saved.parts.at("last_verdict"));
    resumeEvents(saved.memory);
    together(ranks_, [&] { output_->resume(saved.parts.at("output"), result_.steps); });
    outputIsOpen_ = true;
  }

  void end(ExitReason reason, std::string text) {
    result_.reason = reason;
    result_.reasonText = std::move(text);
  }

  void finish() {
    progress_.clear();
    stepper_->complete(state_);
    result_.time = state_.time;
    const bool finite =
        ranks_.least(allFinite(NodeVectorsView(state_.x.data(), part_->ownedNodes()), part_->body().threads()) &&
                             allFinite(NodeVectorsView(state_.v.data(), part_->ownedNodes()), part_->body().threads())
                         ? 1
                         : 0) == 1;
    if (result_.reason == ExitReason::end && !finite)
      end(ExitReason::nonFinite, fmt::format("positions or velocities are not finite after step {}", result_.steps));
    // Nothing is known of the last state but what was known of the step that led to it.
    MonitorReport report;
    report.verdict = lastVerdict_;
    report.certified = std::numeric_limits<double>::quiet_NaN();
    const FrameState last = frameOf(report);
    const auto close = [&](std::span<const MonitorEvent> events) {
      for (RunEvent& told : result_.events)
        for (const MonitorEvent& known : events)
          if (known.handled == told.event.handled && known.kind == told.event.kind && known.step == told.event.step)
            told.event.end = known.end;
    };
    close(monitor_->events());
    if (handler_) close(handler_->events());
    if (first()) recorder_->noteWhatIsNotCertified(whole_->mesh());
    result_.runaway = runaway_->moment();
    if (handler_) result_.handler = handler_->handling();
    countTraffic();
    const Stopwatch measured(result_.outputTime);
    output_->finish(result_, scene_.frameInterval ? stateOfFrame() : State(), finite ? &last : nullptr);
  }

  /// Of all ranks, in the result. Collective.
  void countTraffic() {
    const Halo::Traffic& own = halo_->traffic();
    enum : std::size_t { messages, bytes, received, hidden, ghosts, count };
    std::array<ExactSum, count> sums;  // whole numbers
    sums[messages].add(static_cast<double>(own.messages));
    sums[bytes].add(static_cast<double>(own.bytes));
    sums[received].add(static_cast<double>(own.received));
    sums[hidden].add(static_cast<double>(own.hidden));
    sums[ghosts].add(static_cast<double>(part_->ghostNodes()));
    ranks_.sum(sums);
    double waited = own.waited;
    ranks_.largest({&waited, 1});
    RunResult::Traffic all;
    all.ranks = ranks_.size();
    all.exchanges = own.exchanges;
    all.messages = static_cast<std::int64_t>(sums[messages].value());
    all.bytes = static_cast<std::int64_t>(sums[bytes].value());
    const std::int64_t numbers = system_->velocityDependent() ? 6 : 3;
    all.bytesByModel = static_cast<std::int64_t>(sums[ghosts].value()) * numbers *
                       static_cast<std::int64_t>(sizeof(double)) * (result_.steps - resumedAt_);
    if (sums[received].value() > 0) all.hidden = sums[hidden].value() / sums[received].value();
    all.waited = waited;
    result_.traffic = all;
  }

  void writeSummary() {
    result_.files.emplace_back("summary.json");
    total_.lap();
    nlohmann::ordered_json json = summaryJson(scene_, whole_ ? *whole_ : part_->body(), result_);
    // A part does not know the whole.
    for (const char* key : {"mesh", "mass", "provenance"}) json[key] = ofWhole_[key];
    if (!whole_) json["materials"] = ofWhole_["materials"];
    writeFileAtomically(request_.folder / "summary.json", json.dump(2) + "\n");
    std::error_code ignored;
    if (!result_.canGoOn()) std::filesystem::remove(request_.folder / checkpointFile, ignored);
  }

  Ranks& ranks_;
  const RankRunRequest& request_;
  Scene scene_;
  std::unique_ptr<Body> whole_;  // on the first rank
  StepRule rule_ = 0.0;
  RunResult result_;
  Stopwatch total_{result_.wallTime};
  nlohmann::ordered_json ofWhole_;  // a summary of the whole body before its first step
  std::unique_ptr<RankBody> part_;
  std::unique_ptr<RankBody> explicitPart_;  // of the same nodes; nullptr where it is all of the part
  std::optional<TimedLoads> loads_;
  std::unique_ptr<Integrator> integrator_;
  std::unique_ptr<Halo> halo_;
  std::unique_ptr<RankSystem> system_;
  std::unique_ptr<RankStepper> stepper_;
  std::unique_ptr<RankHandler> handler_;  // nullptr without one
  std::unique_ptr<RankMonitor> monitor_;
  std::unique_ptr<RankEnergyBalance> balance_;
  std::optional<StepPolicy> steps_;
  std::optional<RunRecorder> recorder_;
  std::optional<EnergyRunaway> runaway_;
  std::unique_ptr<RankFrames> frames_;
  std::optional<RunOutput> output_;
  State state_;
  StepEvaluation evaluation_;
  NodeVectors dampingForce_, allForce_;
  Body::Workspace workspace_;
  Energies before_;       // what balances before have come to
  double byHandler_ = 0;  // J, dissipated
  bool balanceBegins_ = true;
  std::string eventsBefore_;          // before the last observation
  std::optional<Energies> energies_;  // of the state, where a row is due
  Verdict lastVerdict_ = Verdict::notCertified;
  std::int64_t freshReports_ = 0, checkpoints_ = 0;
  std::int64_t resumedAt_ = 0;  // step
  int wish_ = nothing;
  bool moving_ = false;      // motion is prescribed at some time
  bool knownToAll_ = false;  // a fault is being told by together()
  bool outputIsOpen_ = false;
  ProgressLine progress_{first() && !request_.quiet};
  ProgressLog log_;
};

}  // namespace

ExitStatus runSceneOnRanks(Ranks& ranks, const RankRunRequest& request,
                           const std::function<void(const std::string&)>& print) {
  try {
    return RankRun(ranks, request).go(print);
  } catch (const OtherRankFailed& fault) {
    return fault.status;
  }
}

}  // namespace ringwatch
