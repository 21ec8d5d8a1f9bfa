#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

#include <omp.h>

namespace ringwatch {

/// Threads to use for a request; 0 asks for all that OpenMP offers.
inline int threadCount(int requested) { return requested > 0 ? requested : omp_get_max_threads(); }

namespace detail {
/// Calls run(body, part) for 0 <= part < parts, each on a thread of its own. An exception must not leave a parallel
/// region: that of the lowest part is thrown here, when all parts have ended.
void runParts(std::int64_t parts, void (*run)(const void* body, std::int64_t part), const void* body);
}  // namespace detail

/// Calls body(begin, end) on `threads` threads (0: all), each with one part of [0, count) of at least `grain` numbers.
/// Where the parts end depends on the number of threads, so bodies must treat each number alone. Throws what a body
/// throws: of several the one of the lowest numbers.
template <class Loop>
void parallelParts(std::int64_t count, int threads, std::int64_t grain, const Loop& body) {
  const std::int64_t n = std::min<std::int64_t>(threadCount(threads), count / grain);
  if (n <= 1) {
    if (count > 0) body(std::int64_t{0}, count);
    return;
  }
  const auto runPart = [&](std::int64_t part) { body(count * part / n, count * (part + 1) / n); };
  detail::runParts(
      n, [](const void* run, std::int64_t part) { (*static_cast<decltype(runPart)*>(run))(part); }, &runPart);
}

/// Calls body(i) for begin <= i < end on `threads` threads (0: all), at least `grain` calls a thread: a loop too short
/// to be worth waking others stays on the caller's. Bodies must write to places of their own; sum
/// afterwards in index order, so that results do not depend on the number of threads. Throws what a body throws: of
/// several, that of the lowest i, as one thread does.
template <class Loop>
void parallelFor(std::int64_t begin, std::int64_t end, int threads, const Loop& body, std::int64_t grain = 1) {
  parallelParts(end - begin, threads, grain, [&](std::int64_t first, std::int64_t last) {
    for (std::int64_t i = begin + first; i < begin + last; ++i) body(i);
  });
}

/// Sum of term(begin, end) over ranges of [0, count), added to `zero`. The ranges have one length and are added in
/// their order, so that the sum has the same bits for any number of threads.
template <class Sum, class Term>
Sum parallelSum(std::int64_t count, int threads, Sum zero, const Term& term) {
  constexpr std::int64_t length = 1024;
  const std::int64_t ranges = (count + length - 1) / length;
  if (ranges == 1) return zero + term(std::int64_t{0}, count);
  std::vector<Sum> sums(ranges, zero);
  parallelFor(
      0, ranges, threads,
      [&](std::int64_t range) { sums[range] = term(range * length, std::min(count, (range + 1) * length)); }, 2);
  for (const Sum& part : sums) zero += part;
  return zero;
}
template <class Term>
double parallelSum(std::int64_t count, int threads, const Term& term) {
  return parallelSum(count, threads, 0.0, term);
}

}  // namespace ringwatch
