#pragma once
#include <memory>

#include <ringwatch/body/element_batch.h>

namespace ringwatch::detail {

/// The batch of the block's element type with law number `lawIndex` of `Laws`. Instantiated once a law.
template <std::size_t lawIndex>
std::unique_ptr<ElementBlock> makeBatch(const Mesh& mesh, const MeshBlock& block, const Material& material,
                                        const QuadratureRule& rule) {
  using LawType = std::variant_alternative_t<lawIndex, Law>;
  std::unique_ptr<ElementBlock> result;
  visitElement(block.type, [&](auto tag) {
    result = std::make_unique<ElementBatch<typename decltype(tag)::type, LawType>>(mesh, block, material, rule);
  });
  return result;
}

}  // namespace ringwatch::detail
