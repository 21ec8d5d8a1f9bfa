#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <ringwatch/app/output/history.h>

namespace ringwatch {

/// The picture of a run: safe, optimistic and actual step against time, with the moments of the first violation, of the
/// energy's runaway and of cuts; handled elements where there are some; and the energies. Drawn by gnuplot, called as a
/// program.
class Picture {
 public:
  void add(const HistoryRow& row);
  /// The step from row number `step` of the history was shortened to end with the run: it is not drawn.
  void leaveOut(std::int64_t step) { leftOut_ = step; }
  void markCut(double time) { cuts_.push_back(time); }
  void markViolation(double time) { violation_ = time; }
  void markRunaway(double time) { runaway_ = time; }

  /// Writes critical_step.dat and critical_step.gp and lets gnuplot make critical_step.png of them. Returns "" or, when
  /// there is no picture, a note that says why. Throws InputError when the script or the data cannot be written.
  std::string draw(const std::filesystem::path& folder, const std::string& title) const;

 private:
  std::string data() const;
  std::string script(const std::string& title) const;
  bool drawsStep(const HistoryRow& row) const { return row.step != leftOut_; }

  // Every stride-th row, thinned when there are more than a picture can show.
  std::vector<HistoryRow> rows_;
  std::size_t stride_ = 1, seen_ = 0;
  std::optional<double> violation_, runaway_;
  std::optional<std::int64_t> leftOut_;
  std::vector<double> cuts_;  // s
};

}  // namespace ringwatch
