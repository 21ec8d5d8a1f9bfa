// The incremental nodal bound along random paths: proven at every state, by dense eigenvalues and by its own two
// statements.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/body/law_of_packs.h>
#include <ringwatch/meshes/generators/generators.h>
#include <ringwatch/monitor/bounds/reduced_ring.h>
#include <ringwatch/monitor/incremental/incremental_nodal_bound.h>
#include <tests/monitor/monitor_cases.h>

namespace ringwatch {
namespace {

using test::DenseTangent;
using test::Hold;
using test::Subdivision;

class IncrementalNodalBoundTest : public ::testing::TestWithParam<Subdivision> {};
INSTANTIATE_TEST_SUITE_P(Subdivisions, IncrementalNodalBoundTest, ::testing::ValuesIn(test::allSubdivisions()),
                         [](const auto& test) { return test::testName(test.param.name); });

/// A path of states: a slow stretch, a shake of single nodes, a jump, and back; `at` in [0, 1].
NodeVectors pathState(const NodeVectors& X, double at, const NodeVectors& shake) {
  const double stretch = at < 0.6 ? 1 + at : at < 0.8 ? 1.6 - 3 * (at - 0.6) : 1;
  return Eigen::Vector3d(stretch, 1 - 0.2 * at, 1).asDiagonal() * X + std::sin(20 * at) * shake;
}

TEST_P(IncrementalNodalBoundTest, HoldsAtEveryStateOfAPath) {
  for (const LawInfo& law : allLaws())
    for (const Hold hold : {Hold::nothing, Hold::face, Hold::components}) {
      Body body = test::boxBody(GetParam(), law.name);
      test::holdBody(body, hold);
      const NodeVectors& X = body.mesh().X;
      test::Random random(12);
      const NodeVectors shake = random.nodeVectors(X.cols(), 0.08 * test::cellSize);
      IncrementalNodalBound bound(body);
      constexpr int steps = 60;
      std::int64_t evaluated = 0;
      for (int step = 0; step <= steps; ++step) {
        const NodeVectors x = pathState(X, static_cast<double>(step) / steps, shake);
        const DenseTangent dense(body, x);
        ASSERT_TRUE(dense.finite());
        const double lambda = dense.largest();
        const std::string what = joinText(law.name, ", ", test::holdName(hold), ", step ", step);
        StepEvaluation evaluation;
        const bool withForce = step % 4 > 1;
        ASSERT_GE(bound.update(x, withForce ? &evaluation : nullptr).value, lambda * (1 - 1e-9)) << what;
        if (withForce) test::expectForce(body, x, evaluation, what);
        EXPECT_LE(bound.verify(x), 1e-9) << what;
        evaluated += bound.statistics().evaluated;
        // The same state again gives the same bound.
        const double again = bound.certifiedEigenvalue();
        EXPECT_EQ(bound.update(x).value, again) << what;
        if (bound.tightenBound(x, LowerBound{lambda}, 0.05)) {
          ASSERT_GE(bound.update(x).value, lambda * (1 - 1e-9)) << what;
        }
      }
      EXPECT_GT(evaluated, 0);
    }
}

TEST_P(IncrementalNodalBoundTest, HoldsWhateverItMaySpend) {
  int raises = 0;
  for (const LawInfo& law : allLaws()) {
    const Body body = test::boxBody(GetParam(), law.name);
    const NodeVectors& X = body.mesh().X;
    test::Random random(12);
    const NodeVectors shake = random.nodeVectors(X.cols(), 0.08 * test::cellSize);
    std::int64_t evaluatedOfMore = std::numeric_limits<std::int64_t>::max();
    for (const double share : {infinity, 10.0, 0.0}) {
      WorkAccount account(body, share);
      IncrementalNodalBound bound(body, {}, &account);
      constexpr int steps = 60;
      std::int64_t evaluated = 0;
      for (int step = 0; step <= steps; ++step) {
        account.earn();
        const NodeVectors x = pathState(X, static_cast<double>(step) / steps, shake);
        const double lambda = DenseTangent(body, x).largest();
        const std::string what = joinText(law.name, ", ", share, ", step ", step);
        ASSERT_GE(bound.update(x).value, lambda * (1 - 1e-9)) << what;
        EXPECT_LE(bound.verify(x), 1e-9) << what;
        if (step > 0) evaluated += bound.statistics().evaluated;
        if (share == 0) raises += bound.statistics().raises;
        if (bound.tightenBound(x, LowerBound{lambda}, 0.05)) {
          evaluated += bound.statistics().evaluated;
          ASSERT_GE(bound.update(x).value, lambda * (1 - 1e-9)) << what;
          EXPECT_LE(bound.verify(x), 1e-9) << what;
          evaluated += bound.statistics().evaluated;
        }
      }
      if (law.tangentIsConstant) continue;  // its tangent stays, and so do its balls
      EXPECT_LE(evaluated, evaluatedOfMore) << law.name << ", " << share;
      evaluatedOfMore = evaluated;
    }
  }
  EXPECT_GT(raises, 0);
}

TEST(IncrementalNodalBound, KeepsAProofBelowItsCeilingWhenItMaySpendSomething) {
  const Body body = test::boxBody(test::allSubdivisions()[0], "stvk");
  const NodeVectors& X = body.mesh().X;
  for (const double share : {0.0, 0.1})
    for (const bool asked : {false, true}) {
      WorkAccount account(body, share);
      IncrementalNodalBound bound(body, {}, &account);
      const double ceiling = 1.5 * bound.update(X).value;
      bool kept = true;
      std::int64_t evaluated = 0;
      // To and fro, so that hardly anything of the debt is needed at the end.
      for (int step = 0; step <= 200; ++step) {
        account.earn();
        const double stretch = 1 + 0.1 * std::sin(0.1 * step);
        const NodeVectors x = Eigen::Vector3d(stretch, 1, 1).asDiagonal() * X;
        const double most = asked ? ceiling : infinity;
        kept = bound.update(x, nullptr, most).value <= ceiling && kept;
        evaluated += bound.statistics().evaluated;
        ASSERT_LE(bound.verify(x), 1e-9);
      }
      if (asked || share == 0) {
        EXPECT_EQ(kept, asked && share > 0);
      }
      if (share == 0) {
        EXPECT_EQ(evaluated, 0);
        EXPECT_EQ(bound.spent()[WorkOn::repairs], 0);
      }
    }
}

TEST(WorkAccount, EarnsSpendsAndForgives) {
  const Body body(test::box({"", "tet4", 5, "", 0}, {10, 10, 10}),
                  makeMaterial("stvk", test::young, 0.3, test::density), test::onThreads(1));
  const auto elements = static_cast<double>(body.mesh().elementCount());
  ASSERT_EQ(body.blocks()[0]->nodesPerElement(), 4);
  const double evaluation = 1728.0 / 26 * elements, force = 3.12 * elements;
  EXPECT_NEAR(WorkAccount::ofEvaluation(body), evaluation, 1e-12 * evaluation);
  EXPECT_NEAR(WorkAccount::ofForce(body), force, 1e-12 * force);
  // Of single elements the first and each pack take as much as several: 2550 and 600 units, and 100 each, where the
  // body is too large for the caches, and less where it is small.
  const Body larger(test::box({"", "tet4", 5, "", 0}, {17, 17, 17}),
                    makeMaterial("stvk", test::young, 0.3, test::density), test::onThreads(1));
  const std::vector<ElementRef> few{{0, 0}, {0, 1}, {0, 2}};
  for (const Body* of : {&body, &larger}) {
    const double cold = std::clamp(WorkAccount::ofForce(*of) / 60000, 0.2, 1.0);
    EXPECT_NEAR(WorkAccount::ofEvaluation(*of, few), cold * (3150 + 3 * 100) + lanes * 1728.0 / 26, 1e-9);
    EXPECT_NEAR(WorkAccount::ofGrowth(*of, few), cold * (1730 + 430 + 3 * 45), 1e-9);
    EXPECT_NEAR(WorkAccount::ofEvaluation(*of->blocks()[0], 1), cold * 100, 1e-9);
    EXPECT_NEAR(WorkAccount::ofEvaluation(*of->blocks()[0], lanes), cold * 700 + lanes * 1728.0 / 26, 1e-9);
  }
  WorkAccount account(body, 0.5);
  EXPECT_TRUE(account.limited());
  // A hundred steps' share of the proven side is there in advance.
  EXPECT_TRUE(account.affords(34.99 * force));
  EXPECT_FALSE(account.affords(35.01 * force));
  EXPECT_FALSE(account.affordsForMode(1));
  EXPECT_FALSE(account.affordsForProof(1));
  account.earn();
  // Of an income the upper side has 45 %, the lower one 30, the proof 15 and searches 10.
  EXPECT_TRUE(account.affords(35.224 * force));
  EXPECT_FALSE(account.affords(35.226 * force));
  EXPECT_TRUE(account.affordsForMode(0.149 * force));
  EXPECT_FALSE(account.affordsForMode(0.151 * force));
  EXPECT_TRUE(account.affordsForProof(0.074 * force));
  EXPECT_FALSE(account.affordsForProof(0.076 * force));
  EXPECT_TRUE(account.affordsForSearches(0.049 * force));
  EXPECT_FALSE(account.affordsForSearches(0.051 * force));
  // The verdict begins with all that it keeps, as the body is small; where it is sought it earns 14 000 units here, and
  // the upper side less.
  const double kept =
      2 * WorkAccount::ofDiagonal(body) + WorkAccount::ofProducts(body, 12) + WorkAccount::ofRing(*body.blocks()[0]);
  EXPECT_TRUE(account.affordsForVerdict(0.99 * kept));
  EXPECT_FALSE(account.affordsForVerdict(1.01 * kept));
  account.spendOnVerdict(kept);
  WorkAccount later = account;
  later.earn();
  EXPECT_FALSE(later.affordsForVerdict(1));
  EXPECT_TRUE(later.affords(35.449 * force));
  later.earn(true);
  EXPECT_TRUE(later.affordsForVerdict(13900));
  EXPECT_FALSE(later.affordsForVerdict(14100));
  EXPECT_TRUE(later.affords(35.549 * force));
  EXPECT_FALSE(later.affords(35.551 * force));
  later.spendOnSearches(0.151 * force);
  EXPECT_FALSE(later.affordsForSearches(1));
  // Tests come off the next income, of which a fifth is left in any case.
  for (const double share : {0.2, 1.0}) {
    WorkAccount tested = account;
    Work tests;
    tests[WorkOn::tests] = share * force;
    tested.spend(tests);
    EXPECT_TRUE(tested.affords(35.224 * force));
    tested.earn();
    const double left = 35.225 + 0.45 * std::max(0.5 - share, 0.1);
    EXPECT_TRUE(tested.affords((left - 0.001) * force)) << share;
    EXPECT_FALSE(tested.affords((left + 0.001) * force)) << share;
    tested.earn();
    EXPECT_TRUE(tested.affords((left + 0.224) * force)) << share;
  }
  for (int step = 0; step < 100000; ++step) account.earn();
  EXPECT_TRUE(account.affords(WorkAccount::ofRebuild(body)));
  EXPECT_FALSE(account.affords(2.01 * WorkAccount::ofRebuild(body)));
  Work much;
  much[WorkOn::sweeps] = 100 * WorkAccount::ofRebuild(body);
  account.spend(much);
  EXPECT_TRUE(account.affords(-0.201 * evaluation));
  EXPECT_FALSE(account.affords(-0.199 * evaluation));
  WorkAccount nothing(body, 0);
  nothing.earn();
  EXPECT_TRUE(nothing.limited());
  EXPECT_FALSE(nothing.affords(1));
  for (const double share : {100.0, infinity}) {
    WorkAccount unlimited(body, share);
    unlimited.spend(much);
    EXPECT_FALSE(unlimited.limited());
    EXPECT_TRUE(unlimited.affords(1e300));
  }
}

// Theorem 22 (b): the shares of points and of the mean gradient add up.
TEST(TangentDrift, OfAMeanAddsToThatOfThePoints) {
  test::Random random(18);
  const StVenantKirchhoff whole{lameConstants(test::young, 0.4)};
  const auto point = withShares(whole, 0.2, 1.0), mean = withShares(whole, 0.8, 0.3);
  ASSERT_TRUE(point && mean);
  for (int trial = 0; trial < 20; ++trial) {
    const Matrix3<double> F = test::toMatrix3(Eigen::Matrix3d::Identity() + random.matrix(0.3)),
                          F2 = test::toMatrix3(Eigen::Matrix3d::Identity() + random.matrix(0.3)),
                          average = 0.5 * (F + F2);
    TangentDrift all;
    all.addPoint(*point, F);
    all.addPoint(*point, F2);
    all.addMean(*mean, average);
    const auto first = point->drift(F), second = point->drift(F2), own = mean->drift(average);
    constexpr double rounding = 1e-14;
    EXPECT_GE(all.law.kappa * (1 + rounding), std::max(first.kappa, second.kappa) + own.kappa);
    EXPECT_GE(all.law.linear * (1 + rounding), std::max(first.linear, second.linear) + own.linear);
    EXPECT_GE(all.law.quadratic * (1 + rounding), std::max(first.quadratic, second.quadratic) + own.quadratic);
    EXPECT_GE(all.law.negative * (1 + rounding), std::max(first.negative, second.negative) + own.negative);
    EXPECT_LE(all.law.radius, std::min({first.radius, second.radius, own.radius}));
  }
}

TEST(IncrementalNodalBound, HoldsForEveryRuleOfTheHexahedron) {
  // Rules with a share at the mean deformation gradient too.
  for (const QuadratureRule& rule : findElementByName("hex8")->rules)
    for (const LawInfo& law : allLaws()) {
      BodyOptions options = test::onThreads(1);
      options.rules["hex8"] = std::string(rule.name);
      const Body body(test::box({"", "hex8", 1, "", 0}, {2, 2, 2}),
                      makeMaterial(law.name, test::young, 0.4, test::density), options);
      const NodeVectors& X = body.mesh().X;
      test::Random random(16);
      const NodeVectors shake = random.nodeVectors(X.cols(), 0.02 * test::cellSize);
      IncrementalNodalBound bound(body);
      std::int64_t evaluated = 0;
      constexpr int steps = 200;
      for (int step = 0; step <= steps; ++step) {
        const NodeVectors x = pathState(X, 0.1 * step / steps, shake);
        const double lambda = DenseTangent(body, x).largest();
        const std::string what = joinText(rule.name, ", ", law.name, ", step ", step);
        ASSERT_GE(bound.update(x).value, lambda * (1 - 1e-9)) << what;
        EXPECT_LE(bound.verify(x), 1e-9) << what;
        evaluated += bound.statistics().evaluated;
      }
      // Balls exist: most elements are inside theirs at most steps.
      EXPECT_LE(static_cast<double>(evaluated), 0.85 * steps * static_cast<double>(body.mesh().elementCount()))
          << rule.name << ", " << law.name;
    }
}

TEST_P(IncrementalNodalBoundTest, EvaluatesFewElementsWhileLittleChanges) {
  for (const LawInfo& law : allLaws()) {
    Body body = test::boxBody(GetParam(), law.name, {4, 3, 3});
    const NodeVectors& X = body.mesh().X;
    test::Random random(15);
    const NodeVectors shake = random.nodeVectors(X.cols(), 1e-4 * test::cellSize);
    for (const bool withForce : {false, true}) {
      IncrementalNodalBound bound(body);
      bound.update(X);
      std::int64_t evaluated = 0;
      constexpr int steps = 100;
      StepEvaluation evaluation;
      for (int step = 0; step < steps; ++step) {
        bound.update(X + std::sin(0.1 * step) * shake, withForce ? &evaluation : nullptr);
        evaluated += bound.statistics().evaluated;
      }
      EXPECT_LE(static_cast<double>(evaluated), 0.05 * steps * static_cast<double>(body.mesh().elementCount()))
          << law.name;
    }
  }
}

Body jitteredBar(std::array<int, 3> cells, double jitter) {
  BarOptions options;
  options.cells = cells;
  options.jitter = jitter;
  return Body(generateBar(options), makeMaterial("stvk", 1e4, 0.3, 1000), test::onThreads(1));
}

// A tangent that does not drift gives balls without an end; a sigma that is lowered too far must reach them too.
TEST(IncrementalNodalBound, EvaluatesElementsInsideTheirBallsWhenTheEigenvalueIsLoweredBelowThem) {
  BarOptions options;
  options.cells = {4, 3, 3};
  const Body body(generateBar(options), makeMaterial("linear", 1e4, 0.3, 1000), test::onThreads(1));
  const NodeVectors& X = body.mesh().X;
  IncrementalNodalBound bound(body);
  bound.update(X);
  const double lambda = DenseTangent(body, X).largest();
  for (const double share : {1.0, 0.7, 0.5}) {
    bound.tightenBound(X, {share * lambda}, 0.05);
    for (int k = 0; k < 50; ++k) EXPECT_GE(bound.update(X).value, lambda) << share;
    EXPECT_LE(bound.verify(X), 1e-9) << share;
  }
}

// A step far below the critical one needs no sweep of the weights. Once elements have cost as much as all sweeps do,
// the weights are swept after all.
TEST(IncrementalNodalBound, SweepsNoMoreThanAProofNeeds) {
  const Body body = jitteredBar({6, 3, 3}, 0.2);
  const NodeVectors& X = body.mesh().X;
  const double lambda = DenseTangent(body, X).largest();
  const std::int64_t elements = body.mesh().elementCount();
  IncrementalNodalBound close(body);
  ASSERT_TRUE(close.certify(X, 1.3 * lambda));
  EXPECT_GT(close.statistics().evaluated, 4 * elements);

  IncrementalNodalBound bound(body);
  const double wanted = 5.5 * lambda;
  ASSERT_TRUE(bound.certify(X, wanted));
  EXPECT_LE(bound.statistics().evaluated, 2 * elements);
  std::int64_t evaluated = 0, rebuilds = 0;
  test::Random random(17);
  for (int step = 0; rebuilds == 0 && step < 1000; ++step) {
    const NodeVectors x = 1.4 * X + random.nodeVectors(X.cols(), 0.004);
    ASSERT_TRUE(bound.certify(x, wanted)) << step;
    EXPECT_LE(bound.verify(x), 1e-9) << step;
    rebuilds += bound.statistics().rebuilds;
    if (rebuilds == 0) evaluated += bound.statistics().evaluated;
  }
  EXPECT_EQ(rebuilds, 1);
  EXPECT_GT(evaluated, 4 * elements);
  EXPECT_GT(bound.statistics().evaluated, 4 * elements);
}

TEST(IncrementalNodalBound, TurnsItsWeightsWithTheBody) {
  const Body body = jitteredBar({6, 3, 3}, 0.2);
  const NodeVectors& X = body.mesh().X;
  IncrementalNodalBound bound(body);
  const double start = bound.update(X).value;
  for (int step = 1; step <= 90; ++step) {
    const Eigen::AngleAxisd turn(step * EIGEN_PI / 180, Eigen::Vector3d(1, 2, 2) / 3);
    bound.update(turn.toRotationMatrix() * X);
    // A turn changes no eigenvalue, and weights that turn too no bound.
    EXPECT_LE(bound.certifiedEigenvalue(), 1.01 * start) << step;
    EXPECT_EQ(bound.statistics().rebuilds, 0) << step;
    EXPECT_LE(bound.verify(turn.toRotationMatrix() * X), 1e-9) << step;
  }
}

TEST(IncrementalNodalBound, KnowsWhereTheHighestRingsMayBe) {
  const Body body = jitteredBar({8, 4, 4}, 0.3);
  const NodeVectors& X = body.mesh().X;
  IncrementalNodalBound bound(body);
  EXPECT_TRUE(bound.highestElements(8).empty());
  bound.update(X);
  ReducedRing ring(body);
  const ReducedRing::Result& rings = ring.evaluate(X);
  double highest = 0;
  for (const ElementRef e : bound.highestElements(8)) highest = std::max(highest, rings.largest[e.block][e.element]);
  EXPECT_GE(highest, 0.95 * rings.highest);
}

TEST_P(IncrementalNodalBoundTest, CertifiesOnlyWhatIsTrue) {
  for (const LawInfo& law : allLaws()) {
    Body body = test::boxBody(GetParam(), law.name);
    test::holdBody(body, Hold::face);
    const NodeVectors& X = body.mesh().X;
    test::Random random(13);
    const NodeVectors shake = random.nodeVectors(X.cols(), 0.08 * test::cellSize);
    const double rest = DenseTangent(body, X).largest();
    for (const double share : {0.5, 0.99, 1.3, 2.0, 5.0}) {
      IncrementalNodalBound bound(body);
      int certified = 0, possible = 0;
      for (int step = 0; step <= 40; ++step) {
        const NodeVectors x = pathState(X, step / 40.0, shake);
        const double lambda = DenseTangent(body, x).largest(), sigma = share * rest;
        const bool yes = bound.certify(x, sigma);
        if (yes) {
          ASSERT_GE(sigma, lambda * (1 - 1e-9)) << law.name << ", " << share << ", step " << step;
          ASSERT_LE(bound.certifiedEigenvalue(), sigma) << law.name << ", " << share << ", step " << step;
          EXPECT_LE(bound.verify(x), 1e-9) << law.name << ", " << share << ", step " << step;
        }
        certified += yes;
        possible += sigma >= 1.5 * lambda;
      }
      if (share == 5) {  // far above the truth there is no doubt
        EXPECT_GT(possible, 0) << law.name;
        EXPECT_GE(certified, possible) << law.name;
      }
    }
  }
}

// Where one element of many becomes stiffer than its surroundings can serve.
TEST(IncrementalNodalBound, RefusesAStepThatItsEigenvalueWasRaisedAbove) {
  const Body body = jitteredBar({10, 4, 4}, 0.2);
  const NodeVectors& X = body.mesh().X;
  test::Random random(19);
  int refused = 0;
  for (int repeat = 0; repeat < 8; ++repeat) {
    IncrementalNodalBound bound(body);
    const double sigma = 1.05 * bound.update(X).value;
    const std::int32_t node = random.index(body.nodeCount());
    const Eigen::Vector3d across = random.vector(1).normalized() * (0.06 * X.row(0).maxCoeff());
    NodeVectors x = X;
    for (int step = 0; step <= 40; ++step) {
      x.col(node) = X.col(node) + step / 40.0 * across;
      const bool yes = bound.certify(x, sigma);
      refused += !yes && std::isfinite(bound.certifiedEigenvalue());
      if (!yes) continue;
      ASSERT_LE(bound.certifiedEigenvalue(), sigma) << repeat << ", step " << step;
      EXPECT_LE(bound.verify(x), 1e-9) << repeat << ", step " << step;
    }
  }
  EXPECT_GT(refused, 0);
}

TEST_P(IncrementalNodalBoundTest, SeesEveryInversion) {
  for (const LawInfo& law : allLaws()) {
    if (law.allowsInversion) continue;
    Body body = test::boxBody(GetParam(), law.name);
    const NodeVectors& X = body.mesh().X;
    for (const double budget : {0.1, WorkAccount::noLimit}) {
      test::Random random(14);
      int inversions = 0;
      for (int repeat = 0; repeat < 10; ++repeat) {
        WorkAccount account(body, budget);
        IncrementalNodalBound bound(body, {}, &account);
        const std::int32_t node = random.index(body.nodeCount());
        const Eigen::Vector3d across = random.vector(2.5 * test::cellSize);
        NodeVectors x = X;
        bool inverted = false;
        for (int step = 0; step <= 40; ++step) {
          x.col(node) = X.col(node) + step / 40.0 * across;
          account.earn();
          if (std::isnan(bound.update(x).value)) break;
          const double least = body.leastDeterminant(x).value;
          if (least > 0)
            EXPECT_GT(bound.statistics().leastDeterminant, 0) << law.name << ", step " << step;
          else
            EXPECT_NEAR(bound.statistics().leastDeterminant, least, 1e-12) << law.name << ", step " << step;
          inverted = inverted || !(least > 0);
        }
        // The law may have no tangent there.
        inversions += inverted || std::isnan(bound.certifiedEigenvalue());
      }
      EXPECT_GE(inversions, 3) << law.name << ", budget " << budget;
    }
  }
}

int invertedElements(const Body& body, NodeVectorsView x) {
  int inverted = 0;
  for (const auto& block : body.blocks())
    for (std::int32_t e = 0; e < block->elementCount(); ++e) {
      std::int32_t elements[lanes];
      std::fill(std::begin(elements), std::end(elements), -1);
      elements[0] = e;
      std::vector<double> F(9 * block->rule().points.size() * lanes);
      TangentDrift drift[lanes];
      block->deformationOf(elements, x.data(), F.data(), drift);
      inverted += !(drift[0].determinant > 0);
    }
  return inverted;
}

// What counts is how far an element can have stiffened; that it is inverted its gradient alone tells.
TEST_P(IncrementalNodalBoundTest, InvertedElementsAreLookedAtAndSeldomEvaluated) {
  Body body = test::boxBody(GetParam(), "stvk");
  const NodeVectors& X = body.mesh().X;
  WorkAccount account(body, 0.1);
  IncrementalNodalBound bound(body, {}, &account);
  const std::int32_t node = body.blocks()[0]->nodesOf(0)[0];
  std::int64_t evaluated = 0;
  int inverted = 0;
  for (int step = 0; step <= 200; ++step) {
    NodeVectors x = X;
    // Through the element and beyond, where it stays and turns hither and thither.
    const Eigen::Vector3d across = body.mesh().X.rowwise().mean() - X.col(node);
    x.col(node) += (std::min(step, 40) / 40.0 * 2 + 0.01 * std::sin(step)) * across;
    account.earn();
    const double value = bound.update(x).value;
    if (step <= 40) continue;
    evaluated += bound.statistics().evaluated;
    const double least = body.leastDeterminant(x).value;
    EXPECT_NEAR(bound.statistics().leastDeterminant, least, 1e-12) << step;
    inverted += invertedElements(body, x);
    EXPECT_LE(bound.verify(x), 1e-9) << step;
    EXPECT_GE(value, DenseTangent(body, x).largest() * (1 - 1e-9)) << step;
  }
  EXPECT_GE(inverted, 160);
  EXPECT_LT(evaluated, inverted);
}

// Flat elements are close to inversion, so that their balls end there and move on while the body is stretched.
TEST_P(IncrementalNodalBoundTest, BallsThatMoveCountWhatElementsMayHaveStiffenedBy) {
  Body body = test::boxBody(GetParam(), "stvk");
  WorkAccount account(body, 0.1);
  IncrementalNodalBound bound(body, {}, &account);
  for (int step = 0; step <= 200; ++step) {
    const NodeVectors x = Eigen::Vector3d(1 + 0.001 * step, 0.01, 1).asDiagonal() * body.mesh().X;
    account.earn();
    const double value = bound.update(x).value;
    EXPECT_LE(bound.verify(x), 1e-9) << step;
    EXPECT_GE(value, DenseTangent(body, x).largest() * (1 - 1e-9)) << step;
  }
}

TEST_P(IncrementalNodalBoundTest, IsNanWithoutATangentAndRecovers) {
  Body body = test::boxBody(GetParam(), "neo-hookean");
  const NodeVectors& X = body.mesh().X;
  IncrementalNodalBound bound(body);
  bound.update(X);
  const NodeVectors inverted = Eigen::Vector3d(-0.5, 1, 1).asDiagonal() * X;
  EXPECT_TRUE(std::isnan(bound.update(inverted).value));
  EXPECT_TRUE(std::isnan(bound.update(inverted).value));
  EXPECT_FALSE(bound.certify(inverted, 1e30));
  NodeVectors bad = X;
  bad(1, 2) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(bound.update(bad).value));
  const double lambda = DenseTangent(body, X).largest(), value = bound.update(X).value;
  EXPECT_GE(value, lambda * (1 - 1e-9));
  EXPECT_LE(value, 2 * lambda);
}

}  // namespace
}  // namespace ringwatch
