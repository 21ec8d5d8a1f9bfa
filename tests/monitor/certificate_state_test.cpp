// The state of an incremental certificate: its two statements are checked, local updates keep them or change nothing.
#include <gtest/gtest.h>

#include <algorithm>

#include <Eigen/Geometry>

#include <ringwatch/meshes/generators/generators.h>
#include <ringwatch/monitor/incremental/local_update.h>
#include <ringwatch/monitor/incremental/run_certificate.h>
#include <tests/monitor/monitor_cases.h>

namespace ringwatch {
namespace {

/// What rounding leaves of a statement that holds: the sums and eigenvalues of verify() are computed in another order.
constexpr double rounding = 1e-9;

Body bar(std::string_view law) {
  BarOptions options;
  options.cells = {5, 3, 3};
  options.jitter = 0.2;
  return Body(generateBar(options), makeMaterial(law, 1e4, 0.3, 1000), test::onThreads(1));
}

/// A certificate at x for the nodal bound there, raised by a slack.
void start(RunCertificate& state, const NodeVectors& x, double slack) {
  state.setCertifiedEigenvalue((1 + slack) * state.weights().evaluate(x, 6).value);
  // The best bound need not be the last one, whose weights are kept.
  state.setCertifiedEigenvalue((1 + slack) * state.weights().last());
  state.distributeAllowances(x);
}

TEST(CertificateState, VerifiesBothStatements) {
  const Body body = bar("stvk");
  const NodeVectors& X = body.mesh().X;
  RunCertificate state(body);
  start(state, X, 0.06);
  EXPECT_LE(state.verify(X), rounding);
  EXPECT_GE(state.certifiedEigenvalue(), test::DenseTangent(body, X).largest());
  // An element above its allowance.
  const ElementRef e{0, 17};
  const double allowance = state.allowance(e), value = state.value(e);
  ASSERT_GT(value, 0);
  state.setAllowance(e, value / 1.25);
  EXPECT_NEAR(state.verify(X), 0.25, 1e-6);
  std::vector<std::vector<bool>> excluded{std::vector<bool>(body.mesh().elementCount(), false)};
  excluded[0][17] = true;
  state.setExcluded(excluded);
  EXPECT_LE(state.verify(X), rounding);
  state.setExcluded(e, false);
  state.setAllowance(e, allowance);
  // Sums above the certified eigenvalue.
  state.setCertifiedEigenvalue(state.certifiedEigenvalue() / 1.5);
  EXPECT_NEAR(state.verify(X), 0.5, 1e-6);
  // Another state, another tangent.
  state.setCertifiedEigenvalue(1.5 * state.certifiedEigenvalue());
  EXPECT_GT(state.verify(Eigen::Vector3d(1.3, 1, 1).asDiagonal() * X), 0.1);
  NodeVectors bad = X;
  bad(0, 0) = std::nan("");
  EXPECT_TRUE(std::isinf(state.verify(bad)));
}

TEST(CertificateState, RotatesWithTheElements) {
  const Body body = bar("stvk");
  const NodeVectors& X = body.mesh().X;
  const Eigen::Matrix3d R = Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, 2) / 3).toRotationMatrix();
  CertificateState<double> state(body);
  state.weights().evaluate(X, 6);
  state.setCertifiedEigenvalue(state.weights().last());
  for (std::int32_t e = 0; e < body.blocks()[0]->elementCount(); ++e)
    state.setAllowance({0, e}, state.weights().value({0, e}));
  EXPECT_LE(state.verify(X), rounding);
  EXPECT_GT(state.verify(R * X), 0.05);
  state.allowRotations();
  for (std::int32_t e = 0; e < body.blocks()[0]->elementCount(); ++e) state.setRotation({0, e}, R);
  EXPECT_LE(state.verify(R * X), rounding);
  EXPECT_GT(state.verify(X), 0.05);
}

