#include <ringwatch/base/leftovers.h>

#include <dirent.h>
#include <fcntl.h>
#include <pthread.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>

namespace ringwatch {
namespace {

using Name = std::atomic<const char*>;
static_assert(Name::is_always_lock_free, "a signal handler may only touch lock-free atomics");
std::array<Name, 64> names{};
std::array<std::atomic<int>, 64> programs{};  // processes; 0 for none
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler may only touch lock-free atomics");

#ifdef __linux__
/// Removes a file, or a folder with all in it. What opendir() does a signal handler may not: it takes memory.
bool removeAll(int folder, const char* name) noexcept {
  if (::unlinkat(folder, name, 0) == 0 || errno == ENOENT) return true;
  const int own = ::openat(folder, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (own < 0) return false;
  alignas(dirent64) char buffer[4096];  // of entries
  for (ssize_t bytes = 0; (bytes = ::getdents64(own, buffer, sizeof buffer)) > 0;)
    for (ssize_t at = 0; at < bytes;) {
      const auto* const entry = reinterpret_cast<const dirent64*>(buffer + at);
      if (std::strcmp(entry->d_name, ".") != 0 && std::strcmp(entry->d_name, "..") != 0) removeAll(own, entry->d_name);
      at += entry->d_reclen;
    }
  ::close(own);
  return ::unlinkat(folder, name, AT_REMOVEDIR) == 0;
}
#else
bool removeAll(int folder, const char* name) noexcept {
  return ::unlinkat(folder, name, 0) == 0 || ::unlinkat(folder, name, AT_REMOVEDIR) == 0;
}
#endif

/// What another process has begun is not left by this one, which fork() made of it.
extern "C" void forgetInChild() {
  for (Name& name : names) name = nullptr;
  for (std::atomic<int>& program : programs) program = 0;
}
void forgetOnFork() { static const int once [[maybe_unused]] = ::pthread_atfork(nullptr, nullptr, forgetInChild); }

extern "C" void onEndingSignal(int number) {
  removeLeftovers();
  std::signal(number, SIG_DFL);
  std::raise(number);
}

}  // namespace

Leftover::Leftover(const std::filesystem::path& path) : name_(::strdup(path.c_str())), slot_(0) {
  forgetOnFork();
  const char* none = nullptr;
  while (slot_ < names.size() && !names[slot_].compare_exchange_strong(none, name_)) {
    none = nullptr;
    ++slot_;
  }
}

Leftover::~Leftover() {
  const char* own = name_;
  // A name that a handler has taken stays: it may be reading it.
  if (slot_ == names.size() || names[slot_].compare_exchange_strong(own, nullptr)) std::free(const_cast<char*>(name_));
}

LeftoverProgram::LeftoverProgram(int process) : process_(process) {
  forgetOnFork();
  for (std::atomic<int>& program : programs)
    if (int none = 0; program.compare_exchange_strong(none, process)) return;
}

LeftoverProgram::~LeftoverProgram() {
  for (std::atomic<int>& program : programs)
    if (int own = process_; program.compare_exchange_strong(own, 0)) return;
}

void removeLeftovers() noexcept {
  for (std::atomic<int>& program : programs)
    if (const int process = program.exchange(0); process > 0) ::kill(process, SIGKILL);
  for (Name& name : names) {
    // Other threads, and a program that is not gone yet, may write into a folder meanwhile.
    constexpr int tries = 100;
    if (const char* own = name.exchange(nullptr))
      for (int i = 0; i < tries && !removeAll(AT_FDCWD, own); ++i) {
      }
  }
}

void removeLeftoversOnSignals() {
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction before {};
    if (::sigaction(number, nullptr, &before) != 0 || before.sa_handler != SIG_DFL) continue;
    std::signal(number, onEndingSignal);
  }
}

}  // namespace ringwatch
