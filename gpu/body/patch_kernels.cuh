#pragma once
#include <cuda_pipeline.h>

#include <ringwatch/base/matrix3.h>
#include <ringwatch/body/element_operators.h>
#include <ringwatch/gpu/body/patch_operations.h>
#include <ringwatch/gpu/cuda_error.h>
#include <ringwatch/materials/registry.h>

/// The kernels over patches of elements, templated on the reference element, the law and the scalar: the same law and
/// element headers as the CPU's batches. A thread block is a patch, a thread an element.
namespace ringwatch::detail {

/// ∂N_a/∂ξ_j at the points of the rule, as a kernel argument: constant memory.
template <class Element, class R>
struct ShapeTable {
  static constexpr int points = [] {
    std::size_t most = 0;
    for (const QuadratureRule& rule : Element::rules) most = rule.points.size() > most ? rule.points.size() : most;
    return static_cast<int>(most);
  }();
  R dN[points][Element::nodes][3];
};

/// Local nodes of an element, loaded at once.
template <int n>
struct alignas(n == 4       ? 8
               : n == 8     ? 16
               : n % 2 == 0 ? 4
                            : 2) Corners {
  std::uint16_t node[n];
};

/// Rows of nodes in shared memory, a plane a component.
template <class R>
struct Planes {
  R* at;
  int stride;
  __device__ R operator()(int component, int node) const { return at[component * stride + node]; }
};

/// J⁻¹ and the weight times det J at a point, loaded at once.
template <class Element, class R>
struct PointGeometry {
  Matrix3<R> J1;
  R weight;  // of elements of constant gradient not loaded

  __device__ __forceinline__ void load(const R* from) {
    constexpr int threads = patchThreads(Element::nodes);
#pragma unroll
    for (int i = 0; i < 9; ++i) J1.m[i] = from[i * threads];
    if constexpr (!Element::constantGradient) weight = from[9 * threads];
  }
};

/// One element and what is stored of it. Loads start when it is made, before the patch's nodes have come.
template <class Element, class R>
struct ElementView {
  static constexpr int n = Element::nodes, threads = patchThreads(n), entries = Element::constantGradient ? 9 : 10;
  Corners<n> corners;
  const R* geometry;  // of the element: entries are `threads` apart
  PointGeometry<Element, R> first;

  __device__ __forceinline__ ElementView(const BlockView<R>& block) {
    const auto at = static_cast<std::size_t>(blockIdx.x) * threads + threadIdx.x;
    corners = reinterpret_cast<const Corners<n>*>(block.corners)[at];
    const int points = Element::constantGradient ? 1 : block.pointCount;
    geometry = block.geometry + static_cast<std::size_t>(blockIdx.x) * points * entries * threads + threadIdx.x;
    first.load(geometry);
  }
};

/// Calls atPoint(q, J⁻¹, weight) for every quadrature point; the weight holds det J.
template <class Element, class R, class AtPoint>
__device__ __forceinline__ void forEachPoint(const ElementView<Element, R>& element, int points,
                                             const AtPoint& atPoint) {
  constexpr int stride = ElementView<Element, R>::entries * ElementView<Element, R>::threads;
  if constexpr (Element::constantGradient) {
    atPoint(0, element.first.J1, R(Element::referenceVolume) / determinant(element.first.J1));
  } else {
    // The next point's numbers are on their way while this one is computed.
    PointGeometry<Element, R> next = element.first;
    const R* geometry = element.geometry;
#pragma unroll 1
    for (int q = 0; q < points; ++q) {
      const PointGeometry<Element, R> here = next;
      if (q + 1 < points) next.load(geometry += stride);
      atPoint(q, here.J1, here.weight);
    }
  }
}

/// Σ_a u_a ⊗ ∂N_a/∂ξ of nodal vectors u(component, local node).
template <class Element, class R, class Vectors>
__device__ __forceinline__ Matrix3<R> naturalGradient(const ElementView<Element, R>& element, const Vectors& u,
                                                      const ShapeTable<Element, R>& table, int q) {
  R first[3];
#pragma unroll
  for (int i = 0; i < 3; ++i) first[i] = u(i, element.corners.node[0]);
  const auto edge = [&](int a, int i) { return u(i, element.corners.node[a]) - first[i]; };
  return ElementOperators<Element, R>::naturalGradient(edge, table.dN[q]);
}

/// F = I + (Σ_a u_a ⊗ ∂N_a/∂ξ) J⁻¹ of displacements u: in single precision far more exact than from positions, which
/// lose what the element is smaller than the body.
template <class Element, class R, class Vectors>
__device__ __forceinline__ Matrix3<R> deformationGradient(const ElementView<Element, R>& element, const Vectors& u,
                                                          const ShapeTable<Element, R>& table, int q,
                                                          const Matrix3<R>& J1) {
  Matrix3<R> F = naturalGradient<Element>(element, u, table, q) * J1;
  F.m[0] += R(1);
  F.m[4] += R(1);
  F.m[8] += R(1);
  return F;
}

/// A node on its way through a step: what the step needs is loaded before the forces are known.
template <class R>
struct MovingNode {
  Row4<R> u;
  R v[3], external[3];
  unsigned constrained;

