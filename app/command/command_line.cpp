#include <ringwatch/app/command/command_line.h>

#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <map>
#include <new>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <ringwatch/app/command/advise.h>
#include <ringwatch/app/command/audit.h>
#include <ringwatch/app/command/compare.h>
#include <ringwatch/app/command/examples.h>
#include <ringwatch/app/command/exit_status.h>
#include <ringwatch/app/command/help.h>
#include <ringwatch/app/command/init.h>
#include <ringwatch/app/command/inspect.h>
#include <ringwatch/app/command/integrator_catalog.h>
#include <ringwatch/app/command/live_watch.h>
#include <ringwatch/app/command/number_text.h>
#include <ringwatch/app/command/process.h>
#include <ringwatch/app/command/progress.h>
#include <ringwatch/app/command/provenance.h>
#include <ringwatch/app/command/rank_program.h>
#include <ringwatch/app/command/reference.h>
#include <ringwatch/app/command/scale_mass.h>
#include <ringwatch/app/command/schema.h>
#include <ringwatch/app/command/suggest.h>
#include <ringwatch/app/command/verify.h>
#include <ringwatch/app/output/report.h>
#include <ringwatch/app/report/run_report.h>
#include <ringwatch/app/run/checkpoint.h>
#include <ringwatch/app/run/runner.h>
#include <ringwatch/app/scene/body_notes.h>
#include <ringwatch/app/scene/scene_keys.h>
#include <ringwatch/app/scene/scene_mesh.h>
#include <ringwatch/base/atomic_file.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/nearest_name.h>
#include <ringwatch/base/user_text.h>
#include <ringwatch/integrators/integrator.h>
#include <ringwatch/meshes/check_texts.h>
#include <ringwatch/meshes/mesh_io.h>
#include <ringwatch/meshes/modify/repair.h>
#include <ringwatch/meshes/quality.h>
#include <ringwatch/monitor/metrics/metrics.h>

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

/// Where the help of a command sends for what is not its own.
std::string seeTopics(std::string_view topics) { return fmt::format("More: ringwatch help {}\n", topics); }

/// What the help of every command says of its exit status.
constexpr const char* exitStatusHint =
    "\nExit status: 0 when all is well; ringwatch help exit-status has the table of the others.";

std::string mainFooter() {
  return std::string(unitsText) + "\n" + findHelpTopic("exit-status")->text() +
         "\n"
         "Examples:\n"
         "  ringwatch mesh generate bar --size 0.2 0.04 0.04 --cells 20 4 4 -o bar.msh\n"
         "  ringwatch inspect bar.msh --young 30e3 --poisson 0.3 --density 1000 --metric all --global\n"
         "  ringwatch run examples/stretch_bar.toml --out out/stretch_bar\n"
         "  ringwatch report out/stretch_bar\n"
         "  ringwatch compare examples/swinging_bar.toml --integrators all --out out/compare\n"
         "  ringwatch run scene.toml --set integrator.step=1e-4 --set output.every=0.01\n\n"
         "Topics of ringwatch help TOPIC:\n" +
         helpTopicListing();
}

/// A word of a message is shown to this length: file names fit in, and no argument fills the screen.
constexpr std::size_t longestWord = 400;

/// A text on one line, with every word shortened: what reaches standard error must not break it.
std::string oneLine(std::string text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  std::string result;
  for (char c : text) {
    const bool space = c == '\n' || c == '\r' || c == '\t';
    if (!space || (!result.empty() && result.back() != ' '))
      result += space ? ' ' : static_cast<unsigned char>(c) < 0x20 ? '?' : c;
  }
  for (std::size_t begin = 0; begin < result.size();) {
    const std::size_t end = std::min(result.find(' ', begin), result.size());
    if (end - begin > longestWord) {
      const std::string word = shortened(std::string_view(result).substr(begin, end - begin), longestWord);
      result.replace(begin, end - begin, word);
      begin += word.size() + 1;
    } else {
      begin = end + 1;
    }
  }
  return result;
}

/// Whether this process says what is wrong: of several that share a run one does.
bool speaks = true;

/// To standard error. A closed standard error does not change how the program ends.
void tell(const std::string& text) { std::fwrite(text.data(), 1, text.size(), stderr); }

ExitStatus complain(const std::string& text, ExitStatus status) {
  if (speaks) tell(fmt::format("ringwatch: {}\n", oneLine(text)));
  return status;
}

/// Human-readable text or JSON, to standard output. Throws when it cannot be written, e.g. on a full disk.
void printOut(const std::string& text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
    throw InputError("cannot write to standard output");
}

/// --json FILE, which every command that finds numbers has.
struct JsonOption {
  std::string path;

  void declare(CLI::App& command, const char* what) {
    command
        .add_option("--json", path,
                    fmt::format("write the {} to this file; - for standard output, and nothing else there", what))
        ->type_name("FILE");
  }
  bool takesStandardOutput() const { return path == "-"; }
  /// Writes the file, if one is wanted.
  void save(const nlohmann::ordered_json& json) const {
    if (!path.empty() && !takesStandardOutput()) writeFileAtomically(path, json.dump(2) + "\n");
  }
  /// Prints the JSON, or the text and its conclusion.
  void print(const nlohmann::ordered_json& json, const std::string& text) const {
    printOut(takesStandardOutput() ? json.dump(2) + "\n" : text + conclusionLine(json));
  }
  void write(const nlohmann::ordered_json& json, const std::string& text) const {
    save(json);
    print(json, text);
  }
};

/// What the program says of a page that it wrote.
std::string reportText(const ReportResult& report) {
  std::string text = fmt::format("wrote {}: {:.2f} MB", report.file.string(), 1e-6 * static_cast<double>(report.bytes));
  if (report.framesOfRun > 0) text += fmt::format(", {} of {} frames", report.frames, report.framesOfRun);
  text += "\n";
  for (const std::string& note : report.notes) text += fmt::format("note: {}\n", note);
  return text;
}

