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
  ReferencedRule own =
      ruleAtOwnStep(scene, body, DampingRates::followed, ownStepTolerance, stepOfTopMode(body, body.mesh().X));
  constexpr double farBelow = 0.5;
  if (!(*scene.step < farBelow * own.reference)) {
    rule_ = stepRuleAt(scene, body, *scene.step, DampingRates::followed);
    return;
  }
  longer_ = std::make_shared<StepRule>(std::move(own.rule));
  rule_ = StepRule([now = longer_](double lambda) { return (*now)(lambda); },
                   [now = longer_](LowerBound lambda) { return now->optimistic(lambda); }, longer_->proven());
}

void RunRule::referToStep(Body& body) {
  ofLonger_ = false;
  if (longer_) *longer_ = stepRuleAt(scene_, body, *scene_.step, DampingRates::followed);
}

}  // namespace ringwatch
