#pragma once

namespace ringwatch::detail {

/// The root, to rounding, of a function that changes sign between low and high.
template <class Function>
double bisect(double low, double high, const Function& f) {
  const bool lowSign = f(low) > 0;
  constexpr int halvings = 200;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (low + high);
    ((f(middle) > 0) == lowSign ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace ringwatch::detail
