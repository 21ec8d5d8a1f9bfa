#include <ringwatch/app/scene/scene_features.h>

#include <algorithm>

#include <fmt/format.h>

#include <ringwatch/app/scene/scene_sections.h>
#include <ringwatch/base/error.h>
#include <ringwatch/body/discrete_forces.h>

namespace ringwatch {
namespace {

bool anySurface(const Scene& scene) { return std::ranges::any_of(scene.contacts, &Scene::Contact::withSurface); }

/// Something in a scene that changes the motion or the bracket, and who takes it.
struct Feature {
  std::string_view what;  // "": as Scene::timedBy has it
  bool (*in)(const Scene& scene);
  std::string (*origin)(const Scene& scene);  // "scene.toml:31: [[cut]]"
  /// By SceneUse. suggest and scale-mass speak of the start alone; audit is given every state.
  bool compare, advise, suggest, scaleMass, audit;

  bool takenBy(SceneUse use) const {
    switch (use) {
      case SceneUse::compare:
        return compare;
      case SceneUse::advise:
        return advise;
      case SceneUse::suggest:
        return suggest;
      case SceneUse::scaleMass:
        return scaleMass;
      case SceneUse::audit:
        return audit;
    }
    return false;
  }
};

const Feature features[] = {
    {"elements that damp", [](const Scene& s) { return s.hasElementDamping(); },
     [](const Scene& s) { return s.elementDampingOrigin; }, false, false, true, false, false},
    {"contact of surfaces", anySurface,
     [](const Scene& s) { return std::ranges::find_if(s.contacts, &Scene::Contact::withSurface)->origin; }, false,
     false, false, false, false},
    {"springs and contact", [](const Scene& s) { return s.hasDiscreteForces(); },
     [](const Scene& s) { return s.discreteOrigin(); }, false, false, true, false, false},
    {"rigid bodies", [](const Scene& s) { return !s.rigids.empty(); },
     [](const Scene& s) { return s.rigids.front().origin; }, false, false, true, false, false},
    {"", [](const Scene& s) { return !s.timed.empty(); }, [](const Scene& s) { return s.timed; }, false, false, true,
     true, true},
    {"cuts", [](const Scene& s) { return !s.cuts.empty(); }, [](const Scene& s) { return s.cuts.front().origin; },
     false, true, true, true, false},
    {"erosion", [](const Scene& s) { return s.erosion.has_value(); },
     [](const Scene& s) { return s.file.string() + ": [erosion]"; }, false, false, true, true, false},
};

constexpr std::string_view nameOf(SceneUse use) {
  constexpr std::string_view names[] = {"compare", "advise", "suggest", "scale-mass", "audit"};
  return names[static_cast<std::size_t>(use)];
}

}  // namespace

void requireTaken(const Scene& scene, SceneUse use) {
  for (const Feature& feature : features)
    if (feature.in(scene) && !feature.takenBy(use))
      throw InputError(fmt::format("{}: {} takes no {}; ringwatch run does", feature.origin(scene), nameOf(use),
                                   feature.what.empty() ? scene.timedBy : feature.what));
}

std::vector<std::string> notesOfLaterChanges(const Scene& scene) {
  std::vector<std::string> notes;
  if (!scene.cuts.empty())
    notes.push_back(fmt::format("the body is cut at t = {:.6g} s: this is the body before", scene.cuts.front().time));
  if (scene.erosion) notes.emplace_back("elements may erode: this is the body with all of them");
  return notes;
}

std::vector<std::string> notesOfBracket(const Scene& scene, const Body& body) {
  std::vector<std::string> notes;
  if (body.discreteForces() && body.discreteForces()->friction())
    notes.emplace_back(
        "friction: while surfaces slide its tangent is not symmetric, and what is called certified is that of the "
        "run without it, with the damping that it has while they stick");
  if (body.elementDamping() && body.elementDamping()->dependsOnRates())
    notes.emplace_back(
        "quadratic bulk viscosity: it counts with its derivative at the velocities of each observed state");
  if (std::ranges::any_of(body.constraints().rigidBodies(), [](const RigidBody& rigid) {
        return rigid.guide().turning != RigidGuide::Turning::prescribed;
      }))
    notes.emplace_back(
        "rigid bodies: their nodes' forces turn with them, which adds a stiffness that is not in the bracket");
  if (!scene.pressures.empty())
    notes.emplace_back(
        "pressure: its load stiffness is not symmetric and not in the bracket, which is that of the body under dead "
        "loads");
  return notes;
}

std::pair<std::string_view, std::string> dampingRefusedBy(const HandlerInfo& handler, const RayleighDamping& damping) {
  const auto refused = [&](std::string_view key, bool HandlerInfo::*takes) {
    return std::pair<std::string_view, std::string>{
        key, fmt::format("the handler \"{}\" works without {}-proportional damping; {} take it", handler.name, key,
                         namesWhere(handlerInfos(), [&](const HandlerInfo& one) { return one.*takes; }))};
  };
  if (damping.alpha != 0 && !handler.takesMassDamping) return refused("mass", &HandlerInfo::takesMassDamping);
  if (damping.beta != 0 && !handler.takesStiffnessDamping)
    return refused("stiffness", &HandlerInfo::takesStiffnessDamping);
  return {};
}

bool takesSomeHandler(const nlohmann::ordered_json& echo) {
  nlohmann::ordered_json scene = echo;
  if (scene["monitor"].is_object()) {
    scene["monitor"]["on_violation"] = "handle";
    scene["monitor"].erase("repeats");  // of another on_violation
  }
  return std::ranges::any_of(allHandlers(), [&](const HandlerEntry& entry) {
    scene["handler"] = {{"method", std::string(entry.info->name)}};
    try {
      sceneOfEcho("scene", scene);
      return true;
    } catch (const std::exception&) {  // an echo that others have written may hold anything
      return false;
    }
  });
}

}  // namespace ringwatch
