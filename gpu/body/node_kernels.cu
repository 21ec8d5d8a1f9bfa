#include <ringwatch/gpu/body/patch_kernels.cuh>

namespace ringwatch {
namespace {

constexpr int threads = 128;

template <class R>
__global__ void __launch_bounds__(threads) sumSlotsKernel(const NodeView<R> nodes, Row4<R>* result) {
  const std::int32_t shared = static_cast<std::int32_t>(blockIdx.x) * threads + static_cast<std::int32_t>(threadIdx.x);
  if (shared >= nodes.count - nodes.interiorCount) return;
  R sum[3];
  detail::sumOfSlots(nodes, shared, sum);
  result[nodes.interiorCount + shared] = {sum[0], sum[1], sum[2], R(0)};
}

template <class R>
__global__ void __launch_bounds__(threads) finishStepKernel(const NodeView<R> nodes) {
  detail::finishStep(nodes, static_cast<std::int32_t>(blockIdx.x) * threads + static_cast<std::int32_t>(threadIdx.x));
}

constexpr int sumThreads = 1024;

__global__ void __launch_bounds__(sumThreads) sumKernel(const double* partial, std::int32_t count, double* sum) {
  double own = 0;
  for (std::int32_t i = static_cast<std::int32_t>(threadIdx.x); i < count; i += sumThreads) own += partial[i];
  own = detail::blockSum(own);
  if (threadIdx.x == 0) *sum = own;
}

template <class R>
__global__ void __launch_bounds__(sumThreads) kineticKernel(const NodeView<R> nodes, double* partial) {
  double own = 0;
  for (std::int32_t i = static_cast<std::int32_t>(blockIdx.x * sumThreads + threadIdx.x); i < nodes.count;
       i += kineticParts * sumThreads) {
    double v2 = 0;
    for (int c = 0; c < 3; ++c) {
      const double v = static_cast<double>(nodes.v[static_cast<std::size_t>(c) * nodes.count + i]);
      v2 += v * v;
    }
    own += 0.5 * v2 / static_cast<double>(nodes.u[i].w);
  }
  own = detail::blockSum(own);
  if (threadIdx.x == 0) partial[blockIdx.x] = own;
}

}  // namespace

template <class R>
void launchSumSlots(const NodeView<R>& nodes, Row4<R>* result, cudaStream_t stream) {
  const std::int32_t shared = nodes.count - nodes.interiorCount;
  if (shared == 0) return;
  sumSlotsKernel<<<(shared + threads - 1) / threads, threads, 0, stream>>>(nodes, result);
  checkLaunch("sum of slots");
}
template <class R>
void launchFinishStep(const NodeView<R>& nodes, cudaStream_t stream) {
  const std::int32_t shared = nodes.count - nodes.interiorCount;
  finishStepKernel<<<(shared + threads) / threads, threads, 0, stream>>>(nodes);  // one block at least
  checkLaunch("step of shared nodes");
}
void launchSum(const double* partial, std::int32_t count, double* sum, cudaStream_t stream) {
  sumKernel<<<1, sumThreads, 0, stream>>>(partial, count, sum);
  checkLaunch("sum");
}
template <class R>
void launchKineticEnergy(const NodeView<R>& nodes, double* partial, double* sum, cudaStream_t stream) {
  kineticKernel<<<kineticParts, sumThreads, 0, stream>>>(nodes, partial);
  checkLaunch("kinetic energy");
  launchSum(partial, kineticParts, sum, stream);
}

template void launchSumSlots(const NodeView<double>&, Row4<double>*, cudaStream_t);
template void launchSumSlots(const NodeView<float>&, Row4<float>*, cudaStream_t);
template void launchFinishStep(const NodeView<double>&, cudaStream_t);
template void launchFinishStep(const NodeView<float>&, cudaStream_t);
template void launchKineticEnergy(const NodeView<double>&, double*, double*, cudaStream_t);
template void launchKineticEnergy(const NodeView<float>&, double*, double*, cudaStream_t);

}  // namespace ringwatch