/// Numbers of a command with what its page says of where they come from.
nlohmann::ordered_json withProvenance(nlohmann::ordered_json json, const std::string& typed,
                                      const std::filesystem::path& scene) {
  json["version"] = std::string(programVersion());
  json["provenance"] = provenanceOf(typed, scene);
  return json;
}

/// The writers of pages; in a program without them nothing gets here, see main.cpp.
const ReportWriters& neededReportWriters() {
  if (const ReportWriters* writers = reportWriters()) return *writers;
  throw InputError("this program writes no pages; call ringwatch");
}

/// An option that is a time, s: a number or a fraction, such as 1/60.
template <class Time>
CLI::Option* addTime(CLI::App& command, const std::string& option, Time& time, const std::string& help) {
  return command.add_option_function<std::string>(
      option, [&time, option](const std::string& text) { time = parsePositiveNumber(text, option); }, help);
}

constexpr const char* pageHelp = "write one HTML page about it to this file, which opens from disk in any browser";

/// A word in single quotes, as a shell takes it.
std::string quoted(const std::string& word) {
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? "'\\''" : std::string(1, c);
  return text + "'";
}

/// The same, without quotes where none are needed.
std::string shellWord(const std::string& word) {
  const bool plain = !word.empty() && word.find_first_of(" \t\n'\"$`\\<>|&;()*?[]#~{}!") == std::string::npos;
  return plain ? word : quoted(word);
}

/// What was typed, for the provenance of a page.
std::string commandTyped(int argc, char** argv) {
  std::string text = "ringwatch";
  for (int i = 1; i < argc; ++i) text += " " + shellWord(argv[i]);
  return text;
}

struct ReportCommand {
  ReportOptions options;
  std::string folder, output;

  void declare(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("report", "write one page that says which element of a run is in the way, when and why");
    command->add_option("DIR", folder, "folder of a run")->required()->type_name("DIR");
    command->add_option("--out", output, "file to write (default: report.html in DIR)")->type_name("FILE");
    command->add_option("--frames", options.frames, "most frames in the page (default: as many as keep it small)")
        ->check(CLI::Range(1, 100000));
    command->footer(
        std::string(
            "The page is one HTML file, and asks for nothing from anywhere: it opens from disk in any browser.\n") +
        exitStatusHint);
  }

  ExitStatus execute() {
    options.folder = folder;
    options.output = output;
    const ReportResult report = neededReportWriters().ofRun(options);
    printOut(fmt::format("{}: {}\n", report.title, report.sentence) + reportText(report));
    return ExitStatus::done;
  }
};

/// launch.h reads it, before this program is the one that it asks for.
void declareRanks(CLI::App& command, std::string& wanted) {
  command
      .add_option("--ranks", wanted,
                  "whether processes that a launcher such as mpirun has started share the work: auto (where there are "
                  "several), yes or no (each does it alone); see docs/cluster.md")
      ->type_name("WHEN")
      ->check(CLI::IsMember({"auto", "yes", "no"}));
}

struct RunCommand {
  std::string scene, folder, resumed;
  std::vector<std::string> overrides;
  int threads = 0;
  bool quiet = false, helpScene = false, requireCertified = false, report = false, live = false;
  std::string ranksWanted = "auto";
  const RankProgram* ranks = nullptr;

  void declare(CLI::App& app) {
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
  }

  /// The command again, with all that the results depend on.
  std::string commandText() const {
    std::string text = "ringwatch run " + (resumed.empty() ? shellWord(scene) : "--resume " + shellWord(resumed));
    for (const std::string& setting : overrides) text += " --set " + quoted(setting);
    if (requireCertified) text += " --require-certified";
    if (threads > 0) text += fmt::format(" --threads {}", threads);
    return text;
  }

  ExitStatus execute() const {
    if (helpScene) {
      printOut(sceneHelp());
      return ExitStatus::done;
    }
    requireWhatGoesTogether();
    const InterruptGuard guard;  // while the mesh is read, too
    if (ranks) return runOnRanks();
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
    if (ranks && (report || live))
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
    return ranks->run(request, [](const std::string& text) { printOut(text); });
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
    // What ended it is what it says; what is missing behind that is of no moment.
    const bool cutShort = result.canGoOn();
    try {
      std::string page;
      if (report || live)
        page = reportText(
            neededReportWriters().ofRun({.folder = options.folder, .output = {}, .frames = 0, .live = nullptr}));
      if (!quiet) printOut(summaryText(description, body, result, options.folder, page));
    } catch (const InputError&) {
      if (!cutShort) throw;  // the terminal may be what is gone
    }
    if (result.reason == ExitReason::failed) return complain(result.reasonText, result.exitStatus());
    return result.exitStatus();
  }
};

/// Makes the folder of --out, unless it is there or none is wanted ("").
void makeFolderOfPictures(const std::string& folder) {
  if (folder.empty()) return;
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    throw InputError(fmt::format("--out: cannot write {}: {}; choose another folder", folder, error.message()));
}

/// Writes the pictures of a report into a folder.
void drawInto(const std::string& folder, const StudyReport& report) {
  for (const std::string& note : drawFigures(report, folder)) tell(fmt::format("note: {}\n", note));
}

struct CompareCommand {
  CompareOptions options;
  JsonOption json;
  std::string folder, page, typed;

