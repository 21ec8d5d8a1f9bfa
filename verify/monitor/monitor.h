#pragma once
#include <ringwatch/verify/report.h>

namespace ringwatch {

/// Holds the monitor to what it claims:
///  - bracket: proven sides against dense eigenvalues on random small meshes of every element and law, held or free, at
///    rest, strained up to 100 %, turned and inverted;
///  - drift: element-and-state trials of the incremental nodal bound along random paths (full: over 1e7), each checked
///  against an
///    exact evaluation;
///  - tetrahedron: the regular tetrahedron's highest frequency over Poisson's ratio, height and size (Fierz 2013,
///  figures
///    3.3 and 3.4) against its closed form;
///  - metrics: every metric against the exact value on several meshes (tables 3.2 to 3.4 in form), each on the side
///  that
///    its direction says;
///  - observed: the bracket against the critical step that bisected real runs show;
///  - histories: bars that are pulled, compressed and twisted, and a ball held at a few nodes in a force field (figures
///    3.9 and 3.11): exact critical step, bracket, reduced 1-ring, and what came first, the alarm or the energy;
///  - cost (full only): the monitor over a plain step of 1e5 tetrahedra, on one thread, in its modes.
/// Figures: a picture a history, the tetrahedron. quick: seconds; full: minutes.
StudyReport verifyMonitor(StudyEffort effort);

}  // namespace ringwatch
