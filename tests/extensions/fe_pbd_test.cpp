// Position-based tetrahedra: their passes against dense solves, and the handler's stability, momenta and long runs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include <Eigen/Geometry>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/base/error.h>
#include <ringwatch/extensions/fe_pbd/fe_pbd.h>
#include <tests/handlers/handler_cases.h>

namespace ringwatch {
namespace {

using test::criticalStepOf;
using test::everyElement;
using test::flat;
using ::testing::HasSubstr;

Mesh oneTetrahedron(const Eigen::Matrix<double, 3, 4>& corners) {
  Mesh mesh;
  mesh.X = corners;
  MeshBlock block{test::gridMesh("tet4", {1, 1, 1}, {1, 1, 1}).blocks[0].type, {0, 1, 2, 3}, {1}};
  mesh.blocks.push_back(block);
  return mesh;
}
const Eigen::Matrix<double, 3, 4> regularCorners =
    (Eigen::Matrix<double, 3, 4>() << 1, -1, 1, -1, 1, 1, -1, -1, 1, -1, -1, 1).finished() * 0.01;
/// Two crossing edges of 2 cm, 0.2 mm apart.
const Eigen::Matrix<double, 3, 4> sliverCorners =
    (Eigen::Matrix<double, 3, 4>() << -0.01, 0, 0.01, 0, 0, -0.011, 0, 0.009, 0, 2e-4, 0, 2e-4).finished();
Body bodyOf(const Eigen::Matrix<double, 3, 4>& corners, double nu = test::poisson) {
  return Body(oneTetrahedron(corners), makeMaterial("corotational", test::young, nu, test::density),
              {{}, Lumping::rowSum, 1});
}

/// Positions that one relaxation leads to from predicted positions x.
NodeVectors relaxed(RelaxedTetrahedra& tetrahedra, const NodeVectors& x, double h) {
  NodeVectors a = NodeVectors::Zero(3, x.cols());
  EXPECT_TRUE(tetrahedra.relax(x, NodeVectors::Zero(3, x.cols()), a));
  return x + h * h * a;
}

/// The matrix of a relaxation about rest, over free degrees of freedom and in the metric of the mass.
Eigen::MatrixXd matrixOf(const Body& body, RelaxedTetrahedra& tetrahedra, double h) {
  constexpr double unit = 1e-7;
  std::vector<Eigen::Index> free;
  for (Eigen::Index d = 0; d < 3 * body.nodeCount(); ++d)
    if (!body.constraints().isConstrained(d / 3, static_cast<int>(d % 3))) free.push_back(d);
  Eigen::MatrixXd result(free.size(), free.size());
  for (std::size_t k = 0; k < free.size(); ++k) {
    NodeVectors plus = body.mesh().X, minus = plus;
    plus.data()[free[k]] += unit;
    minus.data()[free[k]] -= unit;
    const NodeVectors column = (relaxed(tetrahedra, plus, h) - relaxed(tetrahedra, minus, h)) / (2 * unit);
    for (std::size_t i = 0; i < free.size(); ++i)
      result(i, k) =
          column.data()[free[i]] * std::sqrt(body.lumpedMass()[free[i] / 3] / body.lumpedMass()[free[k] / 3]);
  }
  return result;
}
/// (I + h² M^-½ K M^-½)⁻¹ likewise.
Eigen::MatrixXd implicitEuler(const Body& body, double h) {
  const Eigen::MatrixXd K(body.assembleTangent(body.mesh().X));
  std::vector<Eigen::Index> free;
  for (Eigen::Index d = 0; d < 3 * body.nodeCount(); ++d)
    if (!body.constraints().isConstrained(d / 3, static_cast<int>(d % 3))) free.push_back(d);
  Eigen::MatrixXd A = Eigen::MatrixXd::Identity(free.size(), free.size());
  for (std::size_t i = 0; i < free.size(); ++i)
    for (std::size_t k = 0; k < free.size(); ++k)
      A(i, k) +=
          h * h * K(free[i], free[k]) / std::sqrt(body.lumpedMass()[free[i] / 3] * body.lumpedMass()[free[k] / 3]);
  return test::solve(A, Eigen::MatrixXd::Identity(A.rows(), A.cols()));
}
double leastEigenvalue(const Eigen::MatrixXd& A) {
  const Eigen::MatrixXd symmetric = 0.5 * (A + A.transpose());
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric, Eigen::EigenvaluesOnly).eigenvalues()[0];
}

std::unique_ptr<Handler> pbd(Body& body, double h, std::string_view variant = "auto", int passes = 3,
                             std::string_view base = "symplectic-euler") {
  HandlerOptions options;
  options.own.set("variant", variant);
  if (variant != "rigid") options.own.set("passes", passes);
  auto handler = makeHandler("fe-pbd", body, makeIntegrator(base), options);
  handler->prepare(body.mesh().X, h);
  return handler;
}

TEST(Relaxation, HasTheAlphaOfTheDenseEigenvalue) {
  for (const auto& corners : {regularCorners, sliverCorners})
    for (const double nu : {0.0, 0.3, 0.499})
      for (const double h : {1e-5, 1e-3}) {
        const Body body = bodyOf(corners, nu);
        const double lambda = test::denseHighest(body, body.mesh().X);
        for (const GoalShape goal : {GoalShape::rigid, GoalShape::linear}) {
          const RelaxedTetrahedra one(body, everyElement(body), h, goal, 1);
          EXPECT_NEAR(one.alpha()[0], 1 - 1 / (1 + h * h * lambda), 1e-9) << nu << " " << h;
        }
      }
}

// A regular tetrahedron keeps its shape: E = e I before and E' = e / (1 + h² (2 mu + 3 lambda) V eta) I after.
TEST(Relaxation, OfAUniformStretchIsImplicitEulersAtAnyStrain) {
  const Body body = bodyOf(regularCorners);
  const Lame lame = body.blocks()[0]->material().restModuli();
  const double edge2 = 8e-4, mass = body.lumpedMass()[0], eta = 1 / (mass * edge2 / 2);
  for (const double e : {-0.5, 0.3, 2.0}) {
    const double h = 2e-3, left = e / (1 + h * h * (2 * lame.mu + 3 * lame.lambda) * body.volume() * eta);
    for (const int passes : {1, 2, 5}) {  // the first visit is exact for an element alone
      RelaxedTetrahedra one(body, everyElement(body), h, GoalShape::linear, passes);
      const NodeVectors x = relaxed(one, (1 + e) * body.mesh().X, h);
      EXPECT_LE((x - (1 + left) * body.mesh().X).norm(), 1e-12 * body.mesh().X.norm()) << e << " " << passes;
    }
  }
}

TEST(Relaxation, OfOneElementIsImplicitEulers) {
  for (const auto& corners : {regularCorners, sliverCorners})
    for (const int fixed : {0, 1, 2}) {
      Body body = bodyOf(corners);
      for (int n = 0; n < fixed; ++n) body.constraints().fix(n);
      const double h = 1e-3;
      RelaxedTetrahedra one(body, everyElement(body), h, GoalShape::linear, 1);
      EXPECT_LE((matrixOf(body, one, h) - implicitEuler(body, h)).norm(), 1e-5) << fixed;
    }
}

struct MatrixCase {
  GoalShape goal;
  int passes;
  bool clamped;
};
class RelaxationMatrix : public ::testing::TestWithParam<MatrixCase> {};
INSTANTIATE_TEST_SUITE_P(
    All, RelaxationMatrix,
    ::testing::Values(MatrixCase{GoalShape::rigid, 1, true}, MatrixCase{GoalShape::linear, 1, true},
                      MatrixCase{GoalShape::linear, 1, false}, MatrixCase{GoalShape::linear, 2, true},
                      MatrixCase{GoalShape::linear, 3, true}, MatrixCase{GoalShape::linear, 6, false}),
    [](const auto& test) {
      const MatrixCase& c = test.param;
      return (c.goal == GoalShape::rigid ? "rigid_" : "linear_") + std::to_string(c.passes) +
             (c.clamped ? "_clamped" : "_free");
    });

// (I + h² M⁻¹K)⁻¹ ≼ P ≼ I and P symmetric: all that the proof of stability uses. Rigid goals are only 0 ≼ P ≼ I.
TEST_P(RelaxationMatrix, LiesBetweenImplicitEulersAndTheIdentity) {
  const MatrixCase c = GetParam();
  Mesh mesh = test::gridMesh("tet4", {3, 2, 1}, {0.06, 0.04, 0.02});
  mesh.X(0, test::nodeNearest(mesh, {0.02, 0.02, 0})) += 0.019;
  Body body(mesh, makeMaterial("corotational", test::young, test::poisson, test::density), {{}, Lumping::rowSum, 1});
  if (c.clamped) {
    for (const std::int32_t n : body.mesh().nodeSets.at("x-min")) body.constraints().fix(n);
    body.constraints().fix(test::nodeNearest(mesh, {0.06, 0, 0}), 1);
  }
  const double h = 4 * criticalStepOf(body);
  RelaxedTetrahedra all(body, everyElement(body), h, c.goal, c.passes);
  const Eigen::MatrixXd P = matrixOf(body, all, h);
  const auto I = Eigen::MatrixXd::Identity(P.rows(), P.cols());
  EXPECT_LE((P - P.transpose()).norm(), 1e-5 * P.norm());
  EXPECT_GE(leastEigenvalue(I - P), -1e-6);
  EXPECT_GE(leastEigenvalue(c.goal == GoalShape::rigid ? P : Eigen::MatrixXd(P - implicitEuler(body, h))), -1e-6);
}

TEST(Relaxation, ConvergesToImplicitEulerWithItsPasses) {
  Body body = test::sliverBody("corotational", 0.9);
  const double h = 2 * criticalStepOf(body);
  test::Random random(5);
  const NodeVectors u = random.nodeVectors(body.nodeCount(), 1e-6);
  NodeVectors start = body.mesh().X;
  for (std::int32_t i = 0; i < body.nodeCount(); ++i)
    if (body.constraints().freeComponents(i) > 0) start.col(i) += u.col(i);
  const Eigen::MatrixXd K(body.assembleTangent(body.mesh().X));
  Eigen::MatrixXd A = h * h * K;
  Eigen::VectorXd right = flat(start - body.mesh().X);
  for (Eigen::Index d = 0; d < A.rows(); ++d) {
    A(d, d) += body.lumpedMass()[d / 3];
    right[d] *= body.lumpedMass()[d / 3];
    if (body.constraints().freeComponents(d / 3) == 0) {
      A.row(d).setZero();
      A.col(d).setZero();
      A(d, d) = 1;
    }
  }
  const Eigen::VectorXd exact = test::solve(A, right);
  double before = 1;
  for (const int passes : {1, 3, 9, 31}) {
    RelaxedTetrahedra all(body, everyElement(body), h, GoalShape::linear, passes);
    const double error = (flat(relaxed(all, start, h) - body.mesh().X) - exact).norm() / exact.norm();
    EXPECT_LT(error, 0.8 * before) << passes;
    before = error;
  }
  EXPECT_LT(before, 0.01);
}

// A body at rest anywhere, in any orientation, moves on as it is.
TEST(FePbd, LeavesRigidMotionAlone) {
  for (const char* variant : {"linear", "rigid"})
    for (const char* base : {"symplectic-euler", "verlet"}) {
      Body body = test::sliverBody("corotational", 0.98, false);
      const double h = 4 * criticalStepOf(body);
      const auto handler = pbd(body, h, variant, 3, base);
      ASSERT_FALSE(handler->elements().empty());
      BodySystem system(body);
      const Eigen::Matrix3d Q(Eigen::AngleAxisd(2.1, Eigen::Vector3d(1, -2, 0.5).normalized()));
      const Eigen::Vector3d shift(0.3, -0.2, 0.1), v(0.5, 0.1, -0.4);
      State state = system.initialState();
      state.x = (Q * body.mesh().X).colwise() + shift;
      state.v.colwise() = v;
      const NodeVectors x = state.x;
      for (int i = 0; i < 100; ++i) ASSERT_TRUE(handler->step(system, state, h).done);
      EXPECT_LE((state.x - (x.colwise() + 100 * h * v)).cwiseAbs().maxCoeff(), 1e-10) << variant << " " << base;
    }
}

class PositionBasedStability : public ::testing::TestWithParam<std::pair<const char*, int>> {};
INSTANTIATE_TEST_SUITE_P(All, PositionBasedStability,
                         ::testing::Values(std::pair("rigid", 1), std::pair("linear", 1), std::pair("linear", 4)),
                         [](const auto& test) { return test.param.first + ("_" + std::to_string(test.param.second)); });

// The amplification matrix about rest, column by column from the program's own steps.
TEST_P(PositionBasedStability, NoModeGrowsAtManyTimesTheCriticalStep) {
  Body body = test::sliverBody("corotational", 0.98);
  const double h = 4 * criticalStepOf(body);
  const auto handler = pbd(body, h, GetParam().first, GetParam().second);
  EXPECT_LT(handler->elements().size(), body.mesh().elementCount());
  EXPECT_LE(test::spectralRadius(body, *handler, h, 1e-7), 1 + 1e-5);
  const auto plain = makeIntegrator("symplectic-euler");
  EXPECT_GT(test::spectralRadius(body, *plain, h, 1e-7), 2);  // so the test can fail
}

TEST(FePbd, KeepsBothMomentaAndBoundsTheEnergy) {
  for (const char* variant : {"linear", "rigid"}) {
    Body body = test::sliverBody("corotational", 0.98, false);
    const double h = 4 * criticalStepOf(body);
    const auto handler = pbd(body, h, variant);
    const test::LongRun run = test::longRun(*handler, body, h, 4000);
    ASSERT_EQ(run.steps, 4000);
    // The body's energy, not that of the softer elements that rigid goals make.
    EXPECT_LT(run.highestEnergy, variant == std::string("linear") ? 1.02 : 1.5) << variant;
    EXPECT_LE(run.momentumDrift, 1e-11) << variant;
    EXPECT_LE(run.angularDrift, 1e-9) << variant;
  }
}

double errorOf(const char* variant, int passes, double nu = test::poisson) {
  const test::Swing swing{.nu = nu};
  return test::swingError(swing, 0.05, 3 * criticalStepOf(swing.body()),
                          [&](Body& body, double h) { return pbd(body, h, variant, passes, "verlet"); });
}

// What three passes leave is implicit Euler's own error; one is softer and damps less.
TEST(FePbd, FollowsTheMotionBetterWithLinearGoals) {
  const double rigid = errorOf("rigid", 1), one = errorOf("linear", 1), three = errorOf("linear", 3);
  EXPECT_LT(rigid, 0.1);
  EXPECT_LT(std::max(one, three), 0.4 * rigid);
  EXPECT_LT(std::max(one, three), 0.01);
}

TEST(FePbd, StandsNearlyIncompressibleBodies) { EXPECT_LT(errorOf("linear", 3, 0.499), 0.05); }

TEST(FePbd, HoldsAnIsolatedSliverWithAnyNodesFixed) {
  for (const char* variant : {"linear", "rigid"})
    for (const int fixed : {0, 1, 2, 3, 4}) {
      Body body = bodyOf(sliverCorners);
      for (int n = 0; n < fixed; ++n) body.constraints().fix(n);
      if (fixed == 3) body.constraints().move(3, 2, 0.1);
      body.addBodyForce({0, 0.2, -1});
      // With nothing free nothing is critical, and the handler is the plain scheme.
      const auto handler = pbd(body, 1e-3, variant);
      BodySystem system(body);
      State state = system.initialState();
      for (int i = 0; i < 500; ++i) ASSERT_TRUE(handler->step(system, state, 1e-3).done) << variant << fixed;
      ASSERT_TRUE(state.x.allFinite());
      for (int n = 0; n < fixed; ++n) EXPECT_EQ(state.x.col(n), body.mesh().X.col(n));
      if (fixed == 3) {
        EXPECT_NEAR(state.x(2, 3), body.mesh().X(2, 3) + 0.05, 1e-12);
      }
      if (fixed == 0) {
        for (int a = 0; a < 4; ++a)
          for (int b = 0; b < a; ++b)
            EXPECT_NEAR((state.x.col(a) - state.x.col(b)).norm(), (body.mesh().X.col(a) - body.mesh().X.col(b)).norm(),
                        1e-9);
      }
    }
}

TEST(FePbd, TurnsAnInvertedElementBack) {
  for (const char* variant : {"linear", "rigid"})
    for (const auto& corners : {regularCorners, sliverCorners}) {
      Body body = bodyOf(corners);
      const double h = 20 * criticalStepOf(body);
      const auto handler = pbd(body, h, variant);
      BodySystem system(body);
      State state = system.initialState();
      state.x.col(3) -= 1.5 * (state.x.col(3) - state.x.leftCols<3>().rowwise().mean());
      ASSERT_LT(body.leastDeterminant(state.x).value, 0);
      for (int i = 0; i < 2000; ++i) ASSERT_TRUE(handler->step(system, state, h).done);
      EXPECT_NEAR(body.leastDeterminant(state.x).value, 1, 0.01) << variant;
    }
}

// On a line the rotation is not unique: any will do, as long as the forces are finite.
TEST(FePbd, StandsFlattenedElements) {
  for (const char* variant : {"linear", "rigid"})
    for (const Eigen::Vector3d& keep : {Eigen::Vector3d(1, 1, 0), Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(0, 0, 0)}) {
      Body body = bodyOf(sliverCorners);
      const double h = 20 * criticalStepOf(body);
      const auto handler = pbd(body, h, variant);
      BodySystem system(body);
      State state = system.initialState();
      state.x = keep.asDiagonal() * state.x;
      for (int i = 0; i < 1000; ++i) ASSERT_TRUE(handler->step(system, state, h).done);
      EXPECT_TRUE(state.x.allFinite());
      EXPECT_LE(state.x.cwiseAbs().maxCoeff(), 0.1);
    }
}

TEST(FePbd, SurvivesAStepThatMakesEverythingCritical) {
  for (const char* variant : {"linear", "rigid"}) {
    Body body = test::sliverBody("corotational", 0.98);
    body.addBodyForce({0, 0, -1});
    const double h = 100 * criticalStepOf(body);
    const auto handler = pbd(body, h, variant);
    EXPECT_EQ(handler->elements().size(), body.mesh().elementCount());
    BodySystem system(body);
    State state = system.initialState();
    for (int i = 0; i < 500; ++i) ASSERT_TRUE(handler->step(system, state, h).done);
    EXPECT_TRUE(state.x.allFinite());
    // Far softer than it is, so it sags, but held by its fixed end.
    EXPECT_LT((state.x - body.mesh().X).cwiseAbs().maxCoeff(), 0.5 * std::pow(500 * h, 2)) << variant;
  }
}

TEST(FePbd, DoesNotPassNotANumberOn) {
  Body body = test::sliverBody("stvk", 0.98);
  const double h = 4 * criticalStepOf(body);
  for (const char* base : {"symplectic-euler", "verlet"}) {
    const auto handler = pbd(body, h, "auto", 3, base);
    BodySystem system(body);
    State state = system.initialState();
    state.x(0, body.blocks()[0]->nodesOf(handler->elements().front().element)[0]) = std::nan("");
    const NodeVectors v = state.v;
    const StepStatus status = handler->step(system, state, h);
    EXPECT_FALSE(status.done);
    EXPECT_THAT(status.reason, HasSubstr("finite"));
    EXPECT_EQ(state.v, v);
    EXPECT_EQ(state.time, 0);
  }
}

}  // namespace
}  // namespace ringwatch