  void declare(CLI::App& app) {
    CLI::App* command = app.add_subcommand("compare", "run a scene with several integrators: error against cost");
    command->add_option("SCENE", options.scene, "scene file (TOML); its motion is what is computed, to its end")
        ->required()
        ->type_name("SCENE");
    command->add_option("--integrators", options.integrators, "names, separated by commas, or all (default: all)")
        ->type_name("INTEGRATORS")
        ->delimiter(',')
        ->allow_extra_args(false);
    command
        ->add_option("--handlers", options.handlers,
                     "handlers on verlet, separated by commas, or all (default: none); options from the scene")
        ->type_name("HANDLERS")
        ->delimiter(',')
        ->allow_extra_args(false);
    command
        ->add_option_function<std::vector<std::string>>(
            "--step",
            [this](const std::vector<std::string>& steps) {
              for (const std::string& step : steps) options.steps.push_back(parsePositiveNumber(step, "--step"));
            },
            "steps, s, separated by commas (default: a range for each integrator, from its largest)")
        ->delimiter(',')
        ->allow_extra_args(false);
    command->add_option("--set", options.overrides, "section.key=value, replaces the value of the scene")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    command->add_option("--threads", options.threads, "threads (default: 1, so that times compare)")
        ->check(CLI::Range(0, 4096));
    json.declare(*command, "results");
    command->add_option("--out", folder, "folder for pictures, made when missing")->type_name("DIR");
    command->add_option("--report", page, pageHelp)->type_name("FILE");
    command->footer(
        "Against a reference that is refined until it no longer changes. Errors are those of the positions at the end, "
        "relative\nto the displacement.\n" +
        seeTopics("integrators | handlers | scene") + exitStatusHint);
  }

  ExitStatus execute() const {
    CompareResult result = compareScene(options);
    json.save(result.json);
    makeFolderOfPictures(folder);
    if (!folder.empty()) drawInto(folder, result.report);
    if (!page.empty()) {
      const ReportResult written =
          neededReportWriters().ofStudies({"Comparison on " + options.scene.filename().string(),
                                           result.found,
                                           {result.report},
                                           result.json,
                                           provenanceOf(typed, options.scene)},
                                          page);
      result.text += reportText(written);
    }
    json.print(result.json, studyText(result.report) + result.text);
    return ExitStatus::done;
  }
};

/// How masses and tangents of elements are made.
void declareMatrices(CLI::App& command, std::string& lumping, std::vector<std::string>& rules) {
  command
      .add_option("--lumping", lumping,
                  fmt::format("how an element's mass goes to its nodes (default: {}): {}",
                              lumpingNames.nameOf(InspectOptions::usualLumping), lumpingNames.listing()))
      ->type_name("LUMPING");
  command.add_option("--rule", rules, "ELEMENT=RULE, a quadrature rule, e.g. hex8=selective; may be given again")
      ->type_name("ELEMENT=RULE")
      ->allow_extra_args(false);
}

struct InspectCommand {
  InspectOptions options;
  JsonOption json;
  std::string picture, vtu, lumping, certificate, page, typed, stretch;
  std::string ranksWanted = "auto";
  const RankProgram* ranks = nullptr;

  void declare(CLI::App& app) {
    CLI::App* command = app.add_subcommand("inspect", "report the steps that a mesh can take, and what limits them");
    command
        ->add_option("MESH", options.mesh,
                     "mesh file: " + readableExtensions() + "; a MuJoCo model, .xml; or the folder of a run")
        ->required()
        ->type_name("MESH");
    for (const SceneKey& key : sceneKeys())
      if (key.section == "material" && isLawParameter(key.key))
        command->add_option_function<double>(
            "--" + key.key, [this, name = key.key](double value) { options.parameters.set(name, value); },
            fmt::format("{}{}{}{}{}", key.help, key.unit.empty() ? "" : ", ", key.unit,
                        key.range.text().empty() ? "" : ", ", key.range.text()));
    command->add_option("--density", options.density,
                        "density, kg/m3; it and the parameters of the law are required with a mesh file");
    command
        ->add_option("--model", options.model,
                     fmt::format("constitutive law (default: {})", InspectOptions::usualModel))
        ->type_name("LAW");
    command
        ->add_option("--displacement", options.displacement,
                     "field of displacements, m, in a .vtu file: inspect that deformed state")
        ->type_name("FIELD");
    command->add_option("--frame", options.frame,
                        "inspect this frame of a run, counted from 1; material, supports, integrator and damping are "
                        "those of its scene unless given");
    command
        ->add_option(
            "--integrator", options.integrator,
            fmt::format("integrator whose stability limit counts (default: {})", InspectOptions::usualIntegrator))
        ->type_name("INTEGRATOR");
    declareMatrices(*command, lumping, options.rules);
    addTime(*command, "--step", options.step,
            "list the elements that need a smaller step than this, s, and count what a handler would take");
    command->add_option("--metric", options.metrics, "metrics, separated by commas, or all")
        ->type_name("METRICS")
        ->delimiter(',')
        ->allow_extra_args(false);
    command
        ->add_option(
            "--fix", options.fix,
            "nodes that are held, by a condition or set:NAME, and behind a colon the components: \"x < 1e-6\", "
            "\"set:left:x\"; may be given again")
        ->type_name("CONDITION")
        ->allow_extra_args(false);
    command->add_flag("--global", options.global, "also the exact critical step, by a global eigenvalue");
    command->add_option("--lanczos", options.lanczos,
                        "also a step that is safe but for this probability, e.g. 1e-9, within 1 %, by Lanczos");
    command->add_flag("--exact", options.exact,
                      "also the critical step between two proven sides, 1e-6 apart where rounding allows, by a sparse "
                      "factorisation; says on a terminal what that takes");
    command->add_option("--stretch", stretch,
                        "a:b, also a step that is proven for every state whose stretches stay between these two, "
                        "e.g. 0.7:1.5");
    addTime(*command, "--prove", options.prove,
            "prove that this step, s, is stable, by a sparse factorisation; exit status 1 when it is proven "
            "unstable, 3 when neither is proven");
    json.declare(*command, "numbers");
    command->add_flag("--distribution", options.distribution,
                      "histogram and cumulative share of the elements' steps by metric; the ten worst elements");
    command->add_option("--picture", picture, "draw the distribution into this file, .svg or .png")->type_name("FILE");
    command->add_option("--vtu", vtu, "write the mesh with the steps by each metric for ParaView")->type_name("FILE");
    command
        ->add_option("--certificate", certificate,
                     "write a proof that ringwatch-check can check: of the bracket by the nodal bound, or of what "
                     "--exact or --prove finds")
        ->type_name("FILE");
    command->add_option("--report", page, pageHelp)->type_name("FILE");
    command->add_option("--threads", options.threads, "threads (default: as many as the mesh has work for)")
        ->check(CLI::Range(0, 4096));
    declareRanks(*command, ranksWanted);
    command->footer(std::string(unitsText) + "\n" + seeTopics("laws | integrators | metrics | formats") +
                    exitStatusHint);
  }

