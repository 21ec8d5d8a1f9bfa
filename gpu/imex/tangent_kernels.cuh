#pragma once
#include <ringwatch/gpu/imex/tangent_operations.h>
#include <ringwatch/materials/rotation.h>
#include <ringwatch/monitor/small/power_iteration.h>
#include <ringwatch/gpu/certificate/certificate_kernels.cuh>

/// Kernels that need an element's tangent: see TangentOperations.
namespace ringwatch::detail {

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
      if constexpr (Element::order == 1) {
        result.restTangents = &Launcher::template implicitElements<true>;
        result.rotateTangents = &Launcher::template implicitElements<false>;
      }
    });
  });
}

}  // namespace ringwatch::detail
