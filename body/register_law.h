#pragma once
#include <memory>

#include <ringwatch/body/batch_factory.h>

namespace ringwatch {

/// Adds a law, a struct as in materials/, to those that materials are made of by name; call it when the program starts,
/// before any law is asked for. It works with all elements, those that are registered before or after it too. Includes
/// the kernels of the library's elements, so one file of a program does it for all. Runs on the CPU. Throws InputError
/// when the name is taken.
template <class L>
void registerLaw() {
  detail::registerLaw(
      {lawInfo<L>(), [](const Options& parameters, Material& material) {
         auto law = std::make_shared<const L>(L::of(parameters));
         material.outside =
             OutsideLaw{lawInfo<L>(),
                        law->restModuli(),
                        restModulusOf(*law),
                        std::move(law),
                        [](const void* own, const Matrix3<double>& F) { return static_cast<const L*>(own)->energy(F); },
                        [](const void* own, const Matrix3<double>& F) { return static_cast<const L*>(own)->stress(F); },
                        [](const void* own, const Matrix3<double>& F, const Matrix3<double>& dF) {
                          return static_cast<const L*>(own)->linearize(F)(dF);
                        }};
       }});
  detail::registerBatchesOfLaw(
      L::name,
      [](ElementType type) {
        detail::BatchMaker result = nullptr;
        visitElement(type,
                     [&](auto elementTag) { result = detail::makeBatch<typename decltype(elementTag)::type, L>; });
        return result;
      },
      LawOfPacks::functionsOf<L>());
}

}  // namespace ringwatch
