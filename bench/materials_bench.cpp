// Rotation extraction: ns a matrix with the rotation's error beside it, of packed methods and of Eigen's
// decompositions. Inputs: random (singular values 0.2 to 3), near (a rotation and 5 % of noise), inverted, collapsed
// (the least singular value 1e-9, of either sign), equal (singular values equal to 1e-9).
#include <random>
#include <vector>

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <Eigen/SVD>

#include <bench/flops.h>
#include <bench/support.h>
#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/materials/rotation.h>

namespace ringwatch::bench {
namespace {

constexpr int count = 4096;
const char* const inputNames[] = {"random", "near", "inverted", "collapsed", "equal"};
constexpr int inputKinds = static_cast<int>(std::size(inputNames));

Eigen::Matrix3d randomMatrix(std::mt19937_64& engine) {
  Eigen::Matrix3d values;
  for (int i = 0; i < 9; ++i) values(i / 3, i % 3) = static_cast<double>(engine() >> 11) * 0x1p-52 - 1;
  return values;
}
Eigen::Matrix3d randomRotation(std::mt19937_64& engine) {
  const Eigen::Matrix3d Q = Eigen::HouseholderQR<Eigen::Matrix3d>(randomMatrix(engine)).householderQ();
  return Q.determinant() < 0 ? Eigen::Matrix3d(-Q) : Q;
}

struct Inputs {
  // known, axes: rotation and eigenvectors of FᵀF of a step before, for warm starts: turned by 0.02, strained by 0.01.
  std::vector<Eigen::Matrix3d> F, exact, known, axes;
  explicit Inputs(int kind) {
    std::mt19937_64 engine(static_cast<std::uint64_t>(kind) + 1);
    const auto uniform = [&](double low, double high) {
      return low + (high - low) * static_cast<double>(engine() >> 11) * 0x1p-53;
    };
    for (int i = 0; i < count; ++i) {
      Eigen::Vector3d s{uniform(0.2, 3), uniform(0.2, 3), uniform(0.2, 3)};
      if (kind == 2) s = {uniform(0.5, 3), uniform(0.5, 1), -uniform(0.05, 0.4)};
      if (kind == 3) s = {uniform(0.5, 3), uniform(0.5, 3), i % 2 == 0 ? 1e-9 : -1e-9};
      Eigen::Matrix3d matrix = randomRotation(engine) * s.asDiagonal() * randomRotation(engine);
      if (kind == 1) matrix = randomRotation(engine) + 0.05 * randomMatrix(engine);
      if (kind == 4) matrix = randomRotation(engine) + 1e-9 * randomMatrix(engine);
      F.push_back(matrix);
      const Eigen::JacobiSVD<Eigen::Matrix3d> svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
      const double sign = (svd.matrixU() * svd.matrixV().transpose()).determinant();
      exact.push_back(svd.matrixU() * Eigen::Vector3d(1, 1, sign).asDiagonal() * svd.matrixV().transpose());
      const Eigen::Vector3d axis = randomMatrix(engine).col(0).normalized();
      known.push_back(Eigen::AngleAxisd(0.02, axis).toRotationMatrix() * exact.back());
      const Eigen::Matrix3d before = matrix + 0.01 * randomMatrix(engine);
      const Eigen::Matrix3d metric = before.transpose() * before;
      Eigen::Matrix3d V = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(metric).eigenvectors();
      if (V.determinant() < 0) V.col(0) *= -1;
      axes.push_back(V);
    }
  }
};
const Inputs& inputsOf(int kind) {
  static const Inputs all[inputKinds] = {Inputs(0), Inputs(1), Inputs(2), Inputs(3), Inputs(4)};
  return all[kind];
}

template <class S>
struct ScalarOf {
  using type = S;
  static constexpr int width = 1;
};
template <class T>
struct ScalarOf<CountedAs<T>> {
  using type = T;
  static constexpr int width = 1;
};
template <class T, int W>
struct ScalarOf<Pack<T, W>> {
  using type = T;
  static constexpr int width = W;
};

/// One matrix a lane.
template <class S>
std::vector<Matrix3<S>, AlignedAllocator<Matrix3<S>>> packed(const std::vector<Eigen::Matrix3d>& from) {
  constexpr int width = ScalarOf<S>::width;
  std::vector<Matrix3<S>, AlignedAllocator<Matrix3<S>>> to(from.size() / width);
  for (std::size_t i = 0; i < from.size(); ++i)
    for (int k = 0; k < 9; ++k) {
      const auto value = static_cast<typename ScalarOf<S>::type>(from[i](k / 3, k % 3));
      if constexpr (width == 1)
        to[i].m[k] = value;
      else
        to[i / width].m[k].set(static_cast<int>(i % width), value);
    }
  return to;
}
template <class S>
Eigen::Matrix3d unpacked(const Matrix3<S>& from, int lane) {
  Eigen::Matrix3d to;
  for (int k = 0; k < 9; ++k) {
    if constexpr (ScalarOf<S>::width == 1)
      to(k / 3, k % 3) = from.m[k] + 0.0 * lane;
    else
      to(k / 3, k % 3) = static_cast<double>(from.m[k][lane]);
  }
  return to;
}

/// The largest |RᵀR - I| and |R - exact|.
struct Worst {
  double orthogonality = 0, distance = 0;
  void add(const Eigen::Matrix3d& R, const Eigen::Matrix3d& exact) {
    const double own = (R.transpose() * R - Eigen::Matrix3d::Identity()).norm(), apart = (R - exact).norm();
    orthogonality = own <= orthogonality ? orthogonality : own;  // keeps NaN
    distance = apart <= distance ? distance : apart;
  }
};
void reportRotations(benchmark::State& state, const Worst& worst) {
  report(state, count, worst.distance);
  state.counters["orthogonality"] = worst.orthogonality;
}

/// What a step before has left, for methods that start from it.
template <class S>
struct Before {
  Matrix3<S> R, axes;  // rotation; eigenvectors of FᵀF, in columns
};

/// R = Σ (F v_i / s_i) ⊗ v_i of eigenvectors V of FᵀF with their eigenvalues; the third column by the cross product,
/// where the least singular value may be zero or negative.
template <class S>
RINGWATCH_INLINE Matrix3<S> rotationOfAxes(const Matrix3<S>& F, Matrix3<S> V, S (&eigenvalue)[3]) {
  // The least eigenvalue's column last.
  for (int k = 0; k < 2; ++k) {
    const auto swap = eigenvalue[k] < eigenvalue[2];
    for (int i = 0; i < 3; ++i) {
      const S a = V(i, k), b = V(i, 2);
      V(i, k) = select(swap, b, a);
      V(i, 2) = select(swap, -a, b);
    }
    const S value = eigenvalue[k];
    eigenvalue[k] = select(swap, eigenvalue[2], value);
    eigenvalue[2] = select(swap, value, eigenvalue[2]);
  }
  S u[3][3];  // columns
  for (int k = 0; k < 2; ++k) {
    S size(0);
    for (int i = 0; i < 3; ++i) {
      u[k][i] = F(i, 0) * V(0, k) + F(i, 1) * V(1, k) + F(i, 2) * V(2, k);
      size += u[k][i] * u[k][i];
    }
    const S inverse = S(1) / math::sqrt(size);
    for (int i = 0; i < 3; ++i) u[k][i] *= inverse;
  }
  S v[3];
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    u[2][i] = u[0][j] * u[1][k] - u[0][k] * u[1][j];
    v[i] = V(j, 0) * V(k, 1) - V(k, 0) * V(j, 1);
  }
  Matrix3<S> R;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) R(i, j) = u[0][i] * V(j, 0) + u[1][i] * V(j, 1) + u[2][i] * v[j];
  return R;
}

