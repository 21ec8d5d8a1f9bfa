#pragma once

namespace ringwatch {

/// Exit statuses of the program.
enum ExitStatus : int {
  exitStable = 0,    ///< done and stable
  exitUnstable = 1,  ///< a run or a check failed: instability found, bound violated, no convergence
  exitUsage = 2      ///< bad usage or input, with one line on standard error
};

/// The `ringwatch` program: parses the arguments, runs the command, turns every exception into a line and a status.
int runCommandLine(int argc, char** argv);

}  // namespace ringwatch
