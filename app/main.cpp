#include <ringwatch/app/command_line.h>

int main(int argc, char** argv) { return ringwatch::runCommandLine(argc, argv); }
