#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace ringwatch {

/// How a program that was called ended.
struct ProgramResult {
  bool found = true;   // false: there is no such program on the search path
  int status = 0;      // exit status; 128 + signal when it was killed
  std::string output;  // the first 4000 bytes of what it wrote to its outputs but a file
  double seconds = 0;  // of processor time, its own and its children's
};

/// Runs a program (looked up on the search path, without a shell) in a folder and waits for it. Its input is empty.
/// standardOutput: the file that its standard output goes to, all of it; empty: with the rest to ProgramResult::output.
ProgramResult runProgram(const std::vector<std::string>& command, const std::filesystem::path& folder,
                         const std::filesystem::path& standardOutput = {});

}  // namespace ringwatch
