#include <ringwatch/app/scene/scene_discrete.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <fmt/format.h>

#include <ringwatch/app/command/integrator_catalog.h>
#include <ringwatch/app/scene/scene_sections.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/base/nearest_name.h>
#include <ringwatch/base/sort_unique.h>
#include <ringwatch/base/user_text.h>
#include <ringwatch/body/discrete_forces.h>
#include <ringwatch/meshes/adjacency.h>
#include <ringwatch/monitor/bounds/nodal_bound.h>
#include <ringwatch/monitor/critical_step.h>

namespace ringwatch {
namespace {

/// Sweeps of the nodal bound that "auto" and PenaltyRoom are made of.
constexpr int penaltySweeps = 12;
/// Steps N that a node alone is in contact, half a period on the penalty "auto". Two would be stable, but contact
/// begins anywhere within a step, which makes or takes up to (π/2N)² of the node's energy while it touches: 0.27 for N
/// = 3, 0.1 for 5, 0.025 for 10, 0.006 for 20. Measured on examples/rubber_block.toml with the step 1e-4 s, largest
/// balance error over the energy of the fall: 3.7 % for N = 3, 2.4 % for 5, 1.9 % for 10, 1.45 % for 20.
constexpr double contactSteps = 20;
/// What "auto" takes at most of the largest penalty that the wanted step has room for at rest: elements stiffen as they
/// deform. It decides only where the step is within about 1 % of what the elements alone prove, or damping is strong.
constexpr double shareOfRoom = 0.5;
/// The reference step of "auto" where elements damp: how often it is corrected, and when it is near enough.
constexpr int referenceSearches = 4;
constexpr double referenceTolerance = 0.005;

void readSpring(const SceneTable& section, Scene& scene) {
  Scene::SpringSet springs{selectionOf(section),           std::nullopt, section.get<double>("stiffness"),
                           section.get<double>("damping"), std::nullopt, std::nullopt,
                           section.origin + ": [[spring]]"};
  if (section.given("to_where") || section.given("to_set")) springs.to = selectionOf(section, "to_");
  if (section.given("direction")) {
    if (springs.to)
      fail(section.at("direction").origin, "spring.direction",
           "a spring between two nodes acts along their line; take one of the two out");
    const Eigen::Vector3d direction = vectorOf(section.at("direction").value);
    if (!(direction.norm() > 0)) fail(section.at("direction").origin, "spring.direction", "[0, 0, 0] is no direction");
    springs.direction = direction.normalized();
  }
  if (section.given("length")) {
    if (!springs.to)
      fail(section.at("length").origin, "spring.length",
           "a spring to the ground is at rest where its node is; give to_where or to_set, or take it out");
    springs.length = section.get<double>("length");
  }
  scene.springs.push_back(std::move(springs));
}

ObstacleParameters parametersOf(const SceneTable& section, const ObstacleKind& kind) {
  const auto isIn = [](const std::vector<std::string_view>& names, const std::string& key) {
    return std::find(names.begin(), names.end(), key) != names.end();
  };
  for (const ObstacleKind& other : allObstacleKinds())
    for (const auto* names : {&other.needs, &other.takes})
      for (const std::string_view name : *names) {
        const std::string key(name);
        if (!section.given(key) || isIn(kind.needs, key) || isIn(kind.takes, key)) continue;
        std::vector<std::string_view> known{"point"};
        known.insert(known.end(), kind.needs.begin(), kind.needs.end());
        known.insert(known.end(), kind.takes.begin(), kind.takes.end());
        fail(section.at(key).origin, "obstacle." + key,
             fmt::format("is no parameter of a {}; it takes {}", kind.name, fmt::join(known, ", ")));
      }
  for (const std::string_view name : kind.needs)
    if (!section.given(std::string(name)))
      fail(section.origin, fmt::format("obstacle.{}", name), fmt::format("missing; a {} needs it", kind.name));
  const auto vector = [&](const char* key) {
    return section.given(key) ? vectorOf(section.at(key).value) : Eigen::Vector3d(0, 0, 0);
  };
  ObstacleParameters parameters{vector("point"), vector("normal"), vector("axis"), vector("size")};
  if (section.given("radius")) parameters.radius = section.get<double>("radius");
  if (section.given("length")) parameters.length = section.get<double>("length");
  parameters.hollow = section.get<bool>("hollow");
  return parameters;
}

void readObstacle(const SceneTable& section, Scene& scene) {
  const auto& kinds = allObstacleKinds();
  const auto kind = std::ranges::find(kinds, section.get<std::string>("kind"), &ObstacleKind::name);
  Scene::MovingObstacle obstacle{
      section.given("name") ? section.get<std::string>("name") : fmt::format("obstacle {}", scene.obstacles.size()),
      &*kind,
      parametersOf(section, *kind),
      vectorOf(section.at("velocity").value),
      tableOf(section, scene),
      section.origin + ": [[obstacle]]"};
  for (const Scene::MovingObstacle& other : scene.obstacles)
    if (other.name == obstacle.name)
      fail(section.at("name").origin, "obstacle.name",
           fmt::format("{} is the name of another one, at {}", inQuotes(obstacle.name), other.origin));
  try {
    kind->make(obstacle.parameters);
  } catch (const InputError& fault) {
    throw InputError(fmt::format("{}: {}", obstacle.origin, fault.what()));
  }
  scene.obstacles.push_back(std::move(obstacle));
}

void readContact(const SceneTable& section, Scene& scene) {
  if (scene.obstacles.empty())
    fail(section.origin, "[[contact]]", "there is no [[obstacle]] to touch; give one, with its kind");
  Scene::Contact contact;
  contact.origin = section.origin + ": [[contact]]";
  contact.penaltyOrigin = section.given("penalty") ? section.where("penalty") : contact.origin;
  if (section.given("where") || section.given("set")) contact.nodes = selectionOf(section);
  std::vector<std::string> known;
  for (const Scene::MovingObstacle& obstacle : scene.obstacles) known.push_back(obstacle.name);
  if (section.given("obstacle")) {
    const auto name = section.get<std::string>("obstacle");
    const auto found = std::find(known.begin(), known.end(), name);
    if (found == known.end())
      fail(section.at("obstacle").origin, "contact.obstacle",
           fmt::format("unknown obstacle {}; {}the scene has {}", inQuotes(name), didYouMean(name, known),
                       fmt::join(known, ", ")));
    contact.obstacles = {static_cast<std::size_t>(found - known.begin())};
  } else {
    for (std::size_t i = 0; i < known.size(); ++i) contact.obstacles.push_back(i);
  }
  contact.damping = section.get<double>("damping");
  contact.friction = section.get<double>("friction");
  contact.slip = section.get<double>("slip");
  if (section.at("penalty").value.is_number()) {
    contact.penalty = section.get<double>("penalty");
    if (section.given("step"))
      fail(section.at("step").origin, "contact.step", "is what penalty = \"auto\" is made of; take one of them out");
  } else if (section.given("step")) {
    contact.step = section.get<double>("step");
  } else if (scene.step) {
    contact.step = *scene.step;
  } else {
    fail(section.origin, "contact.step",
         "missing; penalty = \"auto\" needs the step (s) that it is to leave where integrator.step is \"auto\"");
  }
  scene.contacts.push_back(std::move(contact));
}

bool damps(const Scene& scene) {
  return std::any_of(scene.springs.begin(), scene.springs.end(), [](const auto& one) { return one.damping > 0; }) ||
         std::any_of(scene.contacts.begin(), scene.contacts.end(),
                     [](const auto& one) { return one.damping > 0 || one.friction > 0; });
}

/// Springs and contact are of explicit schemes of one body, whose masses and meshes stay.
void checkDiscreteForces(Scene& scene) {
  if (!scene.hasDiscreteForces()) return;
  const std::string origin = scene.discreteOrigin();
  const IntegratorInfo& info = *integratorCatalog().find(scene.method);
  const auto takes = [](const IntegratorInfo& one) {
    return !one.partitioned && !one.adaptive && !std::isinf(one.imaginaryLimit);
  };
  const auto takesMoving = [&](const IntegratorInfo& one) { return takes(one) && one.forceEvaluations == 1; };
  const auto takesDashpots = [](const IntegratorInfo& one) { return one.highestModeBinds; };
  if (!takes(info))
    throw InputError(fmt::format("{}: \"{}\" takes no springs and contact; {} do", origin, scene.method,
                                 namesWhere(integratorInfos(), takes)));
  if (scene.movesObstacles() && !takesMoving(info))
    throw InputError(fmt::format("{}: \"{}\" takes no moving obstacles; {} do", origin, scene.method,
                                 namesWhere(integratorInfos(), takesMoving)));
  if (damps(scene) && !takesDashpots(info))
    throw InputError(
        fmt::format("{}: \"{}\": with damping or friction the bracket is proven for {} only; choose one of "
                    "them, or take damping and friction out",
                    origin, scene.method, namesWhere(integratorInfos(), takesDashpots)));
  if (!scene.handler.empty())
    throw InputError(
        fmt::format("{}: handlers do not work with springs and contact; set handler.method = \"none\"", origin));
  if (!scene.cuts.empty()) throw InputError(fmt::format("{}: springs and contact do not go with [[cut]]", origin));
  if (scene.certificates)
    throw InputError(
        fmt::format("{}: certificates in files know no springs and contact; take monitor.certificates out", origin));
  constexpr const char* noDevice = "a GPU takes no springs and contact";
  if (scene.device == RunDevice::cuda)
    throw InputError(fmt::format("{}: \"cuda\": {}; set it to \"cpu\"", scene.deviceOrigin, noDevice));
  if (scene.device == RunDevice::automatic) scene.noDevice = noDevice;
}

std::vector<std::int32_t> surfaceNodes(const Mesh& mesh) {
  std::vector<std::int32_t> nodes;
  for (const ElementFace& face : boundaryFaces(mesh)) {
    const MeshBlock& block = mesh.blocks[face.block];
    const ElementInfo& info = elementInfo(block.type);
    const std::int32_t* own = block.element(face.element);
    const auto& corners = info.faces[face.face];
    const auto isCorner = [&](int a) { return std::find(corners.begin(), corners.end(), a) != corners.end(); };
    for (const int corner : corners)
      if (corner >= 0) nodes.push_back(own[corner]);
    if (info.order < 2) continue;
    const auto firstMiddle = info.nodes - static_cast<int>(info.edges.size());
    for (std::size_t e = 0; e < info.edges.size(); ++e)
      if (isCorner(info.edges[e][0]) && isCorner(info.edges[e][1]))
        nodes.push_back(own[firstMiddle + static_cast<int>(e)]);
  }
  sortUnique(nodes);
  return nodes;
}

std::int32_t nearest(const Mesh& mesh, std::int32_t node, const std::vector<std::int32_t>& others) {
  std::int32_t best = -1;
  double distance = infinity;
  for (const std::int32_t other : others) {
    const double own = (mesh.X.col(other) - mesh.X.col(node)).squaredNorm();
    if (other != node && own < distance) {
      distance = own;
      best = other;
    }
  }
  return best;
}

std::vector<Spring> springsOf(const Scene::SpringSet& set, const Mesh& mesh) {
  std::vector<Spring> springs;
  const std::vector<std::int32_t> others = set.to ? set.to->nodesOf(mesh) : std::vector<std::int32_t>();
  for (const std::int32_t node : set.nodes.nodesOf(mesh)) {
    Spring spring;
    spring.node = node;
    spring.stiffness = set.stiffness;
    spring.damping = set.damping;
    spring.direction = set.direction;
    spring.anchor = mesh.X.col(node);
    if (set.to) {
      spring.other = nearest(mesh, node, others);
      if (spring.other < 0)
        throw InputError(fmt::format("{}: its node {} is the only one that it could lead to; change a condition",
                                     set.origin, mesh.nodeId(node)));
      spring.length = set.length.value_or((mesh.X.col(spring.other) - mesh.X.col(node)).norm());
    }
    springs.push_back(spring);
  }
  return springs;
}

/// lambda_max(S_i) of the elements at rest, rad²/s², by node, and the bound of all: what springs and contact add to.
struct ElementsAlone {
  double bound;
  std::vector<double> nodal;
};
ElementsAlone elementsAlone(const Body& body) {
  NodalBound weights(body);
  if (const DiscreteForces* discrete = body.discreteForces())
    weights.setMajorants(std::vector<Eigen::Matrix3d>(discrete->nodes().size(), Eigen::Matrix3d::Zero()));
  weights.evaluate(body.mesh().X, penaltySweeps);
  return {weights.last(), weights.nodal()};
}

/// Throws InputError where an obstacle begins inside the body: where it holds a node of its contact, or of the whole
/// body for contact of the surface, as an obstacle inside of the body touches no surface.
void requireOutside(const Scene& scene, const Mesh& mesh) {
  // Nodes that lie on a surface are there to rounding.
  const double size = (mesh.X.rowwise().maxCoeff() - mesh.X.rowwise().minCoeff()).maxCoeff();
  constexpr double rounding = 1e-9;
  for (const Scene::Contact& contact : scene.contacts) {
    std::vector<std::int32_t> nodes;
    if (contact.nodes) {
      nodes = contact.nodes->nodesOf(mesh);
    } else {
      nodes.resize(mesh.nodeCount());
      std::iota(nodes.begin(), nodes.end(), 0);
    }
    for (const std::size_t i : contact.obstacles) {
      const Scene::MovingObstacle& obstacle = scene.obstacles[i];
      const std::unique_ptr<Obstacle> shape = obstacle.kind->make(obstacle.parameters);
      double deepest = rounding * size;
      std::int32_t deepestNode = -1;
      std::size_t inside = 0;
      for (const std::int32_t node : nodes) {
        const double depth = -shape->at(mesh.X.col(node)).gap;
        inside += depth > rounding * size;
        if (!(depth > deepest)) continue;
        deepest = depth;
        deepestNode = node;
      }
      if (deepestNode < 0) continue;
      const Eigen::Vector3d at = mesh.X.col(deepestNode);
      throw InputError(fmt::format(
          "{}: {} begins inside the body: node {} at ({:.6g}, {:.6g}, {:.6g}) is {:.4g} m deep in it, the "
          "deepest of {}; move it, or leave the nodes out of [[contact]]",
          obstacle.origin, inQuotes(obstacle.name), mesh.nodeId(deepestNode), at[0], at[1], at[2], deepest, inside));
    }
  }
}

/// The penalty k with k + f 2 ξ √(k m) = room: its damping, as a share of the critical one, has its part of the room.
double penaltyFor(double room, double mass, double damping, double factor) {
  const double half = factor * damping * std::sqrt(mass), root = std::sqrt(half * half + room) - half;
  return root * root;
}

}  // namespace

void readDiscreteSections(const std::vector<SceneTable>& sections, Scene& scene) {
  const auto forEach = [&](std::string_view name, const auto& read) {
    for (const SceneTable& section : sections)
      if (section.name == name) read(section, scene);
  };
  forEach("mass", [](const SceneTable& section, Scene& to) {
    to.pointMasses.push_back({selectionOf(section), section.get<double>("mass")});
  });
  forEach("spring", readSpring);
  forEach("obstacle", readObstacle);
  forEach("contact", readContact);
  if (scene.contacts.empty() && !scene.obstacles.empty())
    throw InputError(fmt::format("{}: there is no [[contact]] with it; give one, which may be empty for the surface",
                                 scene.obstacles.front().origin));
  checkDiscreteForces(scene);
}

void addPointMasses(const Scene& scene, Body& body) {
  for (const Scene::PointMass& point : scene.pointMasses) {
    const std::vector<std::int32_t> nodes = point.nodes.nodesOf(body.mesh());
    for (const std::int32_t node : nodes) body.addNodalMass(node, point.mass / static_cast<double>(nodes.size()));
  }
}

void addDiscreteForces(const Scene& scene, Body& body) {
  if (!scene.hasDiscreteForces()) return;
  DiscreteForces forces(body.nodeCount());
  for (const Scene::SpringSet& set : scene.springs) forces.add(springsOf(set, body.mesh()));
  for (const Scene::MovingObstacle& obstacle : scene.obstacles) forces.add(obstacle.kind->make(obstacle.parameters));
  placeObstacles(scene, 0, forces);
  requireOutside(scene, body.mesh());
  std::optional<ElementsAlone> alone;
  for (const Scene::Contact& contact : scene.contacts) {
    const std::vector<std::int32_t> nodes =
        contact.nodes ? contact.nodes->nodesOf(body.mesh()) : surfaceNodes(body.mesh());
    std::vector<double> penalty(nodes.size(), contact.penalty.value_or(0)), damping(nodes.size());
    if (!contact.penalty) {
      // What elements damp counts for that step, of each contact.
      if (ElementDamping* elements = body.elementDamping()) {
        elements->setFactor(dampingFactor(scene.damping, contact.step));
        alone.reset();
      }
      if (!alone) alone = elementsAlone(body);
      const StepRule rule = stepRule(*integratorCatalog().find(scene.method), scene.damping);
      const double allowed = rule.lambdaFor(contact.step), factor = dampingFactor(scene.damping, contact.step);
      for (std::size_t k = 0; k < nodes.size(); ++k) {
        const double mass = body.lumpedMass()[nodes[k]], room = mass * (allowed - alone->nodal[nodes[k]]);
        if (!(room > 0))
          throw InputError(
              fmt::format("{}: \"auto\" has no room: the elements alone prove steps up to {:.4g} s at "
                          "rest; take a smaller step than {:.4g} s, in contact.step or integrator.step",
                          contact.penaltyOrigin, rule(alone->bound), contact.step));
        const double slow = std::numbers::pi / (contactSteps * contact.step);
        penalty[k] = std::min(mass * slow * slow, penaltyFor(shareOfRoom * room, mass, contact.damping, factor));
      }
    }
    for (std::size_t k = 0; k < nodes.size(); ++k)
      damping[k] = 2 * contact.damping * std::sqrt(penalty[k] * body.lumpedMass()[nodes[k]]);
    for (const std::size_t obstacle : contact.obstacles)
      forces.add(PenaltyContact{obstacle, nodes, penalty, damping, contact.friction, contact.slip});
  }
  body.setDiscreteForces(std::move(forces));
}

StepRule sceneStepRule(const Scene& scene, Body& body) {
  const IntegratorInfo& info = *integratorCatalog().find(scene.method);
  const StepRule rule = stepRule(info, scene.damping);
  const bool dashpots = body.discreteForces() && body.discreteForces()->damped();
  ElementDamping* elements = body.elementDamping();
  if (!dashpots && !elements) return rule;
  const auto setFactor = [&](double f) {
    if (body.discreteForces()) body.discreteForces()->setDampingFactor(f);
    if (elements) elements->setFactor(f);
  };
  const double overcount = elements ? elements->overcount() : 0;
  const auto ruleAt = [&](double reference) {
    setFactor(dampingFactor(scene.damping, reference));
    return stepRuleWithDashpots(info, scene.damping, reference, overcount);
  };
  if (scene.step) return ruleAt(*scene.step);
  setFactor(0);
  double reference = scene.safety * criticalStep(body, body.mesh().X, rule).safe;
  // The bracket is tight at the reference: where every element damps, the step is shorter than without.
  for (int i = 0; elements && i < referenceSearches; ++i) {
    const StepRule own = ruleAt(reference);
    const double next = scene.safety * criticalStep(body, body.mesh().X, own).safe;
    const bool near = std::abs(next - reference) <= referenceTolerance * reference;
    reference = next;
    if (near) break;
  }
  return ruleAt(reference);
}

std::optional<PenaltyRoom> penaltyRoom(const Scene& scene, const Body& body, double step) {
  if (body.elementDamping()) return std::nullopt;
  const StepRule rule = stepRule(*integratorCatalog().find(scene.method), scene.damping);
  const ElementsAlone alone = elementsAlone(body);
  // The largest penalty of all contact nodes with which a step is proven; infinite without contact.
  const auto penaltyAt = [&](double h) {
    double most = infinity;
    for (const PenaltyContact& contact : body.discreteForces()->contacts())
      for (std::size_t k = 0; k < contact.nodes.size(); ++k) {
        const double mass = body.lumpedMass()[contact.nodes[k]];
        // The damping grows with the root of the penalty, as a share of the critical one.
        const double damping =
            contact.penalty[k] > 0 ? contact.damping[k] / (2 * std::sqrt(contact.penalty[k] * mass)) : 0;
        most = std::min(most, penaltyFor(mass * (rule.lambdaFor(h) - alone.nodal[contact.nodes[k]]), mass, damping,
                                         dampingFactor(scene.damping, h)));
      }
    return most;
  };
  PenaltyRoom room;
  room.elementsAlone = rule(alone.bound);
  if (!(room.elementsAlone > 0) || !std::isfinite(room.elementsAlone)) return std::nullopt;
  room.penalty = penaltyAt(room.share * room.elementsAlone);
  if (!std::isfinite(room.penalty)) return std::nullopt;
  if (step > 0 && step < room.elementsAlone) room.penaltyAtStep = penaltyAt(step);
  return room;
}

void placeObstacles(const Scene& scene, double time, DiscreteForces& forces) {
  for (std::size_t i = 0; i < scene.obstacles.size(); ++i) {
    const Scene::MovingObstacle& obstacle = scene.obstacles[i];
    const auto& table = obstacle.table;
    const double way = time > 0 ? (table ? table->mean(0, time) : 1) * time : 0;
    forces.place(i, way * obstacle.velocity, (table ? table->at(time) : 1) * obstacle.velocity);
  }
}

}  // namespace ringwatch
