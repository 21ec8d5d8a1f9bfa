#pragma once
#include <algorithm>
#include <cstdint>

namespace ringwatch {

/// When to try again what may not help: after a first gap, and after longer ones while tries are in vain. Gaps are
/// counted in calls of tick(): evaluations, updates or steps of the caller.
class Backoff {
 public:
  struct Gaps {
    int first;   ///< after a try that helped
    int last;    ///< the longest
    int factor;  ///< from one gap to the next while tries do not help

    /// The same gap always.
    static constexpr Gaps fixed(int gap) { return {.first = gap, .last = gap, .factor = 1}; }
  };
  /// The first try is due at once.
  constexpr explicit Backoff(Gaps gaps) : gaps_(gaps), gap_(gaps.first), since_(gaps.last) {}

  void tick() { ++since_; }
  /// A try is due, and at least `least` ticks have passed since the last one.
  bool due(int least = 0) const { return since_ >= std::max(gap_, least); }
  /// Ticks since the last try.
  std::int64_t since() const { return since_; }
  void tried(bool helped) {
    gap_ = helped ? gaps_.first : std::min(gaps_.factor * gap_, gaps_.last);
    since_ = 0;
  }
  /// Something else has done what a try does: the gap begins again and stays as long as it is.
  void restart() { since_ = 0; }
  /// A try is due at once, and the next gap is the first.
  void reset() { *this = Backoff(gaps_); }

 private:
  Gaps gaps_;
  int gap_;
  std::int64_t since_;
};

}  // namespace ringwatch
