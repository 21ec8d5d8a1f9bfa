#include <ringwatch/monitor/bounds/lanczos_bound.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <ringwatch/base/error.h>
#include <ringwatch/base/random.h>
#include <ringwatch/base/rounding.h>
#include <ringwatch/monitor/bounds/mass_scaled_operator.h>
#include <ringwatch/monitor/small/lanczos.h>

namespace ringwatch {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// What the argument takes from the Lanczos matrix.
struct Tridiagonal : LanczosMatrix {
  /// log of the product of the k ratios β_j p_j/p_(j-1), which is p_k β_k times the other betas; NaN unless t lies
  /// right of all Ritz values.
  double logProduct(double t) const {
    double sum = 0, ratio = 1;
    for (std::size_t j = 0; j < alpha.size(); ++j) {
      ratio = t - alpha[j] - (j == 0 ? 0.0 : beta[j - 1] * beta[j - 1] / ratio);
      if (!(ratio > 0)) return std::numeric_limits<double>::quiet_NaN();
      sum += std::log(ratio);
    }
    return sum;
  }
  /// The least t, to a relative 1e-14 of the norm and rounded up, that fulfils a condition which holds for all larger
  /// t.
  template <class Condition>
  double least(double low, const Condition& holds) const {
    double high = radius + 1e-3 * radius + std::numeric_limits<double>::min();
    while (!holds(high)) high += high - low + radius;
    while (high - low > 1e-14 * radius) {
      const double middle = 0.5 * (low + high);
      if (!(middle > low && middle < high)) break;
      (holds(middle) ? high : low) = middle;
    }
    return high;
  }
};

}  // namespace

LanczosBound lanczosUpperBound(const TangentSource& source, NodeVectorsView x, double width, double eta,
                               std::uint64_t seed, int maxProducts) {
  if (!(width >= 1e-4 && width < 1)) throw InputError(joinText("width = ", width, ": must be >= 1e-4 and < 1"));
  if (!(eta > 0 && eta <= 0.5)) throw InputError(joinText("eta = ", eta, ": must be > 0 and <= 0.5"));
  if (maxProducts < 1) throw InputError(joinText("maxProducts = ", maxProducts, ": must be >= 1"));
  source.checkNodal("x", x);
  LanczosBound result{{0, eta}, {0}, 0, true};
  std::int64_t free = 0;
  for (std::int32_t i = 0; i < source.nodeCount(); ++i) free += source.constraints().freeComponents(i);
  if (free == 0) return result;
  const double d = eta * std::sqrt(std::numbers::pi / (2 * static_cast<double>(free)));
  if (!(d >= 500 * epsilon))
    throw InputError(joinText("eta = ", eta, ": must be >= ", eta * 500 * epsilon / d, " for ", free,
                              " free degrees of freedom, since rounding hides the top mode else"));

  const MassScaledOperator op(source, x);
  NodeVectors q(3, source.nodeCount()), before = NodeVectors::Zero(3, source.nodeCount()), w(3, source.nodeCount());
  Random random(seed);
  for (double& entry : q.reshaped()) entry = random.normal();
  op.restrict(q);
  q /= q.norm();
  Tridiagonal T;
  double logBetas = 0, ritz = 0;  // of all betas but the last
  while (true) {
    op.apply(q.data(), w.data());
    ++result.products;
    // Three terms only: the argument needs no orthogonality, just a recurrence that is exact to rounding.
    if (!T.beta.empty()) w -= T.beta.back() * before;
    const double alpha = w.cwiseProduct(q).sum();
    w -= alpha * q;
    const double beta = w.norm();
    if (!std::isfinite(alpha + beta)) {
      result.upper.value = result.ritz.value = std::numeric_limits<double>::quiet_NaN();
      result.achieved = false;
      return result;
    }
    if (!T.beta.empty()) logBetas += std::log(T.beta.back());
    T.append(alpha, beta);
    if (!(T.radius > 0)) return result;  // K q = 0 for a random q: there is no stiffness
    // The recurrence's own rounding counts as part of the next vector; that also serves when the vectors end.
    const double rounding = lanczosRounding * T.radius, target = std::log((beta + rounding) / (0.5 * d)) + logBetas;
    const double floor = T.size() == 1 ? -T.radius : ritz - rounding;  // Ritz values only rise
    ritz = T.least(floor, [&](double t) { return !std::isnan(T.logProduct(t)); });
    const double upper = T.least(ritz, [&](double t) { return T.logProduct(t) >= target; }) + rounding;
    result.ritz.value = std::max(0.0, ritz);
    result.upper.value = std::max(0.0, upper);
    // Below the rounding of the norm nothing can be told apart.
    result.achieved = result.upper.value <= (1 + width) * (1 + width) * result.ritz.value || upper <= 2 * rounding;
    if (result.achieved || !(beta > rounding) || result.products == maxProducts) return result;
    before.swap(q);
    q = w / beta;
  }
}

}  // namespace ringwatch
