#include <ringwatch/monitor/bounds/top_mode.h>

#include <utility>
#include <vector>

#include <ringwatch/monitor/bounds/rayleigh.h>
#include <ringwatch/monitor/bounds/scaled_tangent.h>

namespace ringwatch {
namespace {

/// Adds to a start what no ring has: nodes without elements, which springs and contact may hold.
void addNodesAlone(const TangentSource& source, NodeVectors& start) {
  if (!source.discreteForces()) return;
  std::vector<bool> alone(source.nodeCount(), true);
  for (const ElementTangents* block : source.tangents())
    for (std::int32_t e = 0; e < block->elementCount(); ++e)
      for (const std::int32_t node : block->nodesOf(e)) alone[node] = false;
  for (std::int32_t node = 0; node < source.nodeCount(); ++node)
    for (int c = 0; alone[node] && c < 3; ++c) start(c, node) = freeFactor(source, node, c);
}

}  // namespace

TopMode findTopMode(ReducedRing& ring, const TangentSource& source, NodeVectorsView x, NodeVectors& mode,
                    int coldProducts, int warmProducts, bool wantLowest) {
  const ReducedRing::Result& rings = ring.evaluate(x, wantLowest);
  NodeVectors start = ring.topVector(rings.highestElement);
  addNodesAlone(source, start);
  const bool cold = mode.size() == 0;
  if (!cold) start += (start.cwiseProduct(mode).sum() < 0 ? -1.0 : 1.0) * mode;
  mode = std::move(start);
  return {{rings.highest}, rayleighLowerBound(source, x, mode, cold ? coldProducts : warmProducts)};
}

}  // namespace ringwatch
