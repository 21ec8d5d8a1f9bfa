#pragma once
#include <limits>

#include <ringwatch/base/rounding.h>
#include <ringwatch/monitor/small/extreme_eigenvalues.h>
#include <ringwatch/monitor/small/symmetric3.h>

/// The arithmetic of the block nodal bound (nodal_bound.h) for one element, or a pack of them: one source for CPU and
/// CUDA threads.
namespace ringwatch {

/// L of D = L Lᵀ, lower triangle: 00, 11, 22, 21, 20, 10. NaN where D is not positive definite.
template <class P>
struct CholeskyFactor {
  P m[6];
};
template <class P>
RINGWATCH_INLINE CholeskyFactor<P> factorOf(const Symmetric3<P>& D) {
  CholeskyFactor<P> L;
  L.m[0] = math::sqrt(D.m[0]);
  const P i00 = P(1.0) / L.m[0];
  L.m[5] = D.m[5] * i00;
  L.m[4] = D.m[4] * i00;
  L.m[1] = math::sqrt(D.m[1] - L.m[5] * L.m[5]);
  L.m[3] = (D.m[3] - L.m[4] * L.m[5]) * (P(1.0) / L.m[1]);
  L.m[2] = math::sqrt(D.m[2] - L.m[4] * L.m[4] - L.m[3] * L.m[3]);
  return L;
}
template <class P>
RINGWATCH_INLINE Symmetric3<P> productOf(const CholeskyFactor<P>& L) {
  return {{L.m[0] * L.m[0], L.m[5] * L.m[5] + L.m[1] * L.m[1], L.m[4] * L.m[4] + L.m[3] * L.m[3] + L.m[2] * L.m[2],
           L.m[5] * L.m[4] + L.m[1] * L.m[3], L.m[0] * L.m[4], L.m[0] * L.m[5]}};
}
/// L⁻¹, lower triangle: 00, 10, 11, 20, 21, 22.
template <class P>
RINGWATCH_INLINE void invertFactor(const CholeskyFactor<P>& L, P w[6]) {
  w[0] = P(1.0) / L.m[0];
  w[2] = P(1.0) / L.m[1];
  w[5] = P(1.0) / L.m[2];
  w[1] = -(L.m[5] * w[0]) * w[2];
  w[4] = -(L.m[3] * w[2]) * w[5];
  w[3] = -(L.m[4] * w[0] + L.m[3] * w[1]) * w[5];
}

template <class P>
RINGWATCH_INLINE Symmetric3<P> inverse(const Symmetric3<P>& a) {
  Symmetric3<P> c;
  c.m[0] = a.m[1] * a.m[2] - a.m[3] * a.m[3];
  c.m[1] = a.m[0] * a.m[2] - a.m[4] * a.m[4];
  c.m[2] = a.m[0] * a.m[1] - a.m[5] * a.m[5];
  c.m[3] = a.m[4] * a.m[5] - a.m[0] * a.m[3];
  c.m[4] = a.m[5] * a.m[3] - a.m[1] * a.m[4];
  c.m[5] = a.m[3] * a.m[4] - a.m[2] * a.m[5];
  return (P(1.0) / (a.m[0] * c.m[0] + a.m[5] * c.m[5] + a.m[4] * c.m[4])) * c;
}

/// (A + ε)^½ of a sum of squares A, ε a share of its trace.
template <class P>
RINGWATCH_INLINE Symmetric3<P> rootOfSquares(Symmetric3<P> squares, double share) {
  const P floor = P(share) * squares.trace() + P(1e-200);
  for (int c = 0; c < 3; ++c) squares.m[c] += floor;
  return squareRoot(squares);
}
/// Weights to start from. |K_aa| of a diagonal block, so that an indefinite one counts by its size.
template <class P>
RINGWATCH_INLINE Symmetric3<P> sizeOf(const Symmetric3<P>& k) {
  return rootOfSquares(square(k), 1e-4);
}
/// ((K²)_aa)^½: of all blocks of a node's rows. K: both triangles, `size` numbers a row. No direction is below a tenth
/// of the size, so that little is lost when weights of 16 bits are turned with a body.
template <class P>
RINGWATCH_INLINE Symmetric3<P> sizeOfRows(const P* K, int size, int a) {
  const P* rows = K + 3 * a * size;
  Symmetric3<P> squares = Symmetric3<P>::diagonal(P(0.0));
  for (int j = 0; j < size; ++j)
    for (int r = 0; r < 3; ++r)
      for (int c = r; c < 3; ++c) squares(r, c) += rows[r * size + j] * rows[c * size + j];
  return rootOfSquares(squares, 1e-2);
}

/// A floor under every direction, over the trace: positive definite beyond the rounding to single precision.
inline constexpr double weightFloor = 1e-6;
/// And one for nodes that have no stiffness left, where everything is constrained: beyond underflow.
inline constexpr double smallestWeight = 1e-12;

/// Trace 1 over the element.
template <class P>
RINGWATCH_INLINE void normaliseWeights(Symmetric3<P>* weights, int n) {
  P sum(0.0);
  for (int a = 0; a < n; ++a) {
    const P floor = P(weightFloor) * weights[a].trace() + P(1e-200);
    for (int c = 0; c < 3; ++c) weights[a].m[c] += floor;
    sum += weights[a].trace();
  }
  const P scale = P(1.0) / sum;
  for (int a = 0; a < n; ++a) {
    weights[a] = scale * weights[a];
    for (int c = 0; c < 3; ++c) weights[a].m[c] += P(smallestWeight);
  }
}

/// R = (S/t)^-½ of a node, S with ones on the diagonal where constrained; for D ← R D R. Longer steps save a third of
/// the sweeps on good meshes and swing at slivers.
template <class P>
RINGWATCH_INLINE Symmetric3<P> sweepFactor(Symmetric3<P> S) {
  const P floor = P(1e-5) * S.trace() + P(1e-8);
  for (int c = 0; c < 3; ++c) S.m[c] += floor;
  return inverse(squareRoot(S));
}

/// K_ac ← L_a⁻¹ K_ac L_c⁻ᵀ for c <= a, with the inverse factors w of the weights: K's lower triangle, 3n×3n.
template <class P>
RINGWATCH_INLINE void scaleByFactors(const P (*w)[6], int n, P* K) {
  const int size = 3 * n;
  for (int a = 0; a < n; ++a)
    for (int c = 0; c <= a; ++c) {
      P* first = K + (3 * a) * size + 3 * c;
      for (int j = 0; j < 3; ++j) {  // rows
        P& k0 = first[j];
        P& k1 = first[size + j];
        P& k2 = first[2 * size + j];
        k2 = w[a][3] * k0 + w[a][4] * k1 + w[a][5] * k2;
        k1 = w[a][1] * k0 + w[a][2] * k1;
        k0 = w[a][0] * k0;
      }
      for (int i = 0; i < 3; ++i) {  // columns
        P* row = first + i * size;
        row[2] = w[c][3] * row[0] + w[c][4] * row[1] + w[c][5] * row[2];
        row[1] = w[c][1] * row[0] + w[c][2] * row[1];
        row[0] = w[c][0] * row[0];
      }
    }
}

/// What errors of a tangent, |ΔK_ab| <= √(T_a T_b), come to in the scaled matrix L⁻¹ K L⁻ᵀ: Σ_a |L_a⁻¹|² T_a, with the
/// inverse factors w of the weights and the sizes of what they are summed from. free: 1, or 0 for a component that is
/// constrained, of which nothing is left in the matrix. Theorem 42, docs/theory/floating_point.md.
template <class P>
RINGWATCH_INLINE P scaledRounding(const CholeskyFactor<P>& L, const P (&w)[6], const P& T, const P* free) {
  const P w3 = (math::abs(L.m[4]) * w[0] + math::abs(L.m[3] * w[1])) * w[5];
  const P norm2 =
      free[0] * (w[0] * w[0] + w[1] * w[1] + w3 * w3) + free[1] * (w[2] * w[2] + w[4] * w[4]) + free[2] * (w[5] * w[5]);
  return select((T > P(0.0)) & (norm2 > P(0.0)), norm2 * T, P(0.0));
}

/// max(0, largest eigenvalue), rounded up: by the eigenvalue's own rounding and by what the matrix errs by. NaN stays:
/// it must not pass for zero.
template <class P>
RINGWATCH_INLINE P largestRoundedUp(P* K, int size, P* work, const P& rounding) {
  const auto extremes = extremeEigenvalues(K, size, work, false);
  const P l = extremes.largest + P(eigenvalueRounding) * extremes.scale + rounding;
  return select(l < P(0.0), P(0.0), l);
}

}  // namespace ringwatch
