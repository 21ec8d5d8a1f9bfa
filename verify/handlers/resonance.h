#pragma once
#include <ringwatch/verify/report.h>

namespace ringwatch {

/// Where local time stepping resonates: a clamped bar of linear tetrahedra with one stiff element, or with a stiff and
/// a very stiff one side by side, whose highest frequency is scanned at a step fixed by the soft rest. The matrix of
/// one step is found column by column with the handler `local-time-stepping` itself; its spectral radius is the growth
/// per step.
///
/// Table: resonance. Figure: handlers_resonance, growth against h omega / pi. Checks: the stabilised variant, with its
/// default dissipation and without any, has a spectral radius of at most 1 everywhere; the plain one has not, so that
/// the scan sees what it is made for.
void addResonance(StudyEffort effort, StudyReport& report);

}  // namespace ringwatch
