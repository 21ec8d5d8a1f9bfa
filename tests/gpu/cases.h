#pragma once
#include <array>
#include <random>
#include <string>

#include <Eigen/Geometry>

#include <ringwatch/body/body.h>
#include <ringwatch/meshes/generators/generators.h>
#include <tests/support/meshes.h>

/// Meshes, states and bodies of the GPU's tests.
namespace ringwatch {

inline constexpr const char* elementNames[] = {"tet4", "hex8", "wedge6", "pyramid5"};
inline constexpr const char* lawNames[] = {"stvk", "linear", "corotational", "neo-hookean"};

inline NodeVectors randomVectors(Eigen::Index count, double size, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-size, size);
  NodeVectors v(3, count);
  for (Eigen::Index i = 0; i < v.size(); ++i) v.data()[i] = uniform(generator);
  return v;
}

/// A strained, turned and disturbed state without inverted elements.
inline NodeVectors randomState(const Mesh& mesh, double noise, unsigned seed) {
  Eigen::Matrix3d F = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, -1).normalized()).toRotationMatrix() *
                      (Eigen::Matrix3d() << 1.1, 0.05, 0, 0, 0.95, 0.1, 0, 0, 1.2).finished();
  return F * mesh.X + randomVectors(mesh.X.cols(), noise, seed);
}

inline Mesh bar(const std::string& element, std::array<int, 3> cells, double jitter = 0.15) {
  return test::gridMesh(element, cells, {0.25 * cells[0], 0.25 * cells[1], 0.25 * cells[2]}, jitter);
}

/// Blocks of all elements.
inline Mesh mixedBar() {
  BarOptions options;
  options.cells = {16, 6, 6};
  options.size = {4, 1.5, 1.5};
  return generateMixedBar(options);
}

using test::firstElements;

inline double relative(const NodeVectors& a, const NodeVectors& b) { return (a - b).norm() / b.norm(); }
inline bool sameBits(const NodeVectors& a, const NodeVectors& b) { return (a.array() == b.array()).all(); }

/// A hanging bar, one end held, the other drawn, under gravity.
inline Body loadedBar(const char* element, const char* law, std::array<int, 3> cells = {6, 3, 3}) {
  Body body(bar(element, cells), makeMaterial(law, 3e4, 0.3, 1000));
  const NodeVectors& X = body.mesh().X;
  for (std::int32_t i = 0; i < body.nodeCount(); ++i) {
    if (X(0, i) < 1e-9) body.constraints().fix(i);
    if (X(0, i) > X.row(0).maxCoeff() - 1e-9) body.constraints().move(i, 0, 0.5);
  }
  body.addBodyForce({0, 0, -9.81});
  return body;
}

}  // namespace ringwatch
