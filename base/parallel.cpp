#include <ringwatch/base/parallel.h>

#include <atomic>
#include <exception>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include <ringwatch/base/error.h>

namespace ringwatch::detail {
namespace {

/// OpenMP ends the process where it cannot start a thread. So as many as it would start are tried here first, all at a
/// time, once for each calling thread, which has threads of its own.
void requireThreads(std::int64_t parts) {
  static thread_local std::int64_t tried = 1;
  if (parts <= tried) return;
  std::vector<std::thread> threads;
  std::atomic<bool> go = false;
  std::string fault;
  try {
    threads.reserve(parts);
    while (std::ssize(threads) < parts - tried) threads.emplace_back([&go] { go.wait(false); });
  } catch (const std::system_error& error) {
    fault = error.code().message();
  }
  go = true;
  go.notify_all();
  for (std::thread& thread : threads) thread.join();
  if (!fault.empty())
    throw InputError(joinText("cannot start ", parts, " threads: ", fault, "; use fewer, or allow more"));
  tried = parts;
}

}  // namespace

void runParts(std::int64_t parts, void (*run)(const void* body, std::int64_t part), const void* body) {
  std::exception_ptr first;
  std::int64_t lowest = parts;
  requireThreads(parts);
#pragma omp parallel for schedule(static, 1) num_threads(static_cast <int>(parts))
  for (std::int64_t part = 0; part < parts; ++part) {
    try {
      run(body, part);
    } catch (...) {
#pragma omp critical(ringwatch_first_exception)
      if (part < lowest) {
        lowest = part;
        first = std::current_exception();
      }
    }
  }
  if (first) std::rethrow_exception(first);
}

}  // namespace ringwatch::detail
