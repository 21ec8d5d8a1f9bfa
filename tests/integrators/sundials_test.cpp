// The implicit integrators: closed forms, large steps, linear solvers against each other, failures that leave the state
// alone.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <sstream>

#include <arkode/arkode_arkstep.h>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/base/error.h>
#include <ringwatch/integrators/body_system.h>
#include <ringwatch/integrators/partitioned_body_system.h>
#include <ringwatch/integrators/stability_limit.h>
#include <ringwatch/integrators/sundials/additive.h>
#include <ringwatch/integrators/sundials/implicit.h>
#include <ringwatch/integrators/sundials/registry.h>
#include <ringwatch/meshes/generators/generators.h>
#include <ringwatch/monitor/bounds/global_frequency.h>
#include <ringwatch/monitor/metrics/stiff_elements.h>
#include <ringwatch/verify/integrators/integrators.h>
#include <ringwatch/verify/integrators/oscillator.h>

#include <tests/support/dense.h>

namespace ringwatch {
namespace {

TEST(Sundials, IntegratorsLiveUpToTheirDeclarations) {
  const StudyReport report = verifyIntegrators(StudyEffort::quick, sundialsIntegrators());
  EXPECT_FALSE(report.checks.empty());
  for (const StudyCheck& check : report.checks)
    EXPECT_TRUE(check.passed()) << check.name << ": measured " << check.measured << ", expected " << check.expected;
}

TEST(Sundials, DocumentationHoldsTheTableOfDeclarations) {
  std::ifstream file(RINGWATCH_SOURCE_DIR "/docs/integrators.md");
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  std::istringstream table(integratorTable(sundialsIntegrators()));
  for (std::string row; std::getline(table, row);) EXPECT_THAT(text, ::testing::HasSubstr(row + "\n"));
}

TEST(Sundials, CatalogKnowsBothLists) {
  const IntegratorCatalog catalog{coreIntegrators(), sundialsIntegrators()};
  for (const char* name : {"verlet", "implicit-euler", "arkode-dirk", "cvode-bdf", "arkode-ark", "arkode-mri"})
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

std::vector<ElementRef> everySecond(const Body& body) {
  std::vector<ElementRef> elements;
  for (std::int32_t e = 0; e < body.blocks()[0]->elementCount(); e += 2) elements.push_back({0, e});
  return elements;
}

TEST(Sundials, StepsForwardAndBack) {
  for (const IntegratorEntry& entry : sundialsIntegrators()) {
    const auto integrator = entry.make();
    Oscillator whole;
    AdditiveOscillator parts(1, 0, 0.5);
    SecondOrderSystem& system = entry.info->partitioned ? static_cast<SecondOrderSystem&>(parts) : whole;
    State state{0, NodeVectors::Ones(3, 1), NodeVectors::Zero(3, 1)};
    for (const double h : {0.01, -0.01})
      for (int k = 0; k < 10; ++k) {
        const StepStatus status = integrator->step(system, state, h);
        ASSERT_TRUE(status.done) << entry.info->name << ": " << status.reason;
      }
    EXPECT_NEAR(state.time, 0, 1e-15);
    EXPECT_NEAR(state.x(0, 0), 1, entry.info->order == 1 ? 2e-3 : 1e-5) << entry.info->name;
  }
}

TEST(Sundials, StiffBarIsStableAtFiftyTimesTheExplicitStep) {
  Body body = bar();
  body.addBodyForce({0, 0, -1});
  const double h = 50 * 2 / std::sqrt(globalFrequency(body, body.mesh().X).lambda);
  int tried = 0;
  for (const IntegratorEntry& entry : sundialsIntegrators()) {
    if (!std::isinf(entry.info->imaginaryLimit)) continue;
    ++tried;
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
  EXPECT_GE(tried, 3);  // implicit Euler, DIRK and BDF
}

TEST(Sundials, LinearSolversAgree) {
  Body body = bar();
  body.addBodyForce({0, 0, -1});
  const double h = 10 * 2 / std::sqrt(globalFrequency(body, body.mesh().X).lambda);
  NodeVectors x[3];
  for (const LinearSolve solve : {LinearSolve::direct, LinearSolve::conjugateGradients, LinearSolve::gmres}) {
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
  for (const int other : {1, 2}) EXPECT_LT((x[0] - x[other]).norm(), 1e-7 * (x[0] - body.mesh().X).norm()) << other;
}

/// Two masses' worth of components: one spring pulls back, one pushes away, ẍ = -diag(k) x.
class Saddle final : public DifferentiableSystem {
 public:
  void acceleration(double, const NodeVectors& x, const NodeVectors&, NodeVectors& a) override {
    stiffnessProduct(x, x, a);
    a *= -1;
  }
  const Eigen::VectorXd& mass() const override { return mass_; }
  void stiffnessProduct(const NodeVectors&, const NodeVectors& u, NodeVectors& Ku) override {
    Ku = k_.asDiagonal() * u;
  }
  Eigen::SparseMatrix<double> stiffness(const NodeVectors&) override {
    Eigen::SparseMatrix<double> K(3, 3);
    for (int c = 0; c < 3; ++c) K.insert(c, c) = k_[c];
    return K;
  }

 private:
  Eigen::Vector3d k_{4, -3, 1};
  Eigen::VectorXd mass_ = Eigen::VectorXd::Ones(1);
};

// With h = 1, M + h² K has a negative eigenvalue: x' = (x + h v)/(1 + h² k) by implicit Euler all the same.
TEST(Sundials, GmresSolvesWhatConjugateGradientsRefuse) {
  for (const LinearSolve solve : {LinearSolve::direct, LinearSolve::conjugateGradients, LinearSolve::gmres}) {
    ImplicitOptions options;
    options.linearSolve = solve;
    ImplicitEuler integrator(options);
    Saddle system;
    State state{0, NodeVectors::Ones(3, 1), NodeVectors::Ones(3, 1)};
    const StepStatus status = integrator.step(system, state, 1);
    if (solve == LinearSolve::conjugateGradients) {
      EXPECT_FALSE(status.done);
      EXPECT_THAT(status.reason, ::testing::HasSubstr("indefinite matrix"));
      EXPECT_EQ(state.x, NodeVectors::Ones(3, 1));
      continue;
    }
    ASSERT_TRUE(status.done) << status.reason;
    EXPECT_NEAR(state.x(0, 0), 2.0 / 5, 1e-7);
    EXPECT_NEAR(state.x(1, 0), 2.0 / -2, 1e-7);
    EXPECT_NEAR(state.x(2, 0), 2.0 / 2, 1e-7);
  }
}

/// Counts the calls that assemble.
class Assemblies final : public DifferentiableSystem {
 public:
  explicit Assemblies(const Body& body) : system_(body) {}
  void acceleration(double t, const NodeVectors& x, const NodeVectors& v, NodeVectors& a) override {
    system_.acceleration(t, x, v, a);
  }
  const Eigen::VectorXd& mass() const override { return system_.mass(); }
  void stiffnessProduct(const NodeVectors& x, const NodeVectors& u, NodeVectors& Ku) override {
    ++products;
    system_.stiffnessProduct(x, u, Ku);
  }
  Eigen::SparseMatrix<double> stiffness(const NodeVectors& x) override {
    ++matrices;
    return system_.stiffness(x);
  }
  void stiffnessDiagonal(const NodeVectors& x, std::vector<Eigen::Matrix3d>& blocks) override {
    ++diagonals;
    system_.stiffnessDiagonal(x, blocks);
  }
  bool isConstrained(std::int32_t node, int component) const override { return system_.isConstrained(node, component); }
  State initialState() const { return system_.initialState(); }
  int products = 0, matrices = 0, diagonals = 0;

 private:
  BodySystem system_;
};

TEST(Sundials, MatrixFreeSolversAssembleRarely) {
  Body body = bar();
  body.addBodyForce({0, 0, -1});
  const double h = 10 * 2 / std::sqrt(globalFrequency(body, body.mesh().X).lambda);
  for (const LinearSolve solve : {LinearSolve::conjugateGradients, LinearSolve::gmres}) {
    ImplicitOptions options;
    options.linearSolve = solve;
    ImplicitEuler integrator(options);
    Assemblies system(body);
    State state = system.initialState();
    for (int k = 0; k < 20; ++k) ASSERT_TRUE(integrator.step(system, state, h).done);
    EXPECT_EQ(system.matrices, 0);
    EXPECT_GE(system.diagonals, 1);
    EXPECT_LE(system.diagonals, 4);
    EXPECT_GT(system.products, 100);
  }
}

TEST(BodySystem, DiagonalBlocksAreThoseOfTheMatrix) {
  const Body body = bar();
  BodySystem system(body);
  const NodeVectors x = 1.1 * body.mesh().X;
  std::vector<Eigen::Matrix3d> blocks, assembled;
  system.stiffnessDiagonal(x, blocks);
  system.DifferentiableSystem::stiffnessDiagonal(x, assembled);
  ASSERT_EQ(blocks.size(), assembled.size());
  for (std::size_t i = 0; i < blocks.size(); ++i)
    EXPECT_LT((blocks[i] - assembled[i]).norm(), 1e-12 * blocks[i].norm());
}

TEST(Sundials, PrescribedMotionIsExact) {
  Body body = bar();
  for (const std::int32_t node : body.mesh().nodeSets.at("x-max")) body.constraints().move(node, 0, 0.05);
  for (const IntegratorEntry& entry : sundialsIntegrators()) {
    const auto integrator = entry.make();
    BodySystem whole(body);
    PartitionedBodySystem parts(body, everySecond(body));
    SecondOrderSystem& system = entry.info->partitioned ? static_cast<SecondOrderSystem&>(parts) : whole;
    State state = whole.initialState();
    const int steps = entry.info->partitioned ? 200 : 10;  // half of the elements are explicit
    for (int k = 0; k < steps; ++k) {
      const StepStatus status = integrator->step(system, state, 0.1 / steps);
      ASSERT_TRUE(status.done) << entry.info->name << ": " << status.reason;
    }
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

/// The same in either part.
class BreakingInParts final : public AdditiveSystem {
 public:
  explicit BreakingInParts(bool stiffBreaks) : stiffBreaks_(stiffBreaks) {}
  SecondOrderSystem& nonstiff() override {
    return stiffBreaks_ ? sound_ : static_cast<DifferentiableSystem&>(breaking_);
  }
  DifferentiableSystem& stiff() override {
    return stiffBreaks_ ? static_cast<DifferentiableSystem&>(breaking_) : sound_;
  }

 private:
  bool stiffBreaks_;
  Breaking breaking_;
  Oscillator sound_;
};

class SundialsFailure : public ::testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(InEitherPart, SundialsFailure, ::testing::Bool(),
                         [](const auto& test) { return test.param ? "stiff_breaks" : "nonstiff_breaks"; });

TEST_P(SundialsFailure, IsAStatusAndLeavesTheState) {
  for (const IntegratorEntry& entry : sundialsIntegrators()) {
    const auto integrator = entry.make();
    Breaking whole;
    BreakingInParts parts(GetParam());
    SecondOrderSystem& system = entry.info->partitioned ? static_cast<SecondOrderSystem&>(parts) : whole;
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
    AdditiveOscillator oscillatorInParts(1, 0, 0.5);
    EXPECT_TRUE((entry.info->partitioned ? integrator->step(oscillatorInParts, state, 0.1)
                                         : integrator->step(oscillator, state, 0.1))
                    .done)
        << entry.info->name;
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

// One step from the tables themselves: Z_i = y + Σ_j (aE_ij A_E + aI_ij A_I) Z_j, y' = y + Σ_i b_i (A_E + A_I) Z_i.
Eigen::Matrix2d arkAmplification(double z, double stiffShare) {
  ARKodeButcherTable E = ARKodeButcherTable_LoadERK(ARKODE_ARK437L2SA_ERK_7_3_4);
  ARKodeButcherTable I = ARKodeButcherTable_LoadDIRK(ARKODE_ARK437L2SA_DIRK_7_3_4);
  Eigen::Matrix2d AE, AI;
  AE << 0, 0, -z * (1 - stiffShare), 0;
  AI << 0, z, -z * stiffShare, 0;
  Eigen::MatrixXd left = Eigen::MatrixXd::Identity(2 * E->stages, 2 * E->stages), right(2 * E->stages, 2);
  for (int i = 0; i < E->stages; ++i) {
    right.block<2, 2>(2 * i, 0).setIdentity();
    for (int j = 0; j < E->stages; ++j) left.block<2, 2>(2 * i, 2 * j) -= E->A[i][j] * AE + I->A[i][j] * AI;
  }
  const Eigen::MatrixXd Z = test::solve(left, right);
  Eigen::Matrix2d T = Eigen::Matrix2d::Identity();
  for (int i = 0; i < E->stages; ++i) T += (E->b[i] * AE + I->b[i] * AI) * Z.block<2, 2>(2 * i, 0);
  ARKodeButcherTable_Free(E);
  ARKodeButcherTable_Free(I);
  return T;
}

TEST(ArkodeArk, StepsAsItsTablesSay) {
  const IntegratorFactory make = [] { return std::make_unique<ArkodeArk>(); };
  for (const double share : {0.0, 0.3, 0.9, 1.0})
    for (const double z : {0.1, 1.0, 3.0}) {
      const TransitionMatrix T = transitionMatrix(make, z, 0, share);
      ASSERT_TRUE(T.found);
      EXPECT_LT((T.matrix - arkAmplification(z, share)).norm(), 1e-9) << z << " " << share;
    }
  const double limit = ArkodeArk::description.imaginaryLimit;
  EXPECT_TRUE(isStableAmplification(arkAmplification(limit - 1e-10, 0)));
  EXPECT_FALSE(isStableAmplification(arkAmplification(limit + 1e-10, 0)));
}

TEST(ArkodeArk, AdaptsItsStepsToTheTolerance) {
  for (const double tolerance : {1e-4, 1e-6, 1e-8}) {
    ImplicitOptions options;
    options.relativeTolerance = tolerance;
    EXPECT_LT(oscillatorError([&] { return std::make_unique<ArkodeArk>(true, options); }, 1, 0.1), 100 * tolerance);
  }
}

TEST(ArkodeMri, HasItsOrderWithEqualSmallSteps) {
  const IntegratorFactory make = [] { return std::make_unique<ArkodeMri>(8); };
  EXPECT_NEAR(measureOrder(make, 0), 3, 0.15);
  EXPECT_NEAR(measureOrder(make, 0.2), 3, 0.15);
  EXPECT_THROW(ArkodeMri(-1), InputError);
}

TEST(PartitionedBodySystem, PartsAddUpToTheBody) {
  Body body = bar();
  body.addBodyForce({0, 0, -1});
  const RayleighDamping damping{0.5, 1e-3};
  BodySystem whole(body, damping);
  NodeVectors x = body.mesh().X, v = body.mesh().X, a, b, Ku, Lu;
  x.row(1) *= 1.2;
  x.row(0) += 0.3 * x.row(2);
  whole.acceleration(0, x, v, a);
  for (const std::size_t kept : {std::size_t{0}, std::size_t{7}, body.mesh().elementCount()}) {
    std::vector<ElementRef> stiff;
    for (std::size_t e = 0; e < kept; ++e) stiff.push_back({0, static_cast<std::int32_t>(e)});
    PartitionedBodySystem parts(body, stiff, damping);
    parts.acceleration(0, x, v, b);
    EXPECT_LT((a - b).norm(), 1e-12 * a.norm()) << kept;
    auto& nonstiff = dynamic_cast<DifferentiableSystem&>(parts.nonstiff());
    whole.stiffnessProduct(x, v, Ku);
    parts.stiff().stiffnessProduct(x, v, Lu);
    NodeVectors sum = Lu;
    nonstiff.stiffnessProduct(x, v, Lu);
    sum += Lu;
    EXPECT_LT((Ku - sum).norm(), 1e-12 * Ku.norm()) << kept;
    const Eigen::SparseMatrix<double> K = whole.stiffness(x);
    EXPECT_LT((K - Eigen::SparseMatrix<double>(parts.stiff().stiffness(x) + nonstiff.stiffness(x))).norm(),
              1e-12 * K.norm());
    std::vector<Eigen::Matrix3d> own, assembled;
    parts.stiff().stiffnessDiagonal(x, own);
    parts.stiff().DifferentiableSystem::stiffnessDiagonal(x, assembled);
    for (std::size_t i = 0; i < own.size(); ++i) EXPECT_LT((own[i] - assembled[i]).norm(), 1e-9);
  }
  EXPECT_THROW(PartitionedBodySystem(body, {{0, 100000}}), InputError);
}

/// The bar with one inner node pulled nearly onto its neighbour: slivers around it.
Body barWithSlivers() {
  BarOptions options;
  options.size = {0.2, 0.04, 0.04};
  options.cells = {10, 2, 2};
  Mesh mesh = generateBar(options);
  const auto node = [&](int i) { return i + 11 * (1 + 3 * 1); };
  mesh.X(0, node(5)) += 0.998 * (mesh.X(0, node(6)) - mesh.X(0, node(5)));
  Body body(std::move(mesh), makeMaterial("stvk", 30e3, 0.3, 1000), {{}, Lumping::rowSum, 1});
  for (const std::int32_t n : body.mesh().nodeSets.at("x-min")) body.constraints().fix(n);
  body.addBodyForce({0, 0, -1});
  return body;
}

// At four times the explicit step of the mesh. The frequency of the explicit part is proven.
TEST(PartitionedBodySystem, AdditiveStepKeepsItsStepOnSlivers) {
  const Body body = barWithSlivers();
  const double h = 4 * 2 / std::sqrt(globalFrequency(body, body.mesh().X).lambda), allowed = 1.5;
  const std::vector<ElementRef> stiff = stiffElements(body, body.mesh().X, h, allowed);
  EXPECT_GT(stiff.size(), 3u);
  EXPECT_LT(stiff.size(), body.mesh().elementCount() / 2);
  // The rest alone, by a dense eigenvalue.
  PartitionedBodySystem system(body, stiff);
  Eigen::MatrixXd K = dynamic_cast<DifferentiableSystem&>(system.nonstiff()).stiffness(body.mesh().X);
  for (Eigen::Index r = 0; r < K.rows(); ++r)
    for (Eigen::Index c = 0; c < K.cols(); ++c)
      K(r, c) /= std::sqrt(body.lumpedMass()[r / 3] * body.lumpedMass()[c / 3]);
  const double top = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(K, Eigen::EigenvaluesOnly).eigenvalues().maxCoeff();
  EXPECT_LE(h * std::sqrt(top), allowed * (1 + 1e-9));

  BodySystem whole(body);
  const double end = 100 * h;
  State reference = whole.initialState(), state = reference, lost = reference;
  const auto pefrl = makeIntegrator("pefrl"), verlet = makeIntegrator("verlet");
  for (int k = 0; k < 1600; ++k) pefrl->step(whole, reference, end / 1600);
  ArkodeArk ark;
  for (int k = 0; k < 100; ++k) {
    const StepStatus status = ark.step(system, state, h);
    ASSERT_TRUE(status.done) << status.reason;
    verlet->step(whole, lost, h);
  }
  EXPECT_LT((state.x - reference.x).norm(), 1e-3 * (reference.x - body.mesh().X).norm());
  EXPECT_FALSE((lost.x - reference.x).norm() < (reference.x - body.mesh().X).norm());
}

}  // namespace
}  // namespace ringwatch
