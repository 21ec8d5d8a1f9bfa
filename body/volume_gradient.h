#pragma once
#include <concepts>

#include <ringwatch/base/matrix3.h>
#include <ringwatch/elements/registry.h>

/// Volumes of elements as they are deformed and their derivatives w by the positions of the nodes, m², in closed form.
/// S: a kernel's scalar; x: edges from the first node. What they err by: Theorem 60, docs/theory/element_damping.md.
namespace ringwatch {

/// Elements whose volume has a closed form here: all rules of hexahedra integrate it exactly.
template <class Element>
inline constexpr bool hasVolumeGradient = Element::constantGradient || std::same_as<Element, Hex8>;

template <class S>
RINGWATCH_INLINE void volumeGradientOfTetrahedron(const S (&x)[4][3], S& volume, S (&w)[4][3]) {
  const Matrix3<S> C = cofactor(
      Matrix3<S>{{x[1][0], x[2][0], x[3][0], x[1][1], x[2][1], x[3][1], x[1][2], x[2][2], x[3][2]}});  // of the edges
  const S sixth(1.0 / 6);
  RINGWATCH_UNROLL
  for (int i = 0; i < 3; ++i) {
    RINGWATCH_UNROLL
    for (int j = 0; j < 3; ++j) w[j + 1][i] = sixth * C(i, j);
    w[0][i] = -(w[1][i] + w[2][i] + w[3][i]);
  }
  volume = x[1][0] * w[1][0] + x[1][1] * w[1][1] + x[1][2] * w[1][2];
}
template <class S>
RINGWATCH_INLINE void volumeGradientOfHexahedron(const S (&x)[8][3], S& volume, S (&w)[8][3]) {
  Hex8::Hourglass::volumeGradient(x, volume, w);
}

}  // namespace ringwatch
