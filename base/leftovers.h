#pragma once
#include <filesystem>

namespace ringwatch {

/// A file or a folder with all in it that removeLeftovers() removes while this lives: a file that is not whole yet, a
/// temporary folder. Of more than 64 at a time some are not known.
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

/// A program, by its process, that removeLeftovers() ends while this lives: it would work on for nobody. Of more than
/// 64 at a time some are not known.
class LeftoverProgram {
 public:
  explicit LeftoverProgram(int process);
  ~LeftoverProgram();
  LeftoverProgram(const LeftoverProgram&) = delete;
  LeftoverProgram& operator=(const LeftoverProgram&) = delete;

 private:
  int process_;
};

/// Ends the programs and removes the files and folders of all that live. A signal handler may call it.
void removeLeftovers() noexcept;
/// SIGINT, SIGTERM and SIGHUP, where they end the program, remove what is left before.
void removeLeftoversOnSignals();

}  // namespace ringwatch
