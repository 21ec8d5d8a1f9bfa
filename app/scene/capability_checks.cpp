#include <algorithm>

#include <fmt/format.h>

#include <ringwatch/app/scene/capabilities.h>
#include <ringwatch/app/scene/integrator_catalog.h>
#include <ringwatch/app/scene/scene_keys.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/user_text.h>
#include <ringwatch/body/discrete_forces.h>

namespace ringwatch {
namespace {

using F = Feature;

/// "rk4, verlet and pefrl": the names of the entries that have a trait.
template <class Infos, class Trait>
std::string namesWhere(const Infos& infos, const Trait& trait) {
  std::vector<std::string_view> names;
  for (const auto& info : infos)
    if (trait(info)) names.push_back(info.name);
  return listed(names);
}

template <class Infos, class Trait>
std::string choices(const Infos& infos, Trait takes) {
  return "choose from " + namesWhere(infos, takes);
}

/// Where a scene has a feature: at the last of its keys that is given.
std::string originOf(const Scene& scene, Feature feature) {
  const std::vector<std::string> keys = keysOf(feature);
  const auto given =
      std::find_if(keys.rbegin(), keys.rend(), [&](const std::string& key) { return scene.places.contains(key); });
  return scene.where(given == keys.rend() ? keys.back() : *given);
}

Features featuresOf(const Scene& scene) {
  Features all{};
  for (const FeatureInfo& info : sceneFeatures())
    if (info.in(scene)) all.add(info.feature);
  return all;
}

Features featuresOf(const Body& body) {
  Features all{};
  if (body.discreteForces()) all.add(F::discrete);
  if (body.elementDamping()) all.add(F::elementDamping);
  if (!body.constraints().rigidBodies().empty()) all.add(F::rigid);
  return all;
}

/// What keeps a feature from what has others: a part of it, or the integrator (nullptr).
struct Obstruction {
  const FeatureInfo* by;
  std::string_view why;
};
std::optional<Obstruction> obstruction(Feature feature, const Features& others, const IntegratorInfo& integrator) {
  const FeatureInfo& info = infoOf(feature);
  if (info.takes && !info.takes(integrator)) return Obstruction{nullptr, info.why};
  for (const FeatureInfo& other : sceneFeatures())
    if (const Capability entry = capability(feature, other.feature);
        others.has(other.feature) && entry.fate == Fate::refused)
      return Obstruction{&other, entry.reason};
  return std::nullopt;
}

std::string notTogether(Feature feature, const Obstruction& found, std::string_view method) {
  return fmt::format("{} do not go with {}", infoOf(feature).name,
                     found.by ? std::string(found.by->name) : inQuotes(std::string(method)));
}

}  // namespace

std::vector<std::string> keysOf(Feature feature) {
  std::vector<std::string> keys;
  for (const SceneSection& section : sceneSections()) {
    if (section.features.has(feature)) keys.emplace_back(section.name);
    for (const SceneKey& key : section.keys)
      if (key.features.has(feature)) keys.push_back(key.section + "." + key.key);
  }
  return keys;
}

std::string capabilitiesText() {
  std::string text = "Features of a scene with their keys, and integrators where they do not go with all:\n\n";
  for (const FeatureInfo& info : sceneFeatures()) {
    text += fmt::format("  {}: {}\n", info.name, fmt::join(keysOf(info.feature), " "));
    if (info.whole != info.feature) text += fmt::format("    part of {}\n", infoOf(info.whole).name);
    if (info.takes) text += fmt::format("    with {}: {}\n", namesWhere(integratorInfos(), info.takes), info.why);
  }
  const auto in = [](const auto& set, auto entry) {
    return [&set, entry](const auto& i) { return set.has(i.*entry); };
  };
  text += "\nWhat does not go together, with all of its parts:\n\n";
  for (const Conflict& row : featureConflicts())
    text +=
        fmt::format("  {}\n    not with {}: {}\n", namesWhere(sceneFeatures(), in(row.these, &FeatureInfo::feature)),
                    namesWhere(sceneFeatures(), in(row.those, &FeatureInfo::feature)), row.why);
  for (const auto& [fate, title] : {std::pair{Fate::refused, "\nWhat else does not take them:\n\n"},
                                    {Fate::meansNothing, "\nWhat leaves them out:\n\n"}}) {
    text += title;
    for (const Limit& row : useLimits())
      if (row.fate == fate)
        text += fmt::format("  {}\n    {}: {}\n", namesWhere(sceneUses(), in(row.by, &SceneUseInfo::use)),
                            namesWhere(sceneFeatures(), in(row.of, &FeatureInfo::feature)), row.why);
  }
  return text;
}

nlohmann::ordered_json capabilitiesJson() {
  nlohmann::ordered_json all = nlohmann::ordered_json::object();
  for (const FeatureInfo& info : sceneFeatures()) {
    const FeatureInfo& whole = infoOf(info.whole);
    std::vector<std::string_view> notWith, notBy;
    for (const FeatureInfo& other : sceneFeatures())
      if (capability(info.feature, other.feature).fate == Fate::refused) notWith.push_back(other.name);
    for (const SceneUseInfo& use : sceneUses())
      if (capability(info.feature, use.use).fate == Fate::refused) notBy.push_back(use.name);
    for (const IntegratorEntry& entry : integratorCatalog().entries())
      if ((info.takes && !info.takes(*entry.info)) || (whole.takes && !whole.takes(*entry.info)))
        notBy.push_back(entry.info->name);
    all[std::string(info.name)] = {{"keys", fmt::format("{}", fmt::join(keysOf(info.feature), " "))},
                                   {"part_of", whole.name},
                                   {"not_with", notWith},
                                   {"not_by", notBy}};
  }
  return all;
}

std::string Refusal::text() const { return fmt::format("{}: {}: {}; {}", origin, what, reason, mend); }

std::optional<Refusal> refusalOf(const Scene& scene) {
  const IntegratorInfo& integrator = *integratorCatalog().find(scene.method);
  const Features all = featuresOf(scene);
  for (const FeatureInfo& info : sceneFeatures()) {
    if (!all.has(info.feature)) continue;
    const auto found = obstruction(info.feature, all, integrator);
    if (!found) continue;
    Refusal refusal{originOf(scene, info.feature), notTogether(info.feature, *found, scene.method),
                    std::string(found->why), "leave one of them out"};
    if (found->by)
      refusal.what += fmt::format(" ({})", originOf(scene, found->by->feature));
    else
      refusal.mend = choices(integratorInfos(), info.takes);
    return refusal;
  }
  return std::nullopt;
}

std::optional<Refusal> refusalOf(const Scene& scene, SceneUse use) {
  const SceneUseInfo& info = infoOf(use);
  const auto no = [&](const std::string& origin, std::string_view what, std::string_view why, std::string mend) {
    return Refusal{origin, fmt::format("{} takes no {}", info.name, what), std::string(why), std::move(mend)};
  };
  if (info.takes && !info.takes(*integratorCatalog().find(scene.method)))
    return no(scene.where("integrator.method"), inQuotes(scene.method), info.why,
              choices(integratorInfos(), info.takes));
  const HandlerInfo* handler = findHandler(scene.handler);
  if (handler && info.takesHandler && !info.takesHandler(*handler))
    return no(scene.where("handler.method"), inQuotes(scene.handler), info.whyHandler,
              choices(handlerInfos(), info.takesHandler));
  for (const FeatureInfo& feature : sceneFeatures())
    if (const Capability entry = capability(feature.feature, use); entry.fate == Fate::refused && feature.in(scene))
      return no(originOf(scene, feature.feature), feature.name, entry.reason, std::string(info.mend));
  if (use != SceneUse::gpu || !handler) return std::nullopt;
  Options own = scene.handlerOptions.own;
  if (const std::string why = handler->forGpu(own); !why.empty())
    return no(scene.where("handler.method"), "such handlers", why, std::string(info.mend));
  return std::nullopt;
}

void requireTogether(const Scene& scene) {
  if (const auto refusal = refusalOf(scene)) throw InputError(refusal->text());
  if (scene.device == RunDevice::cuda) requireTaken(scene, SceneUse::gpu);
}

void requireTaken(const Scene& scene, SceneUse use) {
  if (const auto refusal = refusalOf(scene, use)) throw InputError(refusal->text());
}

std::string whyNot(const Scene& scene, Feature wanted) {
  const auto found = obstruction(wanted, featuresOf(scene), *integratorCatalog().find(scene.method));
  if (found) return notTogether(wanted, *found, scene.method);
  if (scene.device == RunDevice::cuda && capability(wanted, SceneUse::gpu).fate == Fate::refused)
    return fmt::format("{} takes no {}", infoOf(SceneUse::gpu).name, infoOf(wanted).name);
  return {};
}

std::vector<std::string> notesOfOmissions(const Scene& scene, SceneUse use) {
  std::vector<std::string> notes;
  for (const Limit& row : useLimits())
    for (const FeatureInfo& feature : sceneFeatures())
      if (row.told && row.by.has(use) && row.of.has(feature.feature) && feature.in(scene))
        notes.push_back(fmt::format("{}: {}", feature.name, row.why));
  return notes;
}

bool takesBody(SceneUse use, const Body& body) {
  const Features all = featuresOf(body);
  return std::ranges::none_of(sceneFeatures(), [&](const FeatureInfo& info) {
    return all.has(info.feature) && capability(info.feature, use).fate == Fate::refused;
  });
}

std::string whyNoHandlers(const Body& body, const IntegratorInfo& integrator) {
  const auto found = obstruction(F::handler, featuresOf(body), integrator);
  return found ? notTogether(F::handler, *found, integrator.name) : "";
}

std::string whyNoHandlers(Scene scene) {
  scene.handler.clear();
  scene.onViolation = OnViolation::handle;
  if (std::string why = whyNot(scene, F::handler); !why.empty()) return why;
  if (!scene.proves()) return "handlers follow the proven bracket";
  const bool taken = std::ranges::any_of(handlerInfos(), [&](const HandlerInfo& handler) {
    return dampingRefusedBy(handler, scene.damping).second.empty();
  });
  return taken ? "" : "no handler takes this damping";
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

}  // namespace ringwatch
