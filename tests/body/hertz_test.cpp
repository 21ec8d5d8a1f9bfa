// Hertz: a rigid ball pressed into an elastic half-space, F = 4/3 E/(1 - ν²) √R d^1.5.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include <ringwatch/base/error.h>
#include <ringwatch/body/body.h>
#include <ringwatch/body/discrete_forces.h>
#include <tests/support/meshes.h>

namespace ringwatch {
namespace {

using Eigen::Vector3d;

constexpr double hertzYoung = 1e6, hertzPoisson = 0.3, hertzRadius = 1, hertzCell = 0.005;
constexpr double hertz(double d) {
  return 4.0 / 3 * hertzYoung / (1 - hertzPoisson * hertzPoisson) * std::sqrt(hertzRadius * d) * d;
}

/// 0, h, 2h … and from `uniform` cells on each longer than the one before.
double graded(int i, int uniform, double h, double ratio) {
  if (i <= uniform) return i * h;
  return uniform * h + h * ratio * (std::pow(ratio, i - uniform) - 1) / (ratio - 1);
}

/// Positions at rest: Newton's method, its steps by conjugate gradients with the diagonal as preconditioner. What
/// touches at one step is where contact acts at the next.
NodeVectors settled(const Body& body, const NodeVectors& start) {
  NodeVectors x = start, f, Kp;
  Body::Workspace workspace;
  double scale = 0;
  for (int newton = 0; newton < 40; ++newton) {
    body.internalForce(x, f, workspace);
    body.constraints().clearConstrained(f);
    scale = std::max(scale, f.norm());
    if (f.norm() <= 1e-6 * scale) return x;
    const Eigen::SparseMatrix<double> K = body.assembleTangent(x);
    const NodeVectors inverse = K.diagonal().cwiseInverse().reshaped(3, x.cols());
    NodeVectors u = NodeVectors::Zero(3, x.cols()), r = -f, z = inverse.cwiseProduct(r), p = z;
    double rz = r.cwiseProduct(z).sum();
    while (r.norm() > 1e-3 * f.norm()) {
      Kp = (K * p.reshaped()).reshaped(3, x.cols());
      body.constraints().clearConstrained(Kp);
      const double alpha = rz / p.cwiseProduct(Kp).sum();
      u += alpha * p;
      r -= alpha * Kp;
      z = inverse.cwiseProduct(r);
      const double next = r.cwiseProduct(z).sum();
      p = z + (next / rz) * p;
      rz = next;
    }
    x += u;
  }
  ADD_FAILURE() << "no rest after 40 steps of Newton's method";
  return x;
}

/// A quarter of a block 6.5 m wide and deep, fine at the origin, held at its far sides and by symmetry.
Body quarterBlock() {
  constexpr int uniform = 9, cells = 24;
  Mesh mesh = test::gridMesh("hex8", {cells, cells, cells}, {cells, cells, cells});
  for (Eigen::Index i = 0; i < mesh.X.cols(); ++i) {
    Vector3d at;
    for (int c = 0; c < 3; ++c) at[c] = graded(static_cast<int>(std::lround(mesh.X(c, i))), uniform, hertzCell, 1.5);
    // The grid upside down; two axes are exchanged, which leaves elements their handedness.
    mesh.X.col(i) = Vector3d(at[1], at[0], -at[2]);
  }
  const double depth = -mesh.X.row(2).minCoeff();
  Body body(std::move(mesh), makeMaterial("linear", hertzYoung, hertzPoisson, 1000), {{}, Lumping::rowSum, 1});
  const NodeVectors& X = body.mesh().X;
  const double far = X.row(0).maxCoeff() * (1 - 1e-9);
  for (std::int32_t i = 0; i < body.nodeCount(); ++i) {
    if (X(0, i) > far || X(1, i) > far || X(2, i) < -depth * (1 - 1e-9)) body.constraints().fix(i);
    if (X(0, i) == 0) body.constraints().fix(i, 0);
    if (X(1, i) == 0) body.constraints().fix(i, 1);
  }
  return body;
}

TEST(Hertz, ABallPressedOnAHalfSpace) {
  Body body = quarterBlock();
  const NodeVectors& X = body.mesh().X;
  std::vector<std::int32_t> top;
  for (std::int32_t i = 0; i < body.nodeCount(); ++i)
    if (X(2, i) == 0 && std::hypot(X(0, i), X(1, i)) < 0.2) top.push_back(i);
  // Of a node alone, thirty times what its element resists with.
  const double penalty = 30 * hertzYoung * hertzCell;
  DiscreteForces forces(body.nodeCount());
  PenaltyContact contact;
  contact.obstacle = forces.add(sphereObstacle({0, 0, hertzRadius}, hertzRadius, false));
  contact.nodes = top;
  for (const std::int32_t node : top) {
    // A penalty by area: nodes on planes of symmetry have the half and the quarter of it.
    contact.penalty.push_back(penalty * (X(0, node) == 0 ? 0.5 : 1) * (X(1, node) == 0 ? 0.5 : 1));
    contact.damping.push_back(0);
  }
  forces.add(contact);
  body.setDiscreteForces(std::move(forces));
  NodeVectors x = X;
  for (const double radius : {5.0, 6.0}) {
    const double a = radius * hertzCell, d = a * a / hertzRadius;
    body.discreteForces()->place(0, {0, 0, -d}, Vector3d::Zero());
    x = settled(body, x);
    NodeVectors f = NodeVectors::Zero(3, x.cols());
    body.discreteForces()->addInternalForce(x, f);
    const double F = 4 * f.row(2).sum();  // of the four quarters; what resists points up
    RecordProperty(joinText("over_hertz_", radius), joinText(F / hertz(d)));
    EXPECT_NEAR(F, hertz(d), 0.02 * hertz(d)) << radius;
  }
}

}  // namespace
}  // namespace ringwatch
