#include <ringwatch/app/history.h>

#include <cerrno>
#include <cstring>

#include <fmt/format.h>

#include <ringwatch/base/error.h>

namespace ringwatch {
namespace {

constexpr const char* columns =
    "step,time_s,h_s,safe_s,optimistic_s,controlling_element,kinetic_J,strain_J,external_work_J,balance_error_J,"
    "elements_refreshed,handled_elements,metric_step_s,verdict,dissipated_J\n";

}  // namespace

HistoryWriter::HistoryWriter(std::filesystem::path folder)
    : folder_(std::move(folder)), flushed_(std::chrono::steady_clock::now()) {
  errno = 0;
  file_.open(folder_ / "history.csv.part", std::ios::trunc);
  file_ << columns << std::flush;
  check();
}

void HistoryWriter::check() const {
  if (!file_)
    throw InputError(fmt::format("{}: cannot write history.csv: {}; choose another folder with --out", folder_.string(),
                                 errno != 0 ? std::strerror(errno) : "output error"));
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
  file_ << line << '\n';
  const auto now = std::chrono::steady_clock::now();
  if (now - flushed_ > std::chrono::seconds(1)) {
    file_.flush();
    flushed_ = now;
  }
  check();
}

void HistoryWriter::finish() {
  file_.close();
  check();
  std::error_code error;
  std::filesystem::rename(folder_ / "history.csv.part", folder_ / "history.csv", error);
  if (error) throw InputError(fmt::format("{}: cannot write history.csv: {}", folder_.string(), error.message()));
}

}  // namespace ringwatch
