#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <ringwatch/app/output/row_file.h>
#include <ringwatch/monitor/stability_monitor.h>

namespace ringwatch {

/// A row of history.csv: the state before step `step` and what was known of it.
struct HistoryRow {
  std::int64_t step = 0;
  double time = 0;  // s
  double h = 0;     // s, the step taken from here
  std::optional<CriticalStep> bracket;
  std::optional<Energies> energies;
  std::int64_t elementsRefreshed = 0;
  std::int64_t handledElements = 0;
  std::int64_t erodedElements = 0;
  std::int64_t repeats = 0;
  std::optional<double> metricStep;  // s
  std::optional<Verdict> verdict;
};

/// Appends to history.csv as the run goes, as RowFile does.
class HistoryWriter {
 public:
  /// Begins the file again. Throws InputError when the folder cannot be written.
  explicit HistoryWriter(const std::filesystem::path& folder);
  /// Goes on behind the first `bytes` of the file.
  HistoryWriter(const std::filesystem::path& folder, std::size_t bytes);

  /// Throws InputError when the disk is full.
  void write(const HistoryRow& row);
  /// Writes what is left; the bytes of the file then.
  std::size_t bytes() { return file_.bytes(); }
  void sync() { file_.sync(); }
  void finish() { file_.finish(); }

 private:
  RowFile file_;
};

/// The rows of a history.csv, of brackets the two sides alone. Throws InputError where it is not one.
std::vector<HistoryRow> readHistory(const std::filesystem::path& folder);

}  // namespace ringwatch
