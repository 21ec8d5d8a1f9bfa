#include <ringwatch/app/command/command.h>

#include <cstdio>

#include <ringwatch/app/analysis/inspect.h>
#include <ringwatch/app/command/verify.h>
#include <ringwatch/app/output/provenance.h>
#include <ringwatch/app/output/report.h>
#include <ringwatch/app/scene/saved_json.h>
#include <ringwatch/base/atomic_file.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/user_text.h>

namespace ringwatch {
namespace {

bool speaksHere = true;

/// A word of a message is shown to this length: file names fit in, and no argument fills the screen.
constexpr std::size_t longestWord = 400;

}  // namespace

std::string seeTopics(std::string_view topics) { return fmt::format("More: ringwatch help {}\n", topics); }

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

void setSpeaks(bool speaks) { speaksHere = speaks; }

void tell(const std::string& text) { std::fwrite(text.data(), 1, text.size(), stderr); }

ExitStatus complain(const std::string& text, ExitStatus status) {
  if (speaksHere) tell(fmt::format("ringwatch: {}\n", oneLine(labelled(text))));
  return status;
}

void printOut(const std::string& text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
    throw InputError("cannot write to standard output");
}

void JsonOption::declare(CLI::App& command, const char* what) {
  command
      .add_option("--json", path,
                  fmt::format("write the {} to this file; - for standard output, and nothing else there", what))
      ->type_name("FILE");
}

void JsonOption::save(const nlohmann::ordered_json& json) const {
  if (!path.empty() && !takesStandardOutput()) writeFileAtomically(path, jsonText(labelledJson(json)));
}

void JsonOption::print(const nlohmann::ordered_json& json, const std::string& text) const {
  printOut(takesStandardOutput() ? jsonText(labelledJson(json)) : labelled(text + conclusionLine(json["conclusion"])));
}

void JsonOption::write(const nlohmann::ordered_json& json, const std::string& text) const {
  save(json);
  print(json, text);
}

std::string reportText(const ReportResult& report) {
  std::string text = fmt::format("wrote {}: {:.2f} MB", report.file.string(), 1e-6 * static_cast<double>(report.bytes));
  if (report.framesOfRun > 0) text += fmt::format(", {} of {} frames", report.frames, report.framesOfRun);
  text += "\n";
  for (const std::string& note : report.notes) text += fmt::format("note: {}\n", note);
  return text;
}

nlohmann::ordered_json withProvenance(nlohmann::ordered_json json, const std::string& typed,
                                      const std::filesystem::path& scene) {
  json["version"] = std::string(programVersion());
  json["provenance"] = provenanceOf(typed, scene);
  return json;
}

const ReportWriters& neededReportWriters() {
  if (const ReportWriters* writers = reportWriters()) return *writers;
  throw InputError("this program writes no pages; call ringwatch");
}

std::string quoted(const std::string& word) {
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? "'\\''" : std::string(1, c);
  return text + "'";
}

std::string shellWord(const std::string& word) {
  const bool plain = !word.empty() && word.find_first_of(" \t\n'\"$`\\<>|&;()*?[]#~{}!") == std::string::npos;
  return plain ? word : quoted(word);
}

void declareRanks(CLI::App& command, std::string& wanted) {
  command
      .add_option("--ranks", wanted,
                  "whether processes that a launcher such as mpirun has started share the work: auto (where there are "
                  "several), yes or no (each does it alone); see docs/cluster.md")
      ->type_name("WHEN")
      ->check(CLI::IsMember({"auto", "yes", "no"}));
}

void declareUnits(CLI::App& command, std::optional<Units>& units) {
  command
      .add_option_function<std::string>(
          "--units", [&units](const std::string& name) { units = unitSystems.valueOf("--units", name); },
          fmt::format("what results call the numbers: {} (default: the scene's, else SI)", unitSystems.listing()))
      ->type_name("SYSTEM");
}

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

void makeFolderOfPictures(const std::string& folder) {
  if (folder.empty()) return;
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    throw InputError(fmt::format("--out: cannot write {}: {}; choose another folder", folder, error.message()));
}

void drawInto(const std::string& folder, const StudyReport& report) {
  for (const std::string& note : drawFigures(report, folder)) tell(fmt::format("note: {}\n", note));
}

}  // namespace ringwatch
