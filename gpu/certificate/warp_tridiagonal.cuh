#pragma once
#include <ringwatch/gpu/certificate/thread_teams.cuh>

namespace ringwatch::detail {

/// tridiagonalize() (monitor/small/extreme_eigenvalues.h) of one matrix by a warp, thread i the one of row i, so that
/// an element is not a chain of some 10⁴ operations. Sums over a row go over the threads; the bound of Theorem 43
/// (docs/theory/floating_point.md) does not depend on their order. All arrays are in memory that the warp shares.
template <int n>
struct WarpTridiagonal {
  static_assert(n >= 3 && n <= Warp::size);
  double A[n * n];  // both triangles, the same bits; destroyed
  double d[n], e2[n];
  double v[n], p[n];

  __device__ void reduce() {
    __syncwarp();
#pragma unroll 1
    for (int k = 0; k + 2 < n; ++k) reduceColumn(k);
    if (Warp::first() == 0) {
      d[n - 2] = A[(n - 2) * n + n - 2];
      e2[n - 2] = A[(n - 1) * n + n - 2] * A[(n - 1) * n + n - 2];
      d[n - 1] = A[(n - 1) * n + n - 1];
    }
    __syncwarp();
  }

 private:
  /// Householder's reflection of column k, as detail::reduceColumn.
  __device__ __forceinline__ void reduceColumn(int k) {
    const int i = Warp::first();
    const bool mine = i > k && i < n;
    const double x = mine ? A[k * n + i] : 0;
    const double norm2 = Warp::sum(x * x), norm = sqrt(norm2), next = A[k * n + k + 1];
    const double alpha = next > 0 ? -norm : norm, vv = 2 * (norm2 + norm * fabs(next));
    const double beta = vv > 1e-250 ? 2 / vv : 0;  // below, 2 / vv and its products overflow
    const double vi = i == k + 1 ? x - alpha : x;
    if (mine) v[i] = vi;
    if (i == 0) {
      d[k] = A[k * n + k];
      e2[k] = norm2;
    }
    __syncwarp();
    double pi = 0;
    if (mine)
#pragma unroll 4
      for (int j = k + 1; j < n; ++j) pi += A[j * n + i] * v[j];
    pi *= beta;
    pi -= 0.5 * beta * Warp::sum(vi * pi) * vi;
    if (mine) p[i] = pi;
    __syncwarp();
    if (mine)
#pragma unroll 4
      for (int j = k + 1; j < n; ++j)  // without contractions, so that both triangles stay the same
        A[j * n + i] -= __dadd_rn(__dmul_rn(vi, p[j]), __dmul_rn(pi, v[j]));
    __syncwarp();
  }
};

}  // namespace ringwatch::detail
