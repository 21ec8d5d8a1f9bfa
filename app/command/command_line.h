#pragma once

namespace ringwatch {

/// The `ringwatch` program: parses the arguments, runs the command, turns every exception into a line and a status.
/// Returns an ExitStatus (app/command/exit_status.h) as a number.
int runCommandLine(int argc, char** argv);

}  // namespace ringwatch
