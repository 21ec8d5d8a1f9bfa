#pragma once
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <string_view>

#include <ringwatch/base/infinity.h>
#include <ringwatch/meshes/mesh.h>
#include <ringwatch/monitor/bounds.h>

namespace ringwatch {

/// The step h = limit / √lambda, s, at which lambda reaches an integrator's stability limit on the imaginary axis;
/// infinity for lambda <= 0. Theorem 27, docs/theory/integrators.md.
inline double stepFor(double lambda, double limit) {
  if (std::isnan(lambda)) return std::numeric_limits<double>::quiet_NaN();
  return lambda > 0 ? limit / std::sqrt(lambda) : infinity;
}

/// How the highest eigenvalue lambda (rad²/s²) sets an integrator's step: limit/√lambda without damping, a function of
/// lambda with it.
class StepRule {
 public:
  /// limit: largest stable h·omega of an undamped oscillator.
  StepRule(double limit) : limit_(limit) {}  // NOLINT(google-explicit-constructor): a limit is the usual rule
  /// step: critical step, s, of a system whose modes have omega² in [0, lambda]; must not grow with lambda. proven:
  /// whether it is exactly that, so that an upper bound of lambda gives a safe step and a lower bound an optimistic
  /// one.
  StepRule(std::function<double(double lambda)> step, bool proven) : step_(std::move(step)), proven_(proven) {}
  /// optimistic: the step above which a system is unstable of whose highest eigenvalue that is known; `step` then is
  /// the one up to which it is stable where that eigenvalue is lambda at most. They differ where dashpots make the
  /// matrix depend on the step (Theorem 47, docs/theory/discrete_forces.md).
  StepRule(std::function<double(double lambda)> step, std::function<double(LowerBound lambda)> optimistic, bool proven)
      : step_(std::move(step)), optimistic_(std::move(optimistic)), proven_(proven) {}

  double operator()(double lambda) const { return step_ ? step_(lambda) : stepFor(lambda, limit_); }
  double optimistic(LowerBound lambda) const { return optimistic_ ? optimistic_(lambda) : (*this)(lambda.value); }
  bool proven() const { return proven_; }
  /// The rule of a step that is taken as n steps of this one's.
  StepRule ofParts(int n) const {
    if (!step_) return {n * limit_};
    return {[rule = *this, n](double lambda) { return n * rule(lambda); },
            [rule = *this, n](LowerBound lambda) { return n * rule.optimistic(lambda); }, proven_};
  }
  /// The largest lambda, rad²/s², to rounding from below, at which the step h (s, > 0) is allowed: the rule turned
  /// round.
  double lambdaFor(double h) const {
    if (!step_) return (limit_ / h) * (limit_ / h);
    double low = 0, high = 4 / (h * h);
    for (int i = 0; i < 200 && step_(high) >= h && high < std::numeric_limits<double>::max() / 4; ++i) high *= 2;
    for (int i = 0; i < 80; ++i) {
      const double middle = 0.5 * (low + high);
      (step_(middle) >= h ? low : high) = middle;
    }
    return low;
  }

 private:
  double limit_ = 0;
  std::function<double(double)> step_;
  std::function<double(LowerBound)> optimistic_;
  bool proven_ = true;
};

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
  /// Least eigenvalue seen at this state, of a reduced 1-ring or a direction, rad²/s²; < 0 proves K indefinite, 0: none
  /// was looked for, or none below.
  double lowestRing;
  ElementRef lowestRingElement;            // where that is < 0
  std::optional<ProbableStep> probable{};  // when asked for; never part of the proven bracket
  /// Elements whose values are rounded up by more than a thousandth, how many and the worst: their shapes or states
  /// leave little to say in double precision, and the safe side is that much lower there. Only from scratch.
  std::size_t poorlyConditioned = 0;
  ElementRef worstConditioned{};

  /// The share of the top mode's energy that springs and contact hold, as far as that mode is known: above one half
  /// they set the step, and not the controlling element.
  double discreteShare = 0;
  /// Likewise what dashpots and damped elements hold at the step that their damping counts for.
  double dampingShare = 0;

  /// Whether the tangent is proven to have a direction of negative stiffness, which no step cures.
  bool indefinite() const { return lowestRing < 0; }
  /// Whether the two sides are a bracket: numbers, with safe <= optimistic. No function hands out one for which it is
  /// false.
  bool isBracket() const { return safe <= optimistic; }

  template <class Archive>
  void archive(Archive& a) {
    a(safe, optimistic, controlling, safeBy, optimisticBy, lowestRing, lowestRingElement, probable, poorlyConditioned,
      worstConditioned, discreteShare, dampingShare);
  }
};
/// The side of the bracket made from a bound: the types say which.
inline double safeStep(UpperBound lambda, const StepRule& rule) { return rule(lambda.value); }
inline double optimisticStep(LowerBound lambda, const StepRule& rule) { return rule.optimistic(lambda); }

}  // namespace ringwatch
