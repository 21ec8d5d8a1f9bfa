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
#include <ringwatch/body/obstacle.h>
#include <ringwatch/handlers/handler.h>
#include <ringwatch/integrators/integrator.h>
#include <ringwatch/materials/registry.h>
#include <ringwatch/monitor/metrics/metrics.h>

namespace ringwatch {
namespace {

constexpr SceneRange positive{0, infinity, false, true};
constexpr SceneRange notNegative{0, infinity, true, true};
constexpr SceneRange edgeAngles{0, 180, false, false};  // degrees
constexpr SceneRange atLeastOne{1, infinity, true, true};
constexpr SceneRange share{0, 1, true, false};   // 0 <= s < 1
constexpr SceneRange factor{0, 1, false, true};  // 0 < s <= 1

constexpr std::array<SceneSection, 21> sections{{
    {"mesh", false, true, "a file or a generator with its parameters"},
    {"material", false, true,
     "one material for the whole body, or several [[material]], each for the elements that it selects", true},
    {"integrator", false, true, "how time advances"},
    {"damping", false, false,
     "of the whole body: Rayleigh damping, C = mass M + stiffness K(x), and bulk viscosity; its forces lag in the "
     "explicit schemes"},
    {"monitor", false, false, "what is watched, and what happens when the step is too large"},
    {"handler", false, false, "what is done about elements that need a smaller step"},
    {"fix", true, false, "nodes that stay; each [[fix]] adds to the others"},
    {"initial", true, false,
     "velocities at the start, where motion is not prescribed; each [[initial]] adds to the others"},
    {"move", true, false,
     "nodes that move at a constant velocity, or one that follows a table or an expression of time, and turn about an "
     "axis, or whose displacement follows one"},
    {"force", true, false, "dead loads, constant or following a table or an expression of time"},
    {"pressure", true, false,
     "pressure on the surface, which follows its normals; its load stiffness is outside the proof"},
    {"mass", true, false, "point masses: parts that are not meshed; each [[mass]] adds to the others"},
    {"mass_damping", true, false,
     "damping of nodes in proportion to their mass; each [[mass_damping]] adds to the others and to [damping]"},
    {"rigid", true, false,
     "nodes that move as a rigid body of their mass; elements within one are not deformed and set no step"},
    {"spring", true, false, "springs and dashpots, from nodes to the ground or to other nodes"},
    {"obstacle", true, false, "rigid bodies in closed form that nodes of a [[contact]] cannot enter, fixed or moving"},
    {"contact", true, false,
     "penalty contact of nodes with obstacles, or with the surface of other parts and of the body itself, with viscous "
     "damping and Coulomb friction; sliding friction is outside the proof"},
    {"cut", true, false,
     "cuts through a mesh of tetrahedra along a plane or a swept line; lips may pass through each other"},
    {"erosion", false, false,
     "elements that leave the run where a criterion holds; their mass stays at their nodes, their strain energy counts "
     "as dissipated"},
    {"probe", true, false, "numbers of some nodes or elements, each a few columns of probes.csv"},
    {"output", false, false, "what is written besides history.csv and summary.json"},
}};

constexpr std::array<SceneAlternative, 35> alternatives{{
    {"mesh", "file", "generate"},
    {"material", "where", "set", SceneAlternative::Need::oneOfMany},
    {"fix", "where", "set", SceneAlternative::Need::one, "rigid"},
    {"initial", "where", "set"},
    {"initial", "velocity", "angular_velocity", SceneAlternative::Need::any},
    {"move", "where", "set", SceneAlternative::Need::one, "rigid"},
    {"move", "velocity", "angular_velocity", SceneAlternative::Need::any, "displacement"},
    {"move", "displacement", "velocity", SceneAlternative::Need::atMostOne},
    {"move", "displacement", "angular_velocity", SceneAlternative::Need::atMostOne},
    {"move", "factor", "times", SceneAlternative::Need::atMostOne},
    {"force", "factor", "times", SceneAlternative::Need::atMostOne},
    {"pressure", "factor", "times", SceneAlternative::Need::atMostOne},
    {"obstacle", "factor", "times", SceneAlternative::Need::atMostOne},
    {"force", "where", "set"},
    {"force", "acceleration", "force", SceneAlternative::Need::one, "each"},
    {"pressure", "where", "set"},
    {"mass", "where", "set"},
    {"mass", "mass", "nodal_mass"},
    {"handler", "step", "factor", SceneAlternative::Need::atMostOne},
    {"mass_damping", "where", "set"},
    {"rigid", "where", "set"},
    {"spring", "where", "set"},
    {"spring", "to_where", "to_set", SceneAlternative::Need::atMostOne},
    {"spring", "edges", "to_where", SceneAlternative::Need::atMostOne},
    {"spring", "edges", "to_set", SceneAlternative::Need::atMostOne},
    {"spring", "edges", "direction", SceneAlternative::Need::atMostOne},
    {"contact", "where", "set", SceneAlternative::Need::atMostOne},
    {"contact", "to_where", "to_set", SceneAlternative::Need::atMostOne},
    {"cut", "point", "line"},
    {"probe", "where", "set", SceneAlternative::Need::atMostOne},
    {"probe", "where", "material", SceneAlternative::Need::atMostOne},
    {"probe", "set", "material", SceneAlternative::Need::atMostOne},
    {"probe", "where", "rigid", SceneAlternative::Need::atMostOne},
    {"probe", "set", "rigid", SceneAlternative::Need::atMostOne},
    {"probe", "material", "rigid", SceneAlternative::Need::atMostOne},
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

SceneType sceneTypeOf(const OptionInfo& option) {
  if (option.type == OptionType::text) return SceneType::text;
  if (option.automatic) return SceneType::numberOrAuto;
  return option.type == OptionType::integer ? SceneType::integer : SceneType::number;
}

/// A declared option as a key of the scene, without help.
SceneKey keyOf(const OptionInfo& option) {
  const bool text = option.type == OptionType::text || option.automatic;
  SceneKey key{.key = std::string(option.name),
               .type = sceneTypeOf(option),
               .unit = std::string(option.unit),
               .fallback = option.fallback.empty() || !text ? std::string(option.fallback)
                                                            : fmt::format("\"{}\"", option.fallback),
               .range = option.range};
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
std::vector<SceneKey> keysOfOptions(const Infos& infos, Member options) {
  std::vector<SceneKey> keys;
  for (const auto& info : infos)
    for (const OptionInfo& option : info.*options) {
      if (std::ranges::find(keys, option.name, &SceneKey::key) != keys.end()) continue;
      SceneKey& key = keys.emplace_back(keyOf(option));
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

using T = SceneType;

/// Keys of one section, which their entries leave out.
void add(std::vector<SceneKey>& all, std::string_view section, std::vector<SceneKey> keys) {
  for (SceneKey& key : keys) {
    key.section = section;
    all.push_back(std::move(key));
  }
}

void addMesh(std::vector<SceneKey>& all) {
  add(all, "mesh",
      {
          {.key = "file", .type = T::text, .help = "mesh file, relative to the scene; or give generate"},
          {.key = "generate",
           .type = T::text,
           .choices = generatorNames(),
           .help = "kind of generated mesh, instead of file"},
      });
  add(all, "mesh", generatorSceneKeys());
}

void addMaterial(std::vector<SceneKey>& all) {
  add(all, "material",
      {
          {.key = "model",
           .type = T::text,
           .required = true,
           .choices = namesOf(allLaws()),
           .help = "constitutive law; help laws lists its parameters"},
      });
  add(all, "material", keysOfOptions(allLaws(), &LawInfo::parameters));
  add(all, "material",
      {
          {.key = "where",
           .type = T::text,
           .help = "elements that have it, by a condition on the centre of their nodes at rest, e.g. \"x < 0.1\"; each "
                   "element has one material"},
          {.key = "set", .type = T::text, .help = "named element set of the mesh, instead of where"},
          {.key = "density",
           .type = T::number,
           .unit = "kg/m3",
           .required = true,
           .range = positive,
           .help = "density at rest"},
          {.key = "mass_damping",
           .type = T::number,
           .unit = "1/s",
           .fallback = "0.0",
           .range = notNegative,
           .help = "force per mass and velocity, as ALPHA of *DAMPING in Abaqus"},
          {.key = "stiffness_damping",
           .type = T::number,
           .unit = "s",
           .fallback = "0.0",
           .range = notNegative,
           .help = "viscous stress, this time times the stiffness at rest times the rate of Green's strain, as BETA of "
                   "*DAMPING in Abaqus; laws with young and poisson"},
          {.key = "shear_viscosity",
           .type = T::number,
           .unit = "Pa s",
           .fallback = "0.0",
           .range = notNegative,
           .help = "Kelvin-Voigt: stress 2 x this x the rate of Green's strain without its volumetric part"},
          {.key = "volume_viscosity",
           .type = T::number,
           .unit = "Pa s",
           .fallback = "0.0",
           .range = notNegative,
           .help = "Kelvin-Voigt: stress this x the trace of the rate of Green's strain"},
          {.key = "hourglass_viscosity",
           .type = T::number,
           .fallback = "0.0",
           .range = notNegative,
           .help = "of hex8=uniform-strain: viscous hourglass control, usually 0.05 to 0.15"},
          {.key = "hourglass_stiffness",
           .type = T::number,
           .fallback = "0.05",
           .range = notNegative,
           .help =
               "of hex8=uniform-strain, of the whole body: stiffness of hourglass modes over that of pressure waves"},
          {.key = "lumping",
           .type = T::text,
           .fallback = "\"row-sum\"",
           .choices = lumpingNames.names(),
           .help = "how an element's mass goes to its nodes, of the whole body; " + lumpingNames.listing()},
          {.key = "rules",
           .type = T::texts,
           .help = "quadrature rules of elements, of the whole body, e.g. [\"hex8=gauss-2x2x2\"]; `ringwatch verify "
                   "elements` compares them"},
      });
}

void addIntegrator(std::vector<SceneKey>& all) {
  add(all, "integrator",
      {
          {.key = "method",
           .type = T::text,
           .fallback = "\"symplectic-euler\"",
           .choices = namesOf(integratorInfos()),
           .help = "scheme"},
          {.key = "step",
           .type = T::numberOrAuto,
           .unit = "s",
           .required = true,
           .range = positive,
           .help = "step; \"auto\" follows the safe step whenever the monitor evaluates it"},
          {.key = "hold",
           .type = T::boolean,
           .fallback = "false",
           .help = "with step = \"auto\": keep the step of the first state, and judge it as one that is given"},
          {.key = "end",
           .type = T::number,
           .unit = "s",
           .required = true,
           .range = positive,
           .help = "time at which the run ends; with a fixed step, its first multiple from there on"},
          {.key = "device",
           .type = T::text,
           .fallback = "\"cpu\"",
           .choices = runDeviceNames.names(),
           .help = "where the steps are taken; \"auto\" takes a GPU if there is one; the state comes back at every "
                   "observation of the monitor and every row of the "
                   "history"},
          {.key = "devices",
           .type = T::numbers,
           .fallback = "[0]",
           .range = notNegative,
           .help =
               "GPUs that share the steps, by CUDA's numbers; [] takes all of the machine. The results are those of "
               "one, to the last bit"},
          {.key = "safety",
           .type = T::number,
           .fallback = "0.95",
           .range = factor,
           .help = "share of the safe step that \"auto\" and on_violation = \"reduce-step\" or \"repeat\" take"},
      });
}

void addDamping(std::vector<SceneKey>& all) {
  add(all, "damping",
      {
          {.key = "mass",
           .type = T::number,
           .unit = "1/s",
           .fallback = "0.0",
           .range = notNegative,
           .help = "mass-proportional part, takes slow motion"},
          {.key = "stiffness",
           .type = T::number,
           .unit = "s",
           .fallback = "0.0",
           .range = notNegative,
           .help = "stiffness-proportional part, takes fast vibrations; it shortens the critical step"},
          {.key = "bulk_viscosity",
           .type = T::boolean,
           .fallback = "false",
           .help = "a viscous pressure in every element, as Abaqus/Explicit has it unless told otherwise"},
          {.key = "linear_bulk_viscosity",
           .type = T::number,
           .fallback = "0.06",
           .range = notNegative,
           .help = "b1: pressure -b1 x density x wave speed at rest x L x rate of volume, L the cube root of an "
                   "element's volume at rest; takes the ringing of single elements"},
          {.key = "quadratic_bulk_viscosity",
           .type = T::number,
           .fallback = "1.2",
           .range = notNegative,
           .help =
               "b2: pressure density x (b2 x L x rate of volume)^2 under compression; spreads shocks over elements"},
      });
}

void addMonitor(std::vector<SceneKey>& all) {
  add(all, "monitor",
      {
          {.key = "bracket",
           .type = T::boolean,
           .fallback = "true",
           .help = "keep the proven bracket safe <= critical step <= optimistic; false is mode = \"metric\""},
          {.key = "mode",
           .type = T::text,
           .fallback = "\"bracket\"",
           .choices = monitorModeNames.names(),
           .aliases = aliasesOf(monitorModeNames),
           .help = monitorModeNames.listing()},
          {.key = "metric",
           .type = T::text,
           .fallback = "\"none\"",
           .choices = metricNames(),
           .help = "also keep an estimate by this metric"},
          {.key = "margin",
           .type = T::number,
           .fallback = "0.1",
           .range = share,
           .help = "taken off the step by metric"},
          {.key = "every",
           .type = T::integer,
           .unit = "steps",
           .fallback = "1",
           .range = atLeastOne,
           .help = "steps between evaluations"},
          {.key = "budget",
           .type = T::number,
           .range = notNegative,
           .help =
               "what the bracket may take after its first observation, as a share of a step's own work, counted; "
               "when it is used up the proof stays and the bracket becomes wider; more is taken only by evaluations of "
               "elements that a raise of the bound does not replace or at a higher cost, and in small bodies, up to "
               "six steps' work, for telling whether a step without a proof is proven unstable; from 100 on there is "
               "no limit; without the key it is 0.1, and small bodies have no limit before some 0.2 s are taken"},
          {.key = "certificates",
           .type = T::integer,
           .unit = "observations",
           .range = atLeastOne,
           .help = "write a proof of the bracket, from scratch, to certificates/ at every such observation, and before "
                   "and at the first step that is proven unstable, for ringwatch-check; none without it"},
          {.key = "on_violation",
           .type = T::text,
           .fallback = "\"stop\"",
           .choices = onViolationNames.names(),
           .help = onViolationNames.listing()},
          {.key = "repeats",
           .type = T::integer,
           .fallback = "10",
           .range = atLeastOne,
           .help = "on_violation = \"repeat\": how often a run goes back to one state before it ends"},
          {.key = "energy_tolerance",
           .type = T::number,
           .fallback = "0.1",
           .range = positive,
           .help = "energy balance error, as a share of the largest energy so far, that is reported; such a run is not "
                   "called stable"},
          {.key = "require_certified",
           .type = T::boolean,
           .fallback = "false",
           .help = "a run fails (exit status 1) unless every step is certified, which takes every = 1; as "
                   "--require-certified"},
      });
}

void addHandler(std::vector<SceneKey>& all) {
  add(all, "handler",
      {
          {.key = "method",
           .type = T::text,
           .fallback = "\"none\"",
           .choices = handlerNames(),
           .aliases = aliasesOf(handlerInfos()),
           .help = "how elements that need a smaller step are treated"},
          {.key = "selection",
           .type = T::text,
           .fallback = "\"certified\"",
           .choices = selectionNames.names(),
           .aliases = aliasesOf(selectionNames),
           .help = "which elements; " + selectionNames.listing()},
          {.key = "margin",
           .type = T::number,
           .range = share,
           .help = "elements are chosen as for a step of step/(1 - margin), so that the explicit part may stiffen; "
                   "without, 0.1, 0.15 for mass-scaling, and 0.3 for local-time-stepping with stvk"},
          {.key = "step",
           .type = T::number,
           .unit = "s",
           .range = positive,
           .help = "with integrator.step = \"auto\": the step that elements are chosen for, and that is not passed"},
          {.key = "factor",
           .type = T::number,
           .fallback = "2.0",
           .range = positive,
           .help =
               "with integrator.step = \"auto\": this times the safe step of the whole body at the start, in place of "
               "step"},
      });
  add(all, "handler", keysOfOptions(handlerInfos(), &HandlerInfo::options));
}

/// Which nodes: of every section that is about some.
void addNodes(std::vector<SceneKey>& all, std::string_view section) {
  add(all, section,
      {
          {.key = "where",
           .type = T::text,
           .help = "condition on the reference position, e.g. \"x < 1e-6 and y > 0.01\", \"all\", or \"set:NAME\""},
          {.key = "set",
           .type = T::text,
           .help = "named node set of the mesh, instead of where; \"#3,7\" are the nodes with these numbers in the "
                   "mesh file"},
      });
}

/// How a [[rigid]] is held or moved.
void addGuide(std::vector<SceneKey>& all, std::string_view section) {
  add(all, section,
      {
          {.key = "rigid",
           .type = T::text,
           .help = "name of a [[rigid]], instead of where: its centre of mass and its turning"},
          {.key = "turns",
           .type = T::boolean,
           .fallback = "false",
           .help = "with rigid: the body turns freely; without, its turning is held or follows angular_velocity"},
          {.key = "axis", .type = T::vector, .help = "with turns: it turns about an axis of this direction alone"},
      });
}

/// what: that the table scales.
void addTable(std::vector<SceneKey>& all, std::string_view section, std::string_view what) {
  add(all, section,
      {
          {.key = "factor",
           .type = T::text,
           .help =
               fmt::format("of the {}, an expression of the time t, s, instead of a table, e.g. "
                           "\"sin(2*pi*50*t)\": numbers, t, pi, + - * / ^, sqrt, abs, min, max, sin, cos, tan, exp, "
                           "log, tanh",
                           what)},
          {.key = "times",
           .type = T::numbers,
           .unit = "s",
           .range = notNegative,
           .help = "times of a table, increasing; before the first and after the last its factor stays"},
          {.key = "factors", .type = T::numbers, .help = fmt::format("of the {}, at these times", what)},
          {.key = "ramp",
           .type = T::text,
           .fallback = "\"linear\"",
           .choices = rampNames.names(),
           .help = "between two times; " + rampNames.listing()},
      });
}

void addMotionAndLoads(std::vector<SceneKey>& all) {
  addNodes(all, "fix");
  addGuide(all, "fix");
  add(all, "fix",
      {
          {.key = "components",
           .type = T::text,
           .fallback = "\"xyz\"",
           .help = "components that are held, any of x, y, z"},
          {.key = "point",
           .type = T::vector,
           .unit = "m",
           .help = "with rigid and turns: the point that is held, with all components; without, the centre of mass"},
      });
  addNodes(all, "initial");
  add(all, "initial",
      {
          {.key = "velocity", .type = T::vector, .unit = "m/s", .help = "of the nodes"},
          {.key = "angular_velocity",
           .type = T::vector,
           .unit = "rad/s",
           .help = "rotation about an axis of this direction"},
          {.key = "point", .type = T::vector, .unit = "m", .fallback = "[0.0, 0.0, 0.0]", .help = "on the axis"},
      });
  addNodes(all, "move");
  addGuide(all, "move");
  addTable(all, "move", "velocity or displacement");
  add(all, "move",
      {
          {.key = "velocity",
           .type = T::vector,
           .unit = "m/s",
           .help = "prescribed velocity; or give angular_velocity, or both, or displacement"},
          {.key = "displacement",
           .type = T::vector,
           .unit = "m",
           .help = "from where the nodes are at rest, times factor or table, which begins at 0; exact at the ends of "
                   "steps"},
          {.key = "angular_velocity",
           .type = T::vector,
           .unit = "rad/s",
           .help = "rotation about an axis of this direction that stays, exact at the ends of steps; the table is its "
                   "factor too"},
          {.key = "point", .type = T::vector, .unit = "m", .fallback = "[0.0, 0.0, 0.0]", .help = "on the axis"},
          {.key = "components",
           .type = T::text,
           .fallback = "\"xyz\"",
           .help = "components that are prescribed, any of x, y, z"},
      });
  addNodes(all, "force");
  addTable(all, "force", "load");
  add(all, "force",
      {
          {.key = "acceleration",
           .type = T::vector,
           .unit = "m/s2",
           .help = "force = mass x acceleration; or give force or each"},
          {.key = "force", .type = T::vector, .unit = "N", .help = "total force, spread over the nodes by mass"},
          {.key = "each", .type = T::vector, .unit = "N", .help = "force on each of the nodes"},
      });
  addNodes(all, "pressure");
  addTable(all, "pressure", "pressure");
  add(all, "pressure",
      {{.key = "pressure",
        .type = T::number,
        .unit = "Pa",
        .required = true,
        .help = "on the faces all of whose corners are selected, inwards where > 0"}});
}

void addDiscrete(std::vector<SceneKey>& all) {
  addNodes(all, "mass");
  add(all, "mass",
      {{.key = "mass",
        .type = T::number,
        .unit = "kg",
        .range = positive,
        .help = "of all the nodes together, which share it equally"},
       {.key = "nodal_mass",
        .type = T::number,
        .unit = "kg",
        .range = positive,
        .help = "instead of mass: what each node has in all, its elements' share and masses above included; at least "
                "those"}});
  addNodes(all, "mass_damping");
  add(all, "mass_damping",
      {{.key = "rate",
        .type = T::number,
        .unit = "1/s",
        .required = true,
        .range = notNegative,
        .help = "force = -rate x mass x velocity, of each node"}});
  addNodes(all, "rigid");
  add(all, "rigid",
      {{.key = "name", .type = T::text, .help = "for [[probe]]; without, \"rigid N\", N counted from 0"}});
  addNodes(all, "spring");
  add(all, "spring",
      {
          {.key = "to_where",
           .type = T::text,
           .help = "the other ends: each node's spring leads to the nearest of these; without, to the ground"},
          {.key = "to_set", .type = T::text, .help = "named node set of the mesh, instead of to_where"},
          {.key = "edges",
           .type = T::boolean,
           .fallback = "false",
           .help = "one along each edge of the elements both of whose ends are selected, instead of one at each node"},
          {.key = "stiffness",
           .type = T::number,
           .unit = "N/m",
           .required = true,
           .range = notNegative,
           .help = "of each spring"},
          {.key = "damping",
           .type = T::number,
           .unit = "N s/m",
           .fallback = "0.0",
           .range = notNegative,
           .help = "of the dashpot beside it"},
          {.key = "direction",
           .type = T::vector,
           .help = "in which alone a spring to the ground acts; without, it acts in all"},
          {.key = "length",
           .type = T::number,
           .unit = "m",
           .range = notNegative,
           .help = "at rest, between two nodes; without, their distance at the start"},
      });
  std::vector<std::string> kinds;
  std::string listing;
  for (const ObstacleKind& kind : allObstacleKinds()) {
    kinds.emplace_back(kind.name);
    listing += fmt::format("{}{}: {}", listing.empty() ? "" : "; ", kind.name, kind.help);
  }
  add(all, "obstacle",
      {
          {.key = "kind", .type = T::text, .required = true, .choices = kinds, .help = listing},
          {.key = "name", .type = T::text, .help = "for [[contact]]; without, \"obstacle N\", N counted from 0"},
          {.key = "point",
           .type = T::vector,
           .unit = "m",
           .fallback = "[0.0, 0.0, 0.0]",
           .help = "on the plane, on the cylinder's axis at half its length, or the centre"},
          {.key = "normal", .type = T::vector, .help = "of a plane, out of the obstacle"},
          {.key = "axis", .type = T::vector, .help = "direction of a cylinder"},
          {.key = "radius", .type = T::number, .unit = "m", .range = positive, .help = "of a sphere or cylinder"},
          {.key = "length", .type = T::number, .unit = "m", .range = positive, .help = "of a cylinder with flat ends"},
          {.key = "size", .type = T::vector, .unit = "m", .range = positive, .help = "edge lengths of a box"},
          {.key = "hollow", .type = T::boolean, .fallback = "false", .help = "the body is inside a sphere or cylinder"},
          {.key = "velocity",
           .type = T::vector,
           .unit = "m/s",
           .fallback = "[0.0, 0.0, 0.0]",
           .help = "at which it moves from the start"},
      });
  addTable(all, "obstacle", "velocity");
  addNodes(all, "contact");
  add(all, "contact",
      {
          {.key = "with",
           .type = T::text,
           .fallback = "\"obstacles\"",
           .choices = {"obstacles", "surface"},
           .help =
               "what the nodes touch: the [[obstacle]]s, or the surface of the mesh, that of other parts and of their "
               "own"},
          {.key = "obstacle", .type = T::text, .help = "name of the obstacle; without, all of them"},
          {.key = "to_where",
           .type = T::text,
           .help = "nodes of the surface that is touched, with = \"surface\": its faces all of whose corners are "
                   "selected; without, the whole surface"},
          {.key = "to_set", .type = T::text, .help = "named node set of the mesh, instead of to_where"},
          {.key = "edges",
           .type = T::boolean,
           .fallback = "false",
           .help = "with = \"surface\": edges touch edges, too, so that sharp parts and coarse surfaces do not pass "
                   "between nodes"},
          {.key = "edge_angle",
           .type = T::number,
           .unit = "degrees",
           .fallback = "20.0",
           .range = edgeAngles,
           .help = "with edges: of those at which the surface turns outwards by more than this at rest"},
          {.key = "penalty",
           .type = T::numberOrAuto,
           .unit = "N/m",
           .fallback = "\"auto\"",
           .range = positive,
           .help = "stiffness at each node; \"auto\": so soft that a node alone stays in contact for 20 steps, and "
                   "that the step "
                   "has room for it beside the elements at rest"},
          {.key = "step",
           .type = T::number,
           .unit = "s",
           .range = positive,
           .help = "that penalty = \"auto\" is made for; without, integrator.step, and where that is \"auto\" the safe "
                   "step of the elements at rest alone"},
          {.key = "damping",
           .type = T::number,
           .fallback = "0.0",
           .range = notNegative,
           .help = "share of the critical damping of a node on its penalty"},
          {.key = "friction",
           .type = T::number,
           .fallback = "0.0",
           .range = notNegative,
           .help = "Coulomb's coefficient"},
          {.key = "slip",
           .type = T::numberOrAuto,
           .unit = "m/s",
           .fallback = "\"auto\"",
           .range = positive,
           .help =
               "speed below that friction is viscous, so that surfaces that stick creep; \"auto\": in proportion to "
               "the depth, so that a node that sticks has a tenth of the critical damping on its penalty at most"},
      });
}

void addCut(std::vector<SceneKey>& all) {
  add(all, "cut",
      {
          {.key = "time",
           .type = T::number,
           .unit = "s",
           .required = true,
           .range = notNegative,
           .help = "it is made before the first step that begins then"},
          {.key = "point", .type = T::vector, .unit = "m", .help = "of an endless plane; with normal"},
          {.key = "normal", .type = T::vector, .help = "of the plane, of any length"},
          {.key = "line", .type = T::vectors, .unit = "m", .help = "or two and more points, with sweep"},
          {.key = "sweep", .type = T::vector, .unit = "m", .help = "how far the line is swept; the cut ends with it"},
          {.key = "snap",
           .type = T::number,
           .unit = "edge lengths",
           .fallback = "0.1",
           .range = SceneRange{0, 0.5, true, true},
           .help = "nodes nearer than this are taken as on the surface, which saves slivers; 0 cuts exactly"},
          {.key = "positions",
           .type = T::text,
           .fallback = "\"deformed\"",
           .choices = cutPositionsNames.names(),
           .help = "where the surface lies: in space at that time, or in the body at rest"},
          {.key = "critical_step",
           .type = T::boolean,
           .fallback = "false",
           .help = "the summary also has that of the whole body before and after, which takes most of the time of a "
                   "cut of a large mesh"},
      });
}

void addErosion(std::vector<SceneKey>& all) {
  add(all, "erosion",
      {
          {.key = "inverted",
           .type = T::boolean,
           .fallback = "false",
           .help = "elements whose deformation gradient has no positive determinant at a quadrature point leave"},
          {.key = "max_stretch",
           .type = T::number,
           .range = SceneRange{1, infinity, false, true},
           .help = "elements whose largest principal stretch is above leave"},
          {.key = "max_von_mises",
           .type = T::number,
           .unit = "Pa",
           .range = positive,
           .help = "elements leave the von Mises stress of whose mean Cauchy stress is above"},
          {.key = "max_principal_stress",
           .type = T::number,
           .unit = "Pa",
           .range = positive,
           .help = "elements leave the largest principal value of whose mean Cauchy stress is above"},
          {.key = "least_step",
           .type = T::number,
           .unit = "s",
           .range = positive,
           .help = "elements leave whose own critical step, with the mass that they give to their nodes, is below"},
          {.key = "every",
           .type = T::integer,
           .unit = "steps",
           .fallback = "1",
           .range = atLeastOne,
           .help = "steps between looks"},
      });
}

void addProbe(std::vector<SceneKey>& all) {
  std::string what;
  for (const ProbeQuantity& quantity : allProbeQuantities())
    what += fmt::format("{}{}{}: {}", what.empty() ? "" : "; ", quantity.name,
                        quantity.unit.empty() ? "" : fmt::format(", {}", quantity.unit), quantity.help);
  add(all, "probe",
      {
          {.key = "what", .type = T::text, .required = true, .choices = namesOf(allProbeQuantities()), .help = what},
          {.key = "name",
           .type = T::text,
           .help = "with which its columns begin, of letters, digits, _ and -; without, \"probe.N\", N counted from 0"},
          {.key = "where",
           .type = T::text,
           .help = "condition on the reference position of nodes, or of the centre of an element's nodes, or "
                   "\"set:NAME\"; without any selection all of them"},
          {.key = "set", .type = T::text, .help = "named set of nodes or of elements, instead of where"},
          {.key = "material",
           .type = T::integer,
           .range = notNegative,
           .help = "the elements of the material with this number, counted from 0, instead of where"},
          {.key = "rigid",
           .type = T::text,
           .help = "name of the [[rigid]] of centre, rotation, centre_velocity, angular_velocity, force, torque, "
                   "support_force and support_torque; "
                   "without, the only one"},
          {.key = "as",
           .type = T::text,
           .choices = probeReductionNames.names(),
           .help = probeReductionNames.listing() + "; without, the sum of momentum, angular_momentum, load, reaction "
                                                   "and energy, the least step, else the mean"},
          {.key = "metric",
           .type = T::text,
           .fallback = "\"reduced-1-ring\"",
           .choices = namesOf(allMetrics()),
           .help = "of what = \"step\"; it is evaluated for the whole body at every row"},
      });
}

void addOutput(std::vector<SceneKey>& all) {
  add(all, "output",
      {
          {.key = "every",
           .type = T::number,
           .unit = "s",
           .range = positive,
           .help = "time between ParaView frames; no frames without it"},
          {.key = "exact_times",
           .type = T::boolean,
           .fallback = "false",
           .help = "frames at the very multiples of every, also between steps; without, at the first step that reaches "
                   "one"},
          {.key = "fields",
           .type = T::texts,
           .fallback = "[\"critical_step\"]",
           .choices = frameFieldNames(),
           .help = "cell data of the frames: each element's step by a metric (critical_step stands for "
                   "reduced-1-ring), by the monitor's metric with its margin, verdict, handled elements, and of the "
                   "element's mean Cauchy stress von_mises, pressure (positive where it is pressed together), "
                   "max_principal_stress, principal_stresses and the tensor cauchy_stress, Pa; max_stretch, its "
                   "largest principal stretch, and its mean Green strain green_strain and principal_strains; tensors "
                   "are xx, yy, zz, xy, yz, xz; displacement, velocity, sets and the frame's bracket are always "
                   "there"},
          {.key = "checkpoint_every",
           .type = T::number,
           .unit = "s",
           .range = positive,
           .help = "time between checkpoints, from the last of which `ringwatch run --resume DIR` goes on, bit by bit "
                   "as the run would have. A "
                   "signal that stops such a run leaves one too"},
          {.key = "history_every",
           .type = T::integer,
           .unit = "steps",
           .fallback = "1",
           .range = atLeastOne,
           .help = "steps between rows of history.csv"},
          {.key = "probe_every",
           .type = T::integer,
           .unit = "steps",
           .fallback = "1",
           .range = atLeastOne,
           .help = "steps between rows of probes.csv"},
          {.key = "reactions",
           .type = T::boolean,
           .fallback = "false",
           .help = "the reaction forces of each [[fix]] and [[move]], N, in probes.csv; a component that several hold "
                   "counts for the first of them"},
          {.key = "energy",
           .type = T::boolean,
           .fallback = "true",
           .help = "energies in the history, and their balance watched"},
          {.key = "picture",
           .type = T::boolean,
           .fallback = "true",
           .help = "critical_step.png by gnuplot, when the critical step is monitored"},
      });
}

std::vector<SceneKey> makeKeys() {
  std::vector<SceneKey> all;
  for (const auto addSection : {addMesh, addMaterial, addIntegrator, addDamping, addMonitor, addHandler,
                                addMotionAndLoads, addDiscrete, addCut, addErosion, addProbe, addOutput})
    addSection(all);
  return all;
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
std::span<const SceneAlternative> sceneAlternatives() { return alternatives; }

std::span<const SceneKey> sceneKeys() {
  static const std::vector<SceneKey> keys = makeKeys();
  return keys;
}

std::vector<HandlerInfo> handlerInfos() {
  std::vector<HandlerInfo> infos;
  for (const HandlerEntry& entry : allHandlers()) infos.push_back(*entry.info);
  return infos;
}

bool isKeyOfEveryHandler(std::string_view key) {
  return std::ranges::none_of(
      allHandlers(), [&](const HandlerEntry& handler) { return findOption(handler.info->options, key) != nullptr; });
}

bool isLawParameter(std::string_view key) {
  return std::ranges::any_of(allLaws(), [&](const LawInfo& law) { return findOption(law.parameters, key) != nullptr; });
}

namespace {

std::string headOf(const SceneSection& section) {
  return section.list       ? fmt::format("[[{}]]", section.name)
         : section.alsoList ? fmt::format("[{0}] or [[{0}]]", section.name)
                            : fmt::format("[{}]", section.name);
}

std::string helpOf(const SceneSection& section) {
  std::string text = fmt::format("\n{}  {}{}\n", headOf(section), section.help, section.required ? " (required)" : "");
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
  return text;
}

constexpr std::string_view sceneIntroduction = "A scene is a TOML file.\n";
constexpr std::string_view keysIntroduction = "\nKeys with their type, unit, range and default:\n";

}  // namespace

std::string sceneHelp() {
  std::string text = std::string(sceneIntroduction) + std::string(unitsText) + std::string(keysIntroduction);
  for (const SceneSection& section : sections) text += helpOf(section);
  return text + "\nMesh generators and their parameters in [mesh]:\n" + generatorHelp();
}

std::string sceneHelp(std::string_view name) {
  const auto* section = std::ranges::find(sections, name, &SceneSection::name);
  if (section == sections.end()) return {};
  return std::string(unitsText) + std::string(keysIntroduction) + helpOf(*section);
}

std::string sceneOverview() {
  std::string text = std::string(sceneIntroduction) + std::string(unitsText) + "\nIts sections:\n\n";
  for (const SceneSection& section : sections)
    text += fmt::format("  {:<26} {}{}\n", headOf(section), section.help, section.required ? " (required)" : "");
  return text +
         "\nringwatch help scene SECTION lists the keys of one, such as ringwatch help scene contact; ringwatch run "
         "--help-scene lists all. ringwatch help together says what does not go together.\n";
}

}  // namespace ringwatch
