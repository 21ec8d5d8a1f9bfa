#include <ringwatch/meshes/modify/repair.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include <ringwatch/base/error.h>
#include <ringwatch/meshes/check_texts.h>
#include <ringwatch/meshes/formats/mesh_builder.h>

namespace ringwatch {
namespace {

/// Puts nodes that are in another program's order into ours.
void putInOrder(Mesh& mesh, const std::string& source, std::vector<std::string>& done) {
  for (MeshBlock& block : mesh.blocks) {
    const ElementInfo& info = elementInfo(block.type);
    const JacobianProbe probe(info);
    std::map<std::vector<int>, std::size_t> orders;  // of the nodes on edges
    std::size_t inRows = 0;
    for (std::size_t e = 0; e < block.elementCount(); ++e) {
      std::int32_t* const nodes = block.connectivity.data() + e * static_cast<std::size_t>(info.nodes);
      if (const std::vector<std::int32_t> round = detail::nodesOutOfRows(mesh, info, probe, nodes); !round.empty()) {
        std::ranges::copy(round, nodes);
        ++inRows;
      }
      if (info.order == 1) continue;
      const std::vector<int> edges = detail::otherOrderOfMiddles(mesh, info, nodes);
      if (edges.empty()) continue;
      std::int32_t* const middles = nodes + cornerCount(info);
      const std::vector<std::int32_t> before(middles, middles + edges.size());
      for (std::size_t i = 0; i < edges.size(); ++i) middles[edges[i]] = before[i];
      ++orders[edges];
    }
    if (inRows > 0)
      done.push_back(joinText(source, ": ", inRows, " of ", block.elementCount(), " ", info.name,
                              " have their nodes in rows, as VTK's voxels; they were put into our order"));
    for (const auto& [order, count] : orders)
      done.push_back(joinText(source, ": ", count, " of ", block.elementCount(), " ", info.name,
                              " have the nodes on their edges in ", detail::programOfOrder(info, order),
                              " order; they were put into ours"));
  }
}

/// Whether the faces of an element cancel each other, because nodes of it are one.
bool hasNoInside(const ElementInfo& info, const std::int32_t* nodes) {
  std::set<std::set<std::int32_t>> single;
  for (const auto& corners : info.faces) {
    std::set<std::int32_t> face;
    for (const int corner : corners)
      if (corner >= 0) face.insert(nodes[corner]);
    if (face.size() < 3) continue;
    if (const auto [same, isNew] = single.insert(face); !isNew) single.erase(same);
  }
  return single.empty();
}

/// Refuses a distance in which nodes of one sound element lie, so that joining them would change the shape.
void requireApart(const Mesh& mesh, const std::string& source, const std::vector<std::int32_t>& nodeAt, double join) {
  for (const MeshBlock& block : mesh.blocks) {
    const ElementInfo& info = elementInfo(block.type);
    const JacobianProbe probe(info);
    for (std::size_t e = 0; e < block.elementCount(); ++e) {
      const std::int32_t* const nodes = block.element(e);
      for (int a = 0; a < info.nodes; ++a)
        for (int b = 0; b < a; ++b) {
          const double apart = (mesh.X.col(nodes[a]) - mesh.X.col(nodes[b])).norm();
          if (nodes[a] == nodes[b] || nodeAt[nodes[a]] != nodeAt[nodes[b]] || apart == 0) continue;
          const JacobianRange range = probe.range(mesh.X, nodes);
          const double least = detail::leastJacobian(info, mesh.X, nodes);
          if (range.min > least || range.max < -least)
            throw InputError(joinText(source, ": --join ", join, " would join nodes ", mesh.nodeId(nodes[b]), " and ",
                                      mesh.nodeId(nodes[a]), " of element ", block.id(e), ", which lie ", apart,
                                      " m apart and whose shape is sound; a smaller distance is needed"));
        }
    }
  }
}

/// The combination of element sets that each element is in: a number for each element, and the names of each number; 0
/// is none.
struct SetCombinations {
  std::vector<std::vector<std::size_t>> ofElement;  // [block][element]
  std::vector<std::vector<std::string>> names{{}};
};
SetCombinations combineSets(const Mesh& mesh) {
  SetCombinations combinations;
  for (const MeshBlock& block : mesh.blocks) combinations.ofElement.emplace_back(block.elementCount(), 0);
  for (const auto& [name, elements] : mesh.elementSets) {
    std::map<std::size_t, std::size_t> withThis;
    for (const ElementRef e : elements) {
      std::size_t& own = combinations.ofElement[e.block][e.element];
      if (own >= combinations.names.size() ||
          (!combinations.names[own].empty() && combinations.names[own].back() == name))
        continue;  // a set that names an element twice
      const auto [entry, isNew] = withThis.try_emplace(own, combinations.names.size());
      if (isNew) {
        combinations.names.push_back(combinations.names[own]);
        combinations.names.back().push_back(name);
      }
      own = entry->second;
    }
  }
  return combinations;
}

}  // namespace

RepairedMesh repairMesh(Mesh mesh, const std::string& source, std::optional<double> join) {
  requireValid(mesh);
  RepairedMesh repaired;
  std::vector<std::string>& done = repaired.done;
  putInOrder(mesh, source, done);

  std::vector<std::int32_t> nodeAt(mesh.nodeCount());
  std::iota(nodeAt.begin(), nodeAt.end(), 0);
  if (join) nodeAt = detail::firstNodesAtPlaces(mesh, *join, false);  // nodes of sets alone, too
  if (join) requireApart(mesh, source, nodeAt, *join);

  const auto where = [&](std::size_t) { return source; };
  detail::MeshBuilder builder(source, where, where);
  builder.doubles = detail::Doubles::all;
  std::int64_t joined = 0;
  for (std::size_t n = 0; n < mesh.nodeCount(); ++n) {
    const auto at = static_cast<Eigen::Index>(n);
    if (nodeAt[n] == at)
      builder.addNode(at, mesh.X(0, at), mesh.X(1, at), mesh.X(2, at), n);
    else
      ++joined;
  }
  if (joined > 0)
    done.push_back(joinText(source, ": ", joined, joined == 1 ? " node was joined" : " nodes were joined",
                            " with another at the same place"));

  const SetCombinations sets = combineSets(mesh);
  std::vector<int> groups(sets.names.size(), -1);
  for (std::size_t i = 1; i < groups.size(); ++i) groups[i] = builder.addGroup(sets.names[i]);
  std::size_t without = 0, kept = 0;
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b) {
    const MeshBlock& block = mesh.blocks[b];
    const ElementInfo& info = elementInfo(block.type);
    const detail::FileElement* type = detail::findVtkElement(info.vtkCellType);
    if (type == nullptr || detail::elementOf(*type) != &info)
      throw InputError(joinText(source, ": has ", info.name, ", which no mesh format has and repair does not know"));
    std::vector<std::int32_t> own(static_cast<std::size_t>(info.nodes));
    for (std::size_t e = 0; e < block.elementCount(); ++e) {
      for (std::size_t a = 0; a < own.size(); ++a) own[a] = nodeAt[block.element(e)[a]];
      if (hasNoInside(info, own.data())) {
        ++without;
        continue;
      }
      const std::vector<std::int64_t> nodes(own.begin(), own.end());
      builder.addElement(*type, block.id(e), nodes.data(), groups[sets.ofElement[b][e]], kept++);
    }
  }
  if (without > 0)
    done.push_back(joinText(source, ": ", without, without == 1 ? " element" : " elements",
                            " without an inside, whose faces are one, were left out"));
  if (kept == 0) throw InputError(source + ": no element has an inside, so none is left");
  for (const auto& [name, nodes] : mesh.nodeSets)
    for (const std::int32_t node : nodes) builder.addToNodeSet(name, nodeAt[node]);

  repaired.mesh = builder.finish(&done, nullptr);
  for (std::int64_t& id : repaired.mesh.nodeIds) id = mesh.nodeId(static_cast<std::int32_t>(id));
  detail::dropUnusedNodes(repaired.mesh, source, &done);
  repaired.problems = detail::turnAndCheck(repaired.mesh, source, &done);
  const auto nameEmpty = [&](const auto& before, const auto& after, std::string_view what) {
    for (const auto& [name, members] : before)
      if (const auto left = after.find(name); !members.empty() && (left == after.end() || left->second.empty()))
        done.push_back(joinText(source, ": the ", what, " set \"", name, "\" has no ", what, " left"));
  };
  nameEmpty(mesh.elementSets, repaired.mesh.elementSets, "element");
  nameEmpty(mesh.nodeSets, repaired.mesh.nodeSets, "node");
  return repaired;
}

}  // namespace ringwatch