TEST(RunCertificate, RaisesAndLowers) {
  const Body body = bar("neo-hookean");
  const NodeVectors& X = body.mesh().X;
  RunCertificate state(body);
  start(state, X, 0.06);
  EXPECT_TRUE(state.elementsOutsideBall(X, nullptr).empty());
  const double sigma = state.certifiedEigenvalue();
  state.moveTo(1.2 * sigma);
  EXPECT_LE(state.verify(X), rounding);
  state.moveTo(1.1 * sigma);
  EXPECT_LE(state.verify(X), rounding);
  EXPECT_TRUE(state.elementsOutsideBall(X, nullptr).empty());
  // Below what the elements need those without allowance are outside their balls.
  state.moveTo(0.8 * sigma);
  EXPECT_FALSE(state.elementsOutsideBall(X, nullptr).empty());
}

TEST(RunCertificate, RaisesForElementsThatHaveLeftTheirBallsWithoutAnEvaluation) {
  for (const std::string_view law : {"stvk", "neo-hookean", "corotational"}) {
    const Body body = bar(law);
    const NodeVectors x = Eigen::Vector3d(1.008, 1, 1).asDiagonal() * body.mesh().X;
    RunCertificate state(body);
    start(state, body.mesh().X, 0.02);
    const std::int64_t evaluated = state.statistics().evaluated;
    const std::vector<ElementRef> outside = state.elementsOutsideBall(x, nullptr);
    ASSERT_FALSE(outside.empty()) << law;
    // No allowance has grown yet.
    std::vector<RunCertificate::ElementOutside> violating = state.growBalls(x, outside);
    ASSERT_FALSE(violating.empty()) << law;
    for (const RunCertificate::ElementOutside& outsider : violating) EXPECT_GT(outsider.need, 1) << law;
    std::make_heap(violating.begin(), violating.end());
    for (const RunCertificate::ElementOutside& outsider : violating)
      EXPECT_LE(outsider.need, violating.front().need) << law;
    // What is called outside is that, or nearly.
    for (const ElementRef e : state.elementsOutsideBall(x, nullptr))
      EXPECT_NE(std::find(outside.begin(), outside.end(), e), outside.end()) << law << ", element " << e.element;
    state.moveTo(violating.front().need * state.certifiedEigenvalue());
    state.growBalls(violating);
    EXPECT_EQ(state.statistics().evaluated, evaluated);
    EXPECT_TRUE(state.elementsOutsideBall(x, nullptr).empty()) << law;
    EXPECT_LE(state.verify(x), rounding) << law;
    EXPECT_GE(state.certifiedEigenvalue(), test::DenseTangent(body, x).largest()) << law;
  }
}

TEST(RunCertificate, RaisesToTheValuesOfElements) {
  const Body body = bar("stvk");
  const NodeVectors x = Eigen::Vector3d(1.1, 1, 1).asDiagonal() * body.mesh().X;
  RunCertificate state(body);
  start(state, body.mesh().X, 0.02);
  const std::vector<ElementRef> outside = state.elementsOutsideBall(x, nullptr);
  std::vector<RunCertificate::Reference> now;
  state.evaluate(x, outside, false, now);
  ASSERT_GT(state.verify(x), rounding);
  state.raiseToValues(outside, 0.03);
  EXPECT_LE(state.verify(x), rounding);
  EXPECT_TRUE(state.elementsOutsideBall(x, nullptr).empty());
}

TEST(LocalUpdate, MendsTheNeighbourhoodOfAnElement) {
  const Body body = bar("stvk");
  NodeVectors x = body.mesh().X;
  RunCertificate state(body);
  start(state, x, 0.06);
  // One node moves inwards: the elements around it stiffen.
  const ElementRef e{0, 100};
  const auto nodes = body.blocks()[0]->nodesOf(e.element);
  x.col(nodes[0]) += 0.12 * (x.col(nodes[0]) - x.col(nodes[1]));
  std::vector<ElementRef> outside = state.elementsOutsideBall(x, nullptr);
  std::vector<RunCertificate::Reference> now;
  state.evaluate(x, outside, false, now);
  ASSERT_GT(state.verify(x), 0.05);
  int updates = 0;
  for (const ElementRef other : outside) {
    if (state.value(other) <= state.allowance(other)) continue;
    const std::vector<ElementRef> updated = localUpdate(state, x, other, {}, true);
    EXPECT_FALSE(updated.empty());
    EXPECT_LE(state.value(other), state.allowance(other));
    ++updates;
  }
  EXPECT_GT(updates, 0);
  EXPECT_EQ(state.statistics().localUpdates, updates);
  EXPECT_LE(state.verify(x), rounding);
  EXPECT_GE(state.certifiedEigenvalue(), test::DenseTangent(body, x).largest());
}

