#pragma once
#include <string_view>

#include <ringwatch/base/infinity.h>
#include <ringwatch/base/name_table.h>

namespace ringwatch {

/// Which way a value for the highest frequency errs. Only an upper bound of the frequency may set a step called safe
/// (Theorem 27, docs/theory/integrators.md).
enum class Direction { upperBound, lowerBound, estimate };
inline constexpr auto directionNames = nameTable<Direction>({
    {Direction::upperBound, "upper-bound"},
    {Direction::lowerBound, "lower-bound"},
    {Direction::estimate, "estimate"},
});
constexpr std::string_view directionName(Direction direction) { return directionNames.nameOf(direction); }

/// The highest eigenvalue lambda of M⁻¹K over the free degrees of freedom (omega², rad²/s²; 0 where none is positive)
/// lies at or below `value`: proven.
struct UpperBound {
  double value;
};
/// It lies at or below `value` with probability 1 - eta: no proof, and never an UpperBound.
struct ProbableUpperBound {
  double value;
  double eta;
};
/// It lies at or above `value`: proven. Of a quotient it is known how much of that dashpots give: between dampingFrom
/// and dampingTo (DiscreteForces::dampingForm). Where that is not known it may be none or all.
struct LowerBound {
  double value;
  double dampingFrom = 0, dampingTo = infinity;

  /// What damping holds of it, at least.
  double dampingShare() const { return value > 0 ? dampingFrom / value : 0; }
};
/// The higher one.
inline LowerBound higher(LowerBound a, LowerBound b) { return b.value > a.value ? b : a; }
/// It may lie on either side.
struct Estimate {
  double value;
};

}  // namespace ringwatch