  ExitStatus execute() {
    if (!vtu.empty()) options.vtu = vtu;
    if (!certificate.empty()) options.certificate = certificate;
    if (!stretch.empty()) options.stretch = parseStretchRange(stretch, "--stretch");
    if (!picture.empty()) options.picture = picture;
    if (!lumping.empty()) options.lumping = lumpingNames.valueOf("--lumping", lumping);
    std::string written;
    if (!page.empty())
      options.page = [&](const Inspection& found) {
        Inspection whole = found;
        whole.json = withProvenance(std::move(whole.json), typed, "");
        written = reportText(neededReportWriters().ofInspection(whole, page));
      };
    InspectResult result = ranks ? ranks->inspect(options) : inspectMesh(options);
    result.text += written;
    if (ranks && !ranks->speaks()) return result.status;
    json.write(result.json, result.text);
    return result.failure.empty() ? result.status : complain(result.failure, ExitStatus::unstable);
  }
};

struct AuditCommand {
  AuditOptions options;
  JsonOption json;
  std::string page, junit, typed, lumping;

  void declare(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("audit", "say where a run of another program left proven ground, from its results");
    command
        ->add_option("RESULTS", options.results,
                     "results: CalculiX .frd (text), a .pvd, or .vtu or legacy .vtk files in their order")
        ->required();
    command->add_option("--scene", options.scene, "scene or deck with the mesh, the materials and what is held");
    for (const SceneKey& key : sceneKeys())
      if (key.section == "material" && isLawParameter(key.key))
        command->add_option_function<double>(
            "--" + key.key, [this, name = key.key](double value) { options.parameters.set(name, value); },
            key.help + (key.unit.empty() ? "" : ", " + key.unit));
    command->add_option("--density", options.density, "density, kg/m3");
    command->add_option("--model", options.model, "constitutive law (default: the scene's, else stvk)");
    command->add_option("--displacement", options.displacement,
                        "field of the displacement, m (default: the usual names; without any, the points are taken "
                        "for positions)");
    addTime(*command, "--step", options.step,
            "step that the run took, s (default: by the times and increments of the results)");
    command->add_option("--integrator", options.integrator,
                        "integrator whose limit counts (default: symplectic-euler)");
    command->add_option("--limit", options.limit, "largest stable h omega of theirs, instead of --integrator");
    command->add_option("--fix", options.fix, "nodes that are held, as with ringwatch inspect; may be given again")
        ->allow_extra_args(false);
    declareMatrices(*command, lumping, options.rules);
    command->add_option("--every", options.every, "every so many states (default: 1)")->check(CLI::Range(1, 1000000));
    command->add_flag("--all", options.all, "a line of the table for every state; --json always has them");
    json.declare(*command, "numbers");
    command->add_option("--report", page, pageHelp)->type_name("FILE");
    command->add_option("--junit", junit, "a test case for each state in JUnit's XML, which CI systems show")
        ->type_name("FILE");
    command->add_option("--threads", options.threads, "threads (default: as many as the mesh can use)")
        ->check(CLI::Range(0, 4096));
    command->footer(
        "Exit status 1 where a step was proven unstable, an element inverted or a state was lost; 3 where some step "
        "was "
        "not proven.\n" +
        seeTopics("laws | integrators | decks") + exitStatusHint);
  }

  ExitStatus execute() {
    std::string written;
    if (!page.empty())
      options.page = [&](const Audit& found) {
        Audit whole = found;
        whole.json = withProvenance(std::move(whole.json), typed, options.scene);
        written = reportText(neededReportWriters().ofAudit(whole, page));
      };
    if (!lumping.empty()) options.lumping = lumpingNames.valueOf("--lumping", lumping);
    const AuditResult result = auditResults(options);
    if (!junit.empty()) writeFileAtomically(junit, junitText(result.json));
    json.write(result.json, result.text + written);
    return result.status;
  }
};

/// SCENE and the options of every question that is asked of a scene before it runs.
template <class Question>
void declareQuestion(CLI::App& command, Question& options, JsonOption& json) {
  command.add_option("SCENE", options.scene, "scene file (TOML), deck or MuJoCo model; see ringwatch help scene")
      ->required();
  command.add_option("--set", options.overrides, "section.key=value, replaces the value of the scene")
      ->allow_extra_args(false);
  json.declare(command, "numbers");
  command.add_option("--threads", options.threads, "threads (default: as many as the mesh can use)")
      ->check(CLI::Range(0, 4096));
}

struct SuggestCommand {
  SuggestOptions options;
  JsonOption json;
  std::string stretch;

  void declare(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("suggest", "say how many steps a scene needs in a time, such as that of a picture");
    declareQuestion(*command, options, json);
    addTime(*command, "--frame", options.frame,
            "the time, s: a number or a fraction, such as 1/60 (default: the scene's step, which is answered for)");
    command->add_option("--stretch", stretch,
                        "a:b, also for every state whose stretches stay between these two, e.g. 0.7:1.5");
    command->footer(std::string(unitsText) + "\n" + seeTopics("scene | integrators") + exitStatusHint);
  }

  ExitStatus execute() {
    if (!stretch.empty()) options.stretch = parseStretchRange(stretch, "--stretch");
    const SuggestResult result = suggestSteps(options);
    json.write(result.json, result.text);
    return ExitStatus::done;
  }
};

