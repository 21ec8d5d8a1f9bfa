#include <ringwatch/integrators/stability_limit.h>

#include <cmath>

#include <Eigen/LU>

#include <ringwatch/base/infinity.h>

namespace ringwatch {

bool isStableAmplification(const Eigen::Matrix2d& T) {
  constexpr double slack = 1e-12;
  const double det = T.determinant(), trace = T.trace();
  return std::abs(det) <= 1 + slack && std::abs(trace) <= 1 + det + slack;  // false for NaN
}

std::optional<double> declaredLimit(const IntegratorInfo& info, double dampingRatio) {
  if (dampingRatio == 0 || info.imaginaryLimit == infinity) return info.imaginaryLimit;
  if (info.dampedLimit) return info.dampedLimit(dampingRatio);
  if (!info.amplification) return std::nullopt;
  // The fastest eigenvalue of a heavily damped mode is near 2 ξ omega: scan in units of it.
  const double unit = 1 / (1 + 2 * dampingRatio), scanStep = 0.02, scanEnd = 64;
  const auto stable = [&](double s) { return isStableAmplification(info.amplification(s * unit, dampingRatio)); };
  double low = 0, high = scanStep;
  while (stable(high)) {
    low = high;
    high += scanStep;
    if (high > scanEnd) return infinity;
  }
  while (high - low > 1e-12 * high) {
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) break;
    (stable(middle) ? low : high) = middle;
  }
  return low * unit;
}

std::optional<double> dampedStep(double lambda, const RayleighDamping& damping, const IntegratorInfo& info) {
  if (std::isnan(lambda)) return lambda;
  if (info.imaginaryLimit == infinity) return infinity;
  if (!damping.any()) return lambda > 0 ? info.imaginaryLimit / std::sqrt(lambda) : infinity;
  // A vanishing frequency stands for rigid modes, which mass-proportional damping limits too.
  const double top = std::sqrt(std::max(lambda, 1e-12 * damping.alpha * damping.alpha));
  if (top == 0) return infinity;
  const auto stepOf = [&](double omega) -> std::optional<double> {
    const std::optional<double> limit = declaredLimit(info, 0.5 * (damping.alpha / omega + damping.beta * omega));
    if (!limit) return std::nullopt;
    return *limit / omega;
  };
  if (info.highestModeBinds) return stepOf(top);
  constexpr int modes = 64;
  double step = infinity, binding = top;
  for (int k = modes; k >= 0; --k) {
    const double omega = k > 0 ? top * k / modes : 1e-6 * top;
    const std::optional<double> h = stepOf(omega);
    if (!h) return std::nullopt;
    if (*h < step) {
      step = *h;
      binding = omega;
    }
  }
  // Closer to the mode that binds, between its neighbours.
  double low = std::max(binding - top / modes, 1e-6 * top), high = std::min(binding + top / modes, top);
  for (int iteration = 0; iteration < 25; ++iteration) {
    const double left = low + (high - low) / 3, right = high - (high - low) / 3, hLeft = *stepOf(left),
                 hRight = *stepOf(right);
    step = std::min({step, hLeft, hRight});
    (hLeft < hRight ? high : low) = hLeft < hRight ? right : left;
  }
  return step;
}

}  // namespace ringwatch
