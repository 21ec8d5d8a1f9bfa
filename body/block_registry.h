#pragma once
#include <memory>

#include <ringwatch/body/element_block.h>
#include <ringwatch/body/law_of_packs.h>

/// Which code makes the blocks of elements and laws that are registered; body/register_law.h and
/// body/register_element.h fill it.
namespace ringwatch::detail {

/// Makes the block of a mesh block, laid out so.
using BatchMaker = std::unique_ptr<ElementBlock> (*)(const Mesh&, const MeshBlock&, const Material&,
                                                     const QuadratureRule&, const HourglassControl&, PatchLayout);

/// makerOf(element): with this law, for elements of the library.
void registerBatchesOfLaw(std::string_view law, BatchMaker (*makerOf)(ElementType element),
                          const LawOfPacks::Functions& functions);
/// makerOf(material): of this element, for the law of a material, of the library or registered.
void registerBatchesOfElement(ElementType element, BatchMaker (*makerOf)(const Material& material));

}  // namespace ringwatch::detail
