#include <limits>

#include <ringwatch/gpu/cuda_error.h>
#include <ringwatch/gpu/tangent_operations.h>
#include <ringwatch/monitor/small/extreme_eigenvalues.h>

namespace ringwatch {
namespace {

constexpr int size = 12;

__global__ void __launch_bounds__(ringThreads) sumPairsKernel(const RingView view) {
  const std::int32_t shared =
      static_cast<std::int32_t>(blockIdx.x) * ringThreads + static_cast<std::int32_t>(threadIdx.x);
  if (shared >= view.pairCount - view.ownCount) return;
  double sum[9] = {};
  for (std::int32_t s = view.sharedBegin[shared]; s < view.sharedBegin[shared + 1]; ++s)
#pragma unroll
    for (int c = 0; c < 9; ++c) sum[c] += view.slots[static_cast<std::size_t>(c) * view.slotCount + view.sharedSlot[s]];
#pragma unroll
  for (int c = 0; c < 9; ++c) view.pair[static_cast<std::size_t>(c) * view.pairCount + view.ownCount + shared] = sum[c];
}

/// NaN above all; of equal ones the first.
__device__ bool above(const HighestRing& a, const HighestRing& b) {
  if (a.value != a.value || b.value != b.value) return a.value != a.value && (b.value == b.value || a.place < b.place);
  return a.value > b.value || (a.value == b.value && a.place < b.place);
}

/// An element a thread; a thread block is a part of a patch, and has all pairs of the patch in shared memory. The 12×12
/// matrix stays in registers, all but some of it: three thread blocks a multiprocessor are worth more than the rest.
__global__ void __launch_bounds__(ringThreads, 3)
    ringEigenvaluesKernel(const BlockView<double> block, const RingBlockView ring, const RingView view, double* largest,
                          HighestRing* highest) {
  constexpr int patchSize = patchThreads(4), parts = patchSize / ringThreads;
  extern __shared__ double sharedMemory[];
  const std::size_t patch = blockIdx.x / parts;
  const int t = static_cast<int>(blockIdx.x % parts) * ringThreads + static_cast<int>(threadIdx.x);
  const RingPatch pairs = ring.patches[patch];
  const bool active = t < block.patches[patch].elementCount;
  if (!active && threadIdx.x == 0) highest[blockIdx.x] = {-std::numeric_limits<double>::infinity(), 0};
  if (static_cast<int>(blockIdx.x % parts) * ringThreads >= block.patches[patch].elementCount) return;

  std::uint16_t local[tetrahedronPairs];
#pragma unroll
  for (int p = 0; p < tetrahedronPairs; ++p) local[p] = ring.pairs[(patch * tetrahedronPairs + p) * patchSize + t];
  for (int l = threadIdx.x; l < pairs.pairCount; l += ringThreads) {
    const std::int32_t at =
        l < pairs.ownCount ? pairs.firstPair + l : view.slotPair[pairs.firstSlot + (l - pairs.ownCount)];
#pragma unroll
    for (int c = 0; c < 9; ++c)
      sharedMemory[c * ring.pairCapacity + l] = view.pair[static_cast<std::size_t>(c) * view.pairCount + at];
  }
  __syncthreads();
  HighestRing own{-std::numeric_limits<double>::infinity(), static_cast<std::int32_t>(patch) * patchSize + t};
  if (active) {
    double A[size * size], work[4 * size];
    int pair = 0;
#pragma unroll
    for (int a = 0; a < 4; ++a)
#pragma unroll
      for (int b = 0; b <= a; ++b, ++pair)
#pragma unroll
        for (int i = 0; i < 3; ++i)
#pragma unroll
          for (int j = 0; j < 3; ++j)
            if (a != b || j <= i)
              A[(3 * a + i) * size + 3 * b + j] = sharedMemory[(3 * i + j) * ring.pairCapacity + local[pair]];
    const auto extremes = extremeEigenvaluesOf<size, double, true>(A, size, work, false);
    largest[patch * patchSize + t] = extremes.largest;
    own.value = extremes.largest - eigenvalueRounding * extremes.scale;
  }
  for (int offset = 16; offset > 0; offset /= 2) {
    const HighestRing other{__shfl_down_sync(0xffffffffU, own.value, offset),
                            __shfl_down_sync(0xffffffffU, own.place, offset)};
    if (above(other, own)) own = other;
  }
  __shared__ HighestRing ofWarp[ringThreads / 32];
  if (threadIdx.x % 32 == 0) ofWarp[threadIdx.x / 32] = own;
  __syncthreads();
  if (threadIdx.x != 0) return;
  for (int w = 1; w < ringThreads / 32; ++w)
    if (above(ofWarp[w], own)) own = ofWarp[w];
  highest[blockIdx.x] = own;
}

}  // namespace

void launchSumPairs(const RingView& view, cudaStream_t stream) {
  const std::int32_t shared = view.pairCount - view.ownCount;
  if (shared == 0) return;
  sumPairsKernel<<<(shared + ringThreads - 1) / ringThreads, ringThreads, 0, stream>>>(view);
  checkLaunch("sums of node pairs");
}
void launchRingEigenvalues(const BlockView<double>& block, const RingBlockView& ring, const RingView& view,
                           double* largest, HighestRing* highest, cudaStream_t stream) {
  if (block.patchCount == 0) return;
  const int bytes = 9 * ring.pairCapacity * static_cast<int>(sizeof(double));
  checkCuda(cudaFuncSetAttribute(ringEigenvaluesKernel, cudaFuncAttributeMaxDynamicSharedMemorySize, bytes),
            "shared memory of the rings");
  ringEigenvaluesKernel<<<ringBlocks(block.patchCount), ringThreads, bytes, stream>>>(block, ring, view, largest,
                                                                                      highest);
  checkLaunch("eigenvalues of the rings");
}

}  // namespace ringwatch
