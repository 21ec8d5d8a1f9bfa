#pragma once
#include <ringwatch/base/pack.h>

namespace ringwatch {

/// Whether symmetric matrices are positive definite, one matrix a lane: the pivots of L Δ Lᵀ (Golub & Van Loan 2013,
/// section 4.1). A: n×n, row by row, of which the lower triangle is read and used up. Returns 1 in lanes where all
/// pivots are positive, else 0, as for matrices with NaN. What that proves of a matrix that is not far from
/// semidefinite is Theorem 41, docs/theory/floating_point.md.
template <int N, class P>
RINGWATCH_HOST_DEVICE inline P pivotsArePositive(P* A, int anyN) {
  const int n = N > 0 ? N : anyN;
  P all(1.0);
  for (int k = 0; k < n; ++k) {
    const P pivot = A[k * n + k];
    all = select(pivot > P(0.0), all, P(0.0));
    if (!anyOf(all > P(0.0))) break;
    const P inverse = P(1.0) / pivot;
    for (int i = k + 1; i < n; ++i) {
      const P factor = A[i * n + k] * inverse;
      for (int j = k + 1; j <= i; ++j) A[i * n + j] -= factor * A[j * n + k];
    }
  }
  return all;
}

/// The same for any n, with loops of known length for those of linear elements.
template <class P>
P pivotsArePositive(P* A, int n) {
  switch (n) {
    case 12:
      return pivotsArePositive<12>(A, n);
    case 15:
      return pivotsArePositive<15>(A, n);
    case 18:
      return pivotsArePositive<18>(A, n);
    case 24:
      return pivotsArePositive<24>(A, n);
    default:
      return pivotsArePositive<0>(A, n);
  }
}

}  // namespace ringwatch