  __device__ __forceinline__ void load(const NodeView<R>& nodes, std::int32_t node) {
    u = nodes.u[node];
    constrained = nodes.constrained != nullptr ? nodes.constrained[node] : 0U;
#pragma unroll
    for (int c = 0; c < 3; ++c) {
      const auto at = static_cast<std::size_t>(c) * nodes.count + node;
      v[c] = nodes.v[at];
      external[c] = nodes.external != nullptr ? nodes.external[at] : R(0);
    }
  }
  /// Symplectic Euler: v += h a, u += h v, a = (external - f)/m; constrained components get a = 0.
  __device__ __forceinline__ void step(const NodeView<R>& nodes, std::int32_t node, R h, const R (&f)[3]) {
    R* us[3] = {&u.x, &u.y, &u.z};
#pragma unroll
    for (int c = 0; c < 3; ++c) {
      if (!(constrained >> c & 1U)) {
        v[c] += h * ((external[c] - f[c]) * u.w);
        nodes.v[static_cast<std::size_t>(c) * nodes.count + node] = v[c];
      }
      *us[c] += h * v[c];
    }
    nodes.u[node] = u;
  }
};

/// What the slots of a shared node add up to.
template <class R>
__device__ __forceinline__ void sumOfSlots(const NodeView<R>& nodes, std::int32_t shared, R (&sum)[3]) {
  sum[0] = sum[1] = sum[2] = R(0);
  const std::int32_t end = nodes.slotBegin[shared + 1];
  for (std::int32_t s = nodes.slotBegin[shared]; s < end; ++s) {
    const Row4<R> row = nodes.slots[nodes.slot[s]];
    sum[0] += row.x;
    sum[1] += row.y;
    sum[2] += row.z;
  }
}
/// The end of a step, behind the patches: node number `shared` of those that several patches share moves, if there is
/// one, and the clock goes on.
template <class R>
__device__ __forceinline__ void finishStep(const NodeView<R>& nodes, std::int32_t shared) {
  // The patches' kernel is done, so the clock may go on; nothing else reads the count of steps meanwhile.
  if (shared == 0) ++nodes.clock->step;
  if (shared >= nodes.count - nodes.interiorCount) return;
  MovingNode<R> moving;
  moving.load(nodes, nodes.interiorCount + shared);
  R sum[3];
  sumOfSlots(nodes, shared, sum);
  moving.step(nodes, nodes.interiorCount + shared, static_cast<R>(nodes.clock->h), sum);
}

/// The nodes of a patch that a thread serves, and their rows of corners.
template <int threads>
struct OwnNodes {
  static constexpr int most = (patchNodeLimit + threads - 1) / threads;
  std::int32_t node[most];
  int rowBegin[most], rowEnd[most];

