#pragma once
#include <ringwatch/base/matrix3.h>

namespace ringwatch {

/// The 3×3 blocks w g_a (∂P/∂F) g_b of a tangent for a law whose linearization offers nothing but the product
/// dP = (∂P/∂F) dF: it is taken column by column. Laws that know their tangent better offer `nodeBlocks(weight)` of
/// their own, with the same two functions, which is several times faster.
template <class S>
struct ModulusBlocks {
  struct Node {
    S g[3];  // ∂N_a/∂X
  };
  Matrix3<S> column[9];  // ∂P/∂F_jK · w at 3·j + K

  template <class Linearization>
  RINGWATCH_INLINE ModulusBlocks(const Linearization& linearization, const S& weight) {
    RINGWATCH_UNROLL
    for (int c = 0; c < 9; ++c) {
      Matrix3<S> unit = Matrix3<S>::zero();
      unit.m[c] = S(1);
      column[c] = weight * linearization(unit);
    }
  }
  RINGWATCH_INLINE Node node(const S (&g)[3]) const { return {{g[0], g[1], g[2]}}; }
  RINGWATCH_INLINE Matrix3<S> operator()(const Node& a, const Node& b) const {
    Matrix3<S> block;
    RINGWATCH_UNROLL
    for (int j = 0; j < 3; ++j) {
      RINGWATCH_UNROLL
      for (int i = 0; i < 3; ++i) {
        S sum(0);
        RINGWATCH_UNROLL
        for (int k = 0; k < 3; ++k)
          sum += a.g[k] *
                 (column[3 * j](i, k) * b.g[0] + column[3 * j + 1](i, k) * b.g[1] + column[3 * j + 2](i, k) * b.g[2]);
        block(i, j) = sum;
      }
    }
    return block;
  }
};

/// The blocks of a linearization at a point of weight w, its own where it has some.
template <class S, class Linearization>
RINGWATCH_INLINE auto nodeBlocksOf(const Linearization& linearization, const S& weight) {
  if constexpr (requires { linearization.nodeBlocks(weight); })
    return linearization.nodeBlocks(weight);
  else
    return ModulusBlocks<S>(linearization, weight);
}

}  // namespace ringwatch
