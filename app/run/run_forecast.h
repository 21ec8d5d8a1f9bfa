#pragma once
#include <cstdint>
#include <string>

namespace ringwatch {

/// Foretells when a run will end, from the pace of its last steps, and says so where that is longer than anybody waits
/// without a word. Knows no clock: it is told.
class RunForecast {
 public:
  /// Where a run stands.
  struct Moment {
    double elapsed;      // s of wall time since its first step
    std::int64_t steps;  // taken
    double time, end;    // s of the run
    double h;            // s, the step
  };
  /// What there is to say, "" for nothing: when much time is left, and again whenever ten times as much is. limitedBy:
  /// what keeps the step small, asked where the step is a tenth of the first one and less.
  template <class LimitedBy>
  std::string observe(const Moment& now, const LimitedBy& limitedBy) {
    if (!(follow(now) > told_ * muchMore)) return {};
    told_ = left_;
    return sentence(now, now.h < first_ / muchMore ? limitedBy() : std::string());
  }
  /// Wall time that is left, s; 0 before there is a pace.
  double left() const { return left_; }
  /// "3.1 h", "42 seconds".
  static std::string durationText(double seconds);

 private:
  static constexpr double muchMore = 10;
  static constexpr double patience = 60;  // s that people wait for without a word
  static constexpr double settling = 2;   // s of wall time after which a pace is one
  /// Left time, s, once there is a pace.
  double follow(const Moment& now);
  std::string sentence(const Moment& now, const std::string& limitedBy) const;

  double first_ = 0;  // s, the first step
  double since_ = 0;  // s of wall time at which the pace began to be measured, and the steps taken then
  std::int64_t stepsThen_ = 0;
  double left_ = 0, told_ = patience / muchMore;
};

}  // namespace ringwatch
