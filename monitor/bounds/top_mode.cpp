#include <ringwatch/monitor/bounds/top_mode.h>

#include <utility>

#include <ringwatch/monitor/bounds/rayleigh.h>

namespace ringwatch {

TopMode findTopMode(ReducedRing& ring, const TangentSource& source, NodeVectorsView x, NodeVectors& mode,
                    int coldProducts, int warmProducts, bool wantLowest) {
  const ReducedRing::Result& rings = ring.evaluate(x, wantLowest);
  NodeVectors start = ring.topVector(rings.highestElement);
  const bool cold = mode.size() == 0;
  if (!cold) start += (start.cwiseProduct(mode).sum() < 0 ? -1.0 : 1.0) * mode;
  mode = std::move(start);
  return {{rings.highest}, rayleighLowerBound(source, x, mode, cold ? coldProducts : warmProducts)};
}

}  // namespace ringwatch
