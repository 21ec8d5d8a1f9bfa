#include <ringwatch/meshes/node_order.h>

#include <algorithm>
#include <utility>

namespace ringwatch {
namespace {

/// Spreads the lower 21 bits of v so that two zero bits follow each.
std::uint64_t spreadBits(std::uint64_t v) {
  v &= 0x1fffff;
  v = (v | v << 32) & 0x1f00000000ffffULL;
  v = (v | v << 16) & 0x1f0000ff0000ffULL;
  v = (v | v << 8) & 0x100f00f00f00f00fULL;
  v = (v | v << 4) & 0x10c30c30c30c30c3ULL;
  v = (v | v << 2) & 0x1249249249249249ULL;
  return v;
}

}  // namespace

std::uint64_t mortonKey(const Eigen::Vector3d& unit) {
  std::uint64_t key = 0;
  for (int c = 0; c < 3; ++c) {
    const double within = unit[c] > 0 ? std::min(unit[c], 1.0) : 0.0;  // 0 for a NaN, which has no integer
    key |= spreadBits(static_cast<std::uint64_t>(within * 2097151.0)) << c;
  }
  return key;
}

void renumberNodes(Mesh& mesh) {
  const std::size_t count = mesh.nodeCount();
  if (count == 0) return;
  const Eigen::Vector3d low = mesh.X.rowwise().minCoeff();
  const double extent = (mesh.X.rowwise().maxCoeff() - low).maxCoeff();
  std::vector<std::pair<std::uint64_t, std::int32_t>> keyed(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector3d from = mesh.X.col(i) - low;
    keyed[i] = {extent > 0 ? mortonKey(from / extent) : 0, static_cast<std::int32_t>(i)};
  }
  std::sort(keyed.begin(), keyed.end());

  std::vector<std::int32_t> place(count);  // new index of each node
  NodeVectors X(3, mesh.X.cols());
  std::vector<std::int64_t> ids(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t old = keyed[i].second;
    place[old] = static_cast<std::int32_t>(i);
    X.col(i) = mesh.X.col(old);
    ids[i] = mesh.nodeId(old);
  }
  mesh.X = std::move(X);
  mesh.nodeIds = std::move(ids);
  for (MeshBlock& block : mesh.blocks)
    for (std::int32_t& node : block.connectivity) node = place[node];
  for (auto& [name, nodes] : mesh.nodeSets) {
    for (std::int32_t& node : nodes) node = place[node];
    std::sort(nodes.begin(), nodes.end());
  }
}

}  // namespace ringwatch
