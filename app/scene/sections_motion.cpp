#include <algorithm>
#include <cmath>

#include <ringwatch/app/scene/key_binding.h>
#include <ringwatch/app/scene/scene_rigid.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/user_text.h>

namespace ringwatch {
namespace {

using F = Feature;
using Need = SceneAlternative::Need;

/// Which components a section holds or prescribes.
template <class Item>
BoundKey<Item> componentsKey(const std::string& what) {
  return {{.key = "components",
           .type = SceneType::text,
           .fallback = "\"xyz\"",
           .help = fmt::format("components that are {}, any of x, y, z", what)},
          [](const SceneTable& table, Item& item) {
            const auto text = table.get<std::string>("components");
            const auto components = parseComponents(text);
            if (!components)
              fail(table.at("components").origin, table.name + ".components",
                   inQuotes(text) + " names no components; must be some of x, y, z, each once");
            item.components = *components;
          }};
}

/// How a [[rigid]] is held or moved; takeRigidBody() reads it.
template <class Item>
BoundKeys<Item> guideKeys() {
  return unbound<Item>({
      {.key = "rigid",
       .type = SceneType::text,
       .help = "name of a [[rigid]], instead of where: its centre of mass and its turning"},
      {.key = "turns",
       .type = SceneType::boolean,
       .fallback = "false",
       .help = "with rigid: the body turns freely; without, its turning is held or follows angular_velocity"},
      {.key = "axis", .type = SceneType::vector, .help = "with turns: it turns about an axis of this direction alone"},
  });
}

void checkInitial(const SceneTable& table, Scene&, Scene::Initial&) {
  if (table.given("point") && !table.given("angular_velocity"))
    fail(table.at("point").origin, "initial.point", "there is no angular_velocity for it");
}

void checkMove(const SceneTable& table, Scene& scene, Scene::Move& move) {
  takeRigidBody(table, scene, move);
  move.table = tableOf(table, scene);
  if (!move.guide && table.given("point") && !table.given("angular_velocity"))
    fail(table.at("point").origin, "move.point", "there is no angular_velocity for it");
  if (!move.way) return;
  const auto refuse = [&](const std::string& what) {
    fail(table.at("displacement").origin, "move.displacement", what);
  };
  if (!move.table) refuse("it needs a factor that begins at 0; give factor, or times and factors");
  if (move.table->jumps())
    fail(table.at("ramp").origin, "move.ramp",
         "\"hold\" would make a displacement jump; must be linear, smooth or quintic");
  if (const double start = move.table->at(0); start != 0)
    refuse(fmt::format("its factor is {} at t = 0, where nodes are at rest; it must be 0 there", start));
  if (!std::isfinite(move.table->slope(0))) refuse("its factor begins with no finite velocity at t = 0");
}

template <class Item>
void takeTable(const SceneTable& table, Scene& scene, Item& item) {
  item.table = tableOf(table, scene);
}

void checkRigid(const SceneTable& table, Scene& scene, Scene::Rigid& rigid) {
  requireOwnName(table, scene.rigids, rigid);
}

}  // namespace

std::vector<SceneKey> timeTableKeys(std::string_view what) {
  return {{.key = "factor",
           .type = SceneType::text,
           .features = {F::timed},
           .help = fmt::format("of the {}, an expression of the time t, s, instead of a table, e.g. "
                               "\"sin(2*pi*50*t)\": numbers, t, pi, + - * / ^, sqrt, abs, min, max, sin, cos, tan, "
                               "exp, log, tanh",
                               what)},
          {.key = "times",
           .type = SceneType::numbers,
           .unit = "s",
           .range = KeyRange::notNegative,
           .features = {F::timed},
           .help = "times of a table, increasing; before the first and after the last its factor stays"},
          {.key = "factors", .type = SceneType::numbers, .help = fmt::format("of the {}, at these times", what)},
          {.key = "ramp",
           .type = SceneType::text,
           .fallback = "\"linear\"",
           .choices = rampNames.names(),
           .help = "between two times; " + rampNames.listing()}};
}

std::optional<TimeTable> tableOf(const SceneTable& section, const Scene& scene) {
  if (section.given("factor")) {
    for (const char* key : {"factors", "ramp"})
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

SceneSection fixSection() {
  return listSection<Scene::Fix>(
      {.name = "fix",
       .help = "nodes that stay; each [[fix]] adds to the others",
       .alternatives = {{"where", "set", Need::one, "rigid"}}},
      &Scene::fixes,
      {nodeKeys(&Scene::Fix::nodes),
       guideKeys<Scene::Fix>(),
       {componentsKey<Scene::Fix>("held"),
        {{.key = "point",
          .type = SceneType::vector,
          .unit = "m",
          .help = "with rigid and turns: the point that is held, with all components; without, the centre of mass"}}}},
      takeRigidBody<Scene::Fix>);
}

SceneSection initialSection() {
  using I = Scene::Initial;
  return listSection<I>(
      {.name = "initial",
       .help = "velocities at the start, where motion is not prescribed; each [[initial]] adds to the others",
       .alternatives = {{"where", "set"}, {"velocity", "angular_velocity", Need::any}}},
      &Scene::initials,
      {nodeKeys(&I::nodes),
       {withoutDefault(key("velocity", &I::velocity, "of the nodes", {.unit = "m/s"})),
        withoutDefault(key("angular_velocity", &I::angularVelocity, "rotation about an axis of this direction",
                           {.unit = "rad/s"})),
        key("point", &I::point, "on the axis", {.unit = "m"})}},
      checkInitial);
}

SceneSection moveSection() {
  using M = Scene::Move;
  return listSection<M>(
      {.name = "move",
       .help = "nodes that move at a constant velocity, or one that follows a table or an expression of time, and turn "
               "about an axis, or whose displacement follows one",
       .alternatives = {{"where", "set", Need::one, "rigid"},
                        {"velocity", "angular_velocity", Need::any, "displacement"},
                        {"displacement", "velocity", Need::atMostOne},
                        {"displacement", "angular_velocity", Need::atMostOne},
                        {"factor", "times", Need::atMostOne}}},
      &Scene::moves,
      {nodeKeys(&M::nodes),
       guideKeys<M>(),
       unbound<M>(timeTableKeys("velocity or displacement")),
       {withoutDefault(key("velocity", &M::velocity,
                           "prescribed velocity; or give angular_velocity, or both, or displacement", {.unit = "m/s"})),
        key("displacement", &M::way,
            "from where the nodes are at rest, times factor or table, which begins at 0; exact at the ends of steps",
            {.unit = "m"}),
        withoutDefault(key("angular_velocity", &M::angularVelocity,
                           "rotation about an axis of this direction that stays, exact at the ends of steps; the table "
                           "is its factor too",
                           {.unit = "rad/s", .features = {F::timed}})),
        key("point", &M::point, "on the axis", {.unit = "m"}), componentsKey<M>("prescribed")}},
      checkMove);
}

SceneSection forceSection() {
  using L = Scene::Force;
  return listSection<L>(
      {.name = "force",
       .help = "dead loads, constant or following a table or an expression of time",
       .alternatives = {{"factor", "times", Need::atMostOne},
                        {"where", "set"},
                        {"acceleration", "force", Need::one, "each"}}},
      &Scene::forces,
      {nodeKeys(&L::nodes),
       unbound<L>(timeTableKeys("load")),
       {key("acceleration", &L::acceleration, "force = mass x acceleration; or give force or each", {.unit = "m/s2"}),
        key("force", &L::total, "total force, spread over the nodes by mass", {.unit = "N"}),
        key("each", &L::each, "force on each of the nodes", {.unit = "N"})}},
      takeTable<L>);
}

SceneSection pressureSection() {
  using P = Scene::Pressure;
  return listSection<P>(
      {.name = "pressure",
       .help = "pressure on the surface, which follows its normals; its load stiffness is outside the proof",
       .features = {F::timed, F::pressure},
       .alternatives = {{"factor", "times", Need::atMostOne}, {"where", "set"}}},
      &Scene::pressures,
      {nodeKeys(&P::nodes),
       unbound<P>(timeTableKeys("pressure")),
       {key("pressure", &P::pressure, "on the faces all of whose corners are selected, inwards where > 0",
            {.unit = "Pa", .required = true})}},
      takeTable<P>);
}

SceneSection massSection() {
  using P = Scene::PointMass;
  return listSection<P>(
      {.name = "mass",
       .help = "point masses: parts that are not meshed; each [[mass]] adds to the others",
       .alternatives = {{"where", "set"}, {"mass", "nodal_mass"}}},
      &Scene::pointMasses,
      {nodeKeys(&P::nodes),
       {withoutDefault(key("mass", &P::mass, "of all the nodes together, which share it equally",
                           {.unit = "kg", .range = KeyRange::positive})),
        key("nodal_mass", &P::nodal,
            "instead of mass: what each node has in all, its elements' share and masses above included; at least those",
            {.unit = "kg", .range = KeyRange::positive, .features = {F::nodalMass}})}});
}

SceneSection massDampingSection() {
  using D = Scene::MassDamping;
  return listSection<D>(
      {.name = "mass_damping",
       .help = "damping of nodes in proportion to their mass; each [[mass_damping]] adds to the others and to "
               "[damping]",
       .features = {F::discrete, F::dashpots},
       .alternatives = {{"where", "set"}}},
      &Scene::massDampings,
      {nodeKeys(&D::nodes),
       {key("rate", &D::rate, "force = -rate x mass x velocity, of each node",
            {.unit = "1/s", .required = true, .range = KeyRange::notNegative})}});
}

SceneSection rigidSection() {
  using R = Scene::Rigid;
  return listSection<R>(
      {.name = "rigid",
       .help = "nodes that move as a rigid body of their mass; elements within one are not deformed and set no step",
       .features = {F::rigid},
       .alternatives = {{"where", "set"}}},
      &Scene::rigids,
      {nodeKeys(&R::nodes), {key("name", &R::name, "for [[probe]]; without, \"rigid N\", N counted from 0")}},
      checkRigid);
}

}  // namespace ringwatch
