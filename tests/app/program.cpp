#include "program.h"

#include <sys/wait.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <map>
#include <regex>
#include <sstream>

#include <ringwatch/base/error.h>

#include "schema_check.h"

namespace nlohmann {
void PrintTo(const json& value, std::ostream* out) { *out << value; }
}  // namespace nlohmann

namespace ringwatch::test {

std::string digits(double value) {
  std::ostringstream text;
  text.precision(17);
  text << value;
  return text.str();
}

int statusOf(int waited) { return WIFEXITED(waited) ? WEXITSTATUS(waited) : 128 + WTERMSIG(waited); }

Outcome Program::shell(const std::string& line) {
  const std::string command = "cd '" + folder_.path().string() + "' && { " + line + "; } > out.txt 2> err.txt";
  const int status = std::system(command.c_str());
  const std::string errors = folder_.read("err.txt");
  // By this ctest knows that the test asks for what the build has not: tests/list_tests.cmake.
  if (errors.find("this build is without VTK") != std::string::npos) std::cout << errors;
  return {statusOf(status), folder_.read("out.txt"), errors};
}

Outcome Program::call(const std::string& arguments, const std::string& environment) {
  const Outcome outcome = shell(environment + " '" + executable() + "' " + arguments);
  expectValid(arguments, outcome);
  return outcome;
}

Outcome Program::stopRun(const std::string& options, const std::string& ready, const std::string& signal) {
  constexpr int ended = 0, terminatedWhileItEnded = 128 + SIGTERM;
  Outcome outcome{};
  for (int tries = 0; tries < 20 && (outcome.status == ended || outcome.status == terminatedWhileItEnded); ++tries)
    outcome = shell("rm -rf part; '" + executable() + "' run scene.toml --out part --quiet " + options +
                    " & p=$!; while kill -0 $p && ! { " + ready + "; } 2>/dev/null; do sleep 0.002; done; kill -" +
                    signal + " $p; wait $p");
  return outcome;
}

void Program::expectValid(const std::string& arguments, const Outcome& outcome) const {
  if (outcome.status >= 128) return;      // ended by a signal
  constexpr std::size_t longest = 10000;  // std::regex calls itself for every character
  if (arguments.size() > longest) return;
  std::smatch found;
  const std::string standardOutput = "standard output";
  const auto document = [&](const std::string& name, const std::string& text, const std::string& schema) {
    const Json value = Json::parse(text, nullptr, false);
    ASSERT_FALSE(value.is_discarded()) << arguments << ": " << name;
    EXPECT_EQ(schemaFault(schema, value), "") << arguments << ": " << name;
    if (name != standardOutput && value.contains("conclusion") && !outcome.out.empty()) {
      EXPECT_THAT(outcome.out, ::testing::EndsWith("\nconclusion: " + value["conclusion"].get<std::string>() + "\n"));
    }
  };
  static const std::regex json("^([\\w-]+) .*--json[ =]([\\w./-]+)"), run("^run .*--out[ =]([\\w./-]+)"),
      scene("^run ([\\w./-]+\\.toml)"),
      assignment("--set[ =](?:'([^']*)'|\"([^\"\\\\]*)\"|([^\\s'\"\\\\$]+))(?=\\s|$)");
  if (outcome.status != 2 && std::regex_search(arguments, found, json)) {
    const std::filesystem::path path = folder_.path() / found[2].str();
    if (found[2] == "-")
      document(standardOutput, outcome.out, found[1]);
    else if (std::filesystem::is_regular_file(path))
      document(path.string(), folder_.read(path), found[1]);
  }
  if (outcome.status != 2 && std::regex_search(arguments, found, run)) {
    const std::filesystem::path path = folder_.path() / found[1].str() / "summary.json";
    if (std::filesystem::is_regular_file(path)) document(path.string(), folder_.read(path), "summary");
  }
  if (std::regex_search(arguments, found, scene)) {
    const std::string name = found[1];
    std::vector<std::string> overrides;
    for (std::sregex_iterator set(arguments.begin(), arguments.end(), assignment), end; set != end; ++set)
      overrides.push_back((*set)[1].str() + (*set)[2].str() + (*set)[3].str());
    const std::string option = "--set";
    std::size_t options = 0;
    for (std::size_t at = arguments.find(option); at != std::string::npos; at = arguments.find(option, at + 1))
      ++options;
    if (options != overrides.size()) return;  // in quotes that only a shell understands
    const Json value = withOverrides(jsonOfToml(folder_.read(folder_.path() / name)), overrides);
    if (outcome.status != 2 && value.is_object()) {
      EXPECT_EQ(schemaFault("scene", value), "") << arguments;
    } else if (outcome.status == 2 && isAboutTypeRangeOrKey(outcome.err)) {
      EXPECT_NE(schemaFault("scene", value), "") << outcome.err;
    }
  }
}

std::string Program::schemaFault(const std::string& schema, const Json& document) const {
  static std::map<std::string, SchemaCheck> known;  // of each program
  const std::string command = "'" + executable() + "' schema " + schema;
  auto found = known.find(command);
  if (found == known.end()) {
    const std::filesystem::path file = folder_.path() / "the.schema.json";
    if (std::system((command + " > '" + file.string() + "'").c_str()) != 0) return "there is no schema " + schema;
    found = known.emplace(command, SchemaCheck(parse(folder_.read(file)))).first;
    std::filesystem::remove(file);
  }
  return found->second.faultOf(document);
}

std::string Program::executable() const {
  const char* const elsewhere = std::getenv("RINGWATCH_PROGRAM");  // of tests that were built on another machine
  return elsewhere ? elsewhere : RINGWATCH_PROGRAM;
}

void Program::expectRefused(const Outcome& outcome, const std::string& what) {
  EXPECT_EQ(outcome.status, 2) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, ::testing::AllOf(::testing::StartsWith("ringwatch: "), ::testing::HasSubstr(what),
                                            ::testing::EndsWith("\n")));
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
}

