#pragma once
#include <ringwatch/base/matrix3.h>
#include <ringwatch/elements/directions.h>

namespace ringwatch {

/// Coefficients of hourglass control (Flanagan & Belytschko 1981, Int. J. Numer. Meth. Engng 17:679).
struct HourglassControl {
  /// κ: hourglass modes of a parallelepiped have the stiffness κ/2 M V Σ_a |g_a|², M the modulus of pressure waves; the
  /// uniform strains have at most M V Σ_a |g_a|². 0.05 is the usual default of explicit codes.
  double stiffness = 0.05;
};

/// The uniform strain hexahedron: trilinear shapes, evaluated once at the mean gradients g_a = 1/V ∫ ∂N_a/∂X dV, and
/// hourglass control. With the hourglass base vectors Γ_α, the signs of ηζ, ξζ, ξη and ξηζ at the nodes, and
/// s_α = Σ_a Γ_αa X_a, the hourglass vectors and coordinates are
///   γ_αa = Γ_αa - s_α·g_a,   q_α = Σ_a γ_αa x_a = Σ_a Γ_αa x_a - F̄ s_α,   F̄ = Σ_a x_a ⊗ g_a.
/// γ_α vanishes on all linear fields, so that q_α does in every uniform deformation. The energy V W(F̄) + ½ k Σ_α |q_α|²
/// has the forces f_a = (V P(F̄) - k Σ_α q_α ⊗ s_α) g_a + k Σ_α Γ_αa q_α. Theorem 71, docs/theory/hourglass.md.
///
/// Nodal fields go by their modes u_m = Σ_a ±u_a, the sign that of Π ξ_j over the bits j of m at the node (a
/// Walsh-Hadamard transform): the constant one is 0, linear ones 1, 2 and 4, hourglass modes 3, 5, 6 and 7. With
/// g_a = Σ_m ±G_m, F̄ = Σ_m u_m ⊗ G_m; G_0 and G_7 are zero for every shape. S is a kernel's scalar.
template <class Element>
struct HourglassModes {
  static constexpr int modes = 8, count = 4;
  /// The hourglass modes, in the order of s and q.
  static constexpr std::array<int, count> hourglass{3, 5, 6, 7};
  /// The sign of a mode at a node.
  RINGWATCH_HOST_DEVICE static constexpr int sign(int mode, int node) {
    int sign = 1;
    for (int j = 0; j < 3; ++j)
      if ((mode >> j & 1) != 0 && Element::referenceNodes[node][j] < 0) sign = -sign;
    return sign;
  }

  /// What is stored of an element. G[m - 1] of mode m, 1/m; s of the hourglass modes, m; the volume, m³, and the
  /// stiffness k of hourglass modes, N/m: both zero in lanes without an element.
  template <class S>
  struct Geometry {
    S G[6][3], s[count][3], volume, stiffness;
  };

  /// Modes of a component of a nodal field, or the field from its modes: between corners, which are sides along ξ_j by
  /// bit, and modes.
  template <class S>
  RINGWATCH_INLINE static void transform(S (&u)[modes]) {
    RINGWATCH_UNROLL
    for (int j = 0; j < 3; ++j) {
      RINGWATCH_UNROLL
      for (int low = 0; low < modes; ++low) {
        if ((low >> j & 1) != 0) continue;
        const S lower = u[low], upper = u[low | 1 << j];
        u[low] = lower + upper;
        u[low | 1 << j] = upper - lower;
      }
    }
  }
  /// To modes of a component of nodal values, and nodal values from modes.
  template <class S>
  RINGWATCH_INLINE static void toModes(const S (&nodal)[8][3], int component, S (&mode)[modes]) {
    RINGWATCH_UNROLL
    for (int corner = 0; corner < modes; ++corner) mode[corner] = nodal[Corners::nodeAt[corner]][component];
    transform(mode);
  }
  /// The transpose of toModes: Σ_m ±f_m at the nodes.
  template <class S>
  RINGWATCH_INLINE static void toNodes(S (&mode)[modes], int component, S (&nodal)[8][3]) {
    // The matrix of signs: transposed it goes the other way along every direction.
    RINGWATCH_UNROLL
    for (int j = 0; j < 3; ++j) {
      RINGWATCH_UNROLL
      for (int low = 0; low < modes; ++low) {
        if ((low >> j & 1) != 0) continue;
        const S even = mode[low], odd = mode[low | 1 << j];
        mode[low] = even - odd;
        mode[low | 1 << j] = even + odd;
      }
    }
    RINGWATCH_UNROLL
    for (int corner = 0; corner < modes; ++corner) nodal[Corners::nodeAt[corner]][component] = mode[corner];
  }

