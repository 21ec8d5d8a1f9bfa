#pragma once

/// The constants of the rounding budget: what stands between a computed number and the statement in exact arithmetic
/// that it is taken for. Each is a row of the table of margins, docs/theory/floating_point.md, with what it is relative
/// to, and whether it is derived or asserted.
namespace ringwatch {

/// u: half the distance from 1 to the next double.
inline constexpr double unitRoundoff = 0x1p-53;

// Theorem 42: the tangent of an element. In units of u; `condition` is |edges| |∂N/∂ξ| |J⁻¹| at a point.
/// Of F, relative to the condition in the present state; nodes of the element are added.
inline constexpr double gradientRounding = 24;
/// Of shape gradients and weights, relative to the condition at rest.
inline constexpr double shapeRounding = 48;
/// Both for elements of constant gradient, whose ∂N/∂ξ are exact.
inline constexpr double simplexGradientRounding = 8, simplexShapeRounding = 16;
/// Of the products of a law's tangent with shape gradients, of sums over points, of scaling by weights, and of sums at
/// nodes, relative to the norm of the law's tangent.
inline constexpr double productRounding = 128;
/// Of a law's tangent as it is evaluated, relative to the sum of the sizes of its terms.
inline constexpr double lawRounding = 24;

/// Of an eigenvalue, relative to the Gershgorin radius of the matrix as computed: Theorem 43. 9e4 u; the largest matrix
/// is 60×60.
inline constexpr double eigenvalueRounding = 1e-11;
/// Of a Rayleigh quotient, relative to the largest size of an eigenvalue, beside what its sums add: Theorem 44.
inline constexpr double quotientRounding = 1e-12;

// Matrices of more than one element.
/// Of the highest eigenvalue of an element's ring, relative to the largest size of one; of the zero eigenvalues of its
/// constrained components.
inline constexpr double ringRounding = 1e-12, constrainedRounding = 1e-10;
/// Of quotients that show negative stiffness, relative to the norm of the scaled tangent.
inline constexpr double negativeQuotientRounding = 1e-10;
/// Of the matrices that the exchange bound moves about, relative to the largest norm of an element's so far.
inline constexpr double exchangeRounding = 1e-12;
/// Of the scaled matrix that is factored, relative to its norm and the eigenvalue.
inline constexpr double assemblyRounding = 1e-12;
/// Pivots of a factorisation: times Theorem 41's bound, which covers the rounding of the diagonal as well.
inline constexpr double pivotBounds = 4;
/// Of Lanczos' matrix, relative to its norm: 64 u.
inline constexpr double lanczosRounding = 64 * unitRoundoff;
/// Of the eigenvalues of a modulus over a range of stretches, relative to its largest entry.
inline constexpr double modulusRounding = 1e-12;
/// Of tangents that are handed over: of entries scaled by blocks of mass, 2 · 6 products and a factor, and of quotients
/// and sums, relative to the sums of the sizes of what they are summed from.
inline constexpr double givenScalingRounding = 4e-15, givenSumRounding = 1e-12;

// Along a run.
/// Kept free of every allowance for the rounding of the sums that it was computed from, relative.
inline constexpr double allowanceRounding = 1e-12;
/// By which a majorant of discrete forces may seem to have risen at its own state, relative to its trace.
inline constexpr double majorantRounding = 1e-12;
/// Of directions that are computed from positions, in majorants and forms of discrete forces, relative.
inline constexpr double directionRounding = 1e-9;
/// Kept free of a validity radius for the rounding of its own computation, relative.
inline constexpr double radiusRounding = 1e-6;
/// Of a distance that is the root of a sum of nine squares, relative.
inline constexpr double distanceRounding = 1e-15;
/// Kept free of a validity ball for the rounding of the distances that are compared with it, and of a ball about the
/// centre of a batch, so that an element which is inside that one is inside its own by any rounding: relative.
inline constexpr double ballRounding = 1e-9, commonBallRounding = 1e-6;
/// Of 2 tr E + 3 - 2C:F + |C|², by which distances from a centre C are compared, 2 tr E + 3 = |F|², over |C|² + r² + 3,
/// r the radius. Where |F| <= 2 (|C| + r) the sizes of its 33 products and differences add up to 17 (|C|² + r²) + 6 at
/// most and err by less than 33 · 2⁻⁵³ of that, 6.3e-14; beyond, the square of the distance exceeds r² by |F|²/4.
inline constexpr double commonSquareRounding = 1e-13;
/// The ball test on a GPU, in single precision: relative to the radius, and absolute, times 1 + |F|.
inline constexpr double deviceBallRounding = 1e-5, deviceGradientRounding = 1e-6;

// Laws, where the drift of the tangent is bounded.
/// Of the corotational law's lower bound of g, relative to |F|; of the neo-Hookean law's w², relative.
inline constexpr double leastGapRounding = 1e-7, largestInverseRounding = 1e-7;

// Handlers.
/// Kept free of lambda for the rounding of sums and small eigenvalues of a selection, relative; where sums are checked
/// along a run, less than a new choice leaves, whose sums are the same but for rounding.
inline constexpr double selectionRounding = 1e-9, checkedSelectionRounding = 0.5 * selectionRounding;
/// Reference gradients of a selection are stored in single precision: a stored one is off by less, relative.
inline constexpr double storedGradientRounding = 1e-7;
/// Mass scaling: of element values, and of the mass that a node needs, relative.
inline constexpr double scaledValueRounding = 1e-9, addedMassRounding = 1e-12;

// Certificate files.
/// Left between what is computed and what is stated, relative: sums at nodes, and allowances that stand for zero, must
/// be proven with strict inequalities. It is 5e-10 of the step.
inline constexpr double statedRounding = 1e-9;

}  // namespace ringwatch
