#include <ringwatch/app/output/history.h>

#include <utility>

#include <fmt/format.h>

#include <ringwatch/base/error.h>

namespace ringwatch {
namespace {

constexpr const char* columns =
    "step,time_s,h_s,safe_s,optimistic_s,controlling_element,kinetic_J,strain_J,external_work_J,balance_error_J,"
    "elements_refreshed,handled_elements,metric_step_s,verdict,dissipated_J\n";

}  // namespace

HistoryWriter::HistoryWriter(const std::filesystem::path& folder)
    : file_(folder / "history.csv"), flushed_(std::chrono::steady_clock::now()) {
  file_.write(columns);
}

HistoryWriter::~HistoryWriter() {
  try {
    flush();
  } catch (const InputError&) {  // a run that ends by an error has another one to tell
  }
}

void HistoryWriter::flush() {
  if (rows_.empty()) return;
  const std::string rows = std::exchange(rows_, {});
  file_.write(rows);
}

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
  rows_ += line + '\n';
  const auto now = std::chrono::steady_clock::now();
  if (now - flushed_ < std::chrono::milliseconds(250)) return;
  flush();
  flushed_ = now;
}

void HistoryWriter::finish() {
  flush();
  file_.close();
}

}  // namespace ringwatch
