#include <ringwatch/app/scene/scene_rigid.h>

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include <ringwatch/app/scene/integrator_catalog.h>
#include <ringwatch/app/scene/scene_sections.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/nearest_name.h>
#include <ringwatch/base/sort_unique.h>
#include <ringwatch/base/user_text.h>

namespace ringwatch {
namespace {

/// The first of the sections that takes a rigid body.
template <class Sections>
auto* takerOf(const std::string& body, Sections& sections) {
  const auto found =
      std::ranges::find_if(sections, [&](const auto& one) { return one.guide && one.guide->body == body; });
  return found == sections.end() ? nullptr : &*found;
}

/// What is prescribed of a rigid body of the scene, as at the start; a motion whose factor is 0 there has its velocity
/// without the factor.
RigidGuide guideOfBody(const Scene& scene, const std::string& name) {
  RigidGuide guide;
  const auto take = [&](const auto& section) {
    const Scene::Guide& own = *section.guide;
    guide.components = section.components;
    guide.turning = !own.turns           ? RigidGuide::Turning::prescribed
                    : own.axis.isZero(0) ? RigidGuide::Turning::free
                                         : RigidGuide::Turning::aboutAxis;
    guide.axis = own.axis;
    guide.point = own.point;
  };
  if (const Scene::Fix* fix = takerOf(name, scene.fixes)) take(*fix);
  if (const Scene::Move* move = takerOf(name, scene.moves)) {
    take(*move);
    for (int c = 0; c < 3; ++c)
      if (guide.components[static_cast<std::size_t>(c)])
        guide.velocity[c] = (move->way ? *move->way : move->velocity)[c];
    guide.angularVelocity = move->angularVelocity;
  }
  return guide;
}

}  // namespace

std::optional<Scene::Guide> guideOf(const SceneTable& section, const std::array<bool, 3>& components,
                                    const Scene& scene, NodeSelection& nodes) {
  const auto refuse = [&](const char* key, const std::string& what) {
    fail(section.given(key) ? section.at(key).origin : section.origin, section.name + "." + key, what);
  };
  const bool moves = section.name == "move", rotates = moves && section.given("angular_velocity");
  if (!section.given("rigid")) {
    for (const char* key : {"turns", "axis"})
      if (section.given(key)) refuse(key, "goes with rigid, which names a [[rigid]]");
    if (!moves && section.given("point")) refuse("point", "goes with rigid and turns = true");
    return std::nullopt;
  }
  Scene::Guide guide;
  const Scene::Rigid& body = scene.rigids[positionOf(section, "rigid", scene.rigids)];
  guide.body = body.name;
  const auto* fix = takerOf(guide.body, scene.fixes);
  const auto* move = takerOf(guide.body, scene.moves);
  if (fix || move)
    refuse("rigid", fmt::format("{} is held or moved by {} already; put both into one", inQuotes(guide.body),
                                fix ? fix->nodes.origin : move->nodes.origin));
  guide.turns = section.get<bool>("turns");
  if (guide.turns && rotates) refuse("turns", "the body turns as angular_velocity says; take one of them out");
  if (section.given("axis")) {
    if (!guide.turns) refuse("axis", "goes with turns = true");
    guide.axis = vectorOf(section.at("axis").value);
    if (guide.axis.isZero(0)) refuse("axis", "has no direction; must not be zero");
  }
  const bool holdsPoint = components[0] && components[1] && components[2];
  if (section.given("point")) {
    if (!guide.turns && !rotates)
      refuse("point", moves ? "goes with turns = true or angular_velocity" : "goes with turns = true");
    if (!holdsPoint)
      refuse("point", "goes with all three components; with some of them the point is the centre of mass");
    if (guide.turns && moves)
      refuse("point", "what turns about a moving point turns about its centre of mass; take it out");
    guide.point = vectorOf(section.at("point").value);
  } else if (rotates && holdsPoint) {
    guide.point = vectorOf(section.at("point").value);  // as of nodes that turn
  }
  nodes = body.nodes;
  nodes.origin = section.where("rigid");
  return guide;
}

void splitRigidBlocks(const Scene& scene, Mesh& mesh, std::vector<Material>& materials) {
  if (scene.rigids.empty()) return;
  constexpr int none = -1;
  std::vector<int> bodyOf(mesh.nodeCount(), none);
  for (std::size_t r = 0; r < scene.rigids.size(); ++r)
    for (const std::int32_t node : scene.rigids[r].nodes.nodesOf(mesh)) bodyOf[node] = static_cast<int>(r);
  ElementNumbers within;
  bool any = false, all = true;
  for (const MeshBlock& block : mesh.blocks) {
    std::vector<int>& own = within.emplace_back(block.elementCount(), 0);
    for (std::size_t e = 0; e < own.size(); ++e) {
      const int first = bodyOf[*block.element(e)];
      own[e] = first != none && std::all_of(block.element(e), block.element(e) + block.nodesPerElement(),
                                            [&](std::int32_t node) { return bodyOf[node] == first; });
      any = any || own[e] != 0;
      all = all && own[e] != 0;
    }
  }
  if (!any) return;
  if (all)
    throw InputError(fmt::format("{}: every element is within a rigid body; leave nodes out that can be deformed",
                                 scene.rigids.front().origin));
  const std::vector<std::size_t> before = splitMeshBlocks(mesh, within, 2);
  if (materials.size() == 1) return;
  std::vector<Material> ofBlocks;
  for (const std::size_t b : before) ofBlocks.push_back(materials[b]);
  materials = std::move(ofBlocks);
}

void tieRigidBodies(const Scene& scene, Body& body) {
  for (const Scene::Rigid& rigid : scene.rigids) {
    std::vector<std::int32_t> nodes = rigid.nodes.nodesOf(body.mesh());
    sortUnique(nodes);
    const auto count = [&](const auto& holds, const char* what, const char* mend) {
      const std::size_t number = static_cast<std::size_t>(std::ranges::count_if(nodes, holds));
      if (number == 0) return;
      throw InputError(fmt::format("{}: {} of its {} nodes {}, the first is {}; {}", rigid.nodes.origin, number,
                                   nodes.size(), what, body.mesh().nodeId(*std::ranges::find_if(nodes, holds)), mend));
    };
    const RigidGuide guide = guideOfBody(scene, rigid.name);
    if (!guide.all())
      count([&](std::int32_t node) { return body.constraints().freeComponents(node) < 3; },
            "have a motion that a [[fix]] or [[move]] prescribes",
            "change a where or set so that none has, or hold or move the body itself by rigid = in place of where");
    count([&](std::int32_t node) { return body.constraints().isTied(node); }, "are of another [[rigid]]",
          "change a where or set so that none is");
    try {
      body.tie(rigid.name, std::move(nodes), guide);
    } catch (const InputError& fault) {
      throw InputError(fmt::format("{}: {}", rigid.nodes.origin, fault.what()));
    }
    if (const Scene::Move* move = takerOf(rigid.name, scene.moves); move && !guide.all())
      body.constraints().guide(rigid.name, move->velocityAtStart(move->point),
                               (move->table ? move->table->at(0) : 1) * move->angularVelocity);
  }
}

}  // namespace ringwatch
