#pragma once
#include <cstdint>
#include <random>

namespace ringwatch {

/// Random numbers from a seed, the same on every machine: std::uniform_real_distribution differs between standard
/// libraries, the engine itself does not.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  /// In [low, high).
  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
  }
  /// In [0, count).
  int index(int count) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(count)); }

 private:
  std::mt19937_64 engine_;
};

}  // namespace ringwatch
