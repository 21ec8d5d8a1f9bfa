#include <ringwatch/app/scene/scene_materials.h>

#include <algorithm>
#include <cstdint>

#include <fmt/format.h>

#include <ringwatch/app/scene/number_text.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/base/nearest_name.h>
#include <ringwatch/base/sort_unique.h>
#include <ringwatch/base/user_text.h>
#include <ringwatch/meshes/number_index.h>

namespace ringwatch {
namespace {

constexpr int none = -1;

/// The element set of material number `number`; `--set material.N.key` counts alike.
std::string setOfMaterial(std::size_t number) { return fmt::format("material.{}", number); }

Eigen::Vector3d centreOf(const Mesh& mesh, ElementRef e) {
  const MeshBlock& block = mesh.blocks[e.block];
  const std::int32_t* nodes = block.element(e.element);
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for (int a = 0; a < block.nodesPerElement(); ++a) centre += mesh.X.col(nodes[a]);
  return centre / block.nodesPerElement();
}

template <class Visit>
void forEachElement(const Mesh& mesh, const Visit& visit) {
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b)
    for (std::size_t e = 0; e < mesh.blocks[b].elementCount(); ++e) visit(ElementRef{b, e});
}

std::vector<ElementRef> elementsOfSet(const std::string& set, const Mesh& mesh, const std::string& origin) {
  const auto found = mesh.elementSets.find(set);
  if (found != mesh.elementSets.end() && !found->second.empty()) return found->second;
  if (found == mesh.elementSets.end() && set.starts_with("#")) {
    std::vector<ElementRef> elements;
    NumberIndex index(mesh);
    for (const std::int64_t number : numbersOfSelection(set, "elements", origin)) {
      const auto element = index.element(number);
      if (!element) throw InputError(fmt::format("{}: the mesh has no element {}", origin, number));
      elements.push_back(*element);
    }
    sortUnique(elements);
    return elements;
  }
  if (found != mesh.elementSets.end())
    throw InputError(fmt::format("{}: the element set {} is empty", origin, inQuotes(set)));
  std::vector<std::string> known;
  for (const auto& entry : mesh.elementSets) known.push_back(entry.first);
  if (mesh.nodeSets.count(set) != 0)
    throw InputError(fmt::format("{}: {} is a set of nodes, and elements are selected here; {}", origin, inQuotes(set),
                                 known.empty() ? "select them by a condition on their centre, where"
                                               : "the mesh has the element sets " + shortList(known)));
  throw InputError(known.empty() ? fmt::format("{}: unknown element set {}; the mesh has no named sets of elements",
                                               origin, inQuotes(set))
                                 : fmt::format("{}: unknown element set {}; {}the mesh has {}", origin, inQuotes(set),
                                               didYouMean(set, known), shortList(known)));
}

std::string elementName(const Mesh& mesh, ElementRef e) {
  const MeshBlock& block = mesh.blocks[e.block];
  const Eigen::Vector3d centre = centreOf(mesh, e);
  return fmt::format("{} {} at ({:.6g}, {:.6g}, {:.6g})", elementInfo(block.type).name, block.id(e.element), centre[0],
                     centre[1], centre[2]);
}

ElementNumbers numbersByScene(const std::vector<SceneMaterial>& materials, const Mesh& mesh) {
  ElementNumbers numbers;
  for (const MeshBlock& block : mesh.blocks) numbers.emplace_back(block.elementCount(), none);
  for (std::size_t m = 0; m < materials.size(); ++m) {
    std::size_t taken = 0;
    std::optional<ElementRef> first;
    int other = none;
    for (const ElementRef e :
         selectedElements(mesh, materials[m].where, materials[m].set, materials[m].selectionOrigin)) {
      int& number = numbers[e.block][e.element];
      if (number != none && number != static_cast<int>(m)) {
        if (!first) first = e, other = number;
        ++taken;
      }
      number = static_cast<int>(m);
    }
    if (taken > 0)
      throw InputError(fmt::format(
          "{}: {} element{} {} a material already, the first is {}, by {}; change a where or set so that each has one",
          materials[m].origin, taken, taken == 1 ? "" : "s", taken == 1 ? "has" : "have", elementName(mesh, *first),
          materials[other].origin));
  }
  std::size_t without = 0;
  std::optional<ElementRef> first;
  forEachElement(mesh, [&](ElementRef e) {
    if (numbers[e.block][e.element] != none) return;
    if (!first) first = e;
    ++without;
  });
  if (without > 0)
    throw InputError(
        fmt::format("{}: {} of {} elements {} no material, the first is {}; add a [[material]] with where "
                    "or set for them",
                    materials.back().origin, without, mesh.elementCount(), without == 1 ? "has" : "have",
                    elementName(mesh, *first)));
  return numbers;
}

ElementNumbers numbersByMesh(const std::vector<SceneMaterial>& materials, const Mesh& mesh) {
  ElementNumbers numbers;
  for (const MeshBlock& block : mesh.blocks) numbers.emplace_back(block.elementCount(), none);
  std::size_t known = 0;
  for (std::size_t m = 0; m < materials.size(); ++m)
    if (const auto set = mesh.elementSets.find(setOfMaterial(m)); set != mesh.elementSets.end())
      for (const ElementRef e : set->second) {
        numbers[e.block][e.element] = static_cast<int>(m);
        ++known;
      }
  if (known != mesh.elementCount())
    throw InputError(
        fmt::format("{}: the mesh has no materials of this scene: its element sets material.0 to "
                    "material.{} name {} of {} elements",
                    materials.back().origin, materials.size() - 1, known, mesh.elementCount()));
  return numbers;
}

/// Makes blocks of one number each, in the order of the blocks before and of the numbers; element sets follow. Returns
/// the number of each block, and which it was before.
struct SplitBlocks {
  std::vector<int> numbers;
  std::vector<std::size_t> before;
};
SplitBlocks splitBlocks(Mesh& mesh, const ElementNumbers& numbers, int count) {
  SplitBlocks split;
  std::vector<MeshBlock> blocks;
  std::vector<std::vector<ElementRef>> newPlace;  // [block][element] before
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
    const MeshBlock& from = mesh.blocks[b];
    auto& places = newPlace.emplace_back(from.elementCount());
    for (int m = 0; m < count; ++m) {
      MeshBlock part{from.type, {}, {}};
      for (std::size_t e = 0; e < from.elementCount(); ++e) {
        if (numbers[b][e] != m) continue;
        places[e] = {static_cast<std::int32_t>(blocks.size()), static_cast<std::int32_t>(part.ids.size())};
        part.ids.push_back(from.id(e));
        part.connectivity.insert(part.connectivity.end(), from.element(e), from.element(e) + from.nodesPerElement());
      }
      if (part.ids.empty()) continue;
      blocks.push_back(std::move(part));
      split.numbers.push_back(m);
      split.before.push_back(b);
    }
  }
  mesh.blocks = std::move(blocks);
  for (auto& [name, elements] : mesh.elementSets) {
    for (ElementRef& e : elements) e = newPlace[e.block][e.element];
    std::sort(elements.begin(), elements.end());
  }
  return split;
}

}  // namespace

