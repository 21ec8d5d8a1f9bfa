#include <ringwatch/meshes/part_of_mesh.h>

#include <cstdint>
#include <utility>

namespace ringwatch {

Mesh meshOfElements(const Mesh& all, const std::vector<std::vector<bool>>& chosen) {
  Mesh mesh;
  std::vector<std::vector<std::int32_t>> places;  // [block][element] of the chosen ones in their block, -1 for others
  for (std::size_t b = 0; b < all.blocks.size(); ++b) {
    const MeshBlock& from = all.blocks[b];
    MeshBlock& block = mesh.blocks.emplace_back(MeshBlock{from.type, {}, {}});
    std::vector<std::int32_t>& own = places.emplace_back(from.elementCount(), -1);
    for (std::size_t e = 0; e < from.elementCount(); ++e) {
      if (!chosen[b][e]) continue;
      own[e] = static_cast<std::int32_t>(block.ids.size());
      block.ids.push_back(from.id(e));
      block.connectivity.insert(block.connectivity.end(), from.element(e), from.element(e) + from.nodesPerElement());
    }
  }
  for (const auto& [name, elements] : all.elementSets)
    for (std::vector<ElementRef>& own = mesh.elementSets[name]; const ElementRef e : elements)
      if (const std::int32_t place = places[e.block][e.element]; place >= 0) own.push_back({e.block, place});
  return mesh;
}

std::vector<bool> usedNodes(const Mesh& mesh) {
  std::vector<bool> used(mesh.nodeCount());
  for (const MeshBlock& block : mesh.blocks)
    for (const std::int32_t n : block.connectivity)
      if (n >= 0 && static_cast<std::size_t>(n) < used.size()) used[n] = true;
  return used;
}

std::vector<std::size_t> keepUsedNodes(Mesh& mesh) {
  const std::vector<bool> used = usedNodes(mesh);
  std::vector<std::size_t> kept;
  std::vector<std::int32_t> newNumber(used.size(), -1);
  std::vector<std::int64_t> ids;
  for (std::size_t n = 0; n < used.size(); ++n) {
    if (!used[n]) continue;
    newNumber[n] = static_cast<std::int32_t>(kept.size());
    mesh.X.col(newNumber[n]) = mesh.X.col(static_cast<Eigen::Index>(n)).eval();
    ids.push_back(mesh.nodeId(n));
    kept.push_back(n);
  }
  mesh.X.conservativeResize(3, static_cast<Eigen::Index>(kept.size()));
  mesh.nodeIds = std::move(ids);
  for (MeshBlock& block : mesh.blocks)
    for (std::int32_t& n : block.connectivity)
      if (n >= 0 && static_cast<std::size_t>(n) < used.size()) n = newNumber[n];
  for (auto& [name, nodes] : mesh.nodeSets) {
    std::erase_if(nodes, [&](std::int32_t n) { return newNumber[n] < 0; });
    for (std::int32_t& n : nodes) n = newNumber[n];
  }
  return kept;
}

}  // namespace ringwatch
