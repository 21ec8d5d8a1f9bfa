#pragma once
#include <chrono>

namespace ringwatch {

/// Adds the wall time that it lives to a total, s.
class Stopwatch {
 public:
  explicit Stopwatch(double& total) : total_(total), start_(Clock::now()) {}
  ~Stopwatch() { lap(); }
  /// The total has all so far.
  void lap() {
    const Clock::time_point now = Clock::now();
    total_ += std::chrono::duration<double>(now - start_).count();
    start_ = now;
  }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  using Clock = std::chrono::steady_clock;

  double& total_;
  Clock::time_point start_;
};

}  // namespace ringwatch