std::vector<std::size_t> splitMeshBlocks(Mesh& mesh, const ElementNumbers& numbers, int count) {
  return splitBlocks(mesh, numbers, count).before;
}

bool SceneMaterial::hasUniformStrain() const {
  return std::ranges::any_of(
      rules, [](const auto& rule) { return findRule(*findElementByName(rule.first), rule.second)->uniformStrain; });
}

std::string SceneMaterial::selection() const {
  if (!set.empty()) return "set:" + set;
  return where ? where->text() : "all";
}

std::string missingConstants(std::string_view model, const Options& parameters, const std::optional<double>& density) {
  std::vector<std::string> missing;
  for (const OptionInfo& parameter : lawNamed(model).parameters)
    if (parameter.fallback.empty() && !parameters.find(parameter.name))
      missing.push_back(fmt::format("--{}", parameter.name));
  if (!density) missing.emplace_back("--density");
  return missing.empty() ? "" : fmt::format("{} {} required", listed(missing), missing.size() > 1 ? "are" : "is");
}

std::string modelsText(const std::vector<SceneMaterial>& materials) {
  std::vector<std::string> models;
  for (const SceneMaterial& material : materials)
    if (std::find(models.begin(), models.end(), material.model) == models.end()) models.push_back(material.model);
  return fmt::format("{}", fmt::join(models, ", "));
}

