#include <ringwatch/app/command/study_data.h>

#include <cmath>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include <ringwatch/app/output/provenance.h>
#include <ringwatch/app/output/report.h>
#include <ringwatch/base/atomic_file.h>

namespace ringwatch {
namespace {

/// What stands in a column of numbers where there is none.
bool isMissing(const StudyTable::Cell& cell) {
  const auto* text = std::get_if<std::string>(&cell);
  return text != nullptr && (text->empty() || *text == "-");
}

/// A cell of RFC 4180. Numbers have the digits that give the same number again, and are called as Table Schema says
/// where they are not finite.
std::string csvCell(const StudyTable::Cell& cell) {
  if (const auto* number = std::get_if<double>(&cell)) {
    if (std::isnan(*number)) return "NaN";
    if (std::isinf(*number)) return *number > 0 ? "INF" : "-INF";
    return fmt::format("{}", *number);
  }
  if (const auto* whole = std::get_if<std::int64_t>(&cell)) return fmt::format("{}", *whole);
  const auto& text = std::get<std::string>(cell);
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

/// The type of a column in Table Schema: that of its cells that are not missing.
const char* typeOf(const StudyTable& table, std::size_t column) {
  bool some = false, whole = true;
  for (const auto& row : table.rows) {
    if (isMissing(row[column])) continue;
    if (std::holds_alternative<std::string>(row[column])) return "string";
    some = true;
    whole = whole && std::holds_alternative<std::int64_t>(row[column]);
  }
  return !some ? "string" : (whole ? "integer" : "number");
}

/// "h (s)" in two: "h" and "s"; without a unit the second is "".
std::pair<std::string, std::string> nameAndUnit(const std::string& column) {
  const std::size_t open = column.rfind(" (");
  if (open == std::string::npos || column.back() != ')') return {column, ""};
  return {column.substr(0, open), column.substr(open + 2, column.size() - open - 3)};
}

nlohmann::ordered_json fieldOf(const StudyTable& table, std::size_t column) {
  const std::string type = typeOf(table, column);
  const auto [name, unit] = nameAndUnit(table.columns[column]);
  nlohmann::ordered_json field{{"name", table.columns[column]}, {"type", type}};
  if (type != "string") field["unit"] = unit.empty() ? "1" : unit;
  field["description"] = column < table.descriptions.size() ? table.descriptions[column] : name;
  return field;
}

std::string csvOf(const StudyTable& table) {
  const auto line = [](const auto& cells) {
    std::string text;
    for (const auto& cell : cells) text += (text.empty() ? "" : ",") + csvCell(cell);
    return text + "\n";
  };
  std::string csv = line(table.columns);
  for (const auto& row : table.rows) csv += line(row);
  return csv;
}

StudyTable tableOfChecks(const StudyReport& report) {
  StudyTable table{
      "checks",
      "What was measured, and what it is held to",
      {"check", "measured", "expected", "tolerance", "sense", "passed"},
      {},
      {"what was measured, with its unit where it has one", "the number that was measured",
       "what theory or another program says", "how far measured may be from expected",
       "near: on both sides; at most: above; at least: below", "1 where the number is as expected, else 0"}};
  for (const StudyCheck& check : report.checks) {
    const char* const sense = check.sense == StudyCheck::Sense::near     ? "near"
                              : check.sense == StudyCheck::Sense::atMost ? "at most"
                                                                         : "at least";
    table.rows.push_back({check.name, check.measured, check.expected, check.tolerance, std::string(sense),
                          std::int64_t{check.passed() ? 1 : 0}});
  }
  return table;
}

}  // namespace

StudyData::StudyData(std::filesystem::path folder, const std::string& command) : folder_(std::move(folder)) {
  package_ = {
      {"profile", "data-package"},
      {"name", "ringwatch-verify"},
      {"title", ""},
      {"description", fmt::format("Tables, checks and files that `{}` of ringwatch {} wrote. Columns name their units; "
                                  "what has no unit has the unit 1.",
                                  command, programVersion())},
      {"version", programVersion()},
      {"created", timeNow()},
      {"licenses",
       {{{"name", "BSD-3-Clause"},
         {"title", "BSD 3-Clause"},
         {"path", "https://opensource.org/license/bsd-3-clause"}}}},
      {"contributors", {{{"title", "The ringwatch authors"}, {"role", "author"}}}},
      {"sources", {{{"title", fmt::format("ringwatch {}", programVersion())}}}},
      {"resources", nlohmann::ordered_json::array()}};
}

void StudyData::addTable(const std::string& study, const StudyTable& table) {
  const std::string name = study + "." + table.name;
  nlohmann::ordered_json fields = nlohmann::ordered_json::array();
  for (std::size_t column = 0; column < table.columns.size(); ++column) fields.push_back(fieldOf(table, column));
  writeFileAtomically(folder_ / (name + ".csv"), csvOf(table));
  package_["resources"].push_back({{"profile", "tabular-data-resource"},
                                   {"name", name},
                                   {"path", name + ".csv"},
                                   {"title", table.title},
                                   {"format", "csv"},
                                   {"mediatype", "text/csv"},
                                   {"encoding", "utf-8"},
                                   {"schema", {{"fields", fields}, {"missingValues", {"", "-"}}}}});
}

void StudyData::add(const StudyReport& report) {
  for (const StudyTable& table : report.tables) addTable(report.study, table);
  if (!report.checks.empty()) addTable(report.study, tableOfChecks(report));
  for (const StudyFile& file : report.files) {
    const std::filesystem::path path = folder_ / file.name;
    std::error_code error;  // of which the write below tells
    std::filesystem::create_directories(path.parent_path(), error);
    writeFileAtomically(path, file.bytes);
  }
  auto& title = package_["title"].get_ref<std::string&>();
  title += (title.empty() ? "ringwatch, studies: " : ", ") + report.study;
  writeFileAtomically(folder_ / "datapackage.json", package_.dump(1) + "\n");
}

}  // namespace ringwatch
