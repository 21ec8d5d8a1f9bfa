#include <ringwatch/app/run/run_rule.h>

#include <utility>

#include <ringwatch/app/scene/scene_discrete.h>
#include <ringwatch/body/domain.h>

namespace ringwatch {

RunRule::RunRule(const Scene& scene, Body& body) : scene_(scene), rule_(sceneStepRule(scene, body)) {
  const bool damps = body.elementDamping() || (body.discreteForces() && body.discreteForces()->damped());
  // A step that the run shortens, or that a handler chooses elements for, needs the rule that is exact there.
  const bool keepsStep = scene.step && scene.handler.empty() &&
                         (scene.onViolation == OnViolation::stop || scene.onViolation == OnViolation::warn);
  if (!damps || !keepsStep || !scene.monitored() || !scene.proves() || !body.domain().whole()) return;
  const StepByRule step = stepOfTopMode(body, body.mesh().X);
  ReferencedRule own = ruleAtOwnStep(scene, body, DampingRates::followed, ownStepTolerance, step);
  StepRule atStep = stepRuleAt(scene, body, *scene.step, DampingRates::followed);
  // Where the body stiffens, the rule of a longer step says less than that of the scene's: it must be worth it. A
  // bracket has the safe side of this about.
  const StepByRule safe =
      stepOfTopMode(body, body.mesh().X, [](const StepRule& rule, LowerBound lambda) { return rule(lambda.value); });
  constexpr double farLess = 0.5;
  if (!(*scene.step < own.reference) || !(safe(atStep) < farLess * own.reference)) {
    rule_ = std::move(atStep);
    return;
  }
  own.rule = stepRuleAt(scene, body, own.reference, DampingRates::followed);
  longer_ = std::make_shared<StepRule>(std::move(own.rule));
  rule_ = StepRule([now = longer_](double lambda) { return (*now)(lambda); },
                   [now = longer_](LowerBound lambda) { return now->optimistic(lambda); }, longer_->proven());
}

void RunRule::referToStep(Body& body) {
  ofLonger_ = false;
  if (longer_) *longer_ = stepRuleAt(scene_, body, *scene_.step, DampingRates::followed);
}

}  // namespace ringwatch
