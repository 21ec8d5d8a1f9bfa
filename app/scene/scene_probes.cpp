#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <ringwatch/app/scene/integrator_catalog.h>
#include <ringwatch/app/scene/key_binding.h>
#include <ringwatch/base/nearest_name.h>
#include <ringwatch/base/user_text.h>
#include <ringwatch/monitor/metrics/metrics.h>

namespace ringwatch {
namespace {

/// A name is part of the names of columns.
void takeName(const SceneTable& section, const Scene& scene, Scene::Probe& probe) {
  const auto plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  };
  if (!section.given("name"))
    probe.name = fmt::format("probe.{}", &probe - scene.probes.data());
  else if (probe.name.empty() || !std::ranges::all_of(probe.name, plain))
    fail(section.at("name").origin, "probe.name",
         inQuotes(probe.name) + " is no name of columns; must be made of letters, digits, _ and -");
  requireOwnName(section, scene.probes, probe);
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
  return positionOf(section, "rigid", scene.rigids);
}

void checkProbe(const SceneTable& section, Scene& scene, Scene::Probe& probe) {
  takeName(section, scene, probe);
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
  if (section.given("material")) {
    if (probe.quantity.ofNodes())
      fail(section.at("material").origin, "probe.material",
           fmt::format("\"{}\" is of nodes; give where or set", probe.quantity.name));
    if (*probe.material >= static_cast<int>(scene.materials.size()))
      fail(section.at("material").origin, "probe.material",
           fmt::format("{} is no material; there {} {}, counted from 0", *probe.material,
                       scene.materials.size() == 1 ? "is" : "are", scene.materials.size()));
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
    const IntegratorInfo& info = *integratorCatalog().find(scene.method);
    if (std::isinf(info.imaginaryLimit) || info.partitioned || !(info.imaginaryLimit > 0))
      fail(section.at("what").origin, "probe.what",
           fmt::format("\"step\": \"{}\" has no critical step of elements", scene.method));
  }
}

}  // namespace

SceneSection probeSection() {
  using P = Scene::Probe;
  std::string what;
  for (const ProbeQuantity& quantity : allProbeQuantities())
    what += fmt::format("{}{}{}: {}", what.empty() ? "" : "; ", quantity.name,
                        quantity.unit.empty() ? "" : fmt::format(", {}", quantity.unit), quantity.help);
  std::vector<SceneAlternative> alternatives;
  for (const auto& [one, other] : {std::pair{"where", "set"},
                                   {"where", "material"},
                                   {"set", "material"},
                                   {"where", "rigid"},
                                   {"set", "rigid"},
                                   {"material", "rigid"}})
    alternatives.push_back({one, other, SceneAlternative::Need::atMostOne});
  BoundKeys<P> nodes = nodeKeys(&P::selection, "",
                                "condition on the reference position of nodes, or of the centre of an element's nodes, "
                                "or \"set:NAME\"; without any selection all of them");
  nodes.back().key.help = "named set of nodes or of elements, instead of where";
  return listSection<P>(
      {.name = "probe",
       .help = "numbers of some nodes or elements, each a few columns of probes.csv",
       .features = {Feature::probes},
       .alternatives = alternatives},
      &Scene::probes,
      {unbound<P>({{.key = "what",
                    .type = SceneType::text,
                    .required = true,
                    .choices = namesOf(allProbeQuantities()),
                    .help = what}}),
       {key("name", &P::name,
            "with which its columns begin, of letters, digits, _ and -; without, \"probe.N\", N counted from 0")},
       nodes,
       {key("material", &P::material, "the elements of the material with this number, counted from 0, instead of where",
            {.range = KeyRange::notNegative})},
       unbound<P>({{.key = "rigid",
                    .type = SceneType::text,
                    .help = "name of the [[rigid]] of centre, rotation, centre_velocity, angular_velocity, force, "
                            "torque, support_force and support_torque; without, the only one"},
                   {.key = "as",
                    .type = SceneType::text,
                    .choices = probeReductionNames.names(),
                    .help = probeReductionNames.listing() +
                            "; without, the sum of momentum, angular_momentum, load, reaction and energy, the least "
                            "step, else the mean"}}),
       {key("metric", &P::metric, "of what = \"step\"; it is evaluated for the whole body at every row",
            {.choices = namesOf(allMetrics())})}},
      checkProbe);
}

}  // namespace ringwatch