std::vector<ElementRef> selectedElements(const Mesh& mesh, const std::optional<WhereExpression>& where,
                                         const std::string& set, const std::string& origin) {
  std::vector<ElementRef> elements;
  if (!set.empty()) return elementsOfSet(set, mesh, origin);
  if (!where) {
    forEachElement(mesh, [&](ElementRef e) { elements.push_back(e); });
    return elements;
  }
  Eigen::Vector3d low = Eigen::Vector3d::Constant(infinity), high = -low;
  try {
    forEachElement(mesh, [&](ElementRef e) {
      const Eigen::Vector3d centre = centreOf(mesh, e);
      low = low.cwiseMin(centre);
      high = high.cwiseMax(centre);
      if (where->holdsAt(centre)) elements.push_back(e);
    });
  } catch (const InputError& fault) {
    throw InputError(fmt::format("{}: {}", origin, fault.what()));
  }
  if (elements.empty())
    throw InputError(fmt::format(
        "{}: {} selects no element; their centres lie in {:.6g} <= x <= {:.6g}, {:.6g} <= y <= {:.6g}, {:.6g} <= z <= "
        "{:.6g}",
        origin, inQuotes(where->text()), low[0], high[0], low[1], high[1], low[2], high[2]));
  return elements;
}

std::vector<Material> assignMaterials(const std::vector<SceneMaterial>& materials, Mesh& mesh, MaterialsBy by) {
  std::vector<Material> made;
  for (const SceneMaterial& material : materials)
    made.push_back(makeMaterial(material.model, material.parameters, material.density));
  if (materials.size() == 1 && materials.front().ofAllElements()) return made;

  const ElementNumbers numbers =
      by == MaterialsBy::scene ? numbersByScene(materials, mesh) : numbersByMesh(materials, mesh);
  if (materials.size() == 1) return made;
  const SplitBlocks split = splitBlocks(mesh, numbers, static_cast<int>(materials.size()));
  for (std::size_t m = 0; m < materials.size(); ++m) mesh.elementSets[setOfMaterial(m)].clear();
  std::vector<Material> ofBlocks;
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
    const std::size_t number = split.numbers[b];
    std::vector<ElementRef>& set = mesh.elementSets[setOfMaterial(number)];
    for (std::size_t e = 0; e < mesh.blocks[b].elementCount(); ++e) set.push_back({b, e});
    ofBlocks.push_back(made[number]);
  }
  return ofBlocks;
}

std::vector<int> materialOfBlocks(const Mesh& mesh) {
  std::vector<int> numbers(mesh.blocks.size(), none);
  int count = 0;
  for (;; ++count) {
    const auto set = mesh.elementSets.find(setOfMaterial(count));
    if (set == mesh.elementSets.end()) break;
    for (const ElementRef e : set->second) numbers[e.block] = count;
  }
  if (count < 2) return {};
  for (std::size_t b = 0; b < numbers.size(); ++b)
    if (numbers[b] == none && mesh.blocks[b].elementCount() > 0) return {};
  return numbers;
}

std::vector<const SceneMaterial*> blockMaterials(const std::vector<SceneMaterial>& materials, const Mesh& mesh) {
  const std::vector<int> numbers = materialOfBlocks(mesh);
  std::vector<const SceneMaterial*> ofBlocks(mesh.blocks.size(), &materials.front());
  for (std::size_t b = 0; b < numbers.size(); ++b)
    if (numbers[b] != none) ofBlocks[b] = &materials[numbers[b]];
  return ofBlocks;
}

}  // namespace ringwatch
