// Loaded before the C library, a malloc that fails once: at the call FAIL_AT of those for FAIL_LEAST bytes or more.
// Prints how many there were where FAIL_COUNT is set.
#include <dlfcn.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>

namespace {

constinit std::atomic<long> calls = 0;

long setting(const char* name, long otherwise) {
  const char* text = std::getenv(name);
  return text ? std::atol(text) : otherwise;
}

[[gnu::destructor]] void tell() {
  if (std::getenv("FAIL_COUNT")) std::fprintf(stderr, "\nallocations %ld\n", calls.load());
}

}  // namespace

extern "C" void* malloc(std::size_t size) noexcept {
  static const auto allocate = reinterpret_cast<void* (*)(std::size_t)>(dlsym(RTLD_NEXT, "malloc"));
  static const long failing = setting("FAIL_AT", -1), least = setting("FAIL_LEAST", 0);
  if (static_cast<long>(size) < least || calls++ != failing) return allocate(size);
  errno = ENOMEM;
  return nullptr;
}
