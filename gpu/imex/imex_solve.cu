#include <ringwatch/base/matrix3.h>
#include <ringwatch/gpu/cuda_error.h>
#include <ringwatch/gpu/imex/imex_operations.h>

namespace ringwatch {
namespace {

constexpr int warpsOfBlock = imexThreads / 32;
constexpr unsigned everyLane = 0xffffffffU;

/// What a lane of a slice stands for.
struct Lane {
  int own, component;  // node of the slice; idle lanes have -1 as their device node
  std::size_t at;      // in vectors over the lanes
  std::int32_t node;
  bool held;
  __device__ Lane(const ImexView& m, const NodeView<double>& nodes, std::int32_t slice) {
    const int lane = static_cast<int>(threadIdx.x % 32);
    own = lane / 3;
    component = lane % 3;
    at = static_cast<std::size_t>(slice) * 32 + static_cast<std::size_t>(lane);
    node = own < sliceNodes ? m.node[static_cast<std::size_t>(slice) * sliceNodes + static_cast<std::size_t>(own)] : -1;
    held = node >= 0 && nodes.constrained != nullptr && (nodes.constrained[node] >> component & 1U) != 0;
  }
  __device__ bool free() const { return node >= 0 && !held; }
};

__global__ void __launch_bounds__(imexThreads) keepNodesKernel(const ImexView m, const NodeView<double> nodes) {
  const std::int32_t slice = static_cast<std::int32_t>(blockIdx.x * warpsOfBlock + threadIdx.x / 32);
  if (blockIdx.x == 0 && threadIdx.x == 0) m.status->step = nodes.clock->step;
  if (slice >= m.sliceCount) return;
  const Lane lane(m, nodes, slice);
  const bool real = lane.node >= 0;
  m.u[lane.at] = real ? (&nodes.u[lane.node].x)[lane.component] : 0;
  m.v[lane.at] = real ? nodes.v[static_cast<std::size_t>(lane.component) * nodes.count + lane.node] : 0;
}

constexpr int rotationThreads = 128;

/// A block of an element a thread. Results go through shared memory, so that whole lines are written.
__global__ void __launch_bounds__(rotationThreads) rotateBlocksKernel(const ImexElementsView elements) {
  __shared__ double stage[rotationThreads * 9];
  const std::int32_t first = static_cast<std::int32_t>(blockIdx.x) * rotationThreads;
  const std::int32_t own = min(rotationThreads, elements.count - first);
  const std::size_t pair = blockIdx.y, count = elements.count;
  if (static_cast<std::int32_t>(threadIdx.x) < own) {
    const std::size_t e = static_cast<std::size_t>(first) + threadIdx.x;
    Matrix3<double> K, R;
#pragma unroll
    for (int i = 0; i < 9; ++i) {
      K.m[i] = elements.rest[(9 * pair + i) * count + e];
      R.m[i] = elements.rotation[i * count + e];
    }
    const Matrix3<double> rotated = elements.rotation[9 * count + e] * timesTranspose(R * K, R);
#pragma unroll
    for (int i = 0; i < 9; ++i) stage[threadIdx.x * 9 + i] = rotated.m[i];
  }
  __syncthreads();
  double* const to = elements.rotated + (pair * count + static_cast<std::size_t>(first)) * 9;
  for (std::int32_t i = static_cast<std::int32_t>(threadIdx.x); i < 9 * own; i += rotationThreads) to[i] = stage[i];
}

/// A row of a slice a warp, a row of a block a lane.
__global__ void __launch_bounds__(imexThreads) assembleKernel(const ImexView m, const NodeView<double> nodes) {
  const std::int32_t row = static_cast<std::int32_t>(blockIdx.x * warpsOfBlock + threadIdx.x / 32);
  if (row >= m.rowCount) return;
  const std::int32_t slice = m.matrix.slice[row];
  const Lane lane(m, nodes, slice);
  double sum[3] = {0, 0, 0};
  bool diagonal = false;
  if (lane.node >= 0) {
    const std::int32_t* first = m.matrix.first + static_cast<std::size_t>(row) * sliceNodes + lane.own;
    diagonal = m.matrix.column[static_cast<std::size_t>(row) * sliceNodes + lane.own] == slice * 32 + 3 * lane.own &&
               first[0] < first[1];
#pragma unroll 4
    for (std::int32_t k = first[0]; k < first[1]; ++k) {
      const ImexContribution from = __ldg(m.matrix.contributions + k);
      const double* block = m.matrix.rotated + static_cast<std::size_t>(from < 0 ? ~from : from) * 9;
      const int begin = from < 0 ? lane.component : 3 * lane.component, stride = from < 0 ? 3 : 1;
#pragma unroll
      for (int j = 0; j < 3; ++j) sum[j] += __ldg(block + begin + j * stride);
    }
#pragma unroll
    for (int j = 0; j < 3; ++j)
      if (diagonal && j == lane.component) sum[j] += m.mass[lane.at];
  }
  const std::size_t own = threadIdx.x % 32;
#pragma unroll
  for (int j = 0; j < 3; ++j) m.matrix.value[static_cast<std::size_t>(row) * 96 + 32 * j + own] = sum[j];
  // The inverse diagonal block without constrained rows and columns; all lanes take part.
  Matrix3<double> D;
  unsigned held = 0;
#pragma unroll
  for (int i = 0; i < 3; ++i) {
    const int from = min(3 * lane.own + i, 31);
    held |= __shfl_sync(everyLane, lane.held ? 1U : 0U, from) << i;
#pragma unroll
    for (int j = 0; j < 3; ++j) D(i, j) = __shfl_sync(everyLane, sum[j], from);
  }
  if (!diagonal) return;
#pragma unroll
  for (int i = 0; i < 3; ++i)
#pragma unroll
    for (int j = 0; j < 3; ++j)
      if ((held >> i & 1U) != 0 || (held >> j & 1U) != 0) D(i, j) = i == j ? 1 : 0;
  const Matrix3<double> P = inverse(D);
#pragma unroll
  for (int j = 0; j < 3; ++j)
    m.matrix.preconditioner[(static_cast<std::size_t>(slice) * 3 + static_cast<std::size_t>(j)) * 32 + own] =
        lane.component == 0   ? P(0, j)
        : lane.component == 1 ? P(1, j)
                              : P(2, j);
}

/// Two sums over a warp, the same bits in all lanes.
__device__ void warpSum(double (&sum)[2]) {
#pragma unroll
  for (int offset = 16; offset > 0; offset /= 2)
#pragma unroll
    for (double& value : sum) value += __shfl_xor_sync(everyLane, value, offset);
}

/// Who solves a cluster: a warp, a thread block, or several. warp() of warps() take the slices in turn; synchronize()
/// makes what all of them wrote known to all; sum() does that too, and adds in a fixed order.
struct WarpTeam {
  __device__ int warp() const { return 0; }
  __device__ int warps() const { return 1; }
  __device__ void synchronize() { __syncwarp(); }
  __device__ void sum(double (&value)[2]) {
    warpSum(value);
    __syncwarp();
  }
};

struct BlockTeam {
  double (*ofWarp)[warpsOfBlock][2];  // two of them, used in turn, so that one barrier a sum is enough
  int turn = 0;
  __device__ explicit BlockTeam(double (*shared)[warpsOfBlock][2]) : ofWarp(shared) {}
  __device__ int warp() const { return static_cast<int>(threadIdx.x / 32); }
  __device__ int warps() const { return warpsOfBlock; }
  __device__ void synchronize() { __syncthreads(); }
  __device__ void sum(double (&value)[2]) {
    warpSum(value);
    turn ^= 1;
    if (threadIdx.x % 32 == 0) {
      ofWarp[turn][warp()][0] = value[0];
      ofWarp[turn][warp()][1] = value[1];
    }
    __syncthreads();
    value[0] = value[1] = 0;
#pragma unroll
    for (int w = 0; w < warpsOfBlock; ++w) {
      value[0] += ofWarp[turn][w][0];
      value[1] += ofWarp[turn][w][1];
    }
  }
};

/// Blocks that are all resident: the launch is cooperative.
struct GridTeam {
  BlockTeam block;
  ImexTeam team;
  unsigned long long* arrived;
  double* partial;  // [block of the team][turn][2]
  int turn = 0;
  __device__ GridTeam(double (*shared)[warpsOfBlock][2], const ImexView& m, const ImexTeam& own, std::int32_t number)
      : block(shared), team(own), arrived(m.arrived + number), partial(m.partial + 4 * own.firstBlock) {}
  __device__ int place() const { return static_cast<int>(blockIdx.x) - team.firstBlock; }
  __device__ int warp() const { return block.warp() * team.blockCount + place(); }
  __device__ int warps() const { return warpsOfBlock * team.blockCount; }
  __device__ void synchronize() {
    __syncthreads();
    if (threadIdx.x == 0) {
      const auto count = static_cast<unsigned long long>(team.blockCount);
      __threadfence();
      // Every barrier counts on by as many blocks as there are, in every launch, so that it never needs a reset.
      const unsigned long long goal = (atomicAdd(arrived, 1ULL) / count + 1) * count;
      while (*static_cast<volatile unsigned long long*>(arrived) < goal) {
      }
      __threadfence();
    }
    __syncthreads();
  }
  __device__ void sum(double (&value)[2]) {
    block.sum(value);
    turn ^= 1;
    if (threadIdx.x == 0) {
      partial[4 * place() + 2 * turn] = value[0];
      partial[4 * place() + 2 * turn + 1] = value[1];
    }
    synchronize();
    value[0] = value[1] = 0;
    for (int b = static_cast<int>(threadIdx.x % 32); b < team.blockCount; b += 32) {
      value[0] += __ldcg(partial + 4 * b + 2 * turn);
      value[1] += __ldcg(partial + 4 * b + 2 * turn + 1);
    }
    warpSum(value);
  }
};

/// Σ_j A_ij z_j, the lane's component.
__device__ double rowProduct(const ImexView& m, std::int32_t slice, const Lane& lane) {
  double sum = 0;
  if (lane.node >= 0) {
    const std::int32_t end = m.matrix.rowBegin[slice + 1];
    const std::size_t own = threadIdx.x % 32;
#pragma unroll 4
    for (std::int32_t row = m.matrix.rowBegin[slice]; row < end; ++row) {
      const double* value = m.matrix.value + static_cast<std::size_t>(row) * 96 + own;
      const double* z = m.z + __ldg(m.matrix.column + static_cast<std::size_t>(row) * sliceNodes + lane.own);
      sum += __ldg(value) * z[0] + __ldg(value + 32) * z[1] + __ldg(value + 64) * z[2];
    }
  }
  return sum;
}

/// What an iteration keeps of a lane: in registers where a warp has but one slice, else in device memory.
template <bool single>
struct LaneNumbers {
  double r, z, p, s, q, solution;
  __device__ LaneNumbers(const ImexView& /*m*/, std::size_t /*at*/) : r(0), z(0), p(0), s(0), q(0), solution(0) {}
};
template <>
struct LaneNumbers<false> {
  double &r, &z, &p, &s, &q, &solution;
  __device__ LaneNumbers(const ImexView& m, std::size_t at)
      : r(m.r[at]), z(m.z[at]), p(m.p[at]), s(m.s[at]), q(m.q[at]), solution(m.solution[at]) {}
};

/// The lane's component of the preconditioner times r; all lanes of the warp take part.
__device__ double preconditioned(const ImexView& m, std::int32_t slice, const Lane& lane, double r) {
  double z = 0;
#pragma unroll
  for (int j = 0; j < 3; ++j) {
    const double other = __shfl_sync(everyLane, r, min(3 * lane.own + j, 31));
    if (lane.node >= 0)
      z += __ldg(m.matrix.preconditioner + (static_cast<std::size_t>(slice) * 3 + static_cast<std::size_t>(j)) * 32 +
                 threadIdx.x % 32) *
           other;
  }
  return z;
}

/// ImplicitCluster's equations, and its conjugate gradients in the form with both inner products in one place.
/// single: a warp has one slice at most.
template <bool single, class Team>
__device__ void solveCluster(const ImexView& m, const NodeView<double>& nodes, std::int32_t number, Team team) {
  const ImexCluster cluster = m.clusters[number];
  const std::int32_t begin = cluster.firstSlice + team.warp(), end = cluster.firstSlice + cluster.sliceCount,
                     stride = team.warps();
  const Lane only(m, nodes, min(begin, end - 1));
  LaneNumbers<true> registers(m, 0);
  // Calls visit(slice, lane, numbers) for the warp's slices.
  const auto forEachSlice = [&](const auto& visit) {
    if constexpr (single) {
      if (begin < end) visit(begin, only, registers);
    } else {
      for (std::int32_t slice = begin; slice < end; slice += stride) {
        const Lane lane(m, nodes, slice);
        LaneNumbers<false> numbers(m, lane.at);
        visit(slice, lane, numbers);
      }
    }
  };
  const auto velocityAt = [&](const Lane& lane) -> double& {
    return nodes.v[static_cast<std::size_t>(lane.component) * nodes.count + lane.node];
  };
  // Right-hand side M (a + c v), a from the explicit step that was taken; prescribed components go over to that side.
  forEachSlice([&](std::int32_t, const Lane& lane, auto& x) {
    double right = 0, prescribed = 0;
    if (lane.node >= 0) {
      const double v = m.v[lane.at], sum = (velocityAt(lane) - v) / m.h + m.c * v;
      if (lane.held)
        prescribed = sum;
      else
        right = m.mass[lane.at] * sum;
    }
    x.r = right;
    m.z[lane.at] = prescribed;
    x.p = x.s = x.solution = 0;
  });
  if (cluster.held) {
    team.synchronize();
    forEachSlice([&](std::int32_t slice, const Lane& lane, auto& x) {
      const double q = rowProduct(m, slice, lane);
      if (lane.free()) x.r -= q;
    });
    team.synchronize();
  }

  double goal = 0, gammaBefore = 0, alpha = 0;
  int iteration = 0;
  bool converged = false;
  for (;; ++iteration) {
    forEachSlice([&](std::int32_t slice, const Lane& lane, auto& x) {
      x.z = preconditioned(m, slice, lane, x.r);
      if constexpr (single) m.z[lane.at] = x.z;
    });
    team.synchronize();
    double sums[2] = {0, 0};
    forEachSlice([&](std::int32_t slice, const Lane& lane, auto& x) {
      const double q = lane.held ? 0 : rowProduct(m, slice, lane);
      sums[0] += x.r * x.z;
      sums[1] += q * x.z;
      x.q = q;
    });
    team.sum(sums);
    const double gamma = sums[0], delta = sums[1];
    if (iteration == 0) goal = m.tolerance * m.tolerance * gamma;
    if (!(gamma > goal)) {
      converged = gamma <= goal;  // false for NaN
      break;
    }
    if (iteration == m.iterations) break;
    const double beta = iteration == 0 ? 0 : gamma / gammaBefore;
    alpha = gamma / (iteration == 0 ? delta : delta - beta * gamma / alpha);
    gammaBefore = gamma;
    forEachSlice([&](std::int32_t, const Lane&, auto& x) {
      x.p = x.z + beta * x.p;
      x.s = x.q + beta * x.s;
      x.solution += alpha * x.p;
      x.r -= alpha * x.s;
    });
  }
  if (team.warp() == 0 && threadIdx.x % 32 == 0) {
    atomicAdd(&m.status->iterations, static_cast<unsigned long long>(iteration));
    if (!converged) atomicMin(&m.status->fault, imexFaultKey(m.status->step, ImexFault::notConverged, number));
  }
  forEachSlice([&](std::int32_t, const Lane& lane, auto& x) {
    if (!lane.free()) return;
    const double v = m.v[lane.at], next = v + m.h * (x.solution - m.c * v);
    velocityAt(lane) = next;
    (&nodes.u[lane.node].x)[lane.component] = m.u[lane.at] + m.h * next;
  });
}
template <class Team>
__device__ void solveCluster(const ImexView& m, const NodeView<double>& nodes, std::int32_t number, Team team) {
  if (m.clusters[number].sliceCount <= team.warps())
    solveCluster<true>(m, nodes, number, team);
  else
    solveCluster<false>(m, nodes, number, team);
}

__global__ void __launch_bounds__(imexThreads) solveClustersKernel(const ImexView m, const NodeView<double> nodes) {
  __shared__ double shared[2][warpsOfBlock][2];
  const std::int32_t own = blockIdx.x;
  if (own < m.teamBlocks) {
    const std::int32_t number = m.teamOfBlock[own];
    const ImexTeam team = m.teams[number];
    solveCluster(m, nodes, team.cluster, GridTeam(shared, m, team, number));
    return;
  }
  const std::int32_t others = m.blockCount - m.teamBlocks;
  for (std::int32_t k = own - m.teamBlocks; k < m.ofBlocksCount; k += others) {
    solveCluster(m, nodes, m.ofBlocks[k], BlockTeam(shared));
    __syncthreads();
  }
  for (std::int32_t k = (own - m.teamBlocks) * warpsOfBlock + static_cast<std::int32_t>(threadIdx.x / 32);
       k < m.ofWarpsCount; k += others * warpsOfBlock)
    solveCluster(m, nodes, m.ofWarps[k], WarpTeam());
}

}  // namespace

int imexResidentBlocks() {
  int device = 0, processors = 0, each = 0;
  checkCuda(cudaGetDevice(&device), "cudaGetDevice");
  checkCuda(cudaDeviceGetAttribute(&processors, cudaDevAttrMultiProcessorCount, device), "cudaDeviceGetAttribute");
  checkCuda(cudaOccupancyMaxActiveBlocksPerMultiprocessor(&each, solveClustersKernel, imexThreads, 0),
            "occupancy of the solver");
  return processors * each;
}

void launchKeepNodes(const ImexView& view, const NodeView<double>& nodes, cudaStream_t stream) {
  keepNodesKernel<<<(view.sliceCount + warpsOfBlock) / warpsOfBlock, imexThreads, 0, stream>>>(view, nodes);
  checkLaunch("copy of the clusters' nodes");
}
void launchRotateBlocks(const ImexElementsView& elements, cudaStream_t stream) {
  if (elements.count == 0) return;
  const dim3 grid(static_cast<unsigned>((elements.count + rotationThreads - 1) / rotationThreads),
                  static_cast<unsigned>(elements.pairCount));
  rotateBlocksKernel<<<grid, rotationThreads, 0, stream>>>(elements);
  checkLaunch("rotated tangents");
}
void launchAssembleClusters(const ImexView& view, const NodeView<double>& nodes, cudaStream_t stream) {
  if (view.rowCount == 0) return;
  assembleKernel<<<(view.rowCount + warpsOfBlock - 1) / warpsOfBlock, imexThreads, 0, stream>>>(view, nodes);
  checkLaunch("assembly of the clusters");
}
void launchSolveClusters(const ImexView& view, const NodeView<double>& nodes, cudaStream_t stream) {
  if (view.blockCount == 0) return;
  ImexView argument = view;
  NodeView<double> second = nodes;
  void* arguments[] = {&argument, &second};
  checkCuda(cudaLaunchCooperativeKernel(reinterpret_cast<const void*>(solveClustersKernel),
                                        dim3(static_cast<unsigned>(view.blockCount)), dim3(imexThreads), arguments, 0,
                                        stream),
            "solution of the clusters");
}

}  // namespace ringwatch
