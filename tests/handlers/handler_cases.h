#pragma once
#include <algorithm>
#include <cmath>
#include <compare>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/body/body.h>
#include <ringwatch/handlers/handler.h>
#include <ringwatch/handlers/selection/selection.h>
#include <ringwatch/integrators/body_system.h>
#include <tests/support/body_cases.h>
#include <tests/support/dense.h>

namespace ringwatch::test {

/// A number as part of a test's name: "0.3" is "0_3", "1e-12" is "1em12".
inline std::string testName(double number) {
  std::ostringstream text;
  text << number;
  std::string name = text.str();
  std::replace(name.begin(), name.end(), '-', 'm');
  std::erase(name, '+');
  return testName(std::string_view(name));
}

/// A bar of 240 tetrahedra with one inner node pulled by `flatness` of the way to its neighbour along x: flat
/// tetrahedra all around it, none inverted.
inline Mesh sliverBar(double flatness = 0.95) {
  Mesh mesh = gridMesh("tet4", {10, 2, 2}, {0.2, 0.04, 0.04});
  const auto node = [](int i, int j, int k) { return i + 11 * (j + 3 * k); };
  mesh.X(0, node(5, 1, 1)) += flatness * (mesh.X(0, node(6, 1, 1)) - mesh.X(0, node(5, 1, 1)));
  return mesh;
}
inline Body sliverBody(std::string_view law = "stvk", double flatness = 0.95, bool clamped = true,
                       double nu = poisson) {
  Body body(sliverBar(flatness), makeMaterial(law, young, nu, density), {{}, Lumping::rowSum, 1});
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
      A(i, j) = K(free[i], free[j]) / std::sqrt(mass[free[i] / 3] * mass[free[j] / 3]);
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(A, Eigen::EigenvaluesOnly).eigenvalues().tail<1>()[0];
}
inline double denseHighest(const Body& body, const NodeVectors& x) {
  return denseHighest(body, Eigen::MatrixXd(body.assembleTangent(x)), body.lumpedMass());
}

/// All components of all nodes, one node after the other.
inline Eigen::VectorXd flat(const NodeVectors& v) { return Eigen::VectorXd::Map(v.data(), v.size()); }

inline std::vector<ElementRef> everyElement(const Body& body) {
  std::vector<ElementRef> all;
  for (std::size_t b = 0; b < body.blocks().size(); ++b)
    for (std::int32_t e = 0; e < body.blocks()[b]->elementCount(); ++e) all.push_back({b, e});
  return all;
}

inline double criticalStepOf(const Body& body) { return 2 / std::sqrt(denseHighest(body, body.mesh().X)); }

/// Positions after steps of h (s) from rest, m.
inline NodeVectors positionsAfter(Integrator& integrator, const Body& body, double h, int steps) {
  BodySystem system(body);
  State state = system.initialState();
  for (int i = 0; i < steps; ++i) {
    const StepStatus status = integrator.step(system, state, h);
    EXPECT_TRUE(status.done) << status.reason;
    if (!status.done) break;
  }
  return state.x;
}

/// A clamped bar of slivers that swings under its weight.
struct Swing {
  std::string law = "corotational";
  double nu = poisson, flatness = 0.95;
  auto operator<=>(const Swing&) const = default;
  Body body() const {
    Body made = sliverBody(law, flatness, true, nu);
    made.addBodyForce({0, 0, -2});
    return made;
  }
};
/// Error of the positions after `end` (s) by the handler that makeHandler(body, h) makes, in steps of about h (s),
/// against Verlet at a tenth of the critical step, over the displacement.
template <class MakeHandler>
double swingError(const Swing& swing, double end, double h, const MakeHandler& makeHandler) {
  Body body = swing.body();
  static std::map<std::pair<Swing, double>, NodeVectors> references;
  NodeVectors& reference = references[{swing, end}];
  if (reference.size() == 0) {
    const auto verlet = makeIntegrator("verlet");
    const auto steps = static_cast<int>(std::ceil(end / (0.1 * criticalStepOf(body))));
    reference = positionsAfter(*verlet, body, end / steps, steps);
  }
  const auto steps = static_cast<int>(std::lround(end / h));
  const auto handler = makeHandler(body, end / steps);
  EXPECT_FALSE(handler->elements().empty());
  return (positionsAfter(*handler, body, end / steps, steps) - reference).norm() / (reference - body.mesh().X).norm();
}

/// Of the amplification matrix of a step about rest, column by column from the integrator's own steps; unit: m.
inline double spectralRadius(const Body& body, Integrator& integrator, double h, double unit) {
  BodySystem system(body);
  std::vector<Eigen::Index> free;
  for (Eigen::Index d = 0; d < 3 * body.nodeCount(); ++d)
    if (!body.constraints().isConstrained(d / 3, static_cast<int>(d % 3))) free.push_back(d);
  const Eigen::Index n = free.size();
  Eigen::MatrixXd G(2 * n, 2 * n);
  for (Eigen::Index k = 0; k < 2 * n; ++k) {
    State state{0, body.mesh().X, NodeVectors::Zero(3, body.nodeCount())};
    (k < n ? state.x : state.v).data()[free[k % n]] += k < n ? unit : unit / h;
    integrator.step(system, state, h);
    for (Eigen::Index i = 0; i < n; ++i) {
      const Eigen::Index d = free[i];
      G(i, k) = (state.x.data()[d] - body.mesh().X.data()[d]) / unit;
      G(n + i, k) = state.v.data()[d] * h / unit;
    }
  }
  return spectralRadius(G);
}

/// The stiffness of some elements only.
inline Eigen::MatrixXd stiffnessOf(const Body& body, const NodeVectors& x, const ElementFlags& flags, bool wanted) {
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(3 * body.nodeCount(), 3 * body.nodeCount());
  for (std::size_t b = 0; b < flags.size(); ++b)
    for (std::size_t e = 0; e < flags[b].size(); ++e) {
      if (flags[b][e] != wanted) continue;
      const ElementRef ref{b, e};
      const Eigen::MatrixXd own = body.elementTangent(ref, x);
      const auto nodes = body.blocks()[b]->nodesOf(ref.element);
      for (std::size_t i = 0; i < nodes.size(); ++i)
        for (std::size_t j = 0; j < nodes.size(); ++j)
          K.block<3, 3>(3 * nodes[i], 3 * nodes[j]) +=
              own.block<3, 3>(static_cast<Eigen::Index>(3 * i), static_cast<Eigen::Index>(3 * j));
    }
  return K;
}

/// A gentle vibration on top of a spin about y: over some thousand steps the slivers turn round several times.
inline void spinAndVibrate(const Body& body, State& state) {
  const Eigen::Vector3d centre = body.mesh().X.rowwise().mean(), spin(0, 8, 0);
  for (std::int32_t i = 0; i < body.nodeCount(); ++i)
    state.v.col(i) =
        spin.cross(body.mesh().X.col(i) - centre) + Eigen::Vector3d(0, 0, 0.05 * std::sin(20 * state.x(0, i)));
}

/// What a free body keeps.
class ConservedQuantities {
 public:
  explicit ConservedQuantities(const Body& body) : body_(body) {}
  /// Strain and kinetic, J.
  double energy(const State& state) const {
    Body::Workspace workspace;
    return body_.energy(state.x, workspace) + 0.5 * (state.v.colwise().squaredNorm() * body_.lumpedMass()).value();
  }
  Eigen::Vector3d momentum(const State& state) const { return state.v * body_.lumpedMass(); }
  /// About the origin.
  Eigen::Vector3d angular(const State& state) const {
    Eigen::Vector3d L = Eigen::Vector3d::Zero();
    for (std::int32_t i = 0; i < body_.nodeCount(); ++i)
      L += body_.lumpedMass()[i] * state.x.col(i).cross(state.v.col(i));
    return L;
  }

 private:
  const Body& body_;
};

/// What a free body that spins and vibrates has lost after many handled steps.
struct LongRun {
  int steps = 0;                       ///< that the handler took
  double highestEnergy, energy;        ///< seen on the way, and at the end; over that of the start
  double momentumDrift, angularDrift;  ///< m/s, of the body's mean velocity; and over the angular momentum of the start
};
inline LongRun longRun(Handler& handler, Body& body, double h, int steps) {
  BodySystem system(body);
  State state = system.initialState();
  spinAndVibrate(body, state);
  const ConservedQuantities conserved(body);
  const double start = conserved.energy(state);
  const Eigen::Vector3d p = conserved.momentum(state), L = conserved.angular(state);
  LongRun run;
  double highest = start;
  while (run.steps < steps && handler.step(system, state, h).done)
    if (run.steps++ % 20 == 0) highest = std::max(highest, conserved.energy(state));
  run.highestEnergy = highest / start;
  run.energy = conserved.energy(state) / start;
  run.momentumDrift = (conserved.momentum(state) - p).norm() / body.totalMass();
  run.angularDrift = (conserved.angular(state) - L).norm() / L.norm();
  return run;
}

}  // namespace ringwatch::test
