// The studies themselves, on integrators whose behaviour is known in closed form.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include <Eigen/LU>

#include <ringwatch/verify/integrators/oscillator.h>
#include <ringwatch/verify/integrators/spring_chain.h>
#include <ringwatch/verify/matrix_eigenvalues.h>

namespace ringwatch {
namespace {

IntegratorFactory named(const char* name) {
  return [name] { return makeIntegrator(name); };
}

TEST(Oscillator, ExactSolutionSolvesTheEquation) {
  for (const double xi : {0.0, 0.3, 1.0, 2.5}) {
    const Oscillator oscillator(3, xi);
    const double t = 0.7, d = 1e-5;
    const auto x = [&](double s) { return oscillator.exact(s, 0.4, -0.2)[0]; };
    const double v = (x(t + d) - x(t - d)) / (2 * d), a = (x(t + d) - 2 * x(t) + x(t - d)) / (d * d);
    EXPECT_NEAR(v, oscillator.exact(t, 0.4, -0.2)[1], 1e-9);
    EXPECT_NEAR(a, -9 * x(t) - 6 * xi * v, 1e-4);
    EXPECT_NEAR(oscillator.exact(0, 0.4, -0.2)[0], 0.4, 1e-15);
  }
}

TEST(TransitionMatrix, OfVerletIsKnown) {
  const double z = 0.7;
  const TransitionMatrix T = transitionMatrix(named("verlet"), z, 0);
  ASSERT_TRUE(T.found);
  EXPECT_EQ(T.memory, 1);
  const Eigen::Matrix2d expected =
      (Eigen::Matrix2d() << 1 - z * z / 2, z, -z * (1 - z * z / 4), 1 - z * z / 2).finished();
  EXPECT_LT((T.matrix - expected).norm(), 1e-14);
}

// With damping Verlet's acceleration lags: the map after the start is still one of two numbers.
TEST(TransitionMatrix, SeesThroughTheStartOfALaggedMethod) {
  const double z = 0.7, xi = 0.2;
  const TransitionMatrix T = transitionMatrix(named("verlet"), z, xi);
  ASSERT_TRUE(T.found);
  EXPECT_EQ(T.memory, 1);
  EXPECT_NEAR(T.matrix.determinant(), 1 - 2 * xi * z, 1e-12);
  EXPECT_NEAR(T.matrix.trace(), 2 - z * z - 2 * xi * z, 1e-12);
}

/// Two-step Adams–Bashforth on (x, v).
class AdamsBashforth2 final : public Integrator {
 public:
  static constexpr IntegratorInfo description{"ab2", "", 2, 1, 0, false};
  const IntegratorInfo& info() const override { return description; }
  StepStatus step(SecondOrderSystem& system, State& state, double h) override {
    NodeVectors a;
    system.acceleration(state.time, state.x, state.v, a);
    if (a_.size() == 0) {
      v_ = state.v;
      a_ = a;
    }
    const NodeVectors v = state.v;
    state.x += h * (1.5 * v - 0.5 * v_);
    state.v += h * (1.5 * a - 0.5 * a_);
    v_ = v;
    a_ = a;
    state.time += h;
    return {};
  }

