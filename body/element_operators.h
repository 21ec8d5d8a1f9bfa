#pragma once
#include <limits>
#include <type_traits>

#include <ringwatch/base/matrix3.h>
#include <ringwatch/materials/modulus_blocks.h>
#include <ringwatch/materials/tangent_drift.h>

namespace ringwatch {

/// The operators of one element, written once for every kernel scalar S: a SIMD pack (a lane an element) on a CPU, a
/// number (a thread an element) on a GPU. With natural coordinates ξ, reference positions X and the Jacobian J = ∂X/∂ξ,
/// a nodal field u has the gradient ∂u/∂X = (Σ_a u_a ⊗ ∂N_a/∂ξ) J⁻¹. `dN` is any table with dN[a][j] = ∂N_a/∂ξ_j at a
/// point; elements of constant gradient are linear tetrahedra, which do not read it.
template <class Element, class S>
struct ElementOperators {
  static constexpr int n = Element::nodes;
  static constexpr int size = 3 * n;  // of a tangent
  static_assert(!Element::constantGradient || n == 4);

  /// Σ_a (u_a - u_0) ⊗ ∂N_a/∂ξ, edge(a, i) component i of u_a - u_0 for a >= 1. Gradients need differences only, and
  /// far from the origin sums of large coordinates would lose the element's size.
  template <class Edge, class Table>
  RINGWATCH_INLINE static Matrix3<S> naturalGradient(const Edge& edge, const Table& dN) {
    Matrix3<S> D;
    if constexpr (Element::constantGradient) {
      RINGWATCH_UNROLL
      for (int i = 0; i < 3; ++i) {
        RINGWATCH_UNROLL
        for (int j = 0; j < 3; ++j) D(i, j) = edge(j + 1, i);
      }
    } else {
      RINGWATCH_UNROLL
      for (int i = 0; i < 3; ++i) {
        const S first = edge(1, i);
        RINGWATCH_UNROLL
        for (int j = 0; j < 3; ++j) D(i, j) = first * S(dN[1][j]);
      }
      RINGWATCH_UNROLL
      for (int a = 2; a < n; ++a) {
        RINGWATCH_UNROLL
        for (int i = 0; i < 3; ++i) {
          const S u = edge(a, i);
          RINGWATCH_UNROLL
          for (int j = 0; j < 3; ++j) D(i, j) += u * S(dN[a][j]);
        }
      }
    }
    return D;
  }

  /// f_a += T ∂N_a/∂ξ: with T = w det(J) P J⁻ᵀ the nodal forces of the stress P at a point of weight w.
  template <class Table>
  RINGWATCH_INLINE static void addForces(const Matrix3<S>& T, const Table& dN, S (&force)[n][3]) {
    RINGWATCH_UNROLL
    for (int i = 0; i < 3; ++i) {
      if constexpr (Element::constantGradient) {
        force[0][i] -= T(i, 0) + T(i, 1) + T(i, 2);
        RINGWATCH_UNROLL
        for (int j = 0; j < 3; ++j) force[j + 1][i] += T(i, j);
      } else {
        RINGWATCH_UNROLL
        for (int a = 0; a < n; ++a) {
          RINGWATCH_UNROLL
          for (int j = 0; j < 3; ++j) force[a][i] += T(i, j) * S(dN[a][j]);
        }
      }
    }
  }

  /// g_a = J⁻ᵀ ∂N_a/∂ξ, the gradients ∂N_a/∂X.
  template <class Table>
  RINGWATCH_INLINE static void shapeGradients(const Matrix3<S>& inverseJacobian, const Table& dN, S (&g)[n][3]) {
    RINGWATCH_UNROLL
    for (int j = 0; j < 3; ++j) {
      if constexpr (Element::constantGradient) {
        RINGWATCH_UNROLL
        for (int a = 1; a < n; ++a) g[a][j] = inverseJacobian(a - 1, j);
        g[0][j] = -(inverseJacobian(0, j) + inverseJacobian(1, j) + inverseJacobian(2, j));
      } else {
        RINGWATCH_UNROLL
        for (int a = 0; a < n; ++a)
          g[a][j] = S(dN[a][0]) * inverseJacobian(0, j) + S(dN[a][1]) * inverseJacobian(1, j) +
                    S(dN[a][2]) * inverseJacobian(2, j);
      }
    }
  }

