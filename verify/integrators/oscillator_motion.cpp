#include <cmath>

#include <ringwatch/verify/integrators/oscillator.h>

namespace ringwatch {

Eigen::Vector2d Oscillator::exact(double t, double x0, double v0) const {
  const double w = omega_, d = 0.5 * alpha_, k = w * w - d * d;
  double c, s;  // cos and sin(root t)/root, continued to aperiodic motion
  if (k > 0) {
    c = std::cos(std::sqrt(k) * t);
    s = std::sin(std::sqrt(k) * t) / std::sqrt(k);
  } else if (k < 0) {
    c = std::cosh(std::sqrt(-k) * t);
    s = std::sinh(std::sqrt(-k) * t) / std::sqrt(-k);
  } else {
    c = 1;
    s = t;
  }
  const double decay = std::exp(-d * t);
  return {decay * (x0 * c + (v0 + d * x0) * s), decay * (v0 * c - (w * w * x0 + d * v0) * s)};
}

}  // namespace ringwatch
