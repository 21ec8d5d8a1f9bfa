#pragma once
#include <optional>

#include <ringwatch/integrators/integrator.h>

namespace ringwatch {

/// Whether T, the step of an oscillator, has its eigenvalues in the unit disc: the Jury conditions |det| <= 1 and
/// |trace| <= 1 + det, each with a slack of 1e-12 for rounding.
bool isStableAmplification(const Eigen::Matrix2d& T);

/// Largest z = h·omega for which an integrator, by its own declaration, is stable at this and every smaller step on an
/// oscillator of damping ratio ξ >= 0: the closed form where there is one, else by scan and bisection of the declared
/// amplification (to 1e-12 relative). Infinity when there is no limit, nothing when nothing is declared for ξ > 0.
std::optional<double> declaredLimit(const IntegratorInfo& info, double dampingRatio);

/// Critical step, s, of a system with Rayleigh damping whose modes have omega² anywhere in [0, lambda] (rad²/s²): the
/// least h(omega) = declaredLimit(ξ(omega)) / omega over these modes, ξ = alpha/(2 omega) + beta omega/2. It does not
/// grow with lambda, so an upper bound of the highest eigenvalue gives a safe step. Nothing when the integrator
/// declares nothing for damped problems; infinity for lambda <= 0 without damping.
///
/// Which mode binds. In p = h² omega², q = h (alpha + beta omega²) = 2 ξ z every scheme's step is a function of (p, q)
/// alone (its trace and determinant are), and for a given h the modes of [0, lambda] lie on a straight line in that
/// plane. Symplectic Euler and Verlet are stable where p + 2 q <= 4, and p + 2 q grows with omega: the highest mode
/// binds, always, and
///   h = 4 / (c + √(c² + 4 lambda)), c = alpha + beta lambda.
/// So for these two the step of a lower bound of lambda is proven optimistic as well (Theorem 30,
/// docs/theory/integrators.md). Other schemes have regions that
/// are not convex, and with explicit Euler the lowest mode can bind (q <= 2 at omega = 0): for them the least of 65
/// modes, evenly spaced in omega, is taken and refined between its neighbours. That is a search, not a proof.
std::optional<double> dampedStep(double lambda, const RayleighDamping& damping, const IntegratorInfo& info);

}  // namespace ringwatch
