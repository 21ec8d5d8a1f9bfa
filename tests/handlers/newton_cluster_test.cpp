// The nonlinear implicit step: its equation, its energy, laws that have none beyond inversion, and runs that linear
// steps lose.
#include <gtest/gtest.h>

#include <cmath>

#include <Eigen/Geometry>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/base/error.h>
#include <ringwatch/handlers/imex/imex.h>
#include <ringwatch/handlers/imex/newton_cluster.h>
#include <ringwatch/materials/registry.h>
#include <ringwatch/monitor/bounds/global_frequency.h>
#include <tests/handlers/handler_cases.h>

namespace ringwatch {
namespace {

using test::criticalStepOf;
using test::everyElement;
using test::flat;

class NewtonOfLaw : public ::testing::TestWithParam<std::string_view> {};
INSTANTIATE_TEST_SUITE_P(All, NewtonOfLaw,
                         ::testing::Values("linear", "stvk", "corotational", "neo-hookean", "stable-neo-hookean"),
                         [](const auto& test) { return test::testName(test.param); });

// M a = M ã - f(x + alpha h v + beta h² a), computed anew from forces of the whole body.
TEST_P(NewtonOfLaw, SolvesItsEquation) {
  Body body = test::sliverBody(GetParam());
  const std::int32_t moved = test::nodeNearest(body.mesh(), {0.118, 0.02, 0.02});
  body.constraints().move(moved, 1, 0.3);
  const double critical = criticalStepOf(body);
  Body::Workspace workspace;
  int tried = 0;
  for (const double alpha : {0.0, 0.1, 1.0})
    for (const double steps : {2.0, 20.0}) {
      const ImplicitScheme k{steps * critical, alpha};
      test::Random random(3);
      const NodeVectors x = body.mesh().X + random.nodeVectors(body.nodeCount(), 1e-5);
      NodeVectors v = random.nodeVectors(body.nodeCount(), 0.01);
      body.constraints().imposeVelocity(v);
      NodeVectors others = random.nodeVectors(body.nodeCount(), 1);
      body.constraints().clearConstrained(others);
      NodeVectors a = others;
      NewtonCluster cluster(body, everyElement(body), k, 1e-10, 2000);
      ASSERT_EQ(cluster.solve(x, a, v), NewtonCluster::Outcome::solved);
      NodeVectors before, after;
      body.internalForce(x, before, workspace);
      body.internalForce(x + alpha * k.h * v + k.w() * a, after, workspace);
      NodeVectors residual = -after, scale = before;
      for (std::int32_t i = 0; i < body.nodeCount(); ++i) {
        residual.col(i) += body.lumpedMass()[i] * (others.col(i) - a.col(i));
        for (int component = 0; component < 3; ++component)
          if (body.constraints().isConstrained(i, component)) {
            residual(component, i) = 0;
            EXPECT_EQ(a(component, i), 0);
          }
      }
      EXPECT_LE(residual.norm(), 1e-7 * scale.norm()) << alpha << ' ' << steps;
      ++tried;
    }
  EXPECT_EQ(tried, 6);
}

// With implicit Euler the end of the step is where the law was asked for its energy.
TEST(NewtonCluster, NeverInvertsALawThatHasNoEnergyThere) {
  Body body = test::sliverBody("neo-hookean", 0.98, false);
  const ImplicitScheme k{20 * criticalStepOf(body), 1};
  NewtonCluster cluster(body, everyElement(body), k, 1e-6, 2000);
  // Both ends of the bar fly through each other.
  NodeVectors x = body.mesh().X, v = NodeVectors::Zero(3, body.nodeCount());
  for (Eigen::Index i = 0; i < v.cols(); ++i) v(0, i) = x(0, i) < 0.1 ? 8 : -8;
  double least = 1, ballisticLeast = 1;
  for (int step = 0; step < 400; ++step) {
    ballisticLeast = std::min(ballisticLeast, body.leastDeterminant(x + k.h * v).value);
    NodeVectors a = NodeVectors::Zero(3, body.nodeCount());
    ASSERT_EQ(cluster.solve(x, a, v), NewtonCluster::Outcome::solved) << step;
    v += k.h * a;
    x += k.h * v;
    least = std::min(least, body.leastDeterminant(x).value);
  }
  EXPECT_GT(least, 0);
  EXPECT_LT(least, 0.5);           // it was compressed,
  EXPECT_LT(ballisticLeast, 0.0);  // and a step without forces inverts elements: the test can fail
}

TEST(NewtonCluster, TakesImplicitEulerWhereTheStepWouldInvert) {
  for (const double alpha : {0.0, 0.1}) {
    Body body = test::sliverBody("neo-hookean", 0.98, false);
    const ImplicitScheme k{20 * criticalStepOf(body), alpha};
    NewtonCluster cluster(body, everyElement(body), k, 1e-6, 2000);
    NodeVectors x = body.mesh().X, v = NodeVectors::Zero(3, body.nodeCount());
    for (Eigen::Index i = 0; i < v.cols(); ++i) v(0, i) = x(0, i) < 0.1 ? 8 : -8;
    std::int64_t eulerSteps = 0, stalls = 0;
    double worst = 0;
    for (int step = 0; step < 400; ++step) {
      NodeVectors a = NodeVectors::Zero(3, body.nodeCount());
      ASSERT_EQ(cluster.solve(x, a, v), NewtonCluster::Outcome::solved) << step;
      v += k.h * a;
      x += k.h * v;
      ASSERT_GT(body.leastDeterminant(x).value, 0) << step;
      // A step that is not implicit Euler's solves the equation of its own scheme, but where its search has ended since
      // nothing lowers the potential.
      if (cluster.eulerSteps() > eulerSteps || cluster.stalls() > stalls) {
        eulerSteps = cluster.eulerSteps();
        stalls = cluster.stalls();
        continue;
      }
      // Relative to what the equation leaves without a change of velocity, as the tolerance is.
      Body::Workspace workspace;
      NodeVectors force, atStart;
      const NodeVectors begin = x - k.h * v, before = v - k.h * a;
      body.internalForce(begin + alpha * k.h * before + k.w() * a, force, workspace);
      body.internalForce(begin, atStart, workspace);
      const NodeVectors inertia = a * body.lumpedMass().asDiagonal();
      const NodeVectors left = atStart - k.c() * before * body.lumpedMass().asDiagonal();
      worst = std::max(worst, (inertia + force).norm() / left.norm());
    }
    EXPECT_LE(worst, 1.5e-5);  // in the plain norm 5.8e-6, with the address sanitizer as without
    EXPECT_LE(stalls, 3);      // 1
    EXPECT_GT(eulerSteps, 0);
    EXPECT_LT(eulerSteps, 400);
  }
}

// A tangent is kept from step to step and turned with the cluster, and most searches end with a step by it at whose end
// nothing is evaluated: the equation holds there as well.
TEST(NewtonCluster, SolvesItsEquationByATangentThatIsKept) {
  for (const std::string_view law : {"stvk", "corotational", "stable-neo-hookean"}) {
    Body body = test::sliverBody(law, 0.98, false);
    const ImplicitScheme k{5 * criticalStepOf(body), 0.1};
    NewtonCluster cluster(body, everyElement(body), k, 5e-4, 200);
    const Eigen::Vector3d centre(0.1, 0.02, 0.02);
    NodeVectors x = body.mesh().X, v(3, body.nodeCount());
    for (Eigen::Index i = 0; i < v.cols(); ++i) v.col(i) = Eigen::Vector3d(0, 5, 10).cross(x.col(i) - centre);
    Body::Workspace workspace;
    NodeVectors force;
    double worst = 0;
    constexpr int steps = 300;
    for (int step = 0; step < steps; ++step) {
      NodeVectors a = NodeVectors::Zero(3, body.nodeCount());
      ASSERT_EQ(cluster.solve(x, a, v), NewtonCluster::Outcome::solved) << step;
      body.internalForce(x + 0.1 * k.h * v + k.w() * a, force, workspace);
      const NodeVectors inertia = a * body.lumpedMass().asDiagonal();
      const NodeVectors start = (a + k.c() * v) * body.lumpedMass().asDiagonal();
      worst = std::max(worst, (inertia + force).norm() / start.norm());
      v += k.h * a;
      x += k.h * v;
    }
    // By the norm of the forces, which is not the one that the tolerance is for.
    EXPECT_LE(worst, 0.015) << law;
    EXPECT_LE(cluster.iterations(), 1.2 * steps) << law;
  }
}

// More than 2048 nodes: all threads share the cluster.
TEST(NewtonCluster, GivesTheSameBitsForAnyNumberOfThreadsInALargeCluster) {
  BarOptions bar;
  bar.cells = {20, 12, 12};
  bar.size = {0.2, 0.12, 0.12};
  bar.split = 6;
  bar.jitter = 0.2;
  NodeVectors ends[2];
  for (int k = 0; k < 2; ++k) {
    const Body body(generateBar(bar), makeMaterial("stvk", test::young, test::poisson, test::density),
                    {{}, Lumping::rowSum, k == 0 ? 1 : 3});
    const ImplicitScheme scheme{8 / std::sqrt(globalFrequency(body, body.mesh().X, 1e-3).lambda), 0.1};
    NewtonCluster cluster(body, everyElement(body), scheme, 5e-4, 200);
    ASSERT_GT(cluster.nodes().size(), 2048U);
    EXPECT_EQ(cluster.threads(), body.threads());
    NodeVectors x = body.mesh().X, v(3, body.nodeCount());
    for (Eigen::Index i = 0; i < v.cols(); ++i) v.col(i) = Eigen::Vector3d(0, 5, 10).cross(x.col(i));
    for (int step = 0; step < 10; ++step) {
      NodeVectors a = NodeVectors::Zero(3, body.nodeCount());
      ASSERT_EQ(cluster.solve(x, a, v), NewtonCluster::Outcome::solved) << step;
      v += scheme.h * a;
      x += scheme.h * v;
    }
    EXPECT_GT(cluster.products(), 20);
    ends[k] = x;
  }
  EXPECT_EQ(ends[0], ends[1]);
}

TEST(NewtonCluster, RefusesASystemWithDamping) {
  Body body = test::sliverBody("corotational", 0.95);
  auto handler = makeHandler("imex", body, makeIntegrator("symplectic-euler"), {});
  const double h = 3 * criticalStepOf(body);
  handler->prepare(body.mesh().X, h);
  ASSERT_FALSE(handler->elements().empty());
  BodySystem system(body, {1, 0});
  State state = system.initialState();
  EXPECT_THROW(handler->step(system, state, h), InputError);
}

TEST(NewtonCluster, SaysWhereALawHasNoEnergy) {
  Body body = test::sliverBody("neo-hookean");
  NodeVectors x = body.mesh().X;
  x.row(0) *= -1;
  NodeVectors a = NodeVectors::Ones(3, body.nodeCount());
  const NodeVectors v = NodeVectors::Zero(3, body.nodeCount()), before = a;
  NewtonCluster cluster(body, everyElement(body), {1e-3, 0}, 1e-6, 200);
  EXPECT_EQ(cluster.solve(x, a, v), NewtonCluster::Outcome::noEnergy);
  EXPECT_EQ(a, before);
}

TEST(NewtonCluster, KeepsLinearMomentum) {
  Body body = test::sliverBody("stvk", 0.98, false);
  auto handler = makeHandler("imex", body, makeIntegrator("symplectic-euler"),
                             {.own = {{"solver", Imex::newton}, {"dissipation", 0.1}}});
  const double h = 5 * criticalStepOf(body);
  handler->prepare(body.mesh().X, h);
  ASSERT_FALSE(handler->elements().empty());
  BodySystem system(body);
  State state = system.initialState();
  state.v = test::Random(7).nodeVectors(body.nodeCount(), 0.02);
  const Eigen::Vector3d first = state.v * body.lumpedMass();
  const double scale = state.v.cwiseAbs().rowwise().sum().norm() * body.lumpedMass().mean();
  for (int step = 0; step < 200; ++step) ASSERT_TRUE(handler->step(system, state, h).done);
  EXPECT_LE((state.v * body.lumpedMass() - first).norm(), 1e-12 * scale);
}

// K̂ of the linear solvers is K itself for the linear law, so that all solvers take the same steps.
TEST(NewtonCluster, TakesTheStepsOfTheLinearSolversForTheLinearLaw) {
  const auto end = [](std::string_view solver) {
    Body body = test::sliverBody("linear", 0.98);
    Options own{{"solver", solver}, {"dissipation", 0.3}};
    if (solver == Imex::newton) own.set("tolerance", 1e-12).set("iterations", 2000);
    auto handler = makeHandler("imex", body, makeIntegrator("verlet"), {.own = own});
    const double h = 4 * criticalStepOf(body);
    handler->prepare(body.mesh().X, h);
    BodySystem system(body);
    State state = system.initialState();
    state.v = test::Random(9).nodeVectors(body.nodeCount(), 0.02);
    body.constraints().imposeVelocity(state.v);
    for (int step = 0; step < 100; ++step) EXPECT_TRUE(handler->step(system, state, h).done);
    return NodeVectors(state.x - body.mesh().X);
  };
  const NodeVectors factored = end("cholesky"), newton = end(Imex::newton);
  EXPECT_LE((newton - factored).norm(), 1e-8 * factored.norm());
}

}  // namespace
}  // namespace ringwatch
