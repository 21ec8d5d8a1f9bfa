#pragma once
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace ringwatch {

/// Random numbers from a seed, the same on every machine: std::uniform_real_distribution differs between standard
/// libraries, the engine itself does not.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  /// A uniform number in [low, high).
  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
  }
  /// A normal number, mean 0 and variance 1, by the method of Box and Muller.
  double normal() {
    const double radius = std::sqrt(-2 * std::log(inside()));
    return radius * std::cos(2 * std::numbers::pi * inside());
  }
  /// A uniform integer in [0, count).
  int index(int count) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(count)); }

 private:
  /// A uniform number in (0, 1).
  double inside() { return (static_cast<double>(engine_() >> 11) + 0.5) * 0x1p-53; }

  std::mt19937_64 engine_;
};

/// A number in [-1, 1) that belongs to an index: output number `index` of SplitMix64 from `seed`. For starts of
/// iterations: the same on every machine, for any number of threads and any order of evaluation.
inline double randomEntry(std::uint64_t seed, std::uint64_t index) {
  std::uint64_t z = seed + (index + 1) * 0x9e3779b97f4a7c15ULL;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-52 - 1;
}

}  // namespace ringwatch
