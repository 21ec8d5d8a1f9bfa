#pragma once
#include <limits>

#include <ringwatch/base/pack.h>

namespace ringwatch {

/// Eigenvalues and eigenvectors of small symmetric matrices, one matrix a lane, by Jacobi's rotations (Golub & Van Loan
/// 2013, section 8.5), the same in every lane. A (n×n, row by row, both triangles) becomes VᵀAV, its diagonal the
/// eigenvalues to within the norm of what is left beside it; VT (n×n) holds the eigenvectors as rows. Stops when that
/// norm is at most `tolerance` of the matrix' in all lanes, or after `maxSweeps`. Returns the norm left beside the
/// diagonal, a bound of the eigenvalues' error (Theorem 13 (c), docs/theory/exchange.md).
template <int N, class P>
RINGWATCH_HOST_DEVICE inline P diagonalize(P* A, P* VT, int anyN, double tolerance, int maxSweeps) {
  const int n = N > 0 ? N : anyN;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) VT[i * n + j] = P(i == j ? 1.0 : 0.0);
  const auto norms = [&](P& beside) {
    P all(0.0);
    beside = P(0.0);
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < i; ++j) beside += A[i * n + j] * A[i * n + j];
      all += A[i * n + i] * A[i * n + i];
    }
    beside = beside + beside;
    return all + beside;
  };
  P beside;
  for (int sweep = 0;; ++sweep) {
    const P all = norms(beside);
    if (sweep == maxSweeps || !anyOf(beside > P(tolerance * tolerance) * all)) break;
    for (int p = 0; p + 1 < n; ++p)
      for (int q = p + 1; q < n; ++q) {
        // t = tan of the angle, the smaller root of t² + 2 θ t - 1 = 0, θ = (a_qq - a_pp) / (2 a_pq)
        const P apq = A[p * n + q], twice = apq + apq, d = A[q * n + q] - A[p * n + p];
        const P root = math::sqrt(d * d + twice * twice) + P(std::numeric_limits<decltype(P()[0])>::min());
        const P t = select(d < P(0.0), -twice, twice) / (math::abs(d) + root);
        const P c = P(1.0) / math::sqrt(t * t + P(1.0)), s = t * c;
        const P app = A[p * n + p] - t * apq, aqq = A[q * n + q] + t * apq;
        for (int k = 0; k < n; ++k) {
          const P kp = A[p * n + k], kq = A[q * n + k];
          A[p * n + k] = c * kp - s * kq;
          A[q * n + k] = s * kp + c * kq;
          const P vp = VT[p * n + k], vq = VT[q * n + k];
          VT[p * n + k] = c * vp - s * vq;
          VT[q * n + k] = s * vp + c * vq;
        }
        A[p * n + p] = app;
        A[q * n + q] = aqq;
        A[p * n + q] = A[q * n + p] = P(0.0);
        for (int k = 0; k < n; ++k) {
          A[k * n + p] = A[p * n + k];
          A[k * n + q] = A[q * n + k];
        }
      }
  }
  return math::sqrt(beside);
}

}  // namespace ringwatch
