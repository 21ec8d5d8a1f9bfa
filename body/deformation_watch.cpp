#include <ringwatch/body/deformation_watch.h>

#include <algorithm>

namespace ringwatch {

DeformationWatch::DeformationWatch(const ElementBlock& block) {
  constexpr int lanes = PatchLayout::lanes;
  const PatchLayout& layout = block.layout();
  const auto n = static_cast<std::size_t>(block.element().nodes);
  const auto batches = static_cast<std::size_t>(layout.batchCount());
  anchor.assign(batches * block.rule().points.size() * 9 * lanes, 0.0F);
  radius.assign(batches * lanes, -1.0F);
  gradientNorm.resize(batches * lanes);
  double norms[lanes];
  for (std::int32_t batch = 0; batch < layout.batchCount(); ++batch) {
    block.gradientNormBatch(batch, norms);
    for (int lane = 0; lane < lanes; ++lane)  // rounded up
      gradientNorm[static_cast<std::size_t>(batch * lanes + lane)] = static_cast<float>(norms[lane] * (1 + 1e-6));
  }
  patchGroups.push_back(0);
  for (const Patch& patch : layout.patches) {
    for (std::int32_t first = patch.batchBegin; first < patch.batchEnd; first += groupBatches) {
      Group group;
      group.batchBegin = first;
      group.batchEnd = std::min(patch.batchEnd, first + groupBatches);
      group.nodeBegin = static_cast<std::int32_t>(groupNodes.size());
      const auto from =
          layout.localNodes.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(first) * n * lanes);
      const auto to =
          layout.localNodes.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(group.batchEnd) * n * lanes);
      std::vector<std::uint16_t> nodes(from, to);
      std::sort(nodes.begin(), nodes.end());
      nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
      groupNodes.insert(groupNodes.end(), nodes.begin(), nodes.end());
      group.nodeEnd = static_cast<std::int32_t>(groupNodes.size());
      groups.push_back(group);
    }
    patchGroups.push_back(static_cast<std::int32_t>(groups.size()));
  }
  lookedAt.assign(4 * groupNodes.size(), 0.0);
}

}  // namespace ringwatch
