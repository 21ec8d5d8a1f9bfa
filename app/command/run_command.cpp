#include <array>
#include <atomic>
#include <csignal>

#include <ringwatch/app/command/command.h>
#include <ringwatch/app/command/live_watch.h>
#include <ringwatch/app/output/provenance.h>
#include <ringwatch/app/ranks/rank_program.h>
#include <ringwatch/app/run/checkpoint.h>
#include <ringwatch/app/run/run_summary.h>
#include <ringwatch/app/run/runner.h>
#include <ringwatch/app/scene/body_notes.h>
#include <ringwatch/app/scene/scene_keys.h>
#include <ringwatch/base/error.h>

namespace ringwatch {
namespace {

std::atomic<bool> interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may only touch lock-free atomics");

std::atomic<bool> checkpointWanted{false};

extern "C" void onInterrupt(int) { interrupted.store(true); }
extern "C" void onCheckpointWanted(int) { checkpointWanted.store(true); }

/// While it lives, Ctrl-C, SIGTERM and a terminal that closes ask the run to end after its step; a second one ends the
/// program. A hang-up that is ignored (nohup) stays ignored. SIGUSR1 asks for a checkpoint.
class InterruptGuard {
 public:
  InterruptGuard() {
    interrupted.store(false);
    checkpointWanted.store(false);
    for (std::size_t i = 0; i < signals.size(); ++i) {
      sigaction(signals[i], nullptr, &old_[i]);
      if (signals[i] == SIGHUP && old_[i].sa_handler == SIG_IGN) continue;
      struct sigaction action {};
      action.sa_handler = onInterrupt;
      action.sa_flags = static_cast<int>(SA_RESETHAND);
      sigemptyset(&action.sa_mask);
      sigaction(signals[i], &action, nullptr);
    }
    struct sigaction action {};
    action.sa_handler = onCheckpointWanted;
    action.sa_flags = SA_RESTART;
    sigemptyset(&action.sa_mask);
    sigaction(SIGUSR1, &action, &oldCheckpoint_);
  }
  ~InterruptGuard() {
    for (std::size_t i = 0; i < signals.size(); ++i) sigaction(signals[i], &old_[i], nullptr);
    sigaction(SIGUSR1, &oldCheckpoint_, nullptr);
  }
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

 private:
  static constexpr std::array<int, 3> signals{SIGINT, SIGTERM, SIGHUP};
  std::array<struct sigaction, signals.size()> old_{};
  struct sigaction oldCheckpoint_ {};
};

struct RunCommand final : Command {
  using Command::Command;
  std::string scene, folder, resumed;
  std::vector<std::string> overrides;
  int threads = 0;
  bool quiet = false, helpScene = false, requireCertified = false, report = false, live = false;
  std::string ranksWanted = "auto";

  CLI::App* declare(CLI::App& app) override {
    CLI::App* command = app.add_subcommand("run", "run a scene: a nonlinear simulation with the monitor watching");
    command
        ->add_option("SCENE", scene,
                     "scene file (TOML), a deck of Abaqus, CalculiX or LS-DYNA, or a MuJoCo model; see ringwatch help "
                     "scene | decks")
        ->type_name("SCENE");
    command
        ->add_option("--out", folder, "folder for the results, made when missing (default: out/ and the scene's name)")
        ->type_name("DIR");
    command
        ->add_option("--resume", resumed,
                     "folder of a run that was stopped by a signal, or killed with output.checkpoint_every: go on from "
                     "its last checkpoint")
        ->type_name("DIR");
    command->add_option("--set", overrides, "section.key=value, replaces the value of the scene; may be given again")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    command
        ->add_option("--threads", threads,
                     "threads (default: as many as the mesh has work for); results do not depend on it")
        ->check(CLI::Range(0, 4096));
    declareRanks(*command, ranksWanted);
    command->add_flag("--require-certified", requireCertified,
                      "exit with status 1 unless every step was certified; as monitor.require_certified = true");
    command->add_flag("--report", report, "also write report.html there, as ringwatch report does");
    command->add_flag(
        "--live", live,
        "write report.html again and again while the run goes on, which reloads itself, and show bracket, progress "
        "and the monitor's cost on a terminal");
    command->add_flag("--quiet", quiet, "print nothing but errors; the exit status tells how it went");
    command->add_flag("--help-scene", helpScene, "list every key of a scene file, as ringwatch help scene does");
    command->footer(
        std::string("Writes history.csv, summary.json, critical_step.png and, with output.every, run.pvd for "
                    "ParaView.\n") +
        exitStatusHint);
    return command;
  }

