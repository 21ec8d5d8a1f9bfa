#pragma once
#include <limits>

#include <ringwatch/monitor/small/packed_cholesky.h>
#include <ringwatch/monitor/small/packed_jacobi.h>

namespace ringwatch {

/// Of symmetric matrices, one a lane: a lower bound of lambda_min, -infinity where none was found, and the squared norm
/// of what was taken away.
template <class P>
struct LowestPart {
  P least, square;
};

/// Takes most of the negative part away from `matrix` (n×n, both triangles): its part in the span of a few vectors,
/// which inverse iteration with a shift below lambda_min turns toward the lowest eigenvectors (Golub & Van Loan 2013,
/// section 8.2), by Rayleigh and Ritz. What is left is no lower than the matrix was. A fifth of a whole decomposition's
/// cost. The bound is proven by a factorisation (Theorem 41, docs/theory/floating_point.md). A: n² packs, used up.
/// enough: matrix + enough 1 is believed to be definite, and positive. step: where a matrix is definite, whether it is
/// so by this much is tried.
template <int N, class P>
RINGWATCH_HOST_DEVICE inline LowestPart<P> removeLowestPart(P* A, P* matrix, int anyN, const P& enough, const P& step) {
  constexpr int vectors = 4, rounds = 3, quarters = 8;
  constexpr int most = N > 0 ? N : 60;
  const int n = N > 0 ? N : anyN;
  const auto definite = [&](const P& shift) {
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < i; ++j) A[i * n + j] = matrix[i * n + j];
      A[i * n + i] = matrix[i * n + i] + shift;
    }
    return pivotsArePositive<N>(A, n) > P(0.0);
  };
  LowestPart<P> part{P(-std::numeric_limits<double>::infinity()), P(0.0)};
  const auto already = definite(P(0.0));
  part.least = select(already, P(0.0), part.least);
  if (anyOf(already))
    for (const double times : {1.0, 4.0})
      part.least = select(already & definite(P(-times) * step), P(times) * step, part.least);
  if (allOf(already)) return part;
  // A shift that is not much larger than it must be: within a fifth where it is found.
  P shift = enough;
  const auto lowerBy = [&](double factor) {
    const P less = P(factor) * shift;
    const auto enoughToo = definite(less);
    shift = select(enoughToo, less, shift);
    return anyOf(enoughToo);
  };
  for (int k = 0; k < quarters && lowerBy(0.25); ++k) {
  }
  for (const double factor : {0.5, 0.7, 0.84}) lowerBy(factor);
  const auto factored = definite(shift);
  part.least = select(already | ~factored, part.least, -shift);
  P V[vectors][most], inverse[most];
  for (int i = 0; i < n; ++i) inverse[i] = P(1.0) / select(factored, A[i * n + i], P(1.0));
  // Any vectors will do that are not likely to miss what is looked for: pseudo-random ones.
  double digits = 0;
  for (auto& v : V)
    for (int i = 0; i < n; ++i) {
      digits = 997 * digits + 0.6180339887498949;
      digits -= static_cast<int>(digits);
      v[i] = P(digits - 0.5);
    }
  for (int round = 0; round < rounds; ++round)
    for (int k = 0; k < vectors; ++k) {
      P* v = V[k];
      for (int i = 0; i < n; ++i) {
        const P scaled = v[i] * inverse[i];
        for (int j = i + 1; j < n; ++j) v[j] -= A[j * n + i] * scaled;
      }
      for (int i = n - 1; i >= 0; --i) {
        P sum = v[i];
        for (int j = i + 1; j < n; ++j) sum -= A[j * n + i] * v[j];
        v[i] = sum * inverse[i];
      }
      for (int before = 0; before < k; ++before) {
        P along(0.0);
        for (int i = 0; i < n; ++i) along += v[i] * V[before][i];
        for (int i = 0; i < n; ++i) v[i] -= along * V[before][i];
      }
      P square(0.0);
      for (int i = 0; i < n; ++i) square += v[i] * v[i];
      const P scale = P(1.0) / math::sqrt(square + P(std::numeric_limits<decltype(P()[0])>::min()));
      for (int i = 0; i < n; ++i) v[i] *= scale;
    }
  P T[vectors * vectors], Z[vectors * vectors];
  for (int k = 0; k < vectors; ++k) {
    P product[most];
    for (int i = 0; i < n; ++i) {
      product[i] = P(0.0);
      for (int j = 0; j < n; ++j) product[i] += matrix[i * n + j] * V[k][j];
    }
    for (int l = 0; l <= k; ++l) {
      P sum(0.0);
      for (int i = 0; i < n; ++i) sum += product[i] * V[l][i];
      T[k * vectors + l] = T[l * vectors + k] = sum;
    }
  }
  diagonalize<vectors>(T, Z, vectors, 1e-6, 6);
  P lowest(0.0);
  for (int k = 0; k < vectors; ++k) lowest = math::min(lowest, T[k * vectors + k]);
  // The least of Ritz' values is above lambda_min: a little lower may be below it.
  const P below = P(1.04) * lowest;
  const auto proven = definite(-below) & ~already & factored;
  part.least = select(proven & (below > part.least), below, part.least);
  for (int k = 0; k < vectors; ++k) {
    const P value = T[k * vectors + k];
    const P taken = select((value < P(0.0)) & factored & ~already, value, P(0.0));
    part.square += taken * taken;
    if (!anyOf(taken < P(0.0))) continue;
    P v[most];
    for (int i = 0; i < n; ++i) {
      v[i] = P(0.0);
      for (int l = 0; l < vectors; ++l) v[i] += Z[k * vectors + l] * V[l][i];
    }
    for (int i = 0; i < n; ++i) {
      const P weight = taken * v[i];
      for (int j = 0; j < n; ++j) matrix[i * n + j] -= weight * v[j];
    }
  }
  return part;
}

}  // namespace ringwatch