 private:
  NodeVectors v_, a_;
};

TEST(TransitionMatrix, OfATwoStepMethodIsACompanion) {
  const IntegratorFactory make = [] { return std::make_unique<AdamsBashforth2>(); };
  const TransitionMatrix T = transitionMatrix(make, 0.3, 1);
  ASSERT_TRUE(T.found);
  EXPECT_EQ(T.memory, 2);
  // Roots of r² - r (1 - 1.5 w) - 0.5 w for the double eigenvalue w = 0.3.
  const double b = 1 - 1.5 * 0.3, r = 0.5 * (b + std::sqrt(b * b + 2 * 0.3));
  EXPECT_NEAR(T.spectralRadius(), r, 1e-6);
  EXPECT_NEAR(measureStabilityLimit(make, 1), 1, 1e-6);  // the real interval is (-1, 0)
  EXPECT_EQ(measureStabilityLimit(make, 0), 0);          // weakly unstable on the imaginary axis
}

TEST(Eigenvalues, AreFoundWhereTheyComeInDefectivePairs) {
  // Bits of the two-step companion at critical damping at which Eigen's real solver does not converge.
  Eigen::Matrix4d A;
  A << 0x1.ffffffffffff9p-1, 0x1.5cccccccccdp+0, 0x1.1a5f8f8c36333p-51, -0x1.d11111111113ep-2,   //
      -0x1.5ccccccccccf5p+0, -0x1.b9999999999f8p+0, 0x1.d111111111137p-2, 0x1.d111111111145p-1,  //
      1, 0, 0, 0,                                                                                //
      0, 1, 0, 0;
  const double w = 0x1.d111111111145p-1, b = 1 - 1.5 * w, r = 0.5 * (b - std::sqrt(b * b + 2 * w));
  EXPECT_NEAR(eigenvaluesOf(A).cwiseAbs().maxCoeff(), -r, 1e-6);
}

TEST(StabilityLimit, IsFoundToTenDigits) {
  EXPECT_NEAR(measureStabilityLimit(named("symplectic-euler")), 2, 2e-10);
  EXPECT_NEAR(measureStabilityLimit(named("rk4")), 2 * std::sqrt(2.0), 2e-10);
  EXPECT_EQ(measureStabilityLimit(named("explicit-euler")), 0);
  for (const double xi : {0.1, 1.0, 3.0})
    EXPECT_NEAR(measureStabilityLimit(named("verlet"), xi), 2 * (std::sqrt(1 + xi * xi) - xi), 2e-10);
}

TEST(StabilityMap, HoldsTheSpectralRadius) {
  const Eigen::MatrixXd map = stabilityMap(named("symplectic-euler"), {0.5, 2.5}, {0, 0.1});
  EXPECT_NEAR(map(0, 0), 1, 1e-14);
  EXPECT_NEAR(map(0, 1), std::sqrt(0.9), 1e-14);
  EXPECT_NEAR(map(1, 0), 4, 1e-12);  // r² + 4.25 r + 1 = 0
  EXPECT_GT(map(1, 1), 1);
}

TEST(PeriodErrors, OfVerletFollowTheClosedForm) {
  for (const double z : {0.1, 0.5, 1.5}) {
    const PeriodErrors errors = periodErrors(named("verlet"), z);
    EXPECT_NEAR(errors.phase, 2 * std::asin(z / 2) / z - 1, 1e-12);
    EXPECT_NEAR(errors.amplitude, 0, 1e-12);
  }
  EXPECT_LT(periodErrors(named("rk4"), 1).amplitude, 0);
  EXPECT_GT(periodErrors(named("explicit-euler"), 0.1).amplitude, 0.3);
}

TEST(EnergyDrift, BySteppingIsThatByPowers) {
  for (const char* name : {"rk4", "rkn4", "explicit-euler"}) {
    const double z = 0.1;
    const EnergyDrift powers = energyDriftByPowers(named(name), z, 10), steps = energyDriftBySteps(named(name), z, 10);
    EXPECT_NEAR(powers.drift, steps.drift, 1e-9 * (1 + std::abs(steps.drift))) << name;
  }
}

TEST(ObservedCriticalStep, OfAChainIsTheClosedForm) {
  SpringChain chain(12, 2, 50);
  EXPECT_NEAR(chain.highestFrequency(), 2 * 5 * std::sin(12 * std::numbers::pi / 26), 1e-12);
  State start{0, NodeVectors::Zero(3, 12), NodeVectors::Zero(3, 12)};
  start.v(0, 0) = 1;
  const double h = 2 / chain.highestFrequency();
  EXPECT_NEAR(observedCriticalStep(named("verlet"), chain, start, 0.8 * h, 1.2 * h) / h, 1, 1e-4);
  EXPECT_TRUE(std::isnan(observedCriticalStep(named("verlet"), chain, start, 1.1 * h, 1.2 * h)));
}

TEST(SpringChain, ModesAreEigenvectors) {
  SpringChain chain(7, 2, 50);
  for (int j = 1; j <= 7; ++j) {
    const NodeVectors u = chain.mode(j);
    NodeVectors a;
    chain.acceleration(0, u, 0 * u, a);
    EXPECT_LT((a + chain.frequency(j) * chain.frequency(j) * u).norm(), 1e-11);
    EXPECT_LT((chain.stiffness(u) * u.reshaped() + 2 * a.reshaped()).norm(), 1e-11);
  }
}

}  // namespace
}  // namespace ringwatch
