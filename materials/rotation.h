#pragma once
#include <utility>

#include <ringwatch/base/matrix3.h>

namespace ringwatch {

namespace detail {
/// Whether a kernel scalar, or the numbers of a pack, are of single precision.
template <class S>
inline constexpr bool isSingle = [] {
  if constexpr (requires(const S& s) { s[0]; })
    return sizeof(std::declval<const S&>()[0]) == sizeof(float);
  else
    return sizeof(S) == sizeof(float);
}();
}  // namespace detail

/// The rotation closest to F: R in SO(3) that maximises tr(RᵀF), also for inverted F (then the smallest singular value
/// counts negative). Analytic polar decomposition after Kugelstadt, Koschier & Bender 2018 ("Fast corotated FEM using
/// operator splitting"): x = tr(RᵀF) is the largest root of
///   g(x) = x⁴ - 2 I x² - 8 J x + I² - 4 II = 0,   I = tr FᵀF, II = |cof F|², J = det F,
/// and R = ∂x/∂F = ((x² + I) F - 2 F FᵀF + 2 x cof F) / (x³ - I x - 2 J).
/// Newton's method from the upper bound √(3 I) falls monotonically onto the root. Where R is not unique (the two
/// smallest singular values sum to zero: flattened to a line, or reflected) the identity is returned.
template <class S>
RINGWATCH_INLINE Matrix3<S> closestRotation(const Matrix3<S>& F) {
  const Matrix3<S> C = transposeTimes(F, F), cof = cofactor(F);
  const S I = trace(C), II = innerProduct(cof, cof);
  const S J = F.m[0] * cof.m[0] + F.m[1] * cof.m[1] + F.m[2] * cof.m[2];
  const S I2 = I + I, J8 = S(8) * J, c0 = I * I - S(4) * II;
  S x = math::sqrt(S(3) * I);
  // Newton leaves step² g''/(2 g') behind; the last step below squares that once more.
  constexpr double enough = detail::isSingle<S> ? 1e-4 : 1e-8;
  auto going = I >= S(0);  // a lane ends with its own iteration, whatever lies beside it in the pack
  for (int iteration = 0; iteration < 40; ++iteration) {
    const S x2 = x * x, g = ((x2 - I2) * x - J8) * x + c0;
    const S slope = S(4) * (x2 - I) * x - J8;
    // At rest g and slope are exact zeros of rounding; a step that would go up is noise: the root has been reached.
    const auto falling = going & (g > S(0)) & (slope > S(0));
    const S step = select(falling, g / select(falling, slope, S(1)), S(0));
    x -= step;
    going = falling & (step * step * (S(6) * x2 - I2) > S(enough) * x * slope);
    if (!anyOf(going)) break;
  }
  // One more, signed step: brings x to rounding, and a dual number's derivative with it.
  const S slope = S(4) * (x * x - I) * x - J8;
  const auto unique = slope > S(1e-5) * I * x;  // below, rounding spoils R
  x -= select(unique, (((x * x - I2) * x - J8) * x + c0) / select(unique, slope, S(1)), S(0));
  const S denominator = (x * x - I) * x - S(2) * J;
  const S scale = S(1) / select(unique, denominator, S(1));
  const Matrix3<S> R = scale * ((x * x + I) * F - S(2) * (F * C) + (x + x) * cof);
  // A Newton–Schulz step R (3 I - RᵀR)/2 takes the last rounding out of R's orthogonality.
  const Matrix3<S> polished = S(0.5) * (R * (Matrix3<S>::diagonal(S(3)) - transposeTimes(R, R)));
  Matrix3<S> result = Matrix3<S>::identity();
  for (int i = 0; i < 9; ++i) result.m[i] = select(unique, polished.m[i], result.m[i]);
  return result;
}

}  // namespace ringwatch
