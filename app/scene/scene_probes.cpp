#include <ringwatch/app/scene/scene_probes.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <ringwatch/app/command/integrator_catalog.h>
#include <ringwatch/app/scene/scene_sections.h>
#include <ringwatch/base/nearest_name.h>
#include <ringwatch/base/user_text.h>

namespace ringwatch {
namespace {

/// A name is part of the names of columns.
void checkName(const SceneTable& section, const Scene& scene, const std::string& name) {
  const auto plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  };
  if (section.given("name") && (name.empty() || !std::ranges::all_of(name, plain)))
    fail(section.at("name").origin, "probe.name",
         inQuotes(name) + " is no name of columns; must be made of letters, digits, _ and -");
  for (const Scene::Probe& other : scene.probes)
    if (other.name == name)
      fail(section.given("name") ? section.at("name").origin : section.origin, "probe.name",
           fmt::format("{} is the name of {} already; give another", inQuotes(name), other.origin));
}

/// Which rigid body a probe is of.
std::size_t rigidOf(const SceneTable& section, const Scene& scene, const std::string& what) {
  for (const char* key : {"where", "set", "material"})
    if (section.given(key))
      fail(section.at(key).origin, fmt::format("probe.{}", key),
           fmt::format("\"{}\" is of a rigid body; give rigid", what));
  std::vector<std::string> known;
  for (const Scene::Rigid& rigid : scene.rigids) known.push_back(rigid.name);
  if (known.empty())
    fail(section.at("what").origin, "probe.what", inQuotes(what) + " is of a [[rigid]]; there is none");
  if (!section.given("rigid")) {
    if (known.size() == 1) return 0;
    fail(section.origin, "probe.rigid", fmt::format("there are several; name one of {}", fmt::join(known, ", ")));
  }
  const auto name = section.get<std::string>("rigid");
  const auto found = std::ranges::find(known, name);
  if (found == known.end())
    fail(section.at("rigid").origin, "probe.rigid",
         fmt::format("unknown rigid body {}; {}the scene has {}", inQuotes(name), didYouMean(name, known),
                     fmt::join(known, ", ")));
  return static_cast<std::size_t>(found - known.begin());
}

Scene::Probe probeOf(const SceneTable& section, const Scene& scene) {
  Scene::Probe probe;
  probe.origin = section.origin + ": [[probe]]";
  probe.name = section.given("name") ? section.get<std::string>("name") : fmt::format("probe.{}", scene.probes.size());
  checkName(section, scene, probe.name);
  probe.quantity = *std::ranges::find(allProbeQuantities(), section.get<std::string>("what"), &ProbeQuantity::name);
  probe.as = probe.quantity.as.front();
  if (section.given("as")) {
    probe.as = section.named("as", probeReductionNames);
    if (!std::ranges::count(probe.quantity.as, probe.as)) {
      std::vector<std::string> takes;
      for (const ProbeReduction one : probe.quantity.as) takes.push_back(inQuotes(probeReductionNames.nameOf(one)));
      fail(section.at("as").origin, "probe.as",
           fmt::format("{} does not go with what = \"{}\"; must be {}", inQuotes(section.get<std::string>("as")),
                       probe.quantity.name, fmt::join(takes, " or ")));
    }
  }
  if (section.given("where") || section.given("set")) probe.selection = selectionOf(section);
  if (section.given("material")) {
    if (probe.quantity.ofNodes())
      fail(section.at("material").origin, "probe.material",
           fmt::format("\"{}\" is of nodes; give where or set", probe.quantity.name));
    if (probe.selection)
      fail(section.at("material").origin, "probe.material", "both a selection and material are given; give one");
    const auto number = section.get<std::int64_t>("material");
    if (number >= static_cast<std::int64_t>(scene.materials.size()))
      fail(section.at("material").origin, "probe.material",
           fmt::format("{} is no material; there {} {}, counted from 0", number,
                       scene.materials.size() == 1 ? "is" : "are", scene.materials.size()));
    probe.material = static_cast<int>(number);
  }
  if (section.given("rigid") && !probe.quantity.ofRigidBodies())
    fail(section.at("rigid").origin, "probe.rigid",
         fmt::format("\"{}\" is of no rigid body; give where or set", probe.quantity.name));
  if (probe.quantity.ofRigidBodies()) probe.rigid = rigidOf(section, scene, probe.quantity.name);
  if (probe.quantity.ofSupports()) {
    const std::string& name = scene.rigids[probe.rigid].name;
    const auto takes = [&](const auto& one) { return one.guide && one.guide->body == name; };
    if (std::ranges::none_of(scene.fixes, takes) && std::ranges::none_of(scene.moves, takes))
      fail(section.at("what").origin, "probe.what",
           fmt::format("\"{}\": {} is neither held nor moved; a [[fix]] or [[move]] with rigid = {} is missing",
                       probe.quantity.name, inQuotes(name), inQuotes(name)));
  }
  if (section.given("metric") && probe.quantity.kind != ProbeQuantity::Kind::step)
    fail(section.at("metric").origin, "probe.metric",
         fmt::format("goes with what = \"step\" alone, not with \"{}\"", probe.quantity.name));
  if (probe.quantity.kind == ProbeQuantity::Kind::step) {
    probe.metric = section.get<std::string>("metric");
    const IntegratorInfo& info = *integratorCatalog().find(scene.method);
    if (std::isinf(info.imaginaryLimit) || info.partitioned || !(info.imaginaryLimit > 0))
      fail(section.at("what").origin, "probe.what",
           fmt::format("\"step\": \"{}\" has no critical step of elements", scene.method));
  }
  return probe;
}

}  // namespace

void readProbes(const std::vector<SceneTable>& sections, const SceneTable& output, Scene& scene) {
  for (const SceneTable& section : sections)
    if (section.name == "probe") scene.probes.push_back(probeOf(section, scene));
  scene.reactions = output.get<bool>("reactions");
  if (scene.reactions && scene.fixes.empty() && scene.moves.empty())
    fail(output.at("reactions").origin, "output.reactions", "there is no [[fix]] and no [[move]] that could react");
  scene.probeEvery = output.get<std::int64_t>("probe_every");
  if (output.given("probe_every") && !scene.probed())
    fail(output.at("probe_every").origin, "output.probe_every",
         "there is nothing to write; give a [[probe]] or reactions = true");
}

}  // namespace ringwatch
