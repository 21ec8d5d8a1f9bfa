#pragma once
#include <ringwatch/verify/report.h>

namespace ringwatch {

/// Adds Fierz 2013's cutting experiment (section 4.5.3): a clamped, swinging bar of tetrahedra is cut four times:
/// across, by a slit from above, from the side, and by a wedge. Plain Verlet goes on in its falling certified step,
/// every handler in the step that it began with. Table cutting, a row a cut and method: elements, handled, evaluated
/// again and in what time, critical step of the whole body, computing time a simulated second. Checks: the critical
/// step falls to a fifth or less; no handler is lost, none gains more than 2 % of energy over the start but mass
/// scaling, whose mass comes with the velocity of its node.
void addCutting(StudyEffort effort, StudyReport& report);

}  // namespace ringwatch
