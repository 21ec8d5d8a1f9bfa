#include <ringwatch/app/scene/integrator_catalog.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <ringwatch/base/infinity.h>
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

StepRule stepRuleWithDashpots(const IntegratorInfo& info, const RayleighDamping& damping, double reference,
                              double overcount) {
  // The step at which a vector becomes unstable that has the quotient lambda of K + f C, `part` of it of f C: the root
  // of (lambda - part) h² + b h = 4. most: how much of the part is overcounted.
  const auto stepOf = [damping, reference](double lambda, double part, double most = 0) {
    if (std::isnan(lambda)) return std::numeric_limits<double>::quiet_NaN();
    const double all = std::max(lambda, 0.0), dashpots = std::min(part, all), stiffness = all - dashpots;
    const double b =
        2 * (damping.beta * stiffness + damping.alpha) + dashpots / (1 + most) * (reference + 2 * damping.beta);
    return 8 / (b + std::sqrt(b * b + 16 * stiffness));
  };
  return {[stepOf, reference](double lambda) {
            const double step = stepOf(lambda, 0);
            return step < reference ? stepOf(lambda, infinity) : step;
          },
          [stepOf, overcount,
           even = (reference + 2 * damping.beta) / (1 + overcount) - 2 * damping.beta](LowerBound lambda) {
            const double step = stepOf(lambda.value, lambda.dampingFrom, overcount);
            return step > even ? stepOf(lambda.value, lambda.dampingTo, overcount) : step;
          },
          info.highestModeBinds};
}

std::vector<IntegratorInfo> integratorInfos() {
  std::vector<IntegratorInfo> infos;
  for (const IntegratorEntry& entry : integratorCatalog().entries()) infos.push_back(*entry.info);
  return infos;
}

}  // namespace ringwatch
