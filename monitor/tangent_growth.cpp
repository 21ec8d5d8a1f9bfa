#include <ringwatch/monitor/tangent_growth.h>

namespace ringwatch {

void strainNormBounds(const Body& body, const NodalBound& weights, std::int32_t b, const std::int32_t* elements,
                      double* norms) {
  const ElementBlock& block = *body.blocks()[static_cast<std::size_t>(b)];
  const int n = block.nodesPerElement(), size = 3 * n;
  NativePack L[maxElementNodes * maxElementNodes], A[9 * maxElementNodes * maxElementNodes];
  block.laplacianOf(elements, reinterpret_cast<double*>(L));
  for (int i = 0; i < size; ++i)
    for (int j = 0; j < size; ++j) A[i * size + j] = i % 3 == j % 3 ? L[i / 3 * n + j / 3] : NativePack(0.0);
  weights.weightedLargest(b, elements, A, norms);
}

}  // namespace ringwatch
