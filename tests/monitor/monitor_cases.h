#pragma once
#include <cmath>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include <ringwatch/base/error.h>
#include <ringwatch/body/body.h>
#include <ringwatch/meshes/generators/generators.h>
#include <tests/support/body_cases.h>
#include <tests/support/random.h>
#include <tests/support/registry_types.h>

namespace ringwatch::test {

/// Positive eigenvalues lambda of M⁻¹K and everything else of the dense problem over the free degrees of freedom.
struct DenseTangent {
  Eigen::MatrixXd matrix;                                // M^-½ K M^-½, rows and columns of free components
  std::vector<std::pair<std::int32_t, int>> components;  // node and component of each row

  DenseTangent(const Body& body, const NodeVectors& x) {
    for (std::int32_t i = 0; i < body.nodeCount(); ++i)
      for (int c = 0; c < 3; ++c)
        if (!body.constraints().isConstrained(i, c)) components.emplace_back(i, c);
    const Eigen::MatrixXd K = body.assembleTangent(x);
    const Eigen::Index n = components.size();
    matrix.resize(n, n);
    for (Eigen::Index r = 0; r < n; ++r)
      for (Eigen::Index s = 0; s < n; ++s) {
        const auto [i, c] = components[r];
        const auto [j, d] = components[s];
        matrix(r, s) = K(3 * i + c, 3 * j + d) / std::sqrt(body.lumpedMass()[i] * body.lumpedMass()[j]);
      }
  }
  bool finite() const { return matrix.allFinite(); }
  /// Ascending, rad²/s².
  Eigen::VectorXd eigenvalues() const {
    if (matrix.rows() == 0) return Eigen::VectorXd();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix, Eigen::EigenvaluesOnly);
    EXPECT_EQ(solver.info(), Eigen::Success);
    return solver.eigenvalues();
  }
  /// Largest eigenvalue; 0 where nothing is free.
  double largest() const {
    const Eigen::VectorXd lambda = eigenvalues();
    return lambda.size() == 0 ? 0 : lambda[lambda.size() - 1];
  }
};

/// How a box of cells is cut into elements.
struct Subdivision {
  std::string name;
  std::string element;
  int split = 0;
  std::string other;  // the second half of the box is of this element, in a block of its own; "" for none
  int otherSplit = 0;
};
/// Every split of the library into linear elements, and boxes of two blocks.
inline std::vector<Subdivision> allSubdivisions() {
  std::vector<Subdivision> subdivisions;
  std::vector<CellSubdivision> whole;  // splits that add no nodes to the cells' corners, the first of each element
  for (const CellSubdivision& split : allCellSubdivisions()) {
    // Dense eigenvalues at every step of a run take minutes with the 60 degrees of freedom of a quadratic element.
    if (findElementByName(split.element)->order > 1) continue;
    subdivisions.push_back({joinText(split.element, "_", split.elementsPerCell), std::string(split.element),
                            split.elementsPerCell, "", 0});
    if (!split.centre && (whole.empty() || whole.back().element != split.element)) whole.push_back(split);
  }
  for (std::size_t i = 0; i + 1 < whole.size(); ++i)
    subdivisions.push_back({joinText(whole[i].element, "_and_", whole[i + 1].element), std::string(whole[i].element),
                            whole[i].elementsPerCell, std::string(whole[i + 1].element), whole[i + 1].elementsPerCell});
  return subdivisions;
}

/// A box of cells of 1 cm.
inline Mesh box(const Subdivision& subdivision, std::array<int, 3> cells, double jitter = 0.2, std::uint64_t seed = 3) {
  BarOptions options;
  options.cells = cells;
  for (std::size_t k = 0; k < 3; ++k) options.size[k] = cells[k] * cellSize;
  options.jitter = jitter;
  options.seed = seed;
  options.element = subdivision.element;
  options.split = subdivision.split;
  Mesh mesh = generateBar(options);
  if (subdivision.other.empty()) return mesh;
  options.element = subdivision.other;
  options.split = subdivision.otherSplit;
  const Mesh second = generateBar(options);
  // Cells run along x first: the lower half keeps the first block's elements, the upper half takes the second's.
  const auto keep = [&](const MeshBlock& from, bool low) {
    MeshBlock block{from.type, {}, {}};
    const auto perCell = from.elementCount() / static_cast<std::size_t>(cells[0] * cells[1] * cells[2]);
    for (std::size_t e = 0; e < from.elementCount(); ++e)
      if ((static_cast<int>(e / perCell) % cells[0] < cells[0] / 2) == low) {
        block.connectivity.insert(block.connectivity.end(), from.element(e), from.element(e) + from.nodesPerElement());
        block.ids.push_back(from.ids[e]);
      }
    return block;
  };
  mesh.blocks = {keep(mesh.blocks[0], true), keep(second.blocks[0], false)};
  mesh.elementSets.clear();
  return mesh;
}