Outcome Program::runScene(const std::string& scene, const std::string& options, int status, const std::string& folder) {
  folder_.write("scene.toml", scene);
  Outcome outcome = call("run scene.toml --out " + folder + " " + options);
  EXPECT_EQ(outcome.status, status) << outcome.out << outcome.err;
  history_ = table(folder + "/history.csv");
  summary_ = json(folder + "/summary.json");
  return outcome;
}

void Program::refuseScene(const std::string& scene, const std::string& what, const std::string& options) {
  folder_.write("scene.toml", scene);
  expectRefused("run scene.toml --out refused " + options, what);
  EXPECT_FALSE(exists("refused"));
}

void Program::expectSameForAnyThreads(const std::string& scene, const std::string& options) {
  runScene(scene, "--threads 1 " + options, 0, "one");
  runScene(scene, "--threads 3 " + options, 0, "three");
  EXPECT_EQ(folder_.read("one/history.csv"), folder_.read("three/history.csv"));
}

void Program::expectSameWhenKilled(const std::string& scene, const std::string& options) {
  runScene(scene, options + " --quiet", 0, "whole");
  int resumed = 0;
  bool ended = false;
  for (double seconds = 0.15; !ended && seconds < 60; seconds *= 1.3) {
    const bool again = exists("part/checkpoint.bin");
    const std::string what = again ? "run --resume part --quiet" : "run scene.toml --out part --quiet " + options;
    shell("'" + executable() + "' " + what + " & p=$!; sleep " + std::to_string(seconds) +
          "; kill -KILL $p 2>/dev/null; wait $p");
    resumed += again;
    ended = exists("part/summary.json") && json("part/summary.json")["exit_reason"] == "end";
  }
  ASSERT_TRUE(ended);
  EXPECT_GT(resumed, 0);
  EXPECT_EQ(folder_.read("part/history.csv"), folder_.read("whole/history.csv"));
  Json one = json("part/summary.json"), other = summary_;
  for (Json* summary : {&one, &other})
    for (const char* own : {"wall_time", "provenance"}) summary->erase(own);
  EXPECT_EQ(one, other);
}

MeshState Program::lastFrame() const {
  return loadVtuState(folder_.path() / joinText("r/frames/frame_00000", summary_["frames"].get<int>(), ".vtu"),
                      "displacement", nullptr);
}

bool Program::exists(const std::string& name) const { return std::filesystem::exists(folder_.path() / name); }

Json Program::parse(const std::string& text) { return Json::parse(text); }

std::string Program::Table::at(std::size_t row, const std::string& column) const {
  return rows.at(row).at(std::find(columns.begin(), columns.end(), column) - columns.begin());
}

double Program::Table::largest(const std::string& column) const {
  double most = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) most = std::max(most, std::abs(number(i, column)));
  return most;
}

Program::Table Program::table(const std::string& name) const {
  std::istringstream lines(folder_.read(name));
  Table result;
  for (std::string line; std::getline(lines, line);) {
    std::vector<std::string> cells;
    std::istringstream text(line + ",");
    for (std::string cell; std::getline(text, cell, ',');) cells.push_back(cell);
    if (result.columns.empty())
      result.columns = cells;
    else
      result.rows.push_back(cells);
  }
  return result;
}

void Program::expectNothingHalfWritten(const std::string& name) const {
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_.path() / name))
    EXPECT_EQ(entry.path().filename().string().find(".part"), std::string::npos) << entry.path();
}

}  // namespace ringwatch::test
