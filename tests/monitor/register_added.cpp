#include <tests/monitor/register_added.h>

#include <ringwatch/body/register_element.h>
#include <ringwatch/body/register_law.h>
#include <tests/added/log_mooney_rivlin.h>
#include <tests/added/wedge15.h>

namespace ringwatch::test {

void registerWedge15() { registerElement<Wedge15>(); }
void registerLogMooneyRivlin() { registerLaw<LogMooneyRivlin>(); }

}  // namespace ringwatch::test
