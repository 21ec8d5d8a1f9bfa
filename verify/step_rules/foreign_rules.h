#pragma once
#include <span>
#include <string_view>

#include <ringwatch/monitor/metrics/metrics.h>

namespace ringwatch::detail {

/// The step rule of other solvers: the step at which central differences reach the frequency of a metric, times a
/// factor.
struct ForeignRule {
  std::string_view column, metric;
  double (*factor)(double poisson) = nullptr;  // 1 without
  bool ofMeshes = false;                       // says nothing new of an element alone
};

/// The rules of this study. LS-DYNA's and Radioss' lengths are the least height of tetrahedra and V / max A of the
/// others, `height or V/A`; deal.II's step-101 takes the shortest edge, FEniCSx codes the diameter of a cell or, as
/// fenics-constitutive does, a cube of that size.
std::span<const ForeignRule> foreignRules();

/// What a rule multiplies the step of its metric by.
inline double factorOf(const ForeignRule& rule, double poisson) { return rule.factor ? rule.factor(poisson) : 1; }

}  // namespace ringwatch::detail
