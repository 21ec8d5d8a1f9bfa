#include <ringwatch/gpu/certificate/device_positions.h>
#include <ringwatch/gpu/cuda_error.h>

namespace ringwatch {
namespace {

constexpr int threads = 128;

__global__ void __launch_bounds__(threads)
    takePositionsKernel(const NodeView<double> nodes, const std::int32_t* meshNode, const double* reference,
                        const double* x) {
  const std::int32_t node = static_cast<std::int32_t>(blockIdx.x) * threads + static_cast<std::int32_t>(threadIdx.x);
  if (node >= nodes.count) return;
  const double* at = x + 3 * static_cast<std::size_t>(meshNode[node]);
  const double* rest = reference + 3 * static_cast<std::size_t>(node);
  Row4<double> row = nodes.u[node];
  row.x = at[0] - rest[0];
  row.y = at[1] - rest[1];
  row.z = at[2] - rest[2];
  nodes.u[node] = row;
  for (std::size_t c = 0; c < 3; ++c) nodes.v[c * nodes.count + node] = 0;
}

}  // namespace

void launchTakePositions(const NodeView<double>& nodes, const std::int32_t* meshNode, const double* reference,
                         const double* x, cudaStream_t stream) {
  takePositionsKernel<<<(nodes.count + threads - 1) / threads, threads, 0, stream>>>(nodes, meshNode, reference, x);
  checkLaunch("positions of another program");
}

}  // namespace ringwatch
