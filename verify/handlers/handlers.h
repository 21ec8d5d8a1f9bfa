#pragma once
#include <ringwatch/verify/report.h>

namespace ringwatch {

/// Runs every handler at a step that is far too large for some elements: a bar with slivers at three quarters of what
/// it could take without them, and a graded cube like Fierz 2013's (5 cm, small elements at one face) at 0.4/0.15 of
/// its certified step.
///
/// Tables: selection, what the certified and Fierz 2013's choice take, and the highest frequency of the explicit part,
/// by Lanczos; motions, errors against plain explicit at a small step and computing time against plain
/// explicit at its own certified step, in one program; energies, long runs of free, spinning, vibrating bars;
/// cutting, see `addCutting`; resonance, where local time stepping is unstable (resonance.h).
/// Times are for information: no check rests on one.
/// Checks: the certified rest is below the frequency that the step allows; the mean error of every motion by imex and
/// local-time-stepping, and by fe-pbd and modal-filter on the bar, where they handle less than half of the elements.
/// With dissipation: largest energy; linear momentum to rounding; angular momentum by imex, whose K̂ does not resist
/// rotations of the body at rest, but does once it is strained, by local-time-stepping, and to rounding by fe-pbd and
/// modal-filter. What has no dissipation, mass scaling among it, is reported, not checked.
StudyReport verifyHandlers(StudyEffort effort);

}  // namespace ringwatch
