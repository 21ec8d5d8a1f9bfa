#include <ringwatch/body/element_block.h>

#include <memory>
#include <utility>
#include <vector>

#include <ringwatch/base/error.h>

namespace ringwatch {
namespace detail {
// Defined in batch_factory.h, instantiated in one generated file a shard.
using BatchMaker = std::unique_ptr<ElementBlock> (*)(const Mesh&, const MeshBlock&, const Material&,
                                                     const QuadratureRule&);
template <std::size_t shard>
BatchMaker batchMakerOfShard(ElementType type, std::size_t law);

namespace {
struct RegisteredBatches {
  std::string_view law;
  BatchMaker (*makerOf)(ElementType);
};
std::vector<RegisteredBatches>& registeredBatches() {
  static std::vector<RegisteredBatches> all;
  return all;
}
}  // namespace

void registerBatches(std::string_view law, BatchMaker (*makerOf)(ElementType)) {
  registeredBatches().push_back({law, makerOf});
}
}  // namespace detail

void ElementBlock::addTangentProduct(const Patch& patch, const double* x, const double* v, double* slots) const {
  alignas(64) double rows[4 * PatchLayout::maxPatchNodes], vRows[4 * PatchLayout::maxPatchNodes];
  gatherRows(patch, x, rows);
  gatherRows(patch, v, vRows);
  tangentProductBatches(patch.batchBegin, patch.batchEnd, rows, vRows, slots);
}

std::unique_ptr<ElementBlock> makeElementBlock(const Mesh& mesh, const MeshBlock& block, const Material& material,
                                               std::string_view ruleName) {
  const ElementInfo& element = elementInfo(block.type);
  const QuadratureRule* rule = findRule(element, ruleName);
  if (!rule) {
    std::string names;
    for (const QuadratureRule& r : element.rules) names += (names.empty() ? "" : ", ") + std::string(r.name);
    throw InputError(joinText("rule \"", ruleName, "\" for ", element.name, ": must be one of ", names));
  }
  if (material.outside)
    for (const auto& [law, makerOf] : detail::registeredBatches())
      if (law == material.outside->info.name) return makerOf(block.type)(mesh, block, material, *rule);
  detail::BatchMaker make = nullptr;
  [&]<std::size_t... shard>(std::index_sequence<shard...>) {
    ((make = make ? make : detail::batchMakerOfShard<shard>(block.type, material.law.index())), ...);
  }
  (std::make_index_sequence<lawShards>{});
  return make(mesh, block, material, *rule);
}

}  // namespace ringwatch
