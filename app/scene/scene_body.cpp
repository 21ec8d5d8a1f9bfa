#include <ringwatch/app/scene/scene.h>

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include <ringwatch/app/scene/mjcf_model.h>
#include <ringwatch/app/scene/number_text.h>
#include <ringwatch/app/scene/scene_damping.h>
#include <ringwatch/app/scene/scene_discrete.h>
#include <ringwatch/app/scene/scene_mesh.h>
#include <ringwatch/app/scene/scene_pressure.h>
#include <ringwatch/app/scene/scene_rigid.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/nearest_name.h>
#include <ringwatch/base/parallel.h>
#include <ringwatch/base/sort_unique.h>
#include <ringwatch/base/user_text.h>
#include <ringwatch/meshes/formats/mesh_readers.h>
#include <ringwatch/meshes/mesh_io.h>
#include <ringwatch/meshes/node_order.h>
#include <ringwatch/meshes/number_index.h>

namespace ringwatch {
namespace {

/// What the [[fix]] and [[move]] of a scene prescribe at each component of each node. Two that ask for different
/// velocities at one of them are refused.
class PrescribedMotions {
 public:
  explicit PrescribedMotions(std::int32_t nodes) : by_(3 * static_cast<std::size_t>(nodes), -1) {}

  void add(const std::string& origin, const std::vector<std::int32_t>& nodes, const std::array<bool, 3>& components,
           const Eigen::Vector3d& velocity, const std::optional<TimeTable>& table = {}, std::string_view kind = "") {
    const std::int32_t own = all_.size();
    all_.push_back({origin, velocity, table, kind});
    std::map<std::int32_t, std::pair<std::size_t, int>> conflicts;  // of an earlier one: shared nodes, first component
    for (const std::int32_t node : nodes) {
      std::int32_t counted = -1;
      for (int c = 0; c < 3; ++c) {
        if (!components[c]) continue;
        std::int32_t& by = by_[3 * static_cast<std::size_t>(node) + static_cast<std::size_t>(c)];
        if (by < 0) {
          by = own;
        } else if ((!kind.empty() || !all_[by].kind.empty() || all_[by].velocity[c] != velocity[c] ||
                    (velocity[c] != 0 && all_[by].table != table)) &&
                   by != counted) {
          conflicts.try_emplace(by, 0, c).first->second.first += 1;
          counted = by;
        }
      }
    }
    if (conflicts.empty()) return;
    const auto& [other, shared] = *conflicts.begin();
    const auto& [count, c] = shared;
    if (!kind.empty() || !all_[other].kind.empty())
      throw InputError(
          fmt::format("{}: {} and {} prescribe the motion of {} node{} of both along {}; change a condition "
                      "or components so that no node has two",
                      origin, kind.empty() ? "it" : kind, all_[other].origin, count, count == 1 ? "" : "s", "xyz"[c]));
    throw InputError(fmt::format(
        "{}: it prescribes another velocity than {} at {} node{} of both ({} and {} m/s along {}); change "
        "a condition or "
        "components so that no node has two",
        origin, all_[other].origin, count, count == 1 ? "" : "s", velocity[c], all_[other].velocity[c], "xyz"[c]));
  }

