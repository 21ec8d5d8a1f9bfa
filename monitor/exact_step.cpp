#include <ringwatch/monitor/exact_step.h>

#include <algorithm>
#include <cmath>

#include <ringwatch/base/error.h>
#include <ringwatch/monitor/bounds/global_frequency.h>
#include <ringwatch/monitor/bounds/rayleigh.h>
#include <ringwatch/monitor/critical_step.h>

namespace ringwatch {
namespace {

constexpr double widest = 0.02;  // of the eigenvalue, 1 % of the step: beyond, other bounds say as much for less
/// A residual of 1e-7 leaves a Rayleigh quotient 1e-14 below its eigenvalue, relative.
constexpr double modeTolerance = 1e-7;
/// Taken from the eigenvalue of a step, which is some roundings off, so that what is proven of it holds for that very
/// step: 8 u.
constexpr double ruleRounding = 0x1p-50;

}  // namespace

std::optional<TopQuotient> topQuotient(const TangentSource& source, NodeVectorsView x) {
  const GlobalFrequency top = globalFrequency(source, x, modeTolerance);
  if (!top.converged) return std::nullopt;
  NodeVectors u = top.mode;
  for (std::int32_t i = 0; i < source.nodeCount(); ++i) u.col(i) *= std::sqrt(source.lumpedMass()[i]);
  double seen = top.lambda;
  const LowerBound lower = rayleighLowerBound(source, x, u, 1, &seen);
  return TopQuotient{lower, std::move(u), top.products + 1};
}

std::optional<ExactStep> exactCriticalStep(const TangentSource& source, NodeVectorsView x, const StepRule& limit,
                                           double tolerance, const BeforeFactorisation& before) {
  requireProof(limit);
  if (!(tolerance > 0)) throw InputError(joinText("tolerance = ", tolerance, ": must be > 0"));
  const std::optional<TopQuotient> top = topQuotient(source, x);
  if (!top || !(top->lower.value > 0)) return std::nullopt;
  const double lower = top->lower.value;
  FactoredCertificate certificate(source, x);
  if (before) before(certificate.cost());
  // Half of the tolerance, which is of the step, where the margin lets it: a quotient that is low by rounding fits in.
  double gap = std::max(tolerance, 2 * certificate.margin(lower) / lower);
  for (int factorisations = 1; gap <= widest; ++factorisations, gap *= 4) {
    const double sigma = lower * (1 + gap);
    if (certificate.certifies(sigma))
      return ExactStep{safeStep(UpperBound{sigma}, limit),
                       optimisticStep(top->lower, limit),
                       factorisations,
                       top->products,
                       {{sigma}, top->lower, top->mode}};
  }
  return std::nullopt;
}

Verdict proveStep(const TangentSource& source, NodeVectorsView x, const StepRule& limit, double h,
                  const BeforeFactorisation& before, ProvenSides* sides) {
  requireProof(limit);
  if (!(h > 0) || !std::isfinite(h)) throw InputError(joinText("h = ", h, ": must be > 0 and finite"));
  const double sigma = limit.lambdaFor(h) * (1 - ruleRounding);
  FactoredCertificate certificate(source, x);
  if (before) before(certificate.cost());
  if (certificate.certifies(sigma)) {
    if (sides) *sides = {{sigma}, {0}, {}};
    return Verdict::certified;
  }
  const std::optional<TopQuotient> top = topQuotient(source, x);
  const bool violated = top && optimisticStep(top->lower, limit) < h;
  if (sides && violated) *sides = {{0}, top->lower, top->mode};
  return violated ? Verdict::violated : Verdict::notCertified;
}

}  // namespace ringwatch