/// Eigenvectors of FᵀF by cyclic Jacobi rotations (Golub & Van Loan 2013, section 8.5) until what is off the diagonal
/// is rounding, from the unit matrix or, warm, from the axes of a step before.
template <class S, bool warm>
RINGWATCH_INLINE Matrix3<S> cyclicJacobi(const Matrix3<S>& F, const Before<S>& before) {
  using T = typename ScalarOf<S>::type;
  Matrix3<S> C = transposeTimes(F, F), V = Matrix3<S>::identity();
  if constexpr (warm) {
    V = before.axes;
    C = transposeTimes(V, C * V);
  }
  const S enough = S(T(sizeof(T) == 8 ? 1e-30 : 1e-14)) * trace(C) * trace(C);
  for (int sweep = 0; sweep < 8; ++sweep) {
    if (!anyOf(C(0, 1) * C(0, 1) + C(0, 2) * C(0, 2) + C(1, 2) * C(1, 2) > enough)) break;
    for (int k = 0; k < 3; ++k) {
      const int p = k == 2 ? 1 : 0, q = k == 0 ? 1 : 2, r = 3 - p - q;
      const S apq = C(p, q), twice = apq + apq, d = C(q, q) - C(p, p);
      const S root = math::sqrt(d * d + twice * twice) + S(T(1e-37));
      const S t = select(d < S(0), -twice, twice) / (math::abs(d) + root);
      const S c = S(1) / math::sqrt(t * t + S(1)), s = t * c;
      C(p, p) -= t * apq;
      C(q, q) += t * apq;
      C(p, q) = C(q, p) = S(0);
      const S rp = C(r, p), rq = C(r, q);
      C(r, p) = C(p, r) = c * rp - s * rq;
      C(r, q) = C(q, r) = s * rp + c * rq;
      for (int i = 0; i < 3; ++i) {
        const S vp = V(i, p), vq = V(i, q);
        V(i, p) = c * vp - s * vq;
        V(i, q) = s * vp + c * vq;
      }
    }
  }
  S eigenvalue[3] = {C(0, 0), C(1, 1), C(2, 2)};
  return rotationOfAxes(F, V, eigenvalue);
}

