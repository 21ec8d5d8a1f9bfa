#include <ringwatch/app/output/progress.h>

#include <unistd.h>

#include <cstdio>

#include <fmt/format.h>

#include <ringwatch/base/units.h>

namespace ringwatch {
namespace {

/// A terminal that is gone (after SIGHUP) must not end the run.
void put(const std::string& text) {
  if (std::fputs(text.c_str(), stderr) >= 0) std::fflush(stderr);
}

}  // namespace

ProgressLine::ProgressLine(bool wanted)
    : wanted_(wanted), active_(wanted && ::isatty(STDERR_FILENO) != 0), start_(Clock::now()), last_(start_) {}

bool ProgressLine::due() {
  if (!active_) return false;
  const Clock::time_point now = Clock::now();
  if (now - start_ < std::chrono::seconds(2) || now - last_ < std::chrono::milliseconds(200)) return false;
  last_ = now;
  return true;
}

void ProgressLine::show(const std::string& text, double done) {
  const double spent = std::chrono::duration<double>(Clock::now() - start_).count();
  std::string left;
  if (done > 0) left = fmt::format(", {:.0f} seconds left", spent * (1 - done) / done);
  // Return to the line's start, and erase what an earlier, longer text left behind.
  put(fmt::format("\r{}{}\x1b[K", labelled(text), left));
  shown_ = true;
}

void ProgressLine::announce(const std::string& text) {
  if (!active_) return;
  put("\r" + labelled(text) + "\x1b[K");
  shown_ = true;
}

void ProgressLine::tell(const std::string& line, bool error) {
  clear();
  if (wanted_ || error) put(labelled(line) + "\n");
}

void ProgressLine::clear() {
  if (!shown_) return;
  put("\r\x1b[K");
  shown_ = false;
}

}  // namespace ringwatch
