#pragma once
#include <ringwatch/verify/report.h>

namespace ringwatch {

/// Holds frequencies and critical steps to published values:
///  - frequencies (Hz): bars with free and held ends and varying numbers of elements, Lamé's mode of a square prism, a
///    simply supported thick plate by the theory of elasticity (Lamb 1917; Srinivas, Joga Rao & Rao 1970), NAFEMS FV52;
///  - steps (s): lumped bars of linear and of quadratic elements, penalties of stiffness and mass (Askes,
///    Caramés-Saddler & Rodríguez-Ferran 2010), strain along one axis, squares and triangles, regular and distorted, in
///    plane strain (Askes, Rodríguez-Ferran & Hetherington 2015); each with the proven bracket;
///  - ratios: rows and squares of squares by number and supports (Plešek, Kolman & Gabriel 2012), bounds of
///    uniform-strain elements (Flanagan & Belytschko 1984), penalty stiffness at the end of a bar, a wave at the
///    critical step, frequencies and estimates of Fierz 2013.
/// Each value has its source and how it is printed there. quick: coarser plates and shorter bars.
StudyReport verifyLiterature(StudyEffort effort);

}  // namespace ringwatch
