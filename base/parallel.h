#pragma once
#include <algorithm>
#include <cstdint>

#include <omp.h>

namespace ringwatch {

/// Threads to use for a request; 0 asks for all that OpenMP offers.
inline int threadCount(int requested) { return requested > 0 ? requested : omp_get_max_threads(); }

/// Calls body(i) for begin <= i < end on `threads` threads (0: all), at least `grain` calls a thread: a loop too short
/// to be worth waking others stays on the caller's. Bodies must write to places of their own; whoever sums afterwards
/// sums in index order, so that results do not depend on the number of threads.
template <class Loop>
void parallelFor(std::int64_t begin, std::int64_t end, int threads, const Loop& body, std::int64_t grain = 1) {
  const int n = static_cast<int>(std::min<std::int64_t>(threadCount(threads), (end - begin) / grain));
  if (n <= 1) {
    for (std::int64_t i = begin; i < end; ++i) body(i);
    return;
  }
#pragma omp parallel for schedule(static) num_threads(n)
  for (std::int64_t i = begin; i < end; ++i) body(i);
}

}  // namespace ringwatch
