#include <algorithm>
#include <numbers>

#include <ringwatch/app/scene/key_binding.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/nearest_name.h>
#include <ringwatch/base/user_text.h>
#include <ringwatch/body/obstacle.h>

namespace ringwatch {
namespace {

using F = Feature;
using Need = SceneAlternative::Need;

void checkSpring(const SceneTable& table, Scene&, Scene::SpringSet& springs) {
  const auto refuse = [&](const char* key, const char* what) {
    fail(table.at(key).origin, joinText("spring.", key), what);
  };
  if (springs.direction) {
    if (springs.to) refuse("direction", "a spring between two nodes acts along their line; take one of the two out");
    if (!(springs.direction->norm() > 0)) refuse("direction", "[0, 0, 0] is no direction");
    springs.direction->normalize();
  }
  if (springs.length && !springs.to && !springs.alongEdges)
    refuse("length", "a spring to the ground is at rest where its node is; give to_where or to_set, or take it out");
}

/// Refuses parameters that the kind of an obstacle does not take, and asks for those that it needs.
void checkParameters(const SceneTable& table, const ObstacleKind& kind) {
  const auto takes = [&](std::string_view name) {
    return std::ranges::count(kind.needs, name) + std::ranges::count(kind.takes, name) > 0;
  };
  for (const ObstacleKind& other : allObstacleKinds())
    for (const auto* names : {&other.needs, &other.takes})
      for (const std::string_view name : *names) {
        const std::string parameter(name);
        if (!table.given(parameter) || takes(name)) continue;
        std::vector<std::string_view> known{"point"};
        known.insert(known.end(), kind.needs.begin(), kind.needs.end());
        known.insert(known.end(), kind.takes.begin(), kind.takes.end());
        fail(table.at(parameter).origin, "obstacle." + parameter,
             fmt::format("is no parameter of a {}; it takes {}", kind.name, fmt::join(known, ", ")));
      }
  for (const std::string_view name : kind.needs)
    if (!table.given(std::string(name)))
      fail(table.origin, fmt::format("obstacle.{}", name), fmt::format("missing; a {} needs it", kind.name));
}

void checkObstacle(const SceneTable& table, Scene& scene, Scene::MovingObstacle& obstacle) {
  obstacle.kind = &*std::ranges::find(allObstacleKinds(), table.get<std::string>("kind"), &ObstacleKind::name);
  requireOwnName(table, scene.obstacles, obstacle);
  checkParameters(table, *obstacle.kind);
  obstacle.table = tableOf(table, scene);
  try {
    obstacle.kind->make(obstacle.parameters);
  } catch (const InputError& fault) {
    throw InputError(fmt::format("{}: {}", obstacle.origin, fault.what()));
  }
  if (std::ranges::all_of(scene.contacts, &Scene::Contact::withSurface))
    throw InputError(fmt::format("{}: there is no [[contact]] with it; give one, which may be empty for the surface",
                                 scene.obstacles.front().origin));
}

/// Takes what a [[contact]] touches.
void readTouched(const SceneTable& table, const Scene& scene, Scene::Contact& contact) {
  const auto refuse = [&](const char* key, const std::string& what) {
    fail(table.at(key).origin, joinText("contact.", key), what);
  };
  if (contact.withSurface) {
    if (table.given("obstacle"))
      refuse("obstacle", "this contact is with = \"surface\"; take one of the two out, or give another [[contact]]");
    if (table.get<bool>("edges"))
      contact.edgeAngle = table.get<double>("edge_angle") * std::numbers::pi / 180;
    else if (table.given("edge_angle"))
      refuse("edge_angle", "needs edges = true");
    return;
  }
  for (const auto& [key, what] : {std::pair{"edges", "edges"}, std::pair{"edge_angle", "edges"},
                                  std::pair{"to_where", "nodes"}, std::pair{"to_set", "nodes"}})
    if (table.given(key)) refuse(key, fmt::format("needs with = \"surface\"; obstacles have no {}", what));
  if (scene.obstacles.empty())
    fail(table.origin, "[[contact]]",
         "there is no [[obstacle]] to touch; give one, with its kind, or with = \"surface\"");
  if (table.given("obstacle")) {
    contact.obstacles = {positionOf(table, "obstacle", scene.obstacles)};
  } else {
    for (std::size_t i = 0; i < scene.obstacles.size(); ++i) contact.obstacles.push_back(i);
  }
}

void checkContact(const SceneTable& table, Scene& scene, Scene::Contact& contact) {
  contact.penaltyOrigin = table.given("penalty") ? table.where("penalty") : contact.origin;
  readTouched(table, scene, contact);
  if (contact.penalty && contact.step)
    fail(table.at("step").origin, "contact.step", "is what penalty = \"auto\" is made of; take one of them out");
  if (!contact.penalty && !contact.step) contact.step = scene.step;
}

/// A parameter of obstacles.
template <class Value>
BoundKey<Scene::MovingObstacle> parameter(std::string name, Value ObstacleParameters::*member, std::string help,
                                          SceneKey rest) {
  return key(std::move(name), at(&Scene::MovingObstacle::parameters, member), std::move(help), std::move(rest));
}

}  // namespace

SceneSection springSection() {
  using S = Scene::SpringSet;
  return listSection<S>(
      {.name = "spring",
       .help = "springs and dashpots, from nodes to the ground or to other nodes",
       .features = {F::discrete},
       .alternatives = {{"where", "set"},
                        {"to_where", "to_set", Need::atMostOne},
                        {"edges", "to_where", Need::atMostOne},
                        {"edges", "to_set", Need::atMostOne},
                        {"edges", "direction", Need::atMostOne}}},
      &Scene::springs,
      {nodeKeys(&S::nodes),
       nodeKeys(&S::to, "to_",
                "the other ends: each node's spring leads to the nearest of these; without, to the ground"),
       {key("edges", &S::alongEdges,
            "one along each edge of the elements both of whose ends are selected, instead of one at each node"),
        key("stiffness", &S::stiffness, "of each spring",
            {.unit = "N/m", .required = true, .range = KeyRange::notNegative}),
        key("damping", &S::damping, "of the dashpot beside it",
            {.unit = "N s/m", .range = KeyRange::notNegative, .features = {F::dashpots}}),
        key("direction", &S::direction, "in which alone a spring to the ground acts; without, it acts in all"),
        key("length", &S::length, "at rest, between two nodes; without, their distance at the start",
            {.unit = "m", .range = KeyRange::notNegative})}},
      checkSpring);
}

SceneSection obstacleSection() {
  using O = Scene::MovingObstacle;
  using P = ObstacleParameters;
  std::string listing;
  for (const ObstacleKind& kind : allObstacleKinds())
    listing += fmt::format("{}{}: {}", listing.empty() ? "" : "; ", kind.name, kind.help);
  const SceneKey length{.unit = "m", .range = KeyRange::positive};
  return listSection<O>(
      {.name = "obstacle",
       .help = "rigid bodies in closed form that nodes of a [[contact]] cannot enter, fixed or moving",
       .alternatives = {{"factor", "times", Need::atMostOne}}},
      &Scene::obstacles,
      {{{{.key = "kind",
          .type = SceneType::text,
          .required = true,
          .choices = namesOf(allObstacleKinds()),
          .help = listing}},
        key("name", &O::name, "for [[contact]]; without, \"obstacle N\", N counted from 0"),
        parameter("point", &P::point, "on the plane, on the cylinder's axis at half its length, or the centre",
                  {.unit = "m"}),
        withoutDefault(parameter("normal", &P::normal, "of a plane, out of the obstacle", {})),
        withoutDefault(parameter("axis", &P::axis, "direction of a cylinder", {})),
        withoutDefault(parameter("radius", &P::radius, "of a sphere or cylinder", length)),
        parameter("length", &P::length, "of a cylinder with flat ends", length),
        withoutDefault(parameter("size", &P::size, "edge lengths of a box", length)),
        parameter("hollow", &P::hollow, "the body is inside a sphere or cylinder", {}),
        key("velocity", &O::velocity, "at which it moves from the start",
            {.unit = "m/s", .features = {F::movingObstacles}})},
       unbound<O>(timeTableKeys("velocity"))},
      checkObstacle);
}

SceneSection contactSection() {
  using C = Scene::Contact;
  return listSection<C>(
      {.name = "contact",
       .help = "penalty contact of nodes with obstacles, or with the surface of other parts and of the body itself, "
               "with viscous damping and Coulomb friction; sliding friction is outside the proof",
       .features = {F::discrete},
       .alternatives = {{"where", "set", Need::atMostOne}, {"to_where", "to_set", Need::atMostOne}}},
      &Scene::contacts,
      {nodeKeys(&C::nodes),
       {{{.key = "with",
          .type = SceneType::text,
          .fallback = "\"obstacles\"",
          .choices = {"obstacles", "surface"},
          .features = {F::surfaces},
          .help = "what the nodes touch: the [[obstacle]]s, or the surface of the mesh, that of other parts and of "
                  "their own"},
         [](const SceneTable& table, C& contact) {
           contact.withSurface = table.get<std::string>("with") == "surface";
         }},
        {{.key = "obstacle", .type = SceneType::text, .help = "name of the obstacle; without, all of them"}}},
       nodeKeys(&C::to, "to_",
                "nodes of the surface that is touched, with = \"surface\": its faces all of whose corners are "
                "selected; without, the whole surface"),
       {{{.key = "edges",
          .type = SceneType::boolean,
          .fallback = "false",
          .help = "with = \"surface\": edges touch edges, too, so that sharp parts and coarse surfaces do not pass "
                  "between nodes"}},
        {{.key = "edge_angle",
          .unit = "degrees",
          .fallback = "20.0",
          .range = {0, 180, false, false},
          .help = "with edges: of those at which the surface turns outwards by more than this at rest"}},
        numberOrAuto("penalty", &C::penalty,
                     "stiffness at each node; \"auto\": so soft that a node alone stays in contact for 20 steps, and "
                     "that the step has room for it beside the elements at rest",
                     {.unit = "N/m", .range = KeyRange::positive}),
        key("step", &C::step,
            "that penalty = \"auto\" is made for; without, integrator.step, and where that is \"auto\" the safe step "
            "of the elements at rest alone",
            {.unit = "s", .range = KeyRange::positive}),
        key("damping", &C::damping, "share of the critical damping of a node on its penalty",
            {.range = KeyRange::notNegative, .features = {F::dashpots}}),
        key("friction", &C::friction, "Coulomb's coefficient",
            {.range = KeyRange::notNegative, .features = {F::dashpots, F::friction}}),
        numberOrAuto("slip", &C::slip,
                     "speed below that friction is viscous, so that surfaces that stick creep; \"auto\": in proportion "
                     "to the depth, so that a node that sticks has a tenth of the critical damping on its penalty at "
                     "most",
                     {.unit = "m/s", .range = KeyRange::positive})}},
      checkContact);
}

}  // namespace ringwatch
