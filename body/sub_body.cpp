#include <ringwatch/body/sub_body.h>

namespace ringwatch {

Body subBody(const Body& whole, const std::vector<std::vector<std::int32_t>>& elements,
             std::span<const std::int32_t> nodes, Eigen::VectorXd lumpedMass, int threads) {
  const Mesh& all = whole.mesh();
  Mesh mesh;
  mesh.X.resize(3, static_cast<Eigen::Index>(nodes.size()));
  std::vector<std::int32_t> numberOf(all.nodeCount(), -1);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    mesh.X.col(static_cast<Eigen::Index>(i)) = all.X.col(nodes[i]);
    mesh.nodeIds.push_back(all.nodeId(nodes[i]));
    numberOf[nodes[i]] = static_cast<std::int32_t>(i);
  }
  for (std::size_t b = 0; b < all.blocks.size(); ++b) {
    const MeshBlock& from = all.blocks[b];
    MeshBlock block{from.type, {}, {}};
    for (const std::int32_t e : elements[b]) {
      block.ids.push_back(from.id(static_cast<std::size_t>(e)));
      for (const std::int32_t node : whole.blocks()[b]->nodesOf(e)) block.connectivity.push_back(numberOf[node]);
    }
    mesh.blocks.push_back(std::move(block));
  }
  std::vector<std::unique_ptr<ElementBlock>> blocks;
  for (std::size_t b = 0; b < all.blocks.size(); ++b) {
    const ElementBlock& face = *whole.blocks()[b];
    blocks.push_back(makeElementBlock(mesh, mesh.blocks[b], face.material(), face.rule().name));
  }
  Body part(std::move(mesh), std::move(blocks), std::move(lumpedMass), threads);
  for (std::int32_t i = 0; i < part.nodeCount(); ++i)
    for (int c = 0; c < 3; ++c)
      if (whole.constraints().isConstrained(nodes[i], c))
        part.constraints().move(i, c, whole.constraints().velocity()(c, nodes[i]));
  return part;
}

}  // namespace ringwatch
