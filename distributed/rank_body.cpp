#include <ringwatch/distributed/rank_body.h>

#include <algorithm>
#include <utility>

#include <ringwatch/base/error.h>
#include <ringwatch/meshes/part_of_mesh.h>

namespace ringwatch {

RankBody::RankBody(const Body& whole, const Partition& partition, int rank, int threads) {
  if (whole.discreteForces()) throw InputError("springs and contact are not distributed over ranks");
  if (whole.elementDamping()) throw InputError("elements that damp are not distributed over ranks");
  if (partition.ofNode.size() != static_cast<std::size_t>(whole.nodeCount()))
    throw InputError(joinText("a partition of ", partition.ofNode.size(), " nodes: the body has ", whole.nodeCount()));
  const Mesh& all = whole.mesh();
  const auto ownerOf = [&](std::int32_t node) { return partition.ofNode[node]; };

  std::vector<std::vector<bool>> touched;
  std::vector<std::vector<std::int32_t>> elements;
  for (std::size_t b = 0; b < all.blocks.size(); ++b) {
    std::vector<bool>& flags = touched.emplace_back(all.blocks[b].elementCount());
    std::vector<std::int32_t>& numbers = elements.emplace_back();
    for (std::int32_t e = 0; e < whole.blocks()[b]->elementCount(); ++e) {
      const auto nodes = whole.blocks()[b]->nodesOf(e);
      flags[e] = std::any_of(nodes.begin(), nodes.end(), [&](std::int32_t node) { return ownerOf(node) == rank; });
      if (flags[e]) numbers.push_back(e);
    }
  }
  Mesh held = meshOfElements(all, touched);
  std::vector<std::int32_t> owned;
  for (std::int32_t node = 0; node < whole.nodeCount(); ++node)
    if (ownerOf(node) == rank) owned.push_back(node);
  RankPart part(rank, std::move(held.blocks), std::move(elements), std::move(owned), ownerOf);

  Mesh& mesh = part.mesh;
  const std::vector<std::int32_t>& nodes = part.globalNodes;
  mesh.X.resize(3, static_cast<Eigen::Index>(nodes.size()));
  Eigen::VectorXd mass(static_cast<Eigen::Index>(nodes.size()));
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    mesh.X.col(static_cast<Eigen::Index>(i)) = all.X.col(nodes[i]);
    mass[static_cast<Eigen::Index>(i)] = whole.lumpedMass()[nodes[i]];
    mesh.nodeIds.push_back(all.nodeId(nodes[i]));
  }
  // Also where a set is empty here, so that all ranks have the same.
  for (const auto& [name, members] : all.nodeSets) {
    std::vector<std::int32_t>& set = mesh.nodeSets[name];
    for (const std::int32_t node : members)
      if (const std::int32_t local = part.localNode(node); local >= 0) set.push_back(local);
    std::sort(set.begin(), set.end());
  }
  mesh.elementSets = std::move(held.elementSets);
  Blocks blocks;
  for (std::size_t b = 0; b < all.blocks.size(); ++b) {
    const ElementBlock& from = *whole.blocks()[b];
    blocks.push_back(makeElementBlock(mesh, mesh.blocks[b], from.material(), from.rule().name, from.hourglassControl(),
                                      layOutPart(mesh.nodeCount(), from.nodesPerElement(), mesh.blocks[b].connectivity,
                                                 placesOf(from.layout(), part.globalElements[b]))));
  }
  take(std::move(part), std::move(blocks), std::move(mass), threads);
  for (std::int32_t i = 0; i < body_->nodeCount(); ++i) {
    const std::int32_t node = part_.globalNodes[i];
    for (int c = 0; c < 3; ++c)
      if (whole.constraints().isConstrained(node, c)) {
        if (whole.constraints().moving()) body_->constraints().move(i, c, 1);  // what moves once counts as moving
        body_->constraints().move(i, c, whole.constraints().velocity()(c, node));
      }
    body_->externalForce().col(i) = whole.externalForce().col(node);
  }
}

std::optional<ElementRef> RankBody::localElement(ElementRef global) const {
  const std::vector<std::int32_t>& held = part_.globalElements[global.block];
  const auto found = std::lower_bound(held.begin(), held.end(), global.element);
  if (found == held.end() || *found != global.element) return {};
  return ElementRef(global.block, found - held.begin());
}

void RankBody::nameElementsBy(const std::vector<std::vector<std::int32_t>>& numbers) {
  for (std::size_t b = 0; b < numbers.size(); ++b)
    for (std::int32_t& element : part_.globalElements[b]) element = numbers[b][element];
}

RankBody::RankBody(RankPart part, std::vector<std::unique_ptr<ElementBlock>> blocks, Eigen::VectorXd lumpedMass,
                   int threads) {
  take(std::move(part), std::move(blocks), std::move(lumpedMass), threads);
}

void RankBody::take(RankPart part, Blocks blocks, Eigen::VectorXd mass, int threads) {
  body_ = std::make_unique<Body>(std::move(part.mesh), std::move(blocks), std::move(mass), threads);
  part_ = std::move(part);
  part_.places = {};
  part_.byNumber = {};
  std::int64_t patches = 0;
  for (const auto& block : body_->blocks())
    for (const Patch& patch : block->layout().patches) {
      const auto begin = block->layout().nodes.begin();
      const bool owned = std::all_of(begin + patch.nodeBegin, begin + patch.nodeEnd,
                                     [this](std::int32_t node) { return node < ownedNodes(); });
      (owned ? patchesOfOwned_ : patchesWithGhosts_).push_back(patches++);
    }
}

}  // namespace ringwatch
