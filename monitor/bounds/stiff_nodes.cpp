#include <ringwatch/monitor/bounds/stiff_nodes.h>

#include <cmath>

#include <ringwatch/base/aligned.h>
#include <ringwatch/monitor/bounds/scaled_tangent.h>

namespace ringwatch {

std::vector<std::int32_t> StiffNodes::find(NodeVectorsView x, std::size_t count) {
  body_.sumOverPatches(diagonal_, workspace_, [&](std::size_t b, std::int32_t p, double* slots) {
    const ElementBlock& block = *body_.blocks()[b];
    const PatchLayout& layout = block.layout();
    const int n = block.nodesPerElement(), size = 3 * n;
    AlignedVector<NativePack> K(size * size);
    const Patch& patch = layout.patches[p];
    for (std::int32_t batch = patch.batchBegin; batch < patch.batchEnd; ++batch) {
      block.tangentBatch(batch, x.data(), reinterpret_cast<double*>(K.data()));
      for (int lane = 0; lane < lanes; ++lane) {
        if (layout.elements[static_cast<std::size_t>(batch) * lanes + static_cast<std::size_t>(lane)] < 0) continue;
        for (int i = 0; i < size; ++i) {
          const auto local = layout.localNodes[(batch * n + i / 3) * lanes + lane];
          slots[4 * static_cast<std::ptrdiff_t>(local) + i % 3] += K[i * size + i][lane];
        }
      }
    }
  });
  std::vector<double> length(static_cast<std::size_t>(body_.nodeCount()));
  for (std::int32_t i = 0; i < body_.nodeCount(); ++i) {
    for (int c = 0; c < 3; ++c) diagonal_(c, i) *= cutFactor(body_, i, c);
    const double own = diagonal_.col(i).norm() / body_.lumpedMass()[i];
    length[i] = std::isfinite(own) ? own : 0;
  }
  std::vector<std::int32_t> nodes;
  while (nodes.size() < count) {
    std::int32_t top = -1;
    for (std::int32_t i = 0; i < body_.nodeCount(); ++i)
      if (length[i] > (top < 0 ? 0 : length[top])) top = i;
    if (top < 0) break;
    nodes.push_back(top);
    length[top] = 0;
    for (const NodalBound::Incidence at : incidences_.incidences(top)) {
      const ElementRef e = incidences_.elementAt(at);
      for (const std::int32_t node : body_.blocks()[e.block]->nodesOf(e.element)) length[node] = 0;
    }
  }
  return nodes;
}

}  // namespace ringwatch
