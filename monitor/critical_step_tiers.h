#pragma once
#include <functional>

#include <ringwatch/monitor/critical_step.h>

namespace ringwatch {

/// Told of a bracket that is proven already while a narrower one is searched: its sides, s. The optimistic one is
/// infinite before it is known.
using BracketListener = std::function<void(double safe, double optimistic)>;

/// criticalStep(), which tells what is proven so far: after one sweep of the weights, within 10 to 20 % of the critical
/// step; with the optimistic side; and with all sweeps, before the exchange bound is made. Safe sides told are those of
/// Theorem 1, docs/theory/eigenvalue_bounds.md.
CriticalStep criticalStepInTiers(const Body& body, NodeVectorsView x, const StepRule& limit,
                                 const std::optional<LanczosOptions>& lanczos, std::int64_t* evaluations,
                                 const BracketListener& listener);

}  // namespace ringwatch
