#include <ringwatch/app/command/integrator_catalog.h>

#include <limits>

#include <ringwatch/integrators/stability_limit.h>

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

StepRule stepRule(const IntegratorInfo& info, const RayleighDamping& damping) {
  if (!damping.any()) return info.imaginaryLimit;
  return {[info, damping](double lambda) {
            const std::optional<double> step = dampedStep(lambda, damping, info);
            return step ? *step : std::numeric_limits<double>::quiet_NaN();
          },
          info.highestModeBinds};
}

std::vector<IntegratorInfo> integratorInfos() {
  std::vector<IntegratorInfo> infos;
  for (const IntegratorEntry& entry : integratorCatalog().entries()) infos.push_back(*entry.info);
  return infos;
}

}  // namespace ringwatch
