#pragma once
#include <ringwatch/integrators/integrator.h>
#include <ringwatch/monitor/step_limit.h>

namespace ringwatch {

/// The integrators that this program was built with, by name: the explicit ones and, with SUNDIALS, the implicit ones.
const IntegratorCatalog& integratorCatalog();
/// Their declarations, for lists and help texts.
std::vector<IntegratorInfo> integratorInfos();

/// How the highest eigenvalue sets this integrator's step, with damping too. With damping it is proven for those whose
/// highest mode binds.
StepRule stepRule(const IntegratorInfo& info, const RayleighDamping& damping);

}  // namespace ringwatch