/// Rotation matrix of the unit quaternion (w; x, y, z).
template <class S>
RINGWATCH_INLINE Matrix3<S> matrixOf(const S& w, const S (&v)[3]) {
  const S two(2), xx = v[0] * v[0], yy = v[1] * v[1], zz = v[2] * v[2];
  const S xy = v[0] * v[1], xz = v[0] * v[2], yz = v[1] * v[2], wx = w * v[0], wy = w * v[1], wz = w * v[2];
  return Matrix3<S>{{S(1) - two * (yy + zz), two * (xy - wz), two * (xz + wy), two * (xy + wz), S(1) - two * (xx + zz),
                     two * (yz - wx), two * (xz - wy), two * (yz + wx), S(1) - two * (xx + yy)}};
}

/// McAdams, Selle, Tamstorf, Teran & Sifakis 2011, "Computing the singular value decomposition of 3×3 matrices with
/// minimal branching and elementary floating point operations", from its description: a fixed number of sweeps over
/// FᵀF with approximate Givens quaternions (section 2), columns of B = F V sorted by length (section 3), U by Givens
/// QR of B (section 4); R = U Vᵀ. Four sweeps are the paper's.
template <class S, int sweeps>
RINGWATCH_INLINE Matrix3<S> mcAdams(const Matrix3<S>& F, const Before<S>&) {
  using T = typename ScalarOf<S>::type;
  Matrix3<S> C = transposeTimes(F, F);
  S w(1), axis[3] = {S(0), S(0), S(0)};
  const S gamma(T(5.828427124746190));  // 3 + 2√2: beyond, the approximate angle would pass π/8
  const S cosine(T(0.9238795325112867)), sine(T(0.3826834323650898));  // of π/8
  for (int sweep = 0; sweep < sweeps; ++sweep)
    for (int p = 0; p < 3; ++p) {
      const int q = (p + 1) % 3, r = (p + 2) % 3;
      S ch = S(2) * (C(p, p) - C(q, q)), sh = C(p, q);
      const auto small = gamma * sh * sh < ch * ch;
      const S inverse = S(1) / math::sqrt(select(small, ch * ch + sh * sh, S(1)));
      ch = select(small, inverse * ch, cosine);
      sh = select(small, inverse * sh, sine);
      const S c = ch * ch - sh * sh, s = S(2) * ch * sh, cc = c * c, ss = s * s, cs = c * s;
      const S pp = C(p, p), qq = C(q, q), pq = C(p, q), rp = C(r, p), rq = C(r, q);
      const S cross = S(2) * cs * pq;
      C(p, p) = cc * pp + cross + ss * qq;
      C(q, q) = ss * pp - cross + cc * qq;
      C(p, q) = C(q, p) = (cc - ss) * pq + cs * (qq - pp);
      C(r, p) = C(p, r) = c * rp + s * rq;
      C(r, q) = C(q, r) = c * rq - s * rp;
      // The turn about axis r from the right.
      const S w0 = w, a0 = axis[p], a1 = axis[q], a2 = axis[r];
      w = ch * w0 - sh * a2;
      axis[p] = ch * a0 + sh * a1;
      axis[q] = ch * a1 - sh * a0;
      axis[r] = ch * a2 + sh * w0;
    }
  const S unit = S(1) / math::sqrt(w * w + axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
  w *= unit;
  for (S& component : axis) component *= unit;
  Matrix3<S> V = matrixOf(w, axis), B = F * V;
  S length[3];
  for (int k = 0; k < 3; ++k) length[k] = B(0, k) * B(0, k) + B(1, k) * B(1, k) + B(2, k) * B(2, k);
  const int pairs[3][2] = {{0, 1}, {0, 2}, {1, 2}};
  for (const auto& [i, j] : pairs) {
    const auto swap = length[i] < length[j];
    const S l = length[i];
    length[i] = select(swap, length[j], l);
    length[j] = select(swap, l, length[j]);
    for (Matrix3<S>* m : {&B, &V})
      for (int row = 0; row < 3; ++row) {
        const S a = (*m)(row, i), b = (*m)(row, j);
        (*m)(row, i) = select(swap, b, a);
        (*m)(row, j) = select(swap, -a, b);
      }
  }
  Matrix3<S> U = Matrix3<S>::identity();
  const int below[3][2] = {{0, 1}, {0, 2}, {1, 2}};  // column and diagonal row, row to clear
  for (const auto& [k, row] : below) {
    const S a = B(k, k), b = B(row, k), rho = math::sqrt(a * a + b * b);
    const auto some = rho > S(T(sizeof(T) == 8 ? 1e-150 : 1e-18));
    const S inverse = S(1) / select(some, rho, S(1));
    const S c = select(some, a * inverse, S(1)), s = select(some, b * inverse, S(0));
    for (int j = 0; j < 3; ++j) {
      const S top = B(k, j), low = B(row, j);
      B(k, j) = c * top + s * low;
      B(row, j) = c * low - s * top;
      const S uk = U(j, k), ur = U(j, row);
      U(j, k) = c * uk + s * ur;
      U(j, row) = c * ur - s * uk;
    }
  }
  return timesTranspose(U, V);
}

/// Müller, Bender, Chentanez & Macklin 2016, "A robust method to extract the rotational part of deformations": turns R
/// by w = Σ r_i × f_i / |Σ r_i·f_i| until it is small, here by the Cayley transform; from a rotation known before.
template <class S>
RINGWATCH_INLINE Matrix3<S> mueller(const Matrix3<S>& F, const Before<S>& before) {
  using T = typename ScalarOf<S>::type;
  Matrix3<S> R = before.R;
  for (int iteration = 0; iteration < 40; ++iteration) {
    S w[3] = {S(0), S(0), S(0)}, along(0);
    for (int i = 0; i < 3; ++i)
      for (int c = 0; c < 3; ++c) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        w[i] += R(j, c) * F(k, c) - R(k, c) * F(j, c);
        along += R(i, c) * F(i, c);
      }
    const S inverse = S(T(0.5)) / (math::abs(along) + S(T(1e-9)));
    S size(0);
    for (S& component : w) {
      component *= inverse;
      size += component * component;
    }
    // (1 + q)(R)(1 + q)⁻¹ with the quaternion (1, w)/√(1 + |w|²)
    const S f = S(2) / (S(1) + size);
    const S xx = w[0] * w[0], yy = w[1] * w[1], zz = w[2] * w[2];
    const Matrix3<S> turn{{S(1) - f * (yy + zz), f * (w[0] * w[1] - w[2]), f * (w[0] * w[2] + w[1]),
                           f * (w[0] * w[1] + w[2]), S(1) - f * (xx + zz), f * (w[1] * w[2] - w[0]),
                           f * (w[0] * w[2] - w[1]), f * (w[1] * w[2] + w[0]), S(1) - f * (xx + yy)}};
    R = turn * R;
    if (!anyOf(size > S(T(sizeof(T) == 8 ? 1e-26 : 1e-13)))) break;
  }
  return R;
}