  /// The command again, with all that the results depend on.
  std::string commandText() const {
    std::string text = "ringwatch run " + (resumed.empty() ? shellWord(scene) : "--resume " + shellWord(resumed));
    for (const std::string& setting : overrides) text += " --set " + quoted(setting);
    if (requireCertified) text += " --require-certified";
    if (threads > 0) text += fmt::format(" --threads {}", threads);
    return text;
  }

  ExitStatus execute() override {
    if (helpScene) {
      printOut(sceneHelp());
      return ExitStatus::done;
    }
    requireWhatGoesTogether();
    const InterruptGuard guard;  // while the mesh is read, too
    if (call.ranks) return runOnRanks();
    if (!resumed.empty()) return resume();
    const Scene description = readScene(scene, settings());
    return run(description, resultsFolder(), nullptr);
  }

  void requireWhatGoesTogether() const {
    if (resumed.empty()) {
      if (scene.empty()) throw InputError("run: SCENE is missing; give a scene file (TOML), see ringwatch help scene");
    } else {
      for (const auto& [given, option] : {std::pair{!overrides.empty(), "--set"},
                                          {!folder.empty(), "--out"},
                                          {requireCertified, "--require-certified"}})
        if (given)
          throw InputError(
              fmt::format("{}: does not go with --resume, which takes scene and folder as they were", option));
    }
    if (call.ranks && (report || live))
      throw InputError(fmt::format("{}: does not go with a run on ranks; call ringwatch report when it has ended",
                                   live ? "--live" : "--report"));
  }

  std::vector<std::string> settings() const {
    std::vector<std::string> all = overrides;
    if (requireCertified) all.emplace_back("monitor.require_certified=true");
    return all;
  }

  std::filesystem::path resultsFolder() const {
    return folder.empty() ? std::filesystem::path("out") / std::filesystem::path(scene).stem()
                          : std::filesystem::path(folder);
  }

  ExitStatus runOnRanks() const {
    RankRunRequest request;
    request.scene = scene;
    request.overrides = settings();
    request.folder = resumed.empty() ? resultsFolder() : std::filesystem::path(resumed);
    request.resumed = resumed;
    request.command = commandText();
    request.threads = threads;
    request.quiet = quiet;
    request.interrupt = &interrupted;
    request.checkpoint = &checkpointWanted;
    return call.ranks->run(request, [](const std::string& text) { printOut(labelled(text)); });
  }

  /// Goes on with a run that was stopped.
  ExitStatus resume() const {
    const Checkpoint checkpoint = readCheckpoint(resumed);
    if (!scene.empty()) requireSameScene(checkpoint, readScene(scene, {}), resumed);
    return run(sceneOf(checkpoint), resumed, &checkpoint);
  }

  ExitStatus run(const Scene& description, const std::filesystem::path& results, const Checkpoint* from) const {
    RunOptions options;
    options.folder = results;
    options.resume = from;
    options.progress = !quiet && !live;
    options.interrupt = &interrupted;
    options.checkpoint = &checkpointWanted;
    std::optional<LiveWatch> watch;
    if (live) options.listener = &watch.emplace(results, neededReportWriters().ofRun, !quiet);
    options.provenance = provenanceOf(commandText(), scene);
    Body body = sceneBody(description, sceneMesh(description, options.notes), threads);
    for (std::string& note : bodyNotes(body)) options.notes.push_back(std::move(note));
    const RunResult result = runScene(description, body, options);
    watch.reset();
    std::string page;
    try {
      if (report || live)
        page = reportText(
            neededReportWriters().ofRun({.folder = options.folder, .output = {}, .frames = 0, .live = nullptr}));
    } catch (const std::exception& fault) {
      complain(
          fmt::format("--{}: the results are there, but the page is not: {}", live ? "live" : "report", fault.what()),
          result.exitStatus());
    }
    try {
      if (!quiet) printOut(labelled(summaryText(description, body, result, options.folder, page)));
    } catch (const InputError&) {
      if (!result.canGoOn()) throw;  // the terminal may be what is gone
    }
    if (result.reason == ExitReason::failed) return complain(result.reasonText, result.exitStatus());
    return result.exitStatus();
  }
};

}  // namespace

std::unique_ptr<Command> runCommand(const Call& call) { return std::make_unique<RunCommand>(call); }

}  // namespace ringwatch
