#pragma once
#include <ringwatch/verify/report.h>

namespace ringwatch {

/// Whether a better mesh does what a handler does: closed surfaces of badly shaped triangles, like decimated scans,
/// through TetGen's switches and gmsh's optimisers, both called as programs. What is missing is skipped, and told in
/// the table `skipped`.
///
/// Tables: meshes, with sizes, quality, proven and exact critical step at rest and time to mesh; runs, a free body that
/// is stretched and swings, corotational as Fierz 2013's: error against a fine mesh and computing time of plain Verlet
/// at its own step, and with every handler at 0.95 of the step that the mesh would allow without its badly shaped
/// elements; cut_steps and cut_times, the critical step after each of four cuts right through, as they are, and with
/// the pieces meshed anew from their surfaces after each, with the columns and beside the rows of Fierz 2013's
/// Tables 1.1, 1.2 and 1.3, whose bodies and cuts are not public. Times are for information: no check rests on one.
/// Checks: every mesh fills the volume of its surface, its proven step is no longer than the exact one and not much
/// shorter, and so after cuts; the error in a mesh with a volume bound, and what imex and local-time-stepping add to
/// the error of a mesh.
StudyReport verifyRemeshing(StudyEffort effort);

}  // namespace ringwatch
