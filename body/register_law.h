#pragma once
#include <memory>

#include <ringwatch/body/batch_factory.h>

namespace ringwatch {
namespace detail {
/// Makes the blocks of a registered law known by its name.
void registerBatches(std::string_view law, BatchMaker (*makerOf)(ElementType type));
}  // namespace detail

/// Adds a law, a struct as in materials/, to those that materials are made of by name; call it when the program starts,
/// before any law is asked for. Includes the kernels of all elements, so one file of a program does it for all. Runs on
/// the CPU. Throws InputError when the name is taken.
template <class L>
void registerLaw() {
  detail::registerLaw(
      {lawInfo<L>(), [](const Options& parameters, Material& material) {
         auto law = std::make_shared<const L>(L::of(parameters));
         const Lame rest = law->restModuli();
         material.outside =
             OutsideLaw{lawInfo<L>(),
                        rest,
                        std::move(law),
                        [](const void* own, const Matrix3<double>& F) { return static_cast<const L*>(own)->energy(F); },
                        [](const void* own, const Matrix3<double>& F) { return static_cast<const L*>(own)->stress(F); },
                        [](const void* own, const Matrix3<double>& F, const Matrix3<double>& dF) {
                          return static_cast<const L*>(own)->linearize(F)(dF);
                        }};
       }});
  detail::registerBatches(L::name, [](ElementType type) {
    detail::BatchMaker result = nullptr;
    visitElement(type, [&](auto elementTag) {
      result = detail::makeBatch<ElementBatch<typename decltype(elementTag)::type, L>>;
    });
    return result;
  });
}

}  // namespace ringwatch
