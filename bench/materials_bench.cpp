// Rotation extraction: ns a matrix with the rotation's error beside it, of the library's method and of Eigen's
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
  std::vector<Eigen::Matrix3d> F, exact;
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

/// Operations a matrix: the mean over all inputs, each counted alone, so that lanes that wait for others are not part
/// of the floor. A pack of floats holds twice as many.
template <class C>
double countedFlops(const Inputs& inputs) {
  const auto F = packed<C>(inputs.F);
  return operationsOf([&] {
           for (const Matrix3<C>& matrix : F) closestRotation(matrix);
         }) /
         count;
}

/// The library's rotation of numbers or packs S; C: of the same precision, counted.
template <class S, class C>
void rotations(benchmark::State& state, int kind) {
  const Inputs& inputs = inputsOf(kind);
  const auto F = packed<S>(inputs.F);
  auto R = F;
  for (auto _ : state) {
    for (std::size_t i = 0; i < F.size(); ++i) R[i] = closestRotation(F[i]);
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
    reportFloor(state, count, {countedFlops<C>(inputs) / perLane, 0});
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
  const auto add = [](const char* name, void (*run)(benchmark::State&, int)) {
    for (int kind = 0; kind < inputKinds; ++kind)
      benchmark::RegisterBenchmark((std::string("rotation/") + name + "/" + inputNames[kind]).c_str(),
                                   [=](benchmark::State& state) { run(state, kind); });
  };
  add("library", rotations<NativePack, Counted>);
  add("library_float", rotations<Pack<float, 2 * nativeWidth>, CountedAs<float>>);
  add("plain", rotations<double, Counted>);
  add("eigen_svd", baseline<double, eigenSvd<double>>);
  add("eigen_svd_float", baseline<float, eigenSvd<float>>);
  add("eigen_direct", baseline<double, eigenDirect<double>>);
  add("eigen_direct_float", baseline<float, eigenDirect<float>>);
}

}  // namespace
}  // namespace ringwatch::bench

int main(int argc, char** argv) { return ringwatch::bench::runBenchmarks(argc, argv, ringwatch::bench::registerAll); }
