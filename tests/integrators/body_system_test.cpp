// A body under an integrator: prescribed motion, free fall, energy and momentum.
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include <ringwatch/integrators/body_system.h>
#include <ringwatch/integrators/stormer_verlet.h>
#include <ringwatch/monitor/energy_balance.h>
#include <tests/support/body_cases.h>
#include <tests/support/random.h>

namespace ringwatch {
namespace {

constexpr double h = 2e-4;  // far below the critical step of cells of 1 cm

Body makeBody(std::string_view element = "hex8") {
  return Body(test::distortedBox(element, {4, 2, 2}), makeMaterial("stvk", 30e3, 0.3, 1000), {{}, Lumping::rowSum, 1});
}

class BodySystemTest : public ::testing::TestWithParam<IntegratorInfo> {};
INSTANTIATE_TEST_SUITE_P(All, BodySystemTest, ::testing::ValuesIn(allIntegrators().begin(), allIntegrators().end()),
                         [](const auto& test) { return test::testName(test.param.name); });

TEST_P(BodySystemTest, MovesPrescribedNodesExactlyInALine) {
  Body body = makeBody();
  const auto clamped = test::nodesWhere(body.mesh(), [](const Eigen::Vector3d& p) { return p[0] < 1e-9; });
  const auto pulled = test::nodesWhere(body.mesh(), [](const Eigen::Vector3d& p) { return p[0] > 0.04 - 1e-9; });
  for (std::int32_t i : clamped) body.constraints().fix(i);
  for (std::int32_t i : pulled) {
    body.constraints().move(i, 0, 0.1);
    body.constraints().move(i, 1, -0.05);
    body.constraints().fix(i, 2);
  }
  BodySystem system(body);
  State state = system.initialState();
  const auto integrator = makeIntegrator(GetParam().name);
  for (int step = 1; step <= 100; ++step) {
    integrator->step(system, state, h);
    ASSERT_TRUE(state.x.allFinite());
    for (std::int32_t i : clamped) EXPECT_EQ(state.x.col(i), body.mesh().X.col(i));
    for (std::int32_t i : pulled) {
      const Eigen::Vector3d expected = body.mesh().X.col(i) + step * h * Eigen::Vector3d(0.1, -0.05, 0);
      EXPECT_LE((state.x.col(i) - expected).norm(), 1e-16 * step) << step;
      EXPECT_EQ(state.v.col(i), Eigen::Vector3d(0.1, -0.05, 0));
    }
  }
}

TEST_P(BodySystemTest, HasTheSameBitsForAnyNumberOfThreads) {
  const auto stateAfter = [](int threads, const RayleighDamping& damping) {
    Body body(test::distortedBox("tet4", {24, 12, 12}), makeMaterial("stvk", 30e3, 0.3, 1000),
              {{}, Lumping::rowSum, threads});
    EXPECT_GT(body.nodeCount(), 3 * 1024);  // several threads update them
    body.addBodyForce({3, 0, -9.81});
    BodySystem system(body, damping);
    State state = system.initialState();
    const auto integrator = makeIntegrator(GetParam().name);
    EnergyBalance balance(body);
    for (int i = 0; i < 5; ++i) integrator->step(system, state, h);
    EXPECT_TRUE(isFinite(state, threads));
    return std::pair(state, balance.evaluate(state.x, state.v).kinetic);
  };
  for (const RayleighDamping& damping : {RayleighDamping{}, RayleighDamping{20, 1e-6}}) {
    const auto [alone, energy] = stateAfter(1, damping);
    for (const int threads : {2, 3}) {
      const auto [state, kinetic] = stateAfter(threads, damping);
      EXPECT_EQ(state.x, alone.x) << threads;
      EXPECT_EQ(state.v, alone.v) << threads;
      EXPECT_EQ(kinetic, energy) << threads;
    }
  }
}

TEST(BodySystem, FindsWhatIsNotFinite) {
  State state{0, NodeVectors::Random(3, 3000), NodeVectors::Random(3, 3000)};
  for (const int threads : {1, 3}) {
    EXPECT_TRUE(isFinite(state, threads));
    for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL})
      for (const Eigen::Index at : {0, 4000, 8999})
        for (NodeVectors* vectors : {&state.x, &state.v}) {
          const double good = std::exchange(vectors->data()[at], bad);
          EXPECT_FALSE(isFinite(state, threads)) << bad << " at " << at;
          vectors->data()[at] = good;
        }
  }
}

TEST_P(BodySystemTest, FallsFreelyWithoutStrain) {
  Body body = makeBody("tet4");
  body.addBodyForce({0, 0, -9.81});
  BodySystem system(body);
  State state = system.initialState();
  const auto integrator = makeIntegrator(GetParam().name);
  for (int i = 0; i < 25; ++i) integrator->step(system, state, h);
  const double fallen = 0.5 * 9.81 * state.time * state.time;
  for (Eigen::Index i = 0; i < state.x.cols(); ++i) {
    EXPECT_LE((state.v.col(i) - Eigen::Vector3d(0, 0, -9.81 * state.time)).norm(), 1e-9);
    EXPECT_NEAR(state.x(2, i), body.mesh().X(2, i) - fallen, 9.81 * state.time * h);  // first order at least
  }
  Body::Workspace workspace;
  EXPECT_NEAR(body.energy(state.x, workspace), 0, 1e-12);
}