struct ScaleMassCommand {
  ScaleMassOptions options;
  JsonOption json;

  void declare(CLI::App& app) {
    CLI::App* command = app.add_subcommand("scale-mass", "say how little added mass a scene needs for a step");
    declareQuestion(*command, options, json);
    addTime(*command, "--step", options.step, "the step to be proven, s: a number or a fraction")->required();
    command->footer("A run adds mass with handler.method = \"mass-scaling\", at the nodes that the handler chooses.\n" +
                    std::string(unitsText) + "\n" + seeTopics("scene | handlers") + exitStatusHint);
  }

  ExitStatus execute() {
    const ScaleMassResult result = planMass(options);
    json.write(result.json, result.text);
    return ExitStatus::done;
  }
};

struct AdviseCommand {
  AdviseOptions options;
  JsonOption json;

  void declare(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("advise", "say how a scene can take a step that is too large for it, by trials and runs");
    declareQuestion(*command, options, json);
    addTime(*command, "--step", options.step, "the step to be taken, s: a number or a fraction (default: the scene's)");
    addTime(*command, "--time", options.time,
            fmt::format("time of each trial, s (default: {} steps, or the scene's end)", adviseSteps));
    command
        ->add_option("--run-steps", options.runSteps,
                     fmt::format("steps of the runs of what a trial leaves, at most (default: {}, or as many as the "
                                 "scene has; 0: no runs)",
                                 options.runSteps))
        ->check(CLI::Range(std::int64_t{0}, std::int64_t{100'000'000}));
    command
        ->add_option("--error", options.error,
                     "error that is allowed in a trial and in a run, of the displacement (default: 0.01)")
        ->check(CLI::Range(1e-6, 1.0));
    command->footer(
        "It tries the scene's integrator at its safe step, every handler and every implicit integrator at the step, "
        "and\n"
        "runs the scene with those that err little enough and are not much slower.\n" +
        std::string(unitsText) + "\n" + seeTopics("scene | handlers | integrators") + exitStatusHint);
  }

  ExitStatus execute() {
    const AdviseResult result = adviseScene(options);
    json.write(result.json, result.text);
    return ExitStatus::done;
  }
};

struct MeshCommand {
  std::string kind, output, input, target, checked;
  std::map<std::string, std::vector<std::string>> parameters;  // of generators, as given
  std::string join;                                            // a number, as given
  bool allProblems = false, binary = false;
  CLI::App *generate = nullptr, *convert = nullptr, *check = nullptr, *repair = nullptr;

  void declare(CLI::App& app) {
    CLI::App* command = app.add_subcommand("mesh", "generate, convert, check or repair a mesh");
    command->require_subcommand(1);
    command->footer(exitStatusHint);
    generate = command->add_subcommand("generate", "make a mesh");
    generate->add_option("KIND", kind, "kind of mesh")->required()->type_name("KIND");
    generate->add_option("-o,--output", output, "mesh file to write: " + writableExtensions())
        ->required()
        ->type_name("FILE");
    for (const SceneKey& key : generatorSceneKeys())
      generate->add_option("--" + key.key, parameters[key.key], key.help)->expected(1, 3)->delimiter(',');
    const auto declareBinary = [this](CLI::App& writing) {
      writing.add_flag("--binary", binary, "write .msh in binary (4.1), which ranks read in parts; without it as text");
    };
    declareBinary(*generate);
    generate->footer(
        fmt::format("Kinds: {}. Lists are written as --size 0.2 0.04 0.04 or --size 0.2,0.04,0.04.\n",
                    fmt::join(generatorNames(), ", ")) +
        "Example: ringwatch mesh generate bar --size 0.2 0.04 0.04 --cells 20 4 4 --element hex8 -o bar.msh\n" +
        "\nUnits, ranges and defaults of the parameters: ringwatch help generators");
    convert = command->add_subcommand("convert", "read a mesh and write it in another format");
    convert->add_option("IN", input, "mesh file: " + readableExtensions())->required()->type_name("MESH");
    convert->add_option("OUT", target, "mesh file to write: " + writableExtensions())->required()->type_name("FILE");
    declareBinary(*convert);
    check = command->add_subcommand("check", "list what is wrong with a mesh; exit status 1 when there is something");
    check->add_option("MESH", checked, "mesh file: " + readableExtensions())->required()->type_name("MESH");
    check->add_flag("--all", allProblems, "list every problem, not the first ten");
    repair = command->add_subcommand("repair", "mend the numbers of a mesh; exit status 1 when something is left");
    repair->add_option("IN", input, "mesh file: " + readableExtensions())->required()->type_name("MESH");
    repair->add_option("OUT", target, "mesh file to write: " + writableExtensions())->required()->type_name("FILE");
    repair
        ->add_option("--join", join,
                     "join nodes that lie closer to each other, m; 0: at one place; without it none are joined")
        ->type_name("DISTANCE");
    declareBinary(*repair);
    repair->footer(
        "Turns elements of the other handedness round, makes of an element that holds a node several times the\n"
        "wedge, pyramid or tetrahedron that it is, leaves out elements that stand a second time and nodes without\n"
        "elements, and puts nodes on edges into ringwatch's order. Sets are kept.");
  }

  ExitStatus execute() const {
    if (generate->parsed()) return executeGenerate();
    if (repair->parsed()) return executeRepair();
    return convert->parsed() ? executeConvert() : executeCheck();
  }