template <class S>
RINGWATCH_INLINE Matrix3<S> library(const Matrix3<S>& F, const Before<S>&) {
  return closestRotation(F);
}

template <class S>
std::vector<Before<S>, AlignedAllocator<Before<S>>> before(const Inputs& inputs) {
  const auto R = packed<S>(inputs.known), axes = packed<S>(inputs.axes);
  std::vector<Before<S>, AlignedAllocator<Before<S>>> all(R.size());
  for (std::size_t i = 0; i < R.size(); ++i) all[i] = {R[i], axes[i]};
  return all;
}

/// Operations a matrix: the mean over all inputs, each counted alone, so that lanes that wait for others are not part
/// of the floor. A pack of floats holds twice as many.
template <class C, Matrix3<C> (*method)(const Matrix3<C>&, const Before<C>&)>
double countedFlops(const Inputs& inputs) {
  const auto F = packed<C>(inputs.F);
  const auto known = before<C>(inputs);
  return operationsOf([&] {
           for (std::size_t i = 0; i < F.size(); ++i) method(F[i], known[i]);
         }) /
         count;
}

template <class S, Matrix3<S> (*method)(const Matrix3<S>&, const Before<S>&), class C,
          Matrix3<C> (*counted)(const Matrix3<C>&, const Before<C>&)>
