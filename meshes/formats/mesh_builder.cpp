#include <ringwatch/meshes/formats/mesh_builder.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>

#include <ringwatch/base/error.h>
#include <ringwatch/base/sort_unique.h>
#include <ringwatch/meshes/index_limits.h>

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

/// Elements of which the first nodes make one that the library has, in the order of every format.
struct Reduced {
  std::string_view shape;
  int nodes, kept;
};
constexpr Reduced reducible[] = {{"hex", 27, 20},  {"hex", 24, 20},    {"wedge", 18, 6},   {"wedge", 15, 6},
                                 {"wedge", 12, 6}, {"pyramid", 19, 5}, {"pyramid", 14, 5}, {"pyramid", 13, 5}};
/// nullptr where the library has the element, or nothing that could be had of it.
const FileElement* reducedOf(const FileElement& type) {
  if (type.dimension < 3 || elementOf(type) != nullptr) return nullptr;
  for (const Reduced& one : reducible)
    for (const FileElement& kept : fileElements)
      if (one.shape == type.shape && one.nodes == type.nodes && kept.shape == type.shape && kept.nodes == one.kept)
        return elementOf(kept) != nullptr ? &kept : nullptr;
  return nullptr;
}

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

using Face = std::vector<std::int64_t>;

/// The faces of an element without repeated corners, where three or more are left, each begun with its least node, in
/// order.
std::vector<Face> facesOf(const ElementInfo& info, const std::int64_t* nodes) {
  std::vector<Face> faces;
  for (const auto& corners : info.faces) {
    Face face;
    for (const int corner : corners)
      if (corner >= 0 && (face.empty() || face.back() != nodes[corner])) face.push_back(nodes[corner]);
    if (face.size() > 1 && face.front() == face.back()) face.pop_back();
    if (face.size() < 3) continue;
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    faces.push_back(std::move(face));
  }
  std::ranges::sort(faces);
  return faces;
}

/// The tetrahedron, pyramid or wedge that is left of an element whose nodes are not all different: the one that has the
/// very faces of the element, so that it fills the same space. left: its nodes. nullptr for any other shape.
const FileElement* collapsed(const ElementInfo& info, const std::int64_t* nodes, std::array<std::int64_t, 6>& left) {
  const std::vector<Face> faces = facesOf(info, nodes);
  std::vector<std::int64_t> all(nodes, nodes + info.nodes);
  sortUnique(all);
  const auto isBase = [&](const Face& face) { return face.size() == (all.size() == 5 ? 4U : 3U); };
  const auto base = std::ranges::find_if(faces, isBase);
  if (all.size() < 4 || all.size() > 6 || base == faces.end()) return nullptr;
  const auto holds = [&](std::int64_t node) { return std::ranges::find(*base, node) != base->end(); };
  /// Faces look outward, the first face of an element inward.
  for (std::size_t i = 0; i < base->size(); ++i) left[i] = (*base)[(base->size() - i) % base->size()];
  if (all.size() == 6) {
    for (std::size_t i = 0; i < 3; ++i) {
      left[3 + i] = -1;
      for (const Face& face : faces)
        for (std::size_t k = 0; face.size() == 4 && k < 4; ++k)
          for (const std::int64_t above : {face[(k + 1) % 4], face[(k + 3) % 4]})
            if (face[k] == left[i] && !holds(above)) left[3 + i] = above;
    }
  } else {
    left[base->size()] = *std::ranges::find_if_not(all, holds);
  }
  const FileElement* const type = findVtkElement(all.size() == 6 ? 13 : all.size() == 5 ? 14 : 10);
  return facesOf(*elementOf(*type), left.data()) == faces ? type : nullptr;
}

}  // namespace