 private:
  ExitStatus executeGenerate() const {
    if (!findGenerator(kind)) {
      const std::vector<std::string> known = generatorNames();
      throw InputError(fmt::format("KIND: unknown {}; {}known are {}", inQuotes(kind), didYouMean(kind, known),
                                   fmt::join(known, ", ")));
    }
    nlohmann::ordered_json values = nlohmann::ordered_json::object();
    for (const auto& [name, texts] : parameters) {
      if (texts.empty()) continue;
      nlohmann::ordered_json list = nlohmann::ordered_json::array();
      for (const std::string& text : texts) list.push_back(numberOrText(text));
      values[name] = texts.size() == 1 ? list[0] : list;
      const std::string fault = generatorFault(kind, name, values[name]);
      if (!fault.empty()) throw InputError(fmt::format("--{}: {}", name, fault));
    }
    const Mesh mesh = generateMesh(kind, generatorArguments(values));
    write(mesh, output);
    printOut(fmt::format("{}: {} nodes, {}\n", output, mesh.nodeCount(), elementCounts(mesh)));
    return ExitStatus::done;
  }

  void write(const Mesh& mesh, const std::string& file) const {
    if (binary && !file.ends_with(".msh"))
      throw InputError(fmt::format("--binary: {} is not an .msh file; leave it out, or name one", file));
    writeMesh(mesh, file, binary ? MeshFormat::msh41Binary : MeshFormat::byExtension);
  }

  static nlohmann::ordered_json numberOrText(const std::string& text) {
    std::int64_t integer = 0;
    double value = 0;
    if (CLI::detail::lexical_cast(text, integer)) return integer;
    if (CLI::detail::lexical_cast(text, value) && std::isfinite(value)) return value;
    return text;
  }

  ExitStatus executeConvert() const {
    std::vector<std::string> notes;
    Mesh mesh = readMesh(input, &notes);
    // What is only numbered the other way is written right; a folded element stays what it is.
    Mesh turned = mesh;
    std::vector<std::string> turnedNotes;
    const std::vector<MeshProblem> problems = detail::turnAndCheck(turned, input, &turnedNotes);
    if (std::ranges::none_of(problems, [](const MeshProblem& p) { return p.kind == MeshProblem::Kind::inverted; })) {
      mesh = std::move(turned);
      notes.insert(notes.end(), turnedNotes.begin(), turnedNotes.end());
    }
    write(mesh, target);
    for (const std::string& note : notes) printOut("note: " + note + "\n");
    printOut(fmt::format("{}: {} nodes, {}\n", target, mesh.nodeCount(), elementCounts(mesh)));
    return ExitStatus::done;
  }

  /// The first problems, or all of them, one a line.
  static std::string problemLines(const std::vector<MeshProblem>& problems, bool all) {
    constexpr std::size_t shownAtFirst = 10;
    const std::size_t shown = all ? problems.size() : std::min(shownAtFirst, problems.size());
    std::string text;
    for (std::size_t i = 0; i < shown; ++i)
      text += fmt::format("{}: {}\n", problemName(problems[i].kind), problems[i].text);
    if (shown < problems.size()) text += fmt::format("… and {} more; --all lists them\n", problems.size() - shown);
    return text;
  }

  static std::string kindsOf(const std::vector<MeshProblem>& problems) {
    std::map<std::string_view, std::size_t> counts;
    for (const MeshProblem& problem : problems) ++counts[problemName(problem.kind)];
    std::string kinds;
    for (const auto& [name, count] : counts) kinds += fmt::format("{}{} {}", kinds.empty() ? "" : ", ", count, name);
    return kinds;
  }

  ExitStatus executeRepair() const {
    std::optional<double> distance;
    if (!join.empty()) {
      double value = 0;
      if (!CLI::detail::lexical_cast(join, value) || !(value >= 0) || !std::isfinite(value))
        throw InputError(fmt::format("--join: {}; a distance in m is needed, 0 or more", inQuotes(join)));
      distance = value;
    }
    std::vector<std::string> notes;
    const Mesh mesh = readMesh(input, &notes);
    const RepairedMesh repaired = repairMesh(mesh, input, distance);
    write(repaired.mesh, target);
    for (std::string& note : meshNotes(repaired.mesh, target)) notes.push_back(std::move(note));
    std::string text;
    for (const std::string& note : notes) text += "note: " + note + "\n";
    for (const std::string& line : repaired.done) text += line + "\n";
    if (repaired.done.empty()) text += fmt::format("{}: nothing more to repair\n", input);
    text += problemLines(repaired.problems, true);
    if (distance)
      text += fmt::format("{}: the volume was {:.10g} m³ and is {:.10g} m³\n", target, meshVolume(mesh),
                          meshVolume(repaired.mesh));
    text += fmt::format("{}: {} nodes, {}{}\n", target, repaired.mesh.nodeCount(), elementCounts(repaired.mesh),
                        repaired.problems.empty() ? "" : "; left: " + kindsOf(repaired.problems));
    printOut(text);
    return repaired.problems.empty() ? ExitStatus::done : ExitStatus::unstable;
  }

  ExitStatus executeCheck() const {
    std::vector<std::string> notes;
    const std::vector<MeshProblem> problems = checkMeshFile(checked, &notes);
    std::string text;
    for (const std::string& note : notes) text += "note: " + note + "\n";
    text += problemLines(problems, allProblems);
    text += problems.empty()       ? fmt::format("{}: nothing wrong\n", checked)
            : problems.size() == 1 ? fmt::format("{}: 1 problem\n", checked)
                                   : fmt::format("{}: {} problems: {}\n", checked, problems.size(), kindsOf(problems));
    printOut(text);
    return problems.empty() ? ExitStatus::done : ExitStatus::unstable;
  }
};

struct VerifyCommand {
  std::vector<std::string> studies;
  JsonOption json;
  std::string folder, page, typed;
  bool quick = false;

  void declare(CLI::App& app) {
    CLI::App* command = app.add_subcommand("verify", "hold elements and integrators to analytic answers");
    command->add_option("STUDY", studies, "studies to run, or all (default: all)")->type_name("STUDY");
    json.declare(*command, "results");
    command->add_option("--out", folder, "folder for pictures, made when missing")->type_name("DIR");
    command->add_option("--report", page, pageHelp)->type_name("FILE");
    command->add_flag("--quick", quick,
                      "coarser and shorter, on one thread: about a minute of processor time for all studies");
    command->footer("Exit status 1 when a check fails; ringwatch help exit-status has the table.\n\n" +
                    findHelpTopic("studies")->text());
  }

