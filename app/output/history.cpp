#include <ringwatch/app/output/history.h>

#include <cstdlib>
#include <sstream>

#include <fmt/format.h>

#include <ringwatch/app/output/output_fields.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/input_file.h>
#include <ringwatch/base/number_format.h>
#include <ringwatch/base/units.h>

namespace ringwatch {
namespace {

/// The first line of the file.
std::string heading() {
  std::string line;
  for (const OutputField& column : historyColumns()) line += joinText(line.empty() ? "" : ",", column.name);
  return labelledColumns(line);
}

}  // namespace

HistoryWriter::HistoryWriter(const std::filesystem::path& folder) : file_(folder / "history.csv", heading()) {}

HistoryWriter::HistoryWriter(const std::filesystem::path& folder, std::size_t bytes)
    : file_(folder / "history.csv", bytes) {}

void HistoryWriter::write(const HistoryRow& row) {
  // Shortest digits that read back to the same double; an empty cell where nothing was computed.
  std::string line = fmt::format("{},{},{},", row.step, row.time, row.h);
  if (row.bracket)
    line += fmt::format("{},{},{}:{},", row.bracket->safe, row.bracket->optimistic, row.bracket->controlling.block,
                        row.bracket->controlling.element);
  else
    line += ",,,";
  if (row.energies)
    line += fmt::format("{},{},{},{},", row.energies->kinetic, row.energies->strain, row.energies->externalWork,
                        row.energies->balanceError);
  else
    line += ",,,,";
  line += fmt::format("{},{},", row.elementsRefreshed, row.handledElements);
  if (row.metricStep) line += fmt::format("{}", *row.metricStep);
  line += ",";
  if (row.verdict) line += verdictName(*row.verdict);
  line += ",";
  if (row.energies) line += fmt::format("{}", row.energies->dissipated);
  line += fmt::format(",{},{}", row.erodedElements, row.repeats);
  file_.write(line);
}

std::vector<HistoryRow> readHistory(const std::filesystem::path& folder) {
  const std::filesystem::path path = folder / "history.csv";
  std::istringstream file(readBytes(path));
  std::string line;
  if (!std::getline(file, line) || line != heading())
    throw InputError(fmt::format("{}: is no history of this version", path.string()));
  std::vector<HistoryRow> rows;
  while (std::getline(file, line)) {
    std::vector<std::string> cells;
    std::istringstream text(line + ",");
    for (std::string cell; std::getline(text, cell, ',');) cells.push_back(cell);
    const std::size_t count = historyColumns().size();
    if (cells.size() != count)
      throw InputError(fmt::format("{}: row {} has {} cells, not {}", path.string(), rows.size(), cells.size(), count));
    const auto number = [&](std::size_t i) { return readNumber(cells[i]).value_or(0); };
    HistoryRow& row = rows.emplace_back();
    row.step = std::strtoll(cells[0].c_str(), nullptr, 10);
    row.time = number(1);
    row.h = number(2);
    if (!cells[3].empty()) {
      row.bracket.emplace();
      row.bracket->safe = number(3);
      row.bracket->optimistic = number(4);
    }
    if (!cells[6].empty()) row.energies = Energies{number(6), number(7), number(8), number(9), number(14)};
    row.elementsRefreshed = std::strtoll(cells[10].c_str(), nullptr, 10);
    row.handledElements = std::strtoll(cells[11].c_str(), nullptr, 10);
    row.erodedElements = std::strtoll(cells[15].c_str(), nullptr, 10);
    row.repeats = std::strtoll(cells[16].c_str(), nullptr, 10);
    if (!cells[12].empty()) row.metricStep = number(12);
    if (!cells[13].empty()) row.verdict = verdictNames.valueOf(path.string(), cells[13]);
  }
  return rows;
}

}  // namespace ringwatch
