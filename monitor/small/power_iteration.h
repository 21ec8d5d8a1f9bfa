#pragma once
#include <ringwatch/base/math.h>

namespace ringwatch {

/// The highest eigenvalue of a symmetric positive semidefinite matrix K (n×n, both triangles) by eight power iterations
/// from its strongest column, to some per cent and from below. NaN for a matrix that is not finite. S: a number or a
/// pack, a matrix a lane. For an n known to the compiler or N = 0; v and Kv hold n entries each.
template <int N, class S>
RINGWATCH_HOST_DEVICE inline S highestByPowerIteration(const S* K, int anyN, S* v, S* Kv) {
  constexpr int iterations = 8;
  const int n = N > 0 ? N : anyN;
  for (int i = 0; i < n; ++i) v[i] = S(0);
  S most(-1);
  for (int j = 0; j < n; ++j) {
    S length(0);
    for (int i = 0; i < n; ++i) length += K[j * n + i] * K[j * n + i];
    const auto longer = length > most;
    most = select(longer, length, most);
    for (int i = 0; i < n; ++i) v[i] = select(longer, K[j * n + i], v[i]);
  }
  S value(0);
#if defined(__CUDACC__)
#pragma unroll 1
#endif
  for (int k = 0; k < iterations; ++k) {
    S length(0);
    for (int i = 0; i < n; ++i) length += v[i] * v[i];
    const S scale = select(length > S(0), S(1) / math::sqrt(length), length);
    value = S(0);
    for (int i = 0; i < n; ++i) {
      S sum(0);
      for (int j = 0; j < n; ++j) sum += K[i * n + j] * v[j];
      Kv[i] = scale * sum;
      value += v[i] * Kv[i];
    }
    value *= scale;
    for (int i = 0; i < n; ++i) v[i] = Kv[i];
  }
  return value;
}

}  // namespace ringwatch
