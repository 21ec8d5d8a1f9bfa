#include <ringwatch/app/command/integrator_catalog.h>

#include <cmath>
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

bool hasCriticalStep(const IntegratorInfo& info) {
  return info.imaginaryLimit > 0 && !std::isinf(info.imaginaryLimit) && !info.partitioned;
}

StepRule stepRule(const IntegratorInfo& info, const RayleighDamping& damping) {
  if (!damping.any()) return info.imaginaryLimit;
  return {[info, damping](double lambda) {
            const std::optional<double> step = dampedStep(lambda, damping, info);
            return step ? *step : std::numeric_limits<double>::quiet_NaN();
          },
          info.highestModeBinds};
}

double dampingFactor(const RayleighDamping& damping, double reference) { return 2 / (reference + 2 * damping.beta); }

StepRule stepRuleWithDashpots(const IntegratorInfo& info, const RayleighDamping& damping, double reference) {
  const StepRule own = stepRule(info, damping);
  // Where the step differs from the reference, the dashpots count with the factor of the reference for all that is.
  const auto other = [damping, reference](double lambda) {
    return 4 / (lambda * (reference + 2 * damping.beta) + 2 * damping.alpha);
  };
  return {[own, other, reference](double lambda) {
            const double step = own(lambda);
            return step < reference ? other(lambda) : step;
          },
          [own, other, reference](double lambda) {
            const double step = own(lambda);
            return step > reference ? other(lambda) : step;
          },
          info.highestModeBinds};
}

std::vector<IntegratorInfo> integratorInfos() {
  std::vector<IntegratorInfo> infos;
  for (const IntegratorEntry& entry : integratorCatalog().entries()) infos.push_back(*entry.info);
  return infos;
}

}  // namespace ringwatch
