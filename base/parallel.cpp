#include <ringwatch/base/parallel.h>

#include <exception>

namespace ringwatch::detail {

void runParts(std::int64_t parts, void (*run)(const void* body, std::int64_t part), const void* body) {
  std::exception_ptr first;
  std::int64_t lowest = parts;
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
