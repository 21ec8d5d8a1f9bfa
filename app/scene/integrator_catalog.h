#pragma once
#include <ringwatch/integrators/integrator.h>
#include <ringwatch/monitor/step_limit.h>

namespace ringwatch {

/// The integrators that this program was built with, by name: the explicit ones and, with SUNDIALS, the implicit ones.
const IntegratorCatalog& integratorCatalog();
/// Their declarations, for lists and help texts.
std::vector<IntegratorInfo> integratorInfos();

/// Whether an integrator of one system has a largest stable step, of which there can be a bracket.
bool hasCriticalStep(const IntegratorInfo& info);
/// How the highest eigenvalue sets this integrator's step, with damping too. With damping it is proven for those whose
/// highest mode binds.
StepRule stepRule(const IntegratorInfo& info, const RayleighDamping& damping);
/// The same for a system with a damping matrix C besides, of dashpots and elements that damp, whose eigenvalues are
/// those of M⁻¹(K + f C), f = dampingFactor(): the rule is exact for steps of `reference` seconds, safe for others, and
/// optimistic for others: exactly so for bounds that know what C gives. For integrators whose highest mode binds.
/// Theorem 47, docs/theory/discrete_forces.md. overcount: by how much more than C may count, relative; the optimistic
/// side allows for it (Theorem 59, docs/theory/element_damping.md).
StepRule stepRuleWithDashpots(const IntegratorInfo& info, const RayleighDamping& damping, double reference,
                              double overcount = 0);
/// f, 1/s.
double dampingFactor(const RayleighDamping& damping, double reference);

}  // namespace ringwatch
