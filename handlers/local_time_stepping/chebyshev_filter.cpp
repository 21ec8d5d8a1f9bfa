#include <ringwatch/handlers/local_time_stepping/chebyshev_filter.h>

#include <cmath>
#include <numbers>

namespace ringwatch {
namespace {

double chebyshev(int p, double w) {
  return w >= 1   ? std::cosh(p * std::acosh(w))
         : w > -1 ? std::cos(p * std::acos(w))
                  : (p % 2 == 0 ? 1.0 : -1.0) * std::cosh(p * std::acosh(-w));
}

}  // namespace

double ChebyshevFilter::operator()(double b) const {
  // The recursion of the vectors, in numbers.
  double before = 0, u = w1;
  for (int m = 1; m < steps; ++m) {
    const double next = 2 * (atShift[1] - w1 * (coarse + weight * b)) * u - before + 2 * w1 * atShift[m];
    before = u;
    u = next;
  }
  return kappa * u;
}

ChebyshevFilter chebyshevFilter(int steps, double ceiling, double coarse, double weight, double damping) {
  ChebyshevFilter filter;
  filter.steps = steps;
  filter.ceiling = ceiling;
  filter.coarse = coarse;
  filter.weight = weight;
  const double top = (1 + damping) / (1 - damping);  // T_p(w0)
  const double w0 = std::cosh(std::acosh(top) / steps);
  filter.kappa = ceiling / (top + 1);
  if (coarse > 0) {
    // N(c) = c on the way up to the first peak, at w0 - w1 c = cos(pi/p).
    double low = 0, high = (w0 - std::cos(std::numbers::pi / steps)) / coarse;
    constexpr int halvings = 60;
    for (int i = 0; i < halvings; ++i) {
      const double middle = 0.5 * (low + high);
      (filter.kappa * (top - chebyshev(steps, w0 - middle * coarse)) < coarse ? low : high) = middle;
    }
    filter.w1 = 0.5 * (low + high);
  } else {
    // N'(0) = 1, with T_p' = p sinh(p t)/sinh(t) at cosh t.
    const double t = std::acosh(w0);
    filter.w1 = 1 / (filter.kappa * (t > 0 ? steps * std::sinh(steps * t) / std::sinh(t) : 1.0 * steps * steps));
  }
  filter.range = ((w0 + 1) / filter.w1 - coarse) / weight;
  filter.atShift.clear();
  for (int m = 0; m <= steps; ++m) filter.atShift.push_back(chebyshev(m, w0));
  return filter;
}

}  // namespace ringwatch