  /// The part of a point with weight w (det J included) in the tangent, Σ w g_a (∂P/∂F) g_b: calls add(row, column,
  /// value) for the 3×3 blocks of nodes a <= b, rows and columns 3·node + component.
  template <class Linearization, class Add>
  RINGWATCH_INLINE static void addTangent(const Linearization& linearization, const S& weight, const S (&g)[n][3],
                                          const Add& add) {
    const auto blocks = nodeBlocksOf(linearization, weight);
    typename std::remove_const_t<decltype(blocks)>::Node node[n];
    RINGWATCH_UNROLL
    for (int a = 0; a < n; ++a) node[a] = blocks.node(g[a]);
    RINGWATCH_UNROLL
    for (int a = 0; a < n; ++a) {
      RINGWATCH_UNROLL
      for (int b = a; b < n; ++b) {
        const Matrix3<S> block = blocks(node[a], node[b]);
        RINGWATCH_UNROLL
        for (int i = 0; i < 9; ++i) add(3 * a + i / 3, 3 * b + i % 3, block.m[i]);
      }
    }
  }

  /// The part of a point in Σ w ∇N_a · ∇N_b: calls add(a, b, value) for a >= b.
  template <class Add>
  RINGWATCH_INLINE static void addLaplacian(const S& weight, const S (&g)[n][3], const Add& add) {
    RINGWATCH_UNROLL
    for (int a = 0; a < n; ++a) {
      RINGWATCH_UNROLL
      for (int b = 0; b <= a; ++b) add(a, b, weight * (g[a][0] * g[b][0] + g[a][1] * g[b][1] + g[a][2] * g[b][2]));
    }
  }
};

/// How fast an element's highest eigenvalue can grow when its deformation gradients move away from F0. With l the
/// largest eigenvalue of D⁻¹K_e at F0, b >= lambda_max(D⁻¹ Σ_q w_q B_qᵀB_q), and |F_q - F0_q| <= δ <= radius for all q:
///   l(F) <= l + (2 √((l + b negative) kappa b) + b linear) δ + b (kappa + quadratic) δ²:
/// Theorem 16, docs/theory/incremental_certificate.md. How points and a mean combine: Theorem 22,
/// docs/theory/tangent_drift.md.
template <class S>
struct TangentDriftOf {
  TangentDriftCoefficients<S> law{S(0), S(0), S(0), S(0),
                                  S(std::numeric_limits<double>::infinity())};  // largest of the points'
  S determinant = S(std::numeric_limits<double>::infinity());                   // least det F0
  /// No F_q inverts while |F_q - F0_q| is smaller; 0 when one is inverted. Theorem 18,
  /// docs/theory/incremental_certificate.md.
  S inversionDistance = S(std::numeric_limits<double>::infinity());
  /// What F_q, as computed, and a later one in the ball together err by, for what is proven inside a ball.
  S gradientRounding = S(0);

  /// Adds a quadrature point with the deformation gradient F.
  template <class Law>
  RINGWATCH_INLINE void addPoint(const Law& pointLaw, const Matrix3<S>& F) {
    noteDeterminant(F);
    const TangentDriftCoefficients<S> here = pointLaw.drift(F);
    law.kappa = math::max(law.kappa, here.kappa);
    law.linear = math::max(law.linear, here.linear);
    law.quadratic = math::max(law.quadratic, here.quadratic);
    law.negative = math::max(law.negative, here.negative);
    law.radius = math::min(law.radius, here.radius);
  }
  /// Adds the share at the mean deformation gradient F of a rule that has one. The mean of F moves by no more than the
  /// farthest F_q, and V B̄ᵀB̄ ≼ Σ w BᵀB: the bounds of the shares add up.
  template <class Law>
  RINGWATCH_INLINE void addMean(const Law& meanLaw, const Matrix3<S>& F) {
    noteDeterminant(F);
    const TangentDriftCoefficients<S> mean = meanLaw.drift(F);
    law.kappa += mean.kappa;
    law.linear += mean.linear;
    law.quadratic += mean.quadratic;
    law.negative += mean.negative;
    law.radius = math::min(law.radius, mean.radius);
  }

 private:
  RINGWATCH_INLINE void noteDeterminant(const Matrix3<S>& F) {
    // s3 = det F / (s1 s2) >= 2 det F / |F|², and no matrix closer than s3 is singular.
    const S det = ringwatch::determinant(F);
    inversionDistance = math::min(inversionDistance, select(det > S(0), S(2) * det / innerProduct(F, F), S(0)));
    determinant = math::min(determinant, det);
  }
};
using TangentDrift = TangentDriftOf<double>;
/// That of the element in a lane of packs.
template <class P>
TangentDrift laneOf(const TangentDriftOf<P>& all, int lane) {
  TangentDrift r;
  r.law = {all.law.kappa[lane], all.law.linear[lane], all.law.quadratic[lane], all.law.negative[lane],
           all.law.radius[lane]};
  r.determinant = all.determinant[lane];
  r.inversionDistance = all.inversionDistance[lane];
  r.gradientRounding = all.gradientRounding[lane];
  return r;
}

}  // namespace ringwatch
