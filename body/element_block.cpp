#include <ringwatch/body/element_block.h>

#include <memory>
#include <utility>

#include <ringwatch/base/error.h>

namespace ringwatch {
namespace detail {
// Defined in batch_factory.h, instantiated in one generated file a law.
template <std::size_t lawIndex>
std::unique_ptr<ElementBlock> makeBatch(const Mesh&, const MeshBlock&, const Material&, const QuadratureRule&);
}  // namespace detail

std::unique_ptr<ElementBlock> makeElementBlock(const Mesh& mesh, const MeshBlock& block, const Material& material,
                                               std::string_view ruleName) {
  const ElementInfo& element = elementInfo(block.type);
  const QuadratureRule* rule = findRule(element, ruleName);
  if (!rule) {
    std::string names;
    for (const QuadratureRule& r : element.rules) names += (names.empty() ? "" : ", ") + std::string(r.name);
    throw InputError(joinText("rule \"", ruleName, "\" for ", element.name, ": must be one of ", names));
  }
  std::unique_ptr<ElementBlock> result;
  [&]<std::size_t... i>(std::index_sequence<i...>) {
    ((material.law.index() == i ? void(result = detail::makeBatch<i>(mesh, block, material, *rule)) : void()), ...);
  }
  (std::make_index_sequence<std::variant_size_v<Law>>{});
  return result;
}

}  // namespace ringwatch
