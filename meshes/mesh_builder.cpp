#include <ringwatch/meshes/mesh_builder.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include <ringwatch/base/error.h>

namespace ringwatch::detail {
namespace {

constexpr std::uint8_t tet10[] = {0, 1, 2, 3, 4, 5, 6, 7, 9, 8};
constexpr std::uint8_t hex20[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 11, 13, 9, 16, 18, 19, 17, 10, 12, 14, 15};
constexpr std::uint8_t hex27[] = {0,  1,  2,  3,  4,  5,  6,  7,  8,  11, 13, 9,  16, 18,
                                  19, 17, 10, 12, 14, 15, 22, 23, 21, 24, 20, 25, 26};
constexpr std::uint8_t wedge15[] = {0, 1, 2, 3, 4, 5, 6, 9, 7, 12, 14, 13, 8, 10, 11};
constexpr std::uint8_t pyramid13[] = {0, 1, 2, 3, 4, 5, 8, 10, 6, 7, 9, 11, 12};

// Numbers of gmsh ("MSH file format") and of vtkCellType.h; -1: VTK has no such cell of fixed order.
constexpr FileElement fileElements[] = {
    {15, "point1", 0, 1, 1, {}},
    {1, "line2", 1, 2, 3, {}},
    {8, "line3", 1, 3, 21, {}},
    {26, "line4", 1, 4, 35, {}},
    {27, "line5", 1, 5, -1, {}},
    {28, "line6", 1, 6, -1, {}},
    {2, "triangle3", 2, 3, 5, {}},
    {9, "triangle6", 2, 6, 22, {}},
    {20, "triangle9", 2, 9, -1, {}},
    {21, "triangle10", 2, 10, -1, {}},
    {22, "triangle12", 2, 12, -1, {}},
    {23, "triangle15", 2, 15, -1, {}},
    {25, "triangle21", 2, 21, -1, {}},
    {3, "quad4", 2, 4, 9, {}},
    {16, "quad8", 2, 8, 23, {}},
    {10, "quad9", 2, 9, 28, {}},
    {4, "tet4", 3, 4, 10, {}},
    {11, "tet10", 3, 10, 24, tet10},
    {29, "tet20", 3, 20, -1, {}},
    {30, "tet35", 3, 35, -1, {}},
    {31, "tet56", 3, 56, -1, {}},
    {5, "hex8", 3, 8, 12, {}},
    {17, "hex20", 3, 20, 25, hex20},
    {12, "hex27", 3, 27, 29, hex27},
    {92, "hex64", 3, 64, -1, {}},
    {93, "hex125", 3, 125, -1, {}},
    {6, "wedge6", 3, 6, 13, {}},
    {18, "wedge15", 3, 15, 26, wedge15},
    {13, "wedge18", 3, 18, 32, {}},
    {7, "pyramid5", 3, 5, 14, {}},
    {19, "pyramid13", 3, 13, 27, pyramid13},
    {14, "pyramid14", 3, 14, -1, {}},
};

/// Numbers of nodes to indices: a table where the numbers are dense, a hash map else.
class NodeIndex {
 public:
  explicit NodeIndex(const std::vector<std::int64_t>& ids) {
    if (ids.empty()) return;
    const auto [least, most] = std::minmax_element(ids.begin(), ids.end());
    least_ = *least;
    const auto range = static_cast<std::uint64_t>(*most) - static_cast<std::uint64_t>(*least);
    dense_ = range < 4 * ids.size() + 1024;
    if (dense_) table_.assign(range + 1, -1);
  }
  /// False when the number is there already.
  bool insert(std::int64_t id, std::int32_t index) {
    if (!dense_) return map_.emplace(id, index).second;
    std::int32_t& slot = table_[static_cast<std::size_t>(id - least_)];
    if (slot >= 0) return false;
    slot = index;
    return true;
  }
  std::int32_t find(std::int64_t id) const {
    if (dense_) {
      const std::uint64_t at = static_cast<std::uint64_t>(id) - static_cast<std::uint64_t>(least_);
      return at < table_.size() ? table_[at] : -1;
    }
    const auto found = map_.find(id);
    return found == map_.end() ? -1 : found->second;
  }

