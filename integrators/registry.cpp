#include <array>

#include <ringwatch/base/registry.h>
#include <ringwatch/integrators/explicit_euler.h>
#include <ringwatch/integrators/pefrl.h>
#include <ringwatch/integrators/rk4.h>
#include <ringwatch/integrators/rkn4.h>
#include <ringwatch/integrators/stormer_verlet.h>
#include <ringwatch/integrators/symplectic_euler.h>
#include <ringwatch/integrators/yoshida4.h>

namespace ringwatch {
namespace {

/// Every explicit integrator of the library, one line each.
constexpr std::array entriesOfCore{
    integratorEntry<ExplicitEuler>(),  //
    integratorEntry<SymplecticEuler>(),    integratorEntry<StormerVerlet>(), integratorEntry<RungeKutta4>(),
    integratorEntry<RungeKuttaNystrom4>(), integratorEntry<Yoshida4>(),      integratorEntry<Pefrl>(),
};

Registry<IntegratorEntry>& registry() {
  static Registry<IntegratorEntry> integrators("integrator", entriesOfCore);
  return integrators;
}

}  // namespace

void complete(SecondOrderSystem& system, State& state) {
  if (state.lag == 0) return;
  const NodeVectors& a = accelerationOf(system, state);
  updateNodes(system, state.v.cols(), [&](auto slice) { slice(state.v) += state.lag * slice(a); });
  state.lag = 0;
}

std::span<const IntegratorEntry> coreIntegrators() { return registry().all(); }
void registerIntegrator(const IntegratorEntry& entry) { registry().add(entry); }

IntegratorCatalog::IntegratorCatalog(std::initializer_list<std::span<const IntegratorEntry>> lists) {
  for (const auto& list : lists) entries_.insert(entries_.end(), list.begin(), list.end());
}

const IntegratorInfo* IntegratorCatalog::find(std::string_view name) const {
  for (const IntegratorEntry& entry : entries_)
    if (entry.info->name == name) return entry.info;
  return nullptr;
}

std::unique_ptr<Integrator> IntegratorCatalog::make(std::string_view name) const {
  std::string names;
  for (const IntegratorEntry& entry : entries_) {
    if (entry.info->name == name) return entry.make();
    names += (names.empty() ? "" : ", ") + std::string(entry.info->name);
  }
  throw InputError(joinText("integrator \"", name, "\": must be one of ", names));
}

std::span<const IntegratorInfo> allIntegrators() { return registry().infos(); }
const IntegratorInfo* findIntegrator(std::string_view name) {
  const IntegratorEntry* entry = registry().find(name);
  return entry ? entry->info : nullptr;
}
std::unique_ptr<Integrator> makeIntegrator(std::string_view name) { return registry().get(name).make(); }

}  // namespace ringwatch
