#pragma once

namespace ringwatch {

class RankProgram;

/// The `ringwatch` program: parses the arguments, runs the command, turns every exception into a line and a status.
/// Returns an ExitStatus (app/output/exit_status.h) as a number.
/// ranks: the processes that share a run, nullptr in a program of one.
int runCommandLine(int argc, char** argv, const RankProgram* ranks = nullptr);

}  // namespace ringwatch