TEST_P(BodySystemTest, KeepsMomentumOfAFreeBody) {
  const Body body = makeBody();
  BodySystem system(body);
  State state = system.initialState();
  test::Random random(1);
  state.v = random.nodeVectors(state.v.cols(), 0.05);
  const Eigen::Vector3d momentum = state.v * body.lumpedMass();
  const auto integrator = makeIntegrator(GetParam().name);
  for (int i = 0; i < 200; ++i) integrator->step(system, state, h);
  ASSERT_TRUE(state.x.allFinite());
  EXPECT_LE((state.v * body.lumpedMass() - momentum).norm(), 1e-12 * body.totalMass());
}

TEST(BodySystem, StartsAtRestWithPrescribedNodesMoving) {
  Body body = makeBody();
  body.constraints().move(3, 1, 0.25);
  const State state = BodySystem(body).initialState();
  EXPECT_EQ(state.time, 0);
  EXPECT_EQ(state.x, body.mesh().X);
  EXPECT_EQ(state.v(1, 3), 0.25);
  EXPECT_EQ(state.v.norm(), 0.25);
}

TEST(BodySystem, AcceleratesByForceOverMassAndHandsTheForceOn) {
  Body body = makeBody();
  body.constraints().fix(0);
  body.externalForce()(2, 5) = 0.125;
  BodySystem system(body);
  const NodeVectors x = test::strained(body.mesh().X), v = NodeVectors::Zero(3, x.cols());
  NodeVectors a, f;
  Body::Workspace workspace;
  system.acceleration(0, x, v, a);
  body.internalForce(x, f, workspace);
  NodeVectors ofForce;
  system.accelerationOfForce(f, x, v, ofForce);
  EXPECT_TRUE(ofForce == a);
  EXPECT_EQ(a.col(0), Eigen::Vector3d::Zero());
  for (Eigen::Index i = 1; i < x.cols(); ++i) {
    Eigen::Vector3d expected = -f.col(i);
    if (i == 5) expected[2] += 0.125;
    EXPECT_LE((a.col(i) * body.lumpedMass()[i] - expected).norm(), 1e-14);
  }
}

// Elements that damp, in the pass of the internal force and by a pass of their own, beside Rayleigh damping.
TEST(BodySystem, AcceleratesByTheDampingOfElementsHoweverItComes) {
  for (const RayleighDamping& rayleigh : {RayleighDamping{}, RayleighDamping{3, 1e-4}}) {
    Body body = makeBody();
    body.setElementDamping({{0.06, 1.2, 0, 0, 2.5}});
    BodySystem system(body, rayleigh);
    const NodeVectors x = test::strained(body.mesh().X), v = test::Random(5).nodeVectors(x.cols(), 3);
    NodeVectors a, f, damping, ofForce;
    Body::Workspace workspace;
    system.acceleration(0, x, v, a);
    body.internalForce(x, f, workspace);
    system.dampingForce(x, v, damping);
    const NodeVectors expected = -(f + damping) * body.lumpedMass().cwiseInverse().asDiagonal();
    EXPECT_GT(damping.norm(), 1e-3 * f.norm());
    EXPECT_LE((a - expected).norm(), 1e-15 * expected.norm());
    system.accelerationOfForce(f, x, v, ofForce);
    EXPECT_LE((ofForce - expected).norm(), 1e-15 * expected.norm());
    StepEvaluation evaluation;
    for (const NodeVectors* velocities : {&v, static_cast<const NodeVectors*>(nullptr)}) {
      evaluation.velocities = velocities;
      body.evaluate(x, evaluation, workspace);
      State state;
      state.x = x;
      state.v = v;
      system.complete(state, evaluation);
      EXPECT_EQ(state.a, velocities ? a : ofForce);
    }
  }
}

TEST(BodySystem, KeepsItsEnergyUnderVerlet) {
  const Body body = makeBody();
  BodySystem system(body);
  State state = system.initialState();
  state.v.row(0) = 2 * state.x.row(0);
  state.v.row(1) = -state.x.row(2);
  Body::Workspace workspace;
  const auto energy = [&] {
    return 0.5 * (state.v.array().square().matrix() * body.lumpedMass()).sum() + body.energy(state.x, workspace);
  };
  const double start = energy();
  StormerVerlet verlet;
  double largest = 0;
  for (int i = 0; i < 5000; ++i) {
    verlet.step(system, state, h);
    largest = std::max(largest, std::abs(energy() - start));
  }
  EXPECT_LT(largest, 2e-2 * start);
}

}  // namespace
}  // namespace ringwatch
