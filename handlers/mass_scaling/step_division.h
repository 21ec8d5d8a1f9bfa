#pragma once
#include <cstdint>
#include <functional>

#include <ringwatch/integrators/integrator.h>
#include <ringwatch/monitor/bounds.h>

namespace ringwatch {

/// Steps of h that are taken as n of h/n of a scheme of one force a step, where h is not proven stable: Theorem 86,
/// docs/theory/handlers.md. What the handler mass-scaling does after its first choice.
class StepDivision {
 public:
  /// The largest eigenvalue (rad²/s²) that a step (s) is to be stable for.
  using Limit = std::function<double(double step)>;

  /// Sweeps of the weights of the bound that choose() is given.
  static constexpr int sweeps = 12;

  /// Steps of h seconds are proven for now.
  void begin(double h) { dividedFor_ = h; }
  /// Chooses n for steps of h seconds, of a body whose highest eigenvalue is proven to be at most lambda.
  void choose(UpperBound lambda, double h, const Limit& limit);
  /// Takes a step of h seconds. One that would end where endsWithoutEnergy(x) is taken in twice as many parts, and so
  /// on. On failure the state is as before the step.
  StepStatus take(Integrator& base, SecondOrderSystem& system, State& state, double h,
                  const std::function<bool(const NodeVectors& x)>& endsWithoutEnergy);

  /// n, of the last choice.
  int parts() const { return parts_; }
  /// Whether every step so far was taken whole, and the next one is.
  bool neverDivided() const { return parts_ == 1 && largestParts_ == 1; }
  /// Whether the last choice found an n that is proven.
  bool proven() const { return proven_; }
  /// A while after a choice: fewer parts may do.
  bool asksForChoice() const { return parts_ > 1 && partsSinceChoice_ >= patience_; }
  std::int64_t dividedSteps() const { return dividedSteps_; }
  int largestParts() const { return largestParts_; }

 private:
  StepStatus takeParts(Integrator& base, SecondOrderSystem& system, State& state, double h, int parts);

  State before_;        // the step that is being taken
  bool proven_ = true;  // the last choice found an n
  int parts_ = 1, largestParts_ = 1;
  double dividedFor_ = 0;  // s, the step of the last choice
  double lastPart_ = 0;    // s, of the last step; 0 before any was divided
  std::int64_t partsSinceChoice_ = 0, patience_ = 0, dividedSteps_ = 0;
};

}  // namespace ringwatch
