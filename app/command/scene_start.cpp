#include <ringwatch/app/command/scene_start.h>

#include <fmt/format.h>

#include <ringwatch/app/command/integrator_catalog.h>
#include <ringwatch/app/scene/scene_state.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/user_text.h>
#include <ringwatch/integrators/body_system.h>

namespace ringwatch {

SceneStart startOf(const std::filesystem::path& file, const std::vector<std::string>& overrides, int threads) {
  Scene scene = readScene(file, overrides);
  if (scene.hasElementDamping())
    throw InputError(fmt::format("{}: a plan at the start of a run takes no elements that damp; ringwatch run does",
                                 scene.elementDampingOrigin));
  if (scene.hasDiscreteForces())
    throw InputError(
        fmt::format("{}: a plan at the start of a run takes no springs and contact, whose stiffness comes and goes "
                    "later; ringwatch run watches them",
                    scene.discreteOrigin()));
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
  StepRule rule = stepRule(info, scene.damping);
  return {std::move(scene), &info, std::move(rule), std::move(body), std::move(state), std::move(notes)};
}

}  // namespace ringwatch
