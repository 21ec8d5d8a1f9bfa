#include <ringwatch/app/scene/scene_discrete.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <memory>
#include <numbers>
#include <numeric>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <ringwatch/app/scene/integrator_catalog.h>
#include <ringwatch/app/scene/scene_sections.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/base/nearest_name.h>
#include <ringwatch/base/random.h>
#include <ringwatch/base/sort_unique.h>
#include <ringwatch/base/user_text.h>
#include <ringwatch/body/discrete_forces.h>
#include <ringwatch/meshes/adjacency.h>
#include <ringwatch/meshes/surface.h>
#include <ringwatch/monitor/bounds/nodal_bound.h>
#include <ringwatch/monitor/bounds/rayleigh.h>

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
/// Damping of a node that sticks by friction, as a share of the critical one on its penalty: more sticks better, and
/// leaves less of the step, 2 % of λ for 20 steps.
constexpr double stickingShare = 0.1;
/// The reference step of "auto" where elements damp: how often it is corrected, and when it is near enough.
constexpr int referenceCorrections = 4;
constexpr double referenceTolerance = 0.005;
/// Of a reference that is to lie at the step which it gives. Each correction by the top mode leaves the square of what
/// was missing.
constexpr int ownStepCorrections = 12;
/// Nodes that lie on a surface at the start are there to rounding, relative to the size of the body.
constexpr double startRounding = 1e-9;

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

/// The edges of elements both of whose ends are among some nodes, each once.
std::vector<std::array<std::int32_t, 2>> edgesAmong(const std::vector<std::int32_t>& nodes, const Mesh& mesh) {
  std::vector<bool> chosen(mesh.nodeCount(), false);
  for (const std::int32_t node : nodes) chosen[static_cast<std::size_t>(node)] = true;
  std::vector<std::array<std::int32_t, 2>> edges;
  for (const MeshBlock& block : mesh.blocks)
    for (std::size_t e = 0; e < block.elementCount(); ++e)
      for (const auto& [a, b] : elementInfo(block.type).edges) {
        const std::int32_t one = block.element(e)[a], other = block.element(e)[b];
        if (chosen[static_cast<std::size_t>(one)] && chosen[static_cast<std::size_t>(other)])
          edges.push_back({std::min(one, other), std::max(one, other)});
      }
  sortUnique(edges);
  return edges;
}

