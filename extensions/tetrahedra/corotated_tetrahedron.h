#pragma once
#include <ringwatch/base/pack.h>
#include <ringwatch/materials/rotation.h>

namespace ringwatch {

/// A symmetric matrix of its components 00 11 22 12 20 01.
template <class S>
RINGWATCH_INLINE Matrix3<S> symmetric(const S (&s)[6]) {
  return {{s[0], s[5], s[4], s[5], s[1], s[3], s[4], s[3], s[2]}};
}

/// The strain sym(RᵀF) - I, components 00 11 22 12 20 01.
template <class S>
RINGWATCH_INLINE void corotatedStrain(const Matrix3<S>& R, const Matrix3<S>& F, S (&strain)[6]) {
  const Matrix3<S> D = transposeTimes(R, F);
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    strain[i] = D(i, i) - S(1.0);
    strain[i + 3] = S(0.5) * (D(j, k) + D(k, j));
  }
}

/// The rotation closest to F, from one nearby, R, by a step of Newton's method for the largest tr(RᵀF),
///   (tr(U) I - U) w = axial(D), D = RᵀF, U = sym(D),  R ← R cay(w),
/// which leaves an angle of the order |w|³: the terms of third order of tr vanish by symmetry. At most 0.05 rad are
/// turned so; where it is more, or the rotation hardly unique, closestRotation(F).
template <class S>
RINGWATCH_INLINE Matrix3<S> followedRotation(const Matrix3<S>& F, const Matrix3<S>& R) {
  constexpr double most = 0.05;
  const Matrix3<S> D = transposeTimes(R, F);
  const S size = D.m[0] + D.m[4] + D.m[8], half(0.5);
  const S u01 = half * (D.m[1] + D.m[3]), u02 = half * (D.m[2] + D.m[6]), u12 = half * (D.m[5] + D.m[7]);
  const S k0 = D.m[7] - D.m[5], k1 = D.m[2] - D.m[6], k2 = D.m[3] - D.m[1];
  const S a = size - D.m[0], b = size - D.m[4], c = size - D.m[8];  // of tr(U) I - U
  const S c00 = b * c - u12 * u12, c01 = u01 * c + u12 * u02, c02 = u01 * u12 + b * u02, c11 = a * c - u02 * u02,
          c12 = a * u12 + u01 * u02, c22 = a * b - u01 * u01;
  const S det = a * c00 - u01 * c01 - u02 * c02;
  // t = w/2 as det · t, so that one division does.
  const S t0 = half * (c00 * k0 + c01 * k1 + c02 * k2), t1 = half * (c01 * k0 + c11 * k1 + c12 * k2),
          t2 = half * (c02 * k0 + c12 * k1 + c22 * k2);
  const S tt = t0 * t0 + t1 * t1 + t2 * t2, dd = det * det;
  const auto near =
      (a > S(0.0)) & (c22 > S(0.0)) & (det > S(1e-3) * size * size * size) & (tt < S(0.25 * most * most) * dd);
  // cay(w) = I + 2/(1 + |t|²) ([t]× + [t]×²)
  const S scale = S(2.0) / select(near, dd + tt, S(1.0));
  const S s0 = scale * t0, s1 = scale * t1, s2 = scale * t2, d0 = det * s0, d1 = det * s1, d2 = det * s2;
  const S o01 = s0 * t1, o02 = s0 * t2, o12 = s1 * t2, one(1.0);
  const Matrix3<S> Q{{one - s1 * t1 - s2 * t2, o01 - d2, o02 + d1, o01 + d2, one - s0 * t0 - s2 * t2, o12 - d0,
                      o02 - d1, o12 + d0, one - s0 * t0 - s1 * t1}};
  Matrix3<S> turned = R * Q;
  if (allOf(near)) return turned;
  const Matrix3<S> closest = closestRotation(F);
  for (int i = 0; i < 9; ++i) turned.m[i] = select(near, turned.m[i], closest.m[i]);
  return turned;
}

/// The turn [w]× F A, A = diag(inertia), with the torque of a stress about F: (tr(C) I - C) w = axial(stress Fᵀ), C =
/// F A Fᵀ. Zero where the nodes lie on one line, which has no such axis.
template <class S>
RINGWATCH_INLINE Matrix3<S> rotationAgainst(const Matrix3<S>& stress, const Matrix3<S>& F, const S (&inertia)[3]) {
  Matrix3<S> FA;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) FA(i, j) = F(i, j) * inertia[j];
  const Matrix3<S> C = timesTranspose(FA, F), T = timesTranspose(stress, F);
  const S size = trace(C);
  const Matrix3<S> J = Matrix3<S>::diagonal(size) - C, cof = cofactor(J);
  const S det = J.m[0] * cof.m[0] + J.m[1] * cof.m[1] + J.m[2] * cof.m[2];
  const auto turns = det > S(1e-13) * size * size * size;
  const S scale = select(turns, S(1.0) / select(turns, det, S(1.0)), S(0.0));
  const S t0 = scale * (T.m[7] - T.m[5]), t1 = scale * (T.m[2] - T.m[6]), t2 = scale * (T.m[3] - T.m[1]);
  const S w0 = cof.m[0] * t0 + cof.m[1] * t1 + cof.m[2] * t2, w1 = cof.m[3] * t0 + cof.m[4] * t1 + cof.m[5] * t2,
          w2 = cof.m[6] * t0 + cof.m[7] * t1 + cof.m[8] * t2;
  const S o(0.0);
  return Matrix3<S>{{o, -w2, w1, w2, o, -w0, -w1, w0, o}} * FA;
}

}  // namespace ringwatch
