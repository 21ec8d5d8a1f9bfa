#pragma once
#include <cmath>
#include <string>
#include <vector>

#include <Eigen/Eigenvalues>

#include <ringwatch/body/body.h>
#include <ringwatch/handlers/selection.h>
#include <ringwatch/integrators/body_system.h>
#include <tests/support/body_cases.h>

namespace ringwatch::test {

/// A bar of 240 tetrahedra with one inner node pulled by `flatness` of the way to its neighbour along x: flat
/// tetrahedra all around it, none inverted.
inline Mesh sliverBar(double flatness = 0.95) {
  Mesh mesh = gridMesh("tet4", {10, 2, 2}, {0.2, 0.04, 0.04});
  const auto node = [](int i, int j, int k) { return i + 11 * (j + 3 * k); };
  mesh.X(0, node(5, 1, 1)) += flatness * (mesh.X(0, node(6, 1, 1)) - mesh.X(0, node(5, 1, 1)));
  return mesh;
}
inline Body sliverBody(std::string_view law = "stvk", double flatness = 0.95, bool clamped = true) {
  Body body(sliverBar(flatness), makeMaterial(law, young, poisson, density), {{}, Lumping::rowSum, 1});
  if (clamped)
    for (const std::int32_t n : body.mesh().nodeSets.at("x-min")) body.constraints().fix(n);
  return body;
}

/// The highest eigenvalue of mass⁻¹ K over free degrees of freedom by a dense solver: independent of every bound.
inline double denseHighest(const Body& body, const Eigen::MatrixXd& K, const Eigen::VectorXd& mass) {
  std::vector<Eigen::Index> free;
  for (std::int32_t i = 0; i < body.nodeCount(); ++i)
    for (int c = 0; c < 3; ++c)
      if (!body.constraints().isConstrained(i, c)) free.push_back(3 * i + c);
  Eigen::MatrixXd A(free.size(), free.size());
  for (std::size_t i = 0; i < free.size(); ++i)
    for (std::size_t j = 0; j < free.size(); ++j)
      A(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
          K(free[i], free[j]) / std::sqrt(mass[free[i] / 3] * mass[free[j] / 3]);
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(A, Eigen::EigenvaluesOnly).eigenvalues().tail<1>()[0];
}
inline double denseHighest(const Body& body, const NodeVectors& x) {
  return denseHighest(body, Eigen::MatrixXd(body.assembleTangent(x)), body.lumpedMass());
}

inline double criticalStepOf(const Body& body) { return 2 / std::sqrt(denseHighest(body, body.mesh().X)); }

/// Of the amplification matrix of a step about rest, column by column from the integrator's own steps; unit: m.
inline double spectralRadius(const Body& body, Integrator& integrator, double h, double unit) {
  BodySystem system(body);
  std::vector<Eigen::Index> free;
  for (Eigen::Index d = 0; d < 3 * body.nodeCount(); ++d)
    if (!body.constraints().isConstrained(static_cast<std::int32_t>(d / 3), static_cast<int>(d % 3))) free.push_back(d);
  const auto n = static_cast<Eigen::Index>(free.size());
  Eigen::MatrixXd G(2 * n, 2 * n);
  for (Eigen::Index k = 0; k < 2 * n; ++k) {
    State state{0, body.mesh().X, NodeVectors::Zero(3, body.nodeCount())};
    (k < n ? state.x : state.v).data()[free[static_cast<std::size_t>(k % n)]] += k < n ? unit : unit / h;
    integrator.step(system, state, h);
    for (Eigen::Index i = 0; i < n; ++i) {
      const Eigen::Index d = free[static_cast<std::size_t>(i)];
      G(i, k) = (state.x.data()[d] - body.mesh().X.data()[d]) / unit;
      G(n + i, k) = state.v.data()[d] * h / unit;
    }
  }
  return G.eigenvalues().cwiseAbs().maxCoeff();
}

/// The stiffness of some elements only.
inline Eigen::MatrixXd stiffnessOf(const Body& body, const NodeVectors& x, const ElementFlags& flags, bool wanted) {
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(3 * body.nodeCount(), 3 * body.nodeCount());
  for (std::size_t b = 0; b < flags.size(); ++b)
    for (std::size_t e = 0; e < flags[b].size(); ++e) {
      if (flags[b][e] != wanted) continue;
      const ElementRef ref{static_cast<std::int32_t>(b), static_cast<std::int32_t>(e)};
      const Eigen::MatrixXd own = body.elementTangent(ref, x);
      const auto nodes = body.blocks()[b]->nodesOf(ref.element);
      for (std::size_t i = 0; i < nodes.size(); ++i)
        for (std::size_t j = 0; j < nodes.size(); ++j)
          K.block<3, 3>(3 * nodes[i], 3 * nodes[j]) +=
              own.block<3, 3>(static_cast<Eigen::Index>(3 * i), static_cast<Eigen::Index>(3 * j));
    }
  return K;
}

}  // namespace ringwatch::test