  template <class R>
  __device__ __forceinline__ OwnNodes(const BlockView<R>& block) {
    const int t = threadIdx.x, groups = block.nodeCapacity / 32;
#pragma unroll
    for (int k = 0; k < most; ++k) {
      const int i = t + k * threads;
      const bool inside = i < block.nodeCapacity;
      node[k] = inside ? block.nodes[static_cast<std::size_t>(blockIdx.x) * block.nodeCapacity + i] : -1;
      const std::size_t group = static_cast<std::size_t>(blockIdx.x) * groups + i / 32;
      rowBegin[k] = inside ? block.groupRow[group] : 0;
      rowEnd[k] = inside ? block.groupRow[group + 1] : 0;
    }
  }
};

/// What becomes of the sums at a patch's nodes.
enum class Use { force, step };
/// A patch kernel that does not test balls.
struct NoCheck {
  static constexpr bool on = false;
  struct Ball {};
  __device__ Ball ofElement(int /*threads*/) const { return {}; }
};

template <class Element, class Law, class R, bool tangent, Use use, int minBlocks, class Check>
__global__ void __launch_bounds__(patchThreads(Element::nodes), minBlocks)
    patchKernel(const BlockView<R> block, const NodeView<R> nodes, const __grid_constant__ Law law,
                const __grid_constant__ ShapeTable<Element, R> table, const R* __restrict__ direction,
                Row4<R>* __restrict__ result, const Check check) {
  constexpr int n = Element::nodes, threads = patchThreads(n), plane = n * threads + 1;
  extern __shared__ double sharedMemory[];
  auto* const rows = reinterpret_cast<std::uint16_t*>(sharedMemory);
  R* const displacements = reinterpret_cast<R*>(rows + static_cast<std::size_t>(block.rowCapacity) * 32);
  R* const cornerForce = displacements + (tangent ? 6 : 3) * block.nodeCapacity;
  const int t = threadIdx.x;
  const Planes<R> u{displacements, block.nodeCapacity}, v{displacements + 3 * block.nodeCapacity, block.nodeCapacity};

  // Everything that does not wait for something else is put on its way first.
  const OwnNodes<threads> own(block);
  const ElementView<Element, R> element(block);
  const int elementCount = block.patches[blockIdx.x].elementCount;
  const std::size_t firstGroup = static_cast<std::size_t>(blockIdx.x) * (block.nodeCapacity / 32);
  const int firstRow = block.groupRow[firstGroup];
  const int chunks = (block.groupRow[firstGroup + block.nodeCapacity / 32] - firstRow) * 4;  // of 16 bytes
  for (int i = t; i < chunks; i += threads)
    __pipeline_memcpy_async(rows + i * 8, block.rows + static_cast<std::size_t>(firstRow) * 32 + i * 8, 16);
  __pipeline_commit();
#pragma unroll
  for (int k = 0; k < own.most; ++k) {
    const std::int32_t node = own.node[k];
    if (node < 0) continue;
    const int i = t + k * threads;
    const Row4<R> p = nodes.u[node];
    u.at[i] = p.x;
    u.at[u.stride + i] = p.y;
    u.at[2 * u.stride + i] = p.z;
    if constexpr (tangent)
      for (int c = 0; c < 3; ++c) v.at[c * v.stride + i] = direction[static_cast<std::size_t>(c) * nodes.count + node];
  }
  if (t < 3) cornerForce[t * plane + plane - 1] = R(0);
  [[maybe_unused]] const typename Check::Ball ball = check.ofElement(threads);
  __syncthreads();

  if (t < elementCount) {
    using Operators = ElementOperators<Element, R>;
    R force[n][3];
#pragma unroll
    for (int a = 0; a < n; ++a)
#pragma unroll
      for (int c = 0; c < 3; ++c) force[a][c] = R(0);
    [[maybe_unused]] bool left = false;
    forEachPoint(element, block.pointCount, [&](int q, const Matrix3<R>& J1, R weight) {
      const Matrix3<R> F = deformationGradient<Element>(element, u, table, q, J1);
      if constexpr (Check::on) left = ball.left(F, ball.radius()) || left;
      if constexpr (tangent) {
        const Matrix3<R> dF = naturalGradient<Element>(element, v, table, q) * J1;
        Operators::addForces(timesTranspose(weight * law.linearize(F)(dF), J1), table.dN[q], force);
      } else {
        Operators::addForces(timesTranspose(weight * law.stress(F), J1), table.dN[q], force);
      }
    });
#pragma unroll
    for (int a = 0; a < n; ++a)
#pragma unroll
      for (int c = 0; c < 3; ++c) cornerForce[c * plane + a * threads + t] = force[a][c];
    if constexpr (Check::on && !Element::constantGradient)
      if (left) {  // by the ball for all points: few do, and their own say more
        left = false;
        const float radius = check.own(0, block.pointCount, threads).radius();
        forEachPoint(element, block.pointCount, [&](int q, const Matrix3<R>& J1, R) {
          const Matrix3<R> F = deformationGradient<Element>(element, u, table, q, J1);
          left = check.own(q, block.pointCount, threads).left(F, radius) || left;
        });
      }
    if constexpr (Check::on)
      if (left) {  // they compute and note their deformation gradients once more
        double* const to = check.note(block.pointCount, threads);
        if (to != nullptr)
          forEachPoint(element, block.pointCount, [&](int q, const Matrix3<R>& J1, R) {
            const Matrix3<R> F = deformationGradient<Element>(element, u, table, q, J1);
            for (int i = 0; i < 9; ++i) to[9 * q + i] = F.m[i];
          });
      }
  }
  MovingNode<R> moving;
  if constexpr (use == Use::step)
    if (own.node[0] >= 0 && own.node[0] < nodes.interiorCount) moving.load(nodes, own.node[0]);
  __pipeline_wait_prior(0);
  __syncthreads();

#pragma unroll
  for (int k = 0; k < own.most; ++k) {
    const std::int32_t node = own.node[k];
    if (node < 0) continue;
    const int i = t + k * threads;
    R sum[3] = {R(0), R(0), R(0)};
    const std::uint16_t* corner = rows + (own.rowBegin[k] - firstRow) * 32 + t % 32;
    for (int row = own.rowBegin[k]; row < own.rowEnd[k]; ++row, corner += 32) {
#pragma unroll
      for (int c = 0; c < 3; ++c) sum[c] += cornerForce[c * plane + *corner];
    }
    if (node >= nodes.interiorCount) {
      nodes.slots[block.firstSlot + static_cast<std::size_t>(blockIdx.x) * block.nodeCapacity + i] = {sum[0], sum[1],
                                                                                                      sum[2], R(0)};
    } else if constexpr (use == Use::step) {
      if (k > 0) moving.load(nodes, node);
      moving.step(nodes, node, static_cast<R>(nodes.clock->h), sum);
    } else {
      result[node] = {sum[0], sum[1], sum[2], R(0)};
    }
  }
}

/// Sum over a thread block in a fixed order; thread 0 has it.
__device__ inline double blockSum(double value) {
  __shared__ double ofWarp[32];
  for (int offset = 16; offset > 0; offset /= 2) value += __shfl_down_sync(0xffffffffU, value, offset);
  if (threadIdx.x % 32 == 0) ofWarp[threadIdx.x / 32] = value;
  __syncthreads();
  value = 0;
  if (threadIdx.x == 0)
    for (unsigned w = 0; w < blockDim.x / 32; ++w) value += ofWarp[w];
  return value;
}

/// Strain energy of each patch, J. Summed in double precision for either R.
template <class Element, class Law, class R>
__global__ void __launch_bounds__(patchThreads(Element::nodes))
    energyKernel(const BlockView<R> block, const NodeView<R> nodes, const __grid_constant__ Law law,
                 const __grid_constant__ ShapeTable<Element, R> table, double* __restrict__ partial) {
  constexpr int threads = patchThreads(Element::nodes);
  extern __shared__ double sharedMemory[];
  R* const displacements = reinterpret_cast<R*>(sharedMemory);
  const DevicePatch patch = block.patches[blockIdx.x];
  const std::int32_t* const own = block.nodes + static_cast<std::size_t>(blockIdx.x) * block.nodeCapacity;
  const int t = threadIdx.x;
  const Planes<R> u{displacements, block.nodeCapacity};
  const ElementView<Element, R> element(block);
  for (int i = t; i < patch.nodeCount; i += threads) {
    const Row4<R> p = nodes.u[own[i]];
    u.at[i] = p.x;
    u.at[u.stride + i] = p.y;
    u.at[2 * u.stride + i] = p.z;
  }
  __syncthreads();
  double energy = 0;
  if (t < patch.elementCount)
    forEachPoint(element, block.pointCount, [&](int q, const Matrix3<R>& J1, R weight) {
      const Matrix3<R> F = deformationGradient<Element>(element, u, table, q, J1);
      energy += static_cast<double>(weight * law.energy(F));
    });
  energy = blockSum(energy);
  if (t == 0) partial[block.firstPatch + blockIdx.x] = energy;
}

/// Launches the kernels of one element and law.
template <class Element, class Law, class R>
struct PatchLauncher {
  static constexpr int n = Element::nodes, threads = patchThreads(n);
  /// Thread blocks that must fit on a multiprocessor: bounds the registers. Measured; see bench/results.
  static constexpr int minBlocks = n == 4 ? (sizeof(R) == 8 ? 3 : 6) : 2;

