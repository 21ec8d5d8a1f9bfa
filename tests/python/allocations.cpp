// Stands in for malloc, posix_memalign and aligned_alloc in a process that loads this library first (LD_PRELOAD), and
// counts the allocations that are as large as an array: a copy of a state would be one.
#include <dlfcn.h>

#include <atomic>
#include <cstddef>

namespace {

std::atomic<std::size_t> threshold{~std::size_t{0}};
std::atomic<int> large{0};

void count(std::size_t size) {
  if (size >= threshold) ++large;
}
template <class Function>
Function* next(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" {

void* malloc(std::size_t size) {
  static auto* const original = next<void*(std::size_t)>("malloc");
  count(size);
  return original(size);
}
int posix_memalign(void** memory, std::size_t alignment, std::size_t size) {
  static auto* const original = next<int(void**, std::size_t, std::size_t)>("posix_memalign");
  count(size);
  return original(memory, alignment, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  static auto* const original = next<void*(std::size_t, std::size_t)>("aligned_alloc");
  count(size);
  return original(alignment, size);
}

/// Allocations of the size asked for last or more since the last call; from now on those of this size.
int ringwatch_large_allocations(std::size_t size) {
  threshold = size;
  return large.exchange(0);
}
}