std::vector<Spring> springsOf(const Scene::SpringSet& set, const Mesh& mesh) {
  std::vector<Spring> springs;
  if (set.alongEdges) {
    for (const auto& [node, other] : edgesAmong(set.nodes.nodesOf(mesh), mesh))
      springs.push_back({.node = node,
                         .other = other,
                         .length = set.length.value_or((mesh.X.col(other) - mesh.X.col(node)).norm()),
                         .stiffness = set.stiffness,
                         .damping = set.damping});
    if (springs.empty())
      throw InputError(
          fmt::format("{}: no edge of an element has both ends in the selection; change a condition", set.origin));
    return springs;
  }
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

/// A dashpot to the ground with rate times the mass of each node.
std::vector<Spring> dashpotsOf(const Scene::MassDamping& set, const Body& body) {
  std::vector<Spring> dashpots;
  for (const std::int32_t node : set.nodes.nodesOf(body.mesh()))
    dashpots.push_back(
        {.node = node, .anchor = body.mesh().X.col(node), .damping = set.rate * body.lumpedMass()[node]});
  return dashpots;
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

/// The elements at rest, and the step that a penalty "auto" leaves.
struct AtRest {
  double step;  // s
  ElementsAlone alone;
};
/// What elements damp counts for that step. wanted: empty for the safe step of the elements alone.
AtRest atRest(const Scene& scene, Body& body, std::optional<double> wanted) {
  ElementDamping* elements = body.elementDamping();
  const auto aloneAt = [&](double factor) {
    if (elements) elements->setFactor(factor);
    return elementsAlone(body);
  };
  const auto aloneFor = [&](double step) { return aloneAt(dampingFactor(scene.damping, step)); };
  if (wanted) return {*wanted, aloneFor(*wanted)};
  const IntegratorInfo& info = *integratorCatalog().find(scene.method);
  AtRest rest{0, aloneAt(0)};
  rest.step = scene.safety * stepRule(info, scene.damping)(rest.alone.bound);
  for (int i = 0; elements && i < referenceCorrections; ++i) {
    rest.alone = aloneFor(rest.step);
    rest.step =
        scene.safety * stepRuleWithDashpots(info, scene.damping, rest.step, elements->overcount())(rest.alone.bound);
  }
  if (elements) rest.alone = aloneFor(rest.step);
  return rest;
}

/// Throws InputError where surfaces overlap at the start.
void requireApart(const Scene::Contact& contact, SurfaceContact surface, const Mesh& mesh) {
  surface.penalty.assign(surface.nodes.size(), 0);
  surface.damping.assign(surface.nodes.size(), 0);
  surface.friction = 0;
  SurfaceSearch search(std::move(surface), static_cast<std::int32_t>(mesh.nodeCount()));
  search.locate(mesh.X, 0, 1);
  const double size = (mesh.X.rowwise().maxCoeff() - mesh.X.rowwise().minCoeff()).maxCoeff();
  const SurfaceSearch::Touch* deepest = nullptr;
  std::size_t inside = 0;
  for (const SurfaceSearch::Touch& touch : search.touching()) {
    if (!(touch.depth > startRounding * size)) continue;
    ++inside;
    if (!deepest || touch.depth > deepest->depth) deepest = &touch;
  }
  if (!deepest) return;
  const Eigen::Vector3d at = mesh.X.col(deepest->nodes[0]);
  if (deepest->otherEdge >= 0)
    throw InputError(fmt::format(
        "{}: surfaces overlap at the start: the edge of nodes {} and {}, near ({:.6g}, {:.6g}, {:.6g}), is {:.4g} m "
        "beyond that of nodes {} and {}, the deepest of {}; move the parts apart, or set edges = false",
        contact.origin, mesh.nodeId(deepest->nodes[0]), mesh.nodeId(deepest->nodes[1]), at[0], at[1], at[2],
        deepest->depth, mesh.nodeId(deepest->nodes[2]), mesh.nodeId(deepest->nodes[3]), inside));
  throw InputError(fmt::format(
      "{}: surfaces overlap at the start: node {} at ({:.6g}, {:.6g}, {:.6g}) is {:.4g} m deep behind the face of "
      "nodes {}, "
      "{} and {}, the deepest of {}; move the parts apart, or leave the nodes out of [[contact]]",
      contact.origin, mesh.nodeId(deepest->nodes[0]), at[0], at[1], at[2], deepest->depth,
      mesh.nodeId(deepest->nodes[1]), mesh.nodeId(deepest->nodes[2]), mesh.nodeId(deepest->nodes[3]), inside));
}

/// Throws InputError where an obstacle begins inside the body: where it holds a node of its contact, or of the whole
/// body for contact of the surface, as an obstacle inside of the body touches no surface.
void requireOutside(const Scene& scene, const Mesh& mesh) {
  const double size = (mesh.X.rowwise().maxCoeff() - mesh.X.rowwise().minCoeff()).maxCoeff();
  for (const Scene::Contact& contact : scene.contacts) {
    if (contact.withSurface) continue;
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
      double deepest = startRounding * size;
      std::int32_t deepestNode = -1;
      std::size_t inside = 0;
      for (const std::int32_t node : nodes) {
        const double depth = -shape->at(mesh.X.col(node)).gap;
        inside += depth > startRounding * size;
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

std::string noRoom(const Scene::Contact& contact, double proven, double step) {
  return fmt::format(
      "{}: \"auto\" has no room: the elements alone prove steps up to {:.4g} s at "
      "rest; take a smaller step than {:.4g} s, in contact.step or integrator.step",
      contact.penaltyOrigin, proven, step);
}

/// The damping that a penalty "auto" leaves room for, of the critical one.
double dampingShare(const Scene::Contact& contact) {
  return contact.damping + (contact.friction > 0 && !contact.slip ? stickingShare : 0);
}

/// fastest: ω of a node on its penalty, rad/s, the largest of the contact.
SlipSpeed slipOf(const Scene::Contact& contact, double fastest) {
  if (contact.slip) return {.speed = *contact.slip};
  return {.ofDepth = contact.friction * fastest / (2 * stickingShare)};
}

/// Damping of a node, N s/m, with that of friction that sticks at any depth.
template <class Contact>
double dampingOf(const Contact& contact, std::size_t k) {
  const bool sticks = contact.friction > 0 && contact.slip.ofDepth > 0;
  return contact.damping[k] + (sticks ? contact.friction * contact.slip.dashpot(contact.penalty[k], 0) : 0);
}

/// Areas and masses of the nodes of a surface, by node.
struct SurfaceShares {
  std::vector<double> area;      // m², a third of each triangle at a node
  std::vector<bool> held;        // in all directions: as if its mass were infinite
  std::vector<double> reacting;  // kg: the least that a node meets of the touched surface, by medians of its parts
  double meanArea = 0;           // m², of the nodes that touch it
};
SurfaceShares sharesOf(const SurfaceContact& contact, const Body& body) {
  SurfaceShares shares;
  shares.area.assign(body.nodeCount(), 0);
  shares.held.assign(body.nodeCount(), false);
  shares.reacting.assign(body.nodeCount(), infinity);
  const Mesh& mesh = body.mesh();
  for (const SurfaceTriangle& t : surfaceTriangles(mesh)) {
    const Eigen::Vector3d a = mesh.X.col(t.nodes[0]), b = mesh.X.col(t.nodes[1]), c = mesh.X.col(t.nodes[2]);
    for (const std::int32_t node : t.nodes) shares.area[node] += (b - a).cross(c - a).norm() / 6;
  }
  std::vector<std::int32_t> corners;
  for (const auto& triangle : contact.triangles) corners.insert(corners.end(), triangle.begin(), triangle.end());
  sortUnique(corners);
  struct Part {
    std::vector<double> massPerArea, areas;  // kg/m², m²
  };
  std::map<std::int32_t, Part> touched;
  const MeshParts parts = connectedParts(mesh);
  for (const std::int32_t node : corners) {
    shares.held[node] = body.constraints().freeComponents(node) == 0;
    Part& part = touched[parts.partOfNode[node]];
    part.massPerArea.push_back(shares.held[node] ? infinity : body.lumpedMass()[node] / shares.area[node]);
    part.areas.push_back(shares.area[node]);
  }
  const auto median = [](std::vector<double>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
  };
  std::map<std::int32_t, std::array<double, 2>> typical;
  for (auto& [number, part] : touched) typical[number] = {median(part.massPerArea), median(part.areas)};
  for (const std::int32_t node : contact.nodes) {
    shares.meanArea += shares.area[node] / static_cast<double>(contact.nodes.size());
    // A coarse node may stand on one corner of a fine part.
    for (const auto& [number, of] : typical)
      if (number != parts.partOfNode[node] || typical.size() == 1)
        shares.reacting[node] = std::min(shares.reacting[node], of[0] * std::min(shares.area[node], of[1]));
  }
  return shares;
}

/// The largest penalties, up to `wanted` for each node, that leave a share of the room of every node beside the
/// elements: of the nodes that touch, and of the corners that are touched, with as many nodes at each as its area has.
/// room: by node, N/m.
void fitSurfacePenalties(SurfaceContact& contact, const SurfaceShares& shares, const Body& body,
                         const std::vector<double>& room, double damping, double factor) {
  // Of the touched surface, the load on an area is that of the nodes that stand on it.
  double load = 0;
  const auto withDamping = [&](std::size_t k) {
    return contact.penalty[k] +
           factor * 2 * damping * std::sqrt(contact.penalty[k] * body.lumpedMass()[contact.nodes[k]]);
  };
  for (std::size_t k = 0; k < contact.nodes.size(); ++k) {
    const std::int32_t node = contact.nodes[k];
    const double own = 0.5 * shareOfRoom * room[node] / (1 + contact.split[k]);
    contact.penalty[k] = std::min(contact.penalty[k], penaltyFor(own, body.lumpedMass()[node], damping, factor));
    load = std::max(load, (1 + 1 / contact.split[k]) * withDamping(k) / shares.area[node]);
  }
  double share = 1;
  for (const auto& triangle : contact.triangles)
    for (const std::int32_t node : triangle)
      if (!shares.held[node]) share = std::min(share, 0.5 * shareOfRoom * room[node] / (load * shares.area[node]));
  if (share >= 1) return;
  // Damping goes with the root of the penalty.
  for (double& penalty : contact.penalty) penalty *= share * share;
}

/// What a penalty of one newton a metre at all edges of a contact is at a node in the majorant where each edge touches
/// one other, by node.
std::vector<double> edgeLoads(const SurfaceContact& contact, std::int32_t nodeCount) {
  std::vector<double> loads(nodeCount, 0.0);
  double least = infinity;
  for (const SurfaceContact::Edge& edge : contact.edges) least = std::min(least, edge.mass);
  for (const SurfaceContact::Edge& edge : contact.edges)
    for (const std::int32_t node : edge.nodes)
      loads[node] += 1 + std::min(edge.mass / least, SurfaceContact::largestSplit);
  return loads;
}

/// What a penalty of one newton a metre at all nodes of a contact is at a node in the majorant; and of its damping, the
/// share of the critical one.
struct SurfaceLoad {
  double share = 0, damping = 0;
};
std::map<std::int32_t, SurfaceLoad> surfaceLoads(const Body& body) {
  std::map<std::int32_t, SurfaceLoad> loads;
  for (const SurfaceSearch& surface : body.discreteForces()->surfaces()) {
    const SurfaceContact& contact = surface.contact();
    const SurfaceShares shares = sharesOf(contact, body);
    double most = 0, damping = 0;
    for (std::size_t k = 0; k < contact.nodes.size(); ++k) {
      loads[contact.nodes[k]].share += 1 + contact.split[k];
      most = std::max(most, 1 + 1 / contact.split[k]);
      const double mass = body.lumpedMass()[contact.nodes[k]];
      if (contact.penalty[k] > 0)
        damping = std::max(damping, dampingOf(contact, k) / (2 * std::sqrt(contact.penalty[k] * mass)));
    }
    std::vector<std::int32_t> corners;
    for (const auto& triangle : contact.triangles) corners.insert(corners.end(), triangle.begin(), triangle.end());
    sortUnique(corners);
    const std::vector<std::int32_t> touched = corners;
    const std::vector<double> ofEdges = edgeLoads(contact, body.nodeCount());
    for (const SurfaceContact::Edge& edge : contact.edges) {
      if (edge.penalty > 0) damping = std::max(damping, edge.damping / (2 * std::sqrt(edge.penalty * edge.mass)));
      corners.insert(corners.end(), edge.nodes.begin(), edge.nodes.end());
    }
    sortUnique(corners);
    for (const std::int32_t corner : corners)
      if (!shares.held[corner]) loads[corner].share += ofEdges[corner];
    for (const std::int32_t corner : touched)
      if (!shares.held[corner]) loads[corner].share += most * std::max(1.0, shares.area[corner] / shares.meanArea);
    for (auto& [node, load] : loads) load.damping = std::max(load.damping, damping);
  }
  return loads;
}

/// A contact with the surface of a body, without penalties; and what they are made of.
struct SurfaceSides {
  SurfaceContact contact;
  std::vector<std::int32_t> to;  // nodes of the touched surface
  SurfaceShares shares;
};
SurfaceSides sidesOf(const Scene::Contact& contact, const Body& body) {
  const Mesh& mesh = body.mesh();
  const std::vector<std::int32_t> surface = surfaceNodes(mesh);
  const auto onSurface = [&](const std::optional<NodeSelection>& selection) {
    if (!selection) return surface;
    const std::vector<std::int32_t> selected = selection->nodesOf(mesh);
    std::vector<std::int32_t> own;
    std::set_intersection(surface.begin(), surface.end(), selected.begin(), selected.end(), std::back_inserter(own));
    return own;
  };
  const std::vector<std::int32_t> nodes = onSurface(contact.nodes);
  if (nodes.empty())
    throw InputError(fmt::format("{}: none of its nodes is on the surface; change the condition", contact.origin));
  SurfaceSides sides{{}, onSurface(contact.to), {}};
  SurfaceContact& own = sides.contact;
  try {
    own = surfaceContact(mesh, nodes, sides.to, contact.edgeAngle);
  } catch (const InputError& fault) {
    throw InputError(fmt::format("{}: to_where, to_set: {}; change the condition", contact.origin, fault.what()));
  }
  own.friction = contact.friction;
  sides.shares = sharesOf(own, body);
  const SurfaceShares& shares = sides.shares;
  for (std::size_t k = 0; k < nodes.size(); ++k)
    own.split[k] = std::clamp(body.lumpedMass()[nodes[k]] / shares.reacting[nodes[k]], SurfaceContact::leastSplit,
                              SurfaceContact::largestSplit);
  for (SurfaceContact::Edge& edge : own.edges)
    edge.mass = std::min(body.lumpedMass()[edge.nodes[0]], body.lumpedMass()[edge.nodes[1]]);
  return sides;
}

/// Adds damping and slip of a contact with the surface that has its penalties.
void addSurfaceDamping(const Scene::Contact& contact, const Body& body, SurfaceContact& own) {
  double fastest = 0;
  for (SurfaceContact::Edge& edge : own.edges) {
    edge.damping = 2 * contact.damping * std::sqrt(edge.penalty * edge.mass);
    fastest = std::max(fastest, std::sqrt(edge.penalty / edge.mass));
  }
  for (std::size_t k = 0; k < own.nodes.size(); ++k) {
    const double mass = body.lumpedMass()[own.nodes[k]];
    own.damping.push_back(2 * contact.damping * std::sqrt(own.penalty[k] * mass));
    fastest = std::max(fastest, std::sqrt(own.penalty[k] / mass));
  }
  own.slip = slipOf(contact, fastest);
}

/// A contact with the surface, with its penalties. restOf: AtRest of a contact.
template <class RestOf>
SurfaceContact surfaceContactOf(const Scene& scene, const Scene::Contact& contact, const Body& body,
                                const RestOf& restOf) {
  SurfaceSides sides = sidesOf(contact, body);
  SurfaceContact& own = sides.contact;
  const std::vector<std::int32_t>&nodes = own.nodes, &to = sides.to;
  const SurfaceShares& shares = sides.shares;
  requireApart(contact, own, body.mesh());
  if (contact.penalty) {
    own.penalty.assign(nodes.size(), *contact.penalty);
    for (SurfaceContact::Edge& edge : own.edges) edge.penalty = *contact.penalty;
  } else {
    const AtRest& rest = restOf(contact);
    const StepRule rule = stepRule(*integratorCatalog().find(scene.method), scene.damping);
    const double allowed = rule.lambdaFor(rest.step);
    std::vector<double> room(body.nodeCount());
    for (const std::vector<std::int32_t>* side : {&nodes, &to})
      for (const std::int32_t node : *side) {
        room[node] = body.lumpedMass()[node] * (allowed - rest.alone.nodal[node]);
        if (!(room[node] > 0)) throw InputError(noRoom(contact, rule(rest.alone.bound), rest.step));
      }
    const double slow = std::numbers::pi / (contactSteps * rest.step), factor = dampingFactor(scene.damping, rest.step),
                 damping = dampingShare(contact);
    for (const std::int32_t node : nodes)
      own.penalty.push_back(slow * slow * std::min(body.lumpedMass()[node], shares.reacting[node]));
    fitSurfacePenalties(own, shares, body, room, damping, factor);
    const std::vector<double> loads = edgeLoads(own, body.nodeCount());
    for (SurfaceContact::Edge& edge : own.edges) {
      edge.penalty = slow * slow * edge.mass;
      for (const std::int32_t node : edge.nodes)
        if (!shares.held[node])
          edge.penalty = std::min(edge.penalty, penaltyFor(0.5 * shareOfRoom * room[node] / loads[node],
                                                           body.lumpedMass()[node], damping, factor));
    }
  }
  addSurfaceDamping(contact, body, own);
  return std::move(sides.contact);
}

/// The penalty of a node or an edge: as it was, or for its mass as little as the least of the others.
template <class Key>
class KeptPenalties {
 public:
  void add(const Key& key, double penalty, double mass) {
    known_[key] = penalty;
    least_ = std::min(least_, penalty / mass);
  }
  /// otherwise: over the mass, where there are no others.
  double of(const Key& key, double mass, double otherwise) const {
    const auto known = known_.find(key);
    return known != known_.end() ? known->second : mass * std::min(least_, otherwise);
  }
  double least() const { return least_; }

 private:
  std::map<Key, double> known_;
  double least_ = infinity;
};

}  // namespace

void addPointMasses(const Scene& scene, Body& body) {
  for (const Scene::PointMass& point : scene.pointMasses) {
    const std::vector<std::int32_t> nodes = point.nodes.nodesOf(body.mesh());
    for (const std::int32_t node : nodes) {
      const double has = body.lumpedMass()[node];
      if (point.nodal && has > *point.nodal)
        throw InputError(fmt::format("{}: nodal_mass = {} kg: node {} has {} kg without it; give at least that",
                                     point.origin, *point.nodal, body.mesh().nodeId(node), has));
      body.addNodalMass(node, point.nodal ? *point.nodal - has : point.mass / static_cast<double>(nodes.size()));
    }
  }
}

void addDiscreteForces(const Scene& scene, Body& body) {
  if (!scene.hasDiscreteForces()) return;
  DiscreteForces forces(body.nodeCount());
  for (const Scene::SpringSet& set : scene.springs) forces.add(springsOf(set, body.mesh()));
  for (const Scene::MassDamping& set : scene.massDampings) forces.add(dashpotsOf(set, body));
  for (const Scene::MovingObstacle& obstacle : scene.obstacles) forces.add(obstacle.kind->make(obstacle.parameters));
  placeObstacles(scene, 0, forces);
  requireOutside(scene, body.mesh());
  std::optional<AtRest> rest;
  std::optional<double> wanted;
  const auto restOf = [&](const Scene::Contact& contact) -> const AtRest& {
    if (!rest || contact.step != wanted) rest = atRest(scene, body, contact.step);
    wanted = contact.step;
    if (!(rest->step > 0) || !std::isfinite(rest->step))
      throw InputError(
          fmt::format("{}: contact.step: missing; penalty = \"auto\" is made for a step, and the elements "
                      "alone set none",
                      contact.penaltyOrigin));
    return *rest;
  };
  for (const Scene::Contact& contact : scene.contacts) {
    if (contact.withSurface) {
      forces.add(surfaceContactOf(scene, contact, body, restOf));
      continue;
    }
    const std::vector<std::int32_t> nodes =
        contact.nodes ? contact.nodes->nodesOf(body.mesh()) : surfaceNodes(body.mesh());
    std::vector<double> penalty(nodes.size(), contact.penalty.value_or(0)), damping(nodes.size());
    if (!contact.penalty) {
      const AtRest& elements = restOf(contact);
      const StepRule rule = stepRule(*integratorCatalog().find(scene.method), scene.damping);
      const double allowed = rule.lambdaFor(elements.step), factor = dampingFactor(scene.damping, elements.step),
                   slow = std::numbers::pi / (contactSteps * elements.step);
      for (std::size_t k = 0; k < nodes.size(); ++k) {
        const double mass = body.lumpedMass()[nodes[k]], room = mass * (allowed - elements.alone.nodal[nodes[k]]);
        if (!(room > 0)) throw InputError(noRoom(contact, rule(elements.alone.bound), elements.step));
        penalty[k] = std::min(mass * slow * slow, penaltyFor(shareOfRoom * room, mass, dampingShare(contact), factor));
      }
    }
    double fastest = 0;
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const double mass = body.lumpedMass()[nodes[k]];
      damping[k] = 2 * contact.damping * std::sqrt(penalty[k] * mass);
      fastest = std::max(fastest, std::sqrt(penalty[k] / mass));
    }
    const SlipSpeed slip = slipOf(contact, fastest);
    for (const std::size_t obstacle : contact.obstacles)
      forces.add(PenaltyContact{obstacle, nodes, penalty, damping, contact.friction, slip});
  }
  body.setDiscreteForces(std::move(forces));
}

void renewSurfaceContact(const Scene& scene, double time, std::vector<std::size_t>& contacts, Body& body) {
  const DiscreteForces* const before = body.discreteForces();
  if (contacts.empty()) return;
  DiscreteForces forces(body.nodeCount());
  forces.add(before->springs());
  for (const Scene::MovingObstacle& obstacle : scene.obstacles) forces.add(obstacle.kind->make(obstacle.parameters));
  placeObstacles(scene, time, forces);
  for (const PenaltyContact& contact : before->contacts()) forces.add(contact);
  forces.setDampingFactor(before->dampingFactor());
  std::vector<std::size_t> left;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const SurfaceContact& former = before->surfaces()[i].contact();
    const Scene::Contact& contact = scene.contacts[contacts[i]];
    SurfaceContact own;
    try {
      own = sidesOf(contact, body).contact;
    } catch (const InputError&) {
      continue;  // one of its sides is gone
    }
    KeptPenalties<std::int32_t> nodes;
    KeptPenalties<std::array<std::int32_t, 2>> edges;
    for (std::size_t k = 0; k < former.nodes.size(); ++k)
      nodes.add(former.nodes[k], former.penalty[k], body.lumpedMass()[former.nodes[k]]);
    for (const SurfaceContact::Edge& edge : former.edges) edges.add(edge.nodes, edge.penalty, edge.mass);
    for (const std::int32_t node : own.nodes)
      own.penalty.push_back(contact.penalty ? *contact.penalty : nodes.of(node, body.lumpedMass()[node], infinity));
    for (SurfaceContact::Edge& edge : own.edges)
      edge.penalty = contact.penalty ? *contact.penalty : edges.of(edge.nodes, edge.mass, nodes.least());
    addSurfaceDamping(contact, body, own);
    own.slip = former.slip;
    forces.add(std::move(own));
    left.push_back(contacts[i]);
  }
  contacts = std::move(left);
  body.setDiscreteForces(std::move(forces));
}

namespace {

/// Whether something damps whose share of the limit changes with the step.
bool countsDamping(const Body& body) {
  return body.elementDamping() || (body.discreteForces() && body.discreteForces()->damped());
}

void countDamping(Body& body, double factor) {
  if (body.discreteForces()) body.discreteForces()->setDampingFactor(factor);
  if (body.elementDamping()) body.elementDamping()->setFactor(factor);
}

bool isStep(double h) { return h > 0 && std::isfinite(h); }

/// Replaces a reference step by what a rule that is exact there gives, a few times or until it stays.
double correctedReference(const Scene& scene, Body& body, DampingRates rates, double reference, int corrections,
                          double tolerance, const StepByRule& step) {
  for (int i = 0; i < corrections; ++i) {
    const double next = step(stepRuleAt(scene, body, reference, rates));
    if (!isStep(next)) break;
    const bool near = std::abs(next - reference) <= tolerance * reference;
    reference = next;
    if (near) break;
  }
  return reference;
}

}  // namespace

StepByRule stepOfTopMode(const Body& body, const NodeVectors& x, double (*side)(const StepRule&, LowerBound)) {
  const auto mode = std::make_shared<NodeVectors>(3, body.nodeCount());
  for (Eigen::Index i = 0; i < mode->size(); ++i) mode->data()[i] = randomEntry(1, static_cast<std::uint64_t>(i));
  return [&body, &x, mode, side, seen = 0.0](const StepRule& rule) mutable {
    // The first search starts from a random direction.
    constexpr int firstProducts = 60, products = 15;
    const LowerBound lower = rayleighLowerBound(body, x, *mode, seen == 0 ? firstProducts : products, &seen);
    // Brackets from scratch are about so wide, and the rule is to be exact at the safe side.
    constexpr double width = 0.01;
    return (1 - width) * side(rule, lower);
  };
}

StepRule stepRuleAt(const Scene& scene, Body& body, double h, DampingRates rates) {
  const IntegratorInfo& info = *integratorCatalog().find(scene.method);
  if (!countsDamping(body)) return stepRule(info, scene.damping);
  countDamping(body, dampingFactor(scene.damping, h));
  const bool over = body.elementDamping() && rates == DampingRates::followed;
  return stepRuleWithDashpots(info, scene.damping, h, over ? body.elementDamping()->overcount() : 0);
}

StepRule sceneStepRule(const Scene& scene, Body& body) {
  const StepRule rule = stepRule(*integratorCatalog().find(scene.method), scene.damping);
  if (!countsDamping(body)) return rule;
  if (scene.step) return stepRuleAt(scene, body, *scene.step, DampingRates::followed);
  const StepByRule share = [&scene, step = stepOfTopMode(body, body.mesh().X)](const StepRule& own) {
    return scene.safety * step(own);
  };
  countDamping(body, 0);
  // The bracket is tight at the reference: where every element damps, the step is shorter than without.
  const double reference =
      correctedReference(scene, body, DampingRates::followed, share(rule),
                         body.elementDamping() ? referenceCorrections : 0, referenceTolerance, share);
  return stepRuleAt(scene, body, reference, DampingRates::followed);
}

ReferencedRule ruleAtOwnStep(const Scene& scene, Body& body, DampingRates rates, double tolerance,
                             const StepByRule& step) {
  const StepRule rule = stepRule(*integratorCatalog().find(scene.method), scene.damping);
  if (!countsDamping(body)) return {rule};
  countDamping(body, 0);
  double reference = step(rule);
  if (!isStep(reference)) reference = isStep(scene.end) ? scene.end : 1;  // damping alone sets the step
  reference = correctedReference(scene, body, rates, reference, ownStepCorrections, tolerance, step);
  return {stepRuleAt(scene, body, reference, rates), reference};
}

std::optional<PenaltyRoom> penaltyRoom(const Scene& scene, const Body& body, double step) {
  if (body.elementDamping()) return std::nullopt;
  const StepRule rule = stepRule(*integratorCatalog().find(scene.method), scene.damping);
  const ElementsAlone alone = elementsAlone(body);
  const std::map<std::int32_t, SurfaceLoad> loads = surfaceLoads(body);
  // The largest penalty of all contact nodes with which a step is proven; infinite without contact.
  const auto penaltyAt = [&](double h) {
    double most = infinity;
    for (const PenaltyContact& contact : body.discreteForces()->contacts())
      for (std::size_t k = 0; k < contact.nodes.size(); ++k) {
        const double mass = body.lumpedMass()[contact.nodes[k]];
        // The damping grows with the root of the penalty, as a share of the critical one.
        const double damping =
            contact.penalty[k] > 0 ? dampingOf(contact, k) / (2 * std::sqrt(contact.penalty[k] * mass)) : 0;
        most = std::min(most, penaltyFor(mass * (rule.lambdaFor(h) - alone.nodal[contact.nodes[k]]), mass, damping,
                                         dampingFactor(scene.damping, h)));
      }
    // A node of a surface is loaded by what it touches and by what touches it.
    for (const auto& [node, coefficient] : loads) {
      const double mass = body.lumpedMass()[node];
      most = std::min(most, penaltyFor(mass * (rule.lambdaFor(h) - alone.nodal[node]) / coefficient.share, mass,
                                       coefficient.damping, dampingFactor(scene.damping, h)));
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
