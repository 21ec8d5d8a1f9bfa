#pragma once
#include <ringwatch/gpu/tangent_operations.h>
#include <ringwatch/materials/rotation.h>
#include <ringwatch/monitor/small/power_iteration.h>
#include <ringwatch/gpu/certificate/certificate_kernels.cuh>

/// Kernels that need an element's tangent: see TangentOperations.
namespace ringwatch::detail {

/// An element a thread: the ten node blocks of its scaled tangent, a row of all of them at a time, go through shared
/// memory to the threads that sum them pair by pair.
template <class Law>
__global__ void __launch_bounds__(patchThreads(4), 2)
    assembleRingsKernel(const BlockView<double> block, const NodeView<double> nodes, const __grid_constant__ Law law,
                        const __grid_constant__ ShapeTable<Tet4, double> table, const RingBlockView ring,
                        const RingView view) {
  constexpr int n = 4, threads = patchThreads(n), plane = tetrahedronPairs * threads + 1;
  extern __shared__ double sharedMemory[];
  auto* const rows = reinterpret_cast<std::uint16_t*>(sharedMemory);
  double* const stage = sharedMemory + static_cast<std::size_t>(ring.rowCapacity) * 8;
  const int t = threadIdx.x;
  const std::size_t patch = blockIdx.x;
  const RingPatch pairs = ring.patches[patch];
  const std::int32_t* const groupRow = ring.groupRow + patch * static_cast<std::size_t>(ring.pairCapacity / 32);
  const int firstRow = groupRow[0], chunks = (groupRow[ring.pairCapacity / 32] - firstRow) * 4;  // of 16 bytes
  for (int i = t; i < chunks; i += threads)
    __pipeline_memcpy_async(rows + i * 8, ring.rows + static_cast<std::size_t>(firstRow) * 32 + i * 8, 16);
  __pipeline_commit();
  const bool active = t < block.patches[patch].elementCount;
  const std::int32_t* const own = block.nodes + patch * static_cast<std::size_t>(block.nodeCapacity);
  const ElementView<Tet4, double> element(block);

  using Blocks = decltype(nodeBlocksOf(law.linearize(Matrix3<double>{}), 0.0));
  typename Blocks::Node node[n];
  double factor[n][3];
  const auto blocks = [&] {
    const Matrix3<double>& J1 = element.first.J1;
    const double weight = Tet4::referenceVolume / determinant(J1);
    const Matrix3<double> F = active ? deformationGradient<Tet4>(element, MeshDisplacements{nodes.u, own}, table, 0, J1)
                                     : Matrix3<double>::identity();
    return nodeBlocksOf(law.linearize(F), weight);
  }();
  if (active) {
    double g[n][3];
    ElementOperators<Tet4, double>::shapeGradients(element.first.J1, table.dN[0], g);
    const unsigned order = ring.order[patch * threads + t];
#pragma unroll
    for (int a = 0; a < n; ++a) {
      const unsigned corner = order >> (2 * a) & 3U;
      double own_g[3];
#pragma unroll
      for (int i = 0; i < 3; ++i)
        own_g[i] = corner < 2 ? (corner == 0 ? g[0][i] : g[1][i]) : (corner == 2 ? g[2][i] : g[3][i]);
      node[a] = blocks.node(own_g);
      const unsigned local = corner < 2 ? (corner == 0 ? element.corners.node[0] : element.corners.node[1])
                                        : (corner == 2 ? element.corners.node[2] : element.corners.node[3]);
      const std::int32_t at = own[local];
      const unsigned held = nodes.constrained != nullptr ? nodes.constrained[at] : 0U;
      const double root = sqrt(nodes.u[at].w);
#pragma unroll
      for (int i = 0; i < 3; ++i) factor[a][i] = (held >> i & 1U) != 0 ? 0.0 : root;
    }
  }
  if (t < 3) stage[t * plane + plane - 1] = 0;
  __pipeline_wait_prior(0);
#pragma unroll
  for (int row = 0; row < 3; ++row) {
    if (active) {
      int pair = 0;
#pragma unroll
      for (int a = 0; a < n; ++a)
#pragma unroll
        for (int b = 0; b <= a; ++b, ++pair) {
          const Matrix3<double> k = blocks(node[a], node[b]);
#pragma unroll
          for (int j = 0; j < 3; ++j)
            stage[j * plane + pair * threads + t] = k(row, j) * (factor[a][row] * factor[b][j]);
        }
    }
    __syncthreads();
    for (int l = t; l < pairs.pairCount; l += threads) {
      const std::uint16_t *at = rows + (groupRow[l / 32] - firstRow) * 32 + l % 32, *const end =
                                                                                        rows + (groupRow[l / 32 + 1] -
                                                                                                firstRow) *
                                                                                                   32;
      double sum[3] = {0, 0, 0};
#pragma unroll 4
      for (; at < end; at += 32)
#pragma unroll
        for (int j = 0; j < 3; ++j) sum[j] += stage[j * plane + *at];
#pragma unroll
      for (int j = 0; j < 3; ++j) {
        const std::size_t entry = 3 * row + j;
        if (l < pairs.ownCount)
          view.pair[entry * view.pairCount + pairs.firstPair + l] = sum[j];
        else
          view.slots[entry * view.slotCount + pairs.firstSlot + (l - pairs.ownCount)] = sum[j];
      }
    }
    __syncthreads();
  }
}

/// Displacements of an implicit element's nodes as they were kept.
struct KeptDisplacements {
  const double* u;
  const std::int32_t* node;  // of the element: entries are `stride` apart
  std::int32_t stride;
  __device__ double operator()(int component, int a) const {
    return u[node[static_cast<std::size_t>(a) * stride] + component];
  }
};

inline constexpr int listThreads = 64;

/// An element a thread. At rest: K_e(X) and its highest eigenvalue. Else the rotation of its fitted deformation
/// gradient, and how much stiffer it has become.
template <class Element, class Law>
__global__ void __launch_bounds__(listThreads)
    implicitElementsKernel(const BlockView<double> block, const __grid_constant__ Law law,
                           const __grid_constant__ ShapeTable<Element, double> table, const ImexElementsView elements,
                           const ImexView imex, const bool rest) {
  using Bound = ElementBound<Element, Law>;
  constexpr int n = Bound::n, size = Bound::size, threads = Bound::threads;
  constexpr int entries = Element::constantGradient ? 9 : 10;
  const std::int32_t e = static_cast<std::int32_t>(blockIdx.x) * listThreads + static_cast<std::int32_t>(threadIdx.x);
  if (e >= elements.count) return;
  const std::size_t place = elements.place[e];
  const int points = Element::constantGradient ? 1 : block.pointCount;
  const double* geometry =
      block.geometry + place / threads * static_cast<std::size_t>(points * entries * threads) + place % threads;
  const KeptDisplacements kept{imex.u, elements.node + e, elements.count};

  Matrix3<double> R = Matrix3<double>::identity();
  constexpr bool stiffens = Law::tangentStiffens;
  double stiffening = 1;
  bool finite = true;
  if (rest || stiffens) {
    double K[size * size], v[size], Kv[size];
    Bound::clear(K);
#pragma unroll 1
    for (int q = 0; q < points; ++q) {
      PointGeometry<Element, double> at;
      at.load(geometry + static_cast<std::size_t>(q) * entries * threads);
      if constexpr (Element::constantGradient) at.weight = Element::referenceVolume / determinant(at.J1);
      double g[n][3];
      Bound::Operators::shapeGradients(at.J1, table.dN[q], g);
      Matrix3<double> F = Matrix3<double>::identity();
      if (!rest)
#pragma unroll
        for (int a = 0; a < n; ++a)
#pragma unroll
          for (int i = 0; i < 3; ++i) {
            const double u = kept(i, a);
#pragma unroll
            for (int j = 0; j < 3; ++j) F(i, j) += u * g[a][j];
          }
      Bound::addTangent(law, F, at.weight, g, K);
    }
#pragma unroll(size == 12 ? 12 : 1)
    for (int i = 0; i < size; ++i)
#pragma unroll(size == 12 ? 12 : 1)
      for (int j = 0; j < i; ++j) K[j * size + i] = K[i * size + j];
    const double highest = highestByPowerIteration < size == 12 ? 12 : 0 > (K, size, v, Kv);
    if (rest) {
      elements.restHighest[e] = highest;
      for (int a = 0, pair = 0; a < n; ++a)
        for (int b = 0; b <= a; ++b, ++pair)
          for (int i = 0; i < 9; ++i)
            elements.rest[static_cast<std::size_t>(9 * pair + i) * elements.count + e] =
                K[(3 * a + i / 3) * size + 3 * b + i % 3];
      return;
    }
    stiffening = highest / elements.restHighest[e];
    finite = isfinite(stiffening);
    stiffening = fmax(stiffening, 1.0);
  }
  if constexpr (Law::objective) {
    Matrix3<double> F = Matrix3<double>::identity();
    for (int a = 0; a < n; ++a)
      for (int i = 0; i < 3; ++i) {
        const double u = kept(i, a);
        for (int j = 0; j < 3; ++j)
          F(i, j) += u * elements.shape[static_cast<std::size_t>(3 * a + j) * elements.count + e];
      }
    finite = finite && isfinite(innerProduct(F, F));
    R = closestRotation(F);
    if (!finite)
      atomicMin(&imex.status->fault, imexFaultKey(imex.status->step, ImexFault::notFinite, elements.cluster[e]));
  }
#pragma unroll
  for (int i = 0; i < 9; ++i) elements.rotation[static_cast<std::size_t>(i) * elements.count + e] = R.m[i];
  elements.rotation[static_cast<std::size_t>(9) * elements.count + e] = imex.w * stiffening;
}

/// Launches the kernels of one element and law.
template <class Element, class Law>
struct TangentLauncher {
  using Patches = PatchLauncher<Element, Law, double>;
  static void assembleRings(const BlockView<double>& block, const NodeView<double>& nodes, const LawParameters& law,
                            const RingBlockView& ring, const RingView& view, cudaStream_t stream) {
    if (block.patchCount == 0) return;
    const auto kernel = assembleRingsKernel<Law>;
    const int bytes =
        3 * (tetrahedronPairs * patchThreads(4) + 1) * static_cast<int>(sizeof(double)) + 64 * ring.rowCapacity;
    checkCuda(cudaFuncSetAttribute(kernel, cudaFuncAttributeMaxDynamicSharedMemorySize, bytes),
              "shared memory of the assembly");
    kernel<<<block.patchCount, patchThreads(4), bytes, stream>>>(block, nodes, std::get<Law>(law.law),
                                                                 Patches::tableOf(*law.rule), ring, view);
    checkLaunch("assembly of reduced rings");
  }
  template <bool rest>
  static void implicitElements(const BlockView<double>& block, const LawParameters& law,
                               const ImexElementsView& elements, const ImexView& imex, cudaStream_t stream) {
    if (elements.count == 0) return;
    implicitElementsKernel<Element, Law><<<(elements.count + listThreads - 1) / listThreads, listThreads, 0, stream>>>(
        block, std::get<Law>(law.law), Patches::tableOf(*law.rule), elements, imex, rest);
    checkLaunch("implicit elements");
  }
};

/// Sets the operations of an element type with law number `law` when the law is in this shard. Instantiated in a
/// generated file a shard.
template <std::size_t shard>
void tangentOperationsOfShard(ElementType type, std::size_t law, TangentOperations& result) {
  visitLawOfShard<shard>(law, [&]<class LawType>(TypeTag<LawType>) {
    visitElement(type, [&](auto tag) {
      using Element = typename decltype(tag)::type;
      using Launcher = TangentLauncher<Element, LawType>;
      if constexpr (std::is_same_v<Element, Tet4>) result.assembleRings = &Launcher::assembleRings;
      if constexpr (Element::order == 1) {
        result.restTangents = &Launcher::template implicitElements<true>;
        result.rotateTangents = &Launcher::template implicitElements<false>;
      }
    });
  });
}

}  // namespace ringwatch::detail
