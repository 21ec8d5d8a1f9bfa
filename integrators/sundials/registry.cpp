#include <ringwatch/integrators/sundials/registry.h>

#include <array>

#include <ringwatch/integrators/sundials/additive.h>
#include <ringwatch/integrators/sundials/implicit.h>

namespace ringwatch {

std::span<const IntegratorEntry> sundialsIntegrators() {
  static constexpr std::array entries{
      integratorEntry<ImplicitEuler>(),  //
      integratorEntry<ArkodeDirk>(),    integratorEntry<CvodeBdf>(),
      integratorEntry<ArkodeArk>(),     integratorEntry<ArkodeMri>(),
  };
  return entries;
}

}  // namespace ringwatch
