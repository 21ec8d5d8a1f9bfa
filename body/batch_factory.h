#pragma once
#include <memory>
#include <utility>

#include <ringwatch/body/block_registry.h>
#include <ringwatch/body/element_batch.h>
#include <ringwatch/body/uniform_strain_batch.h>

namespace ringwatch::detail {

template <class Element, class Law>
std::unique_ptr<ElementBlock> makeBatch(const Mesh& mesh, const MeshBlock& block, const Material& material,
                                        const QuadratureRule& rule, const HourglassControl& hourglassControl,
                                        PatchLayout layout) {
  constexpr bool uniformStrain =
      std::ranges::any_of(Element::rules, [](const QuadratureRule& one) { return one.uniformStrain; });
  if constexpr (uniformStrain)
    if (rule.uniformStrain)
      return std::make_unique<UniformStrainBatch<Element, Law>>(mesh, block, material, rule, hourglassControl,
                                                                std::move(layout));
  return std::make_unique<ElementBatch<Element, Law>>(mesh, block, material, rule, std::move(layout));
}

/// The maker of batches of an element of the library with law number `law` of `Laws`; nullptr when the law is in
/// another shard.
template <std::size_t shard>
BatchMaker batchMakerOfShard(ElementType type, std::size_t law) {
  BatchMaker result = nullptr;
  visitLawOfShard<shard>(law, [&]<class LawType>(TypeTag<LawType>) {
    visitElement(type, [&](auto elementTag) { result = makeBatch<typename decltype(elementTag)::type, LawType>; });
  });
  return result;
}

}  // namespace ringwatch::detail