void rotations(benchmark::State& state, int kind) {
  const Inputs& inputs = inputsOf(kind);
  const auto F = packed<S>(inputs.F);
  const auto known = before<S>(inputs);
  auto R = F;
  for (auto _ : state) {
    for (std::size_t i = 0; i < F.size(); ++i) R[i] = method(F[i], known[i]);
    benchmark::DoNotOptimize(R.data());
    benchmark::ClobberMemory();
  }
  Worst worst;
  constexpr int width = ScalarOf<S>::width;
  for (std::size_t i = 0; i < count; ++i)
    worst.add(unpacked(R[i / width], static_cast<int>(i % width)), inputs.exact[i]);
  reportRotations(state, worst);
  if constexpr (width > 1) {
    constexpr double perLane = detail::isSingle<S> ? 2 : 1;  // a pack of floats has twice the lanes
    reportFloor(state, count, {countedFlops<C, counted>(inputs) / perLane, 0});
  }
}

/// The baselines, one matrix at a time.
template <class T, Eigen::Matrix<T, 3, 3> (*method)(const Eigen::Matrix<T, 3, 3>&)>
void baseline(benchmark::State& state, int kind) {
  const Inputs& inputs = inputsOf(kind);
  std::vector<Eigen::Matrix<T, 3, 3>> F, R(count);
  for (const Eigen::Matrix3d& matrix : inputs.F) F.push_back(matrix.cast<T>());
  for (auto _ : state) {
    for (std::size_t i = 0; i < count; ++i) R[i] = method(F[i]);
    benchmark::DoNotOptimize(R.data());
    benchmark::ClobberMemory();
  }
  Worst worst;
  for (std::size_t i = 0; i < count; ++i) worst.add(R[i].template cast<double>(), inputs.exact[i]);
  reportRotations(state, worst);
}
template <class T>
Eigen::Matrix<T, 3, 3> eigenSvd(const Eigen::Matrix<T, 3, 3>& F) {
  using Matrix = Eigen::Matrix<T, 3, 3>;
  const Eigen::JacobiSVD<Matrix> svd(F, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Matrix R = svd.matrixU() * svd.matrixV().transpose();
  if (R.determinant() >= 0) return R;
  return svd.matrixU() * Eigen::Matrix<T, 3, 1>(1, 1, -1).asDiagonal() * svd.matrixV().transpose();
}
/// F (FᵀF)^-½ by the closed-form eigenvalues of FᵀF; the least root counts negative where det F < 0.
template <class T>
Eigen::Matrix<T, 3, 3> eigenDirect(const Eigen::Matrix<T, 3, 3>& F) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix<T, 3, 3>> solver;
  solver.computeDirect(F.transpose() * F);
  Eigen::Matrix<T, 3, 1> s = solver.eigenvalues().cwiseMax(T(0)).cwiseSqrt();
  if (F.determinant() < 0) s[0] = -s[0];
  return F * solver.eigenvectors() * s.cwiseInverse().asDiagonal() * solver.eigenvectors().transpose();
}

