#include <ringwatch/gpu/body/patch_operations.h>
#include <ringwatch/gpu/certificate/certificate_operations.h>
#include <ringwatch/gpu/imex/tangent_operations.h>
#include <ringwatch/materials/registry.h>

namespace ringwatch {
namespace detail {
// Defined in patch_kernels.cuh, certificate_kernels.cuh and tangent_kernels.cuh, instantiated in one generated file a
// shard of the laws.
template <std::size_t shard, class R>
void patchOperationsOfShard(ElementType type, std::size_t law, PatchOperations<R>& result);
template <std::size_t shard>
void certificateOperationsOfShard(ElementType type, std::size_t law, CertificateOperations& result);
template <std::size_t shard>
void tangentOperationsOfShard(ElementType type, std::size_t law, TangentOperations& result);
}  // namespace detail

template <class R>
PatchOperations<R> patchOperations(ElementType type, std::size_t law) {
  PatchOperations<R> result;
  forEachLawShard([&](auto shard) { detail::patchOperationsOfShard<shard, R>(type, law, result); });
  return result;
}
template PatchOperations<double> patchOperations(ElementType, std::size_t);
template PatchOperations<float> patchOperations(ElementType, std::size_t);

CertificateOperations certificateOperations(ElementType type, std::size_t law) {
  CertificateOperations result;
  forEachLawShard([&](auto shard) { detail::certificateOperationsOfShard<shard>(type, law, result); });
  return result;
}

TangentOperations tangentOperations(ElementType type, std::size_t law) {
  TangentOperations result;
  forEachLawShard([&](auto shard) { detail::tangentOperationsOfShard<shard>(type, law, result); });
  return result;
}

}  // namespace ringwatch
