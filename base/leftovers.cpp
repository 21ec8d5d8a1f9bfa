#include <ringwatch/base/leftovers.h>

#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <cstring>

namespace ringwatch {
namespace {

using Name = std::atomic<const char*>;
static_assert(Name::is_always_lock_free, "a signal handler may only touch lock-free atomics");
std::array<Name, 64> names{};

extern "C" void onEndingSignal(int number) {
  removeLeftovers();
  std::signal(number, SIG_DFL);
  std::raise(number);
}

}  // namespace

Leftover::Leftover(const std::filesystem::path& path) : name_(::strdup(path.c_str())), slot_(0) {
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

void removeLeftovers() noexcept {
  for (Name& name : names)
    if (const char* own = name.exchange(nullptr)) ::unlink(own);
}

void removeLeftoversOnSignals() {
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction before {};
    if (::sigaction(number, nullptr, &before) != 0 || before.sa_handler != SIG_DFL) continue;
    std::signal(number, onEndingSignal);
  }
}

}  // namespace ringwatch
