#include <ringwatch/app/command/command_line.h>

/// `ringwatch` with the studies and what writes pages: takes the same arguments.
int main(int argc, char** argv) { return ringwatch::runCommandLine(argc, argv); }
