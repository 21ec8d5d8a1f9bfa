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

std::string_view nameOfIntegrator(const IntegratorEntry& entry) { return entry.info->name; }

auto& registry() {
  static Registry<IntegratorEntry, nameOfIntegrator> integrators(entriesOfCore);
  return integrators;
}

const IntegratorCatalog& coreCatalog() {
  static const IntegratorCatalog catalog{coreIntegrators()};
  return catalog;
}

}  // namespace

std::span<const IntegratorEntry> coreIntegrators() { return registry().all(); }
void registerIntegrator(const IntegratorEntry& entry) { registry().add("integrator", entry); }

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

std::span<const IntegratorInfo> allIntegrators() {
  static const auto table = [] {
    std::vector<IntegratorInfo> infos;
    for (const IntegratorEntry& entry : coreIntegrators()) infos.push_back(*entry.info);
    return infos;
  }();
  return table;
}

const IntegratorInfo* findIntegrator(std::string_view name) { return coreCatalog().find(name); }
std::unique_ptr<Integrator> makeIntegrator(std::string_view name) { return coreCatalog().make(name); }

}  // namespace ringwatch
