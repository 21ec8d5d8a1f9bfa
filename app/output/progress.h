#pragma once
#include <chrono>
#include <string>

namespace ringwatch {

/// One line on a terminal that tells how far a long run has come. Silent for the first two seconds, and always where
/// standard error is not a terminal.
class ProgressLine {
 public:
  explicit ProgressLine(bool wanted);
  ~ProgressLine() { clear(); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// Whether a new line is due; cheap enough to ask at every step.
  bool due();
  /// done: share of the whole, 0 to 1.
  void show(const std::string& text, double done);
  /// Shows a text at once, for work that cannot say how far it has come.
  void announce(const std::string& text);
  /// Prints a line that stays, on standard error; where no progress is wanted, errors alone.
  void tell(const std::string& line, bool error);
  void clear();

 private:
  using Clock = std::chrono::steady_clock;
  bool wanted_, active_;
  bool shown_ = false;
  Clock::time_point start_, last_;
};

}  // namespace ringwatch