void registerAll() {
  using Double = NativePack;
  using Float = Pack<float, 2 * nativeWidth>;
  using CountedSingle = CountedAs<float>;
  const auto add = [](const char* name, void (*run)(benchmark::State&, int)) {
    for (int kind = 0; kind < inputKinds; ++kind)
      benchmark::RegisterBenchmark((std::string("rotation/") + name + "/" + inputNames[kind]).c_str(),
                                   [=](benchmark::State& state) { run(state, kind); });
  };
  add("library", rotations<Double, library<Double>, Counted, library<Counted>>);
  add("library_float", rotations<Float, library<Float>, CountedSingle, library<CountedSingle>>);
  add("jacobi", rotations<Double, cyclicJacobi<Double, false>, Counted, cyclicJacobi<Counted, false>>);
  add("jacobi_float", rotations<Float, cyclicJacobi<Float, false>, CountedSingle, cyclicJacobi<CountedSingle, false>>);
  add("jacobi_warm", rotations<Double, cyclicJacobi<Double, true>, Counted, cyclicJacobi<Counted, true>>);
  add("jacobi_warm_float",
      rotations<Float, cyclicJacobi<Float, true>, CountedSingle, cyclicJacobi<CountedSingle, true>>);
  add("mcadams_4", rotations<Double, mcAdams<Double, 4>, Counted, mcAdams<Counted, 4>>);
  add("mcadams_4_float", rotations<Float, mcAdams<Float, 4>, CountedSingle, mcAdams<CountedSingle, 4>>);
  add("mcadams_8", rotations<Double, mcAdams<Double, 8>, Counted, mcAdams<Counted, 8>>);
  add("mcadams_8_float", rotations<Float, mcAdams<Float, 8>, CountedSingle, mcAdams<CountedSingle, 8>>);
  add("mueller_warm", rotations<Double, mueller<Double>, Counted, mueller<Counted>>);
  add("mueller_warm_float", rotations<Float, mueller<Float>, CountedSingle, mueller<CountedSingle>>);
  add("plain", rotations<double, library<double>, Counted, library<Counted>>);
  add("eigen_svd", baseline<double, eigenSvd<double>>);
  add("eigen_svd_float", baseline<float, eigenSvd<float>>);
  add("eigen_direct", baseline<double, eigenDirect<double>>);
  add("eigen_direct_float", baseline<float, eigenDirect<float>>);
}

}  // namespace
}  // namespace ringwatch::bench

int main(int argc, char** argv) { return ringwatch::bench::runBenchmarks(argc, argv, ringwatch::bench::registerAll); }
