#include <ringwatch/app/run/run_forecast.h>

#include <fmt/format.h>

namespace ringwatch {

double RunForecast::follow(const Moment& now) {
  if (first_ <= 0) first_ = now.h;
  if (now.elapsed - since_ < settling || now.steps <= stepsThen_ || !(now.h > 0)) return left_;
  const double pace = (now.elapsed - since_) / static_cast<double>(now.steps - stepsThen_);
  left_ = pace * (now.end - now.time) / now.h;
  since_ = now.elapsed;
  stepsThen_ = now.steps;
  return left_;
}

std::string RunForecast::sentence(const Moment& now, const std::string& limitedBy) const {
  std::string text = fmt::format("t = {:.4g} of {:.4g} s, h = {:.4g} s: {:.3g} steps are left, about {}", now.time,
                                 now.end, now.h, (now.end - now.time) / now.h, durationText(left_));
  if (!limitedBy.empty())
    text += fmt::format("; the step began with {:.4g} s, and {} keeps it small", first_, limitedBy);
  return text;
}

std::string RunForecast::durationText(double seconds) {
  constexpr double minute = 60, hour = 3600, day = 86400;
  if (seconds < 2 * minute) return fmt::format("{:.0f} seconds", seconds);
  if (seconds < 2 * hour) return fmt::format("{:.0f} min", seconds / minute);
  return seconds < 2 * day ? fmt::format("{:.1f} h", seconds / hour) : fmt::format("{:.3g} days", seconds / day);
}

}  // namespace ringwatch
