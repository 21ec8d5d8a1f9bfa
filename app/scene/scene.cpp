#include <ringwatch/app/scene/scene.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <ringwatch/app/command/integrator_catalog.h>
#include <ringwatch/app/scene/capabilities.h>
#include <ringwatch/app/scene/mjcf_model.h>
#include <ringwatch/app/scene/mjcf_scene.h>
#include <ringwatch/app/scene/scene_damping.h>
#include <ringwatch/app/scene/scene_discrete.h>
#include <ringwatch/app/scene/scene_keys.h>
#include <ringwatch/app/scene/scene_mesh.h>
#include <ringwatch/app/scene/scene_probes.h>
#include <ringwatch/app/scene/scene_rigid.h>
#include <ringwatch/app/scene/scene_sections.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/input_file.h>
#include <ringwatch/base/nearest_name.h>
#include <ringwatch/base/user_text.h>
#include <ringwatch/integrators/integrator.h>
#include <ringwatch/monitor/metrics/metrics.h>

namespace ringwatch {
namespace {

using Json = nlohmann::ordered_json;

std::array<bool, 3> componentsOf(const SceneTable& section) {
  const auto text = section.get<std::string>("components");
  const auto components = parseComponents(text);
  if (!components)
    fail(section.at("components").origin, section.name + ".components",
         inQuotes(text) + " names no components; must be some of x, y, z, each once");
  return *components;
}

/// [mesh]: a file, or a generator with parameters that it takes.
void readMeshSection(const SceneTable& section, Scene& scene) {
  if (section.given("file") == section.given("generate"))
    fail(section.given("file") ? section.at("file").origin : section.origin, "mesh.file",
         section.given("file") ? "both file and generate are given; give one of them"
                               : "missing; give file or generate");
  if (section.given("file")) {
    const std::filesystem::path path = section.get<std::string>("file");
    scene.meshFile = path.is_absolute() ? path : scene.file.parent_path() / path;
    scene.meshOrigin = section.where("file");
  } else {
    scene.generator = section.get<std::string>("generate");
    scene.meshOrigin = section.where("generate");
    scene.generatorArguments = Json::object();
  }
  for (const auto& [key, entry] : section.entries) {
    if (key == "file" || key == "generate") continue;
    if (scene.generator.empty())
      fail(entry.origin, "mesh." + key, "is a parameter of generators; a mesh file takes none");
    const std::string fault = generatorFault(scene.generator, key, entry.value);
    if (!fault.empty()) fail(entry.origin, "mesh." + key, fault);
    scene.generatorArguments[key] = entry.value;
  }
  if (scene.generator.empty()) return;
  const Json defaults = generatorDefaults(scene.generator);
  for (const auto& [key, value] : defaults.items())
    if (!scene.generatorArguments.contains(key)) scene.generatorArguments[key] = value;
  scene.echo["mesh"].update(scene.generatorArguments);
}

/// The keys of a [material] that its law declares.
Options lawParameters(const LawInfo& law, const SceneTable& material) {
  Options parameters;
  for (const LawInfo& other : allLaws())
    for (const OptionInfo& option : other.parameters) {
      const std::string key(option.name);
      if (material.given(key) && !findOption(law.parameters, key)) {
        std::vector<std::string_view> known;
        for (const OptionInfo& own : law.parameters) known.push_back(own.name);
        fail(material.at(key).origin, "material." + key,
             fmt::format("is no parameter of the law \"{}\"; it takes {}", law.name, fmt::join(known, ", ")));
      }
    }
  for (const OptionInfo& option : law.parameters) {
    const std::string key(option.name);
    if (!material.given(key)) {
      if (option.fallback.empty())
        fail(material.origin, "material." + key, missingText(SceneType::number, option.unit, option.range));
      continue;
    }
    parameters.set(key, material.get<double>(key));
    if (const std::string fault = optionFault(law.parameters, parameters, key); !fault.empty())
      fail(material.at(key).origin, "material." + key,
           fmt::format("{}; {}{}", material.at(key).value.dump(), fault,
                       option.unit.empty() ? "" : fmt::format(" {}", option.unit)));
  }
  return parameters;
}

/// A [material]. several: there are others, so that it must say of which elements it is.
SceneMaterial materialOf(const SceneTable& section, bool several) {
  SceneMaterial material;
  material.model = section.get<std::string>("model");
  material.parameters = lawParameters(lawNamed(material.model), section);
  material.density = section.get<double>("density");
  material.damping = dampingOf(section, material.parameters);
  material.origin = section.origin + (several ? ": [[material]]" : ": [material]");
  if (!several && !section.given("where") && !section.given("set")) return material;
  const NodeSelection selection = selectionOf(section);
  material.where = selection.where;
  material.set = selection.set;
  material.selectionOrigin = selection.origin;
  return material;
}

/// [material] or [[material]]: the materials, and what they say of the body as a whole.
void readMaterials(const std::vector<SceneTable>& sections, Scene& scene) {
  std::vector<const SceneTable*> tables;
  for (const SceneTable& section : sections)
    if (section.name == "material") tables.push_back(&section);
  for (const SceneTable* table : tables) scene.materials.push_back(materialOf(*table, tables.size() > 1));
  const SceneTable *lumping = tables.front(), *rules = nullptr, *hourglass = nullptr;
  const auto differs = [](const SceneTable& table, const std::string& key, const SceneTable& other) {
    fail(table.at(key).origin, "material." + key,
         fmt::format("another value than at {}; it is one of the whole body: give it once, or the same",
                     other.at(key).origin));
  };
  for (const SceneTable* table : tables) {
    if (table->given("lumping")) {
      if (lumping->given("lumping") && lumping->at("lumping").value != table->at("lumping").value)
        differs(*table, "lumping", *lumping);
      lumping = table;
    }
    if (table->given("rules")) {
      if (rules && rules->at("rules").value != table->at("rules").value) differs(*table, "rules", *rules);
      rules = table;
    }
    if (table->given("hourglass_stiffness")) {
      if (hourglass && hourglass->at("hourglass_stiffness").value != table->at("hourglass_stiffness").value)
        differs(*table, "hourglass_stiffness", *hourglass);
      hourglass = table;
    }
  }
  scene.lumping = lumping->named("lumping", lumpingNames);
  if (rules) scene.rules = parseRules(rules->get<std::vector<std::string>>("rules"), rules->where("rules"));
  if (hourglass) scene.hourglassControl.stiffness = hourglass->get<double>("hourglass_stiffness");
  if (scene.hasUniformStrain()) return;
  for (const SceneTable* table : tables)
    for (const char* key : {"hourglass_stiffness", "hourglass_viscosity"})
      if (table->given(key))
        fail(table->at(key).origin, joinText("material.", key),
             "goes with a rule of uniform strain; set rules = [\"hex8=uniform-strain\"] too");
}

void readIntegratorSection(const SceneTable& integrator, const SceneTable& monitor, const SceneTable& damping,
                           Scene& scene) {
  readDampingSection(damping, scene);
  scene.method = integrator.get<std::string>("method");
  const Json& step = integrator.at("step").value;
  if (step.is_number()) scene.step = step.get<double>();
  scene.holdsStep = integrator.get<bool>("hold");
  if (scene.holdsStep && scene.step)
    fail(integrator.at("hold").origin, "integrator.hold", "is for step = \"auto\"; a step that is given is held");
  scene.end = integrator.get<double>("end");
  scene.safety = integrator.get<double>("safety");

  scene.mode = monitor.named("mode", monitorModeNames);
  if (scene.mode == MonitorMode::metric && monitor.get<std::string>("metric") == "none")
    fail(monitor.at("mode").origin, "monitor.mode", "\"metric\" needs a metric; set monitor.metric");
  if (!monitor.get<bool>("bracket")) {
    if (scene.mode == MonitorMode::threshold)
      fail(monitor.at("bracket").origin, "monitor.bracket",
           "false leaves nothing to prove, but mode = \"threshold\" does; take one of them out");
    scene.mode = MonitorMode::metric;
  }
  scene.metric = monitor.get<std::string>("metric");
  if (scene.metric == "none") scene.metric.clear();
  scene.margin = monitor.get<double>("margin");
  scene.every = monitor.get<std::int64_t>("every");
  if (monitor.given("budget")) scene.budget = monitor.get<double>("budget");
  scene.energyTolerance = monitor.get<double>("energy_tolerance");
  scene.requireCertified = monitor.get<bool>("require_certified");
  if (monitor.given("certificates")) scene.certificates = monitor.get<std::int64_t>("certificates");
  scene.onViolation = monitor.named("on_violation", onViolationNames);

  if (scene.step && *scene.step > scene.end)
    fail(integrator.at("step").origin, "integrator.step",
         fmt::format("{} s is beyond the end; must be <= end = {} s", *scene.step, scene.end));
  if (scene.step)
    if (const std::string fault = tooManySteps(*scene.step, scene.end); !fault.empty())
      fail(integrator.at("step").origin, "integrator.step", fault);
  if (!scene.step && scene.mode != MonitorMode::bracket)
    fail(integrator.at("step").origin, "integrator.step",
         "\"auto\" follows the safe step; it needs monitor.bracket = true and monitor.mode = \"bracket\"");
  if (scene.onViolation == OnViolation::reduceStep && !scene.monitored())
    fail(monitor.at("on_violation").origin, "monitor.on_violation",
         "\"reduce-step\" needs monitor.bracket = true or a monitor.metric");
  scene.repeats = monitor.get<std::int64_t>("repeats");
  if (monitor.given("repeats") && scene.onViolation != OnViolation::repeat)
    fail(monitor.at("repeats").origin, "monitor.repeats", "is for on_violation = \"repeat\"; take it out");
  if (scene.monitored() && !(integratorCatalog().find(scene.method)->imaginaryLimit > 0))
    fail(integrator.at("method").origin, "integrator.method",
         fmt::format("\"{}\" is unstable at every step without damping, so there is no critical step to monitor; "
                     "choose another, "
                     "or set monitor.bracket = false and monitor.metric = \"none\"",
                     scene.method));
  const IntegratorInfo& info = *integratorCatalog().find(scene.method);
  if (std::isinf(info.imaginaryLimit) || info.partitioned) {
    // No step is too large for it, or its stiff part is whatever the step asks for: there is nothing to watch but
    // energies and the state itself.
    if (!scene.step)
      fail(integrator.at("step").origin, "integrator.step",
           fmt::format("\"auto\" follows the critical step, and \"{}\" {}; give a number", scene.method,
                       info.partitioned ? "chooses its stiff elements by the step" : "is stable at every step"));
    scene.mode = MonitorMode::metric;
    scene.metric.clear();
  }
}

/// The keys of [handler] that the handler declares.
void readHandlerOptions(const HandlerInfo& info, const SceneTable& handler, Scene& scene) {
  if (!info.takes(scene.handlerOptions.selection)) {
    std::vector<std::string> names;
    for (const Selection one : info.selections) names.push_back(fmt::format("\"{}\"", selectionNames.nameOf(one)));
    fail(handler.at("selection").origin, "handler.selection",
         fmt::format("\"{}\" does not go with {}; must be {}", selectionNames.nameOf(scene.handlerOptions.selection),
                     info.name, fmt::join(names, " or ")));
  }
  Options& own = scene.handlerOptions.own;
  for (const auto& [key, entry] : handler.entries) {
    if (!entry.given || isKeyOfEveryHandler(key)) continue;
    if (!findOption(info.options, key)) {
      std::vector<std::string_view> owners;
      for (const HandlerEntry& other : allHandlers())
        if (findOption(other.info->options, key)) owners.push_back(other.info->name);
      fail(entry.origin, "handler." + key,
           fmt::format("is a key of {}; \"{}\" does not take it", fmt::join(owners, ", "), info.name));
    }
    own.set(key, entry.value.is_string() ? OptionValue(entry.value.get<std::string>())
                                         : OptionValue(entry.value.get<double>()));
  }
  for (const auto& [key, value] : own)
    if (const std::string fault = optionFault(info.options, own, key); !fault.empty())
      fail(handler.at(key).origin, "handler." + key,
           fmt::format("{} {}, with the handler \"{}\"", handler.at(key).value.dump(), fault, info.name));
  const Options all = completed(info.name, info.options, own);
  scene.reduceOnFailure = findOption(info.options, "on_failure") && all.text("on_failure") == "reduce-step";
}

/// With step = "auto" a handler needs a step to choose its elements for.
void readWantedStep(const SceneTable& handler, Scene& scene) {
  scene.handlerFactor = handler.get<double>("factor");
  if (handler.given("step")) scene.handlerStep = handler.get<double>("step");
  for (const char* key : {"step", "factor"})
    if (scene.step && handler.given(key))
      fail(handler.at(key).origin, fmt::format("handler.{}", key),
           fmt::format("is for integrator.step = \"auto\", and {} s is given; take one of them out", *scene.step));
  if (handler.given("step") && handler.given("factor"))
    fail(handler.at("factor").origin, "handler.factor", "handler.step is given too; give one of them");
  if (!scene.handlerStep) return;
  if (*scene.handlerStep > scene.end)
    fail(handler.at("step").origin, "handler.step",
         fmt::format("{} s is beyond the end; must be <= integrator.end = {} s", *scene.handlerStep, scene.end));
  if (const std::string fault = tooManySteps(*scene.handlerStep, scene.end); !fault.empty())
    fail(handler.at("step").origin, "handler.step", fault);
}

/// Which Rayleigh damping a handler works with is its own.
void checkDampingOfHandler(const HandlerInfo& info, const SceneTable& handler, const SceneTable& damping,
                           Scene& scene) {
  if (!scene.damping.any()) return;
  if (const auto [key, why] = dampingRefusedBy(info, scene.damping); !why.empty())
    fail(damping.at(std::string(key)).origin, fmt::format("damping.{}", key), why);
  if (handler.given("solver") && handler.get<std::string>("solver") == "newton")
    fail(handler.at("solver").origin, "handler.solver", "\"newton\" works without [damping]; take \"auto\"");
  if (scene.step && !(0.5 * scene.damping.alpha * *scene.step < 1))
    fail(damping.at("mass").origin, "damping.mass",
         fmt::format("{} 1/s needs a step below {} s", scene.damping.alpha, 2 / scene.damping.alpha));
}

void readHandlerSection(const SceneTable& handler, const SceneTable& monitor, const SceneTable& damping, Scene& scene) {
  scene.handler = handler.get<std::string>("method");
  if (scene.handler == "none") scene.handler.clear();
  scene.handlerOptions.selection = handler.named("selection", selectionNames);
  if (handler.given("margin")) scene.handlerOptions.margin = handler.get<double>("margin");
  scene.handlerOptions.damping = scene.damping;

  if (scene.handler.empty()) {
    for (const auto& [key, entry] : handler.entries)
      if (entry.given && key != "method")
        fail(entry.origin, "handler." + key, "there is no handler; set handler.method");
    if (scene.onViolation == OnViolation::handle)
      fail(monitor.at("on_violation").origin, "monitor.on_violation", "\"handle\" needs a handler; set handler.method");
    return;
  }
  readWantedStep(handler, scene);
  readHandlerOptions(*findHandler(scene.handler), handler, scene);
  if (scene.onViolation == OnViolation::handle && !scene.proves())
    fail(monitor.at("on_violation").origin, "monitor.on_violation",
         "\"handle\" follows the proven bracket; it needs monitor.mode = \"bracket\" or \"threshold\"");
  checkDampingOfHandler(*findHandler(scene.handler), handler, damping, scene);
}

std::vector<int> readDevices(const SceneTable& integrator) {
  std::vector<int> devices;
  for (const double number : integrator.get<std::vector<double>>("devices")) {
    if (number != std::floor(number) || number > 1e6)
      fail(integrator.at("devices").origin, "integrator.devices",
           fmt::format("{} is not the number of a GPU: they are counted from 0", number));
    const auto device = static_cast<int>(number);
    if (std::find(devices.begin(), devices.end(), device) != devices.end())
      fail(integrator.at("devices").origin, "integrator.devices", fmt::format("GPU {} is named twice", device));
    devices.push_back(device);
  }
  return devices;
}

void readDevice(const SceneTable& integrator, Scene& scene) {
  scene.device = integrator.named("device", runDeviceNames);
  scene.devices = readDevices(integrator);
  if (scene.device == RunDevice::cpu && scene.devices != std::vector<int>{0})
    fail(integrator.at("devices").origin, "integrator.devices",
         "the steps are taken on the CPU; set integrator.device = \"cuda\" or \"auto\"");
}

/// What a run that goes back needs.
void checkRepeats(const SceneTable& monitor, const Scene& scene) {
  if (scene.onViolation != OnViolation::repeat) return;
  const std::pair<bool, std::string> faults[] = {
      {!scene.proves(), "goes back to certified states; it needs monitor.mode = \"bracket\" or \"threshold\""},
      {!scene.step && !scene.holdsStep,
       "is for a step that is given; integrator.step = \"auto\" follows the safe one"}};
  for (const auto& [is, why] : faults)
    if (is) fail(monitor.at("on_violation").origin, "monitor.on_violation", fmt::format("\"repeat\" {}", why));
}

void readCheckpoints(const SceneTable& output, Scene& scene) {
  if (!output.given("checkpoint_every")) return;
  const SceneEntry& entry = output.at("checkpoint_every");
  scene.checkpointInterval = entry.value.get<double>();
  const double count = scene.end / *scene.checkpointInterval;
  if (!(count <= mostSteps))
    fail(entry.origin, "output.checkpoint_every",
         fmt::format("{} s makes {:.3g} checkpoints to the end at {} s; at most {} are possible",
                     *scene.checkpointInterval, count, scene.end, mostSteps));
}

void readInitialSection(const SceneTable& section, Scene& scene) {
  if (!section.given("velocity") && !section.given("angular_velocity"))
    fail(section.origin, "initial.velocity", "missing; give velocity (m/s) or angular_velocity (rad/s)");
  if (section.given("point") && !section.given("angular_velocity"))
    fail(section.at("point").origin, "initial.point", "there is no angular_velocity for it");
  const auto given = [&](const char* key) {
    return section.given(key) ? vectorOf(section.at(key).value) : Eigen::Vector3d(0, 0, 0);
  };
  scene.initials.push_back(
      {selectionOf(section), given("velocity"), given("angular_velocity"), vectorOf(section.at("point").value)});
}

/// The nodes that a [[fix]] or [[move]] takes: those of a rigid body where it names one, whose guide follows.
NodeSelection takenNodes(const SceneTable& section, const Scene& scene, std::optional<Scene::Guide>& guide) {
  NodeSelection nodes;
  guide = guideOf(section, componentsOf(section), scene, nodes);
  return guide ? nodes : selectionOf(section);
}

Scene::Move moveOf(const SceneTable& section, Scene& scene) {
  std::optional<Scene::Guide> guide;
  NodeSelection nodes = takenNodes(section, scene, guide);
  const bool way = section.given("displacement");
  if (!section.given("velocity") && !section.given("angular_velocity") && !way)
    fail(section.origin, "move.velocity", "missing; give velocity (m/s), angular_velocity (rad/s) or displacement (m)");
  for (const char* other : {"velocity", "angular_velocity"})
    if (way && section.given(other))
      fail(section.at(other).origin, fmt::format("move.{}", other), "displacement is given too; give one of them");
  if (!guide && section.given("point") && !section.given("angular_velocity"))
    fail(section.at("point").origin, "move.point", "there is no angular_velocity for it");
  const auto given = [&](const char* key) {
    return section.given(key) ? vectorOf(section.at(key).value) : Eigen::Vector3d(0, 0, 0);
  };
  Scene::Move move{std::move(nodes),        componentsOf(section),     given("velocity"),
                   tableOf(section, scene), given("angular_velocity"), vectorOf(section.at("point").value)};
  move.guide = std::move(guide);
  if (!way) return move;
  const std::string& origin = section.at("displacement").origin;
  if (!move.table)
    fail(origin, "move.displacement", "it needs a factor that begins at 0; give factor, or times and factors");
  if (move.table->jumps())
    fail(section.at("ramp").origin, "move.ramp",
         "\"hold\" would make a displacement jump; must be linear, smooth or quintic");
  if (const double start = move.table->at(0); start != 0)
    fail(origin, "move.displacement",
         fmt::format("its factor is {} at t = 0, where nodes are at rest; it must be 0 there", start));
  if (!std::isfinite(move.table->slope(0)))
    fail(origin, "move.displacement", "its factor begins with no finite velocity at t = 0");
  move.way = given("displacement");
  return move;
}

void readLoadSection(const SceneTable& section, Scene& scene) {
  if (section.name == "move") {
    scene.moves.push_back(moveOf(section, scene));
    return;
  }
  if (section.name == "fix") {
    Scene::Fix fix{{}, componentsOf(section)};
    fix.nodes = takenNodes(section, scene, fix.guide);
    scene.fixes.push_back(std::move(fix));
    return;
  }
  NodeSelection nodes = selectionOf(section);
  if (section.name == "pressure") {
    scene.pressures.push_back({std::move(nodes), section.get<double>("pressure"), tableOf(section, scene),
                               section.origin + ": [[pressure]]"});
  } else {
    std::vector<std::string> given;
    for (const char* key : {"acceleration", "force", "each"})
      if (section.given(key)) given.emplace_back(key);
    if (given.size() != 1)
      fail(given.empty() ? section.origin : section.at(given.back()).origin, "force.acceleration",
           given.empty() ? "missing; give acceleration (m/s2), force (N) or each (N)"
                         : fmt::format("both {} and {} are given; give one of them", given[0], given[1]));
    Scene::Force force{std::move(nodes), std::nullopt, std::nullopt, std::nullopt, tableOf(section, scene)};
    const Eigen::Vector3d value = vectorOf(section.at(given[0]).value);
    (given[0] == "force" ? force.total : given[0] == "each" ? force.each : force.acceleration) = value;
    scene.forces.push_back(std::move(force));
  }
}

void readCutSection(const SceneTable& section, Scene& scene) {
  for (const auto& [one, other] : {std::pair{"point", "normal"}, std::pair{"line", "sweep"}})
    if (section.given(one) != section.given(other))
      fail(section.origin, std::string("cut.") + (section.given(one) ? other : one),
           fmt::format("missing; it goes with {}", section.given(one) ? one : other));
  if (section.given("point") == section.given("line"))
    fail(section.origin, "[[cut]]",
         section.given("line") ? "both a plane and a line are given; give one of them"
                               : "missing; give point and normal, or line and sweep");
  const std::string origin = section.origin + ": [[cut]]";
  const auto time = section.get<double>("time");
  if (!(time < scene.end))
    fail(section.at("time").origin, "cut.time",
         fmt::format("{} s is not before the end; must be < end = {} s", time, scene.end));
  try {
    CutSurface surface = [&] {
      if (section.given("point"))
        return CutSurface::plane(vectorOf(section.at("point").value), vectorOf(section.at("normal").value));
      std::vector<Eigen::Vector3d> line;
      for (const Json& point : section.at("line").value) line.push_back(vectorOf(point));
      return CutSurface::swept(std::move(line), vectorOf(section.at("sweep").value));
    }();
    scene.cuts.push_back({std::move(surface), time, section.get<double>("snap"),
                          section.named("positions", cutPositionsNames) == CutPositions::reference,
                          section.get<bool>("critical_step"), origin});
  } catch (const InputError& fault) {
    throw InputError(fmt::format("{}: {}", origin, fault.what()));
  }
}

void readErosion(const SceneTable& section, Scene& scene) {
  const bool given = std::ranges::any_of(section.entries, [](const auto& entry) { return entry.second.given; });
  if (!given) return;
  Scene::Erosion erosion;
  erosion.inverted = section.get<bool>("inverted");
  const auto limit = [&](const char* key) {
    return section.given(key) ? std::optional(section.get<double>(key)) : std::nullopt;
  };
  erosion.stretch = limit("max_stretch");
  erosion.vonMises = limit("max_von_mises");
  erosion.principalStress = limit("max_principal_stress");
  erosion.step = limit("least_step");
  erosion.every = section.get<std::int64_t>("every");
  if (!erosion.inverted && !erosion.stretch && !erosion.vonMises && !erosion.principalStress && !erosion.step)
    fail(section.origin, "[erosion]",
         "there is no criterion; give inverted = true, max_stretch, max_von_mises, max_principal_stress or least_step");
  scene.erosion = erosion;
}

/// Scene::places: keys that are false, 0 or "none" switch nothing on, but some switch off what is on without them.
std::map<std::string, std::string> placesOf(const std::vector<SceneTable>& sections) {
  const Json off[] = {false, 0, "none"};
  std::map<std::string, std::string> places;
  for (const SceneTable& section : sections) {
    places.emplace(section.name, section.origin);
    for (const auto& [key, entry] : section.entries)
      if (entry.given && (std::ranges::find(off, entry.value) == std::end(off) ||
                          std::ranges::any_of(sceneKeys(), [&](const SceneKey& known) {
                            return known.section == section.name && known.key == key && known.fallback == "true";
                          })))
        places.emplace(section.name + "." + key, entry.origin);
  }
  return places;
}

/// Options of a handler that are not given have other defaults on a GPU.
void takeDefaultsOfGpu(Scene& scene) {
  const HandlerInfo* handler = findHandler(scene.handler);
  if (handler && scene.device != RunDevice::cpu && !refusalOf(scene, SceneUse::gpu))
    handler->forGpu(scene.handlerOptions.own);
}

Json echoOf(const std::vector<SceneTable>& sections) {
  Json echo = Json::object();
  const auto isList = [&](const std::string& name) {
    const auto known = sceneSections();
    const auto section = std::ranges::find(known, name, &SceneSection::name);
    return section->list || (section->alsoList && std::ranges::count(sections, name, &SceneTable::name) > 1);
  };
  for (const SceneTable& section : sections) {
    Json values = Json::object();
    for (const SceneKey& key : sceneKeys())  // the table's order
      if (key.section == section.name && section.entries.count(key.key) != 0)
        values[key.key] = section.at(key.key).value;
    if (isList(section.name))
      echo[section.name].push_back(std::move(values));
    else
      echo[section.name] = std::move(values);
  }
  return echo;
}

}  // namespace

Eigen::Vector3d vectorOf(const Json& value) {
  return {value[0].get<double>(), value[1].get<double>(), value[2].get<double>()};
}

NodeSelection selectionOf(const SceneTable& section, const std::string& prefix) {
  const std::string where = prefix + "where", set = prefix + "set";
  if (section.given(where) == section.given(set))
    fail(section.given(set) ? section.at(set).origin : section.origin, section.name + "." + where,
         section.given(set)
             ? fmt::format("both {} and {} are given; give one of them", where, set)
             : fmt::format("missing; give a condition, e.g. {} = \"x < 1e-6\", or {} = \"NAME\"", where, set));
  if (section.given(set)) return {std::nullopt, section.get<std::string>(set), section.where(set)};
  return NodeSelection::parse(section.get<std::string>(where), section.where(where));
}

std::optional<TimeTable> tableOf(const SceneTable& section, Scene& scene) {
  if (section.given("factor")) {
    for (const char* key : {"times", "factors", "ramp"})
      if (section.given(key))
        fail(section.at(key).origin, section.name + "." + key, "is of a table, and factor is given; give one of them");
    const auto text = section.get<std::string>("factor");
    try {
      return TimeTable(TimeExpression(text), scene.end);
    } catch (const InputError& fault) {
      const std::string what = fault.what();
      fail(section.at("factor").origin, section.name + ".factor",
           what.starts_with("\"") ? what : fmt::format("{}: {}", inQuotes(text), what));
    }
  }
  if (!section.given("times") && !section.given("factors")) {
    if (section.given("ramp"))
      fail(section.at("ramp").origin, section.name + ".ramp", "there is no table; give times and factors");
    return std::nullopt;
  }
  for (const auto& [one, other] : {std::pair{"times", "factors"}, std::pair{"factors", "times"}})
    if (!section.given(one))
      fail(section.at(other).origin, section.name + "." + one, fmt::format("missing; it goes with {}", other));
  try {
    return TimeTable(section.get<std::vector<double>>("times"), section.get<std::vector<double>>("factors"),
                     section.named("ramp", rampNames));
  } catch (const InputError& fault) {
    fail(section.at("times").origin, section.name + ".times", fault.what());
  }
}

NodeSelection NodeSelection::parse(const std::string& text, const std::string& origin) {
  if (text.rfind("set:", 0) == 0) return {std::nullopt, text.substr(4), origin};
  try {
    return {WhereExpression(text), {}, origin};
  } catch (const InputError& fault) {
    const bool isName = !text.empty() && std::ranges::all_of(text, [](unsigned char c) {
      return std::isalnum(c) != 0 || c == '_' || c == '-' || c == '.';
    });
    throw InputError(fmt::format("{}: {}: {}{}", origin, inQuotes(text), fault.what(),
                                 isName ? fmt::format("; a named set is written \"set:{}\"", text) : ""));
  }
}

std::string tooManySteps(double h, double end) {
  const double steps = end / h;
  if (steps <= mostSteps) return {};
  return fmt::format("{} s makes {:.3g} steps to the end at {} s; at most {} are possible", h, steps, end, mostSteps);
}

namespace {
Scene makeScene(const std::filesystem::path& file, const std::vector<SceneTable>& sections) {
  Scene scene;
  scene.file = file;
  scene.echo = echoOf(sections);
  scene.places = placesOf(sections);
  const auto section = [&](std::string_view name) -> const SceneTable& {
    return *std::find_if(sections.begin(), sections.end(), [&](const SceneTable& s) { return s.name == name; });
  };
  readMeshSection(section("mesh"), scene);

  readMaterials(sections, scene);
  readIntegratorSection(section("integrator"), section("monitor"), section("damping"), scene);
  readHandlerSection(section("handler"), section("monitor"), section("damping"), scene);
  readDevice(section("integrator"), scene);
  readRigidSections(sections, scene);
  for (const SceneTable& s : sections)
    if (s.name == "fix" || s.name == "move" || s.name == "force" || s.name == "pressure") readLoadSection(s, scene);

  for (const SceneTable& s : sections)
    if (s.name == "initial") readInitialSection(s, scene);

  for (const SceneTable& s : sections)
    if (s.name == "cut") readCutSection(s, scene);
  std::stable_sort(scene.cuts.begin(), scene.cuts.end(),
                   [](const Scene::Cut& a, const Scene::Cut& b) { return a.time < b.time; });
  readDiscreteSections(sections, scene);

  const SceneTable& output = section("output");
  if (output.given("every")) {
    scene.frameInterval = output.get<double>("every");
    const double frames = scene.end / *scene.frameInterval;
    if (!(frames <= mostSteps))
      fail(output.at("every").origin, "output.every",
           fmt::format("{} s makes {:.3g} frames to the end at {} s; at most {} are possible", *scene.frameInterval,
                       frames, scene.end, mostSteps));
  }
  scene.exactTimes = output.get<bool>("exact_times");
  if (scene.exactTimes && !scene.frameInterval)
    fail(output.at("exact_times").origin, "output.exact_times", "there are no frames; give output.every");
  readCheckpoints(output, scene);
  readErosion(section("erosion"), scene);
  checkRepeats(section("monitor"), scene);
  scene.fields = output.get<std::vector<std::string>>("fields");
  scene.historyEvery = output.get<std::int64_t>("history_every");
  readProbes(sections, output, scene);
  scene.energy = output.get<bool>("energy");
  scene.picture = output.get<bool>("picture");
  const IntegratorInfo& info = *integratorCatalog().find(scene.method);
  const bool noCriticalStep = std::isinf(info.imaginaryLimit) || info.partitioned;
  if (noCriticalStep && !output.given("fields")) std::erase(scene.fields, "critical_step");
  for (const std::string& field : scene.fields)
    if (noCriticalStep && (field == "critical_step" || findMetric(field)))
      fail(output.at("fields").origin, "output.fields",
           fmt::format("\"{}\": \"{}\" {} and has no critical step", field, scene.method,
                       info.partitioned ? "chooses its stiff elements by the step" : "is stable at every step"));
  if (scene.metric.empty() && std::find(scene.fields.begin(), scene.fields.end(), "metric") != scene.fields.end())
    fail(output.at("fields").origin, "output.fields", "\"metric\" needs a metric; set monitor.metric");
  requireTogether(scene);
  takeDefaultsOfGpu(scene);
  return scene;
}
}  // namespace

Scene readScene(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  if (isModelFile(file)) return sceneOfModel(file, DeckUse::run, overrides);
  return makeScene(file, readSceneTables(file, overrides));
}

bool isModelFile(const std::filesystem::path& file) { return isDeckFile(file) || isMjcfFile(file); }

Scene sceneOfModel(const std::filesystem::path& file, DeckUse use, const std::vector<std::string>& overrides) {
  DeckScene model = isMjcfFile(file) ? readMjcfScene(file) : readDeckScene(file, use);
  Scene scene = makeScene(file, sceneTablesOfDeck(file, model, overrides));
  scene.ofModel = true;
  scene.notes = std::move(model.notes);
  scene.mayBeStable = std::move(model.mayBeStable);
  return scene;
}

Scene sceneOfRun(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "summary.json";
  const Json summary =
      Json::parse(readBytes(file, "; it is there when a run has ended in this folder"), nullptr, false);
  const auto echo = summary.is_object() ? summary.find("scene") : summary.end();
  if (!summary.is_object() || echo == summary.end() || !echo->is_object())
    throw InputError(fmt::format("{}: not the summary of a run; it has no \"scene\"", file.string()));
  return sceneOfEcho(file, *echo);
}

Scene sceneOfEcho(const std::filesystem::path& file, const Json& echo) {
  return makeScene(file, sceneTablesOfEcho(file, tomlOfSections(echo)));
}

std::string Scene::where(const std::string& sectionOrKey) const {
  const auto place = places.find(sectionOrKey);
  const auto known = sceneSections();
  const auto section = std::ranges::find(known, sectionOrKey, &SceneSection::name);
  return fmt::format(fmt::runtime(section == known.end() ? "{}: {}"
                                  : section->list        ? "{}: [[{}]]"
                                                         : "{}: [{}]"),
                     place == places.end() ? file.string() : place->second, sectionOrKey);
}

std::optional<std::array<bool, 3>> parseComponents(std::string_view text) {
  std::array<bool, 3> result{};
  for (char c : text) {
    if (c < 'x' || c > 'z' || result[c - 'x']) return std::nullopt;
    result[c - 'x'] = true;
  }
  if (text.empty()) return std::nullopt;
  return result;
}

Scene::Fix parseFix(const std::string& text, const std::string& origin) {
  const std::size_t begin = text.rfind("set:", 0) == 0 ? 4 : 0, colon = text.rfind(':');
  if (colon == std::string::npos || colon < begin) return {NodeSelection::parse(text, origin), {true, true, true}};
  const std::string components = text.substr(colon + 1);
  const auto held = parseComponents(components);
  if (!held)
    throw InputError(fmt::format("{}: {}: {} names no components; must be some of x, y, z, each once", origin,
                                 inQuotes(text), inQuotes(components)));
  return {NodeSelection::parse(text.substr(0, colon), origin), *held};
}

bool Scene::hasUniformStrain() const {
  return std::any_of(rules.begin(), rules.end(), [](const auto& rule) {
    return findRule(*findElementByName(rule.first), rule.second)->uniformStrain;
  });
}

std::map<std::string, std::string> parseRules(const std::vector<std::string>& texts, const std::string& origin) {
  std::map<std::string, std::string> rules;
  for (const std::string& text : texts) {
    const std::size_t equals = text.find('=');
    const std::string name = text.substr(0, equals);
    const ElementInfo* element = nullptr;
    std::vector<std::string> elements;
    for (const ElementInfo& info : allElements()) {
      elements.emplace_back(info.name);
      if (info.name == name) element = &info;
    }
    if (equals == std::string::npos || !element)
      throw InputError(fmt::format("{}: {} must be ELEMENT=RULE; elements are {}", origin, inQuotes(text),
                                   fmt::join(elements, ", ")));
    const std::string rule = text.substr(equals + 1);
    if (!findRule(*element, rule) || rule.empty()) {
      std::vector<std::string> known;
      for (const QuadratureRule& r : element->rules) known.emplace_back(r.name);
      throw InputError(fmt::format("{}: unknown rule {} for {}; {}known are {}", origin, inQuotes(rule), name,
                                   didYouMean(rule, known), fmt::join(known, ", ")));
    }
    rules[name] = rule;
  }
  return rules;
}

}  // namespace ringwatch
