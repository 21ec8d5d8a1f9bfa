// The largest eigenvalue of one element's M⁻¹K: the library's packed solver against Eigen's full ones, for the shapes
// of Fierz 2013, tables 5.3 and 5.4.
#include <map>
#include <random>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include <bench/support.h>
#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/base/error.h>
#include <ringwatch/monitor/small/extreme_eigenvalues.h>

namespace ringwatch::bench {
namespace {

constexpr int count = 512, lanes = nativeWidth;

struct Shape {
  const char* element;
  const char* name;
  std::vector<Eigen::Vector3d> nodes;
};
const std::vector<Shape>& shapes() {
  const auto hex = [](double a, double b, double c, double shear) {
    std::vector<Eigen::Vector3d> x;
    for (const auto& [i, j, k] :
         {std::tuple{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}})
      x.emplace_back(a * i + shear * k, b * j, c * k);
    return x;
  };
  static const std::vector<Shape> all = {
      // Named as in Cheng et al. 2000, "Sliver exudation".
      {"tet4", "cap", {{0, 0, 0}, {1, 0, 0}, {0.5, 0.87, 0}, {0.5, 0.29, 0.06}}},
      {"tet4", "needle", {{0, 0, 0}, {0.1, 0, 0}, {0.05, 0.087, 0}, {0.05, 0.029, 1}}},
      {"tet4", "round", {{0, 0, 0}, {1, 0, 0}, {0.5, 0.87, 0}, {0.5, 0.29, 0.82}}},
      {"tet4", "sliver", {{0, 0, 0}, {1, 0, 0.06}, {1, 1, 0}, {0, 1, 0.06}}},
      {"tet4", "spindle", {{0, 0, 0}, {1, 0, 0}, {0.5, 0.15, 0.05}, {0.5, -0.15, 0.05}}},
      {"tet4", "wedge", {{0, 0, 0}, {1, 0, 0}, {0.5, 0.87, 0}, {0.5, 0.87, 0.08}}},
      {"hex8", "cube", hex(1, 1, 1, 0)},
      {"hex8", "plate", hex(1, 1, 0.1, 0)},
      {"hex8", "rod", hex(1, 0.1, 0.1, 0)},
      {"hex8", "sheared", hex(1, 1, 1, 1)},
  };
  return all;
}

/// Elements that share no nodes, a few per cent off the shape and turned, with all that the solvers need.
struct Elements {
  int n = 0;                           // nodes
  std::vector<Eigen::MatrixXd> dense;  // M^-½ K M^-½
  std::vector<double> exact;           // its largest eigenvalues
  AlignedVector<NativePack> packed;    // [pack][3n][3n]
  Elements(const Shape& shape, double poisson) {
    Mesh mesh;
    n = static_cast<int>(shape.nodes.size());
    mesh.X.resize(3, n * count);
    MeshBlock block{n == 4 ? elementTypeOf<Tet4> : elementTypeOf<Hex8>, {}, {}};
    std::mt19937_64 engine(7);
    const auto random = [&] { return static_cast<double>(engine() >> 11) * 0x1p-52 - 1; };
    for (int e = 0; e < count; ++e) {
      Eigen::Vector4d quaternion;
      Eigen::Matrix3d off = Eigen::Matrix3d::Identity();
      for (double& value : quaternion) value = random();
      for (double& value : off.reshaped()) value += 0.03 * random();
      const Eigen::Matrix3d turn = Eigen::Quaterniond(quaternion).normalized().toRotationMatrix();
      for (int a = 0; a < n; ++a) {
        mesh.X.col(e * n + a) = turn * off * shape.nodes[a];
        block.connectivity.push_back(e * n + a);
      }
      // Node order that turns the other way round has a negative volume.
      if (n == 4) {
        const auto x = mesh.X.middleCols<4>(4 * e);
        if ((x.col(1) - x.col(0)).cross(x.col(2) - x.col(0)).dot(x.col(3) - x.col(0)) < 0)
          std::swap(block.connectivity[4 * e + 1], block.connectivity[4 * e + 2]);
      }
    }
    mesh.blocks.push_back(std::move(block));
    const Body body(std::move(mesh), makeMaterial("linear", 1, poisson, 1));
    const int size = 3 * n;
    packed.resize(count / lanes * size * size);
    for (int e = 0; e < count; ++e) {
      const auto nodes = body.blocks()[0]->nodesOf(e);
      Eigen::VectorXd scale(size);
      for (int i = 0; i < size; ++i) scale[i] = 1 / std::sqrt(body.lumpedMass()[nodes[i / 3]]);
      const Eigen::MatrixXd K = body.elementTangent({0, e}, body.mesh().X);
      dense.emplace_back(scale.asDiagonal() * K * scale.asDiagonal());
      exact.push_back(
          Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(dense.back(), Eigen::EigenvaluesOnly).eigenvalues()[size - 1]);
      for (int i = 0; i < size; ++i)
        for (int j = 0; j < size; ++j) packed[(e / lanes * size + i) * size + j].set(e % lanes, dense.back()(i, j));
    }
  }
};
const Elements& elementsOf(const Shape& shape, double poisson) {
  static std::map<std::string, Elements> known;
  const std::string key = std::string(shape.element) + shape.name + std::to_string(poisson);
  auto found = known.find(key);
  if (found == known.end()) found = known.emplace(key, Elements(shape, poisson)).first;
  return found->second;
}

void finish(benchmark::State& state, const Elements& elements, const std::vector<double>& found) {
  double error = 0;
  for (std::size_t e = 0; e < count; ++e) error = std::max(error, std::abs(found[e] / elements.exact[e] - 1));
  report(state, count, error);
}

template <bool Vectors>
void eigenSolver(benchmark::State& state, const Elements& elements) {
  std::vector<double> found(count);
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(3 * elements.n);
  for (auto _ : state)
    for (std::size_t e = 0; e < count; ++e) {
      solver.compute(elements.dense[e], Vectors ? Eigen::ComputeEigenvectors : Eigen::EigenvaluesOnly);
      found[e] = solver.eigenvalues()[3 * elements.n - 1];
    }
  finish(state, elements, found);
}

/// What the library uses: tridiagonal form and Laguerre's iteration, to rounding.
void packedSolver(benchmark::State& state, const Elements& elements) {
  const int size = 3 * elements.n;
  std::vector<double> found(count);
  AlignedVector<NativePack> A(size * size), work(4 * size);
  for (auto _ : state)
    for (int pack = 0; pack < count / lanes; ++pack) {
      std::copy_n(elements.packed.begin() + static_cast<std::ptrdiff_t>(pack) * size * size, size * size, A.begin());
      extremeEigenvalues(A.data(), size, work.data(), false).largest.store(found.data() + pack * lanes);
    }
  finish(state, elements, found);
}

void registerAll() {
  for (const Shape& shape : shapes())
    for (const double poisson : {0.3, 0.4, 0.49}) {
      const auto add = [&](const char* solver, const auto& run) {
        benchmark::RegisterBenchmark(
            joinText("largest/", solver, "/", shape.element, "/", shape.name, "/nu:", poisson).c_str(),
            [&shape, poisson, run](benchmark::State& state) { run(state, elementsOf(shape, poisson)); });
      };
      add("eigen_vectors", eigenSolver<true>);
      add("eigen_values", eigenSolver<false>);
      add("packed", packedSolver);
    }
}

}  // namespace
}  // namespace ringwatch::bench

int main(int argc, char** argv) { return ringwatch::bench::runBenchmarks(argc, argv, ringwatch::bench::registerAll); }
