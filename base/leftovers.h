#pragma once
#include <filesystem>

namespace ringwatch {

/// A file that removeLeftovers() removes while this lives: one that is not whole yet. Of more than 64 at a time some
/// are not known.
class Leftover {
 public:
  explicit Leftover(const std::filesystem::path& path);
  ~Leftover();
  Leftover(const Leftover&) = delete;
  Leftover& operator=(const Leftover&) = delete;

 private:
  const char* name_;  // nullptr where it is not known
  std::size_t slot_;
};

/// Removes the files of all that live. A signal handler may call it.
void removeLeftovers() noexcept;
/// SIGINT, SIGTERM and SIGHUP, where they end the program, remove what is left before.
void removeLeftoversOnSignals();

}  // namespace ringwatch
