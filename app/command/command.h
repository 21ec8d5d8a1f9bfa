#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <ringwatch/app/output/exit_status.h>
#include <ringwatch/app/report/run_report.h>
#include <ringwatch/app/scene/number_text.h>
#include <ringwatch/base/units.h>

namespace ringwatch {

class RankProgram;

/// A call of the program.
struct Call {
  const CLI::App& app;                 // with all commands
  std::string typed;                   // by the user, as a shell takes it
  const RankProgram* ranks = nullptr;  // of several processes that share the work
};

/// A command: its options, and what it does with them.
struct Command {
  explicit Command(const Call& of) : call(of) {}
  virtual ~Command() = default;
  Command(const Command&) = delete;
  Command& operator=(const Command&) = delete;
  /// Adds it to the program, and returns what was added.
  virtual CLI::App* declare(CLI::App& app) = 0;
  virtual ExitStatus execute() = 0;

  const Call& call;
};

// One file a command; command_line.cpp lists them.
std::unique_ptr<Command> helpCommand(const Call& call);
std::unique_ptr<Command> runCommand(const Call& call);
std::unique_ptr<Command> inspectCommand(const Call& call);
std::unique_ptr<Command> auditCommand(const Call& call);
std::unique_ptr<Command> suggestCommand(const Call& call);
std::unique_ptr<Command> scaleMassCommand(const Call& call);
std::unique_ptr<Command> adviseCommand(const Call& call);
std::unique_ptr<Command> meshCommand(const Call& call);
std::unique_ptr<Command> verifyCommand(const Call& call);
std::unique_ptr<Command> judgeCommand(const Call& call);
std::unique_ptr<Command> compareCommand(const Call& call);
std::unique_ptr<Command> reportCommand(const Call& call);
std::unique_ptr<Command> schemaCommand(const Call& call);
std::unique_ptr<Command> examplesCommand(const Call& call);
std::unique_ptr<Command> initCommand(const Call& call);
std::unique_ptr<Command> referenceCommand(const Call& call);

// What several commands share.

/// Where the help of a command sends for what is not its own.
std::string seeTopics(std::string_view topics);
/// What the help of every command says of its exit status.
inline constexpr const char* exitStatusHint =
    "\nExit status: 0 when all is well; ringwatch help exit-status has the table of the others.";
inline constexpr const char* pageHelp =
    "write one HTML page about it to this file, which opens from disk in any browser";

/// A text on one line, with every word shortened: what reaches standard error must not break it.
std::string oneLine(std::string text);
/// Whether this process says what is wrong: of several that share a run one does.
void setSpeaks(bool speaks);
/// Writes to standard error. A closed standard error does not change how the program ends.
void tell(const std::string& text);
/// Says what is wrong, and returns the status.
ExitStatus complain(const std::string& text, ExitStatus status);
/// Writes text or JSON to standard output. Throws when it cannot be written, e.g. on a full disk.
void printOut(const std::string& text);

/// --json FILE, which every command that finds numbers has.
struct JsonOption {
  std::string path;

  /// what: is written.
  void declare(CLI::App& command, const char* what);
  bool takesStandardOutput() const { return path == "-"; }
  /// Writes the file, if one is wanted.
  void save(const nlohmann::ordered_json& json) const;
  /// Prints the JSON, or the text and its conclusion.
  void print(const nlohmann::ordered_json& json, const std::string& text) const;
  void write(const nlohmann::ordered_json& json, const std::string& text) const;
};

/// What the program says of a page that it wrote.
std::string reportText(const ReportResult& report);
/// Numbers of a command with what its page says of where they come from.
nlohmann::ordered_json withProvenance(nlohmann::ordered_json json, const std::string& typed,
                                      const std::filesystem::path& scene);
/// The writers of pages; in a program without them nothing gets here, see main.cpp.
const ReportWriters& neededReportWriters();

/// An option that is a time, s: a number or a fraction, such as 1/60.
template <class Time>
CLI::Option* addTime(CLI::App& command, const std::string& option, Time& time, const std::string& help) {
  return command.add_option_function<std::string>(
      option, [&time, option](const std::string& text) { time = parsePositiveNumber(text, option); }, help);
}

/// A word in single quotes, as a shell takes it.
std::string quoted(const std::string& word);
/// The same, without quotes where none are needed.
std::string shellWord(const std::string& word);

/// Declares --ranks; launch.h reads it, before this program is the one that it asks for.
void declareRanks(CLI::App& command, std::string& wanted);
/// Declares how masses and tangents of elements are made.
void declareMatrices(CLI::App& command, std::string& lumping, std::vector<std::string>& rules);
/// Declares --units: what the results call the numbers of a mesh that no scene names.
void declareUnits(CLI::App& command, std::optional<Units>& units);
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

/// A question that is asked of a scene before it runs, by `answer`, a function of its options.
template <class Options, auto answer>
struct QuestionCommand : Command {
  using Command::Command;
  Options options;
  JsonOption json;

  ExitStatus execute() override {
    const auto result = answer(options);
    json.write(result.json, result.text);
    return ExitStatus::done;
  }
};

/// Makes the folder of --out, unless it is there or none is wanted ("").
void makeFolderOfPictures(const std::string& folder);
/// Writes the pictures of a report into a folder.
void drawInto(const std::string& folder, const StudyReport& report);

}  // namespace ringwatch
