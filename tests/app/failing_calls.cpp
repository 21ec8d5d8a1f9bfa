// Loaded before the C library: from the start of main on, the call FAIL_AT of the kind FAIL_CALL fails, once, in
// programs whose name begins with ringwatch. The number of calls of the kind goes into the file FAIL_COUNT when the
// program ends. Of the kinds "memory" is an allocation of 2000 bytes or more that fails when it is tried once more,
// too, and "short" a write of half of what it is given. "signal" is any call on files, none of which fails: SIGTERM
// comes before it. What VTK and OpenMP call is passed over: they end the process by a signal or a line of their own
// then.
#include <dirent.h>
#include <dlfcn.h>
#include <execinfo.h>
#include <fcntl.h>
#include <pthread.h>
#include <sys/mman.h>
#include <sys/uio.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <string_view>
#include <utility>

extern "C" {
// What the C library's own allocation is called behind the names that are replaced here.
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
}

namespace {

constinit std::atomic<long> calls = 0;
constinit std::string_view chosen;  // empty before main
constinit long failing = -1;

/// Whether the call that is under way came through a library that does not bear a failure.
bool isPassedOver() {
  void* frames[64];
  const std::string_view kind = std::exchange(chosen, {});  // what is called here does not count
  const int count = backtrace(frames, static_cast<int>(std::size(frames)));
  const bool passed = std::any_of(frames, frames + count, [](void* frame) {
    Dl_info found{};
    const std::string_view file = dladdr(frame, &found) != 0 && found.dli_fname ? found.dli_fname : "";
    return file.find("/libvtk") != file.npos || file.find("/libgomp") != file.npos;
  });
  chosen = kind;
  return passed;
}

bool fails(std::string_view kind, int reason, long times = 1) {
  if (chosen == "signal") {
    constexpr std::string_view ofFiles = "open write fsync rename read";
    if (ofFiles.find(kind) != ofFiles.npos && calls++ == failing) std::raise(SIGTERM);
    return false;
  }
  if (kind != chosen) return false;
  const long call = calls++ - failing;
  if (failing < 0 || call < 0 || call >= times || isPassedOver()) return false;
  errno = reason;
  return true;
}
bool allocationFails(std::size_t size) {
  constexpr std::size_t large = 2000;
  return fails("allocation", ENOMEM) || (size >= large && fails("memory", ENOMEM, 2));
}

template <class Function>
Function* next(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

[[gnu::destructor]] void tell() {
  const long count = calls;
  const char* const name = std::getenv("FAIL_COUNT");
  if (chosen.empty() || !name) return;
  chosen = {};
  if (std::FILE* file = std::fopen(name, "w")) {
    std::fprintf(file, "%ld\n", count);
    std::fclose(file);
  }
}

using Main = int(int, char**, char**);
Main* realMain = nullptr;

int armedMain(int argc, char** argv, char** environment) {
  const char *const kind = std::getenv("FAIL_CALL"), *const at = std::getenv("FAIL_AT");
  if (at) failing = std::atol(at);
  if (kind && std::string_view(program_invocation_short_name).starts_with("ringwatch")) chosen = kind;
  return realMain(argc, argv, environment);
}

mode_t modeOf(int flags, std::va_list arguments) {
  return (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(arguments, mode_t) : 0;
}

}  // namespace

extern "C" {

int __libc_start_main(Main* main, int argc, char** argv, void (*init)(), void (*fini)(), void (*ofLoader)(),
                      void* stack) {
  realMain = main;
  static const auto start = next<decltype(__libc_start_main)>("__libc_start_main");
  return start(armedMain, argc, argv, init, fini, ofLoader, stack);
}

void* malloc(std::size_t size) noexcept { return allocationFails(size) ? nullptr : __libc_malloc(size); }
void* calloc(std::size_t count, std::size_t size) noexcept {
  return allocationFails(count * size) ? nullptr : __libc_calloc(count, size);
}
void* realloc(void* old, std::size_t size) noexcept {
  return allocationFails(size) ? nullptr : __libc_realloc(old, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  return allocationFails(size) ? nullptr : __libc_memalign(alignment, size);
}
int posix_memalign(void** result, std::size_t alignment, std::size_t size) noexcept {
  void* const found = aligned_alloc(alignment, size);
  if (found) *result = found;
  return found ? 0 : ENOMEM;
}

#define FAILING_OPEN(name)                                           \
  int name(const char* path, int flags, ...) {                       \
    std::va_list arguments;                                          \
    va_start(arguments, flags);                                      \
    const mode_t mode = modeOf(flags, arguments);                    \
    va_end(arguments);                                               \
    static const auto original = next<decltype(name)>(#name);        \
    return fails("open", EMFILE) ? -1 : original(path, flags, mode); \
  }
FAILING_OPEN(open)
FAILING_OPEN(open64)
#define FAILING_OPENAT(name)                                                 \
  int name(int folder, const char* path, int flags, ...) {                   \
    std::va_list arguments;                                                  \
    va_start(arguments, flags);                                              \
    const mode_t mode = modeOf(flags, arguments);                            \
    va_end(arguments);                                                       \
    static const auto original = next<decltype(name)>(#name);                \
    return fails("open", EMFILE) ? -1 : original(folder, path, flags, mode); \
  }
FAILING_OPENAT(openat)
FAILING_OPENAT(openat64)

// FAILING(KIND, REASON, RESULT of a failure, TYPE, NAME, PARAMETERS, ARGUMENTS)
#define FAILING(kind, reason, failure, type, name, parameters, arguments) \
  type name parameters {                                                  \
    static const auto original = next<decltype(name)>(#name);             \
    return fails(kind, reason) ? failure : original arguments;            \
  }
FAILING("open", EMFILE, nullptr, std::FILE*, fopen, (const char* path, const char* mode), (path, mode))
FAILING("open", EMFILE, nullptr, std::FILE*, fopen64, (const char* path, const char* mode), (path, mode))
FAILING("open", EMFILE, nullptr, DIR*, opendir, (const char* path), (path))
FAILING("fsync", EIO, -1, int, fsync, (int file), (file))
FAILING("rename", EIO, -1, int, rename, (const char* from, const char* to) noexcept, (from, to))
FAILING("read", EIO, -1, ssize_t, read, (int file, void* data, std::size_t size), (file, data, size))
FAILING("mmap", ENOMEM, MAP_FAILED, void*, mmap,
        (void* at, std::size_t size, int protection, int flags, int file, off_t from) noexcept,
        (at, size, protection, flags, file, from))
FAILING("mmap", ENOMEM, MAP_FAILED, void*, mmap64,
        (void* at, std::size_t size, int protection, int flags, int file, off_t from) noexcept,
        (at, size, protection, flags, file, from))
FAILING("thread", EAGAIN, EAGAIN, int, pthread_create,
        (pthread_t * thread, const pthread_attr_t* attributes, void* (*work)(void*), void* data) noexcept,
        (thread, attributes, work, data))

// What is told on standard error is the test's to read.
ssize_t write(int file, const void* data, std::size_t size) {
  static const auto original = next<decltype(write)>("write");
  if (file == STDERR_FILENO) return original(file, data, size);
  if (size > 1 && fails("short", 0)) return original(file, data, size / 2);
  return fails("write", ENOSPC) ? -1 : original(file, data, size);
}
ssize_t writev(int file, const iovec* parts, int count) {
  static const auto original = next<decltype(writev)>("writev");
  if (file == STDERR_FILENO) return original(file, parts, count);
  if (count > 1 && fails("short", 0)) return original(file, parts, 1);
  return fails("write", ENOSPC) ? -1 : original(file, parts, count);
}

}  // extern "C"