TEST(LocalUpdate, ThatIsRefusedLeavesWeightsAndAllowances) {
  const Body body = bar("stvk");
  const NodeVectors& X = body.mesh().X;
  RunCertificate state(body);
  start(state, X, 0.06);
  // Far stiffer everywhere, and no leave to raise the certified eigenvalue.
  const NodeVectors x = Eigen::Vector3d(1.6, 1.2, 1.2).asDiagonal() * X;
  std::vector<double> allowances;
  std::vector<NodalBound::Factor> weights;
  const auto note = [&] {
    allowances.clear();
    weights.clear();
    for (std::int32_t e = 0; e < body.blocks()[0]->elementCount(); ++e) {
      allowances.push_back(state.allowance({0, e}));
      for (int a = 0; a < 4; ++a) weights.push_back(state.weights().factor(state.weights().incidenceOf({0, e}, a)));
    }
  };
  note();
  const auto allowancesBefore = allowances;
  const auto weightsBefore = weights;
  EXPECT_TRUE(localUpdate(state, x, {0, 100}, {}, false).empty());
  note();
  EXPECT_EQ(allowances, allowancesBefore);
  for (std::size_t i = 0; i < weights.size(); ++i)
    for (std::size_t c = 0; c < 6; ++c)
      EXPECT_EQ(static_cast<double>(weights[i][c]), static_cast<double>(weightsBefore[i][c]));
  EXPECT_EQ(state.statistics().raises, 0);
  EXPECT_GT(state.value({0, 100}), state.allowance({0, 100}));
  EXPECT_LE(state.verify(X), rounding);  // the proof of before is whole
}

TEST(CertificateState, SumsTheAllowancesOfAllElementsAtANode) {
  const Body body = bar("stvk");
  RunCertificate state(body);
  start(state, body.mesh().X, 0.06);
  std::vector<Eigen::Matrix3d> sums(body.nodeCount(), Eigen::Matrix3d::Zero());
  for (std::int32_t e = 0; e < body.blocks()[0]->elementCount(); ++e) {
    const ElementRef element{0, e};
    const auto nodes = body.blocks()[0]->nodesOf(e);
    for (int a = 0; a < 4; ++a)
      sums[nodes[a]] += state.allowance(element) * state.weights().weight(state.weights().incidenceOf(element, a));
  }
  for (std::int32_t i = 0; i < body.nodeCount(); ++i)
    EXPECT_TRUE(state.sumOfAllowances(i).isApprox(sums[i], 1e-13)) << "node " << i;
}

TEST(TangentGrowth, IsThatOfTheoremSixteen) {
  const TangentGrowth growth = growthOf({2, 3, 5, 7, 11}, 13, 0.5);
  EXPECT_EQ(growth.value, 13);
  EXPECT_DOUBLE_EQ(growth.linear, 2 * std::sqrt((13 + 0.5 * 7) * 2 * 0.5) + 0.5 * 3);
  EXPECT_DOUBLE_EQ(growth.quadratic, 0.5 * (2 + 5));
  EXPECT_EQ(growth.radius, 11);
}

TEST(TangentGrowth, GivesTheRadiusThatAnAllowanceHas) {
  const TangentGrowth growth{3, 2, 5, 10};
  EXPECT_EQ(growth.at(0), 3);
  EXPECT_DOUBLE_EQ(growth.at(2), 27);
  EXPECT_TRUE(std::isinf(growth.at(10.5)));
  EXPECT_TRUE(std::isinf(growth.at(std::nan(""))));
  const double radius = validityRadius(growth, 100, 27);
  EXPECT_DOUBLE_EQ(radius, 2 * (1 - radiusRounding));
  EXPECT_LE(growth.at(radius), 27);
  EXPECT_EQ(validityRadius(growth, 100, 2.9), -1);
  EXPECT_LT(validityRadius(growth, 0.5, 27), 0.5);
  EXPECT_LT(validityRadius(TangentGrowth{3, 0, 0, 10}, 100, 4), 10);
  EXPECT_GT(validityRadius(TangentGrowth{3, 0, 0, 10}, 100, 4), 9.9);
}

}  // namespace
}  // namespace ringwatch