  static ShapeTable<Element, R> tableOf(const QuadratureRule& rule) {
    ShapeTable<Element, R> table{};
    for (std::size_t q = 0; q < rule.points.size(); ++q) {
      double dN[n][3];
      elementInfo(ringwatch::elementTypeOf<Element>).shapeGradient(rule.points[q].xi, dN);
      for (int a = 0; a < n; ++a)
        for (int j = 0; j < 3; ++j) table.dN[q][a][j] = static_cast<R>(dN[a][j]);
    }
    return table;
  }

  template <bool tangent, Use use>
  static void launch(const BlockView<R>& block, const NodeView<R>& nodes, const LawParameters& parameters,
                     const R* direction, Row4<R>* result, cudaStream_t stream) {
    launchWith<tangent, use>(block, nodes, parameters, direction, result, NoCheck{}, stream);
  }
  template <bool tangent, Use use, class Check>
  static void launchWith(const BlockView<R>& block, const NodeView<R>& nodes, const LawParameters& parameters,
                         const R* direction, Row4<R>* result, const Check& check, cudaStream_t stream) {
    if (block.patchCount == 0) return;
    const auto kernel = patchKernel<Element, Law, R, tangent, use, minBlocks, Check>;
    const std::size_t bytes =
        ((tangent ? 6 : 3) * block.nodeCapacity + 3 * (n * threads + 1)) * sizeof(R) + 64 * block.rowCapacity;
    checkCuda(cudaFuncSetAttribute(kernel, cudaFuncAttributeMaxDynamicSharedMemorySize, static_cast<int>(bytes)),
              "shared memory of the patch kernel");
    kernel<<<block.patchCount, threads, bytes, stream>>>(block, nodes, std::get<Law>(parameters.law),
                                                         tableOf(*parameters.rule), direction, result, check);
    checkLaunch("patch kernel");
  }
  static void energy(const BlockView<R>& block, const NodeView<R>& nodes, const LawParameters& parameters,
                     double* partial, cudaStream_t stream) {
    if (block.patchCount == 0) return;
    energyKernel<Element, Law, R><<<block.patchCount, threads, 3 * block.nodeCapacity * sizeof(R), stream>>>(
        block, nodes, std::get<Law>(parameters.law), tableOf(*parameters.rule), partial);
    checkLaunch("energy kernel");
  }

  static PatchOperations<R> operations() {
    PatchOperations<R> all;
    all.force = &launch<false, Use::force>;
    all.step = &launch<false, Use::step>;
    all.tangentProduct = &launch<true, Use::force>;
    all.energy = &energy;
    return all;
  }
};

/// Sets the operations of an element type with law number `law` of `Laws` when the law is in this shard. Instantiated
/// in a generated file a shard.
template <std::size_t shard, class R>
void patchOperationsOfShard(ElementType type, std::size_t law, PatchOperations<R>& result) {
  visitLawOfShard<shard>(law, [&]<class LawType>(TypeTag<LawType>) {
    visitElement(type, [&](auto tag) {
      using Element = typename decltype(tag)::type;
      if constexpr (Element::order == 1) result = PatchLauncher<Element, LawType, R>::operations();
    });
  });
}

}  // namespace ringwatch::detail
