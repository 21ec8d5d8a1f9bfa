#pragma once
#include <ringwatch/base/rounding.h>
#include <ringwatch/materials/modulus_rounding.h>

namespace ringwatch {

/// What rounding makes of an element's tangent, written once for every kernel scalar: numbers T_a, N/m, of its nodes
/// with
///   |K̂_ab - K_ab| <= √(T_a T_b)
/// for the 3×3 blocks (Frobenius) of K̂ as computed and of K, the tangent in exact arithmetic of the positions,
/// reference positions and constants as the doubles that they are. Theorem 42, docs/theory/floating_point.md.
template <class Element, class S>
class TangentRounding {
 public:
  static constexpr int n = Element::nodes;

  /// edges: |x_a - x_0| in the present state, extent: |X_a - X_0|, both the root of the sum of squares over the nodes.
  RINGWATCH_INLINE TangentRounding(const S& edges, const S& extent) : edges_(edges), extent_(extent) {}

  /// What a deformation gradient at a point errs by. inverseJacobian: its norm; table: that of ∂N/∂ξ.
  RINGWATCH_INLINE S gradientError(const S& inverseJacobian, double table, const Matrix3<S>& F) const {
    if constexpr (Element::constantGradient) {
      return S(simplexGradientRounding * unitRoundoff) * inverseJacobian * edges_;
    } else {
      const S own = math::sqrt(innerProduct(F, F));
      return S(unitRoundoff * table) * inverseJacobian *
             (S(gradientRounding + n) * edges_ + S(gradientRounding) * extent_ * own);
    }
  }
  /// Adds a point: its law's rounding, the norm of J⁻¹, that of ∂N/∂ξ, the weight and the shape gradients.
  RINGWATCH_INLINE void addPoint(const ModulusRounding<S>& law, const S& inverseJacobian, double table, const S& weight,
                                 const S (&g)[n][3], S* T) const {
    // Lanes without an element weigh nothing, whatever their law says.
    const S all = S(2.0) * weight * factorOf(law, condition(inverseJacobian, table));
    const S factor = select(weight > S(0.0), all, S(0.0));
    RINGWATCH_UNROLL
    for (int a = 0; a < n; ++a) T[a] += factor * squareOf(g[a]);
  }
  /// |g|² + 1/|X|². Of a linear tetrahedron |g_a| >= 1/|X|, since g_a (X_a - X_b) = 1: 2 |g|² is no less.
  RINGWATCH_INLINE S squareOf(const S (&g)[3]) const {
    const S own = g[0] * g[0] + g[1] * g[1] + g[2] * g[2];
    if constexpr (Element::constantGradient)
      return own + own;
    else
      return own + S(1.0) / (extent_ * extent_);
  }
  /// Of K̂'s own arithmetic and of the shape gradients, in the norm of the law's tangent.
  RINGWATCH_INLINE static S factorOf(const ModulusRounding<S>& law, const S& condition) {
    constexpr double shape = Element::constantGradient ? simplexShapeRounding : shapeRounding;
    return law.error + (S(shape * unitRoundoff) * condition + S(productRounding * unitRoundoff)) * law.size;
  }
  RINGWATCH_INLINE S condition(const S& inverseJacobian, double table) const {
    return S(scaleOf(table)) * inverseJacobian * extent_;
  }

 private:
  RINGWATCH_INLINE static constexpr double scaleOf(double table) { return Element::constantGradient ? 1.0 : table; }

  S edges_, extent_;
};

}  // namespace ringwatch
