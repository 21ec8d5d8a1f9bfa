#include <ringwatch/app/ranks/rank_handler.h>

#include <fmt/format.h>

#include <ringwatch/app/ranks/rank_imex.h>
#include <ringwatch/app/ranks/rank_mass_scaling.h>
#include <ringwatch/base/error.h>

namespace ringwatch {

std::vector<ElementRef> elementsOfPart(const RankBody& part, const ElementFlags& chosen) {
  std::vector<ElementRef> elements;
  for (std::size_t b = 0; b < part.body().blocks().size(); ++b)
    for (std::int32_t e = 0; e < part.body().blocks()[b]->elementCount(); ++e) {
      const ElementRef inWhole = part.globalElement({b, e});
      if (chosen[inWhole.block][inWhole.element]) elements.push_back({b, e});
    }
  return elements;
}

std::unique_ptr<RankHandler> makeRankHandler(const Scene& scene, Body& whole, double h) {
  if (scene.handler == Imex::description.name) return std::make_unique<RankImex>(scene, whole, h);
  return std::make_unique<RankMassScaling>(scene, whole, h);
}

void requireDistributableHandler(const Scene& scene) {
  if (scene.handler.empty()) return;
  const std::string file = scene.file.string();
  const std::string alone = "run the scene with one process, without mpirun";
  const bool imex = scene.handler == Imex::description.name;
  if (!imex && scene.handler != MassScaling::description.name)
    throw InputError(
        fmt::format("{}: handler.method: \"{}\" is not distributed over ranks; take \"{}\" or \"{}\", or {}", file,
                    scene.handler, Imex::description.name, MassScaling::description.name, alone));
  if (!scene.step)
    throw InputError(
        fmt::format("{}: integrator.step: \"auto\" with a handler is not distributed over ranks; {}", file, alone));
  if (!imex) return;
  if (const OptionValue* solver = scene.handlerOptions.own.find("solver");
      solver && *solver != OptionValue(Imex::newton) && *solver != OptionValue("auto"))
    throw InputError(fmt::format("{}: handler.solver: is not distributed over ranks but for \"{}\"; take that, or {}",
                                 file, Imex::newton, alone));
  if (scene.damping.any())
    throw InputError(fmt::format("{}: [damping]: with \"imex\" is not distributed over ranks; {}", file, alone));
  if (scene.onViolation == OnViolation::handle)
    throw InputError(
        fmt::format("{}: monitor.on_violation: \"handle\" with \"imex\" is not distributed over ranks, which "
                    "choose elements once; set it to \"warn\" or \"stop\", with a larger handler.margin, or {}",
                    file, alone));
  if (scene.reduceOnFailure)
    throw InputError(
        fmt::format("{}: handler.on_failure: \"reduce-step\" is not distributed over ranks; set it to \"stop\", or {}",
                    file, alone));
}

}  // namespace ringwatch
