#pragma once
#include <variant>

#include <ringwatch/body/batch_factory.h>
#include <ringwatch/body/element_geometry_functions.h>

namespace ringwatch {

/// Adds an element, a struct as in elements/, to those that meshes, readers, writers, generators, scenes and studies
/// know; call it when the program starts, before any element is asked for. It works with all laws, those that are
/// registered before or after it too: with these a block takes one indirect call a pack and point. Includes the kernels
/// of all laws, so one file of a program does it for all. Runs on the CPU. Throws InputError when the name or a number
/// of a file format is taken, for more than maxElementNodes nodes, for nodes that are neither corners nor middles of
/// edges, and for an element that names no way to fill a cell.
template <class E>
void registerElement() {
  const ElementType type = detail::registerElement(elementInfoOf<E>(ElementType{}));
  detail::registerBatchesOfElement(type, [](const Material& material) -> detail::BatchMaker {
    if (material.outside) return detail::makeBatch<E, LawOfPacks>;
    return std::visit([]<class L>(const L&) -> detail::BatchMaker { return detail::makeBatch<E, L>; }, material.law);
  });
}

}  // namespace ringwatch
