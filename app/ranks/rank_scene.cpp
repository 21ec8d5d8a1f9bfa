#include <ringwatch/app/ranks/rank_scene.h>

#include <cmath>
#include <memory>
#include <string>

#include <fmt/format.h>

#include <ringwatch/app/command/integrator_catalog.h>
#include <ringwatch/app/ranks/rank_handler.h>
#include <ringwatch/base/error.h>
#include <ringwatch/body/element_stress.h>

namespace ringwatch {

void requireDistributable(const Scene& scene) {
  const std::string file = scene.file.string();
  const auto refuse = [](bool is, const std::string& where, const std::string& what) {
    if (is)
      throw InputError(fmt::format("{}: {} not distributed over ranks; run the scene with one process, without mpirun",
                                   where, what));
  };
  const auto key = [&](const char* name) { return fmt::format("{}: {}", file, name); };
  const std::unique_ptr<Integrator> integrator = integratorCatalog().make(scene.method);
  const IntegratorInfo& info = integrator->info();
  refuse(!integrator->beginsWithAcceleration() || info.forceEvaluations != 1 || info.partitioned,
         key("integrator.method"), fmt::format("\"{}\" is", scene.method));
  requireDistributableHandler(scene);
  refuse(scene.device == RunDevice::cuda, scene.deviceOrigin, "runs on a GPU are");
  if (scene.hasDiscreteForces()) refuse(true, scene.discreteOrigin(), "springs, dampers of nodes and contact are");
  if (!scene.rigids.empty()) refuse(true, scene.rigids.front().origin, "rigid bodies are");
  if (!scene.pressures.empty()) refuse(true, scene.pressures.front().origin, "pressures are");
  if (!scene.cuts.empty()) refuse(true, scene.cuts.front().origin, "cuts are");
  refuse(scene.erosion.has_value(), key("[erosion]"), "erosion is");
  refuse(scene.hasElementDamping(), scene.elementDampingOrigin, "elements that damp are");
  refuse(scene.damping.beta != 0, key("damping.stiffness"), "stiffness-proportional damping is");
  refuse(!scene.proves(), key("monitor.mode"), "runs without a bracket are");
  refuse(!scene.metric.empty(), key("monitor.metric"), "metrics are");
  refuse(scene.budget.has_value(), key("monitor.budget"), "a budget of the monitor is");
  refuse(scene.onViolation == OnViolation::repeat, key("monitor.on_violation"), "\"repeat\" is");
  refuse(scene.certificates.has_value(), key("monitor.certificates"), "files of proofs are");
  if (!scene.probes.empty()) refuse(true, scene.probes.front().origin, "probes are");
  refuse(scene.reactions, key("output.reactions"), "reactions are");
  refuse(scene.exactTimes, key("output.exact_times"), "frames between steps are");
  for (const std::string& field : scene.fields)
    refuse(scene.frameInterval && field != "critical_step" && !findStressMeasure(field), key("output.fields"),
           fmt::format("\"{}\" is", field));
}

}  // namespace ringwatch
