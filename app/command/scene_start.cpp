#include <ringwatch/app/command/scene_start.h>

#include <cmath>

#include <fmt/format.h>

#include <ringwatch/app/command/integrator_catalog.h>
#include <ringwatch/app/scene/scene_discrete.h>
#include <ringwatch/app/scene/scene_state.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/base/user_text.h>
#include <ringwatch/body/discrete_forces.h>
#include <ringwatch/integrators/body_system.h>
#include <ringwatch/monitor/critical_step.h>

namespace ringwatch {

namespace {
constexpr int mostReferences = 4;  // each lies nearer to the step that it proves
}  // namespace

SceneStart startOf(const std::filesystem::path& file, const std::vector<std::string>& overrides, int threads,
                   DiscreteAtStart discrete) {
  Scene scene = readScene(file, overrides);
  if (scene.hasElementDamping())
    throw InputError(fmt::format("{}: a plan at the start of a run takes no elements that damp; ringwatch run does",
                                 scene.elementDampingOrigin));
  if (scene.hasDiscreteForces() && discrete == DiscreteAtStart::refused)
    throw InputError(
        fmt::format("{}: a plan at the start of a run takes no springs and contact, whose stiffness comes and goes "
                    "later; ringwatch run watches them",
                    scene.discreteOrigin()));
  if (!scene.rigids.empty() && discrete == DiscreteAtStart::refused)
    throw InputError(fmt::format("{}: a plan at the start of a run takes no rigid bodies; ringwatch run does",
                                 scene.rigids.front().origin));
  for (const Scene::Contact& contact : scene.contacts)
    if (contact.withSurface)
      throw InputError(
          fmt::format("{}: a plan at the start of a run takes no contact of surfaces, of which any node may "
                      "meet any face later; ringwatch run watches it",
                      contact.origin));
  const IntegratorInfo& info = *integratorCatalog().find(scene.method);
  if (!hasCriticalStep(info))
    throw InputError(
        fmt::format("{}: integrator.method = {}: has no critical step that a step could keep to; choose "
                    "another with --set integrator.method=…, e.g. symplectic-euler",
                    file.string(), inQuotes(scene.method)));
  std::vector<std::string> notes;
  Mesh mesh = sceneMesh(scene, notes);
  const int all = threadsThatPay(threads, mesh);
  Body body = [&] {
    try {
      return sceneBody(scene, std::move(mesh), all);
    } catch (const NumericalError& fault) {
      throw InputError(fmt::format("{}: {}", scene.meshOrigin, fault.what()));
    }
  }();
  State state = sceneInitialState(scene, BodySystem(body, scene.damping));
  StepRule rule = sceneStepRule(scene, body);
  if (DiscreteForces* forces = body.discreteForces()) {
    forces->setReach(infinity);
    // With dashpots a rule is exact at its reference, and far from it loose: here no step is given, but looked for.
    for (int i = 0; forces->damped() && i < mostReferences; ++i) {
      const double safe = criticalStep(body, state.x, rule).safe;
      if (!(safe > 0) || !std::isfinite(safe)) break;
      forces->setDampingFactor(dampingFactor(scene.damping, safe));
      rule = stepRuleWithDashpots(info, scene.damping, safe);
    }
  }
  return {std::move(scene), &info, std::move(rule), std::move(body), std::move(state), std::move(notes)};
}

}  // namespace ringwatch
