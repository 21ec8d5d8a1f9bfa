#pragma once
#include <functional>
#include <optional>

#include <ringwatch/body/tangent_source.h>
#include <ringwatch/monitor/bounds/factored_certificate.h>
#include <ringwatch/monitor/stability_monitor.h>
#include <ringwatch/monitor/step_limit.h>

namespace ringwatch {

/// What a factorisation has proven of the highest eigenvalue from above, and a vector from below, rad²/s²: 0 for a side
/// of which nothing is proven.
struct ProvenSides {
  UpperBound upper{0};
  LowerBound lower{0};
  NodeVectors mode;  // of the lower side, M^½ times a displacement, 3×N; empty without one
};

/// The critical step between two proven sides that are as close as rounding allows.
struct ExactStep {
  double safe, optimistic;  // s
  int factorisations;
  int products;       // tangent products
  ProvenSides sides;  // what the steps come from
};

/// The Rayleigh quotient of the top mode (globalFrequency; Theorem 8, docs/theory/rings_and_rayleigh.md).
struct TopQuotient {
  LowerBound lower;
  NodeVectors mode;  // M^½ times a displacement, 3×N
  int products;
};
/// At positions x (3×N, m). Empty where the mode does not converge.
std::optional<TopQuotient> topQuotient(const TangentSource& source, NodeVectorsView x);

/// Told what the factorisation takes before the first one. An exception that it throws ends the work.
using BeforeFactorisation = std::function<void(const FactorisationCost&)>;

/// The critical step at one state to within `tolerance`, or as far as rounding allows: above by the Rayleigh quotient
/// of the top mode (globalFrequency; Theorem 8, docs/theory/rings_and_rayleigh.md), below by a sparse factorisation
/// just above it (FactoredCertificate; Theorem 5, docs/theory/eigenvalue_bounds.md). x: 3×N, m. tolerance: of
/// optimistic over safe, > 0. Empty where the top mode does not converge, where the highest eigenvalue is not positive
/// and where no factorisation within 1 % proves a step. Throws InputError for a rule that is not proven and when x is
/// not 3×N.
std::optional<ExactStep> exactCriticalStep(const TangentSource& source, NodeVectorsView x, const StepRule& limit,
                                           double tolerance = 1e-6, const BeforeFactorisation& before = {});

/// Whether a step h, s, is proven stable (certified) or unstable (violated) at one state: by a factorisation (Theorem
/// 5), and where that fails by the Rayleigh quotient of the top mode (Theorem 8). Directions of negative stiffness,
/// which no step cures, are not searched: criticalStep() does. notCertified only for steps as close to the critical one
/// as rounding, or where the top mode does not converge. sides, if any: what the verdict comes from. Throws InputError
/// unless h is positive and finite, for a rule that is not proven and when x is not 3×N.
Verdict proveStep(const TangentSource& source, NodeVectorsView x, const StepRule& limit, double h,
                  const BeforeFactorisation& before = {}, ProvenSides* sides = nullptr);

}  // namespace ringwatch