inline BodyOptions onThreads(int threads) {
  BodyOptions options;
  options.threads = threads;
  return options;
}
inline Body boxBody(const Subdivision& subdivision, std::string_view law, std::array<int, 3> cells = {2, 2, 2},
                    double jitter = 0.2, std::uint64_t seed = 3, int threads = 1) {
  Mesh mesh = box(subdivision, cells, jitter, seed);
  std::vector<Material> materials{makeMaterial(law, young, poisson, density)};
  if (mesh.blocks.size() > 1) materials.push_back(makeMaterial(law, 3 * young, 0.4, 0.7 * density));
  return Body(std::move(mesh), materials, onThreads(threads));
}

/// A deformed state of a body, with a word on what it is.
struct NamedState {
  std::string name;
  NodeVectors x;
};
inline std::vector<NamedState> deformedStates(const NodeVectors& X, std::uint64_t seed) {
  Random random(seed);
  const Eigen::Vector3d pull(1.6, 0.9, 0.9), push(0.7, 1.1, 1.1);
  std::vector<NamedState> states{
      {"rest", X}, {"stretched", pull.asDiagonal() * X}, {"compressed", push.asDiagonal() * X}};
  for (const double share : {0.1, 0.2, 0.3})
    states.push_back({joinText("moved by ", share, " of an edge"), X + random.nodeVectors(X.cols(), share * cellSize)});
  states.push_back({"turned and strained", random.rotation() * (Eigen::Matrix3d::Identity() + random.matrix(0.2)) * X});
  return states;
}

/// A path of states: a turn about a skew axis by `turned` (rad, at its end), a stretch and back, and a shake of single
/// nodes; `at` in [0, 1].
inline NodeVectors pathState(const NodeVectors& X, double at, double turned, const NodeVectors& shake) {
  const double stretch = at < 0.6 ? 1 + 0.5 * at : at < 0.8 ? 1.3 - 1.5 * (at - 0.6) : 1;
  const Eigen::AngleAxisd turn(turned * at, Eigen::Vector3d(1, 2, 3).normalized());
  return turn.toRotationMatrix() * (Eigen::Vector3d(stretch, 1 - 0.2 * at, 1).asDiagonal() * X) +
         std::sin(20 * at) * shake;
}

/// The force that came with a bound is the body's own, to the last bit.
inline void expectForce(const Body& body, const NodeVectors& x, const StepEvaluation& evaluation,
                        const std::string& what) {
  NodeVectors expected;
  Body::Workspace workspace;
  body.internalForce(x, expected, workspace);
  EXPECT_TRUE(evaluation.internalForce == expected) << what;
}

/// Ways to hold a body: nothing, a face, single components here and there.
enum class Hold { nothing, face, components };
inline std::string holdName(Hold hold) {
  return hold == Hold::nothing ? "free" : hold == Hold::face ? "face held" : "components held";
}
inline void holdBody(Body& body, Hold hold, std::uint64_t seed = 7) {
  Random random(seed);
  const double edge = body.mesh().X.row(0).minCoeff() + 1e-9;
  for (std::int32_t i = 0; i < body.nodeCount(); ++i) {
    if (hold == Hold::face && body.mesh().X(0, i) < edge) body.constraints().fix(i);
    if (hold == Hold::components)
      for (int c = 0; c < 3; ++c)
        if (random.index(5) == 0) body.constraints().move(i, c, random.index(2) * 0.1);
  }
}

/// Random velocities, mass by mass alike, that leave constrained components alone.
inline NodeVectors randomVelocities(const Body& body, double scale, std::uint64_t seed) {
  Random random(seed);
  NodeVectors v = random.nodeVectors(body.nodeCount(), scale);
  body.constraints().clearConstrained(v);
  return v;
}

}  // namespace ringwatch::test
