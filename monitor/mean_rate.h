#pragma once
#include <cmath>

namespace ringwatch {

/// The mean of two values of a rate, or of a force, between which a work is summed. One that is no number, as of an
/// element that is inverted and about to leave, counts as the other; where both are none, 0.
inline double meanRate(double before, double now) {
  if (!std::isfinite(before)) before = now;
  if (!std::isfinite(now)) now = before;
  return std::isfinite(before) ? 0.5 * (before + now) : 0;
}

}  // namespace ringwatch
