#pragma once
#include <ringwatch/verify/report.h>

namespace ringwatch {

/// Holds frequencies and critical steps to published values:
///  - frequencies (Hz): bars with free and held ends and varying numbers of elements, Lamé's mode of a square prism, a
///    simply supported thick plate by the theory of elasticity (Srinivas, Joga Rao & Rao 1970), NAFEMS FV52, the
///    regular tetrahedron of Fierz 2013;
///  - steps (s): lumped bars of linear and of quadratic elements, strain along one axis; each with the proven bracket;
///  - ratios: bounds of uniform-strain elements (Flanagan & Belytschko 1984), penalty stiffness at the end of a bar,
///    estimates of Fierz 2013 over the exact frequency.
/// Each value has its source and how it is printed there. quick: coarser plates and shorter bars.
StudyReport verifyLiterature(StudyEffort effort);

}  // namespace ringwatch
