#pragma once
#include <array>
#include <random>
#include <string>

#include <Eigen/Geometry>

#include <ringwatch/body/body.h>
#include <ringwatch/meshes/generators/generators.h>

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
  BarOptions options;
  options.element = element;
  options.cells = cells;
  options.size = {0.25 * cells[0], 0.25 * cells[1], 0.25 * cells[2]};
  options.jitter = jitter;
  return generateBar(options);
}

/// Blocks of all elements.
inline Mesh mixedBar() {
  BarOptions options;
  options.cells = {16, 6, 6};
  options.size = {4, 1.5, 1.5};
  return generateMixedBar(options);
}

/// The first `count` elements of a mesh of one block, without the nodes that they do not have.
inline Mesh firstElements(const Mesh& mesh, std::size_t count) {
  Mesh part;
  const MeshBlock& from = mesh.blocks.front();
  MeshBlock block{from.type, {}, {}};
  std::vector<std::int32_t> number(mesh.nodeCount(), -1), nodes;
  for (std::size_t e = 0; e < count; ++e) {
    block.ids.push_back(e);
    for (int a = 0; a < from.nodesPerElement(); ++a) {
      const std::int32_t node = from.element(e)[a];
      if (number[node] < 0) {
        number[node] = static_cast<std::int32_t>(nodes.size());
        nodes.push_back(node);
      }
      block.connectivity.push_back(number[node]);
    }
  }
  part.X.resize(3, nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    part.X.col(i) = mesh.X.col(nodes[i]);
    part.nodeIds.push_back(i);
  }
  part.blocks.push_back(std::move(block));
  return part;
}

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
