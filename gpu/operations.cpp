#include <variant>

#include <ringwatch/gpu/certificate_operations.h>
#include <ringwatch/gpu/patch_operations.h>
#include <ringwatch/gpu/tangent_operations.h>
#include <ringwatch/materials/registry.h>

namespace ringwatch {
namespace detail {
// Defined in patch_kernels.cuh, instantiated in one generated file a law and scalar.
template <std::size_t law, class R>
PatchOperations<R> lawOperations(ElementType type);
// The same in certificate_kernels.cuh.
template <std::size_t law>
CertificateOperations certificateOfLaw(ElementType type);
// The same in tangent_kernels.cuh.
template <std::size_t law>
TangentOperations tangentsOfLaw(ElementType type);
}  // namespace detail

template <class R>
PatchOperations<R> patchOperations(ElementType type, std::size_t law) {
  PatchOperations<R> result;
  [&]<std::size_t... i>(std::index_sequence<i...>) {
    ((law == i ? void(result = detail::lawOperations<i, R>(type)) : void()), ...);
  }
  (std::make_index_sequence<std::variant_size_v<Law>>{});
  return result;
}
template PatchOperations<double> patchOperations(ElementType, std::size_t);
template PatchOperations<float> patchOperations(ElementType, std::size_t);

CertificateOperations certificateOperations(ElementType type, std::size_t law) {
  CertificateOperations result;
  [&]<std::size_t... i>(std::index_sequence<i...>) {
    ((law == i ? void(result = detail::certificateOfLaw<i>(type)) : void()), ...);
  }
  (std::make_index_sequence<std::variant_size_v<Law>>{});
  return result;
}

TangentOperations tangentOperations(ElementType type, std::size_t law) {
  TangentOperations result;
  [&]<std::size_t... i>(std::index_sequence<i...>) {
    ((law == i ? void(result = detail::tangentsOfLaw<i>(type)) : void()), ...);
  }
  (std::make_index_sequence<std::variant_size_v<Law>>{});
  return result;
}

}  // namespace ringwatch
