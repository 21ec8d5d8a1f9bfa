#pragma once
#include <ringwatch/verify/report.h>

namespace ringwatch {

/// Nonlinear runs as a data set: twenty (quick: three short ones) of bars that are pulled, twisted and compressed and
/// of balls that hang, by elements and laws, with symplectic Euler at a fixed step.
///  - runs: what each run is, when its exact step first lay below its own, when that was said, when the energy was off;
///  - points: the exact step of every n-th state, the bracket that the monitor kept, the step that a certificate of
///  that
///    state proves, energies;
///  - events: what the monitor told.
/// The report's files are the certificates of the points, which `ringwatch-check` proves. Checks hold every bracket and
/// every certificate to the exact step, and every alarm to be true. Figures: exact steps along the runs of each load.
StudyReport verifyHistories(StudyEffort effort);

}  // namespace ringwatch
