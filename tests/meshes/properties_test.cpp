#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>  // needs gtest.h before it

#include <map>
#include <set>

#include <ringwatch/meshes/adjacency.h>
#include <ringwatch/meshes/check.h>
#include <ringwatch/meshes/generators/generators.h>
#include <ringwatch/meshes/mesh_io.h>
#include <ringwatch/meshes/modify/repair.h>
#include <ringwatch/meshes/quality.h>

#include "tests/meshes/mesh_test_tools.h"

namespace ringwatch {
namespace {

using namespace test;

BarOptions anyBar() {
  BarOptions o;
  for (std::size_t k = 0; k < 3; ++k) {
    o.cells[k] = *rc::gen::inRange(1, 5);
    o.size[k] = *rc::gen::inRange(1, 100) * 1e-2;
  }
  const auto splits = allCellSubdivisions();
  const CellSubdivision& split = splits[*rc::gen::inRange<std::size_t>(0, splits.size())];
  o.element = split.element;
  o.split = split.elementsPerCell;
  o.jitter = *rc::gen::inRange(0, 12) * 1e-2;
  o.seed = *rc::gen::arbitrary<std::uint64_t>();
  o.grading = 1 + *rc::gen::inRange(0, 30) * 0.1;
  return o;
}

RC_GTEST_PROP(MeshProperties, EveryBarIsSoundAndOfTheRightVolume, ()) {
  const BarOptions o = anyBar();
  const Mesh mesh = generateBar(o);
  const double volume = o.size[0] * o.size[1] * o.size[2];
  RC_ASSERT(std::abs(meshVolume(mesh) - volume) <= 1e-13 * volume);
  RC_ASSERT(checkMesh(mesh).empty());
  RC_ASSERT(faceNeighbours(mesh).overfull.empty());
}

RC_GTEST_PROP(MeshProperties, MshRoundTripsToTheLastBit, ()) {
  const TemporaryFolder folder;
  Mesh mesh = generateBar(anyBar());
  mesh.elementSets["some"] = {{0, 0}};
  for (const MeshFormat format : {MeshFormat::msh41, MeshFormat::msh41Binary}) {
    writeMesh(mesh, folder / "m.msh", format);
    expectSame(mesh, loadMesh(folder / "m.msh"), false);
  }
  // Version 2.2 keeps one set an element.
  Mesh one = mesh;
  one.elementSets.erase("some");
  for (const MeshFormat format : {MeshFormat::msh22, MeshFormat::msh22Binary}) {
    writeMesh(one, folder / "m.msh", format);
    expectSame(one, loadMesh(folder / "m.msh"), false);
  }
}

RC_GTEST_PROP(MeshProperties, MirroringIsFoundAndUndone, ()) {
  Mesh mesh = generateBar(anyBar());
  const double volume = meshVolume(mesh);
  mesh.X.row(*rc::gen::inRange(0, 3)) *= -1;
  std::vector<std::string> notes;
  requireSound(mesh, "m", &notes);
  RC_ASSERT(notes.size() == 1u);
  RC_ASSERT(std::abs(meshVolume(mesh) - volume) <= 1e-13 * volume);
}

/// An element apart from its block, which can be damaged.
struct LooseElement {
  ElementType type;
  std::vector<std::int32_t> nodes;
  std::int64_t id;
  std::set<std::string> sets;
};

std::vector<LooseElement> takenApart(const Mesh& mesh) {
  std::vector<LooseElement> elements;
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b)
    for (std::size_t e = 0; e < mesh.blocks[b].elementCount(); ++e) {
      const std::int32_t* const nodes = mesh.blocks[b].element(e);
      elements.push_back({mesh.blocks[b].type,
                          {nodes, nodes + mesh.blocks[b].nodesPerElement()},
                          static_cast<std::int64_t>(elements.size()),
                          {}});
      for (const auto& [name, members] : mesh.elementSets)
        if (std::ranges::find(members, ElementRef(b, e)) != members.end()) elements.back().sets.insert(name);
    }
  return elements;
}

Mesh putTogether(const Mesh& nodes, const std::vector<LooseElement>& elements) {
  Mesh mesh = nodes;
  mesh.blocks.clear();
  mesh.elementSets.clear();
  for (const LooseElement& element : elements) {
    auto block = std::ranges::find(mesh.blocks, element.type, &MeshBlock::type);
    if (block == mesh.blocks.end()) block = mesh.blocks.insert(block, {element.type, {}, {}});
    for (const std::string& name : element.sets)
      mesh.elementSets[name].push_back({block - mesh.blocks.begin(), block->ids.size()});
    block->connectivity.insert(block->connectivity.end(), element.nodes.begin(), element.nodes.end());
    block->ids.push_back(element.id);
  }
  return mesh;
}

/// The element of the same nodes with the other handedness.
void mirror(LooseElement& element) {
  const std::map<std::string_view, std::vector<std::pair<int, int>>> exchanged{
      {"tet4", {{0, 1}}},
      {"pyramid5", {{1, 3}}},
      {"wedge6", {{1, 2}, {4, 5}}},
      {"hex8", {{0, 1}, {3, 2}, {4, 5}, {7, 6}}},
      {"tet10", {{0, 1}, {5, 6}, {7, 8}}},
      {"hex20", {{0, 1}, {3, 2}, {4, 5}, {7, 6}, {9, 11}, {13, 15}, {16, 17}, {18, 19}}}};
  for (const auto& [a, b] : exchanged.at(elementInfo(element.type).name)) std::swap(element.nodes[a], element.nodes[b]);
}

/// The hexahedron with repeated nodes that a deck writes for the element; other elements stay.
void asHexahedron(LooseElement& element) {
  const std::map<std::string_view, std::vector<int>> places{
      {"tet4", {0, 1, 2, 2, 3, 3, 3, 3}}, {"pyramid5", {0, 1, 2, 3, 4, 4, 4, 4}}, {"wedge6", {0, 1, 2, 2, 3, 4, 5, 5}}};
  const auto own = places.find(elementInfo(element.type).name);
  if (own == places.end()) return;
  std::vector<std::int32_t> nodes;
  for (const int place : own->second) nodes.push_back(element.nodes[place]);
  element.type = elementTypeOf<Hex8>;
  element.nodes = std::move(nodes);
}

std::map<std::int64_t, std::pair<ElementType, std::set<std::string>>> kindsAndSets(
    const std::vector<LooseElement>& elements, const Mesh& mesh) {
  std::map<std::int64_t, std::pair<ElementType, std::set<std::string>>> found;
  std::size_t at = 0;
  for (const MeshBlock& block : mesh.blocks)
    for (std::size_t e = 0; e < block.elementCount(); ++e, ++at)
      found[block.id(e)] = {elements[at].type, elements[at].sets};
  return found;
}

// A good mesh with elements mirrored, written as hexahedra, standing twice and split off from their neighbours, and
// with another order of nodes on edges: repaired, it has the volume, the elements, the sets and the joints of the good
// one.
RC_GTEST_PROP(MeshProperties, ADamagedMeshIsRepaired, ()) {
  Mesh good = generateBar(anyBar());
  std::vector<LooseElement> elements = takenApart(good);
  for (LooseElement& element : elements)
    if (*rc::gen::arbitrary<bool>()) element.sets.insert("some");
  good = putTogether(good, elements);
  const std::map before = kindsAndSets(elements, good);

  const double size = (good.X.rowwise().maxCoeff() - good.X.rowwise().minCoeff()).norm(), gap = 1e-8 * size;
  const ElementInfo& quadratic = elementInfo(elements.front().type);
  const bool otherOrder = !quadratic.gmshOrder.empty() && quadratic.order == 2 && *rc::gen::arbitrary<bool>();
  Mesh nodes = good;
  std::vector<LooseElement> doubles;
  std::map<std::int64_t, std::set<std::string>> added;
  for (LooseElement& element : elements) {
    const auto oneIn = [](int chances) { return *rc::gen::inRange(0, chances) == 0; };
    if (oneIn(4)) {
      doubles.push_back(element);
      doubles.back().sets = {"doubles"};
      added[element.id] = {"doubles"};
      if (oneIn(2)) mirror(doubles.back());
    }
    if (oneIn(3)) mirror(element);
    if (oneIn(3)) asHexahedron(element);
    if (oneIn(3)) {  // has nodes of its own, each where the common one is, up to the gap
      std::map<std::int32_t, std::int32_t> own;
      for (std::int32_t& node : element.nodes) {
        const auto [copy, isNew] = own.try_emplace(node, static_cast<std::int32_t>(nodes.X.cols()));
        if (isNew) {
          nodes.X.conservativeResize(3, nodes.X.cols() + 1);
          nodes.X.rightCols(1) = good.X.col(node) + Eigen::Vector3d(0.3, -0.2, 0.1) * gap * *rc::gen::inRange(-1, 2);
        }
        node = copy->second;
      }
    }
  }
  elements.insert(elements.end(), doubles.begin(), doubles.end());
  if (otherOrder)
    for (LooseElement& element : elements) {
      const std::vector<std::int32_t> ours = element.nodes;
      for (std::size_t a = 0; a < ours.size(); ++a) element.nodes[quadratic.gmshOrder[a]] = ours[a];
    }
  nodes.nodeIds.clear();
  const Mesh damaged = putTogether(nodes, elements);

  const RepairedMesh repaired = repairMesh(damaged, "m", gap);
  RC_ASSERT(repaired.problems.empty());
  RC_ASSERT(repaired.mesh.nodeCount() == good.nodeCount());
  RC_ASSERT(std::abs(meshVolume(repaired.mesh) - meshVolume(good)) <= 1e-5 * meshVolume(good));
  RC_ASSERT(std::abs(boundaryArea(repaired.mesh) - boundaryArea(good)) <= 1e-5 * boundaryArea(good));
  std::map expected = before;
  for (const auto& [id, sets] : added) expected[id].second.insert(sets.begin(), sets.end());
  RC_ASSERT(kindsAndSets(takenApart(repaired.mesh), repaired.mesh) == expected);
  RC_ASSERT(repaired.mesh.nodeSets.size() == good.nodeSets.size());
  for (const auto& [name, members] : good.nodeSets) {
    const std::vector<std::int32_t>& now = repaired.mesh.nodeSets.at(name);
    RC_ASSERT(now.size() == members.size());
    for (const std::int32_t n : members)
      RC_ASSERT(std::ranges::any_of(
          now, [&](std::int32_t m) { return (repaired.mesh.X.col(m) - good.X.col(n)).norm() <= gap; }));
  }
}

RC_GTEST_PROP(MeshProperties, RandomBytesAfterAGoodStartNeverCrash, ()) {
  const TemporaryFolder folder;
  const auto tail =
      *rc::gen::container<std::string>(rc::gen::elementOf(std::string("0123456789.-e \n$\"\0\xFF"
                                                                      "abcNE",
                                                                      24)));
  for (const char* start : {"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n", "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n",
                            "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n"}) {
    writeBytes(folder / "m.msh", start + tail);
    RC_ASSERT_THROWS_AS(readMesh(folder / "m.msh"), InputError);
  }
}

}  // namespace
}  // namespace ringwatch