 private:
  bool dense_ = true;
  std::int64_t least_ = 0;
  std::vector<std::int32_t> table_;
  std::unordered_map<std::int64_t, std::int32_t> map_;
};

}  // namespace

const FileElement* findGmshElement(int gmshType) {
  for (const FileElement& e : fileElements)
    if (e.gmshType == gmshType) return &e;
  return nullptr;
}
const FileElement* findVtkElement(int vtkCellType) {
  for (const FileElement& e : fileElements)
    if (e.vtkCellType == vtkCellType && vtkCellType > 0) return &e;
  return nullptr;
}

void MeshBuilder::addElement(const FileElement& type, std::int64_t id, const std::int64_t* nodes, int group,
                             std::size_t position, bool gmshOrder) {
  auto found = std::find_if(elements_.rbegin(), elements_.rend(), [&](const Elements& e) { return e.type == &type; });
  Elements* list = found != elements_.rend() ? &*found : nullptr;
  if (list == nullptr) {
    const ElementInfo* info = type.dimension == 3 ? findElementByGmshType(type.gmshType) : nullptr;
    list = &elements_.emplace_back(Elements{&type, info, {}, {}, {}, {}, 0});
  }
  ++list->count;
  if (list->info == nullptr) {
    if (type.dimension == 3) {
      if (list->positions.empty()) list->positions.push_back(position);  // for the message
      return;
    }
    if (group < 0) return;
  }
  const auto count = static_cast<std::size_t>(type.nodes);
  for (std::size_t i = 0; i < count; ++i)
    list->nodes.push_back(nodes[gmshOrder && !type.permutation.empty() ? type.permutation[i] : i]);
  list->ids.push_back(id);
  list->groups.push_back(group);
  list->positions.push_back(position);
}

Mesh MeshBuilder::finish(std::vector<std::string>* notes, std::vector<MeshProblem>* problems) {
  std::string unsupported;
  std::size_t firstPosition = 0, dropped = 0;
  bool volumes = false, hex27 = false;
  for (const Elements& list : elements_) {
    if (list.type->dimension < 3) dropped += list.count;
    if (list.info != nullptr) volumes = true;
    if (list.type->dimension < 3 || list.info != nullptr) continue;
    if (unsupported.empty()) firstPosition = list.positions[0];
    hex27 = hex27 || list.type->name == "hex27";
    unsupported += joinText(unsupported.empty() ? "" : " and ", list.count, " of type ", list.type->name);
  }
  if (!unsupported.empty()) {
    std::string known;
    for (const ElementInfo& info : allElements()) known += (known.empty() ? "" : ", ") + std::string(info.name);
    throw InputError(
        joinText(elementWhere_(firstPosition), ": elements that are not supported: ", unsupported, "; supported are ",
                 known, hex27 ? "; gmsh writes hex20 in place of hex27 with Mesh.SecondOrderIncomplete = 1" : ""));
  }
  if (!volumes)
    throw InputError(joinText(source_, ": there are no volume elements, only ", dropped,
                              " of surfaces, lines or points; a mesh of tetrahedra or hexahedra is needed",
                              noVolumeHint));
  constexpr std::size_t limit = std::numeric_limits<std::int32_t>::max();
  if (nodeIds_.size() > limit)
    throw InputError(joinText(source_, ": ", nodeIds_.size(), " nodes; at most ", limit, " are possible"));

  Mesh mesh;
  mesh.X = Eigen::Map<const NodeVectors>(coordinates_.data(), 3, static_cast<Eigen::Index>(nodeIds_.size()));
  for (std::size_t n = 0; n < nodeIds_.size(); ++n)
    for (std::size_t k = 0; k < 3; ++k) {
      const double value = coordinates_[3 * n + k];
      if (std::isfinite(value)) continue;
      const std::string text = joinText(nodeWhere_(nodePositions_[n]), ": coordinate ", "xyz"[k], " of node ",
                                        nodeIds_[n], " is ", value, "; it must be finite");
      if (problems == nullptr) throw InputError(text);
      problems->push_back(
          {MeshProblem::Kind::nonFinite, -1, static_cast<std::int64_t>(n), nodeIds_[n], {nodeIds_[n]}, value, text});
      break;
    }
  NodeIndex index(nodeIds_);
  for (std::size_t n = 0; n < nodeIds_.size(); ++n)
    if (!index.insert(nodeIds_[n], static_cast<std::int32_t>(n)))
      throw InputError(joinText(nodeWhere_(nodePositions_[n]), ": node ", nodeIds_[n], " is defined a second time"));

  for (const Elements& list : elements_) {
    const auto width = static_cast<std::size_t>(list.type->nodes);
    if (list.ids.size() > limit)
      throw InputError(joinText(source_, ": ", list.ids.size(), " elements of type ", list.type->name, "; at most ",
                                limit, " are possible"));
    const auto blockNumber = static_cast<std::int32_t>(mesh.blocks.size());
    std::vector<std::int32_t> connectivity(list.nodes.size());
    for (std::size_t e = 0; e < list.ids.size(); ++e)
      for (std::size_t a = 0; a < width; ++a) {
        const std::size_t at = e * width + a;
        connectivity[at] = index.find(list.nodes[at]);
        if (connectivity[at] >= 0) continue;
        const std::string text =
            joinText(elementWhere_(list.positions[e]), ": element ", list.ids[e], " (", list.type->name,
                     ") refers to node ", list.nodes[at], ", which the file does not have");
        if (problems == nullptr) throw InputError(text);
        problems->push_back(
            {MeshProblem::Kind::missingNode, list.info != nullptr ? blockNumber : -1, static_cast<std::int64_t>(e),
             list.ids[e],
             std::vector<std::int64_t>(list.nodes.begin() + static_cast<std::ptrdiff_t>(e * width),
                                       list.nodes.begin() + static_cast<std::ptrdiff_t>((e + 1) * width)),
             static_cast<double>(list.nodes[at]), text});
      }
    // Consecutive elements mostly share their group, so the sets are looked up once a run.
    std::vector<std::vector<ElementRef>*> elementTargets;
    std::vector<std::vector<std::int32_t>*> nodeTargets;
    int group = -1;
    for (std::size_t e = 0; e < list.ids.size(); ++e) {
      if (list.groups[e] != group) {
        group = list.groups[e];
        elementTargets.clear();
        nodeTargets.clear();
        if (group >= 0)
          for (const std::string& name : groups_[static_cast<std::size_t>(group)]) {
            if (list.info != nullptr)
              elementTargets.push_back(&mesh.elementSets[name]);
            else
              nodeTargets.push_back(&mesh.nodeSets[name]);
          }
      }
      for (auto* set : elementTargets) set->push_back({blockNumber, static_cast<std::int32_t>(e)});
      for (auto* set : nodeTargets)
        for (std::size_t a = 0; a < width; ++a)
          if (connectivity[e * width + a] >= 0) set->push_back(connectivity[e * width + a]);
    }
    if (list.info != nullptr) mesh.blocks.push_back({list.info->type, std::move(connectivity), list.ids});
  }
  for (const auto& [name, ids] : nodeSetIds_)
    for (const std::int64_t id : ids) mesh.nodeSets[name].push_back(index.find(id));
  for (auto& [name, nodes] : mesh.nodeSets) {
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  }
  mesh.nodeIds = std::move(nodeIds_);
  if (notes != nullptr && dropped > 0)
    notes->push_back(joinText(source_, ": ", dropped,
                              " elements of surfaces, lines or points are kept only as node sets of their groups"));
  return mesh;
}

}  // namespace ringwatch::detail