VtkCell vtkCell(int vtkCellType, std::size_t nodes) {
  // Lagrange cells, as dolfinx writes them, of so few nodes have the nodes of the usual cell in our order
  // (vtkLagrangeTetra, vtkLagrangeHexahedron, vtkLagrangeWedge). A voxel has rows of nodes where a hexahedron has
  // rings.
  struct Lagrange {
    int type;
    std::size_t nodes;
    int usual;
  };
  constexpr Lagrange lagrange[] = {{71, 4, 10}, {71, 10, 24}, {72, 8, 12}, {73, 6, 13}};
  for (const Lagrange& cell : lagrange)
    if (cell.type == vtkCellType && cell.nodes == nodes) return {findVtkElement(cell.usual)};
  constexpr int voxel = 11, hexahedron = 12, wedge = 13;
  if (vtkCellType == voxel) return {findVtkElement(hexahedron), NodeOrder::vtkVoxel};
  return {findVtkElement(vtkCellType), vtkCellType == wedge ? NodeOrder::vtkWedge : NodeOrder::ours};
}

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
                           const std::function<std::string(std::size_t position)>& where, const std::string& hint,
                           std::size_t leftOut) {
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
    throw InputError(
        joinText(source, ": there are no volume elements",
                 dropped + leftOut == 0 ? "" : joinText(", only ", dropped + leftOut, " of surfaces, lines or points"),
                 "; a mesh of tetrahedra or hexahedra is needed", hint));
  if (nodes > std::size_t{nodeCountLimit})
    throw InputError(joinText(source, ": ", nodes, " nodes; at most ", nodeCountLimit, " are possible"));
  for (const FoundElements& list : found)
    if (list.count > std::size_t{elementCountLimit} && list.type->dimension == 3)
      throw InputError(joinText(source, ": ", list.count, " elements of type ", list.type->name(), "; at most ",
                                elementCountLimit, " are possible"));
  return dropped;
}

std::vector<std::string> droppedNote(const std::string& source, std::size_t dropped) {
  if (dropped == 0) return {};
  return {joinText(source, ": ", dropped,
                   " elements of surfaces, lines or points are kept only as node sets of their groups")};
}

MeshBuilder::Elements& MeshBuilder::listOf(const FileElement& type) {
  const auto found =
      std::find_if(elements_.rbegin(), elements_.rend(), [&](const Elements& e) { return e.type == &type; });
  return found != elements_.rend() ? *found : elements_.emplace_back(Elements{&type, elementOf(type), {}, {}, {}, {}});
}

void MeshBuilder::addElement(const FileElement& type, std::int64_t id, const std::int64_t* nodes, int group,
                             std::size_t position, NodeOrder order) {
  if (const FileElement* const kept = reducedOf(type)) {
    ++reduced_[{type.name(), kept->name()}];
    if (elementOf(*kept)->order == 1)  // else what is left out is of no other element
      for (int i = kept->nodes; i < type.nodes; ++i) hanging_.emplace(nodes[i], OfReduced{type.name(), id, position});
    return addElement(*kept, id, nodes, group, position, order);
  }
  Elements* list = &listOf(type);
  if (list->info == nullptr) {
    ++list->count;
    if (type.dimension == 3) {
      if (list->positions.empty()) list->positions.push_back(position);  // for the message
      return;
    }
    if (group < 0) return;
  }
  constexpr std::array<std::uint8_t, 8> voxelOrder{0, 1, 3, 2, 4, 5, 7, 6};
  const std::span<const std::uint8_t> places = list->info == nullptr          ? std::span<const std::uint8_t>()
                                               : order == NodeOrder::gmsh     ? list->info->gmshOrder
                                               : order == NodeOrder::vtkWedge ? vtkWedgeOrder
                                               : order == NodeOrder::vtkVoxel ? voxelOrder
                                                                              : std::span<const std::uint8_t>();
  const auto count = static_cast<std::size_t>(type.nodes);
  const auto node = [&](std::size_t i) { return nodes[places.empty() ? i : places[i]]; };
  std::array<std::int64_t, 8> own;
  if (list->info != nullptr && list->info->order == 1 && count <= own.size()) {
    bool repeated = false;
    for (std::size_t i = 0; i < count; ++i) {
      own[i] = node(i);
      for (std::size_t k = 0; k < i; ++k) repeated = repeated || own[k] == own[i];
    }
    std::array<std::int64_t, 6> left;
    if (const FileElement* other = repeated ? collapsed(*list->info, own.data(), left) : nullptr) {
      ++collapsed_[{type.name(), other->name()}];
      return addElement(*other, id, left.data(), group, position);
    }
  }
  if (list->info != nullptr) ++list->count;
  for (std::size_t i = 0; i < count; ++i) list->nodes.push_back(node(i));
  list->ids.push_back(id);
  list->groups.push_back(group);
  list->positions.push_back(position);
}

int MeshBuilder::groupOfBoth(int one, int other) {
  if (other < 0 || one == other) return one;
  if (one < 0) return other;
  const auto [known, isNew] = bothGroups_.try_emplace({one, other}, 0);
  if (isNew) {
    std::vector<std::string> names = groups_[one];
    names.insert(names.end(), groups_[other].begin(), groups_[other].end());
    known->second = addGroup(std::move(names));
  }
  return known->second;
}

