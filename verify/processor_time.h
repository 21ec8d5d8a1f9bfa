#pragma once
#include <ctime>

namespace ringwatch {

/// Seconds that this program has computed so far: what other programs take meanwhile does not count. Times are reported
/// for information; no criterion of a study rests on one.
inline double processorSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// The same of the calling thread alone.
inline double threadSeconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace ringwatch
