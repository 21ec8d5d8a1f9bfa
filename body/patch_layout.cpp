#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <ringwatch/body/patch_layout.h>
#include <ringwatch/meshes/node_order.h>

namespace ringwatch {
namespace {

/// Elements along a Morton curve through their centroids: neighbours in the list are neighbours in space.
std::vector<std::int32_t> mortonOrder(const Mesh& mesh, const MeshBlock& block) {
  const std::size_t count = block.elementCount();
  const int n = block.nodesPerElement();
  const Eigen::Vector3d low = mesh.X.rowwise().minCoeff(), size = mesh.X.rowwise().maxCoeff() - low;
  const double extent = std::max(size.maxCoeff(), std::numeric_limits<double>::min());
  std::vector<std::pair<std::uint64_t, std::int32_t>> keyed(count);
  for (std::size_t e = 0; e < count; ++e) {
    Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
    for (int a = 0; a < n; ++a) centroid += mesh.X.col(block.element(e)[a]);
    keyed[e] = {mortonKey((centroid / n - low) / extent), static_cast<std::int32_t>(e)};
  }
  std::sort(keyed.begin(), keyed.end());
  std::vector<std::int32_t> order(count);
  for (std::size_t e = 0; e < count; ++e) order[e] = keyed[e].second;
  return order;
}

}  // namespace

PatchLayout layOutPatches(std::size_t nodeCount, int nodesPerElement, std::span<const std::int32_t> connectivity,
                          const std::vector<std::int32_t>& order) {
  // Rows of positions and slots of a patch, 64 bytes a node, are to stay in a first-level cache of 32 to 48 kB.
  constexpr std::int32_t maxNodes = 448;
  const int n = nodesPerElement;
  PatchLayout layout;
  layout.batchOfElement.resize(order.size());
  layout.elements.reserve(order.size() + lanes);
  layout.localNodes.reserve((order.size() + lanes) * static_cast<std::size_t>(n));
  std::vector<std::int32_t> localOf(nodeCount, -1);

  std::size_t next = 0;
  while (next < order.size()) {
    Patch patch{};
    patch.batchBegin = layout.batchCount();
    patch.nodeBegin = static_cast<std::int32_t>(layout.nodes.size());
    auto nodesInPatch = [&] { return static_cast<std::int32_t>(layout.nodes.size()) - patch.nodeBegin; };
    while (next < order.size() && nodesInPatch() + lanes * n <= std::max(maxNodes, lanes * n)) {
      const std::size_t taken = std::min<std::size_t>(lanes, order.size() - next);
      const std::size_t base = layout.localNodes.size();
      layout.localNodes.resize(base + static_cast<std::size_t>(n * lanes));
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        const bool present = lane < taken;
        const std::int32_t e = order[next + (present ? lane : 0)];
        if (present) layout.batchOfElement[e] = static_cast<std::int32_t>(layout.elements.size());
        layout.elements.push_back(present ? e : -1);
        for (int a = 0; a < n; ++a) {
          const std::int32_t node =
              connectivity[static_cast<std::size_t>(e) * static_cast<std::size_t>(n) + static_cast<std::size_t>(a)];
          std::int32_t& local = localOf[node];
          if (local < 0) {
            local = nodesInPatch();
            layout.nodes.push_back(node);
          }
          layout.localNodes[base + static_cast<std::size_t>(a * lanes) + lane] = static_cast<std::uint16_t>(local);
        }
      }
      next += taken;
    }
    patch.batchEnd = layout.batchCount();
    patch.nodeEnd = static_cast<std::int32_t>(layout.nodes.size());
    for (std::int32_t i = patch.nodeBegin; i < patch.nodeEnd; ++i) localOf[layout.nodes[i]] = -1;
    layout.patches.push_back(patch);
  }
  return layout;
}

PatchLayout layOutPatches(const Mesh& mesh, const MeshBlock& block) {
  return layOutPatches(mesh.nodeCount(), block.nodesPerElement(), block.connectivity, mortonOrder(mesh, block));
}

}  // namespace ringwatch