  /// V/8 of a hexahedron and its derivatives G[m - 1] by c_m: closed forms of the modes c_m of X(ξ) = Σ c_m Π ξ_j,
  /// V = 8 [c1 c2 c4] + 8/3 ([c1 c3 c5] + [c5 c6 c4] + [c3 c2 c6]).
  template <class S>
  RINGWATCH_INLINE static void volume(const S (&c)[modes][3], S& eighth, S (&G)[6][3]) {
    // A cross product of two linear modes and two of hourglass modes, or two mixed ones.
    const S third = S(1.0) / S(3.0);
    const auto linear = [&](int m, int a, int b, int k, int l) {
      for (int i = 0; i < 3; ++i) G[m - 1][i] = cross(c[a], c[b], i) + third * cross(c[k], c[l], i);
    };
    linear(1, 2, 4, 3, 5);
    linear(2, 4, 1, 6, 3);
    linear(4, 1, 2, 5, 6);
    const auto mixed = [&](int m, int a, int b, int k, int l) {
      for (int i = 0; i < 3; ++i) G[m - 1][i] = third * (cross(c[a], c[b], i) + cross(c[k], c[l], i));
    };
    mixed(3, 5, 1, 2, 6);
    mixed(5, 1, 3, 6, 4);
    mixed(6, 4, 5, 3, 2);
    eighth = S(0.0);
    for (int i = 0; i < 3; ++i)
      eighth +=
          c[1][i] * cross(c[2], c[4], i) +
          third * (c[1][i] * cross(c[3], c[5], i) + c[4][i] * cross(c[5], c[6], i) + c[2][i] * cross(c[6], c[3], i));
  }
  /// The volume of a hexahedron and its derivatives by the nodes, of their positions less that of the first.
  template <class S>
  RINGWATCH_INLINE static void volumeGradient(const S (&x)[8][3], S& volumeHere, S (&w)[8][3]) {
    S c[modes][3], of[modes], G[6][3];
    RINGWATCH_UNROLL
    for (int i = 0; i < 3; ++i) {
      toModes(x, i, of);
      RINGWATCH_UNROLL
      for (int m = 0; m < modes; ++m) c[m][i] = of[m];
    }
    volume(c, volumeHere, G);
    // These modes are 8 c_m, V is cubic in them, and ∂c_m/∂x_a = ±1/8.
    const S scale(1.0 / 64);
    volumeHere = scale * volumeHere;
    RINGWATCH_UNROLL
    for (int i = 0; i < 3; ++i) {
      of[0] = of[7] = S(0.0);
      RINGWATCH_UNROLL
      for (int m = 1; m <= 6; ++m) of[m] = scale * G[m - 1][i];
      toNodes(of, i, w);
    }
  }

  /// The geometry of an element at rest from the nodes' positions less that of the first; stiffness: κ M / 2 with the
  /// modulus M of pressure waves, Pa.
  template <class S>
  RINGWATCH_INLINE static void atRest(const S (&X)[8][3], const S& stiffness, Geometry<S>& out) {
    S c[modes][3], of[modes];
    for (int i = 0; i < 3; ++i) {
      toModes(X, i, of);
      for (int h = 0; h < count; ++h) out.s[h][i] = of[hourglass[h]];
      for (int m = 0; m < modes; ++m) c[m][i] = S(0.125) * of[m];
    }
    S eighth;
    volume(c, eighth, out.G);
    // g_a = ∂V/∂X_a / V, and ∂c_m/∂X_a = ±1/8.
    out.volume = S(8.0) * eighth;
    const S inverse = S(0.125) / eighth;
    S square(0.0);  // Σ_a |g_a|² = 8 Σ_m |G_m|²
    for (auto& row : out.G)
      for (S& entry : row) {
        entry = inverse * entry;
        square += entry * entry;
      }
    // k = κ/2 M V Σ_a |g_a|² / 8, the 8 of |Γ_α|².
    out.stiffness = stiffness * out.volume * square;
  }

  /// Row i of F̄ and component i of q_α, of the modes of component i of the positions.
  template <class S>
  RINGWATCH_INLINE static void deformation(const Geometry<S>& at, const S (&mode)[modes], S (&row)[3], S (&q)[count]) {
    RINGWATCH_UNROLL
    for (int j = 0; j < 3; ++j) {
      row[j] = mode[1] * at.G[0][j];
      RINGWATCH_UNROLL
      for (int m = 2; m <= 6; ++m) row[j] += mode[m] * at.G[m - 1][j];
    }
    RINGWATCH_UNROLL
    for (int h = 0; h < count; ++h)
      q[h] = mode[hourglass[h]] - (row[0] * at.s[h][0] + row[1] * at.s[h][1] + row[2] * at.s[h][2]);
  }
  /// Modes of component i of the forces, of row i of V P and component i of k q_α; the row is left less Σ k q_α ⊗ s_α.
  template <class S>
  RINGWATCH_INLINE static void forces(const Geometry<S>& at, S (&row)[3], const S (&kq)[count], S (&mode)[modes]) {
    RINGWATCH_UNROLL
    for (int h = 0; h < count; ++h) {
      RINGWATCH_UNROLL
      for (int j = 0; j < 3; ++j) row[j] -= kq[h] * at.s[h][j];
    }
    mode[0] = S(0.0);
    RINGWATCH_UNROLL
    for (int m = 1; m <= 6; ++m) mode[m] = row[0] * at.G[m - 1][0] + row[1] * at.G[m - 1][1] + row[2] * at.G[m - 1][2];
    mode[3] += kq[0];
    mode[5] += kq[1];
    mode[6] += kq[2];
    mode[7] = kq[3];
  }
  /// g_a and γ_α of the nodes.
  template <class S>
  RINGWATCH_INLINE static void vectors(const Geometry<S>& at, S (&g)[8][3], S (&gamma)[count][8]) {
    for (int a = 0; a < 8; ++a) {
      for (int j = 0; j < 3; ++j) {
        g[a][j] = S(0.0);
        for (int m = 1; m <= 6; ++m) g[a][j] += S(sign(m, a)) * at.G[m - 1][j];
      }
      for (int h = 0; h < count; ++h)
        gamma[h][a] = S(sign(hourglass[h], a)) - (at.s[h][0] * g[a][0] + at.s[h][1] * g[a][1] + at.s[h][2] * g[a][2]);
    }
  }

 private:
  using Corners = TrilinearDirections<Element>;
  template <class S>
  RINGWATCH_INLINE static S cross(const S (&a)[3], const S (&b)[3], int i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    return a[j] * b[k] - a[k] * b[j];
  }
};

}  // namespace ringwatch
