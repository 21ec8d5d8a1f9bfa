// The implicit integrators: closed forms, large steps, linear solvers against each other, failures that leave the state
// alone.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include <Eigen/LU>

#include <ringwatch/base/error.h>
#include <ringwatch/integrators/body_system.h>
#include <ringwatch/integrators/sundials/implicit.h>
#include <ringwatch/integrators/sundials/registry.h>
#include <ringwatch/meshes/generators.h>
#include <ringwatch/monitor/global_frequency.h>
#include <ringwatch/verify/integrators.h>
#include <ringwatch/verify/oscillator.h>

namespace ringwatch {
namespace {

TEST(Sundials, IntegratorsLiveUpToTheirDeclarations) {
  const StudyReport report = verifyIntegrators(StudyEffort::quick, sundialsIntegrators());
  for (const StudyCheck& check : report.checks)
    EXPECT_TRUE(check.passed) << check.name << ": " << check.measured << ", expected " << check.expected << " within "
                              << check.tolerance;
  EXPECT_GT(report.checks.size(), 10u);
}

TEST(Sundials, CatalogKnowsBothLists) {
  const IntegratorCatalog catalog{coreIntegrators(), sundialsIntegrators()};
  for (const char* name : {"verlet", "implicit-euler", "arkode-dirk", "cvode-bdf"})
    EXPECT_EQ(catalog.make(name)->info().name, name);
}

TEST(ImplicitEuler, HasItsClosedForm) {
  for (const double z : {0.1, 1.0, 10.0})
    for (const double xi : {0.0, 0.3}) {
      const TransitionMatrix T = transitionMatrix([] { return std::make_unique<ImplicitEuler>(); }, z, xi);
      ASSERT_TRUE(T.found);
      const Eigen::Matrix2d A = (Eigen::Matrix2d() << 1, -z, z, 1 + 2 * xi * z).finished();
      const double det = 1 + 2 * xi * z + z * z;
      EXPECT_NEAR(T.matrix.determinant(), 1 / det, 1e-9);
      EXPECT_NEAR(T.matrix.trace(), A.trace() / det, 1e-9);
    }
}

TEST(ArkodeDirk, HasItsOrders) {
  for (const int order : {2, 3, 4}) {
    const IntegratorFactory make = [&] { return std::make_unique<ArkodeDirk>(order); };
    EXPECT_EQ(make()->info().order, order);
    EXPECT_NEAR(measureOrder(make, 0), order, 0.15);
    EXPECT_NEAR(measureOrder(make, 0.2), order, 0.15);
    for (const double z : {1.0, 10.0, 1e3, 1e6})
      EXPECT_LE(transitionMatrix(make, z, 0).spectralRadius(), 1 + 1e-9) << order << " " << z;
  }
  EXPECT_THROW(ArkodeDirk(5), InputError);
  EXPECT_THROW(ArkodeDirk(1), InputError);
}

TEST(ArkodeDirk, AdaptsItsStepsToTheTolerance) {
  for (const double tolerance : {1e-4, 1e-6, 1e-8}) {
    ImplicitOptions options;
    options.relativeTolerance = tolerance;
    const double error = oscillatorError([&] { return std::make_unique<ArkodeDirk>(4, true, options); }, 1, 0.1);
    EXPECT_LT(error, 30 * tolerance);
  }
}

Body bar() {
  BarOptions options;
  options.size = {0.2, 0.04, 0.04};
  options.cells = {5, 1, 1};
  options.jitter = 0.2;
  Body body(generateBar(options), makeMaterial("stvk", 30e3, 0.3, 1000), {{}, Lumping::rowSum, 1});
  for (const std::int32_t node : body.mesh().nodeSets.at("x-min")) body.constraints().fix(node);
  return body;
}

TEST(Sundials, StiffBarIsStableAtFiftyTimesTheExplicitStep) {
  Body body = bar();
  body.addBodyForce({0, 0, -1});
  const double h = 50 * 2 / std::sqrt(globalFrequency(body, body.mesh().X).lambda);
  for (const IntegratorEntry& entry : sundialsIntegrators()) {
    const auto integrator = entry.make();
    BodySystem system(body);
    State state = system.initialState();
    for (int k = 0; k < 20; ++k) {
      const StepStatus status = integrator->step(system, state, h);
      ASSERT_TRUE(status.done) << entry.info->name << ": " << status.reason;
    }
    EXPECT_NEAR(state.time, 20 * h, 1e-12);
    Body::Workspace workspace;
    const double sag = (state.x - body.mesh().X).cwiseProduct(body.externalForce()).sum();
    const double energy = 0.5 * (state.v * body.lumpedMass().asDiagonal()).cwiseProduct(state.v).sum() +
                          body.energy(state.x, workspace) - sag;
    EXPECT_LT(energy, 1e-5 * sag) << entry.info->name;  // it started from zero, and no method here adds energy
    EXPECT_GT(sag, 0);
  }
}

TEST(Sundials, LinearSolversAgree) {
  Body body = bar();
  body.addBodyForce({0, 0, -1});
  const double h = 10 * 2 / std::sqrt(globalFrequency(body, body.mesh().X).lambda);
  NodeVectors x[2];
  for (const LinearSolve solve : {LinearSolve::direct, LinearSolve::conjugateGradients}) {
    ImplicitOptions options;
    options.linearSolve = solve;
    ArkodeDirk integrator(3, false, options);
    BodySystem system(body, {1, 1e-3});
    State state = system.initialState();
    for (int k = 0; k < 5; ++k) {
      const StepStatus status = integrator.step(system, state, h);
      ASSERT_TRUE(status.done) << status.reason;
    }
    x[static_cast<int>(solve)] = state.x;
  }
  EXPECT_LT((x[0] - x[1]).norm(), 1e-7 * (x[0] - body.mesh().X).norm());
}

TEST(Sundials, PrescribedMotionIsExact) {
  Body body = bar();
  for (const std::int32_t node : body.mesh().nodeSets.at("x-max")) body.constraints().move(node, 0, 0.05);
  for (const IntegratorEntry& entry : sundialsIntegrators()) {
    const auto integrator = entry.make();
    BodySystem system(body);
    State state = system.initialState();
    for (int k = 0; k < 10; ++k) ASSERT_TRUE(integrator->step(system, state, 0.01).done);
    for (const std::int32_t node : body.mesh().nodeSets.at("x-max"))
      EXPECT_NEAR(state.x(0, node), 0.2 + 0.1 * 0.05, 1e-9) << entry.info->name;
    for (const std::int32_t node : body.mesh().nodeSets.at("x-min"))
      EXPECT_NEAR(state.x(0, node), 0, 1e-12) << entry.info->name;
  }
}

/// A force that breaks after some evaluations.
class Breaking final : public DifferentiableSystem {
 public:
  void acceleration(double time, const NodeVectors& x, const NodeVectors&, NodeVectors& a) override {
    a = -x;
    if (time > 0.15) a(0, 0) = std::numeric_limits<double>::quiet_NaN();
  }
  const Eigen::VectorXd& mass() const override { return mass_; }
  void stiffnessProduct(const NodeVectors&, const NodeVectors& u, NodeVectors& Ku) override { Ku = u; }
  Eigen::SparseMatrix<double> stiffness(const NodeVectors&) override {
    Eigen::SparseMatrix<double> K(3, 3);
    K.setIdentity();
    return K;
  }

