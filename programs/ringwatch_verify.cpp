#include <ringwatch/app/command/command_line.h>
#include <ringwatch/app/command/verify.h>
#include <ringwatch/app/scene/integrator_catalog.h>
#include <ringwatch/extensions/extensions.h>
#include <ringwatch/extensions/fierz2013/fierz2013.h>

/// `ringwatch` with the studies and what writes pages: takes the same arguments.
int main(int argc, char** argv) {
  using namespace ringwatch;
  registerExtensions();
  registerStudy({"fierz2013",
                 "Fierz's cube and bar with small elements, stretched, compressed, bent and twisted with every handler",
                 [](StudyEffort effort) { return verifyFierz2013(effort, integratorCatalog().entries()); },
                 "deformations"});
  return runCommandLine(argc, argv);
}
