#include <algorithm>
#include <cmath>

#include <ringwatch/app/scene/capabilities.h>
#include <ringwatch/app/scene/integrator_catalog.h>
#include <ringwatch/app/scene/key_binding.h>
#include <ringwatch/base/user_text.h>
#include <ringwatch/body/element_stress.h>
#include <ringwatch/handlers/handler.h>
#include <ringwatch/monitor/metrics/metrics.h>

namespace ringwatch {
namespace {

using F = Feature;

std::vector<std::string> andNone(std::vector<std::string> names, bool first) {
  names.insert(first ? names.begin() : names.end(), "none");
  return names;
}

/// A key that names an entry of a registry, and leaves its member empty for "none".
BoundKey<Scene> nameOrNone(const std::string& name, std::string Scene::*member, std::string help, SceneKey rest) {
  rest.fallback = "\"none\"";
  BoundKey<Scene> bound = key(name, member, std::move(help), std::move(rest));
  bound.store = [name, member](const SceneTable& table, Scene& scene) {
    const auto value = table.get<std::string>(name);
    scene.*member = value == "none" ? "" : value;
  };
  return bound;
}

/// What [output] fields may name: cell data of the frames. "critical_step" is an older name of "reduced-1-ring".
std::vector<std::string> frameFieldNames() {
  std::vector<std::string> names = namesOf(allMetrics());
  for (const char* name : {"metric", "verdict", "handler", "critical_step"}) names.emplace_back(name);
  for (const StressMeasure& measure : allStressMeasures()) names.emplace_back(measure.name);
  return names;
}

/// Why an integrator has no critical step of elements; "" where it has one.
std::string_view whyNoCriticalStep(const IntegratorInfo& info) {
  return info.partitioned                  ? "chooses its stiff elements by the step"
         : std::isinf(info.imaginaryLimit) ? "is stable at every step"
                                           : "";
}

/// Refuses an interval of which there are too many to the end.
void requireFew(const SceneTable& table, const std::string& name, std::optional<double> interval, double end,
                std::string_view what) {
  const std::string fault = interval ? tooMany(what, *interval, end) : "";
  if (!fault.empty()) fail(table.at(name).origin, table.name + "." + name, fault);
}

/// A step that is given must be within the run.
void requireWithin(const SceneTable& table, std::optional<double> step, const Scene& scene, std::string_view end) {
  if (step && *step > scene.end)
    fail(table.at("step").origin, table.name + ".step",
         fmt::format("{} s is beyond the end; must be <= {} = {} s", *step, end, scene.end));
  requireFew(table, "step", step, scene.end, "steps");
}

void checkIntegrator(const SceneTable& table, Scene& scene) {
  const auto refuse = [&](const char* key, const std::string& what) {
    fail(table.at(key).origin, joinText("integrator.", key), what);
  };
  if (scene.holdsStep && scene.step) refuse("hold", "is for step = \"auto\"; a step that is given is held");
  requireWithin(table, scene.step, scene, "end");
  scene.devices.clear();
  for (const double number : table.get<std::vector<double>>("devices")) {
    if (number != std::floor(number) || number > 1e6)
      refuse("devices", fmt::format("{} is not the number of a GPU: they are counted from 0", number));
    const auto device = static_cast<int>(number);
    if (std::ranges::find(scene.devices, device) != scene.devices.end())
      refuse("devices", fmt::format("GPU {} is named twice", device));
    scene.devices.push_back(device);
  }
  if (scene.device == RunDevice::cpu && scene.devices != std::vector<int>{0})
    refuse("devices", "the steps are taken on the CPU; set integrator.device = \"cuda\" or \"auto\"");
}

void checkDamping(const SceneTable& table, Scene& scene) {
  for (const char* key : {"linear_bulk_viscosity", "quadratic_bulk_viscosity"})
    if (table.given(key) && !table.given("bulk_viscosity"))
      fail(table.at(key).origin, joinText("damping.", key), "goes with bulk_viscosity = true; set that too");
  if (!table.get<bool>("bulk_viscosity")) scene.linearBulkViscosity = scene.quadraticBulkViscosity = 0;
}

void checkMonitor(const SceneTable& table, Scene& scene) {
  const auto require = [&](bool fits, const char* key, std::string_view what) {
    if (!fits) fail(table.at(key).origin, joinText("monitor.", key), std::string(what));
  };
  const auto requireKey = [&](bool fits, const char* key, const std::string& what) {
    if (!fits) throw InputError(fmt::format("{}: {}", scene.where(key), what));
  };
  require(scene.mode != MonitorMode::metric || !scene.metric.empty(), "mode",
          "\"metric\" needs a metric; set monitor.metric");
  if (!table.get<bool>("bracket")) {
    require(scene.mode != MonitorMode::threshold, "bracket",
            "false leaves nothing to prove, but mode = \"threshold\" does; take one of them out");
    scene.mode = MonitorMode::metric;
  }
  requireKey(scene.step || scene.mode == MonitorMode::bracket, "integrator.step",
             "\"auto\" follows the safe step; it needs monitor.bracket = true and monitor.mode = \"bracket\"");
  require(scene.onViolation != OnViolation::reduceStep || scene.monitored(), "on_violation",
          "\"reduce-step\" needs monitor.bracket = true or a monitor.metric");
  require(!table.given("repeats") || scene.onViolation == OnViolation::repeat, "repeats",
          "is for on_violation = \"repeat\"; take it out");
  const IntegratorInfo& info = *integratorCatalog().find(scene.method);
  requireKey(!scene.monitored() || info.imaginaryLimit > 0, "integrator.method",
             fmt::format("\"{}\" is unstable at every step without damping, so there is no critical step to monitor; "
                         "choose another, or set monitor.bracket = false and monitor.metric = \"none\"",
                         scene.method));
  if (const std::string_view why = whyNoCriticalStep(info); !why.empty()) {
    // No step is too large for it, or its stiff part is whatever the step asks for: there is nothing to watch but
    // energies and the state itself.
    requireKey(scene.step.has_value(), "integrator.step",
               fmt::format("\"auto\" follows the critical step, and \"{}\" {}; give a number", scene.method, why));
    scene.mode = MonitorMode::metric;
    scene.metric.clear();
  }
  const bool repeats = scene.onViolation == OnViolation::repeat, handles = scene.onViolation == OnViolation::handle;
  require(!repeats || scene.proves(), "on_violation",
          "\"repeat\" goes back to certified states; it needs monitor.mode = \"bracket\" or \"threshold\"");
  require(!repeats || scene.step || scene.holdsStep, "on_violation",
          "\"repeat\" is for a step that is given; integrator.step = \"auto\" follows the safe one");
  require(!handles || !scene.handler.empty(), "on_violation", "\"handle\" needs a handler; set handler.method");
  require(!handles || scene.proves(), "on_violation",
          "\"handle\" follows the proven bracket; it needs monitor.mode = \"bracket\" or \"threshold\"");
}

/// The keys of [handler] that the handler declares.
void readHandlerOptions(const HandlerInfo& info, const SceneTable& table, Scene& scene) {
  if (!info.takes(scene.handlerOptions.selection)) {
    std::vector<std::string> names;
    for (const Selection one : info.selections) names.push_back(inQuotes(selectionNames.nameOf(one)));
    fail(table.at("selection").origin, "handler.selection",
         fmt::format("\"{}\" does not go with {}; must be {}", selectionNames.nameOf(scene.handlerOptions.selection),
                     info.name, fmt::join(names, " or ")));
  }
  Options& own = scene.handlerOptions.own;
  for (const auto& [key, entry] : table.entries) {
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
      fail(table.at(key).origin, "handler." + key,
           fmt::format("{} {}, with the handler \"{}\"", table.at(key).value.dump(), fault, info.name));
  const Options all = completed(info.name, info.options, own);
  scene.reduceOnFailure = findOption(info.options, "on_failure") && all.text("on_failure") == "reduce-step";
}

void checkHandler(const SceneTable& table, Scene& scene) {
  scene.handlerOptions.damping = scene.damping;
  if (scene.handler.empty()) {
    for (const auto& [key, entry] : table.entries)
      if (entry.given && key != "method")
        fail(entry.origin, "handler." + key, "there is no handler; set handler.method");
    return;
  }
  const HandlerInfo& info = *findHandler(scene.handler);
  for (const char* key : {"step", "factor"})  // by which "auto" chooses elements
    if (scene.step && table.given(key))
      fail(table.at(key).origin, joinText("handler.", key),
           fmt::format("is for integrator.step = \"auto\", and {} s is given; take one of them out", *scene.step));
  requireWithin(table, scene.handlerStep, scene, "integrator.end");
  readHandlerOptions(info, table, scene);
  if (!scene.damping.any()) return;
  if (const auto [key, why] = dampingRefusedBy(info, scene.damping); !why.empty())
    throw InputError(fmt::format("{}: {}", scene.where(fmt::format("damping.{}", key)), why));
  if (table.given("solver") && table.get<std::string>("solver") == "newton")
    fail(table.at("solver").origin, "handler.solver", "\"newton\" works without [damping]; take \"auto\"");
  if (scene.step && !(0.5 * scene.damping.alpha * *scene.step < 1))
    throw InputError(fmt::format("{}: {} 1/s needs a step below {} s", scene.where("damping.mass"), scene.damping.alpha,
                                 2 / scene.damping.alpha));
}

/// The options of handlers, some of which are features.
BoundKeys<Scene> handlerKeys() {
  BoundKeys<Scene> keys = unbound<Scene>(keysOfOptions(handlerInfos(), &HandlerInfo::options));
  for (BoundKey<Scene>& bound : keys) {
    if (bound.key.key == "solver") bound.key.features.add(F::handlerSolver);
    if (bound.key.key == "on_failure") bound.key.features.add(F::handlerHalves);
  }
  return keys;
}

void checkCut(const SceneTable& table, Scene& scene, Scene::Cut& cut) {
  for (const auto& [one, other] : {std::pair{"point", "normal"}, std::pair{"line", "sweep"}})
    if (table.given(one) != table.given(other))
      fail(table.origin, joinText("cut.", table.given(one) ? other : one),
           fmt::format("missing; it goes with {}", table.given(one) ? one : other));
  if (!(cut.time < scene.end))
    fail(table.at("time").origin, "cut.time",
         fmt::format("{} s is not before the end; must be < end = {} s", cut.time, scene.end));
  try {
    if (table.given("point")) {
      cut.surface = CutSurface::plane(vectorOf(table.at("point").value), vectorOf(table.at("normal").value));
    } else {
      std::vector<Eigen::Vector3d> line;
      for (const auto& point : table.at("line").value) line.push_back(vectorOf(point));
      cut.surface = CutSurface::swept(std::move(line), vectorOf(table.at("sweep").value));
    }
  } catch (const InputError& fault) {
    throw InputError(fmt::format("{}: {}", cut.origin, fault.what()));
  }
}

void checkErosion(const SceneTable& table, Scene&, Scene::Erosion& erosion) {
  if (!erosion.inverted && !erosion.stretch && !erosion.vonMises && !erosion.principalStress && !erosion.step)
    fail(table.origin, "[erosion]",
         "there is no criterion; give inverted = true, max_stretch, max_von_mises, max_principal_stress or least_step");
}

void checkOutput(const SceneTable& table, Scene& scene) {
  const auto refuse = [&](const char* key, const std::string& what) {
    fail(table.at(key).origin, joinText("output.", key), what);
  };
  requireFew(table, "every", scene.frameInterval, scene.end, "frames");
  requireFew(table, "checkpoint_every", scene.checkpointInterval, scene.end, "checkpoints");
  if (scene.exactTimes && !scene.frameInterval) refuse("exact_times", "there are no frames; give output.every");
  const std::string_view why = whyNoCriticalStep(*integratorCatalog().find(scene.method));
  if (!why.empty() && !table.given("fields")) std::erase(scene.fields, "critical_step");
  for (const std::string& field : scene.fields)
    if (!why.empty() && (field == "critical_step" || findMetric(field)))
      refuse("fields", fmt::format("\"{}\": \"{}\" {} and has no critical step", field, scene.method, why));
  if (scene.metric.empty() && std::ranges::find(scene.fields, "metric") != scene.fields.end())
    refuse("fields", "\"metric\" needs a metric; set monitor.metric");
  if (scene.reactions && scene.fixes.empty() && scene.moves.empty())
    refuse("reactions", "there is no [[fix]] and no [[move]] that could react");
  if (table.given("probe_every") && !scene.probed())
    refuse("probe_every", "there is nothing to write; give a [[probe]] or reactions = true");
}

}  // namespace

SceneSection integratorSection() {
  return plainSection(
      {.name = "integrator", .help = "how time advances", .required = true},
      {{key("method", &Scene::method, "scheme",
            {.fallback = "\"symplectic-euler\"", .choices = namesOf(integratorInfos()), .features = {F::noBracket}}),
        numberOrAuto("step", &Scene::step, "step; \"auto\" follows the safe step whenever the monitor evaluates it",
                     {.unit = "s", .required = true, .range = KeyRange::positive, .features = {F::handlerAuto}}),
        key("hold", &Scene::holdsStep,
            "with step = \"auto\": keep the step of the first state, and judge it as one that is given",
            {.features = {F::hold}}),
        key("end", &Scene::end, "time at which the run ends; with a fixed step, its first multiple from there on",
            {.unit = "s", .required = true, .range = KeyRange::positive}),
        choice("device", &Scene::device, runDeviceNames,
               "where the steps are taken; \"auto\" takes a GPU if there is one; the state comes back at every "
               "observation of the monitor and every row of the history"),
        key("devices", &Scene::devices,
            "GPUs that share the steps, by CUDA's numbers; [] takes all of the machine. The results are those of one, "
            "to the last bit",
            {.range = KeyRange::notNegative, .features = {F::handlerDevices}}),
        key("safety", &Scene::safety,
            "share of the safe step that \"auto\" and on_violation = \"reduce-step\" or \"repeat\" take",
            {.range = KeyRange::factor})}},
      checkIntegrator);
}

SceneSection dampingSection() {
  const Features rayleigh{F::rayleigh, F::provenDamping, F::handlerDamping};
  return plainSection(
      {.name = "damping",
       .help = "of the whole body: Rayleigh damping, C = mass M + stiffness K(x), and bulk viscosity; its forces lag "
               "in the explicit schemes"},
      {{key("mass", at(&Scene::damping, &RayleighDamping::alpha), "mass-proportional part, takes slow motion",
            {.unit = "1/s", .range = KeyRange::notNegative, .features = rayleigh}),
        key("stiffness", at(&Scene::damping, &RayleighDamping::beta),
            "stiffness-proportional part, takes fast vibrations; it shortens the critical step",
            {.unit = "s", .range = KeyRange::notNegative, .features = rayleigh | F::stiffnessDamping}),
        {{.key = "bulk_viscosity",
          .type = SceneType::boolean,
          .fallback = "false",
          .features = {F::elementDamping},
          .help = "a viscous pressure in every element, as Abaqus/Explicit has it unless told otherwise"}},
        key("linear_bulk_viscosity", &Scene::linearBulkViscosity,
            "b1: pressure -b1 x density x wave speed at rest x L x rate of volume, L the cube root of an element's "
            "volume at rest; takes the ringing of single elements",
            {.fallback = "0.06", .range = KeyRange::notNegative}),
        key("quadratic_bulk_viscosity", &Scene::quadraticBulkViscosity,
            "b2: pressure density x (b2 x L x rate of volume)^2 under compression; spreads shocks over elements",
            {.fallback = "1.2", .range = KeyRange::notNegative})}},
      checkDamping);
}

SceneSection monitorSection() {
  return plainSection(
      {.name = "monitor", .help = "what is watched, and what happens when the step is too large"},
      {{{{.key = "bracket",
          .type = SceneType::boolean,
          .fallback = "true",
          .features = {F::noBracket},
          .help = "keep the proven bracket safe <= critical step <= optimistic; false is mode = \"metric\""}},
        choice("mode", &Scene::mode, monitorModeNames, "", {.features = {F::noBracket}}),
        nameOrNone("metric", &Scene::metric, "also keep an estimate by this metric",
                   {.choices = andNone(namesOf(allMetrics()), false), .features = {F::metric}}),
        key("margin", &Scene::margin, "taken off the step by metric", {.range = KeyRange::share}),
        key("every", &Scene::every, "steps between evaluations",
            {.unit = "steps", .range = KeyRange::atLeastOne, .features = {F::gaps}}),
        key("budget", &Scene::budget,
            "what the bracket may take after its first observation, as a share of a step's own work, counted; when it "
            "is used up the proof stays and the bracket becomes wider; more is taken only by evaluations of elements "
            "that a raise of the bound does not replace or at a higher cost, and in small bodies, up to six steps' "
            "work, for telling whether a step without a proof is proven unstable; from 100 on there is no limit; "
            "without the key it is 0.1, and small bodies have no limit before some 0.2 s are taken",
            {.range = KeyRange::notNegative, .features = {F::budget}}),
        key("certificates", &Scene::certificates,
            "write a proof of the bracket, from scratch, to certificates/ at every such observation, and before and at "
            "the first step that is proven unstable, for ringwatch-check; none without it",
            {.unit = "observations", .range = KeyRange::atLeastOne, .features = {F::certificates}}),
        choice("on_violation", &Scene::onViolation, onViolationNames, "",
               {.features = {F::savedStates, F::repeat, F::reduceStep, F::handlerHandle}}),
        key("repeats", &Scene::repeats,
            "on_violation = \"repeat\": how often a run goes back to one state before it ends",
            {.range = KeyRange::atLeastOne}),
        key("energy_tolerance", &Scene::energyTolerance,
            "energy balance error, as a share of the largest energy so far, that is reported; such a run is not called "
            "stable",
            {.range = KeyRange::positive}),
        key("require_certified", &Scene::requireCertified,
            "a run fails (exit status 1) unless every step is certified, which takes every = 1; as "
            "--require-certified",
            {.features = {F::mustCertify}})}},
      checkMonitor);
}

SceneSection handlerSection() {
  return plainSection(
      {.name = "handler",
       .help = "what is done about elements that need a smaller step",
       .alternatives = {{"step", "factor", SceneAlternative::Need::atMostOne}}},
      {{nameOrNone("method", &Scene::handler, "how elements that need a smaller step are treated",
                   {.choices = andNone(namesOf(handlerInfos()), true),
                    .aliases = aliasesOf(handlerInfos()),
                    .features = {F::handler}}),
        choice("selection", at(&Scene::handlerOptions, &HandlerOptions::selection), selectionNames, "which elements"),
        key("margin", at(&Scene::handlerOptions, &HandlerOptions::margin),
            "elements are chosen as for a step of step/(1 - margin), so that the explicit part may stiffen; without, "
            "0.1, 0.15 for mass-scaling, and 0.3 for local-time-stepping with stvk",
            {.range = KeyRange::share}),
        key("step", &Scene::handlerStep,
            "with integrator.step = \"auto\": the step that elements are chosen for, and that is not passed",
            {.unit = "s", .range = KeyRange::positive}),
        key("factor", &Scene::handlerFactor,
            "with integrator.step = \"auto\": this times the safe step of the whole body at the start, in place of "
            "step",
            {.range = KeyRange::positive})},
       handlerKeys()},
      checkHandler);
}

SceneSection cutSection() {
  const auto later = [](const char* name, SceneType type, const char* unit, const char* help) {
    return BoundKey<Scene::Cut>{{.key = name, .type = type, .unit = unit, .help = help}};
  };
  return listSection<Scene::Cut>(
      {.name = "cut",
       .help = "cuts through a mesh of tetrahedra along a plane or a swept line; lips may pass through each other",
       .features = {F::cuts},
       .alternatives = {{"point", "line"}}},
      &Scene::cuts,
      {{key("time", &Scene::Cut::time, "it is made before the first step that begins then",
            {.unit = "s", .required = true, .range = KeyRange::notNegative}),
        later("point", SceneType::vector, "m", "of an endless plane; with normal"),
        later("normal", SceneType::vector, "", "of the plane, of any length"),
        later("line", SceneType::vectors, "m", "or two and more points, with sweep"),
        later("sweep", SceneType::vector, "m", "how far the line is swept; the cut ends with it"),
        key("snap", &Scene::Cut::snap,
            "nodes nearer than this are taken as on the surface, which saves slivers; 0 cuts exactly",
            {.unit = "edge lengths", .range = {0, 0.5, true, true}}),
        choice("positions", &Scene::Cut::positions, cutPositionsNames,
               "where the surface lies: in space at that time, or in the body at rest"),
        key("critical_step", &Scene::Cut::criticalStep,
            "the summary also has that of the whole body before and after, which takes most of the time of a cut of a "
            "large mesh")}},
      checkCut);
}

SceneSection erosionSection() {
  using E = Scene::Erosion;
  return optionalSection<E>(
      {.name = "erosion",
       .help = "elements that leave the run where a criterion holds; their mass stays at their nodes, their strain "
               "energy counts as dissipated",
       .features = {F::erosion}},
      &Scene::erosion,
      {{key("inverted", &E::inverted,
            "elements whose deformation gradient has no positive determinant at a quadrature point leave"),
        key("max_stretch", &E::stretch, "elements whose largest principal stretch is above leave",
            {.range = {1, infinity, false, true}}),
        key("max_von_mises", &E::vonMises, "elements leave the von Mises stress of whose mean Cauchy stress is above",
            {.unit = "Pa", .range = KeyRange::positive}),
        key("max_principal_stress", &E::principalStress,
            "elements leave the largest principal value of whose mean Cauchy stress is above",
            {.unit = "Pa", .range = KeyRange::positive}),
        key("least_step", &E::step,
            "elements leave whose own critical step, with the mass that they give to their nodes, is below",
            {.unit = "s", .range = KeyRange::positive}),
        key("every", &E::every, "steps between looks", {.unit = "steps", .range = KeyRange::atLeastOne})}},
      checkErosion);
}

SceneSection outputSection() {
  return plainSection(
      {.name = "output", .help = "what is written besides history.csv and summary.json"},
      {{key("every", &Scene::frameInterval, "time between ParaView frames; no frames without it",
            {.unit = "s", .range = KeyRange::positive}),
        key("exact_times", &Scene::exactTimes,
            "frames at the very multiples of every, also between steps; without, at the first step that reaches one",
            {.features = {F::exactTimes}}),
        key("fields", &Scene::fields,
            "cell data of the frames: each element's step by a metric (critical_step stands for reduced-1-ring), by "
            "the monitor's metric with its margin, verdict, handled elements, and of the element's mean Cauchy stress "
            "von_mises, pressure (positive where it is pressed together), max_principal_stress, principal_stresses "
            "and the tensor cauchy_stress, Pa; max_stretch, its largest principal stretch, and its mean Green strain "
            "green_strain and principal_strains; tensors are xx, yy, zz, xy, yz, xz; displacement, velocity, sets and "
            "the frame's bracket are always there",
            {.choices = frameFieldNames(), .features = {F::fields}}),
        key("checkpoint_every", &Scene::checkpointInterval,
            "time between checkpoints, from the last of which `ringwatch run --resume DIR` goes on, bit by bit as the "
            "run would have. A signal that stops such a run leaves one too",
            {.unit = "s", .range = KeyRange::positive, .features = {F::savedStates, F::checkpoints}}),
        key("history_every", &Scene::historyEvery, "steps between rows of history.csv",
            {.unit = "steps", .range = KeyRange::atLeastOne}),
        key("probe_every", &Scene::probeEvery, "steps between rows of probes.csv",
            {.unit = "steps", .range = KeyRange::atLeastOne}),
        key("reactions", &Scene::reactions,
            "the reaction forces of each [[fix]] and [[move]], N, in probes.csv; a component that several hold counts "
            "for the first of them",
            {.features = {F::reactions}}),
        key("energy", &Scene::energy, "energies in the history, and their balance watched"),
        key("picture", &Scene::picture, "critical_step.png by gnuplot, when the critical step is monitored")}},
      checkOutput);
}

}  // namespace ringwatch
