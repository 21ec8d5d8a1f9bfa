#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

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

/// Fills a layout, one patch after another.
class PatchFiller {
 public:
  PatchFiller(std::size_t nodeCount, int nodesPerElement, std::span<const std::int32_t> connectivity,
              std::size_t elements)
      : nodesPerElement_(nodesPerElement), connectivity_(connectivity), localOf_(nodeCount, -1) {
    layout_.batchOfElement.resize(elements);
    layout_.elements.reserve(elements + lanes);
    layout_.localNodes.reserve((elements + lanes) * static_cast<std::size_t>(nodesPerElement));
  }

  void beginPatch() {
    patch_ = {};
    patch_.batchBegin = layout_.batchCount();
    patch_.nodeBegin = static_cast<std::int32_t>(layout_.nodes.size());
  }
  std::int32_t nodesInPatch() const { return static_cast<std::int32_t>(layout_.nodes.size()) - patch_.nodeBegin; }
  /// Adds a batch of 1 to `lanes` elements.
  void addBatch(std::span<const std::int32_t> batch) {
    const auto n = static_cast<std::size_t>(nodesPerElement_);
    const std::size_t base = layout_.localNodes.size();
    layout_.localNodes.resize(base + n * lanes);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const bool present = lane < batch.size();
      const std::int32_t e = batch[present ? lane : 0];
      if (present) layout_.batchOfElement[e] = static_cast<std::int32_t>(layout_.elements.size());
      layout_.elements.push_back(present ? e : -1);
      for (std::size_t a = 0; a < n; ++a) {
        const std::int32_t node = connectivity_[static_cast<std::size_t>(e) * n + a];
        std::int32_t& local = localOf_[node];
        if (local < 0) {
          local = nodesInPatch();
          layout_.nodes.push_back(node);
        }
        layout_.localNodes[base + a * lanes + lane] = static_cast<std::uint16_t>(local);
      }
    }
  }
  void endPatch() {
    patch_.batchEnd = layout_.batchCount();
    patch_.nodeEnd = static_cast<std::int32_t>(layout_.nodes.size());
    for (std::int32_t i = patch_.nodeBegin; i < patch_.nodeEnd; ++i) localOf_[layout_.nodes[i]] = -1;
    layout_.patches.push_back(patch_);
  }
  PatchLayout take() { return std::move(layout_); }

 private:
  int nodesPerElement_;
  std::span<const std::int32_t> connectivity_;
  std::vector<std::int32_t> localOf_;  // node -> position in the patch, -1: none
  PatchLayout layout_;
  Patch patch_{};
};

}  // namespace

PatchLayout layOutPatches(std::size_t nodeCount, int nodesPerElement, std::span<const std::int32_t> connectivity,
                          const std::vector<std::int32_t>& order) {
  // Rows of positions and slots of a patch, 64 bytes a node, are to stay in a first-level cache of 32 to 48 kB.
  constexpr std::int32_t maxNodes = 448;
  const int n = nodesPerElement;
  PatchFiller filler(nodeCount, n, connectivity, order.size());
  std::span<const std::int32_t> left = order;
  while (!left.empty()) {
    filler.beginPatch();
    while (!left.empty() && filler.nodesInPatch() + lanes * n <= std::max(maxNodes, lanes * n)) {
      const std::size_t taken = std::min<std::size_t>(lanes, left.size());
      filler.addBatch(left.first(taken));
      left = left.subspan(taken);
    }
    filler.endPatch();
  }
  return filler.take();
}

PatchLayout layOutPart(std::size_t nodeCount, int nodesPerElement, std::span<const std::int32_t> connectivity,
                       const PatchLayout& whole, std::span<const std::int32_t> elements) {
  std::vector<std::int32_t> partOf(whole.batchOfElement.size(), -1);  // position in the block -> in the part
  for (std::size_t i = 0; i < elements.size(); ++i) partOf[elements[i]] = static_cast<std::int32_t>(i);
  PatchFiller filler(nodeCount, nodesPerElement, connectivity, elements.size());
  std::vector<std::int32_t> own;
  for (const Patch& patch : whole.patches) {
    bool begun = false;
    for (std::int32_t batch = patch.batchBegin; batch < patch.batchEnd; ++batch) {
      own.clear();
      for (std::int64_t place = std::int64_t{batch} * lanes; place < (std::int64_t{batch} + 1) * lanes; ++place)
        if (const std::int32_t e = whole.elements[place]; e >= 0 && partOf[e] >= 0) own.push_back(partOf[e]);
      if (own.empty()) continue;
      if (!begun) filler.beginPatch();
      begun = true;
      filler.addBatch(own);
    }
    if (begun) filler.endPatch();
  }
  return filler.take();
}

PatchLayout layOutPatches(const Mesh& mesh, const MeshBlock& block) {
  return layOutPatches(mesh.nodeCount(), block.nodesPerElement(), block.connectivity, mortonOrder(mesh, block));
}

}  // namespace ringwatch
