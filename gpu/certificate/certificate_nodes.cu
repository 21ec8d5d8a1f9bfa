#include <ringwatch/gpu/certificate/certificate_operations.h>
#include <ringwatch/gpu/cuda_error.h>
#include <ringwatch/monitor/bounds/nodal_weights.h>
#include <ringwatch/gpu/body/patch_kernels.cuh>

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

constexpr int placeBlocks = 64;
/// A thread a ball: [listed][ball][5] to [patch][point][5][thread], the last one of several to that of the element.
__device__ void placeBalls(const BallPlacements& placements, unsigned thread) {
  for (int b = 0; b < placements.count; ++b) {
    const auto& [view, patchThreads, points] = placements.first[b];
    const unsigned listed = min(*view.outsideCount, static_cast<unsigned>(view.capacity));
    const auto balls = static_cast<unsigned>(ballsOfPoints(points));
    for (unsigned i = thread; i < listed * balls; i += placeBlocks * threads) {
      const std::size_t place = view.outsidePlace[i / balls], patch = place / patchThreads;
      const unsigned ball = i % balls;
      const bool ofElement = points > 1 && ball == static_cast<unsigned>(points);
      std::uint32_t* to = (ofElement ? view.centres : view.balls) + place % patchThreads +
                          (ofElement ? patch : patch * points + ball) * 5 * patchThreads;
      for (int k = 0; k < 5; ++k) to[k * patchThreads] = view.newBalls[static_cast<std::size_t>(i) * 5 + k];
    }
  }
  __syncthreads();
  if (threadIdx.x != 0) return;
  __threadfence();
  if (atomicAdd(placements.done, 1U) != placeBlocks - 1) return;
  for (int b = 0; b < placements.count; ++b) *placements.first[b].view.outsideCount = 0;
  *placements.done = 0;
}
__global__ void __launch_bounds__(threads) placeBallsKernel(const BallPlacements placements) {
  placeBalls(placements, blockIdx.x * threads + threadIdx.x);
}
/// The first blocks place balls, the others finish the step.
__global__ void __launch_bounds__(threads)
    finishStepAndPlaceKernel(const NodeView<double> nodes, const BallPlacements placements) {
  const unsigned thread = blockIdx.x * threads + threadIdx.x;
  if (blockIdx.x < placeBlocks)
    placeBalls(placements, thread);
  else
    detail::finishStep(nodes, static_cast<std::int32_t>(thread - placeBlocks * threads));
}

}  // namespace

void launchFinishStepAndPlace(const NodeView<double>& nodes, const BallPlacements& placements, cudaStream_t stream) {
  const std::int32_t shared = nodes.count - nodes.interiorCount;
  finishStepAndPlaceKernel<<<placeBlocks + (shared + threads) / threads, threads, 0, stream>>>(nodes, placements);
  checkLaunch("step of shared nodes");
}
void launchPlaceBalls(const BallPlacements& placements, cudaStream_t stream) {
  placeBallsKernel<<<placeBlocks, threads, 0, stream>>>(placements);
  checkLaunch("new balls");
}
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