std::size_t MeshBuilder::leaveDoublesOut(Elements& list) {
  const std::size_t width = list.type->nodes;
  const auto nodesOf = [&](std::vector<std::int64_t>& nodes, std::size_t e) {
    return std::span(nodes).subspan(width * e, width);
  };
  const bool all = doubles == Doubles::all;
  if (!all && std::ranges::adjacent_find(list.groups, std::ranges::not_equal_to()) == list.groups.end()) return 0;
  std::vector<std::int64_t> sorted;
  if (all) sorted = list.nodes;
  std::vector<std::int64_t>& keys = all ? sorted : list.nodes;
  for (std::size_t e = 0; all && e < list.ids.size(); ++e) std::ranges::sort(nodesOf(keys, e));
  std::vector<std::size_t> order(list.ids.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::ranges::lexicographical_compare(nodesOf(keys, a), nodesOf(keys, b));
  });
  std::vector<bool> again(list.ids.size());
  for (std::size_t i = 1, first = 0; i < order.size(); ++i) {
    int& group = list.groups[order[first]];
    const int other = list.groups[order[i]];
    if (!std::ranges::equal(nodesOf(keys, order[i]), nodesOf(keys, order[first]))) {
      first = i;
    } else if (all || (group >= 0 && other >= 0 && group != other)) {
      group = groupOfBoth(group, other);
      again[order[i]] = true;
    }
  }
  std::size_t kept = 0;
  for (std::size_t e = 0; e < again.size(); ++e) {
    if (again[e]) continue;
    std::ranges::copy(nodesOf(list.nodes, e), list.nodes.begin() + width * static_cast<std::ptrdiff_t>(kept));
    list.ids[kept] = list.ids[e];
    list.groups[kept] = list.groups[e];
    list.positions[kept++] = list.positions[e];
  }
  list.nodes.resize(kept * static_cast<std::size_t>(width));
  list.ids.resize(kept);
  list.groups.resize(kept);
  list.positions.resize(kept);
  list.count -= again.size() - kept;
  return again.size() - kept;
}

void MeshBuilder::requireNoneHangs() const {
  for (const Elements& list : elements_)
    for (std::size_t i = 0; list.info != nullptr && list.info->order > 1 && i < list.nodes.size(); ++i)
      if (const auto found = hanging_.find(list.nodes[i]); found != hanging_.end())
        throw InputError(joinText(elementWhere_(found->second.position), ": element ", found->second.id, " (",
                                  found->second.type, ") could be read as linear, but element ",
                                  list.ids[i / static_cast<std::size_t>(list.type->nodes)], " (", list.type->name(),
                                  ") keeps node ", list.nodes[i],
                                  " between them, which would hang; make the mesh of linear elements"));
}

Mesh MeshBuilder::finish(std::vector<std::string>* notes, std::vector<MeshProblem>* problems) {
  // A list may have lost all that it had to another type.
  std::erase_if(elements_, [](const Elements& list) { return list.count == 0; });
  std::size_t merged = 0;
  if (doubles != Doubles::none)
    for (Elements& list : elements_)
      if (list.info != nullptr) merged += leaveDoublesOut(list);
  std::vector<FoundElements> found;
  for (const Elements& list : elements_)
    found.push_back({list.type, list.count, list.positions.empty() ? 0 : list.positions[0]});
  const std::size_t dropped = requireVolumes(found, nodeIds_.size(), source_, elementWhere_, noVolumeHint, leftOut);

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

  requireNoneHangs();
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
    if (list.info == nullptr) continue;
    mesh.blocks.push_back({list.info->type, std::move(connectivity), list.ids});
    positions_.push_back(list.positions);
  }
  for (const auto& [name, ids] : nodeSetIds_)
    for (const std::int64_t id : ids) mesh.nodeSets[name].push_back(index.find(id));
  for (auto& [name, nodes] : mesh.nodeSets) {
    sortUnique(nodes);
  }
  mesh.nodeIds = std::move(nodeIds_);
  if (notes == nullptr) return mesh;
  for (std::string& note : droppedNote(source_, dropped)) notes->push_back(std::move(note));
  for (const auto& [types, count] : reduced_)
    notes->push_back(joinText(source_, ": ", count, " ", types.first, " are read as ", types.second,
                              ", which is another element: their other nodes are left out"));
  for (const auto& [types, count] : collapsed_)
    notes->push_back(joinText(source_, ": ", count, " ", types.first,
                              " that hold a node several times are read as the ", types.second, " that are left"));
  if (merged > 0)
    notes->push_back(
        doubles == Doubles::all
            ? joinText(source_, ": ", merged, merged == 1 ? " element that stands" : " elements that stand",
                       " a second time were left out")
            : joinText(source_, ": ", merged, " elements that stand once more for another group are read once"));
  return mesh;
}

}  // namespace ringwatch::detail
