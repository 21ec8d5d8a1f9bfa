#include <ringwatch/distributed/rank_body.h>

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <utility>

#include <ringwatch/base/error.h>
#include <ringwatch/base/sort_unique.h>
#include <ringwatch/meshes/adjacency.h>
#include <ringwatch/monitor/energy_balance.h>

namespace ringwatch {

RankBody::RankBody(const Body& whole, const Partition& partition, int rank, int threads)
    : mostNodes_(whole.mostNodesOfAnElement()), roundingEnergy_(ringwatch::roundingEnergy(whole)) {
  if (whole.discreteForces()) throw InputError("springs and contact are not distributed over ranks");
  if (whole.elementDamping()) throw InputError("elements that damp are not distributed over ranks");
  if (partition.ofNode.size() != static_cast<std::size_t>(whole.nodeCount()))
    throw InputError(joinText("a partition of ", partition.ofNode.size(), " nodes: the body has ", whole.nodeCount()));
  const Mesh& all = whole.mesh();
  const auto ownerOf = [&](std::int32_t node) { return partition.ofNode[node]; };

  std::vector<std::int32_t> ghosts;
  std::map<int, std::vector<std::int32_t>> sent;
  for (std::size_t b = 0; b < all.blocks.size(); ++b) {
    std::vector<std::int32_t>& own = globalElements_.emplace_back();
    for (std::int32_t e = 0; e < whole.blocks()[b]->elementCount(); ++e) {
      const auto nodes = whole.blocks()[b]->nodesOf(e);
      if (std::none_of(nodes.begin(), nodes.end(), [&](std::int32_t node) { return ownerOf(node) == rank; })) continue;
      own.push_back(e);
      for (const std::int32_t node : nodes) {
        const int owner = ownerOf(node);
        if (owner == rank) continue;
        ghosts.push_back(node);
        for (const std::int32_t other : nodes)
          if (ownerOf(other) == rank) sent[owner].push_back(other);
      }
    }
    elements_ += static_cast<std::int64_t>(own.size());
  }
  sortUnique(ghosts);
  std::stable_sort(ghosts.begin(), ghosts.end(),
                   [&](std::int32_t a, std::int32_t b) { return ownerOf(a) < ownerOf(b); });
  for (std::int32_t node = 0; node < whole.nodeCount(); ++node)
    if (ownerOf(node) == rank) globalNodes_.push_back(node);
  owned_ = static_cast<std::int32_t>(globalNodes_.size());
  globalNodes_.insert(globalNodes_.end(), ghosts.begin(), ghosts.end());
  std::vector<std::int32_t> localOf(all.nodeCount(), -1);
  for (std::size_t i = 0; i < globalNodes_.size(); ++i) localOf[globalNodes_[i]] = static_cast<std::int32_t>(i);
  for (std::size_t first = owned_; first < globalNodes_.size();) {
    const int owner = ownerOf(globalNodes_[first]);
    std::size_t end = first;
    while (end < globalNodes_.size() && ownerOf(globalNodes_[end]) == owner) ++end;
    std::vector<std::int32_t>& own = sent[owner];
    sortUnique(own);
    for (std::int32_t& node : own) node = localOf[node];
    neighbours_.push_back(
        {owner, std::move(own), static_cast<std::int32_t>(first), static_cast<std::int32_t>(end - first)});
    first = end;
  }

  Mesh mesh;
  mesh.X.resize(3, static_cast<Eigen::Index>(globalNodes_.size()));
  Eigen::VectorXd mass(static_cast<Eigen::Index>(globalNodes_.size()));
  for (std::size_t i = 0; i < globalNodes_.size(); ++i) {
    const std::int32_t node = globalNodes_[i];
    mesh.X.col(static_cast<Eigen::Index>(i)) = all.X.col(node);
    mass[static_cast<Eigen::Index>(i)] = whole.lumpedMass()[node];
    mesh.nodeIds.push_back(all.nodeId(node));
  }
  for (std::size_t b = 0; b < all.blocks.size(); ++b) {
    MeshBlock& block = mesh.blocks.emplace_back(MeshBlock{all.blocks[b].type, {}, {}});
    for (const std::int32_t e : globalElements_[b]) {
      block.ids.push_back(all.blocks[b].id(e));
      for (const std::int32_t node : whole.blocks()[b]->nodesOf(e)) block.connectivity.push_back(localOf[node]);
    }
  }
  // Also where a set is empty here, so that all ranks have the same.
  for (const auto& [name, nodes] : all.nodeSets) {
    std::vector<std::int32_t>& own = mesh.nodeSets[name];
    for (const std::int32_t node : nodes)
      if (localOf[node] >= 0) own.push_back(localOf[node]);
    std::sort(own.begin(), own.end());
  }
  for (const auto& [name, elements] : all.elementSets) {
    std::vector<ElementRef>& own = mesh.elementSets[name];
    for (const ElementRef e : elements) {
      const std::vector<std::int32_t>& held = globalElements_[e.block];
      const auto found = std::lower_bound(held.begin(), held.end(), static_cast<std::int32_t>(e.element));
      if (found != held.end() && *found == e.element) own.push_back({e.block, found - held.begin()});
    }
  }
  std::vector<std::unique_ptr<ElementBlock>> blocks;
  for (std::size_t b = 0; b < all.blocks.size(); ++b) {
    const ElementBlock& from = *whole.blocks()[b];
    blocks.push_back(makeElementBlock(mesh, mesh.blocks[b], from.material(), from.rule().name, from.hourglassControl(),
                                      layOutPart(mesh.nodeCount(), from.nodesPerElement(), mesh.blocks[b].connectivity,
                                                 from.layout(), globalElements_[b])));
  }
  std::int64_t patches = 0;
  for (const auto& block : blocks)
    for (const Patch& patch : block->layout().patches) {
      const auto begin = block->layout().nodes.begin();
      const bool owned = std::all_of(begin + patch.nodeBegin, begin + patch.nodeEnd,
                                     [this](std::int32_t node) { return node < owned_; });
      (owned ? patchesOfOwned_ : patchesWithGhosts_).push_back(patches++);
    }
  body_ = std::make_unique<Body>(std::move(mesh), std::move(blocks), std::move(mass), threads);
  for (std::int32_t i = 0; i < body_->nodeCount(); ++i) {
    const std::int32_t node = globalNodes_[i];
    for (int c = 0; c < 3; ++c)
      if (whole.constraints().isConstrained(node, c))
        body_->constraints().move(i, c, whole.constraints().velocity()(c, node));
    body_->externalForce().col(i) = whole.externalForce().col(node);
  }
}

void RankBody::nameElementsBy(const std::vector<std::vector<std::int32_t>>& numbers) {
  for (std::size_t b = 0; b < globalElements_.size(); ++b)
    for (std::int32_t& element : globalElements_[b]) element = numbers[b][element];
}

}  // namespace ringwatch
