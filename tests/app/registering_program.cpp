// The program with kinds of its own: each is one file and one line here.
#include <ringwatch/app/command/command_line.h>
#include <ringwatch/body/register_element.h>
#include <ringwatch/body/register_law.h>
#include <tests/added/doubled_metric.h>
#include <tests/added/log_mooney_rivlin.h>
#include <tests/added/plain_format.h>
#include <tests/added/substeps.h>
#include <tests/added/two_halves.h>
#include <tests/added/volume_study.h>
#include <tests/added/wedge15.h>

int main(int argc, char** argv) {
  using namespace ringwatch;
  registerLaw<test::LogMooneyRivlin>();
  registerElement<test::Wedge15>();
  registerIntegrator(integratorEntry<test::TwoHalves>());
  registerMetric(test::doubledMetric);
  registerHandler(handlerEntry<test::Substeps>());
  registerMeshFormat(test::plainFormat);
  registerStudy(test::volumeStudy);
  return runCommandLine(argc, argv);
}
