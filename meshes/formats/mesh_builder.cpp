#include <ringwatch/meshes/formats/mesh_builder.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include <ringwatch/base/error.h>
#include <ringwatch/base/sort_unique.h>

namespace ringwatch::detail {
namespace {

// Numbers of gmsh ("MSH file format") and of vtkCellType.h; 0: it has no such cell of fixed order.
constexpr int gmshHex27 = 12;
constexpr FileElement fileElements[] = {
    {15, "point", 0, 1, 1},     {1, "line", 1, 2, 3},       {8, "line", 1, 3, 21},      {26, "line", 1, 4, 35},
    {27, "line", 1, 5, 0},      {28, "line", 1, 6, 0},      {2, "triangle", 2, 3, 5},   {9, "triangle", 2, 6, 22},
    {20, "triangle", 2, 9, 0},  {21, "triangle", 2, 10, 0}, {22, "triangle", 2, 12, 0}, {23, "triangle", 2, 15, 0},
    {25, "triangle", 2, 21, 0}, {3, "quad", 2, 4, 9},       {16, "quad", 2, 8, 23},     {10, "quad", 2, 9, 28},
    {4, "tet", 3, 4, 10},       {11, "tet", 3, 10, 24},     {29, "tet", 3, 20, 0},      {30, "tet", 3, 35, 0},
    {31, "tet", 3, 56, 0},      {5, "hex", 3, 8, 12},       {17, "hex", 3, 20, 25},     {12, "hex", 3, 27, 29},
    {92, "hex", 3, 64, 0},      {93, "hex", 3, 125, 0},     {6, "wedge", 3, 6, 13},     {18, "wedge", 3, 15, 26},
    {13, "wedge", 3, 18, 32},   {7, "pyramid", 3, 5, 14},   {19, "pyramid", 3, 13, 27}, {14, "pyramid", 3, 14, 0},
    {0, "wedge", 3, 12, 31},    {0, "hex", 3, 24, 33},      {0, "pyramid", 3, 19, 37},
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
    std::int32_t& slot = table_[id - least_];
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
    if (e.gmshType == gmshType && gmshType > 0) return &e;
  return nullptr;
}
const FileElement* findVtkElement(int vtkCellType) {
  for (const FileElement& e : fileElements)
    if (e.vtkCellType == vtkCellType && vtkCellType > 0) return &e;
  return nullptr;
}

const ElementInfo* elementOf(const FileElement& type) {
  if (type.dimension < 3) return nullptr;
  const ElementInfo* info = findElementByVtkType(type.vtkCellType);
  if (info == nullptr) info = findElementByGmshType(type.gmshType);
  return info != nullptr && info->nodes == type.nodes ? info : nullptr;
}

std::size_t requireVolumes(std::span<const FoundElements> found, std::size_t nodes, const std::string& source,
                           const std::function<std::string(std::size_t position)>& where, const std::string& hint) {
  std::string unsupported;
  std::size_t firstPosition = 0, dropped = 0;
  bool volumes = false, hex27 = false;
  for (const FoundElements& list : found) {
    if (list.type->dimension < 3) {
      dropped += list.count;
    } else if (elementOf(*list.type) != nullptr) {
      volumes = true;
    } else {
      if (unsupported.empty()) firstPosition = list.firstPosition;
      hex27 = hex27 || list.type->gmshType == gmshHex27;
      unsupported += joinText(unsupported.empty() ? "" : " and ", list.count, " of type ", list.type->name());
    }
  }
  if (!unsupported.empty()) {
    std::string known;
    for (const ElementInfo& info : allElements()) known += (known.empty() ? "" : ", ") + std::string(info.name);
    throw InputError(
        joinText(where(firstPosition), ": elements that are not supported: ", unsupported, "; supported are ", known,
                 hex27 ? "; gmsh writes hex20 in place of hex27 with Mesh.SecondOrderIncomplete = 1" : ""));
  }
  if (!volumes)
    throw InputError(joinText(source, ": there are no volume elements, only ", dropped,
                              " of surfaces, lines or points; a mesh of tetrahedra or hexahedra is needed", hint));
  constexpr std::size_t limit = std::numeric_limits<std::int32_t>::max();
  if (nodes > limit) throw InputError(joinText(source, ": ", nodes, " nodes; at most ", limit, " are possible"));
  for (const FoundElements& list : found)
    if (list.count > limit && list.type->dimension == 3)
      throw InputError(joinText(source, ": ", list.count, " elements of type ", list.type->name(), "; at most ", limit,
                                " are possible"));
  return dropped;
}

std::vector<std::string> droppedNote(const std::string& source, std::size_t dropped) {
  if (dropped == 0) return {};
  return {joinText(source, ": ", dropped,
                   " elements of surfaces, lines or points are kept only as node sets of their groups")};
}

void MeshBuilder::addElement(const FileElement& type, std::int64_t id, const std::int64_t* nodes, int group,
                             std::size_t position, bool gmshOrder) {
  auto found = std::find_if(elements_.rbegin(), elements_.rend(), [&](const Elements& e) { return e.type == &type; });
  Elements* list = found != elements_.rend() ? &*found : nullptr;
  if (list == nullptr) {
    list = &elements_.emplace_back(Elements{&type, elementOf(type), {}, {}, {}, {}, 0});
  }
  ++list->count;
  if (list->info == nullptr) {
    if (type.dimension == 3) {
      if (list->positions.empty()) list->positions.push_back(position);  // for the message
      return;
    }
    if (group < 0) return;
  }
  const std::size_t count = type.nodes;
  const bool turned = gmshOrder && list->info != nullptr && !list->info->gmshOrder.empty();
  for (std::size_t i = 0; i < count; ++i) list->nodes.push_back(nodes[turned ? list->info->gmshOrder[i] : i]);
  list->ids.push_back(id);
  list->groups.push_back(group);
  list->positions.push_back(position);
}

Mesh MeshBuilder::finish(std::vector<std::string>* notes, std::vector<MeshProblem>* problems) {
  std::vector<FoundElements> found;
  for (const Elements& list : elements_)
    found.push_back({list.type, list.count, list.positions.empty() ? 0 : list.positions[0]});
  const std::size_t dropped = requireVolumes(found, nodeIds_.size(), source_, elementWhere_, noVolumeHint);

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
    if (!index.insert(nodeIds_[n], n))
      throw InputError(joinText(nodeWhere_(nodePositions_[n]), ": node ", nodeIds_[n], " is defined a second time"));

  for (const Elements& list : elements_) {
    const std::size_t width = list.type->nodes;
    const std::int32_t blockNumber = mesh.blocks.size();
    std::vector<std::int32_t> connectivity(list.nodes.size());
    for (std::size_t e = 0; e < list.ids.size(); ++e)
      for (std::size_t a = 0; a < width; ++a) {
        const std::size_t at = e * width + a;
        connectivity[at] = index.find(list.nodes[at]);
        if (connectivity[at] >= 0) continue;
        const std::string text =
            joinText(elementWhere_(list.positions[e]), ": element ", list.ids[e], " (", list.type->name(),
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
          for (const std::string& name : groups_[group]) {
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
    sortUnique(nodes);
  }
  mesh.nodeIds = std::move(nodeIds_);
  if (notes != nullptr)
    for (std::string& note : droppedNote(source_, dropped)) notes->push_back(std::move(note));
  return mesh;
}

}  // namespace ringwatch::detail
