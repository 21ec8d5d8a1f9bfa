#pragma once
#include <ringwatch/verify/report.h>

namespace ringwatch {

/// Error of the answer against processor time, one thread, of twelve bodies (quick: two) that are held at one side and
/// swing under gravity: explicit integrators in shares of the proven step and of the usual one (pressure wave over the
/// least height), and handlers at multiples of the proven step.
///  - bodies: size, proven, usual and exact step, first frequency;
///  - runs: errors of displacement, strain energy and first frequency against a converged run on the same mesh, time;
///  - cheapest: for each body and rule the quickest run with a displacement error of at most 1 %;
///  - lost: how many runs of each rule were lost.
/// Figures: one a body. Checks: references converge, no run in a share of the proven step is lost, and errors fall with
/// the step.
StudyReport verifyWorkError(StudyEffort effort);

}  // namespace ringwatch