 private:
  Eigen::VectorXd mass_ = Eigen::VectorXd::Ones(1);
};

TEST(Sundials, FailureIsAStatusAndLeavesTheState) {
  for (const IntegratorEntry& entry : sundialsIntegrators()) {
    const auto integrator = entry.make();
    Breaking system;
    State state{0, NodeVectors::Ones(3, 1), NodeVectors::Zero(3, 1)};
    ASSERT_TRUE(integrator->step(system, state, 0.1).done);
    const State before = state;
    const StepStatus status = integrator->step(system, state, 0.1);
    EXPECT_FALSE(status.done);
    EXPECT_THAT(status.reason,
                ::testing::AllOf(::testing::HasSubstr("t = 0.1 s, h = 0.1 s"), ::testing::HasSubstr("residual")));
    EXPECT_EQ(state.x, before.x);
    EXPECT_EQ(state.v, before.v);
    EXPECT_EQ(state.time, before.time);
    // And it goes on with a system that works.
    Oscillator oscillator;
    EXPECT_TRUE(integrator->step(oscillator, state, 0.1).done) << entry.info->name;
  }
}

class NoTangent final : public SecondOrderSystem {
 public:
  void acceleration(double, const NodeVectors& x, const NodeVectors&, NodeVectors& a) override { a = -x; }
};
TEST(Sundials, AsksForATangent) {
  NoTangent system;
  State state{0, NodeVectors::Ones(3, 1), NodeVectors::Zero(3, 1)};
  for (const IntegratorEntry& entry : sundialsIntegrators()) EXPECT_FALSE(entry.make()->step(system, state, 0.1).done);
}

TEST(Equilibrium, BalancesAHangingBar) {
  Body body = bar();
  body.addBodyForce({0, 0, -2});
  for (const LinearSolve solve : {LinearSolve::direct, LinearSolve::conjugateGradients}) {
    ImplicitOptions options;
    options.linearSolve = solve;
    BodySystem system(body);
    NodeVectors x = body.mesh().X;
    const EquilibriumStatus status = solveEquilibrium(system, 0, x, 1e-9, options);
    ASSERT_TRUE(status.done) << status.reason;
    EXPECT_GT(status.iterations, 0);
    NodeVectors a;
    system.acceleration(0, x, 0 * x, a);
    EXPECT_LT((a * body.lumpedMass().asDiagonal()).cwiseAbs().maxCoeff(),
              1e-8 * body.externalForce().cwiseAbs().maxCoeff());
    EXPECT_LT((x - body.mesh().X).row(2).minCoeff(), -1e-3);  // it sags
    for (const std::int32_t node : body.mesh().nodeSets.at("x-min")) EXPECT_EQ(x.col(node), body.mesh().X.col(node));
  }
}

TEST(Equilibrium, SaysWhyItFailed) {
  Body body(generateBar(BarOptions{}), makeMaterial("stvk", 30e3, 0.3, 1000),
            {{}, Lumping::rowSum, 1});  // held by nothing
  body.addBodyForce({0, 0, -2});
  BodySystem system(body);
  NodeVectors x = body.mesh().X;
  const EquilibriumStatus status = solveEquilibrium(system, 0, x);
  EXPECT_FALSE(status.done);
  EXPECT_FALSE(status.reason.empty());
  EXPECT_EQ(x, body.mesh().X);
}

}  // namespace
}  // namespace ringwatch
