#pragma once
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

#include <ringwatch/meshes/mesh.h>

namespace ringwatch {

/// Which way a value for the highest frequency errs. Only an upper bound of the frequency may set a step called safe.
enum class Direction { upperBound, lowerBound, estimate };
std::string_view directionName(Direction direction);

/// The highest eigenvalue lambda of M⁻¹K (omega², rad²/s²) lies at or below `value`: proven.
struct UpperBound {
  double value;
};
/// It lies at or below `value` with probability 1 - eta: no proof, and never an UpperBound.
struct ProbableUpperBound {
  double value;
  double eta;
};
/// It lies at or above `value`: proven.
struct LowerBound {
  double value;
};
/// It may lie on either side.
struct Estimate {
  double value;
};

/// The step h = limit / √lambda, s, at which lambda reaches an integrator's stability limit on the imaginary axis;
/// infinity for lambda <= 0.
inline double stepFor(double lambda, double limit) {
  if (std::isnan(lambda)) return std::numeric_limits<double>::quiet_NaN();
  return lambda > 0 ? limit / std::sqrt(lambda) : std::numeric_limits<double>::infinity();
}

/// A step that is safe with probability 1 - eta, s: below the critical one unless chance was against it.
struct ProbableStep {
  double safe;
  double eta;
  int products;  // tangent products it took
};

/// The bracket safe <= h_crit <= optimistic of the critical step at one state, s, both sides proven for the tangent at
/// that state.
struct CriticalStep {
  double safe;
  double optimistic;
  ElementRef controlling;   // the element that holds most of the top mode, as far as it is known
  std::string_view safeBy;  // how the sides were obtained
  std::string_view optimisticBy;
  double lowestRing;  // least eigenvalue seen in any reduced 1-ring, rad²/s²; < 0 proves K indefinite
  ElementRef lowestRingElement;
  std::optional<ProbableStep> probable{};  // when asked for; never part of the proven bracket
};
/// The side of the bracket made from a bound: the types say which.
inline double safeStep(UpperBound lambda, double limit) { return stepFor(lambda.value, limit); }
inline double optimisticStep(LowerBound lambda, double limit) { return stepFor(lambda.value, limit); }

}  // namespace ringwatch
