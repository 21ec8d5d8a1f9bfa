#pragma once
#include <cstdint>

#include <ringwatch/base/matrix3.h>
#include <ringwatch/base/pack.h>
#include <ringwatch/body/volume_gradient.h>

namespace ringwatch {

/// Bulk viscosity of the elements of a block (DampingConstants) at the velocities of a pass.
struct BulkViscosity {
  using P = NativePack;
  /// An element below this share of its volume at rest counts with it.
  static constexpr double leastVolumeShare = 0.1;
  /// Numbers stored of an element: volume at rest, m³, and its cube root, m, 0 in lanes without an element.
  static constexpr int sizeCount = 2;

  const P* sizes;            ///< [batch][sizeCount]
  double impedance;          ///< ρ₀ c, kg/(m² s)
  double slowness;           ///< 1/c, s/m
  double linear, quadratic;  ///< b₁, b₂²
  const double* velocities;  ///< rows of the patch

  /// s of the forces s ∂V/∂x, by the volume V, m³, and its rate, m³/s.
  RINGWATCH_INLINE P factor(std::int32_t batch, const P& volume, const P& volumeRate) const {
    const P* own = sizes + static_cast<std::ptrdiff_t>(batch) * sizeCount;
    const P inverse = P(1.0) / math::max(volume, P(leastVolumeShare) * own[0]);
    const P rate = volumeRate * inverse;
    const P coefficient = P(linear) + P(quadratic * slowness) * own[1] * math::max(-rate, P(0.0));
    return P(impedance) * own[0] * own[1] * inverse * rate * coefficient;
  }

  /// What is added to the natural stress T of a linear tetrahedron, whose force on node j + 1 is column j of T: with D
  /// the edges, V = det D / 6 and ∂V/∂D = cof D / 6.
  RINGWATCH_INLINE void addTo(std::int32_t batch, const std::uint16_t* localNodes, const Matrix3<P>& D,
                              Matrix3<P>& T) const {
    const Matrix3<P> C = cofactor(D);
    const P sixth(1.0 / 6);
    P first[3], v[3], rate(0.0);
    loadRows(velocities, localNodes, first);
    RINGWATCH_UNROLL
    for (int j = 0; j < 3; ++j) {
      loadRows(velocities, localNodes + (j + 1) * P::width, v);
      RINGWATCH_UNROLL
      for (int i = 0; i < 3; ++i) rate += C(i, j) * (v[i] - first[i]);
    }
    const P determinant = C(0, 0) * D(0, 0) + C(0, 1) * D(0, 1) + C(0, 2) * D(0, 2);
    const P s = sixth * factor(batch, sixth * determinant, sixth * rate);
    for (int i = 0; i < 9; ++i) T.m[i] += s * C.m[i];
  }

  /// Adds the forces of a hexahedron with these edges to those on its nodes.
  RINGWATCH_INLINE void addTo(std::int32_t batch, const std::uint16_t* localNodes, const P (&edges)[8][3],
                              P (&force)[8][3]) const {
    P w[8][3], volume, first[3], v[3], rate(0.0);
    volumeGradientOfHexahedron(edges, volume, w);
    loadRows(velocities, localNodes, first);
    RINGWATCH_UNROLL
    for (int a = 1; a < 8; ++a) {
      loadRows(velocities, localNodes + a * P::width, v);
      RINGWATCH_UNROLL
      for (int i = 0; i < 3; ++i) rate += w[a][i] * (v[i] - first[i]);
    }
    const P s = factor(batch, volume, rate);
    RINGWATCH_UNROLL
    for (int a = 0; a < 8; ++a) {
      RINGWATCH_UNROLL
      for (int i = 0; i < 3; ++i) force[a][i] += s * w[a][i];
    }
  }
};

}  // namespace ringwatch
