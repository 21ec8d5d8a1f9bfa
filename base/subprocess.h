#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace ringwatch {

/// How a program that was called ended.
struct ProgramResult {
  bool found = true;   // false: there is no such program on the search path
  int status = 0;      // exit status; 128 + signal when it was killed
  std::string output;  // the first 4000 bytes of what it wrote to its outputs
  double seconds = 0;  // of processor time, its own and its children's
};

/// Runs a program (looked up on the search path, without a shell) in a folder and waits for it. Its input is empty.
ProgramResult runProgram(const std::vector<std::string>& command, const std::filesystem::path& folder);

}  // namespace ringwatch
