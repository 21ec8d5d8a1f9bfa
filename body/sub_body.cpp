#include <ringwatch/body/discrete_forces.h>
#include <ringwatch/body/sub_body.h>

namespace ringwatch {

Body subBody(const Body& whole, std::span<const ElementRef> elements, std::span<const std::int32_t> nodes,
             Eigen::VectorXd lumpedMass, int threads) {
  const Mesh& all = whole.mesh();
  Mesh mesh;
  mesh.X.resize(3, nodes.size());
  std::vector<std::int32_t> numberOf(all.nodeCount(), -1);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    mesh.X.col(i) = all.X.col(nodes[i]);
    mesh.nodeIds.push_back(all.nodeId(nodes[i]));
    numberOf[nodes[i]] = static_cast<std::int32_t>(i);
  }
  for (const MeshBlock& block : all.blocks) mesh.blocks.push_back({block.type, {}, {}});
  for (const ElementRef e : elements) {
    MeshBlock& block = mesh.blocks[e.block];
    block.ids.push_back(all.blocks[e.block].id(e.element));
    for (const std::int32_t node : whole.blocks()[e.block]->nodesOf(e.element))
      block.connectivity.push_back(numberOf[node]);
  }
  std::vector<std::unique_ptr<ElementBlock>> blocks;
  for (std::size_t b = 0; b < all.blocks.size(); ++b) {
    const ElementBlock& face = *whole.blocks()[b];
    blocks.push_back(
        makeElementBlock(mesh, mesh.blocks[b], face.material(), face.rule().name, face.hourglassControl()));
  }
  Body part(std::move(mesh), std::move(blocks), std::move(lumpedMass), threads);
  for (std::int32_t i = 0; i < part.nodeCount(); ++i)
    for (int c = 0; c < 3; ++c)
      if (whole.constraints().isConstrained(nodes[i], c))
        part.constraints().move(i, c, whole.constraints().velocity()(c, nodes[i]));
  if (whole.elementDamping()) {
    std::vector<std::vector<std::int32_t>> ofBlocks(all.blocks.size());
    for (const ElementRef e : elements) ofBlocks[e.block].push_back(e.element);
    part.setElementDamping(whole, ofBlocks);
  }
  if (const DiscreteForces* discrete = whole.discreteForces()) part.setDiscreteForces(discrete->restrictedTo(nodes));
  return part;
}

}  // namespace ringwatch