  ExitStatus execute() const {
    bool passed = true;
    ProgressLine line(true);
    StudyProgress progress;
    progress.begins = [&](const StudyInfo& study, std::size_t number, std::size_t count) {
      if (number == 1) makeFolderOfPictures(folder);
      line.announce(fmt::format("study {} of {}: {}", number, count, study.name));
    };
    // A study's results are there when it ends: all together take long.
    progress.ended = [&](const StudyReport& report) {
      line.clear();
      passed = passed && report.passed();
      if (!json.takesStandardOutput()) printOut(studyText(report) + "\n");
      if (!folder.empty()) drawInto(folder, report);
    };
    const std::vector<StudyReport> reports =
        runStudies(studies, quick ? StudyEffort::quick : StudyEffort::full, progress);
    const nlohmann::ordered_json found = studiesJson(reports);
    json.save(found);
    std::string written;
    if (!page.empty())
      written = reportText(
          neededReportWriters().ofStudies({"Verification", {}, reports, found, provenanceOf(typed, "")}, page));
    json.print(found, written);
    return passed ? ExitStatus::done : ExitStatus::unstable;
  }
};

struct HelpCommand {
  std::vector<std::string> words;

  void declare(CLI::App& app) {
    CLI::App* command = app.add_subcommand("help", "explain a topic or a command");
    command->add_option("TOPIC", words, "one of the topics below, or a command such as run or mesh generate")
        ->type_name("TOPIC");
    command->footer("Topics:\n" + helpTopicListing());
  }

  ExitStatus execute(const CLI::App& app) const {
    if (const HelpTopic* topic = words.empty() ? nullptr : findHelpTopic(words[0])) {
      printOut(textOf(*topic));
      return ExitStatus::done;
    }
    const auto isCommand = [](const CLI::App*) { return true; };
    const CLI::App* command = &app;
    std::string name = app.get_name();
    for (const std::string& word : words) {
      std::vector<std::string> known;
      const CLI::App* found = nullptr;
      for (const CLI::App* next : command->get_subcommands(isCommand)) {
        known.push_back(next->get_name());
        if (next->get_name() == word) found = next;
      }
      if (command == &app)
        for (const HelpTopic& topic : helpTopics()) known.emplace_back(topic.name);
      if (!found)
        throw InputError(known.empty() ? fmt::format("help: {} has no command {}", name, inQuotes(word))
                                       : fmt::format("help: unknown topic {}; {}known are {}", inQuotes(word),
                                                     didYouMean(word, known), fmt::join(known, ", ")));
      command = found;
      name += " " + word;
    }
    printOut(app.get_formatter()->make_help(command, name, CLI::AppFormatMode::Normal));
    return ExitStatus::done;
  }

 private:
  std::string textOf(const HelpTopic& topic) const {
    if (words.size() == 1) return topic.text();
    if (topic.part == nullptr || words.size() > 2)
      throw InputError(fmt::format("help: unknown argument {}; write ringwatch help {}{}", inQuotes(words.back()),
                                   topic.name, topic.part == nullptr ? "" : " " + words[1]));
    const std::string text = topic.part(words[1]);
    if (text.empty())
      throw InputError(fmt::format("help: {} has no {}; {}known are {}", topic.name, inQuotes(words[1]),
                                   didYouMean(words[1], topic.parts()), fmt::join(topic.parts(), ", ")));
    return text;
  }
};

struct SchemaCommand {
  std::string name;

  void declare(CLI::App& app) {
    CLI::App* command = app.add_subcommand("schema", "print the JSON Schema of a scene or of a JSON file");
    command->add_option("SCHEMA", name, "one of those below; without it they are listed")->type_name("SCHEMA");
    command->footer("Schemas:\n" + listing());
  }

  ExitStatus execute() const {
    printOut(name.empty() ? listing() : schemaOf(name).dump(2) + "\n");
    return ExitStatus::done;
  }

 private:
  static std::string listing() {
    std::string text;
    for (const SchemaInfo& schema : allSchemas()) text += fmt::format("  {:<12} {}\n", schema.name, schema.help);
    return text;
  }
};

struct ExamplesCommand {
  std::string name, folder = ".";

  void declare(CLI::App& app) {
    CLI::App* command = app.add_subcommand("examples", "list the example scenes, or copy one to try it");
    command->add_option("NAME", name, "one of those below, or all; without it they are listed")->type_name("NAME");
    command->add_option("--out", folder, "folder to write it to, made when missing (default: the current one)")
        ->type_name("DIR");
    command->footer("Examples:\n" + exampleListing());
  }

  ExitStatus execute() const {
    printOut(name.empty() ? exampleListing() : copyExamples(name, folder));
    return ExitStatus::done;
  }
};

struct InitCommand {
  InitOptions options;

  void declare(CLI::App& app) {
    CLI::App* command = app.add_subcommand("init", "write a commented scene that runs; asks on a terminal");
    command->add_option("SCENE", options.scene, "file to write (default: scene.toml)")->type_name("SCENE");
    command->add_option("--mesh", options.mesh, "mesh file (default: a bar of rubber)")->type_name("MESH");
    command->add_option("--young", options.young,
                        "Young's modulus, Pa; with a mesh it, --poisson and --density are required");
    command->add_option("--poisson", options.poisson, "Poisson's ratio");
    command->add_option("--density", options.density, "density, kg/m3");
    command->add_option("--fix", options.fix, "nodes that are held (default: those of least x)")
        ->type_name("CONDITION");
    addTime(*command, "--end", options.end,
            "time that the run takes, s (default: ten times that of a pressure wave through the body)");
    command->footer(std::string(unitsText) + "\n" + seeTopics("scene | laws | generators") + exitStatusHint);
  }

