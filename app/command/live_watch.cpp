#include <ringwatch/app/command/live_watch.h>

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <fmt/format.h>

#include <ringwatch/app/output/provenance.h>
#include <ringwatch/app/run/run_forecast.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/base/units.h>

namespace ringwatch {
namespace {

using Seconds = std::chrono::duration<double>;

/// Least time between two pages, s, and the share of the wall time that writing them may take.
constexpr double pageEvery = 2, pageShare = 0.05;

/// A terminal that is gone (after SIGHUP) must not end the run.
void writeToTerminal(const std::string& text) {
  if (std::fputs(text.c_str(), stderr) >= 0) std::fflush(stderr);
}

int terminalWidth() {
  winsize size{};
  constexpr int usual = 80, least = 40, most = 160;
  if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return usual;
  return std::clamp<int>(size.ws_col, least, most);
}

double monitorShare(const RunMoment& moment) {
  const double all = moment.forceTime + moment.monitorTime + moment.outputTime;
  return all > 0 ? moment.monitorTime / all : 0;
}

std::chrono::steady_clock::duration ticks(double seconds) {
  return std::chrono::duration_cast<std::chrono::steady_clock::duration>(Seconds(seconds));
}

}  // namespace

void LivePoints::add(const LivePoint& point) {
  // The last point stays for the newest moment; every stride_-th one is kept behind it.
  if (!points_.empty() && (seen_ - 1) % stride_ != 0) points_.pop_back();
  points_.push_back(point);
  ++seen_;
  if (points_.size() <= most_) return;
  std::vector<LivePoint> half;
  for (std::size_t i = 0; i < points_.size(); i += 2) half.push_back(points_[i]);
  points_ = std::move(half);
  stride_ *= 2;
}

std::vector<std::string> bracketLines(const std::vector<LivePoint>& points, double end, int width, int height) {
  double largest = 0, taken = 0;
  for (const LivePoint& point : points) taken = std::max(taken, point.h);
  // An optimistic side far above the step says no more than that it is, and is left out.
  constexpr double far = 3;
  for (const LivePoint& point : points)
    for (const double step : {point.h, point.safe, point.optimistic})
      if (std::isfinite(step) && step <= far * taken) largest = std::max(largest, step);
  if (!(largest > 0) || points.empty() || width < 30 || height < 2) return {};
  constexpr int labels = 12;
  const int columns = width - labels - 1;
  std::vector<std::string> picture(height, std::string(columns, ' '));
  const double begin = points.front().time, range = std::max(end - begin, 1e-300);
  const auto mark = [&](double time, double step, char sign) {
    if (!std::isfinite(step) || step < 0 || step > largest) return;
    const int column = std::clamp(static_cast<int>((time - begin) / range * columns), 0, columns - 1);
    const int row =
        std::clamp(height - 1 - static_cast<int>(std::lround(step / largest * (height - 1))), 0, height - 1);
    picture[row][column] = sign;
  };
  // What comes later covers what came before: the step that is taken is always seen.
  for (const LivePoint& point : points) mark(point.time, point.optimistic, 'o');
  for (const LivePoint& point : points) mark(point.time, point.safe, 's');
  for (const LivePoint& point : points) mark(point.time, point.h, '#');
  std::vector<std::string> lines;
  for (int row = 0; row < height; ++row)
    lines.push_back(fmt::format("{:>10} |{}",
                                row == 0            ? fmt::format("{:.3g} s", largest)
                                : row == height - 1 ? "0"
                                                    : "",
                                picture[row]));
  return lines;
}

LiveWatch::LiveWatch(std::filesystem::path folder, ReportResult (*write)(const ReportOptions&), bool terminal)
    : folder_(std::move(folder)),
      write_(write),
      terminal_(terminal && ::isatty(STDERR_FILENO) != 0),
      start_(Clock::now()),
      nextPage_(start_),
      nextShow_(start_) {}

LiveWatch::~LiveWatch() { erase(); }

void LiveWatch::erase() {
  if (lines_ > 0) writeToTerminal(fmt::format("\x1b[{}A\r\x1b[J", lines_));
  lines_ = 0;
}

std::optional<double> LiveWatch::secondsLeft(const RunMoment& moment) const {
  const double done = moment.time - *firstTime_, left = moment.end - moment.time;
  const double spent = Seconds(Clock::now() - start_).count();
  constexpr double enough = 0.5;  // s, before which nothing can be said
  if (!(done > 0) || spent < enough) return std::nullopt;
  return spent * left / done;
}

void LiveWatch::observe(const RunMoment& moment) {
  if (!firstTime_) firstTime_ = moment.time;
  LivePoint point{moment.time, moment.h};
  if (moment.bracket) {
    point.safe = moment.bracket->safe;
    point.optimistic = moment.bracket->optimistic;
  }
  points_.add(point);
  const Clock::time_point now = Clock::now();
  if (now >= nextPage_) writePage(moment);
  if (terminal_ && now >= nextShow_) show(moment);
}

void LiveWatch::writePage(const RunMoment& moment) {
  const Clock::time_point begin = Clock::now();
  LiveRun live;
  live.summary = moment.summary();
  const std::optional<double> left = secondsLeft(moment);
  live.summary["live"] = {{"time", moment.time},
                          {"end", moment.end},
                          {"seconds_left", left ? nlohmann::ordered_json(*left) : nlohmann::ordered_json(nullptr)},
                          {"monitor_share", monitorShare(moment)},
                          {"written", timeNow()}};
  // The page tells its reader when to look again: when the next one is there.
  live.reloadAfter = std::max(pageEvery, lastCost_ / pageShare);
  try {
    ReportOptions options;
    options.folder = folder_;
    options.live = &live;
    write_(options);
    pageFault_.clear();
  } catch (const InputError& fault) {  // a full disk ends the run by itself
    pageFault_ = fault.what();
  }
  lastCost_ = Seconds(Clock::now() - begin).count();
  nextPage_ = Clock::now() + ticks(std::max(pageEvery, lastCost_ / pageShare));
}

void LiveWatch::show(const RunMoment& moment) {
  const int width = terminalWidth();
  std::vector<std::string> lines;
  const double share = moment.end > 0 ? std::clamp(moment.time / moment.end, 0.0, 1.0) : 0;
  const std::optional<double> left = secondsLeft(moment);
  const std::string progress = fmt::format(" {:.0f} %, t = {:.4g} of {:.4g} s{}", 100 * share, moment.time, moment.end,
                                           left ? fmt::format(", {} left", RunForecast::durationText(*left)) : "");
  const int bar = std::max(8, width - static_cast<int>(progress.size()) - 3);
  const int full = static_cast<int>(share * bar);
  lines.push_back(fmt::format("[{}{}]{}", std::string(full, '='), std::string(bar - full, ' '), progress));
  constexpr int height = 9;
  for (std::string& line : bracketLines(points_.points(), moment.end, width, height)) lines.push_back(std::move(line));
  lines.emplace_back("           s safe (proven stable below), o optimistic (proven unstable above), # step taken");
  std::string state = fmt::format("step {}, h = {:.4g} s", moment.step, moment.h);
  if (moment.bracket) {
    state += fmt::format(", safe {:.4g} s, optimistic {:.4g} s", moment.bracket->safe, moment.bracket->optimistic);
    state += fmt::format(", element {}:{}", moment.bracket->controlling.block, moment.bracket->controlling.element);
  }
  if (moment.verdict) state += fmt::format(", {}", verdictName(*moment.verdict));
  if (moment.handled > 0) state += fmt::format(", {} handled", moment.handled);
  lines.push_back(std::move(state));
  const double all = std::max(moment.forceTime + moment.monitorTime + moment.outputTime, 1e-300);
  lines.push_back(fmt::format("wall time: monitor {:.0f} %, force {:.0f} %, output {:.0f} %",
                              100 * moment.monitorTime / all, 100 * moment.forceTime / all,
                              100 * moment.outputTime / all));
  lines.push_back(pageFault_.empty() ? fmt::format("page: {}", (folder_ / "report.html").string())
                                     : fmt::format("no page: {}", pageFault_));
  std::string text;
  if (lines_ > 0) text = fmt::format("\x1b[{}A\r", lines_);
  for (const std::string& line : lines) text += labelled(line).substr(0, width - 1) + "\x1b[K\n";
  text += "\x1b[J";
  writeToTerminal(text);
  lines_ = static_cast<int>(lines.size());
  constexpr double showEvery = 0.2;  // s
  nextShow_ = Clock::now() + ticks(showEvery);
}

}  // namespace ringwatch
