#include <ringwatch/handlers/mass_scaling/step_division.h>

#include <algorithm>

namespace ringwatch {
namespace {

/// Parts that a step is divided into at most. What needs more is not proven.
constexpr int mostParts = 1000;
/// A part of a divided step is that share of what is proven at most: elements that stiffen at speed have room before
/// the next choice.
constexpr double shareOfProven = 0.5;
/// Parts after which fewer are tried, twice as many after each try in vain. A choice costs as much as some forty
/// forces.
constexpr std::int64_t leastPatience = 512;

}  // namespace

void StepDivision::choose(UpperBound lambda, double h, const Limit& limit) {
  // A choice that was not asked for has a reason, even where the step is proven at this state. Once it had one the
  // whole step, which takes all of what is proven, is not tried again: while elements stiffen and soften it feeds
  // energy.
  const bool otherStep = h != dividedFor_, asked = asksForChoice() || otherStep;
  int parts = 1;
  if (!otherStep || !(lambda.value <= limit(h)))
    while (parts < mostParts && !(lambda.value <= shareOfProven * shareOfProven * limit(h / parts))) ++parts;
  proven_ = lambda.value <= limit(h / parts);
  if (lastPart_ == 0) lastPart_ = dividedFor_;
  dividedFor_ = h;
  if (!asked || parts >= parts_) patience_ = std::max(2 * patience_, leastPatience);
  partsSinceChoice_ = 0;
  parts_ = parts;
  largestParts_ = std::max(largestParts_, parts);
}

StepStatus StepDivision::take(Integrator& base, SecondOrderSystem& system, State& state, double h,
                              const std::function<bool(const NodeVectors& x)>& endsWithoutEnergy) {
  before_ = state;
  for (int parts = parts_;; parts *= 2) {
    if (StepStatus status = takeParts(base, system, state, h, parts); !status.done) {
      state = before_;
      return status;
    }
    if (2 * parts > mostParts || !endsWithoutEnergy(state.x)) {
      lastPart_ = h / parts;
      partsSinceChoice_ += parts;
      dividedSteps_ += parts > 1 ? 1 : 0;
      largestParts_ = std::max(largestParts_, parts);
      return {};
    }
    state = before_;
    base.reset();
  }
}

StepStatus StepDivision::takeParts(Integrator& base, SecondOrderSystem& system, State& state, double h, int parts) {
  const double part = h / parts;
  // Where velocities are half a step behind they are by half a step of another size.
  if (part != lastPart_ && lastPart_ > 0 && !base.info().reversible)
    state.v += 0.5 * (lastPart_ - part) * accelerationOf(system, state);
  for (int k = 0; k < parts; ++k)
    if (StepStatus status = base.step(system, state, part); !status.done) return status;
  state.time = before_.time + h;
  return {};
}

}  // namespace ringwatch
