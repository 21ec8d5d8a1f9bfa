#pragma once
#include <span>
#include <string>

#include <ringwatch/integrators/integrator.h>
#include <ringwatch/verify/integrators/oscillator.h>
#include <ringwatch/verify/report.h>

namespace ringwatch {

/// Holds integrators to what they declare: stability limits without damping and with it, order, symplecticity,
/// reversibility, force evaluations, time that advances by the step, forces of time, nodes and components each for
/// itself, energy drift over 1e6 periods, and the critical
/// step of real runs of a spring chain and of two bodies against the one predicted from the highest frequency.
///
/// Those that are stable at every step swing a stiff bar at 50 times the explicit step. Partitioned ones are held to
/// their order with half the stiffness in each part, and to their limit with nothing in the stiff one.
///
/// Tables: limits, damped_limits, orders, periods, drift, observed, partitioned, stiff, adaptive. Figures: the spectral
/// radius over h·omega, the limit over the damping ratio, the stability regions in the plane of h times eigenvalue, and
/// the phase error.
StudyReport verifyIntegrators(StudyEffort effort, std::span<const IntegratorEntry> integrators = coreIntegrators());

/// Verifies one integrator so, your own for example.
StudyReport verifyIntegrator(const IntegratorFactory& make, StudyEffort effort);

/// The declarations as a table in Markdown, a row an integrator: docs/integrators.md holds it.
std::string integratorTable(std::span<const IntegratorEntry> integrators);

}  // namespace ringwatch
