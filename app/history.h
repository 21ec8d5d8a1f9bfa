#pragma once
#include <chrono>
#include <filesystem>
#include <fstream>
#include <optional>

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

/// Streams history.csv: rows go to history.csv.part, flushed about once a second, which becomes history.csv when the
/// run is over, however it ended.
class HistoryWriter {
 public:
  /// Throws InputError when the folder cannot be written.
  explicit HistoryWriter(std::filesystem::path folder);
  /// Throws InputError when the disk is full.
  void write(const HistoryRow& row);
  void finish();

 private:
  void check() const;

  std::filesystem::path folder_;
  std::ofstream file_;
  std::chrono::steady_clock::time_point flushed_;
};

}  // namespace ringwatch
