#pragma once
#include <ringwatch/base/math.h>

namespace ringwatch {

/// The highest eigenvalue of a symmetric positive semidefinite matrix K (n×n, both triangles) by eight power iterations
/// from its strongest column, to some per cent and from below. NaN for a matrix that is not finite. For an n known to
/// the compiler or N = 0; v and Kv hold n numbers each.
template <int N>
RINGWATCH_HOST_DEVICE inline double highestByPowerIteration(const double* K, int anyN, double* v, double* Kv) {
  constexpr int iterations = 8;
  const int n = N > 0 ? N : anyN;
  double most = -1;
  for (int j = 0; j < n; ++j) {
    double sum = 0;
    for (int i = 0; i < n; ++i) sum += K[j * n + i] * K[j * n + i];
    if (j == 0 || sum > most) {
      most = sum;
      for (int i = 0; i < n; ++i) v[i] = K[j * n + i];
    }
  }
  double value = 0;
#if defined(__CUDACC__)
#pragma unroll 1
#endif
  for (int k = 0; k < iterations; ++k) {
    double norm = 0;
    for (int i = 0; i < n; ++i) norm += v[i] * v[i];
    norm = math::sqrt(norm);
    if (!(norm > 0)) return norm;
    const double inverse = 1 / norm;
    value = 0;
    for (int i = 0; i < n; ++i) v[i] *= inverse;
    for (int i = 0; i < n; ++i) {
      double sum = 0;
      for (int j = 0; j < n; ++j) sum += K[i * n + j] * v[j];
      Kv[i] = sum;
      value += v[i] * sum;
    }
    for (int i = 0; i < n; ++i) v[i] = Kv[i];
  }
  return value;
}

}  // namespace ringwatch
