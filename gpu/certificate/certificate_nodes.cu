#include <ringwatch/gpu/certificate/certificate_operations.h>
#include <ringwatch/gpu/cuda_error.h>
#include <ringwatch/monitor/bounds/nodal_weights.h>

namespace ringwatch {
namespace {

constexpr int threads = 128;

/// Weights times element values, summed at the nodes of a patch: those of interior nodes into sums, others into the
/// patch's slots.
__global__ void __launch_bounds__(threads)
    gatherWeightsKernel(const BlockView<double> block, const NodeView<double> nodes, const CertificateView view,
                        const NodalSums sums, int n, int elements, const double* values) {
  const std::size_t patch = blockIdx.x;
  for (int i = static_cast<int>(threadIdx.x); i < block.patches[patch].nodeCount; i += threads) {
    const std::size_t group =
        patch * static_cast<std::size_t>(block.nodeCapacity / 32) + static_cast<std::size_t>(i / 32);
    double sum[6] = {0, 0, 0, 0, 0, 0};
    for (int row = block.groupRow[group]; row < block.groupRow[group + 1]; ++row) {
      const int corner = block.rows[static_cast<std::size_t>(row) * 32 + static_cast<std::size_t>(i % 32)];
      if (corner == n * elements) continue;
      const int a = corner / elements, t = corner % elements;
      const double value = values[patch * static_cast<std::size_t>(elements) + static_cast<std::size_t>(t)];
      const double* weight = view.weights + patch * static_cast<std::size_t>(6 * n * elements) + 6 * a * elements + t;
      for (int c = 0; c < 6; ++c) sum[c] += value * weight[c * elements];
    }
    const std::size_t at = patch * static_cast<std::size_t>(block.nodeCapacity) + static_cast<std::size_t>(i);
    const std::int32_t node = block.nodes[at];
    double* to = node < nodes.interiorCount ? sums.sums + static_cast<std::size_t>(node) * 6
                                            : sums.slots + (static_cast<std::size_t>(block.firstSlot) + at) * 6;
    for (int c = 0; c < 6; ++c) to[c] = sum[c];
  }
}

__device__ unsigned constrainedBits(const NodeView<double>& nodes, std::int32_t node) {
  return nodes.constrained != nullptr ? nodes.constrained[node] : 0U;
}

__global__ void __launch_bounds__(threads) boundNodesKernel(const NodeView<double> nodes, const NodalSums sums) {
  const std::int32_t node = static_cast<std::int32_t>(blockIdx.x) * threads + static_cast<std::int32_t>(threadIdx.x);
  if (node >= nodes.count) return;
  Symmetric3<double> S;
  double* own = sums.sums + static_cast<std::size_t>(node) * 6;
  if (node < nodes.interiorCount) {
    for (int c = 0; c < 6; ++c) S.m[c] = own[c];
  } else {
    for (int c = 0; c < 6; ++c) S.m[c] = 0;
    const std::int32_t shared = node - nodes.interiorCount;
    for (std::int32_t s = nodes.slotBegin[shared]; s < nodes.slotBegin[shared + 1]; ++s)
      for (int c = 0; c < 6; ++c) S.m[c] += sums.slots[static_cast<std::size_t>(nodes.slot[s]) * 6 + c];
  }
  // Constrained components leave the problem: their rows and columns count nothing.
  const unsigned bits = constrainedBits(nodes, node);
  const double inverseMass = nodes.u[node].w;
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j) S(i, j) = (bits >> i & 1U) != 0 || (bits >> j & 1U) != 0 ? 0.0 : inverseMass * S(i, j);
  for (int c = 0; c < 6; ++c) own[c] = S.m[c];
  double A[9], work[12];
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j <= i; ++j) A[3 * i + j] = S(i, j);
  const auto extremes = extremeEigenvaluesOf<3>(A, 3, work, false);
  const double nodal = extremes.largest + eigenvalueRounding * extremes.scale;
  sums.nodal[node] = nodal;
  // Numbers >= 0 order as their bits do, and NaN, made positive, lies above all.
  const double size = nodal <= 0 ? 0.0 : fabs(nodal);
  atomicMax(sums.bound, static_cast<unsigned long long>(__double_as_longlong(size)));
}

__global__ void __launch_bounds__(threads)
    sweepFactorsKernel(const NodeView<double> nodes, const NodalSums sums, double bound) {
  const std::int32_t node = static_cast<std::int32_t>(blockIdx.x) * threads + static_cast<std::int32_t>(threadIdx.x);
  if (node >= nodes.count) return;
  const unsigned bits = constrainedBits(nodes, node);
  Symmetric3<double> S;
  for (int c = 0; c < 6; ++c) S.m[c] = sums.sums[static_cast<std::size_t>(node) * 6 + c] / bound;
  for (int c = 0; c < 3; ++c)
    if ((bits >> c & 1U) != 0) S.m[c] = 1;
  const Symmetric3<double> R = sweepFactor(S);
  for (int c = 0; c < 6; ++c) sums.factors[static_cast<std::size_t>(node) * 6 + c] = R.m[c];
}

}  // namespace

void launchGatherWeights(const BlockView<double>& block, const NodeView<double>& nodes, const CertificateView& view,
                         const NodalSums& sums, int elementNodes, const double* values, cudaStream_t stream) {
  if (block.patchCount == 0) return;
  gatherWeightsKernel<<<block.patchCount, threads, 0, stream>>>(block, nodes, view, sums, elementNodes,
                                                                patchThreads(elementNodes), values);
  checkLaunch("sums of weights");
}
void launchBoundNodes(const NodeView<double>& nodes, const NodalSums& sums, cudaStream_t stream) {
  checkCuda(cudaMemsetAsync(sums.bound, 0, sizeof *sums.bound, stream), "cudaMemset");
  boundNodesKernel<<<(nodes.count + threads - 1) / threads, threads, 0, stream>>>(nodes, sums);
  checkLaunch("bounds of nodes");
}
void launchSweepFactors(const NodeView<double>& nodes, const NodalSums& sums, double bound, cudaStream_t stream) {
  sweepFactorsKernel<<<(nodes.count + threads - 1) / threads, threads, 0, stream>>>(nodes, sums, bound);
  checkLaunch("factors of a sweep");
}

}  // namespace ringwatch
