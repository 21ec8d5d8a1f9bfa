#pragma once
#include <type_traits>
#include <utility>

#include <ringwatch/base/math.h>
#include <ringwatch/base/rounding.h>

namespace ringwatch {

/// Largest and least eigenvalue of small symmetric matrices, one matrix a lane, with the same operations in every lane:
/// Householder tridiagonalisation (Golub & Van Loan 2013, alg. 8.3.1), then Laguerre's iteration on the characteristic
/// polynomial from outside the spectrum, which for real roots approaches the outermost one monotonically and cubically
/// (Parlett 1964).
///
/// The values are within `eigenvalueRounding * scale` of those of the matrix as given (base/rounding.h): Theorem 43,
/// docs/theory/floating_point.md.
template <class P>
struct ExtremeEigenvalues {
  P largest;
  P least;
  P scale;  // Gershgorin bound of the spectral radius
};

namespace detail {
/// Calls body(i) for begin <= i < end; `Unrolled` asks the compiler for straight code, which takes constant bounds.
template <bool Unrolled, class Loop>
RINGWATCH_INLINE void forRange(int begin, int end, const Loop& body) {
  if constexpr (Unrolled) {
#if defined(__clang__) || defined(__CUDACC__)
#pragma unroll
#else
#pragma GCC unroll 16
#endif
    for (int i = begin; i < end; ++i) body(i);
  } else {
    for (int i = begin; i < end; ++i) body(i);
  }
}

/// Householder's reflection of column k, applied to the columns right of it. What bounds the speed is the chain from
/// sum to root to quotient to sum: sums are split in four, and the product with A starts before the root is known.
template <bool Unrolled, class P>
RINGWATCH_INLINE void reduceColumn(P* A, int n, int k, P* d, P* e2, P* v, P* p) {
  const auto sumOf = [](const P* part) { return (part[0] + part[1]) + (part[2] + part[3]); };
  P squares[4] = {P(0.0), P(0.0), P(0.0), P(0.0)};
  forRange<Unrolled>(k + 1, n, [&](int i) {
    v[i] = A[i * n + k];
    squares[i % 4] += v[i] * v[i];
    p[i] = P(0.0);
  });
  // p = A x from the lower triangle, x the column
  forRange<Unrolled>(k + 1, n, [&](int i) {
    const P* row = A + i * n;
    P sum = row[i] * v[i];
    const P vi = v[i];
    forRange<Unrolled>(k + 1, i, [&](int j) {
      sum += row[j] * v[j];
      p[j] += row[j] * vi;
    });
    p[i] += sum;
  });
  const P norm2 = sumOf(squares), norm = math::sqrt(norm2);
  const P alpha = select(v[k + 1] > P(0.0), -norm, norm);
  const P vv = P(2.0) * (norm2 + norm * math::abs(v[k + 1]));
  e2[k] = norm2;
  d[k] = A[k * n + k];
  const auto nonzero = vv > P(1e-250);  // below, 2 / vv and its products overflow, and nothing is left to reflect
  const P beta = select(nonzero, P(2.0) / select(nonzero, vv, P(1.0)), P(0.0));
  // v = x - alpha e, p = beta A v
  v[k + 1] -= alpha;
  P products[4] = {P(0.0), P(0.0), P(0.0), P(0.0)};
  forRange<Unrolled>(k + 1, n, [&](int i) {
    p[i] = beta * (p[i] - alpha * A[i * n + k + 1]);
    products[i % 4] += v[i] * p[i];
  });
  const P half = P(0.5) * beta * sumOf(products);
  forRange<Unrolled>(k + 1, n, [&](int i) { p[i] -= half * v[i]; });
  forRange<Unrolled>(k + 1, n, [&](int i) {
    P* row = A + i * n;
    const P vi = v[i], pi = p[i];
    forRange<Unrolled>(k + 1, i + 1, [&](int j) { row[j] = row[j] - vi * p[j] - pi * v[j]; });
  });
}
template <int N, class P, int... K>
RINGWATCH_INLINE void reduceColumns(P* A, P* d, P* e2, P* v, P* p, std::integer_sequence<int, K...>) {
  (reduceColumn<true>(A, N, K, d, e2, v, p), ...);
}
}  // namespace detail

/// Reduces A (n×n, row by row, lower triangle read, destroyed) to tridiagonal form: diagonal d[n], squared off-diagonal
/// e2[n-1].
template <int N, class P>
RINGWATCH_HOST_DEVICE inline void tridiagonalize(P* A, int anyN, P* d, P* e2, P* v, P* p) {
  const int n = N > 0 ? N : anyN;
  if constexpr (N > 2 && N <= 12) {  // straight code, v and p in registers
    P own[2][N];
    detail::reduceColumns<N>(A, d, e2, own[0], own[1], std::make_integer_sequence<int, N - 2>());
  } else {
    for (int k = 0; k + 2 < n; ++k) detail::reduceColumn<false>(A, n, k, d, e2, v, p);
  }
  if (n >= 2) {
    d[n - 2] = A[(n - 2) * n + n - 2];
    e2[n - 2] = A[(n - 1) * n + n - 2] * A[(n - 1) * n + n - 2];
  }
  d[n - 1] = A[(n - 1) * n + n - 1];
}

/// Sums over the eigenvalues λ_i of a tridiagonal matrix, from its characteristic polynomial p at x.
template <class P>
struct CharacteristicSums {
  P first;   // Σ 1/(x - λ_i) = p'/p
  P second;  // Σ 1/(x - λ_i)² = (p'/p)² - p''/p
  P least;   // positive where x lies right of all λ_i: then all leading minors are
};
/// The sums by the three-term recurrence, without a division in it; for numbers of order one and n <= 24, else minors
/// underflow.
template <int N, class P>
RINGWATCH_HOST_DEVICE inline CharacteristicSums<P> sumsByMinors(const P* d, const P* e2, int anyN, P x) {
  const int n = N > 0 ? N : anyN;
  // p, p', p''/2 of the leading minors of order k and k - 1
  P p = x - d[0], dp(1.0), ddp(0.0), p0(1.0), dp0(0.0), ddp0(0.0), least = p;
  detail::forRange<(N > 0)>(1, n, [&](int k) {
    const P q = x - d[k], e = e2[k - 1];
    const P ddp1 = q * ddp + (dp - e * ddp0), dp1 = q * dp + (p - e * dp0), p1 = q * p - e * p0;
    ddp0 = ddp;
    dp0 = dp;
    p0 = p;
    ddp = ddp1;
    dp = dp1;
    p = p1;
    least = math::min(least, p);
  });
  constexpr double tiny = std::is_same_v<P, float> ? 1e-30 : 1e-290;
  const P inverse = P(1.0) / select(p > P(tiny), p, P(1.0));
  const P first = dp * inverse;
  return {first, first * first - P(2.0) * ddp * inverse, least - P(tiny)};
}
/// The sums by ratios of successive minors: for any n.
template <class P>
RINGWATCH_HOST_DEVICE inline CharacteristicSums<P> sumsByRatios(const P* d, const P* e2, int n, P x) {
  const P tiny(1e-16);
  // q_k = p_k / p_(k-1), r = q'/q, s = q''/q
  P r(0.0), s(0.0), first(0.0), second(0.0), previousInverse(0.0), least(1.0);
  for (int k = 0; k < n; ++k) {
    const P c = k == 0 ? P(0.0) : e2[k - 1] * previousInverse;
    const P q = x - d[k] - c;
    least = math::min(least, q);
    const P inverse = P(1.0) / math::max(q, tiny);
    const P slope = P(1.0) + c * r, bend = c * (s - P(2.0) * r * r);
    r = slope * inverse;
    s = bend * inverse;
    first += r;
    second += r * r - s;
    previousInverse = inverse;
  }
  return {first, second, least - tiny};
}

/// Largest eigenvalue of a tridiagonal matrix of spectral radius at most one, by Laguerre's iteration from `start`,
/// which must lie at or above it.
template <int N, class P>
RINGWATCH_HOST_DEVICE inline P largestByLaguerre(const P* d, const P* e2, int anyN, P start) {
  const int n = N > 0 ? N : anyN;
  const P count(static_cast<double>(n));
  // What may be left, and the least step that is worth another one.
  constexpr bool single = std::is_same_v<P, float>;
  constexpr double enough = single ? 3e-6 : 1e-13, shortest = single ? 1e-7 : 1e-15;
  P lambda = start;
  auto going = lambda >= lambda;  // a lane ends with its own iteration, whatever lies beside it in the pack
  // A few, mostly; a cluster of half the eigenvalues makes convergence linear, by a quarter each time at n = 60.
  constexpr int maxIterations = 250;
  for (int iteration = 0; iteration < maxIterations; ++iteration) {
    const CharacteristicSums<P> sums = n <= 24 ? sumsByMinors<N>(d, e2, n, lambda) : sumsByRatios(d, e2, n, lambda);
    // λ - n / (G + √((n-1)(n H - G²))) with the sums G, H; the root is at most G/H away, since the largest of positive
    // numbers is at least the ratio of their squares' sum to their own.
    const auto right = going & (sums.least > P(0.0)) & (sums.first > P(0.0)) & (sums.second > P(0.0));
    const P first = select(right, sums.first, P(1.0)), second = select(right, sums.second, P(1.0));
    const P root = math::sqrt(math::max((count - P(1.0)) * (count * second - first * first), P(0.0)));
    const P step = select(right, count / (first + root), P(0.0));
    const P left = select(right, first / second, P(0.0)) - step;
    lambda -= step;
    going = going & (left > P(enough)) & (step > P(shortest));
    if (!anyOf(going)) break;
  }
  return lambda;
}
/// largestByLaguerre for n <= 24, most of the way in single precision: half of the work where that is the faster one.
template <int N>
RINGWATCH_HOST_DEVICE inline double largestFromSingle(const double* d, const double* e2, double start) {
  static_assert(N > 0 && N <= 24);
  float single[N], single2[N];
  for (int k = 0; k < N; ++k) {
    single[k] = static_cast<float>(d[k]);
    single2[k] = k + 1 < N ? static_cast<float>(e2[k]) : 0.0F;
  }
  // Rounding moves eigenvalues of order one by less than this; whether it was enough is seen in double precision.
  constexpr double singleRounding = 5e-6;
  const double guess =
      static_cast<double>(largestByLaguerre<N>(single, single2, N, static_cast<float>(start + singleRounding))) +
      singleRounding;
  if (guess < start) {
    const double found = largestByLaguerre<N>(d, e2, N, guess);
    if (found < guess) return found;  // else it did not lie above
  }
  return largestByLaguerre<N>(d, e2, N, start);
}

/// Bounds of a tridiagonal matrix's eigenvalues and its largest one.
template <class P>
struct TridiagonalBounds {
  P low, high, scale;  // Gershgorin's circles
  P mean, deviation;   // of the eigenvalues
};
template <class P>
RINGWATCH_HOST_DEVICE inline TridiagonalBounds<P> tridiagonalBounds(const P* d, const P* e2, int n) {
  TridiagonalBounds<P> b;
  P before(0.0), sum(0.0);
  for (int k = 0; k < n; ++k) {
    sum += d[k];
    const P after = k + 1 < n ? math::sqrt(e2[k]) : P(0.0);
    b.high = k == 0 ? d[k] + after : math::max(b.high, d[k] + before + after);
    b.low = k == 0 ? d[k] - after : math::min(b.low, d[k] - before - after);
    before = after;
  }
  b.scale = math::max(math::abs(b.high), math::abs(b.low));
  b.mean = sum * P(1.0 / n);
  P squares(0.0);
  for (int k = 0; k < n; ++k) {
    const P off = d[k] - b.mean;
    squares += off * off;
    if (k + 1 < n) squares += P(2.0) * e2[k];
  }
  b.deviation = math::sqrt(squares * P(1.0 / n));
  return b;
}

/// Extreme eigenvalues of a tridiagonal matrix: diagonal d[n], squared off-diagonal e2[n-1], which are destroyed; n >=
/// 1, N as for extremeEigenvaluesOf.
template <int N, class P, bool fromSingle = false>
RINGWATCH_HOST_DEVICE inline ExtremeEigenvalues<P> extremesOfTridiagonal(P* d, P* e2, int anyN, bool wantLeast) {
  const int n = N > 0 ? N : anyN;
  P nanGuard(0.0);  // min and max lose NaN: added back; 0 for finite numbers
  for (int k = 0; k < n; ++k) nanGuard += k + 1 < n ? d[k] + e2[k] : d[k];
  nanGuard *= P(0.0);
  const TridiagonalBounds<P> bounds = tridiagonalBounds(d, e2, n);
  // To a spectral radius of at most one; a zero matrix stays as it is.
  const auto zero = bounds.scale <= P(1e-290);
  const P unit = P(1.0) / select(zero, P(1.0), bounds.scale);
  for (int k = 0; k < n; ++k) {
    d[k] *= unit;
    if (k + 1 < n) e2[k] = e2[k] * unit * unit;
  }
  // No eigenvalue is farther than √(n-1) deviations from the mean (Samuelson 1968).
  const P spread = P(math::sqrt(n - 1.0)) * bounds.deviation, margin(1e-13);
  ExtremeEigenvalues<P> result;
  result.scale = bounds.scale + nanGuard;
  const P high = math::min(bounds.high, bounds.mean + spread) * unit + margin;
  P largest;
  if constexpr (fromSingle)
    largest = largestFromSingle<N>(d, e2, high);
  else
    largest = largestByLaguerre<N>(d, e2, n, high);
  result.largest = select(zero, P(0.0), bounds.scale * largest) + nanGuard;
  result.least = P(0.0);
  if (wantLeast) {
    for (int k = 0; k < n; ++k) d[k] = -d[k];
    const P low = math::min(-bounds.low, spread - bounds.mean) * unit + margin;
    result.least = select(zero, P(0.0), -bounds.scale * largestByLaguerre<N>(d, e2, n, low)) + nanGuard;
  }
  return result;
}

/// Extreme eigenvalues of A (n×n, row by row, destroyed), n >= 1, for an N known to the compiler or N = 0. `work` holds
/// 4n numbers. fromSingle: iterates in single precision first.
template <int N, class P, bool fromSingle = false>
RINGWATCH_HOST_DEVICE inline ExtremeEigenvalues<P> extremeEigenvaluesOf(P* A, int anyN, P* work, bool wantLeast) {
  const int n = N > 0 ? N : anyN;
  P *d = work, *e2 = work + n, *v = work + 2 * n, *p = work + 3 * n;
  tridiagonalize<N>(A, n, d, e2, v, p);
  return extremesOfTridiagonal<N, P, fromSingle>(d, e2, n, wantLeast);
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