 private:
  struct Motion {
    std::string origin;
    Eigen::Vector3d velocity;  // m/s
    std::optional<TimeTable> table;
    std::string_view kind;  // what it is beside a velocity; "" for nothing
  };
  std::vector<Motion> all_;
  std::vector<std::int32_t> by_;  // [node][component]: which of all_; -1: none
};

}  // namespace

std::vector<std::int64_t> NodeSelection::numbers() const {
  if (where || !set.starts_with("#")) return {};
  return numbersOfSelection(set, "nodes", origin);
}

InputError NodeSelection::noSuchNode(std::int64_t number) const {
  return InputError(fmt::format("{}: the mesh has no node {}", origin, number));
}

std::vector<std::int32_t> NodeSelection::nodesIn(const Mesh& part) const {
  std::vector<std::int32_t> nodes;
  if (!where && set.starts_with("#")) {
    const std::vector<std::int64_t> wanted = numbers();
    constexpr std::size_t few = 16;  // for which a look at every node is quicker than an index
    if (wanted.size() <= few) {
      for (std::int32_t i = 0; i < static_cast<std::int32_t>(part.nodeCount()); ++i)
        if (std::ranges::find(wanted, part.nodeId(i)) != wanted.end()) nodes.push_back(i);
      return nodes;
    }
    NumberIndex index(part);
    for (const std::int64_t number : wanted)
      if (const auto node = index.node(number)) nodes.push_back(*node);
    sortUnique(nodes);
    return nodes;
  }
  if (!where) {
    const auto found = part.nodeSets.find(set);
    if (found != part.nodeSets.end()) return found->second;
    std::vector<std::string> known;
    for (const auto& entry : part.nodeSets) known.push_back(entry.first);
    if (part.elementSets.count(set) != 0)
      throw InputError(fmt::format("{}: {} is a set of elements, and nodes are selected here; {}", origin,
                                   inQuotes(set),
                                   known.empty() ? "select them by a condition on their position"
                                                 : "the mesh has the node sets " + shortList(known)));
    throw InputError(known.empty()
                         ? fmt::format("{}: unknown node set {}; the mesh has no named sets", origin, inQuotes(set))
                         : fmt::format("{}: unknown node set {}; {}the mesh has {}", origin, inQuotes(set),
                                       didYouMean(set, known), shortList(known)));
  }
  try {
    for (Eigen::Index i = 0; i < part.X.cols(); ++i)
      if (where->holdsAt(part.X.col(i))) nodes.push_back(static_cast<std::int32_t>(i));
  } catch (const InputError& fault) {
    throw InputError(fmt::format("{}: {}", origin, fault.what()));
  }
  return nodes;
}

void NodeSelection::requireSome(std::int64_t count, const Eigen::Vector3d& low, const Eigen::Vector3d& high) const {
  if (count > 0) return;
  if (!where) throw InputError(fmt::format("{}: the node set {} is empty", origin, inQuotes(set)));
  throw InputError(fmt::format("{}: {} selects no node; the mesh lies in {} <= x <= {}, {} <= y <= {}, {} <= z <= {}",
                               origin, inQuotes(where->text()), low[0], high[0], low[1], high[1], low[2], high[2]));
}

std::vector<std::int32_t> NodeSelection::nodesOf(const Mesh& mesh) const {
  std::vector<std::int32_t> nodes = nodesIn(mesh);
  std::vector<std::int64_t> found;
  for (const std::int32_t node : nodes) found.push_back(mesh.nodeId(node));
  std::sort(found.begin(), found.end());
  for (const std::int64_t number : numbers())
    if (!std::binary_search(found.begin(), found.end(), number)) throw noSuchNode(number);
  if (nodes.empty()) requireSome(0, mesh.X.rowwise().minCoeff(), mesh.X.rowwise().maxCoeff());
  return nodes;
}

int threadsThatPay(int requested, const Mesh& mesh) {
  constexpr std::size_t elementsPerThread = 4000;
  if (requested > 0) return requested;
  return std::min(threadCount(0),
                  static_cast<int>(std::min<std::size_t>(1 + mesh.elementCount() / elementsPerThread, 1 << 20)));
}

Mesh sceneMesh(const Scene& scene, std::vector<std::string>& notes) {
  if (scene.generator.empty()) {
    try {
      std::vector<std::string> read;
      const bool flexes = isMjcfFile(scene.meshFile);
      if (flexes && scene.repair) throw InputError("mesh.repair: flexes are as MuJoCo makes them; leave it out");
      Mesh mesh = flexes ? meshOfFlexes(readFlexModel(scene.meshFile)) : loadMesh(scene.meshFile, &read, scene.repair);
      // What a deck holds beside its mesh has become the scene.
      if (scene.ofModel)
        std::erase_if(read, [](const std::string& note) { return note.find(detail::deckSkippedNote) != note.npos; });
      notes.insert(notes.end(), scene.notes.begin(), scene.notes.end());
      notes.insert(notes.end(), read.begin(), read.end());
      renumberNodes(mesh);  // a mesher's order may cost a fifth of every step
      return mesh;
    } catch (const InputError& fault) {
      if (scene.ofModel) throw;  // it names the file
      throw InputError(fmt::format("{}: {}", scene.meshOrigin, fault.what()));
    }
  }
  try {
    return generateMesh(scene.generator, generatorArguments(scene.generatorArguments));
  } catch (const InputError& fault) {
    throw InputError(fmt::format("{}: {}", scene.meshOrigin, fault.what()));
  }
}

std::vector<Eigen::Vector3d> nodalForces(const Scene::Force& force, const std::vector<std::int32_t>& nodes,
                                         const Body& body) {
  if (force.each) return std::vector<Eigen::Vector3d>(nodes.size(), *force.each);
  double mass = 0;
  for (std::int32_t node : nodes) mass += body.lumpedMass()[node];
  const Eigen::Vector3d acceleration = force.acceleration ? *force.acceleration : Eigen::Vector3d(*force.total / mass);
  std::vector<Eigen::Vector3d> forces;
  forces.reserve(nodes.size());
  for (std::int32_t node : nodes) forces.emplace_back(body.lumpedMass()[node] * acceleration);
  return forces;
}

Body sceneBody(const Scene& scene, Mesh mesh, int threads, MaterialsBy by) {
  BodyOptions options;
  options.lumping = scene.lumping;
  options.hourglassControl = scene.hourglassControl;
  options.threads = threadsThatPay(threads, mesh);
  std::vector<Material> materials = assignMaterials(scene.materials, mesh, by);
  splitRigidBlocks(scene, mesh, materials);
  for (const SceneMaterial* material : blockMaterials(scene.materials, mesh))
    options.rulesOfBlock.push_back(material->rules);
  std::optional<Body> body;
  try {
    body.emplace(std::move(mesh), materials, options);
  } catch (const NumericalError& fault) {
    throw InputError(fmt::format("{}: {}", scene.meshOrigin, fault.what()));  // the mesh is what the user can mend
  }
  addPointMasses(scene, *body);
  PrescribedMotions prescribed(body->nodeCount());
  for (const Scene::Fix& fix : scene.fixes) {
    if (Scene::guides(fix)) continue;  // tieRigidBodies has them
    const std::vector<std::int32_t> nodes = fix.nodes.nodesOf(body->mesh());
    prescribed.add(fix.nodes.origin, nodes, fix.components, Eigen::Vector3d::Zero());
    for (std::int32_t node : nodes)
      for (int c = 0; c < 3; ++c)
        if (fix.components[c]) body->constraints().fix(node, c);
  }
  for (const Scene::Move& move : scene.moves) {
    if (Scene::guides(move)) continue;
    const std::vector<std::int32_t> nodes = move.nodes.nodesOf(body->mesh());
    prescribed.add(move.nodes.origin, nodes, move.components, move.velocity, move.table,
                   move.rotates() ? "a rotation"
                   : move.way     ? "a displacement"
                                  : "");
    for (std::int32_t node : nodes) {
      const Eigen::Vector3d start = move.velocityAtStart(body->mesh().X.col(node));
      for (int c = 0; c < 3; ++c) {
        if (!move.components[c]) continue;
        // Its factor may be 0 at the start: it is a motion.
        body->constraints().move(node, c, move.rotates() ? 1 : move.way ? (*move.way)[c] : move.velocity[c]);
        body->constraints().move(node, c, start[c]);
      }
    }
  }
  tieRigidBodies(scene, *body);
  addElementDamping(scene, *body);
  for (const Scene::Force& force : scene.forces) {
    const std::vector<std::int32_t> nodes = force.nodes.nodesOf(body->mesh());
    if (force.table) continue;  // a run sets them at each of its times
    const std::vector<Eigen::Vector3d> forces = nodalForces(force, nodes, *body);
    for (std::size_t i = 0; i < nodes.size(); ++i) body->externalForce().col(nodes[i]) += forces[i];
  }
  for (const Scene::Initial& initial : scene.initials)
    initial.nodes.nodesOf(body->mesh());  // throws before a run begins
  for (const Scene::Pressure& pressure : scene.pressures) pressedFaces(pressure, body->mesh());  // likewise
  addDiscreteForces(scene, *body);
  return std::move(*body);
}

}  // namespace ringwatch
