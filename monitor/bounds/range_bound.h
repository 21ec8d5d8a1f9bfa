#pragma once
#include <vector>

#include <ringwatch/body/body.h>
#include <ringwatch/monitor/step_limit.h>

namespace ringwatch {

/// Singular values of deformation gradients, 0 < low <= high: stretches of all directions.
struct StretchRange {
  double low, high;
};

/// An upper bound, Pa, of the largest eigenvalue of a law's tangent modulus ∂P/∂F over all deformation gradients whose
/// singular values lie in the range, and a value that is reached in it. Theorem 48, docs/theory/tangent_drift.md.
struct ModulusRange {
  double bound, reached;
  int states;  // at which the modulus was evaluated
};
/// tolerance: the bound is at most this much above the largest modulus that was seen, relative; it stays a bound, and
/// is wider, where `mostStates` do not suffice. Throws InputError for a range that is empty or reaches 0, for a law
/// that a program has registered, and for one that declares no ball.
ModulusRange largestModulus(const Material& material, StretchRange range, double tolerance = 0.01,
                            int mostStates = 200000);

/// What holds for all states of a body whose deformation gradients, at all quadrature points, have their singular
/// values in a range; where a rule has a share at the mean deformation gradient, that one's too.
struct RangeStep {
  double safe;                        // s: stable in every one of these states
  UpperBound lambda;                  // of the highest eigenvalue, rad²/s²
  std::vector<ModulusRange> modulus;  // of each block, Pa
};
/// By one scalar problem on the nodes, K(x) ≼ Σ κ_e L_e ⊗ I with the Laplacians L_e of the elements at rest: Theorem
/// 48, docs/theory/tangent_drift.md. Springs and contact with obstacles count wherever nodes are, with the damping
/// factor that the forces have: Theorem 66, docs/theory/discrete_forces.md. Throws InputError as largestModulus, for
/// elements that damp, for contact of surfaces and for friction.
RangeStep rangeStep(const Body& body, StretchRange range, const StepRule& rule);

}  // namespace ringwatch