  ExitStatus execute() const {
    const bool terminal = ::isatty(STDIN_FILENO) != 0 && ::isatty(STDOUT_FILENO) != 0;
    printOut(initScene(options, terminal ? askOnTerminal : Ask()));
    return ExitStatus::done;
  }

 private:
  static std::string askOnTerminal(const std::string& question) {
    printOut(question + ": ");
    std::string answer;
    if (!std::getline(std::cin, answer))
      throw InputError("init: no answer; give the options, see ringwatch init --help");
    return answer;
  }
};

struct ReferenceCommand {
  std::string folder;

  void declare(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("reference", "write reference pages, schemas, manual page and shell completion");
    command->add_option("DIR", folder, "folder to write them to, made when missing; laid out as share/ of a system")
        ->required()
        ->type_name("DIR");
    command->footer(std::string("All are made from what this program has.\n") + exitStatusHint);
  }

  ExitStatus execute(const CLI::App& app) const {
    for (const ReferenceFile& file : referenceFiles(app)) {
      const std::filesystem::path path = folder / file.path;
      std::error_code error;
      std::filesystem::create_directories(path.parent_path(), error);
      if (error) throw InputError(fmt::format("DIR: cannot write {}: {}", path.string(), error.message()));
      writeFileAtomically(path, file.text);
    }
    return ExitStatus::done;
  }
};

/// CLI11's message for a wrong usage, on one line, with the nearest known option or command.
std::string usageText(const CLI::App& app, const CLI::ParseError& fault) {
  std::string text = oneLine(fault.what());
  // An unknown command is reported by CLI11 as a missing one.
  const bool unknown = dynamic_cast<const CLI::ExtrasError*>(&fault) != nullptr ||
                       dynamic_cast<const CLI::RequiredError*>(&fault) != nullptr;
  if (unknown && !app.remaining(true).empty()) {
    const CLI::App* innermost = &app;
    while (!innermost->get_subcommands().empty()) innermost = innermost->get_subcommands().front();
    std::vector<std::string> known;
    for (const CLI::Option* option : innermost->get_options()) known.push_back(option->get_name());
    for (const CLI::App* command : innermost->get_subcommands([](const CLI::App*) { return true; }))
      known.push_back(command->get_name());
    const std::string extra = app.remaining(true).front();
    const std::string hint = didYouMean(extra, known);
    text = fmt::format("unknown argument {}{}", inQuotes(extra),
                       hint.empty() ? "" : "; " + hint.substr(0, hint.size() - 1));
  }
  return text + "; see ringwatch --help";
}

ExitStatus dispatch(int argc, char** argv, const RankProgram* ranks) {
  CLI::App app("ringwatch: how large a step can this explicit finite element run take, and what stands in the way",
               "ringwatch");
  app.set_version_flag("--version", "ringwatch " + std::string(programVersion()));
  app.require_subcommand(1);
  app.footer(mainFooter());
  RunCommand run;
  run.ranks = ranks;
  InspectCommand inspect;
  inspect.ranks = ranks;
  AuditCommand audit;
  SuggestCommand suggest;
  ScaleMassCommand scaleMass;
  AdviseCommand advise;
  MeshCommand mesh;
  VerifyCommand verify;
  CompareCommand compare;
  ReportCommand report;
  SchemaCommand schema;
  ReferenceCommand reference;
  ExamplesCommand examples;
  InitCommand init;
  HelpCommand help;
  help.declare(app);
  run.declare(app);
  inspect.declare(app);
  audit.declare(app);
  suggest.declare(app);
  scaleMass.declare(app);
  advise.declare(app);
  mesh.declare(app);
  verify.declare(app);
  compare.declare(app);
  report.declare(app);
  schema.declare(app);
  examples.declare(app);
  init.declare(app);
  reference.declare(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked) {  // --help and --version
    app.exit(asked);
    return ExitStatus::done;
  } catch (const CLI::ParseError& fault) {
    return complain(usageText(app, fault), ExitStatus::badInput);
  }
  inspect.typed = audit.typed = verify.typed = compare.typed = commandTyped(argc, argv);
  if (app.got_subcommand("help")) return help.execute(app);
  if (app.got_subcommand("run")) return run.execute();
  if (app.got_subcommand("inspect")) return inspect.execute();
  if (app.got_subcommand("audit")) return audit.execute();
  if (app.got_subcommand("suggest")) return suggest.execute();
  if (app.got_subcommand("scale-mass")) return scaleMass.execute();
  if (app.got_subcommand("advise")) return advise.execute();
  if (app.got_subcommand("verify")) return verify.execute();
  if (app.got_subcommand("report")) return report.execute();
  if (app.got_subcommand("schema")) return schema.execute();
  if (app.got_subcommand("reference")) return reference.execute(app);
  if (app.got_subcommand("compare")) return compare.execute();
  if (app.got_subcommand("examples")) return examples.execute();
  if (app.got_subcommand("init")) return init.execute();
  return mesh.execute();
}

}  // namespace

int runCommandLine(int argc, char** argv, const RankProgram* ranks) {
  speaks = !ranks || ranks->speaks();
  keepMemoryInReserve();
  holdStandardStreams();
  reportFileSizeLimit();
  const auto status = [&] {
    try {
      ExitStatus result = ExitStatus::done;
      onLargeStack([&] { result = dispatch(argc, argv, ranks); });
      return result;
    } catch (const InputError& fault) {
      return complain(fault.what(), ExitStatus::badInput);
    } catch (const NumericalError& fault) {
      return complain(fault.what(), ExitStatus::unstable);
    } catch (const RunFailed& fault) {
      return complain(fault.what(), ExitStatus::unstable);
    } catch (const std::bad_alloc&) {
      return complain("out of memory; use a smaller mesh or more memory", ExitStatus::badInput);
    } catch (const std::exception& fault) {
      return complain(fault.what(), ExitStatus::badInput);
    }
  }();
  return static_cast<int>(status);
}

}  // namespace ringwatch
