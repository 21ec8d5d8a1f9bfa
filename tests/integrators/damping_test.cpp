// Rayleigh damping: the critical step against real runs and against brute force, and what it does to a body.
#include <gtest/gtest.h>

#include <cmath>

#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/integrators/body_system.h>
#include <ringwatch/integrators/stability_limit.h>
#include <ringwatch/meshes/generators/generators.h>
#include <ringwatch/monitor/bounds/global_frequency.h>
#include <ringwatch/monitor/stability_monitor.h>
#include <ringwatch/verify/integrators/oscillator.h>
#include <tests/support/random.h>

namespace ringwatch {
namespace {

TEST(DampedStep, IsTheUndampedOneWithoutDamping) {
  for (const IntegratorInfo& info : allIntegrators())
    EXPECT_DOUBLE_EQ(*dampedStep(1e6, {}, info), info.imaginaryLimit / 1e3);
}

TEST(DampedStep, OfCentralDifferencesHasAClosedForm) {
  const IntegratorInfo& info = *findIntegrator("verlet");
  for (const double lambda : {1e-3, 1.0, 1e4, 1e12})
    for (const RayleighDamping damping :
         {RayleighDamping{0.3, 0}, RayleighDamping{0, 1e-3}, RayleighDamping{50, 1e-2}}) {
      const double c = damping.alpha + damping.beta * lambda, h = 4 / (c + std::sqrt(c * c + 4 * lambda));
      EXPECT_NEAR(*dampedStep(lambda, damping, info) / h, 1, 1e-12);
      const double omega = std::sqrt(lambda), xi = c / (2 * omega);
      EXPECT_NEAR(2 / omega * (std::sqrt(1 + xi * xi) - xi) / h, 1, xi > 1e3 ? 1e-6 : 1e-9);
    }
}

// At the step given, every mode of [0, lambda] must be stable by the declared step; a hair above, one must not.
TEST(DampedStep, IsTheLeastOverAllModes) {
  for (const IntegratorInfo& info : allIntegrators())
    for (const double alpha : {0.0, 0.1, 1.0, 10.0})
      for (const double beta : {0.0, 0.05, 0.5, 5.0}) {
        if (alpha == 0 && beta == 0) continue;
        const double h = *dampedStep(1, {alpha, beta}, info);
        int unstableBelow = 0, unstableAbove = 0;
        for (int k = 1; k <= 2000; ++k) {
          const double omega = k / 2000.0, xi = 0.5 * (alpha / omega + beta * omega);
          unstableBelow += !isStableAmplification(info.amplification(h * (1 - 1e-4) * omega, xi));
          unstableAbove += !isStableAmplification(info.amplification(h * (1 + 1e-3) * omega, xi));
        }
        if (info.imaginaryLimit == 0 && beta == 0) {
          // Explicit Euler with mass damping: h <= alpha / omega².
          EXPECT_NEAR(h, std::min(alpha, 2 / alpha), 1e-3 * h);
          continue;
        }
        EXPECT_EQ(unstableBelow, 0) << info.name << " alpha " << alpha << " beta " << beta << " h " << h;
        EXPECT_GT(unstableAbove, 0) << info.name << " alpha " << alpha << " beta " << beta << " h " << h;
      }
}

TEST(DampedStep, DoesNotGrowWithTheFrequency) {
  for (const IntegratorInfo& info : allIntegrators())
    for (const RayleighDamping damping : {RayleighDamping{1, 0}, RayleighDamping{0, 0.1}, RayleighDamping{2, 0.5}}) {
      double before = infinity;
      for (double lambda = 0.01; lambda < 1e3; lambda *= 1.3) {
        const double h = *dampedStep(lambda, damping, info);
        EXPECT_LE(h, before * (1 + 1e-3)) << info.name << " at " << lambda;
        before = h;
      }
    }
}

TEST(DampedStep, AnswersNothingWhenNothingIsDeclared) {
  IntegratorInfo info{"mine", "", 2, 1, 2.0, false};
  EXPECT_EQ(*dampedStep(4, {}, info), 1);
  EXPECT_FALSE(dampedStep(4, {1, 0}, info));
  EXPECT_EQ(*dampedStep(0, {}, info), infinity);
}

Body bar(const char* law) {
  BarOptions options;
  options.size = {0.2, 0.04, 0.04};
  options.cells = {5, 1, 1};
  options.jitter = 0.2;
  Body body(generateBar(options), makeMaterial(law, 30e3, 0.3, 1000), {{}, Lumping::rowSum, 1});
  for (const std::int32_t node : body.mesh().nodeSets.at("x-min")) body.constraints().fix(node);
  return body;
}

TEST(RayleighDampedBody, HasTheCriticalStepOfTheFormula) {
  const Body body = bar("stvk");
  const double lambda = globalFrequency(body, body.mesh().X).lambda;
  ASSERT_GT(lambda, 0);
  for (const RayleighDamping damping : {RayleighDamping{0, 2e-4}, RayleighDamping{200, 1e-4}}) {
    BodySystem system(body, damping);
    EXPECT_TRUE(system.velocityDependent());
    State start = system.initialState();
    test::Random random(1);
    NodeVectors noise = random.nodeVectors(start.x.cols(), 1e-8);
    body.constraints().clearConstrained(noise);
    start.v += noise;
    for (const char* name : {"symplectic-euler", "verlet", "rk4"}) {
      const double h = *dampedStep(lambda, damping, *findIntegrator(name));
      const double found = observedCriticalStep([&] { return makeIntegrator(name); }, system, start, 0.9 * h, 1.1 * h,
                                                {1000, 1e3, 1e-4});
      EXPECT_NEAR(found / h, 1, 2e-3) << name;
    }
  }
}

StepRule ruleOf(const IntegratorInfo& info, const RayleighDamping& damping) {
  return {[info, damping](double lambda) { return *dampedStep(lambda, damping, info); }, info.highestModeBinds};
}

// The monitor's bracket against runs: certified ones are bounded, violated ones are not, and what the undamped limit
// would allow is lost.
TEST(RayleighDampedBody, HasItsObservedStepWithinTheMonitorsBracket) {
  const Body body = bar("stvk");
  const double undamped = criticalStep(body, body.mesh().X, 2).safe;
  for (const RayleighDamping damping : {RayleighDamping{20, 0}, RayleighDamping{0, 1e-3}, RayleighDamping{200, 1e-4}})
    for (const char* name : {"symplectic-euler", "verlet"}) {
      const StepRule rule = ruleOf(*findIntegrator(name), damping);
      const CriticalStep bracket = criticalStep(body, body.mesh().X, rule);
      ASSERT_LE(bracket.safe, bracket.optimistic);
      BodySystem system(body, damping);
      State start = system.initialState();
      test::Random random(2);
      NodeVectors noise = random.nodeVectors(start.x.cols(), 1e-8);
      body.constraints().clearConstrained(noise);
      start.v += noise;
      const double found = observedCriticalStep([&] { return makeIntegrator(name); }, system, start,
                                                0.95 * bracket.safe, 1.1 * bracket.optimistic, {2000, 1e3, 1e-4});
      EXPECT_GE(found, bracket.safe) << name;
      EXPECT_LE(found, 1.002 * bracket.optimistic) << name;  // growth just above the limit takes its time
      if (damping.beta >= 1e-4) {
        EXPECT_GT(undamped, bracket.optimistic);
      }

      MonitorOptions options;
      options.limit = rule;
      StabilityMonitor monitor(body, options);
      EXPECT_EQ(
          monitor.observe(0, 0, start.x, start.v, 0.999 * monitor.observe(0, 0, start.x, start.v, 1).bracket->safe)
              .verdict,
          Verdict::certified);
      EXPECT_EQ(monitor.observe(1, 0, start.x, start.v, 1.01 * found).verdict, Verdict::violated) << name;
    }
}

TEST(RayleighDampedBody, HasNoBracketWhereNothingIsProven) {
  const Body body = bar("stvk");
  MonitorOptions options;
  options.limit = ruleOf(*findIntegrator("rk4"), {0, 1e-3});
  EXPECT_THROW(StabilityMonitor(body, options), InputError);
  EXPECT_THROW(criticalStep(body, body.mesh().X, options.limit), InputError);
  options.mode = MonitorMode::metric;
  options.metric = "single-element";
  StabilityMonitor monitor(body, options);
  const MonitorReport report = monitor.observe(0, 0, body.mesh().X, 0 * body.mesh().X, 1e-6);
  EXPECT_EQ(report.verdict, Verdict::notCertified);
  EXPECT_GT(*report.metricStep, 0);
}

// What damping takes is in the energy balance, at order two, with a moved end that has to pull against it.
TEST(RayleighDampedBody, BalancesItsEnergies) {
  Body body = bar("stvk");
  body.addBodyForce({0, 0, -1});
  for (const std::int32_t node : body.mesh().nodeSets.at("x-max")) body.constraints().move(node, 0, 0.05);
  const RayleighDamping damping{2, 1e-3};
  const double h = 0.5 * criticalStep(body, body.mesh().X, ruleOf(*findIntegrator("verlet"), damping)).safe;
  double error[2];
  for (const int refinement : {0, 1}) {
    BodySystem system(body, damping);
    State state = system.initialState();
    EnergyBalance balance(body);
    NodeVectors dampingForce;
    const auto integrator = makeIntegrator("rk4");
    const int steps = 200 << (2 * refinement);
    Energies energies;
    for (int k = 0; k <= steps; ++k) {
      system.dampingForce(state.x, state.v, dampingForce);
      balance.recordDamping(state.x, dampingForce);
      energies = balance.evaluate(state.x, state.v);
      if (k == steps) break;
      ASSERT_TRUE(integrator->step(system, state, 200 * h / steps).done);
    }
    EXPECT_GT(energies.dissipated, 0.01 * energies.externalWork);
    error[refinement] = std::abs(energies.balanceError) / energies.externalWork;
  }
  EXPECT_LT(error[0], 1e-2);
  EXPECT_LT(error[1], error[0] / 8);
}

// With mass damping alone, all of a free body's momentum decays like exp(-alpha t).
TEST(RayleighDampedBody, LosesMomentumAtTheMassRate) {
  Body body(generateBar(BarOptions{}), makeMaterial("stvk", 30e3, 0.3, 1000), {{}, Lumping::rowSum, 1});
  BodySystem system(body, {3, 1e-3});
  State state = system.initialState();
  state.v.row(1).setConstant(0.25);
  const auto integrator = makeIntegrator("rk4");
  for (int k = 0; k < 1000; ++k) ASSERT_TRUE(integrator->step(system, state, 1e-3).done);
  for (Eigen::Index i = 0; i < state.v.cols(); ++i) EXPECT_NEAR(state.v(1, i), 0.25 * std::exp(-3), 1e-9);
}

// Stiffness damping takes energy out of a vibration and none out of a rigid motion.
TEST(RayleighDampedBody, StiffnessDampingSparesRigidMotion) {
  Body body(generateBar(BarOptions{}), makeMaterial("stvk", 30e3, 0.3, 1000), {{}, Lumping::rowSum, 1});
  BodySystem system(body, {0, 1e-2});
  State state = system.initialState();
  state.v.row(2).setConstant(1);
  NodeVectors a;
  system.acceleration(0, state.x, state.v, a);
  EXPECT_LT(a.norm(), 1e-8);
  state.v.row(2) = state.x.row(2);  // stretching
  system.acceleration(0, state.x, state.v, a);
  EXPECT_LT((a * body.lumpedMass().asDiagonal()).cwiseProduct(state.v).sum(), -1e-3);
}

}  // namespace
}  // namespace ringwatch
