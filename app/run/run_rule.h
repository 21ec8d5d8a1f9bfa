#pragma once
#include <memory>

#include <ringwatch/app/scene/scene.h>
#include <ringwatch/body/body.h>
#include <ringwatch/monitor/step_limit.h>

namespace ringwatch {

/// The rule of a run's steps. What damps counts for a step at which the rule is exact: that of the scene, or the safe
/// step of the body where the scene's is far below it and its rule says much less of longer steps than is true.
class RunRule {
 public:
  /// The body counts its damping for this rule.
  RunRule(const Scene& scene, Body& body);
  RunRule(const RunRule&) = delete;
  RunRule& operator=(const RunRule&) = delete;

  /// The rule of now, and so are copies of it.
  const StepRule& rule() const { return rule_; }
  /// Whether it is exact at a step that is longer than the scene's.
  bool isOfLongerStep() const { return longer_ != nullptr && ofLonger_; }
  /// Makes it exact at the scene's step from here on; the body then counts its damping for that.
  void referToStep(Body& body);

 private:
  const Scene& scene_;
  std::shared_ptr<StepRule> longer_;  // what rule_ asks; nullptr where it never changes
  StepRule rule_;
  bool ofLonger_ = true;
};

}  // namespace ringwatch
