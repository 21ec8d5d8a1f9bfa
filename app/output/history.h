#pragma once
#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <ringwatch/base/output_file.h>
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
  std::optional<double> metricStep;  // s
  std::optional<Verdict> verdict;
};

/// Appends to history.csv as the run goes, whole rows only, four times a second or at every row when those are slower:
/// however the run ends, its history is there. A run that is killed (SIGKILL) while it writes may cut the last row.
class HistoryWriter {
 public:
  /// Begins the file again. Throws InputError when the folder cannot be written.
  explicit HistoryWriter(const std::filesystem::path& folder);
  /// Goes on behind the first `bytes` of the file; what is behind them is dropped. Throws InputError when there are
  /// fewer.
  HistoryWriter(const std::filesystem::path& folder, std::size_t bytes);
  /// Writes what is left, in silence.
  ~HistoryWriter();
  HistoryWriter(const HistoryWriter&) = delete;
  HistoryWriter& operator=(const HistoryWriter&) = delete;

  /// Throws InputError when the disk is full.
  void write(const HistoryRow& row);
  /// Writes what is left; the bytes of the file then.
  std::size_t bytes();
  void finish();

 private:
  void flush();

  OutputFile file_;
  std::string rows_;  // not yet in the file
  std::chrono::steady_clock::time_point flushed_;
};

/// The rows of a history.csv, of brackets the two sides alone. Throws InputError where it is not one.
std::vector<HistoryRow> readHistory(const std::filesystem::path& folder);

}  // namespace ringwatch
