// Every integrator of integrators/registry.cpp held to what it declares of itself.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include <ringwatch/base/error.h>
#include <ringwatch/integrators/explicit_euler.h>
#include <ringwatch/integrators/stormer_verlet.h>
#include <ringwatch/integrators/symplectic_euler.h>
#include <tests/support/oscillator.h>
#include <tests/support/random.h>
#include <tests/support/registry_types.h>

namespace ringwatch {
namespace {

using test::oneNode;
using test::Oscillator;
using test::Pendulum;

class IntegratorTest : public ::testing::TestWithParam<IntegratorInfo> {
 public:
  const std::unique_ptr<Integrator> integrator = makeIntegrator(GetParam().name);

  void advance(SecondOrderSystem& system, State& state, double h, int steps) {
    for (int i = 0; i < steps; ++i) {
      const StepStatus status = integrator->step(system, state, h);
      ASSERT_TRUE(status.done) << status.reason;
    }
  }
};
INSTANTIATE_TEST_SUITE_P(All, IntegratorTest, ::testing::ValuesIn(allIntegrators().begin(), allIntegrators().end()),
                         [](const auto& test) { return test::testName(test.param.name); });

TEST_P(IntegratorTest, HasTheOrderItDeclares) {
  // x = cos t + sin t at t = 1, errors of two small steps.
  const auto error = [&](int steps) {
    Oscillator oscillator(1);
    State state = oneNode(1, 1);
    integrator->reset();
    advance(oscillator, state, 1.0 / steps, steps);
    EXPECT_NEAR(state.time, 1, 1e-12);
    return std::abs(state.x(0, 0) - (std::cos(1.0) + std::sin(1.0)));
  };
  const int coarse = GetParam().order >= 4 ? 32 : 256;
  const double order = std::log2(error(coarse) / error(2 * coarse));
  EXPECT_NEAR(order, GetParam().order, 0.15);
}

TEST_P(IntegratorTest, StaysBoundedJustBelowItsLimit) {
  const double limit = GetParam().imaginaryLimit;
  if (limit == 0) GTEST_SKIP() << "never stable";
  Oscillator oscillator(1);
  State state = oneNode(1, 0.5);
  double largest = 0;
  const double h = std::isinf(limit) ? 1e3 : 0.99 * limit;
  for (int i = 0; i < 100000; ++i) {
    integrator->step(oscillator, state, h);
    largest = std::max(largest, state.x.norm());
  }
  EXPECT_LT(largest, 20);
}

TEST_P(IntegratorTest, BlowsUpJustAboveItsLimit) {
  const double limit = GetParam().imaginaryLimit;
  if (std::isinf(limit)) GTEST_SKIP() << "stable for every step";
  // A limit of zero: unstable at any step, however small.
  for (const double h : limit > 0 ? std::vector<double>{1.01 * limit} : std::vector<double>{0.01, 0.1, 1}) {
    Oscillator oscillator(1);
    State state = oneNode(1, 0.5);
    integrator->reset();
    const double start = oscillator.energy(state);
    double growth = 1;
    for (int i = 0; i < 1000000 && growth < 1e6; ++i) {
      integrator->step(oscillator, state, h);
      growth = oscillator.energy(state) / start;
    }
    EXPECT_GE(growth, 1e6) << "h = " << h;
  }
}

TEST_P(IntegratorTest, KeepsTheEnergyOfAPendulumWhenSymplectic) {
  if (!GetParam().symplectic) GTEST_SKIP() << "does not claim it";
  Pendulum pendulum;
  State state = oneNode(1.5, 0);
  const double h = 0.05, start = Pendulum::energy(state);
  double early = 0, late = 0;
  const int steps = 200000;
  for (int i = 0; i < steps; ++i) {
    integrator->step(pendulum, state, h);
    double& largest = i < steps / 10 ? early : late;
    largest = std::max(largest, std::abs(Pendulum::energy(state) - start));
  }
  // It swings about its start and does not drift: late swings are no larger than early ones.
  EXPECT_LT(early, std::pow(h, GetParam().order));
  EXPECT_LT(late, 1.01 * early);
}

TEST_P(IntegratorTest, SpendsTheForceEvaluationsItDeclares) {
  if (GetParam().forceEvaluations == 0) GTEST_SKIP() << "their number varies";
  Oscillator oscillator(1);
  State state = oneNode(1, 0);
  advance(oscillator, state, 0.01, 1);  // the first step may need one more
  oscillator.evaluations = 0;
  advance(oscillator, state, 0.01, 100);
  EXPECT_EQ(oscillator.evaluations, 100 * GetParam().forceEvaluations);
}

TEST_P(IntegratorTest, ForgetsOnReset) {
  // With the state changed from outside and a reset, it goes on as a new one would.
  Oscillator oscillator(2);
  State state = oneNode(1, 0);
  advance(oscillator, state, 0.1, 3);
  state.x.setConstant(0.7);
  state.v.setConstant(-0.2);
  State fresh = state;
  integrator->reset();
  advance(oscillator, state, 0.1, 5);
  const auto another = makeIntegrator(GetParam().name);
  for (int i = 0; i < 5; ++i) another->step(oscillator, fresh, 0.1);
  EXPECT_TRUE(state.x == fresh.x);
  EXPECT_TRUE(state.v == fresh.v);
}

TEST_P(IntegratorTest, DoesTheSameForEveryNodeAndComponent) {
  Pendulum pendulum;
  test::Random random(1);
  State many;
  many.x = random.nodeVectors(5, 1);
  many.v = random.nodeVectors(5, 1);
  const State start = many;
  advance(pendulum, many, 0.1, 20);
  for (Eigen::Index i = 0; i < 5; ++i) {
    State one;
    one.x = start.x.col(i);
    one.v = start.v.col(i);
    integrator->reset();
    advance(pendulum, one, 0.1, 20);
    EXPECT_LE((one.x - many.x.col(i)).norm(), 1e-14);
    EXPECT_LE((one.v - many.v.col(i)).norm(), 1e-14);
  }
}

TEST_P(IntegratorTest, MovesFreelyAtConstantVelocityWithoutForces) {
  Oscillator nothing(0);
  State state = oneNode(0.5, 2);
  advance(nothing, state, 0.25, 40);
  EXPECT_EQ(state.time, 10);
  EXPECT_NEAR(state.x(0, 0), 20.5, 1e-12);
  EXPECT_NEAR(state.v(0, 0), 2, 1e-14);
}

TEST(StormerVerlet, RetracesItsWayBackInTime) {
  Pendulum pendulum;
  State state = oneNode(1.2, 0.3);
  StormerVerlet verlet;
  for (int i = 0; i < 1000; ++i) verlet.step(pendulum, state, 0.1);
  state.v = -state.v;
  verlet.reset();
  for (int i = 0; i < 1000; ++i) verlet.step(pendulum, state, 0.1);
  EXPECT_NEAR(state.x(0, 0), 1.2, 1e-10);
  EXPECT_NEAR(state.v(0, 0), -0.3, 1e-10);
}

TEST(SymplecticEuler, IsVerletShiftedByHalfAStep) {
  // Kicked by half a step at the start, symplectic Euler visits the positions of Verlet, its velocities half a step
  // ahead.
  Pendulum pendulum;
  const double h = 0.2;
  State verletState = oneNode(1.2, 0.3), eulerState = verletState;
  NodeVectors a;
  pendulum.acceleration(0, eulerState.x, eulerState.v, a);
  eulerState.v -= 0.5 * h * a;  // v at -h/2
  StormerVerlet verlet;
  SymplecticEuler euler;
  for (int i = 0; i < 200; ++i) {
    pendulum.acceleration(0, verletState.x, verletState.v, a);
    const double half = verletState.v(0, 0) + 0.5 * h * a(0, 0);
    verlet.step(pendulum, verletState, h);
    euler.step(pendulum, eulerState, h);
    EXPECT_NEAR(eulerState.x(0, 0), verletState.x(0, 0), 1e-12) << i;
    EXPECT_NEAR(eulerState.v(0, 0), half, 1e-12) << i;
  }
}

TEST(StormerVerlet, HasTheFrequencyShiftOfCentralDifferences) {
  // sin(Ωh/2) = ωh/2: the step at which the numerical period closes.
  const double h = 0.5, Omega = 2 / h * std::asin(h / 2);
  Oscillator oscillator(1);
  State state = oneNode(1, 0);
  StormerVerlet verlet;
  for (int i = 1; i <= 50; ++i) {
    verlet.step(oscillator, state, h);
    EXPECT_NEAR(state.x(0, 0), std::cos(Omega * h * i), 1e-12);
  }
}

TEST(ExplicitEuler, GrowsByTheKnownFactor) {
  // |1 + iωh|² in energy a step.
  Oscillator oscillator(3);
  State state = oneNode(1, 0);
  ExplicitEuler euler;
  const double before = oscillator.energy(state);
  for (int i = 0; i < 10; ++i) euler.step(oscillator, state, 0.1);
  EXPECT_NEAR(oscillator.energy(state) / before, std::pow(1.09, 10), 1e-12);
}

TEST(IntegratorRegistry, KnowsEveryName) {
  std::set<std::string_view> names;
  for (const IntegratorInfo& info : allIntegrators()) {
    EXPECT_TRUE(names.insert(info.name).second) << info.name << " twice";
    EXPECT_FALSE(info.help.empty());
    EXPECT_GE(info.order, 1);
    EXPECT_GE(info.imaginaryLimit, 0);
    EXPECT_EQ(findIntegrator(info.name)->name, info.name);
    EXPECT_EQ(makeIntegrator(info.name)->info().name, info.name);
  }
  EXPECT_EQ(findIntegrator("leapfrog"), nullptr);
}

TEST(IntegratorRegistry, ListsTheNamesWhenOneIsUnknown) {
  try {
    makeIntegrator("leapfrog");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("\"leapfrog\""));
    for (const IntegratorInfo& info : allIntegrators())
      EXPECT_THAT(error.what(), ::testing::HasSubstr(std::string(info.name)));
  }
}

}  // namespace
}  // namespace ringwatch
