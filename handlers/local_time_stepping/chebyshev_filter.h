#pragma once
#include <vector>

namespace ringwatch {

/// A polynomial Q of degree p - 1 that averages a force over a step which is too large for it. With
///   N(s) = kappa (T_p(w0) - T_p(w0 - w1 s)),   s = c + weight b,   Q(b) = N(s)/s,
/// T_p Chebyshev's polynomial: Q(0) = 1, 0 < Q <= 1 and
///   Q(b) (c + weight b) <= ceiling   for 0 <= b <= range,
/// the ceiling being the largest (h omega)² that the base scheme is to see: 4 is the limit of leapfrog.
/// c = 0 and w0 = 1 is p leapfrog steps of h/p from rest (Diaz & Grote 2009); w0 > 1 and the shift c are the damping
/// and the stabilisation of Carle, Hochbruck & Sturm (2020). Theorem 35, docs/theory/handlers.md.
struct ChebyshevFilter {
  int steps = 1;  // p
  double coarse = 0, weight = 1, ceiling = 4;
  double w1 = 1, kappa = 1;
  double range = 0;
  std::vector<double> atShift{1, 1};  // T_0(w0) … T_p(w0)

  /// Q(b).
  double operator()(double b) const;
};

/// The filter of p >= 2 steps for 0 <= coarse < ceiling. damping: least N over [c, c + weight range] by its largest,
/// >= 0 and < 1; with 0, Q has zeros. The range is the largest that these allow.
ChebyshevFilter chebyshevFilter(int steps, double ceiling, double coarse, double weight, double damping);

}  // namespace ringwatch
