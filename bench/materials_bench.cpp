// Rotation extraction: ns a matrix with the rotation's error beside it, of packed methods and of Eigen's
// decompositions. Inputs: random (singular values 0.2 to 3), near (a rotation and 5 % of noise), inverted, collapsed
// (the least singular value 1e-9, of either sign).
#include <random>
#include <vector>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/QR>
#include <Eigen/SVD>

#include <bench/support.h>
#include <ringwatch/materials/rotation.h>

namespace ringwatch::bench {
namespace {

constexpr int count = 4096;
const char* const inputNames[] = {"random", "near", "inverted", "collapsed"};

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
  std::vector<Eigen::Matrix3d> F, exact, known;  // known: a rotation of a step before, for warm starts
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
      F.push_back(matrix);
      const Eigen::JacobiSVD<Eigen::Matrix3d> svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
      const double sign = (svd.matrixU() * svd.matrixV().transpose()).determinant();
      exact.push_back(svd.matrixU() * Eigen::Vector3d(1, 1, sign).asDiagonal() * svd.matrixV().transpose());
      const Eigen::Vector3d axis = randomMatrix(engine).col(0).normalized();
      known.push_back(Eigen::AngleAxisd(0.02, axis).toRotationMatrix() * exact.back());
    }
  }
};
const Inputs& inputsOf(int kind) {
  static const Inputs all[] = {Inputs(0), Inputs(1), Inputs(2), Inputs(3)};
  return all[kind];
}

template <class S>
struct ScalarOf {
  using type = S;
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

/// Eigenvectors of FᵀF by cyclic Jacobi rotations (Golub & Van Loan 2013, section 8.5) with a fixed number of sweeps,
/// then U from the two largest: R = Σ (F v_i / s_i) ⊗ v_i, the third column by the cross product.
template <class S>
RINGWATCH_INLINE Matrix3<S> cyclicJacobi(const Matrix3<S>& F, const Matrix3<S>&) {
  Matrix3<S> C = transposeTimes(F, F), V = Matrix3<S>::identity();
  constexpr int sweeps = sizeof(typename ScalarOf<S>::type) == 8 ? 5 : 4;
  for (int sweep = 0; sweep < sweeps; ++sweep)
    for (int k = 0; k < 3; ++k) {
      const int p = k == 2 ? 1 : 0, q = k == 0 ? 1 : 2, r = 3 - p - q;
      const S apq = C(p, q), twice = apq + apq, d = C(q, q) - C(p, p);
      const S root = math::sqrt(d * d + twice * twice) + S(1e-37f);
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
  // The least eigenvalue's column last.
  S least = C(2, 2);
  for (int k = 0; k < 2; ++k) {
    const auto swap = C(k, k) < least;
    for (int i = 0; i < 3; ++i) {
      const S a = V(i, k), b = V(i, 2);
      V(i, k) = select(swap, b, a);
      V(i, 2) = select(swap, -a, b);
    }
    const S value = C(k, k);
    C(k, k) = select(swap, least, value);
    least = select(swap, value, least);
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

/// Müller, Bender, Chentanez & Macklin 2016, "A robust method to extract the rotational part of deformations": turns R
/// by w = Σ r_i × f_i / |Σ r_i·f_i| until it is small, here by the Cayley transform; from a rotation known before.
template <class S>
RINGWATCH_INLINE Matrix3<S> mueller(const Matrix3<S>& F, const Matrix3<S>& known) {
  using T = typename ScalarOf<S>::type;
  Matrix3<S> R = known;
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
RINGWATCH_INLINE Matrix3<S> library(const Matrix3<S>& F, const Matrix3<S>&) {
  return closestRotation(F);
}

template <class S, Matrix3<S> (*method)(const Matrix3<S>&, const Matrix3<S>&)>
void rotations(benchmark::State& state, int kind) {
  const Inputs& inputs = inputsOf(kind);
  const auto F = packed<S>(inputs.F), known = packed<S>(inputs.known);
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
}

/// The peers, one matrix at a time.
template <Eigen::Matrix3d (*method)(const Eigen::Matrix3d&)>
void peer(benchmark::State& state, int kind) {
  const Inputs& inputs = inputsOf(kind);
  std::vector<Eigen::Matrix3d> R(count);
  for (auto _ : state) {
    for (std::size_t i = 0; i < count; ++i) R[i] = method(inputs.F[i]);
    benchmark::DoNotOptimize(R.data());
    benchmark::ClobberMemory();
  }
  Worst worst;
  for (std::size_t i = 0; i < count; ++i) worst.add(R[i], inputs.exact[i]);
  reportRotations(state, worst);
}
Eigen::Matrix3d eigenSvd(const Eigen::Matrix3d& F) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(F, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::Matrix3d R = svd.matrixU() * svd.matrixV().transpose();
  return R.determinant() < 0 ? svd.matrixU() * Eigen::Vector3d(1, 1, -1).asDiagonal() * svd.matrixV().transpose() : R;
}
/// F (FᵀF)^-½ by the closed-form eigenvalues of FᵀF; the least root counts negative where det F < 0.
Eigen::Matrix3d eigenDirect(const Eigen::Matrix3d& F) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(F.transpose() * F);
  Eigen::Vector3d s = solver.eigenvalues().cwiseMax(0).cwiseSqrt();
  if (F.determinant() < 0) s[0] = -s[0];
  return F * solver.eigenvectors() * s.cwiseInverse().asDiagonal() * solver.eigenvectors().transpose();
}

void registerAll() {
  using Double = NativePack;
  using Float = Pack<float, 2 * nativeWidth>;
  const auto add = [](const char* name, void (*run)(benchmark::State&, int)) {
    for (int kind = 0; kind < 4; ++kind)
      benchmark::RegisterBenchmark((std::string("rotation/") + name + "/" + inputNames[kind]).c_str(),
                                   [=](benchmark::State& state) { run(state, kind); });
  };
  add("library", rotations<Double, library<Double>>);
  add("library_float", rotations<Float, library<Float>>);
  add("cyclic_jacobi", rotations<Double, cyclicJacobi<Double>>);
  add("cyclic_jacobi_float", rotations<Float, cyclicJacobi<Float>>);
  add("mueller_warm", rotations<Double, mueller<Double>>);
  add("mueller_warm_float", rotations<Float, mueller<Float>>);
  add("plain", rotations<double, library<double>>);
  add("eigen_svd", peer<eigenSvd>);
  add("eigen_direct", peer<eigenDirect>);
}

}  // namespace
}  // namespace ringwatch::bench

int main(int argc, char** argv) { return ringwatch::bench::runBenchmarks(argc, argv, ringwatch::bench::registerAll); }
