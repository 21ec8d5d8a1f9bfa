#include <ringwatch/distributed/rank_part.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include <ringwatch/base/sort_unique.h>

namespace ringwatch {

RankPart::RankPart(int rank, std::vector<MeshBlock> blocks, std::vector<std::vector<std::int32_t>> elements,
                   std::vector<std::int32_t> owned, const std::function<int(std::int32_t node)>& ownerOf)
    : ownedNodes(static_cast<std::int32_t>(owned.size())),
      globalNodes(std::move(owned)),
      globalElements(std::move(elements)) {
  mesh.blocks = std::move(blocks);
  std::vector<std::pair<int, std::int32_t>> ghosts;  // owner, number
  std::map<int, std::vector<std::int32_t>> sent;
  std::vector<int> owners;
  for (const MeshBlock& block : mesh.blocks) {
    const auto n = static_cast<std::size_t>(block.nodesPerElement());
    owners.resize(n);
    for (std::size_t e = 0; e < block.elementCount(); ++e) {
      const std::int32_t* nodes = block.element(e);
      for (std::size_t a = 0; a < n; ++a) owners[a] = ownerOf(nodes[a]);
      for (std::size_t a = 0; a < n; ++a) {
        if (owners[a] == rank) continue;
        ghosts.emplace_back(owners[a], nodes[a]);
        for (std::size_t other = 0; other < n; ++other)
          if (owners[other] == rank) sent[owners[a]].push_back(nodes[other]);
      }
    }
  }
  sortUnique(ghosts);
  for (const auto& [owner, node] : ghosts) globalNodes.push_back(node);
  byNumber.resize(globalNodes.size());
  std::iota(byNumber.begin(), byNumber.end(), 0);
  std::sort(byNumber.begin(), byNumber.end(),
            [&](std::int32_t a, std::int32_t b) { return globalNodes[a] < globalNodes[b]; });
  for (std::size_t first = 0; first < ghosts.size();) {
    const int owner = ghosts[first].first;
    std::size_t end = first;
    while (end < ghosts.size() && ghosts[end].first == owner) ++end;
    std::vector<std::int32_t>& own = sent[owner];
    sortUnique(own);
    for (std::int32_t& node : own) node = localNode(node);
    neighbours.push_back(
        {owner, std::move(own), ownedNodes + static_cast<std::int32_t>(first), static_cast<std::int32_t>(end - first)});
    first = end;
  }
  for (MeshBlock& block : mesh.blocks)
    for (std::int32_t& node : block.connectivity) node = localNode(node);
}

std::int32_t RankPart::localNode(std::int32_t globalNode) const {
  const auto found =
      std::lower_bound(byNumber.begin(), byNumber.end(), globalNode,
                       [&](std::int32_t local, std::int32_t number) { return globalNodes[local] < number; });
  return found != byNumber.end() && globalNodes[*found] == globalNode ? *found : -1;
}

}  // namespace ringwatch
