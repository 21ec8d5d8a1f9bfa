#include <array>

#include <ringwatch/base/error.h>
#include <ringwatch/base/type_list.h>
#include <ringwatch/integrators/explicit_euler.h>
#include <ringwatch/integrators/stormer_verlet.h>
#include <ringwatch/integrators/symplectic_euler.h>

namespace ringwatch {
namespace {

/// Every integrator of the library, one line each.
using Integrators = TypeList<ExplicitEuler, SymplecticEuler, StormerVerlet>;

template <class... Is>
std::array<IntegratorInfo, sizeof...(Is)> describeAll(TypeList<Is...>) {
  return {Is::description...};
}

}  // namespace

std::span<const IntegratorInfo> allIntegrators() {
  static const auto table = describeAll(Integrators{});
  return table;
}

const IntegratorInfo* findIntegrator(std::string_view name) {
  for (const IntegratorInfo& info : allIntegrators())
    if (info.name == name) return &info;
  return nullptr;
}

std::unique_ptr<Integrator> makeIntegrator(std::string_view name) {
  std::unique_ptr<Integrator> result;
  forEachType(Integrators{}, [&](auto tag) {
    using I = typename decltype(tag)::type;
    if (I::description.name == name) result = std::make_unique<I>();
  });
  if (result) return result;
  std::string names;
  for (const IntegratorInfo& info : allIntegrators()) names += (names.empty() ? "" : ", ") + std::string(info.name);
  throw InputError(joinText("integrator \"", name, "\": must be one of ", names));
}

}  // namespace ringwatch
