#include <ringwatch/body/element_block.h>

#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <variant>

#include <ringwatch/base/error.h>
#include <ringwatch/body/block_registry.h>

namespace ringwatch {
namespace detail {
// Defined in batch_factory.h, instantiated in one generated file a shard.
template <std::size_t shard>
BatchMaker batchMakerOfShard(ElementType type, std::size_t law);

namespace {
struct RegisteredLaw {
  BatchMaker (*makerOf)(ElementType);
  LawOfPacks::Functions functions;
};
std::map<std::string, RegisteredLaw, std::less<>>& registeredLaws() {
  static std::map<std::string, RegisteredLaw, std::less<>> all;
  return all;
}
const RegisteredLaw& registeredLaw(const Material& material) {
  const auto found = registeredLaws().find(material.lawName());
  if (found == registeredLaws().end())
    throw InputError(joinText("law \"", material.lawName(), "\": is not registered by registerLaw"));
  return found->second;
}
std::map<ElementType, BatchMaker (*)(const Material&)>& registeredElements() {
  static std::map<ElementType, BatchMaker (*)(const Material&)> all;
  return all;
}

BatchMaker batchMaker(ElementType element, const Material& material) {
  if (!isOfLibrary(element)) {
    const auto found = registeredElements().find(element);
    if (found == registeredElements().end())
      throw InputError(joinText("element \"", elementInfo(element).name, "\": is not registered by registerElement"));
    return found->second(material);
  }
  if (material.outside) return registeredLaw(material).makerOf(element);
  BatchMaker make = nullptr;
  forEachLawShard([&](auto shard) {
    if (make == nullptr) make = batchMakerOfShard<shard>(element, material.law.index());
  });
  return make;
}
}  // namespace

void registerBatchesOfLaw(std::string_view law, BatchMaker (*makerOf)(ElementType),
                          const LawOfPacks::Functions& functions) {
  registeredLaws().insert_or_assign(std::string(law), RegisteredLaw{makerOf, functions});
}
void registerBatchesOfElement(ElementType element, BatchMaker (*makerOf)(const Material&)) {
  registeredElements().insert_or_assign(element, makerOf);
}
}  // namespace detail

bool hasShares(const Material& material, const LameShares& shares) {
  const auto whole = [](double lambda, double mu) { return lambda == mu && (mu == 0 || mu == 1); };
  if (whole(shares.pointLambda, shares.pointMu) && whole(shares.meanLambda, shares.meanMu)) return true;
  if (material.outside) return LawOfPacks::of(material).withShares(1, 1).has_value();
  return std::visit([](const auto& law) { return withShares(law, 1, 1).has_value(); }, material.law);
}

LawOfPacks LawOfPacks::of(const Material& material) {
  return {detail::registeredLaw(material).functions, material.outside->law};
}

void ElementBlock::addTangentProduct(const Patch& patch, const double* x, const double* v, double* slots) const {
  alignas(64) double rows[4 * PatchLayout::maxPatchNodes], vRows[4 * PatchLayout::maxPatchNodes];
  gatherRows(patch, x, rows);
  gatherRows(patch, v, vRows);
  tangentProductBatches(patch.batchBegin, patch.batchEnd, rows, vRows, slots);
}

std::unique_ptr<ElementBlock> makeElementBlock(const Mesh& mesh, const MeshBlock& block, const Material& material,
                                               std::string_view ruleName, const HourglassControl& hourglassControl,
                                               std::optional<PatchLayout> layout) {
  const ElementInfo& element = elementInfo(block.type);
  const QuadratureRule* rule = findRule(element, ruleName);
  if (!rule) {
    std::string names;
    for (const QuadratureRule& r : element.rules) names += (names.empty() ? "" : ", ") + std::string(r.name);
    throw InputError(joinText("rule \"", ruleName, "\" for ", element.name, ": must be one of ", names));
  }
  if (!hasShares(material, rule->shares))
    throw InputError(joinText(element.name,
                              ": rules that treat pressure and shear apart need a law linear in Lamé's constants; ",
                              material.lawName(), " is none"));
  if (!(hourglassControl.stiffness >= 0) || !std::isfinite(hourglassControl.stiffness))
    throw InputError(joinText("hourglass stiffness = ", hourglassControl.stiffness, ": must be >= 0"));
  return detail::batchMaker(block.type, material)(mesh, block, material, *rule, hourglassControl,
                                                  layout ? std::move(*layout) : layOutPatches(mesh, block));
}

}  // namespace ringwatch
