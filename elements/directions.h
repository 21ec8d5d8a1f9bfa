#pragma once
#include <algorithm>
#include <array>
#include <cstddef>

#include <ringwatch/base/matrix3.h>
#include <ringwatch/elements/quadrature.h>

namespace ringwatch {

/// The operators of elements that are products of shapes, at the points of a product rule, one direction after the
/// other (sum factorisation; Orszag 1980, J. Comput. Phys. 37:70): a derivative along a direction is the same at all
/// points that differ in it alone, and is interpolated across the others in steps. An element that has such operators
/// names them `Directions`:
/// - `points`, of the rule that they are for, in order;
/// - `Field<S>(u)` gives Σ_a u_a ⊗ ∂N_a/∂ξ of a nodal field at each point, as ElementOperators::naturalGradient does;
/// - `Forces<S>` adds stresses T_q at the points up and stores Σ_q T_q ∂N_a/∂ξ at the nodes: the transpose.
/// S is a kernel's scalar. Weights of interpolation are positive, so that no rounding is larger than that of the sums
/// over nodes (Theorem 42, docs/theory/floating_point.md).
template <class Directions>
bool haveDirections(const QuadratureRule& rule) {
  return std::ranges::equal(rule.points, Directions::points, [](const QuadraturePoint& a, const QuadraturePoint& b) {
    return std::ranges::equal(a.xi, b.xi);
  });
}

/// Weights of the nearer and the farther end of a line at either point of the two-point rule.
inline constexpr double nearWeight = (1 + gauss::p2) / 2, farWeight = (1 - gauss::p2) / 2;

/// Sets every number of any arrays of arrays to zero.
template <class S, std::size_t lines>
RINGWATCH_INLINE void clearLines(S (&sum)[lines][3]) {
  for (auto& line : sum)
    for (S& component : line) component = S(0.0);
}

/// Trilinear hexahedra at the 2×2×2 points: 12 derivatives instead of 24.
template <class Element>
struct TrilinearDirections {
  static constexpr auto points = gaussCube(gauss::x2, gauss::w2);

  /// The node at a corner: bit j of the corner tells the side along ξ_j.
  static constexpr std::array<int, 8> nodeAt = [] {
    std::array<int, 8> nodes{};
    for (int a = 0; a < Element::nodes; ++a) {
      int corner = 0;
      for (int j = 0; j < 3; ++j) corner |= (Element::referenceNodes[a][j] > 0 ? 1 : 0) << j;
      nodes[corner] = a;
    }
    return nodes;
  }();
  /// The line along ξ_j through a point or corner: its sides along the two other directions.
  RINGWATCH_HOST_DEVICE static constexpr int lineOf(int j, int corner) {
    return j == 0 ? corner >> 1 : j == 1 ? (corner & 1) | (corner >> 2 << 1) : corner & 3;
  }
  /// The corner at the lower end of a line.
  RINGWATCH_HOST_DEVICE static constexpr int lowerEnd(int j, int line) {
    return j == 0 ? line << 1 : j == 1 ? (line & 1) | (line >> 1 << 2) : line;
  }
  /// From lines through corners to those through points, or its transpose, which is the same; and the 1/2 of ±1/2, the
  /// slope along the line.
  template <class S>
  RINGWATCH_INLINE static void interpolate(S (&of)[4]) {
    constexpr double near = nearWeight, far = farWeight;
    const S a = S(near) * of[0] + S(far) * of[1], b = S(far) * of[0] + S(near) * of[1];
    const S c = S(near) * of[2] + S(far) * of[3], d = S(far) * of[2] + S(near) * of[3];
    of[0] = S(near / 2) * a + S(far / 2) * c;
    of[1] = S(near / 2) * b + S(far / 2) * d;
    of[2] = S(far / 2) * a + S(near / 2) * c;
    of[3] = S(far / 2) * b + S(near / 2) * d;
  }

  template <class S>
  class Field {
   public:
    RINGWATCH_INLINE explicit Field(const S (&u)[8][3]) {
      RINGWATCH_UNROLL
      for (int j = 0; j < 3; ++j) {
        RINGWATCH_UNROLL
        for (int i = 0; i < 3; ++i) {
          S along[4];
          RINGWATCH_UNROLL
          for (int line = 0; line < 4; ++line) {
            const int lower = lowerEnd(j, line);
            along[line] = u[nodeAt[lower | 1 << j]][i] - u[nodeAt[lower]][i];
          }
          interpolate(along);
          RINGWATCH_UNROLL
          for (int line = 0; line < 4; ++line) derivative_[j][line][i] = along[line];
        }
      }
    }
    RINGWATCH_INLINE Matrix3<S> operator()(int q) const {
      Matrix3<S> D;
      RINGWATCH_UNROLL
      for (int j = 0; j < 3; ++j) {
        RINGWATCH_UNROLL
        for (int i = 0; i < 3; ++i) D(i, j) = derivative_[j][lineOf(j, q)][i];
      }
      return D;
    }

   private:
    S derivative_[3][4][3];
  };

