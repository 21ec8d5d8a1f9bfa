#include <ringwatch/app/command/process.h>

#include <fcntl.h>
#include <pthread.h>
#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <cctype>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <string_view>
#include <thread>

#include <fmt/format.h>

#include <ringwatch/app/output/exit_status.h>
#include <ringwatch/base/error.h>

namespace ringwatch {
namespace {

constexpr std::size_t enoughStack = std::size_t{1} << 20;  // the loops over elements take up to 150 kB
constexpr std::size_t ownStack = std::size_t{8} << 20;

/// OMP_STACKSIZE in bytes: a number and B, K (without a unit), M or G; 0 for what it is not.
std::size_t stackSizeOf(std::string_view text) {
  const auto trim = [&] {
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front()))) text.remove_prefix(1);
  };
  trim();
  std::size_t size = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), size);
  if (error != std::errc()) return 0;
  text.remove_prefix(stop - text.data());
  trim();
  switch (text.empty() ? 'K' : std::toupper(static_cast<unsigned char>(text.front()))) {
    case 'B':
      return size;
    case 'K':
      return size << 10;
    case 'M':
      return size << 20;
    case 'G':
      return size << 30;
    default:
      return 0;
  }
}

void requireThreadStacks() {
  for (const char* name : {"OMP_STACKSIZE", "GOMP_STACKSIZE"}) {
    const char* const text = std::getenv(name);
    if (text == nullptr) continue;
    const std::size_t size = stackSizeOf(text);
    if (size > 0 && size < enoughStack)
      throw InputError(fmt::format("{} = {}: threads need a stack of 1M at least; raise it, or unset it", name, text));
    return;
  }
}

}  // namespace

void holdStandardStreams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    // open() takes the lowest number that is free.
    if (::fcntl(stream, F_GETFD) < 0 && ::open("/dev/null", stream == STDERR_FILENO ? O_WRONLY : O_RDONLY) != stream)
      return;
}

void keepMemoryInReserve() {
  constexpr std::size_t reserve = std::size_t{1} << 20;  // for what an end writes: messages, a summary
  static std::atomic<char*> kept = nullptr;
  static const std::terminate_handler abort = std::get_terminate();
  if (std::get_new_handler()) return;
  kept = new (std::nothrow) char[reserve];
  std::set_new_handler([] {
    const char* const given = kept.exchange(nullptr);
    if (!given) throw std::bad_alloc();
    delete[] given;
  });
  std::set_terminate([] {
    try {
      if (std::current_exception()) throw;
    } catch (const std::bad_alloc&) {  // where nothing may throw, as in a destructor
      std::fputs("ringwatch: out of memory; use a smaller mesh or more memory\n", stderr);
      ::_exit(static_cast<int>(ExitStatus::unstable));
    } catch (...) {
    }
    abort();
  });
}

void reportFileSizeLimit() { std::signal(SIGXFSZ, SIG_IGN); }

void onLargeStack(const std::function<void()>& work) {
  requireThreadStacks();
  struct rlimit limit {};
  if (::getrlimit(RLIMIT_STACK, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY || limit.rlim_cur >= enoughStack)
    return work();
#ifdef __GLIBC__
  // What threads get that do not ask, those of OpenMP among them.
  pthread_attr_t attributes;
  ::pthread_attr_init(&attributes);
  ::pthread_attr_setstacksize(&attributes, ownStack);
  ::pthread_setattr_default_np(&attributes);
  ::pthread_attr_destroy(&attributes);
#endif
  std::exception_ptr fault;
  std::thread([&] {
    try {
      work();
    } catch (...) {
      fault = std::current_exception();
    }
  }).join();
  if (fault) std::rethrow_exception(fault);
}

}  // namespace ringwatch
