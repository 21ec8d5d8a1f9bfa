#pragma once
#include <cuda_runtime_api.h>

#include <ringwatch/elements/registry.h>
#include <ringwatch/gpu/body/kernel_views.h>
#include <ringwatch/materials/registry.h>

namespace ringwatch {

/// What the kernels of a block need besides its views.
struct LawParameters {
  Law law;
  const QuadratureRule* rule;
};

/// The launches over the patches of a block, by element type, law and scalar. Interior nodes are finished by them; what
/// is left of shared ones lies in their slots. Everything is put into the stream, nothing waits. Throw DeviceError.
template <class R>
struct PatchOperations {
  using Launch = void (*)(const BlockView<R>&, const NodeView<R>&, const LawParameters&, const R* direction,
                          Row4<R>* result, cudaStream_t);
  Launch force = nullptr;           // internal force, N, into result
  Launch step = nullptr;            // force and a step of symplectic Euler
  Launch tangentProduct = nullptr;  // K(x) direction ([component][node]) into result
  void (*energy)(const BlockView<R>&, const NodeView<R>&, const LawParameters&, double* partial,
                 cudaStream_t) = nullptr;
};
/// The operations of an element type and law number `law` of `Laws`.
template <class R>
PatchOperations<R> patchOperations(ElementType type, std::size_t law);

/// Sums the slots of shared nodes into result.
template <class R>
void launchSumSlots(const NodeView<R>& nodes, Row4<R>* result, cudaStream_t stream);
/// The step of the shared nodes, from their slots.
template <class R>
void launchFinishStep(const NodeView<R>& nodes, cudaStream_t stream);
/// Σ partial, in a fixed order, into *sum.
void launchSum(const double* partial, std::int32_t count, double* sum, cudaStream_t stream);
/// ½ Σ m v², J, in a fixed order, into *sum; partial holds kineticParts numbers.
inline constexpr int kineticParts = 256;
template <class R>
void launchKineticEnergy(const NodeView<R>& nodes, double* partial, double* sum, cudaStream_t stream);

}  // namespace ringwatch
