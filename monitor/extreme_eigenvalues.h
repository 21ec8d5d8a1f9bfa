#pragma once
#include <ringwatch/base/math.h>

namespace ringwatch {

/// Largest and least eigenvalue of small symmetric matrices, one matrix a lane, with the same operations in every lane:
/// Householder tridiagonalisation (Golub & Van Loan 2013, alg. 8.3.1), then Laguerre's iteration on the characteristic
/// polynomial from outside the spectrum, which for real roots approaches the outermost one monotonically and cubically
/// (Parlett 1964).
///
/// The values are within `1e-12 * scale` of those of the matrix as given; whoever needs a proven side adds that.
template <class P>
struct ExtremeEigenvalues {
  P largest;
  P least;
  P scale;  // Gershgorin bound of the spectral radius
};

/// Reduces A (n×n, row by row, lower triangle read, destroyed) to tridiagonal form: diagonal d[n], squared off-diagonal
/// e2[n-1].
template <int N, class P>
RINGWATCH_HOST_DEVICE inline void tridiagonalize(P* A, int anyN, P* d, P* e2, P* v, P* p) {
  const int n = N > 0 ? N : anyN;  // a constant lets the compiler unroll
  for (int k = 0; k + 2 < n; ++k) {
    P norm2(0.0);
    for (int i = k + 1; i < n; ++i) {
      v[i] = A[i * n + k];
      norm2 += v[i] * v[i];
    }
    const P norm = math::sqrt(norm2);
    const P alpha = select(v[k + 1] > P(0.0), -norm, norm);
    e2[k] = norm2;
    d[k] = A[k * n + k];
    v[k + 1] -= alpha;
    const P vv = P(2.0) * (norm2 + norm * math::abs(A[(k + 1) * n + k]));
    const auto nonzero = vv > P(1e-250);  // below, 2 / vv and its products overflow, and nothing is left to reflect
    const P beta = select(nonzero, P(2.0) / select(nonzero, vv, P(1.0)), P(0.0));
    // p = beta A v from the lower triangle
    for (int i = k + 1; i < n; ++i) p[i] = P(0.0);
    for (int i = k + 1; i < n; ++i) {
      const P* row = A + i * n;
      P sum = row[i] * v[i];
      const P vi = v[i];
      for (int j = k + 1; j < i; ++j) {
        sum += row[j] * v[j];
        p[j] += row[j] * vi;
      }
      p[i] += sum;
    }
    P vp(0.0);
    for (int i = k + 1; i < n; ++i) {
      p[i] *= beta;
      vp += v[i] * p[i];
    }
    const P half = P(0.5) * beta * vp;
    for (int i = k + 1; i < n; ++i) p[i] -= half * v[i];
    for (int i = k + 1; i < n; ++i) {
      P* row = A + i * n;
      const P vi = v[i], pi = p[i];
      for (int j = k + 1; j <= i; ++j) row[j] -= vi * p[j] + pi * v[j];
    }
  }
  if (n >= 2) {
    d[n - 2] = A[(n - 2) * n + n - 2];
    e2[n - 2] = A[(n - 1) * n + n - 2] * A[(n - 1) * n + n - 2];
  }
  d[n - 1] = A[(n - 1) * n + n - 1];
}

/// Largest eigenvalue of sign·T, T tridiagonal, by Laguerre's iteration from `start`, which must lie at or above it.
template <int N, class P>
RINGWATCH_HOST_DEVICE inline P largestByLaguerre(const P* d, const P* e2, int anyN, P sign, P start, P scale) {
  const int n = N > 0 ? N : anyN;
  P lambda = start;
  // A few, mostly; a cluster of half the eigenvalues makes convergence linear, by a quarter each time at n = 60.
  constexpr int maxIterations = 250;
  const P tiny = P(1e-300) + P(1e-16) * scale, enough = P(1e-14) * scale + P(1e-300);
  for (int iteration = 0; iteration < maxIterations; ++iteration) {
    // Ratios of leading principal minors q_k = p_k / p_(k-1) > 0 right of the spectrum; r = q'/q, s = q''/q.
    P r(0.0), s(0.0), sumR(0.0), sumH(0.0), previousInverse(0.0), lowest = scale;
    for (int k = 0; k < n; ++k) {
      const P c = k == 0 ? P(0.0) : e2[k - 1] * previousInverse;  // e²/q_(k-1)
      const P q = lambda - sign * d[k] - c;
      lowest = math::min(lowest, q);
      const P inverse = P(1.0) / math::max(q, tiny);
      const P slope = P(1.0) + c * r, bend = c * (s - P(2.0) * r * r);
      r = slope * inverse;
      s = bend * inverse;
      sumR += r;
      sumH += r * r - s;
      previousInverse = inverse;
    }
    // Laguerre: lambda - n / (G + √((n-1)(n H - G²)))
    const P count(static_cast<double>(n));
    const P root = math::sqrt(math::max((count - P(1.0)) * (count * sumH - sumR * sumR), P(0.0)));
    const P step = select(lowest > tiny, count / (sumR + root), P(0.0));
    lambda -= step;
    if (!anyOf(step > enough)) break;
  }
  return lambda;
}

/// Extreme eigenvalues of A (n×n, row by row, destroyed), n >= 1, for an N known to the compiler or N = 0. `work` holds
/// 4n numbers.
template <int N, class P>
RINGWATCH_HOST_DEVICE inline ExtremeEigenvalues<P> extremeEigenvaluesOf(P* A, int anyN, P* work, bool wantLeast) {
  const int n = N > 0 ? N : anyN;
  P *d = work, *e2 = work + n, *v = work + 2 * n, *p = work + 3 * n;
  tridiagonalize<N>(A, n, d, e2, v, p);
  P high = d[0], low = d[0], before(0.0), sum(0.0);
  for (int k = 0; k < n; ++k) {
    sum += k + 1 < n ? d[k] + e2[k] : d[k];
    const P after = k + 1 < n ? math::sqrt(e2[k]) : P(0.0);
    high = k == 0 ? d[k] + after : math::max(high, d[k] + before + after);
    low = k == 0 ? d[k] - after : math::min(low, d[k] - before - after);
    before = after;
  }
  const P scale = math::max(math::abs(high), math::abs(low));
  const P margin = P(1e-13) * scale + P(1e-300);
  ExtremeEigenvalues<P> result;
  // min and max lose NaN: added back; 0 for finite numbers. A zero matrix would keep the margin.
  const P poison = P(0.0) * sum;
  const auto zero = scale == P(0.0);
  result.scale = scale + poison;
  result.largest = select(zero, P(0.0), largestByLaguerre<N>(d, e2, n, P(1.0), high + margin, scale)) + poison;
  result.least = P(0.0);
  if (wantLeast)
    result.least = select(zero, P(0.0), -largestByLaguerre<N>(d, e2, n, P(-1.0), margin - low, scale)) + poison;
  return result;
}

template <class P>
RINGWATCH_HOST_DEVICE inline ExtremeEigenvalues<P> extremeEigenvalues(P* A, int n, P* work, bool wantLeast) {
  switch (n) {
    case 3:
      return extremeEigenvaluesOf<3>(A, n, work, wantLeast);
    case 12:
      return extremeEigenvaluesOf<12>(A, n, work, wantLeast);
    default:
      return extremeEigenvaluesOf<0>(A, n, work, wantLeast);
  }
}

}  // namespace ringwatch
