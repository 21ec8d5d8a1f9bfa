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
  const Eigen::Vector3d low = mesh.X.rowwise().minCoeff();
  const double extent = curveExtent(low, mesh.X.rowwise().maxCoeff());
  std::vector<std::pair<std::uint64_t, std::int32_t>> keyed(count);
  for (std::size_t e = 0; e < count; ++e)
    keyed[e] = {curveKey(mesh.X, block.element(e), n, low, extent), static_cast<std::int32_t>(e)};
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

std::uint64_t curveKey(const NodeVectors& X, const std::int32_t* nodes, int n, const Eigen::Vector3d& low,
                       double extent) {
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
  for (int a = 0; a < n; ++a) centroid += X.col(nodes[a]);
  return mortonKey((centroid / n - low) / extent);
}

double curveExtent(const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
  const Eigen::Vector3d size = high - low;
  return std::max(size.maxCoeff(), std::numeric_limits<double>::min());
}

bool takesAnotherBatch(std::int32_t nodesInPatch, int nodesPerElement) {
  // Rows of positions and slots of a patch, 64 bytes a node, are to stay in a first-level cache of 32 to 48 kB.
  constexpr std::int32_t maxNodes = 448;
  const std::int32_t more = lanes * nodesPerElement;
  return nodesInPatch + more <= std::max(maxNodes, more);
}

PatchLayout layOutPatches(std::size_t nodeCount, int nodesPerElement, std::span<const std::int32_t> connectivity,
                          const std::vector<std::int32_t>& order) {
  const int n = nodesPerElement;
  PatchFiller filler(nodeCount, n, connectivity, order.size());
  std::span<const std::int32_t> left = order;
  while (!left.empty()) {
    filler.beginPatch();
    while (!left.empty() && takesAnotherBatch(filler.nodesInPatch(), n)) {
      const std::size_t taken = std::min<std::size_t>(lanes, left.size());
      filler.addBatch(left.first(taken));
      left = left.subspan(taken);
    }
    filler.endPatch();
  }
  return filler.take();
}

PatchLayout layOutPart(std::size_t nodeCount, int nodesPerElement, std::span<const std::int32_t> connectivity,
                       std::span<const PatchPlace> places) {
  std::vector<std::int32_t> order(places.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](std::int32_t p, std::int32_t q) { return places[p].place < places[q].place; });
  PatchFiller filler(nodeCount, nodesPerElement, connectivity, places.size());
  std::span<const std::int32_t> left = order;
  const auto leading = [&](const auto& belongs) {
    std::size_t count = 0;
    while (count < left.size() && belongs(places[left[count]])) ++count;
    return count;
  };
  while (!left.empty()) {
    const std::int32_t patch = places[left.front()].patch;
    filler.beginPatch();
    while (!left.empty() && places[left.front()].patch == patch) {
      const std::int32_t batch = places[left.front()].place / lanes;
      const std::size_t taken = leading([&](const PatchPlace& at) { return at.place / lanes == batch; });
      filler.addBatch(left.first(taken));
      left = left.subspan(taken);
    }
    filler.endPatch();
  }
  return filler.take();
}

std::vector<PatchPlace> placesOf(const PatchLayout& whole, std::span<const std::int32_t> elements) {
  std::vector<std::int32_t> patchOfBatch;
  for (std::size_t p = 0; p < whole.patches.size(); ++p)
    patchOfBatch.resize(static_cast<std::size_t>(whole.patches[p].batchEnd), static_cast<std::int32_t>(p));
  std::vector<PatchPlace> places;
  places.reserve(elements.size());
  for (const std::int32_t e : elements) {
    const std::int32_t place = whole.batchOfElement[e];
    places.push_back({patchOfBatch[place / lanes], place});
  }
  return places;
}

PatchLayout layOutPatches(const Mesh& mesh, const MeshBlock& block) {
  return layOutPatches(mesh.nodeCount(), block.nodesPerElement(), block.connectivity, mortonOrder(mesh, block));
}

}  // namespace ringwatch
