#include <ringwatch/app/command/command_line.h>
#include <ringwatch/app/report/run_report.h>

namespace ringwatch {

ReportWriter reportWriter() { return nullptr; }

}  // namespace ringwatch

/// `ringwatch` with the studies: takes the same arguments.
int main(int argc, char** argv) { return ringwatch::runCommandLine(argc, argv); }