  template <class S>
  class Forces {
   public:
    RINGWATCH_INLINE Forces() {
      for (auto& direction : sum_) clearLines(direction);
    }
    RINGWATCH_INLINE void add(int q, const Matrix3<S>& T) {
      RINGWATCH_UNROLL
      for (int j = 0; j < 3; ++j) {
        RINGWATCH_UNROLL
        for (int i = 0; i < 3; ++i) sum_[j][lineOf(j, q)][i] += T(i, j);
      }
    }
    RINGWATCH_INLINE void store(S (&force)[8][3]) const {
      RINGWATCH_UNROLL
      for (int i = 0; i < 3; ++i) {
        RINGWATCH_UNROLL
        for (int j = 0; j < 3; ++j) {
          S along[4];
          RINGWATCH_UNROLL
          for (int line = 0; line < 4; ++line) along[line] = sum_[j][line][i];
          interpolate(along);
          RINGWATCH_UNROLL
          for (int line = 0; line < 4; ++line) {
            const int lower = nodeAt[lowerEnd(j, line)], upper = nodeAt[lowerEnd(j, line) | 1 << j];
            force[lower][i] = j == 0 ? -along[line] : force[lower][i] - along[line];
            force[upper][i] = j == 0 ? along[line] : force[upper][i] + along[line];
          }
        }
      }
    }

   private:
    S sum_[3][4][3];
  };
};

/// Six-node wedges at three points on the triangle by two along the axis: three derivatives along the axis instead of
/// six, and two of each of the others.
struct WedgeDirections {
  /// Triangle: the three inner points of degree 2 (Strang & Fix 1973, table 4.1), the first fastest.
  static constexpr std::array<QuadraturePoint, 6> points{{{{1.0 / 6, 1.0 / 6, -gauss::p2}, 1.0 / 6},
                                                          {{2.0 / 3, 1.0 / 6, -gauss::p2}, 1.0 / 6},
                                                          {{1.0 / 6, 2.0 / 3, -gauss::p2}, 1.0 / 6},
                                                          {{1.0 / 6, 1.0 / 6, gauss::p2}, 1.0 / 6},
                                                          {{2.0 / 3, 1.0 / 6, gauss::p2}, 1.0 / 6},
                                                          {{1.0 / 6, 2.0 / 3, gauss::p2}, 1.0 / 6}}};
  /// Area coordinates of the points are 2/3 of their own corner and 1/6 of the others, that is 1/2 of their own and 1/6
  /// of all; and the slope along the axis is ±1/2.
  static constexpr double ofAll = 1.0 / 12, ofOwn = 1.0 / 4;

  template <class S>
  class Field {
   public:
    RINGWATCH_INLINE explicit Field(const S (&u)[6][3]) {
      RINGWATCH_UNROLL
      for (int i = 0; i < 3; ++i) {
        S axis[3];
        RINGWATCH_UNROLL
        for (int a = 0; a < 3; ++a) axis[a] = u[a + 3][i] - u[a][i];
        const S all = S(ofAll) * (axis[0] + axis[1] + axis[2]);
        RINGWATCH_UNROLL
        for (int a = 0; a < 3; ++a) axis_[a][i] = all + S(ofOwn) * axis[a];
        RINGWATCH_UNROLL
        for (int j = 0; j < 2; ++j) {
          const S low = u[j + 1][i] - u[0][i], high = u[j + 4][i] - u[3][i];
          plane_[2 * j][i] = S(nearWeight) * low + S(farWeight) * high;
          plane_[2 * j + 1][i] = S(farWeight) * low + S(nearWeight) * high;
        }
      }
    }
    RINGWATCH_INLINE Matrix3<S> operator()(int q) const {
      const int level = q / 3;
      Matrix3<S> D;
      RINGWATCH_UNROLL
      for (int i = 0; i < 3; ++i) {
        D(i, 0) = plane_[level][i];
        D(i, 1) = plane_[2 + level][i];
        D(i, 2) = axis_[q - 3 * level][i];
      }
      return D;
    }

   private:
    S axis_[3][3], plane_[4][3];
  };

  template <class S>
  class Forces {
   public:
    RINGWATCH_INLINE Forces() {
      clearLines(axis_);
      clearLines(plane_);
    }
    RINGWATCH_INLINE void add(int q, const Matrix3<S>& T) {
      const int level = q / 3;
      RINGWATCH_UNROLL
      for (int i = 0; i < 3; ++i) {
        plane_[level][i] += T(i, 0);
        plane_[2 + level][i] += T(i, 1);
        axis_[q - 3 * level][i] += T(i, 2);
      }
    }
    RINGWATCH_INLINE void store(S (&force)[6][3]) const {
      RINGWATCH_UNROLL
      for (int i = 0; i < 3; ++i) {
        const S all = S(ofAll) * (axis_[0][i] + axis_[1][i] + axis_[2][i]);
        RINGWATCH_UNROLL
        for (int a = 0; a < 3; ++a) {
          force[a + 3][i] = all + S(ofOwn) * axis_[a][i];
          force[a][i] = -force[a + 3][i];
        }
        RINGWATCH_UNROLL
        for (int j = 0; j < 2; ++j) {
          const S low = S(nearWeight) * plane_[2 * j][i] + S(farWeight) * plane_[2 * j + 1][i];
          const S high = S(farWeight) * plane_[2 * j][i] + S(nearWeight) * plane_[2 * j + 1][i];
          force[j + 1][i] += low;
          force[0][i] -= low;
          force[j + 4][i] += high;
          force[3][i] -= high;
        }
      }
    }

   private:
    S axis_[3][3], plane_[4][3];
  };
};

}  // namespace ringwatch
