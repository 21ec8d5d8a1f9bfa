#pragma once
#include <cstdint>
#include <functional>
#include <optional>

#include <ringwatch/body/body.h>
#include <ringwatch/monitor/bounds/exchange_bound.h>
#include <ringwatch/monitor/bounds/lanczos_bound.h>
#include <ringwatch/monitor/step_limit.h>

namespace ringwatch {

/// How a probabilistic safe side is wanted; see lanczosUpperBound.
struct LanczosOptions {
  double width = 0.01;
  double eta = 1e-9;
  std::uint64_t seed = 1;
};

/// Told of a bracket that is proven already while a narrower one is searched: its sides, s. The optimistic one is
/// infinite before it is known. Safe sides told are those of Theorem 1, docs/theory/eigenvalue_bounds.md.
using BracketListener = std::function<void(double safe, double optimistic)>;

/// What criticalStep() is asked for. width: the optimistic over the safe step, less 1, from which the search goes no
/// further; more makes it faster. lanczos: fills in CriticalStep::probable (Theorem 6), which is far tighter than the
/// proven side on regular grids. evaluations: unless nullptr, the element evaluations that it took are added to it.
struct CriticalStepOptions {
  double width = ExchangePolicy::width;
  std::optional<LanczosOptions> lanczos = std::nullopt;
  BracketListener listener = {};
  std::int64_t* evaluations = nullptr;
};

/// The best proven bracket at one state, from scratch, as tight as is asked for or as the methods give without a run's
/// history. Safe side: the smaller of the block nodal bound (Theorem 1, docs/theory/eigenvalue_bounds.md), whose
/// weights are swept while that pays, and the exchange bound (Theorem 12, docs/theory/exchange.md), which takes three
/// to twenty times as long. Optimistic side: reduced 1-rings and Rayleigh quotients (Theorems 9 and 8,
/// docs/theory/rings_and_rayleigh.md). From eigenvalue to step: Theorem 27, docs/theory/integrators.md.
/// x: 3×N, m. limit: the integrator's largest stable h·omega, or a proven rule. Throws InputError for a rule that is
/// not proven, for a negative width and when x is not 3×N; NumericalError where the tangent is not finite. On a part of
/// a body (body/domain.h) the nodal bound and a Rayleigh quotient alone, without `lanczos`, whatever the width; all
/// processes get the same, and each adds its own evaluations. Collective.
CriticalStep criticalStep(const Body& body, NodeVectorsView x, const StepRule& limit,
                          const CriticalStepOptions& options = {});

/// Throws InputError for a rule that is not proven: it cannot make a bracket.
void requireProof(const StepRule& rule);

}  // namespace ringwatch
