#include <ringwatch/app/analysis/scene_start.h>

#include <array>
#include <cmath>

#include <fmt/format.h>

#include <ringwatch/app/scene/body_notes.h>
#include <ringwatch/app/scene/integrator_catalog.h>
#include <ringwatch/app/scene/scene_discrete.h>
#include <ringwatch/app/scene/scene_state.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/base/user_text.h>
#include <ringwatch/body/discrete_forces.h>
#include <ringwatch/integrators/body_system.h>

namespace ringwatch {

SceneStart startOf(const std::filesystem::path& file, const std::vector<std::string>& overrides, int threads,
                   SceneUse use) {
  Scene scene = readScene(file, overrides);
  requireTaken(scene, use);
  const IntegratorInfo& info = *integratorCatalog().find(scene.method);
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
  if (DiscreteForces* forces = body.discreteForces()) forces->setReach(infinity);
  body.followDampingRates(state.x, state.v);
  const ReferencedRule own =
      ruleAtOwnStep(scene, body, state.v.isZero(0) ? DampingRates::atRest : DampingRates::followed, ownStepTolerance,
                    stepOfTopMode(body, state.x));
  for (std::vector<std::string>& more :
       std::array{bodyNotes(body), notesOfBracket(scene, body), notesOfOmissions(scene, use)})
    notes.insert(notes.end(), more.begin(), more.end());
  return {std::move(scene), &info, own.rule, std::move(body), std::move(state), std::move(notes)};
}

}  // namespace ringwatch
