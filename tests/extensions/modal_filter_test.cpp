// Modal filter: eigenvalues against dense ones, constraints against differences, and the handler's stability and runs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include <Eigen/Geometry>

#include <ringwatch/base/eigen_instances.h>
#include <ringwatch/base/error.h>
#include <ringwatch/extensions/modal_filter/filtered_stiffness.h>
#include <ringwatch/extensions/modal_filter/modal_filter.h>
#include <ringwatch/meshes/quality.h>
#include <tests/handlers/handler_cases.h>

namespace ringwatch {
namespace {

using test::criticalStepOf;
using test::everyElement;
using ::testing::HasSubstr;
using Matrix12 = Eigen::Matrix<double, 12, 12>;
using Vector12 = Eigen::Matrix<double, 12, 1>;

std::unique_ptr<Handler> filtered(Body& body, double h, std::string_view variant = "auto",
                                  std::string_view base = "symplectic-euler",
                                  Selection selection = Selection::certified) {
  auto handler =
      makeHandler("modal-filter", body, makeIntegrator(base), {.selection = selection, .own = {{"variant", variant}}});
  handler->prepare(body.mesh().X, h);
  return handler;
}

// Against the definition: the generalised eigenvalues of K' are min(mu, 1), its vectors those of K.
TEST(ModalFilter, CutsTheEigenvaluesAndNothingElse) {
  const Body body = test::sliverBody("corotational", 0.9);
  test::Random random(3);
  int modes[7] = {};
  for (const ElementRef e : everyElement(body)) {
    const Matrix12 K = body.elementTangent(e, body.mesh().X);
    Eigen::Vector4d allowance;
    for (int a = 0; a < 4; ++a) allowance[a] = 0.2 * K.norm() * random.uniform(0.1, 1);
    Vector12 T;
    for (int d = 0; d < 12; ++d) T[d] = allowance[d / 3];
    const FilteredStiffness filtered = filterModes(K, allowance);
    const test::GeneralizedEigen before = test::generalizedEigen(0.5 * (K + K.transpose()), T.asDiagonal()),
                                 after = test::generalizedEigen(filtered.kept, T.asDiagonal());
    int cut = 0;
    for (int k = 0; k < 12; ++k) {
      EXPECT_NEAR(after.values[k], std::min(before.values[k], 1.0), 1e-9);
      cut += before.values[k] > 1;
      const Vector12 phi = before.vectors.col(k);
      EXPECT_LE((filtered.kept * phi - std::min(before.values[k], 1.0) * T.cwiseProduct(phi)).norm(),
                1e-9 * T.cwiseProduct(phi).norm());
    }
    EXPECT_EQ(filtered.modes, cut);
    ++modes[cut];
    Matrix12 whole = filtered.kept;
    for (int k = 0; k < filtered.modes; ++k)
      whole += filtered.mode.col(k) * filtered.mode.col(k).transpose() / filtered.compliance[k];
    EXPECT_LE((whole - K).norm(), 1e-10 * K.norm());
  }
  EXPECT_GT(std::count_if(modes + 1, modes + 7, [](int n) { return n > 0; }), 2);  // several numbers of them occur
}

TEST(ShapeConstraints, HaveTheGradientOfTheirDifferences) {
  test::Random random(8);
  for (const ConstraintKind kind : {ConstraintKind::edge, ConstraintKind::height, ConstraintKind::volume})
    for (int trial = 0; trial < 20; ++trial) {
      const NodeVectors x = random.nodeVectors(4, 1);
      const ShapeConstraint c{
          kind, {0, 1, kind == ConstraintKind::edge ? -1 : 2, kind == ConstraintKind::edge ? -1 : 3}, 0.7};
      Eigen::Matrix<double, 3, 4> gradient, unused;
      constraintValue(c, x, gradient);
      constexpr double unit = 1e-6;
      for (int a = 0; a < 4; ++a)
        for (int i = 0; i < 3; ++i) {
          NodeVectors plus = x, minus = x;
          plus(i, a) += unit;
          minus(i, a) -= unit;
          EXPECT_NEAR((constraintValue(c, plus, unused) - constraintValue(c, minus, unused)) / (2 * unit),
                      gradient(i, a), 1e-6 * (1 + gradient.norm()));
        }
    }
}

TEST(ShapeConstraints, FollowTheShapeOfTheElement) {
  const auto kinds = [](const Eigen::Matrix<double, 3, 4>& corners) {
    Mesh mesh = test::gridMesh("tet4", {1, 1, 1}, {1, 1, 1});
    mesh.X = corners;
    mesh.blocks[0].connectivity = {0, 1, 2, 3};
    mesh.blocks[0].ids = {1};
    std::string text(shapeName(elementShape(mesh.blocks[0], 0, mesh.X, 0).shape));
    for (const ShapeConstraint& c : shapeConstraints(mesh, {{0, 0}})) {
      EXPECT_GT(c.rest, 0);
      text += c.kind == ConstraintKind::edge ? " edge" : c.kind == ConstraintKind::height ? " height" : " volume";
    }
    return text;
  };
  Eigen::Matrix<double, 3, 4> x;
  x << 0, 1, 0.5, 0.5, 0, 0, 0.9, 0.3, 0, 0, 0, 0.02;
  EXPECT_EQ(kinds(x), "cap height");
  x << -1, 0, 1, 0, 0, -1, 0, 1, 0, 0.02, 0, 0.02;
  EXPECT_EQ(kinds(x), "sliver volume");
  x << 0, 1, 0.5, 0.5, 0, 0, 0.9, 0.9, 0, 0, -0.01, 0.01;
  EXPECT_EQ(kinds(x), "wedge edge");
  x << 0, 0.02, 0, 0, 0, 0, 0.02, 0, 0, 0, 0, 1;
  EXPECT_EQ(kinds(x), "needle edge edge edge");
  x << 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1;
  EXPECT_EQ(kinds(x), "round volume");
}

TEST(Projection, MeetsItsToleranceAndKeepsMomentum) {
  const Body body = test::sliverBody("corotational", 0.98, false);
  std::vector<ElementRef> few{{0, 3}, {0, 60}, {0, 120}, {0, 130}, {0, 200}};
  ConstraintProjection projection(body, shapeConstraints(body.mesh(), few), 1e-10, 20);
  test::Random random(2);
  const NodeVectors start = body.mesh().X + random.nodeVectors(body.nodeCount(), 5e-4);
  NodeVectors x = start;
  EXPECT_EQ(projection.project(x), "");
  EXPECT_GT(projection.iterations(), 1);
  Eigen::Matrix<double, 3, 4> gradient;
  for (const ShapeConstraint& c : projection.constraints()) EXPECT_LE(std::abs(constraintValue(c, x, gradient)), 1e-10);
  const NodeVectors move = x - start;
  EXPECT_LE((move * body.lumpedMass()).norm(), 1e-12 * move.norm() * body.totalMass());
  ConstraintProjection hasty(body, shapeConstraints(body.mesh(), few), 1e-10, 1);
  x = start;
  EXPECT_THAT(hasty.project(x), HasSubstr("did not meet its 5 constraints in 1 iterations"));
}

TEST(ModalFilter, LeavesRigidMotionAlone) {
  for (const char* variant : {"compliant", "projection"}) {
    Body body = test::sliverBody("corotational", 0.95, false);
    const double h = 1.5 * criticalStepOf(body);
    const auto handler = filtered(body, h, variant);
    ASSERT_FALSE(handler->elements().empty());
    BodySystem system(body);
    const Eigen::Matrix3d Q(Eigen::AngleAxisd(2.1, Eigen::Vector3d(1, -2, 0.5).normalized()));
    const Eigen::Vector3d v(0.5, 0.1, -0.4);
    State state = system.initialState();
    state.x = Q * body.mesh().X;
    state.v.colwise() = v;
    const NodeVectors x = state.x;
    for (int i = 0; i < 50; ++i) {
      const StepStatus status = handler->step(system, state, h);
      ASSERT_TRUE(status.done) << status.reason;
    }
    EXPECT_LE((state.x - (x.colwise() + 50 * h * v)).cwiseAbs().maxCoeff(), 1e-9) << variant;
  }
}

class FilteredStability : public ::testing::TestWithParam<Selection> {};
INSTANTIATE_TEST_SUITE_P(All, FilteredStability, ::testing::Values(Selection::certified, Selection::elementFrequency),
                         [](const auto& test) { return test::testName(selectionNames.nameOf(test.param)); });

TEST_P(FilteredStability, NoModeGrowsAtManyTimesTheCriticalStep) {
  Body body = test::sliverBody("corotational", 0.98);
  const double h = 4 * criticalStepOf(body);
  const auto handler = filtered(body, h, "auto", "symplectic-euler", GetParam());
  EXPECT_FALSE(handler->elements().empty());
  EXPECT_TRUE(handler->certified());
  EXPECT_LE(test::spectralRadius(body, *handler, h, 1e-7), 1 + 1e-5);
}

TEST(ModalFilter, KeepsBothMomentaAndBoundsTheEnergy) {
  Body body = test::sliverBody("corotational", 0.98, false);
  const double h = 4 * criticalStepOf(body);
  const auto handler = filtered(body, h);
  const test::LongRun run = test::longRun(*handler, body, h, 2000);
  ASSERT_EQ(run.steps, 2000);
  EXPECT_LT(run.highestEnergy, 1.02);
  EXPECT_LE(run.momentumDrift, 1e-11);
  EXPECT_LE(run.angularDrift, 1e-9);
}

double errorOf(const char* variant, double nu, double times) {
  const test::Swing swing{.nu = nu};
  return test::swingError(swing, 0.05, times * criticalStepOf(swing.body()),
                          [&](Body& body, double h) { return filtered(body, h, variant, "verlet"); });
}

TEST(ModalFilter, FollowsTheMotion) {
  EXPECT_LT(errorOf("compliant", test::poisson, 3), 0.01);
  EXPECT_LT(errorOf("compliant", 0.499, 3), 0.05);
  EXPECT_LT(errorOf("projection", test::poisson, 1.3), 0.1);
}

TEST(Projection, SaysWhenItsConstraintsContradictEachOther) {
  const Body body = test::sliverBody("corotational", 0.98, false);
  std::vector<ShapeConstraint> both;
  for (const double length : {0.02, 0.03}) both.push_back({ConstraintKind::edge, {0, 1, -1, -1}, length});
  ConstraintProjection projection(body, both, 1e-8, 20);
  NodeVectors x = body.mesh().X;
  EXPECT_THAT(projection.project(x), HasSubstr("constraints"));
}

TEST(ModalFilter, SaysWhenTheProjectionDoesNotConverge) {
  Body body = test::sliverBody("corotational", 0.95);
  const HandlerOptions options{.own = {{"variant", "projection"}, {"tolerance", 1e-14}, {"iterations", 1}}};
  const double h = 3 * criticalStepOf(body);
  const auto handler = makeHandler("modal-filter", body, makeIntegrator("verlet"), options);
  handler->prepare(body.mesh().X, h);
  BodySystem system(body);
  State state = system.initialState();
  test::Random random(4);
  state.v = random.nodeVectors(body.nodeCount(), 0.1);
  body.constraints().imposeVelocity(state.v);
  const State before = state;
  const StepStatus status = handler->step(system, state, h);
  EXPECT_FALSE(status.done);
  EXPECT_THAT(status.reason, HasSubstr("constraints"));
  EXPECT_EQ(state.x, before.x);
  EXPECT_EQ(state.v, before.v);
  EXPECT_EQ(state.time, 0);
}

TEST(ModalFilter, SurvivesAStepThatMakesEverythingCritical) {
  Body body = test::sliverBody("corotational", 0.98);
  body.addBodyForce({0, 0, -1});
  const double h = 50 * criticalStepOf(body);
  const auto handler = filtered(body, h);
  EXPECT_EQ(handler->elements().size(), body.mesh().elementCount());
  BodySystem system(body);
  State state = system.initialState();
  for (int i = 0; i < 200; ++i) ASSERT_TRUE(handler->step(system, state, h).done);
  EXPECT_LT((state.x - body.mesh().X).cwiseAbs().maxCoeff(), 0.2);
}

TEST(ModalFilter, HoldsAnIsolatedSliverWithAnyNodesFixed) {
  for (const int fixed : {0, 1, 2, 3, 4}) {
    Mesh mesh = test::gridMesh("tet4", {1, 1, 1}, {1, 1, 1});
    mesh.X = (Eigen::Matrix<double, 3, 4>() << -0.01, 0, 0.01, 0, 0, -0.011, 0, 0.009, 0, 2e-4, 0, 2e-4).finished();
    mesh.blocks[0].connectivity = {0, 1, 2, 3};
    mesh.blocks[0].ids = {1};
    mesh.nodeSets.clear();
    mesh.elementSets.clear();
    mesh.nodeIds.clear();
    Body body(mesh, makeMaterial("corotational", test::young, test::poisson, test::density), {{}, Lumping::rowSum, 1});
    for (int n = 0; n < fixed; ++n) body.constraints().fix(n);
    body.addBodyForce({0, 0.2, -1});
    const auto handler = filtered(body, 1e-3);
    BodySystem system(body);
    State state = system.initialState();
    for (int i = 0; i < 500; ++i) ASSERT_TRUE(handler->step(system, state, 1e-3).done) << fixed;
    ASSERT_TRUE(state.x.allFinite());
    EXPECT_GT(body.leastDeterminant(state.x).value, 0.5) << fixed;
    for (int n = 0; n < fixed; ++n) EXPECT_EQ(state.x.col(n), body.mesh().X.col(n));
  }
}

TEST(ModalFilter, TurnsAnInvertedElementBackAndReportsNotANumber) {
  Body body = test::sliverBody("corotational", 0.98);
  const double h = 4 * criticalStepOf(body);
  const auto handler = filtered(body, h);
  BodySystem system(body);
  State state = system.initialState();
  const auto nodes = body.blocks()[0]->nodesOf(handler->elements().front().element);
  state.x.col(nodes[3]) += 1.2 * (state.x.col(nodes[0]) - state.x.col(nodes[3]));
  ASSERT_LT(body.leastDeterminant(state.x).value, 0.1);
  for (int i = 0; i < 3000; ++i) ASSERT_TRUE(handler->step(system, state, h).done);
  EXPECT_GT(body.leastDeterminant(state.x).value, 0.3);
  state.x(1, nodes[2]) = std::nan("");
  const StepStatus status = handler->step(system, state, h);
  EXPECT_FALSE(status.done);
  EXPECT_THAT(status.reason, HasSubstr("finite"));
}

TEST(SingleElementSelection, ProvesItsRest) {
  const Body body = test::sliverBody("corotational", 0.98);
  const double lambda = std::pow(2 / (1.3 * criticalStepOf(body)), 2);
  const ElementFlags chosen = selectBySingleElement(body, body.mesh().X, lambda);
  EXPECT_FALSE(chosenElements(chosen).empty());
  EXPECT_LT(chosenElements(chosen).size(), body.mesh().elementCount());
  EXPECT_LE(test::denseHighest(body, test::stiffnessOf(body, body.mesh().X, chosen, false), body.lumpedMass()), lambda);
  EXPECT_THROW(selectBySingleElement(body, body.mesh().X, 0), InputError);
}

}  // namespace
}  // namespace ringwatch
