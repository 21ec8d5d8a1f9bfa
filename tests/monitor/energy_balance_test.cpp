// The energy balance of a run: what is put in is what is there, to the order of the scheme.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include <ringwatch/base/error.h>
#include <ringwatch/integrators/body_system.h>
#include <ringwatch/integrators/stormer_verlet.h>
#include <ringwatch/monitor/energy_balance.h>
#include <ringwatch/monitor/energy_check.h>
#include <ringwatch/monitor/stability_monitor.h>
#include <tests/monitor/monitor_cases.h>

namespace ringwatch {
namespace {

struct Balance {
  double worst = 0;  // |balance error|
  double most = 0;   // largest kinetic + strain
  Energies last;
};

class EnergyBalanceTest : public ::testing::TestWithParam<std::string> {
 protected:
  static Body makeBody(const test::Subdivision& subdivision) {
    return test::boxBody(subdivision, GetParam(), {3, 2, 2}, 0.1);
  }
  /// Runs Verlet from `state` for `duration` with steps of at most h, with energies evaluated at every step.
  static Balance run(const Body& body, State state, double duration, double h) {
    BodySystem system(body);
    StormerVerlet integrator;
    EnergyBalance balance(body);
    Balance result;
    balance.evaluate(state.x, state.v);
    const int steps = static_cast<int>(std::ceil(duration / h));
    for (int i = 0; i < steps; ++i) {
      integrator.step(system, state, duration / steps);
      result.last = balance.evaluate(state.x, state.v);
      result.worst = std::max(result.worst, std::abs(result.last.balanceError));
      result.most = std::max(result.most, result.last.kinetic + result.last.strain);
    }
    return result;
  }
  static double safe(const Body& body) { return criticalStep(body, body.mesh().X, 2).safe; }
  static State atRest(const Body& body) { return BodySystem(body).initialState(); }
};
std::vector<std::string> lawNames() {
  std::vector<std::string> names;
  for (const LawInfo& law : allLaws()) names.emplace_back(law.name);
  return names;
}
INSTANTIATE_TEST_SUITE_P(Laws, EnergyBalanceTest, ::testing::ValuesIn(lawNames()),
                         [](const auto& test) { return test::testName(test.param); });

// Strains of 1e-14 to 1e-13 have less than a hundredth of the energy of one of 1e-12; what is computed is the law's
// rounding.
TEST_P(EnergyBalanceTest, RoundingIsNoMeasure) {
  for (const test::Subdivision& subdivision : test::allSubdivisions()) {
    const Body body = makeBody(subdivision);
    for (int k = 1; k <= 10; ++k) {
      const NodeVectors x = (1 + 1e-14 * k) * body.mesh().X;
      const double strain = EnergyBalance(body).evaluate(x, NodeVectors::Zero(3, x.cols())).strain;
      EXPECT_LE(std::abs(strain), 0.1 * roundingEnergy(body)) << subdivision.name << " " << k;
    }
  }
}

TEST_P(EnergyBalanceTest, OfABodyInFreeFlightErrsAtSecondOrder) {
  for (const test::Subdivision& subdivision : test::allSubdivisions()) {
    const Body body = makeBody(subdivision);
    State state = atRest(body);
    // Swinging about its middle and flying.
    const Eigen::Matrix3d gradient = Eigen::Vector3d(8, -5, -3).asDiagonal();
    state.v = (gradient * state.x).colwise() + Eigen::Vector3d(0.01, 0.02, 0);
    const double h = 0.2 * safe(body), duration = 60 * h;
    const Balance coarse = run(body, state, duration, h), fine = run(body, state, duration, h / 2);
    EXPECT_LE(coarse.worst, 0.02 * coarse.most) << subdivision.name;
    EXPECT_NEAR(coarse.worst / fine.worst, 4, 0.4) << subdivision.name;
    EXPECT_EQ(coarse.last.externalWork, 0) << subdivision.name;
  }
}

TEST_P(EnergyBalanceTest, CountsTheWorkOfAPulledEnd) {
  for (const test::Subdivision& subdivision : test::allSubdivisions()) {
    Body body = makeBody(subdivision);
    for (std::int32_t i = 0; i < body.nodeCount(); ++i) {
      if (body.mesh().X(0, i) < 1e-9) body.constraints().fix(i);
      if (body.mesh().X(0, i) > 3 * test::cellSize - 1e-9) {
        body.constraints().fix(i);
        body.constraints().move(i, 0, 0.3);
      }
    }
    // The pull comes at full speed, so the balance starts with the kinetic energy of the pulled nodes and a shock.
    const double h = 0.1 * safe(body), duration = 0.02;
    const Balance coarse = run(body, atRest(body), duration, h), fine = run(body, atRest(body), duration, h / 2);
    EXPECT_GT(coarse.last.externalWork, 0.5 * coarse.last.strain) << subdivision.name;
    EXPECT_GT(coarse.last.strain, 0) << subdivision.name;
    EXPECT_LE(coarse.worst, 2e-3 * coarse.most) << subdivision.name;
    EXPECT_LE(fine.worst, 0.35 * coarse.worst) << subdivision.name;
    EXPECT_NEAR(fine.last.externalWork, coarse.last.externalWork, 1e-2 * coarse.last.externalWork) << subdivision.name;
  }
}

TEST_P(EnergyBalanceTest, CountsTheWorkOfGravity) {
  for (const test::Subdivision& subdivision : test::allSubdivisions()) {
    Body body = makeBody(subdivision);
    test::holdBody(body, test::Hold::face);
    body.addBodyForce({0, 0, -9.81});
    const double h = 0.2 * safe(body), duration = 0.05;
    const Balance coarse = run(body, atRest(body), duration, h), fine = run(body, atRest(body), duration, h / 2);
    EXPECT_GT(coarse.last.externalWork, 0) << subdivision.name;
    EXPECT_LE(coarse.worst, 5e-3 * coarse.most) << subdivision.name;
    EXPECT_LE(fine.worst, 0.35 * coarse.worst) << subdivision.name;
  }
}

TEST_P(EnergyBalanceTest, OfAFallingBodyIsThatOfAPointMass) {
  const test::Subdivision subdivision = test::allSubdivisions()[0];
  Body body = makeBody(subdivision);
  body.addBodyForce({0, 0, -9.81});
  const double h = 0.5 * safe(body), duration = 40 * h;
  const Balance result = run(body, atRest(body), duration, h);
  const double expected = 0.5 * body.totalMass() * std::pow(9.81 * duration, 2);
  EXPECT_NEAR(result.last.kinetic, expected, 1e-10 * expected);
  EXPECT_NEAR(result.last.externalWork, expected, 1e-10 * expected);
  EXPECT_LE(result.last.strain, 1e-10 * expected);
  EXPECT_LE(result.worst, 1e-10 * expected);
}

// By hand: a body of a joule, one state of 296 kJ that comes from nowhere, and 5228 J too much from then on.
TEST(EnergyCheck, AnErrorIsNoMeasureOfWhatFollows) {
  EnergyCheck check(1e-20);
  for (int step = 0; step < 60; ++step) {
    const double swing = std::sin(0.3 * step), kinetic = swing * swing, strain = 1 - kinetic;
    const double error = step < 30 ? 0.01 * swing : step == 30 ? 296e3 : 5228;
    const auto share = check.observe({kinetic + error, strain, 0, error}, step, 0.1);
    EXPECT_EQ(share.has_value(), step >= 30) << step;
    EXPECT_NEAR(share.value_or(0), step >= 30 ? error : 0, 1e-6 * std::abs(error)) << step;
  }
}

// What was there or was put in stays a measure when it is gone: a body at rest at last, a swing that turns, a load.
TEST(EnergyCheck, EnergiesThatBothSidesHaveStayAMeasure) {
  EnergyCheck braked(1e-20), swinging(1e-20), pulled(1e-20);
  for (int step = 0; step < 400; ++step) {
    const double left = 100 * std::exp(-0.1 * step), lost = 100 - left;
    EXPECT_FALSE(braked.observe({left, 0, 0, 0.02 * lost, lost + 0.02 * lost}, step, 0.1)) << step;
    const double work = 5 * (1 - std::cos(0.1 * step));
    EXPECT_FALSE(swinging.observe({work + 0.3, 0, work, 0.3}, step, 0.1)) << step;
    const auto share = pulled.observe({0, 0.01 * step * step, 0.013 * step * step, -0.003 * step * step}, step, 0.1);
    EXPECT_EQ(share.has_value(), step >= 20) << step;
  }
}

TEST(EnergyCheck, AStateWithoutAnEnergyIsOffAndLeavesNothingBehind) {
  EnergyCheck check(1e-20);
  const double none = std::numeric_limits<double>::quiet_NaN();
  for (int step = 0; step < 60; ++step) {
    const bool inverted = step == 40;
    const auto share = check.observe({1, inverted ? none : 2, 0, inverted ? none : 0.05}, step, 0.1);
    EXPECT_EQ(share.has_value(), inverted) << step;
  }
}

// The trapezoidal rule over a force that is 2 N at each moved component, but no number at one state.
TEST(EnergyBalance, SumsOnlyNumbers) {
  Body body = test::boxBody(test::allSubdivisions()[0], "neo-hookean", {1, 1, 1}, 0);
  body.constraints().move(0, 0, 1.0);
  EnergyBalance balance(body);
  NodeVectors x = body.mesh().X;
  const NodeVectors force = NodeVectors::Constant(3, x.cols(), 2.0),
                    none = NodeVectors::Constant(3, x.cols(), std::nan(""));
  const NodeVectors v = NodeVectors::Zero(3, x.cols());
  for (int step = 0; step <= 4; ++step) {
    if (step > 0) x(0, 0) += 0.25;
    balance.record(x, step == 2 ? none : force);
    balance.energies(x, v, step == 2 ? std::nan("") : 0.0);
  }
  const Energies last = balance.energies(x, v, 0);
  EXPECT_NEAR(last.externalWork, 2 * 4 * 0.25, 1e-15);
  EXPECT_NEAR(last.balanceError, -2, 1e-15);
}

// Central differences of an oscillator with a dashpot, by its recursion: what the kicks take, half of the first and of
// the last one, and what is kept to rounding, however strong the dashpot is.
TEST(EnergyBalance, OfAnOscillatorWithADashpotIsExact) {
  const Body body = test::boxBody(test::allSubdivisions()[0], "linear", {1, 1, 1}, 0);
  constexpr double m = 2, k = 50;  // kg, N/m
  int runs = 0;
  for (const double ratio : {0.01, 0.3, 1.0, 4.0})
    for (const double share : {0.1, 0.5, 0.99}) {
      const double c = ratio * 2 * std::sqrt(k * m), h = share * (std::sqrt(c * c + 4 * k * m) - c) / k;
      EnergyBalance balance(body);
      double x = 0.03, v = -0.4, kicks = 0, first = 0;
      for (int step = 0; step <= 300; ++step) {
        const double d = c * v, after = v - h * (k * x + d) / m;
        NodeVectors positions = body.mesh().X, force = NodeVectors::Zero(3, positions.cols());
        positions(1, 3) += x;
        force(1, 3) = d;
        balance.recordDamping(positions, force);
        const double taken = balance.energies(positions, force, 0).dissipated,
                     kept = 0.5 * m * v * after + 0.5 * k * x * x + taken;
        if (step == 0) {
          first = kept;
          kicks = -0.5 * h * d * v;
        }
        ASSERT_NEAR(kept, first, 1e-13 * std::abs(first)) << ratio << " " << share << " " << step;
        ASSERT_NEAR(taken, kicks + 0.5 * h * d * v, 1e-13 * std::abs(first)) << ratio << " " << share << " " << step;
        kicks += 0.5 * h * d * (v + after);
        v = after;
        x += h * v;
      }
      ++runs;
    }
  EXPECT_EQ(runs, 12);
}

TEST_P(EnergyBalanceTest, SeesWhatComesFromNowhere) {
  const Body body = makeBody(test::allSubdivisions()[0]);
  EnergyBalance balance(body);
  const NodeVectors& X = body.mesh().X;
  const NodeVectors none = NodeVectors::Zero(3, body.nodeCount());
  EXPECT_EQ(balance.evaluate(X, none).balanceError, 0);
  const NodeVectors v = NodeVectors::Constant(3, body.nodeCount(), 0.1);
  const Energies found = balance.evaluate(X, v);
  const double expected = 0.5 * body.totalMass() * 0.03;
  EXPECT_NEAR(found.kinetic, expected, 1e-13 * expected);
  EXPECT_NEAR(found.balanceError, expected, 1e-10 * expected);
}

}  // namespace
}  // namespace ringwatch
