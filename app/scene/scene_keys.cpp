#include <ringwatch/app/command/integrator_catalog.h>
#include <ringwatch/app/scene/scene_keys.h>

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include <ringwatch/app/command/help.h>
#include <ringwatch/app/output/frames.h>
#include <ringwatch/app/scene/scene.h>
#include <ringwatch/app/scene/scene_mesh.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/handlers/handler.h>
#include <ringwatch/integrators/integrator.h>
#include <ringwatch/materials/registry.h>
#include <ringwatch/monitor/metrics/metrics.h>

namespace ringwatch {
namespace {

constexpr SceneRange anything{};
constexpr SceneRange positive{0, infinity, false, true};
constexpr SceneRange notNegative{0, infinity, true, true};
constexpr SceneRange atLeastOne{1, infinity, true, true};
constexpr SceneRange share{0, 1, true, false};   // 0 <= s < 1
constexpr SceneRange factor{0, 1, false, true};  // 0 < s <= 1

constexpr std::array<SceneSection, 12> sections{{
    {"mesh", false, true, "a file or a generator with its parameters"},
    {"material", false, true,
     "one material for the whole body, or several [[material]], each for the elements that it selects", true},
    {"integrator", false, true, "how time advances"},
    {"damping", false, false, "Rayleigh damping, C = mass M + stiffness K(x); its forces lag in the explicit schemes"},
    {"monitor", false, false, "what is watched, and what happens when the step is too large"},
    {"handler", false, false, "what is done about elements that need a smaller step"},
    {"fix", true, false, "nodes that stay; each [[fix]] adds to the others"},
    {"initial", true, false,
     "velocities at the start, where motion is not prescribed; each [[initial]] adds to the others"},
    {"move", true, false, "nodes that move at a constant velocity, or one that follows a table of time"},
    {"force", true, false, "dead loads, constant or following a table of time"},
    {"cut", true, false,
     "cuts through a mesh of tetrahedra along a plane or a swept line; lips may pass through each other"},
    {"output", false, false, "what is written besides history.csv and summary.json"},
}};

template <class Table>
std::vector<std::string> namesOf(const Table& table) {
  std::vector<std::string> names;
  for (const auto& entry : table) names.emplace_back(entry.name);
  return names;
}

std::vector<std::string> metricNames() {
  std::vector<std::string> names = namesOf(allMetrics());
  names.emplace_back("none");
  return names;
}

std::vector<std::string> handlerNames() {
  std::vector<std::string> names{"none"};
  for (const HandlerEntry& entry : allHandlers()) names.emplace_back(entry.info->name);
  return names;
}

template <class Table>
std::vector<std::pair<std::string, std::string>> aliasesOf(const Table& table) {
  std::vector<std::pair<std::string, std::string>> aliases;
  for (const auto& entry : table)
    if (!entry.alias.empty()) aliases.emplace_back(entry.alias, entry.name);
  return aliases;
}

std::vector<HandlerInfo> handlerInfos() {
  std::vector<HandlerInfo> infos;
  for (const HandlerEntry& entry : allHandlers()) infos.push_back(*entry.info);
  return infos;
}

SceneType sceneTypeOf(const OptionInfo& option) {
  if (option.type == OptionType::text) return SceneType::text;
  if (option.automatic) return SceneType::numberOrAuto;
  return option.type == OptionType::integer ? SceneType::integer : SceneType::number;
}

/// A declared option as a key of the scene. owner: stands before its help.
SceneKey keyOf(std::string section, const OptionInfo& option) {
  const bool text = option.type == OptionType::text || option.automatic;
  SceneKey key{std::move(section),
               std::string(option.name),
               sceneTypeOf(option),
               std::string(option.unit),
               false,
               option.fallback.empty() || !text ? std::string(option.fallback) : fmt::format("\"{}\"", option.fallback),
               option.range,
               {},
               ""};
  if (option.automatic && option.type == OptionType::text) key.choices.emplace_back("auto");
  return key;
}

/// One key for options of the same name: it takes what any of them takes, and the entry that is chosen checks the
/// others.
void join(SceneKey& key, const OptionInfo& option) {
  for (const std::string_view choice : option.choices)
    if (std::find(key.choices.begin(), key.choices.end(), choice) == key.choices.end())
      key.choices.emplace_back(choice);
  if (option.range.low < key.range.low)
    key.range.low = option.range.low, key.range.lowIncluded = option.range.lowIncluded;
  if (option.range.high > key.range.high)
    key.range.high = option.range.high, key.range.highIncluded = option.range.highIncluded;
}

/// The options that entries of a registry declare, by name in the order of their first declaration; the help of each
/// says whose it is.
template <class Infos, class Member>
std::vector<SceneKey> keysOfOptions(const std::string& section, const Infos& infos, Member options) {
  std::vector<SceneKey> keys;
  for (const auto& info : infos)
    for (const OptionInfo& option : info.*options) {
      if (std::ranges::find(keys, option.name, &SceneKey::key) != keys.end()) continue;
      SceneKey& key = keys.emplace_back(keyOf(section, option));
      std::vector<std::pair<std::string, std::string>> helps;  // whose, what
      for (const auto& other : infos)
        if (const OptionInfo* same = findOption(other.*options, option.name)) {
          join(key, *same);
          const auto known = std::ranges::find(helps, same->help, &std::pair<std::string, std::string>::second);
          if (known == helps.end())
            helps.emplace_back(other.name, same->help);
          else
            known->first += ", " + std::string(other.name);
        }
      for (const auto& [owners, help] : helps)
        key.help += fmt::format("{}{}: {}", key.help.empty() ? "" : "; ", owners, help);
    }
  return keys;
}

std::vector<SceneKey> makeKeys() {
  using T = SceneType;
  std::vector<SceneKey> keys{
      {"mesh", "file", T::text, "", false, "", anything, {}, "mesh file, relative to the scene; or give generate"},
      {"mesh", "generate", T::text, "", false, "", anything, generatorNames(),
       "kind of generated mesh, instead of file"},
  };
  for (SceneKey& key : generatorSceneKeys()) keys.push_back(std::move(key));
  keys.push_back({"material", "model", T::text, "", true, "", anything, namesOf(allLaws()),
                  "constitutive law; help laws lists its parameters"});
  for (SceneKey& key : keysOfOptions("material", allLaws(), &LawInfo::parameters)) keys.push_back(std::move(key));
  const std::vector<SceneKey> rest{
      {"material",
       "where",
       T::text,
       "",
       false,
       "",
       anything,
       {},
       "elements that have it, by a condition on the centre of their nodes at rest, e.g. \"x < 0.1\"; each element "
       "has one material"},
      {"material", "set", T::text, "", false, "", anything, {}, "named element set of the mesh, instead of where"},
      {"material", "density", T::number, "kg/m3", true, "", positive, {}, "density at rest"},
      {"material", "lumping", T::text, "", false, "\"row-sum\"", anything, lumpingNames.names(),
       "how an element's mass goes to its nodes, of the whole body; " + lumpingNames.listing()},
      {"material",
       "rules",
       T::texts,
       "",
       false,
       "",
       anything,
       {},
       "quadrature rules of elements, of the whole body, e.g. [\"hex8=gauss-2x2x2\"]; `ringwatch verify elements` "
       "compares them"},
      {"integrator", "method", T::text, "", false, "\"symplectic-euler\"", anything, namesOf(integratorInfos()),
       "scheme"},
      {"integrator",
       "step",
       T::numberOrAuto,
       "s",
       true,
       "",
       positive,
       {},
       "step; \"auto\" follows the safe step whenever the monitor evaluates it"},
      {"integrator", "end", T::number, "s", true, "", positive, {}, "time at which the run ends"},
      {"integrator", "device", T::text, "", false, "\"cpu\"", anything, runDeviceNames.names(),
       "where the steps are taken; \"auto\" takes a GPU if there is one. Symplectic Euler without damping, alone or "
       "with imex; "
       "the state comes back at every observation of the monitor and every row of the history"},
      {"integrator",
       "safety",
       T::number,
       "",
       false,
       "0.95",
       factor,
       {},
       "share of the safe step that \"auto\" and on_violation = \"reduce-step\" take"},
      {"damping", "mass", T::number, "1/s", false, "0.0", notNegative, {}, "mass-proportional part, takes slow motion"},
      {"damping",
       "stiffness",
       T::number,
       "s",
       false,
       "0.0",
       notNegative,
       {},
       "stiffness-proportional part, takes fast vibrations; it shortens the critical step"},
      {"monitor",
       "bracket",
       T::boolean,
       "",
       false,
       "true",
       anything,
       {},
       "keep the proven bracket safe <= critical step <= optimistic; false is mode = \"metric\""},
      {"monitor", "mode", T::text, "", false, "\"bracket\"", anything, monitorModeNames.names(),
       monitorModeNames.listing(), aliasesOf(monitorModeNames)},
      {"monitor", "metric", T::text, "", false, "\"none\"", anything, metricNames(),
       "also keep an estimate by this metric"},
      {"monitor", "margin", T::number, "", false, "0.1", share, {}, "taken off the step by metric"},
      {"monitor", "every", T::integer, "steps", false, "1", atLeastOne, {}, "steps between evaluations"},
      {"monitor",
       "budget",
       T::number,
       "",
       false,
       "",
       notNegative,
       {},
       "what evaluating elements for the safe side may take, as a share of a step's own work, counted; when it is used "
       "up the proof stays and the bracket becomes wider; without it no limit"},
      {"monitor",
       "certificates",
       T::integer,
       "observations",
       false,
       "",
       atLeastOne,
       {},
       "write a proof of the bracket, from scratch, to certificates/ at every such observation, and before and at the "
       "first step that is proven unstable, for ringwatch-check; none without it"},
      {"monitor", "on_violation", T::text, "", false, "\"stop\"", anything, onViolationNames.names(),
       onViolationNames.listing()},
      {"monitor",
       "energy_tolerance",
       T::number,
       "",
       false,
       "0.1",
       positive,
       {},
       "energy balance error, as a share of the largest energy so far, that is reported; such a run is not called "
       "stable"},
      {"monitor",
       "require_certified",
       T::boolean,
       "",
       false,
       "false",
       anything,
       {},
       "a run fails (exit status 1) unless every step is certified; as --require-certified"},
      {"handler", "method", T::text, "", false, "\"none\"", anything, handlerNames(),
       "how elements that need a smaller step are treated", aliasesOf(handlerInfos())},
      {"handler", "selection", T::text, "", false, "\"certified\"", anything, selectionNames.names(),
       "which elements; " + selectionNames.listing(), aliasesOf(selectionNames)},
      {"handler",
       "margin",
       T::number,
       "",
       false,
       "0.1",
       share,
       {},
       "elements are chosen as for a step of step/(1 - margin), so that the explicit part may stiffen"},
  };
  keys.insert(keys.end(), rest.begin(), rest.end());
  for (SceneKey& key : keysOfOptions("handler", handlerInfos(), &HandlerInfo::options)) keys.push_back(std::move(key));
  for (const char* section : {"fix", "initial", "move", "force"}) {
    keys.push_back({section,
                    "where",
                    T::text,
                    "",
                    false,
                    "",
                    anything,
                    {},
                    "condition on the reference position, e.g. \"x < 1e-6 and y > 0.01\", \"all\", or \"set:NAME\""});
    keys.push_back(
        {section, "set", T::text, "", false, "", anything, {}, "named node set of the mesh, instead of where"});
  }
  for (const char* section : {"move", "force"}) {
    const std::string what = section == std::string("move") ? "velocity" : "load";
    keys.push_back({section,
                    "times",
                    T::numbers,
                    "s",
                    false,
                    "",
                    notNegative,
                    {},
                    "times of a table, increasing; before the first and after the last its factor stays. With "
                    "integrators of one force a step, without handler, cuts and GPU"});
    keys.push_back(
        {section, "factors", T::numbers, "", false, "", anything, {}, "of the " + what + ", at these times"});
    keys.push_back({section, "ramp", T::text, "", false, "\"linear\"", anything, rampNames.names(),
                    "between two times; " + rampNames.listing()});
  }
  const std::vector<SceneKey> last{
      {"initial", "velocity", T::vector, "m/s", false, "", anything, {}, "of the nodes"},
      {"initial",
       "angular_velocity",
       T::vector,
       "rad/s",
       false,
       "",
       anything,
       {},
       "rotation about an axis of this direction"},
      {"initial", "point", T::vector, "m", false, "[0.0, 0.0, 0.0]", anything, {}, "on the axis"},
      {"fix", "components", T::text, "", false, "\"xyz\"", anything, {}, "components that are held, any of x, y, z"},
      {"move", "velocity", T::vector, "m/s", true, "", anything, {}, "prescribed velocity"},
      {"move",
       "components",
       T::text,
       "",
       false,
       "\"xyz\"",
       anything,
       {},
       "components that are prescribed, any of x, y, z"},
      {"force",
       "acceleration",
       T::vector,
       "m/s2",
       false,
       "",
       anything,
       {},
       "force = mass x acceleration; or give force"},
      {"force", "force", T::vector, "N", false, "", anything, {}, "total force, spread over the nodes by mass"},
      {"cut", "time", T::number, "s", true, "", notNegative, {}, "it is made before the first step that begins then"},
      {"cut", "point", T::vector, "m", false, "", anything, {}, "of an endless plane; with normal"},
      {"cut", "normal", T::vector, "", false, "", anything, {}, "of the plane, of any length"},
      {"cut", "line", T::vectors, "m", false, "", anything, {}, "or two and more points, with sweep"},
      {"cut", "sweep", T::vector, "m", false, "", anything, {}, "how far the line is swept; the cut ends with it"},
      {"cut",
       "snap",
       T::number,
       "edge lengths",
       false,
       "0.1",
       SceneRange{0, 0.5, true, true},
       {},
       "nodes nearer than this are taken as on the surface, which saves slivers; 0 cuts exactly"},
      {"cut", "positions", T::text, "", false, "\"deformed\"", anything, cutPositionsNames.names(),
       "where the surface lies: in space at that time, or in the body at rest"},
      {"cut",
       "critical_step",
       T::boolean,
       "",
       false,
       "false",
       anything,
       {},
       "the summary also has that of the whole body before and after, which takes most of the time of a cut of a large "
       "mesh"},
      {"output",
       "every",
       T::number,
       "s",
       false,
       "",
       positive,
       {},
       "time between ParaView frames; no frames without it"},
      {"output", "fields", T::texts, "", false, "[\"critical_step\"]", anything, frameFieldNames(),
       "cell data of the frames: each element's step by a metric (critical_step stands for reduced-1-ring), by the "
       "monitor's metric with its margin, verdict, handled elements; displacement, velocity, sets and the frame's "
       "bracket are always there"},
      {"output",
       "checkpoint_every",
       T::number,
       "s",
       false,
       "",
       positive,
       {},
       "time between checkpoints, from the last of which `ringwatch run --resume DIR` goes on, bit by bit as the run "
       "would have; with explicit integrators of fixed order, without handler, cuts and GPU"},
      {"output", "history_every", T::integer, "steps", false, "1", atLeastOne, {}, "steps between rows of history.csv"},
      {"output",
       "energy",
       T::boolean,
       "",
       false,
       "true",
       anything,
       {},
       "energies in the history, and their balance watched"},
      {"output",
       "picture",
       T::boolean,
       "",
       false,
       "true",
       anything,
       {},
       "critical_step.png by gnuplot, when the critical step is monitored"},
  };
  keys.insert(keys.end(), last.begin(), last.end());
  return keys;
}

}  // namespace

std::string_view sceneTypeName(SceneType type) {
  static constexpr auto names = nameTable<SceneType>({
      {SceneType::number, "number"},
      {SceneType::integer, "integer"},
      {SceneType::boolean, "true or false"},
      {SceneType::text, "text"},
      {SceneType::texts, "list of texts"},
      {SceneType::numbers, "list of numbers"},
      {SceneType::vector, "list of three numbers"},
      {SceneType::vectors, "list of points, each a list of three numbers"},
      {SceneType::numberOrAuto, "number or \"auto\""},
      {SceneType::parameter, "parameter"},
  });
  return names.nameOf(type);
}

std::span<const SceneSection> sceneSections() { return sections; }

std::span<const SceneKey> sceneKeys() {
  static const std::vector<SceneKey> keys = makeKeys();
  return keys;
}

bool isKeyOfEveryHandler(std::string_view key) {
  return std::ranges::none_of(
      allHandlers(), [&](const HandlerEntry& handler) { return findOption(handler.info->options, key) != nullptr; });
}

bool isLawParameter(std::string_view key) {
  return std::ranges::any_of(allLaws(), [&](const LawInfo& law) { return findOption(law.parameters, key) != nullptr; });
}

std::string sceneHelp() {
  std::string text =
      "A scene is a TOML file.\n" + std::string(unitsText) + "\nKeys with their type, unit, range and default:\n";
  for (const SceneSection& section : sections) {
    text += fmt::format("\n{}  {}{}\n",
                        section.list       ? fmt::format("[[{}]]", section.name)
                        : section.alsoList ? fmt::format("[{0}] or [[{0}]]", section.name)
                                           : fmt::format("[{}]", section.name),
                        section.help, section.required ? " (required)" : "");
    for (const SceneKey& key : sceneKeys()) {
      if (key.section != section.name) continue;
      std::string line = fmt::format("  {:<17} {}", key.key, sceneTypeName(key.type));
      if (!key.unit.empty()) line += ", " + key.unit;
      if (!key.range.text().empty()) line += ", " + key.range.text();
      if (key.required) line += ", required";
      if (!key.fallback.empty()) line += ", default " + key.fallback;
      text += line + "\n" + fmt::format("  {:<17}   {}\n", "", key.help);
      if (!key.choices.empty()) text += fmt::format("  {:<17}   one of: {}\n", "", fmt::join(key.choices, ", "));
      for (const auto& [alias, meant] : key.aliases)
        text += fmt::format("  {:<17}   {} is another name of {}\n", "", alias, meant);
    }
  }
  return text + "\nMesh generators and their parameters in [mesh]:\n" + generatorHelp();
}

}  // namespace ringwatch
