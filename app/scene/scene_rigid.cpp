#include <ringwatch/app/scene/scene_rigid.h>

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include <ringwatch/app/command/integrator_catalog.h>
#include <ringwatch/app/scene/scene_sections.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/sort_unique.h>
#include <ringwatch/base/user_text.h>

namespace ringwatch {
namespace {

void readRigid(const SceneTable& section, Scene& scene) {
  Scene::Rigid rigid;
  rigid.origin = section.origin + ": [[rigid]]";
  rigid.name = section.given("name") ? section.get<std::string>("name") : fmt::format("rigid {}", scene.rigids.size());
  for (const Scene::Rigid& other : scene.rigids)
    if (other.name == rigid.name)
      fail(section.given("name") ? section.at("name").origin : section.origin, "rigid.name",
           fmt::format("{} is the name of {} already; give another", inQuotes(rigid.name), other.origin));
  rigid.nodes = selectionOf(section);
  scene.rigids.push_back(std::move(rigid));
}

}  // namespace

void readRigidSections(const std::vector<SceneTable>& sections, Scene& scene) {
  for (const SceneTable& section : sections)
    if (section.name == "rigid") readRigid(section, scene);
  if (scene.rigids.empty()) return;
  const auto refuse = [&](const std::string& what) {
    throw InputError(fmt::format("{}: {}", scene.rigids.front().origin, what));
  };
  const auto takes = [](const IntegratorInfo& info) { return info.drifts; };
  if (!takes(*integratorCatalog().find(scene.method)))
    refuse(fmt::format("\"{}\" takes no rigid bodies, whose nodes do not move along straight lines; {} do",
                       scene.method, namesWhere(integratorInfos(), takes)));
  if (!scene.handler.empty()) refuse("handlers take no rigid bodies; set handler.method = \"none\"");
  if (!scene.cuts.empty()) refuse("rigid bodies do not go with [[cut]]; remove one of them");
  if (scene.certificates) refuse("certificates in files know no rigid bodies; take monitor.certificates out");
  if (scene.device == RunDevice::cuda) refuse("a GPU takes no rigid bodies; set integrator.device = \"cpu\"");
  if (scene.device == RunDevice::automatic) scene.noDevice = "a GPU takes no rigid bodies";
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
    const auto count = [&](const auto& holds, const char* what) {
      const std::size_t number = static_cast<std::size_t>(std::ranges::count_if(nodes, holds));
      if (number == 0) return;
      throw InputError(fmt::format("{}: {} of its {} nodes {}, the first is {}; change a where or set so that none has",
                                   rigid.nodes.origin, number, nodes.size(), what,
                                   body.mesh().nodeId(*std::ranges::find_if(nodes, holds))));
    };
    count([&](std::int32_t node) { return body.constraints().freeComponents(node) < 3; },
          "have a motion that a [[fix]] or [[move]] prescribes");
    count([&](std::int32_t node) { return body.constraints().isTied(node); }, "are of another [[rigid]]");
    try {
      body.tie(rigid.name, std::move(nodes));
    } catch (const InputError& fault) {
      throw InputError(fmt::format("{}: {}", rigid.nodes.origin, fault.what()));
    }
  }
}

}  // namespace ringwatch
