#include <ringwatch/distributed/partition.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <utility>

#include <ptscotch.h>

#include <ringwatch/base/error.h>
#include <ringwatch/meshes/adjacency.h>

namespace ringwatch {
namespace {

/// A graph of Scotch's, given back with its owner.
class Graph {
 public:
  Graph() { check(SCOTCH_graphInit(&graph_)); }
  ~Graph() { SCOTCH_graphExit(&graph_); }
  Graph(const Graph&) = delete;
  Graph& operator=(const Graph&) = delete;
  SCOTCH_Graph* get() { return &graph_; }
  static void check(int status) {
    if (status != 0) throw InputError("Scotch could not cut the mesh");
  }

 private:
  SCOTCH_Graph graph_;
};

class Strategy {
 public:
  Strategy() { Graph::check(SCOTCH_stratInit(&strategy_)); }
  ~Strategy() { SCOTCH_stratExit(&strategy_); }
  Strategy(const Strategy&) = delete;
  Strategy& operator=(const Strategy&) = delete;
  SCOTCH_Strat* get() { return &strategy_; }

 private:
  SCOTCH_Strat strategy_;
};

/// The number that comes most often, of several such numbers the least. Sorts them; there must be one.
std::int32_t mostFrequent(std::vector<std::int32_t>& numbers) {
  std::sort(numbers.begin(), numbers.end());
  std::int32_t result = numbers.front();
  std::ptrdiff_t most = 0;
  for (auto begin = numbers.begin(); begin != numbers.end();) {
    const auto end = std::upper_bound(begin, numbers.end(), *begin);
    if (end - begin > most) {
      most = end - begin;
      result = *begin;
    }
    begin = end;
  }
  return result;
}

}  // namespace

Partition partitionOf(const Mesh& mesh, std::vector<std::int32_t> partOfElement, int parts) {
  if (parts < 1) throw InputError(joinText(parts, " parts of a mesh: must be 1 or more"));
  if (partOfElement.size() != mesh.elementCount())
    throw InputError(joinText(partOfElement.size(), " parts for ", mesh.elementCount(), " elements: give one each"));
  for (const std::int32_t part : partOfElement)
    if (part < 0 || part >= parts) throw InputError(joinText("part ", part, ": must be 0 to ", parts - 1));
  const CompressedRows<ElementNode> elements = nodeElements(mesh);
  const std::vector<std::size_t> first = blockOffsets(mesh);
  Partition partition{parts, std::move(partOfElement), std::vector<std::int32_t>(mesh.nodeCount(), 0)};
  std::vector<std::int32_t> own;
  for (std::size_t node = 0; node < mesh.nodeCount(); ++node) {
    own.clear();
    for (const ElementNode& at : elements.row(node))
      own.push_back(partition.ofElement[first[at.block] + static_cast<std::size_t>(at.element)]);
    if (!own.empty()) partition.ofNode[node] = mostFrequent(own);
  }
  return partition;
}

void keepTogether(Partition& partition, std::span<const std::int32_t> group) {
  std::vector<std::int32_t> owners;
  for (const std::int32_t node : group) owners.push_back(partition.ofNode[node]);
  if (owners.empty()) return;
  const std::int32_t owner = mostFrequent(owners);
  for (const std::int32_t node : group) partition.ofNode[node] = owner;
}

Partition partitionMesh(const Mesh& mesh, int parts) {
  if (parts < 1) throw InputError(joinText(parts, " parts of a mesh: must be 1 or more"));
  const std::size_t count = mesh.elementCount();
  std::vector<std::int32_t> result(count, 0);
  if (parts == 1) return partitionOf(mesh, std::move(result), parts);
  const std::vector<std::size_t> first = blockOffsets(mesh);
  const FaceNeighbours neighbours = faceNeighbours(mesh);
  std::vector<SCOTCH_Num> begin{0}, adjacent, weight, part(count);
  for (std::size_t e = 0; e < count; ++e) {
    for (const ElementFace& other : neighbours.rows.row(e))
      if (other.element >= 0)
        adjacent.push_back(static_cast<SCOTCH_Num>(first[other.block] + static_cast<std::size_t>(other.element)));
    begin.push_back(static_cast<SCOTCH_Num>(adjacent.size()));
  }
  for (const MeshBlock& block : mesh.blocks)
    weight.insert(weight.end(), block.elementCount(), static_cast<SCOTCH_Num>(block.nodesPerElement()));
  if (adjacent.empty()) adjacent.push_back(0);  // an array for elements that meet in no face
  Graph graph;
  Strategy strategy;
  SCOTCH_randomReset();
  Graph::check(SCOTCH_graphBuild(graph.get(), 0, static_cast<SCOTCH_Num>(count), begin.data(), nullptr, weight.data(),
                                 nullptr, begin.back(), adjacent.data(), nullptr));
  Graph::check(SCOTCH_graphPart(graph.get(), parts, strategy.get(), part.data()));
  std::copy(part.begin(), part.end(), result.begin());
  return partitionOf(mesh, std::move(result), parts);
}

Partition partitionMesh(Ranks& ranks, const Mesh& mesh) {
  std::vector<std::int32_t> parts(mesh.elementCount());
  if (ranks.rank() == 0) parts = partitionMesh(mesh, ranks.size()).ofElement;
  ranks.share(parts.data(), parts.size() * sizeof parts[0], 0);
  return partitionOf(mesh, std::move(parts), ranks.size());
}

}  // namespace ringwatch
