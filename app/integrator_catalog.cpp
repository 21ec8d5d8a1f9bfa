#include <ringwatch/app/integrator_catalog.h>

#ifdef RINGWATCH_WITH_SUNDIALS
#include <ringwatch/integrators/sundials/registry.h>
#endif

namespace ringwatch {

const IntegratorCatalog& integratorCatalog() {
#ifdef RINGWATCH_WITH_SUNDIALS
  static const IntegratorCatalog catalog({coreIntegrators(), sundialsIntegrators()});
#else
  static const IntegratorCatalog catalog({coreIntegrators()});
#endif
  return catalog;
}

std::vector<IntegratorInfo> integratorInfos() {
  std::vector<IntegratorInfo> infos;
  for (const IntegratorEntry& entry : integratorCatalog().entries()) infos.push_back(*entry.info);
  return infos;
}

}  // namespace ringwatch
