#pragma once
#include <chrono>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <ringwatch/app/report/run_report.h>
#include <ringwatch/app/run/run_listener.h>

namespace ringwatch {

/// Safe, optimistic and taken step at moments of a run.
struct LivePoint {
  double time = 0;                                               // s
  double h = 0;                                                  // s
  double safe = std::numeric_limits<double>::quiet_NaN();        // s
  double optimistic = std::numeric_limits<double>::quiet_NaN();  // s
};

/// Keeps at most a number of points of a run, evenly spread over its steps, and the last one.
class LivePoints {
 public:
  explicit LivePoints(std::size_t most) : most_(most) {}
  void add(const LivePoint& point);
  const std::vector<LivePoint>& points() const { return points_; }

 private:
  std::size_t most_, stride_ = 1, seen_ = 0;
  std::vector<LivePoint> points_;
};

/// The bracket against time in characters, a line each: s safe, o optimistic, # the step taken.
std::vector<std::string> bracketLines(const std::vector<LivePoint>& points, double end, int width, int height);

/// Follows a run while it goes on: writes its page anew, and shows bracket, progress, time left and the monitor's cost
/// on a terminal. Takes at most about a twentieth of the run's wall time.
class LiveWatch final : public RunListener {
 public:
  /// write: writes the page of the run in the folder. terminal: whether to show anything, where standard error is one.
  LiveWatch(std::filesystem::path folder, ReportResult (*write)(const ReportOptions&), bool terminal);
  ~LiveWatch() override;
  LiveWatch(const LiveWatch&) = delete;
  LiveWatch& operator=(const LiveWatch&) = delete;

  void observe(const RunMoment& moment) override;

 private:
  using Clock = std::chrono::steady_clock;
  std::optional<double> secondsLeft(const RunMoment& moment) const;
  void writePage(const RunMoment& moment);
  void show(const RunMoment& moment);
  void erase();

  std::filesystem::path folder_;
  ReportResult (*write_)(const ReportOptions&);
  bool terminal_;
  Clock::time_point start_, nextPage_, nextShow_;
  std::optional<double> firstTime_;  // s, of the run
  LivePoints points_{2000};
  int lines_ = 0;          // on the terminal
  double lastCost_ = 0;    // s, of the last page
  std::string pageFault_;  // why the page could not be written
};

}  // namespace ringwatch
