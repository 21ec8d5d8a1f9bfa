#pragma once
#include <span>

#include <ringwatch/integrators/integrator.h>
#include <ringwatch/verify/report.h>

namespace ringwatch {

/// Who survives what: small St. Venant–Kirchhoff bodies run long (full: 1e6 steps) at 0.5, 0.9, 0.99 and 1.01 of the
/// limit; with a stiffness contrast of 1e8, a Poisson ratio of 0.4999, a sliver flat to 1e-6, from random states; and
/// spinning freely for 100 turns. Explicit integrators with a limit only.
///
/// Table: robustness, with the largest change of energy and of momentum; checks: all below the limit stay bounded, all
/// above blow up, and a spinning body keeps its angular momentum.
StudyReport verifyRobustness(StudyEffort effort, std::span<const IntegratorEntry> integrators = coreIntegrators());

}  // namespace ringwatch
