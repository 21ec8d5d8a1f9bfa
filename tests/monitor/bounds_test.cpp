// Every metric's declared direction and the bracket of the critical step against dense eigenvalues, for every law and
// every way to cut a box; then what rotations and changes of scale must do to them.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <limits>

#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/base/rounding.h>
#include <ringwatch/monitor/bounds/rayleigh.h>
#include <ringwatch/monitor/bounds/reduced_ring.h>
#include <ringwatch/monitor/metrics/metrics.h>
#include <ringwatch/monitor/stability_monitor.h>
#include <tests/monitor/bounds_fault.h>
#include <tests/monitor/monitor_cases.h>

namespace ringwatch {
namespace {

using test::DenseTangent;
using test::Hold;
using test::Subdivision;

using test::boundsFault;
using test::limit;

struct BoundsCase {
  Subdivision subdivision;
  std::string law;
};
std::vector<BoundsCase> allBoundsCases() {
  std::vector<BoundsCase> cases;
  for (const Subdivision& subdivision : test::allSubdivisions())
    for (const LawInfo& law : allLaws()) cases.push_back({subdivision, std::string(law.name)});
  return cases;
}
class BoundsTest : public ::testing::TestWithParam<BoundsCase> {
 public:
  const BoundsCase& param() const { return GetParam(); }
};
INSTANTIATE_TEST_SUITE_P(All, BoundsTest, ::testing::ValuesIn(allBoundsCases()), [](const auto& test) {
  return test::testName(test.param.subdivision.name + "_" + test.param.law);
});

TEST_P(BoundsTest, HoldInEveryStateAndHoweverTheBodyIsHeld) {
  // Element counts that fill packs, and such that do not.
  for (const std::array<int, 3> cells : {std::array{2, 2, 2}, std::array{3, 1, 1}})
    for (const Hold hold : {Hold::nothing, Hold::face, Hold::components})
      for (const std::uint64_t seed : {1u, 2u}) {
        Body body = test::boxBody(param().subdivision, param().law, cells, seed == 1 ? 0.2 : 0.3, seed);
        test::holdBody(body, hold, seed);
        for (const test::NamedState& state : test::deformedStates(body.mesh().X, seed))
          EXPECT_EQ(boundsFault(body, state.x), "") << state.name << ", " << test::holdName(hold) << ", seed " << seed;
      }
}

TEST_P(BoundsTest, TheBracketIsNarrowAtRest) {
  // Not a theorem, but what makes the bracket worth having: 1 % in h, optimistic within 0.5 %.
  const Body body = test::boxBody(param().subdivision, param().law);
  const double exact = stepFor(DenseTangent(body, body.mesh().X).largest(), limit);
  const CriticalStep step = criticalStep(body, body.mesh().X, limit);
  EXPECT_GE(step.safe, 0.99 * exact);
  EXPECT_LE(step.optimistic, 1.005 * exact);
  // The probabilistic side comes apart from the proven one, and only when asked for.
  EXPECT_FALSE(step.probable);
  const CriticalStep more = criticalStep(body, body.mesh().X, limit, {.lanczos = LanczosOptions{0.02, 1e-8, 3}});
  EXPECT_EQ(more.safe, step.safe);
  ASSERT_TRUE(more.probable);
  EXPECT_EQ(more.probable->eta, 1e-8);
  EXPECT_LE(more.probable->safe, exact);
  EXPECT_GE(more.probable->safe, 0.98 * exact);
}

TEST(Bounds, HoldForRandomBodies) {
  const auto subdivisions = test::allSubdivisions();
  const bool held = rc::check("bounds of random bodies", [&] {
    test::Random random(*rc::gen::arbitrary<std::uint64_t>());
    const Subdivision& subdivision = subdivisions[random.index(static_cast<int>(subdivisions.size()))];
    const auto& law = allLaws()[random.index(static_cast<int>(allLaws().size()))];
    const std::array<int, 3> cells{2 + random.index(2), 1 + random.index(2), 1 + random.index(2)};
    Body body = test::boxBody(subdivision, law.name, cells, random.uniform(0, 0.25),
                              static_cast<std::uint64_t>(random.index(1000)));
    const Hold holds[] = {Hold::nothing, Hold::face, Hold::components};
    test::holdBody(body, holds[random.index(3)], static_cast<std::uint64_t>(random.index(1000)));
    const NodeVectors x = (random.rotation() * (Eigen::Matrix3d::Identity() + random.matrix(0.5))) * body.mesh().X +
                          random.nodeVectors(body.nodeCount(), random.uniform(0, 0.3) * test::cellSize);
    const std::string fault = boundsFault(body, x);
    RC_TAG(std::string(law.name));
    if (!fault.empty()) RC_FAIL(joinText(subdivision.name, ", ", law.name, ": ", fault));
  });
  EXPECT_TRUE(held);
}

TEST(Bounds, HoldWithDensitiesAndStiffnessesFarApart) {
  int mixed = 0;
  for (const Subdivision& subdivision : test::allSubdivisions()) {
    if (subdivision.other.empty()) continue;
    ++mixed;
    for (const double ratio : {1e-6, 1e6}) {
      const Body body(test::box(subdivision, {4, 1, 1}),
                      {makeMaterial("stvk", test::young, 0.3, test::density),
                       makeMaterial("stvk", ratio * test::young, 0.45, test::density)},
                      test::onThreads(1));
      for (const test::NamedState& state : test::deformedStates(body.mesh().X, 3))
        EXPECT_EQ(boundsFault(body, state.x), "") << subdivision.name << ", " << state.name << ", ratio " << ratio;
    }
  }
  EXPECT_GT(mixed, 0);
}

// Whatever width is asked for: the bracket holds, is no wider than that, and takes no more than a narrower one.
TEST(Bounds, AreAsNarrowAsIsAskedFor) {
  for (const Subdivision& subdivision : test::allSubdivisions())
    for (const double jitter : {0.0, 0.2}) {
      const Body body = test::boxBody(subdivision, "stvk", {4, 3, 3}, jitter);
      const double exact = stepFor(DenseTangent(body, body.mesh().X).largest(), limit);
      EXPECT_THROW(criticalStep(body, body.mesh().X, limit, {.width = -0.1}), InputError);
      std::int64_t before = std::numeric_limits<std::int64_t>::max();
      for (const double width : {0.01, 0.05, 0.3}) {
        std::int64_t evaluations = 0;
        const CriticalStep step =
            criticalStep(body, body.mesh().X, limit, {.width = width, .evaluations = &evaluations});
        EXPECT_LE(step.safe, exact * (1 + 1e-9)) << subdivision.name << ", " << width;
        EXPECT_GE(step.optimistic, exact * (1 - 1e-9)) << subdivision.name << ", " << width;
        EXPECT_LE(step.optimistic, (1 + width) * step.safe)
            << subdivision.name << ", jitter " << jitter << ", " << width;
        EXPECT_LE(evaluations, before) << subdivision.name << ", jitter " << jitter << ", " << width;
        before = evaluations;
      }
    }
}

TEST(Bounds, NothingFree) {
  for (const Subdivision& subdivision : test::allSubdivisions()) {
    Body body = test::boxBody(subdivision, "stvk");
    for (std::int32_t i = 0; i < body.nodeCount(); ++i) body.constraints().fix(i);
    EXPECT_EQ(boundsFault(body, body.mesh().X), "") << subdivision.name;
    const CriticalStep step = criticalStep(body, body.mesh().X, limit);
    EXPECT_GT(step.safe, 1e6) << subdivision.name;  // any step will do
    EXPECT_GE(step.optimistic, step.safe) << subdivision.name;
  }
}

TEST(Bounds, OneFreeNodeIsGivenExactly) {
  for (const Subdivision& subdivision : test::allSubdivisions()) {
    Body body = test::boxBody(subdivision, "stvk");
    const std::int32_t middle = 13;  // of 3×3×3 nodes
    for (std::int32_t i = 0; i < body.nodeCount(); ++i)
      if (i != middle) body.constraints().fix(i);
    EXPECT_EQ(boundsFault(body, body.mesh().X), "") << subdivision.name;
    const double exact = stepFor(DenseTangent(body, body.mesh().X).largest(), limit);
    EXPECT_NEAR(criticalStep(body, body.mesh().X, limit).optimistic, exact, 1e-9 * exact) << subdivision.name;
  }
}

TEST(Bounds, AnElementWithoutTangentIsNeverHiddenBehindOthers) {
  // One inverted neo-Hookean element anywhere: no metric and no bracket may go by the other elements alone.
  for (const Subdivision& subdivision : test::allSubdivisions()) {
    Body body = test::boxBody(subdivision, "neo-hookean");
    const NodeVectors& X = body.mesh().X;
    int inverted = 0;
    for (std::int32_t i = 0; i < body.nodeCount(); ++i) {
      NodeVectors x = X;
      x.col(i) += 3 * test::cellSize * (X.rowwise().mean() - X.col(i)).normalized() + Eigen::Vector3d(1e-4, 2e-4, 3e-4);
      if (body.leastDeterminant(x).value > 0) continue;
      ++inverted;
      EXPECT_EQ(boundsFault(body, x), "") << subdivision.name << ", node " << i;
    }
    EXPECT_GE(4 * inverted, 3 * body.nodeCount()) << subdivision.name;
  }
}

TEST(Rayleigh, IsALowerBoundThatProductsTighten) {
  test::Random random(5);
  for (const Subdivision& subdivision : test::allSubdivisions())
    for (const LawInfo& law : allLaws())
      for (const Hold hold : {Hold::nothing, Hold::face, Hold::components}) {
        Body body = test::boxBody(subdivision, law.name);
        test::holdBody(body, hold);
        const NodeVectors x = body.mesh().X + random.nodeVectors(body.nodeCount(), 0.05 * test::cellSize);
        const double lambda = DenseTangent(body, x).largest();
        const NodeVectors start = random.nodeVectors(body.nodeCount(), 1);
        double before = -infinity;
        for (const int products : {1, 2, 5, 10, 20, 80}) {
          NodeVectors v = start;
          const LowerBound bound = rayleighLowerBound(body, x, v, products);
          EXPECT_LE(bound.value, lambda * (1 + 1e-13)) << subdivision.name << ", " << law.name << ", " << products;
          EXPECT_GE(bound.value, before - 1e-9 * lambda) << subdivision.name << ", " << law.name << ", " << products;
          EXPECT_NEAR(v.norm(), 1, 1e-13);
          NodeVectors held = v;
          body.constraints().clearConstrained(held);
          EXPECT_EQ(held, v);
          before = bound.value;
        }
        EXPECT_NEAR(before, lambda, 1e-6 * lambda) << subdivision.name << ", " << law.name;
      }
}

TEST(Rayleigh, IsRoundedByTheLargestEigenvalueThatWasSeen) {
  const Body body = test::boxBody(test::allSubdivisions()[0], "linear");
  test::Random random(7);
  const NodeVectors start = random.nodeVectors(body.nodeCount(), 1);
  NodeVectors v = start;
  const double alone = rayleighLowerBound(body, body.mesh().X, v, 1).value;
  double seen = 1e6 * alone;
  v = start;
  const double margin = quotientRounding + unitRoundoff * static_cast<double>(start.size());
  EXPECT_NEAR(alone - rayleighLowerBound(body, body.mesh().X, v, 1, &seen).value, 1e6 * margin * alone, 1e-11 * alone);
  EXPECT_EQ(seen, 1e6 * alone);
  seen = 0;
  v = start;
  EXPECT_EQ(rayleighLowerBound(body, body.mesh().X, v, 1, &seen).value, alone);
  EXPECT_GT(seen, alone);
}

TEST(Rayleigh, GivesZeroForNoStart) {
  const Body body = test::boxBody(test::allSubdivisions()[0], "linear");
  NodeVectors zero = NodeVectors::Zero(3, body.nodeCount());
  EXPECT_EQ(rayleighLowerBound(body, body.mesh().X, zero, 5).value, 0);
}

TEST(ReducedRing, IsThePrincipalSubmatrixOfTheWhole) {
  for (const Subdivision& subdivision : test::allSubdivisions())
    for (const Hold hold : {Hold::nothing, Hold::face, Hold::components}) {
      Body body = test::boxBody(subdivision, "stvk");
      test::holdBody(body, hold);
      test::Random random(6);
      const NodeVectors x = body.mesh().X + random.nodeVectors(body.nodeCount(), 0.2 * test::cellSize);
      const DenseTangent dense(body, x);
      ReducedRing ring(body);
      const ReducedRing::Result& rings = ring.evaluate(x, true);
      double highest = 0, lowest = 0;
      for (std::size_t b = 0; b < body.blocks().size(); ++b)
        for (std::int32_t e = 0; e < body.blocks()[b]->elementCount(); ++e) {
          const auto nodes = body.blocks()[b]->nodesOf(e);
          std::vector<Eigen::Index> rows;
          for (std::size_t r = 0; r < dense.components.size(); ++r)
            if (std::find(nodes.begin(), nodes.end(), dense.components[r].first) != nodes.end()) rows.push_back(r);
          double top = 0, bottom = 0;
          if (!rows.empty()) {
            const Eigen::MatrixXd A = dense.matrix(rows, rows);
            const Eigen::VectorXd lambda =
                Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(A, Eigen::EigenvaluesOnly).eigenvalues();
            top = std::max(0.0, lambda[lambda.size() - 1]);
            bottom = lambda[0];
          }
          const double found = rings.largest[b][e];
          EXPECT_NEAR(found, top, 1e-11 * std::max(top, -bottom)) << subdivision.name << ", " << b << ":" << e;
          const ElementRef here{b, e};
          if (here == rings.highestElement) {
            EXPECT_NEAR(rings.highest, found, 1e-10 * found) << subdivision.name;
          }
          if (here == rings.lowestElement && rings.lowest < 0) {
            EXPECT_NEAR(rings.lowest, bottom, 1e-10 * top) << subdivision.name;
          }
          highest = std::max(highest, top);
          lowest = std::min(lowest, bottom);
          // The ring's own vector attains its value on the whole body.
          const NodeVectors v = ring.topVector(here);
          Eigen::VectorXd flat(dense.components.size());
          for (std::size_t r = 0; r < dense.components.size(); ++r)
            flat[r] = v(dense.components[r].second, dense.components[r].first);
          if (top > 0) {
            EXPECT_NEAR(flat.dot(dense.matrix * flat) / flat.squaredNorm(), top, 1e-10 * highest) << subdivision.name;
          }
        }
      EXPECT_NEAR(rings.highest, highest, 1e-10 * highest) << subdivision.name;
      EXPECT_LE(rings.highest, highest) << subdivision.name;
      EXPECT_NEAR(rings.lowest, lowest, 1e-10 * highest) << subdivision.name;
    }
}

TEST(Metrics, OfAnElementAreThoseOfTheElementAlone) {
  // Every element of single-element against its own dense problem: none is left out, none takes another's place.
  for (const Subdivision& subdivision : test::allSubdivisions())
    for (const std::array<int, 3> cells : {std::array{2, 2, 2}, std::array{3, 1, 1}, std::array{2, 1, 1}}) {
      const Body body = test::boxBody(subdivision, "stvk", cells);
      const NodeVectors x = Eigen::Vector3d(1.2, 1, 0.9).asDiagonal() * body.mesh().X;
      const MetricResult result = evaluateMetric("single-element", body, x);
      for (std::size_t b = 0; b < body.blocks().size(); ++b)
        for (std::int32_t e = 0; e < body.blocks()[b]->elementCount(); ++e) {
          const ElementRef here{b, e};
          Eigen::MatrixXd K = body.elementTangent(here, x);
          std::vector<double> mass(body.blocks()[b]->element().nodes);
          body.elementLumpedMass(here, mass.data());
          for (Eigen::Index r = 0; r < K.rows(); ++r)
            for (Eigen::Index s = 0; s < K.cols(); ++s) K(r, s) /= std::sqrt(mass[r / 3] * mass[s / 3]);
          const double lambda =
              Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(K, Eigen::EigenvaluesOnly).eigenvalues()[K.rows() - 1];
          EXPECT_NEAR(result.elementLambda[b][e], lambda, 1e-11 * lambda) << subdivision.name << ", " << b << ":" << e;
        }
    }
}

TEST(Metrics, AreKnownByName) {
  const Body body = test::boxBody(test::allSubdivisions()[0], "linear");
  for (const MetricInfo& metric : allMetrics()) {
    EXPECT_EQ(findMetric(metric.name)->name, metric.name);
    EXPECT_FALSE(metric.help.empty());
    EXPECT_EQ(evaluateMetric(metric.name, body, body.mesh().X).info->name, metric.name);
    EXPECT_FALSE(directionName(metric.direction).empty());
  }
  EXPECT_EQ(findMetric("no-such"), nullptr);
  try {
    evaluateMetric("no-such", body, body.mesh().X);
    FAIL() << "an unknown metric was accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("no-such"), std::string::npos);
    for (const MetricInfo& metric : allMetrics())
      EXPECT_NE(std::string(error.what()).find(metric.name), std::string::npos) << error.what();
  }
}

TEST(Metrics, DoNotSeeARigidMotion) {
  test::Random random(8);
  for (const Subdivision& subdivision : test::allSubdivisions())
    for (const LawInfo& law : allLaws()) {
      if (!law.objective) continue;
      for (const Hold hold : {Hold::nothing, Hold::face}) {
        Body body = test::boxBody(subdivision, law.name);
        test::holdBody(body, hold);
        const NodeVectors x = body.mesh().X + random.nodeVectors(body.nodeCount(), 0.05 * test::cellSize);
        const double safe = criticalStep(body, x, limit).safe;
        for (int repeat = 0; repeat < 2; ++repeat) {
          const NodeVectors turned = (random.rotation() * x).colwise() + random.vector(0.1);
          for (const MetricInfo& metric : allMetrics()) {
            const MetricResult before = evaluateMetric(metric.name, body, x),
                               after = evaluateMetric(metric.name, body, turned);
            // Shapes are kept with eleven bits, in the world's axes.
            const double allowed = (metric.name == "nodal-bound" ? 1e-3 : 1e-8) * before.lambda;
            for (std::size_t b = 0; b < before.elementLambda.size(); ++b)
              for (std::size_t e = 0; e < before.elementLambda[b].size(); ++e)
                EXPECT_NEAR(after.elementLambda[b][e], before.elementLambda[b][e], allowed)
                    << metric.name << ", " << subdivision.name << ", " << law.name << ", " << b << ":" << e;
          }
          // Iterated until it is narrow enough, which turned numbers reach a little earlier or later.
          EXPECT_NEAR(criticalStep(body, turned, limit).safe, safe, 3e-3 * safe)
              << subdivision.name << ", " << law.name;
        }
      }
    }
}

TEST(Metrics, ScaleWithSizeStiffnessAndDensity) {
  // omega ~ (1/L) √(E/rho)
  test::Random random(9);
  const double size = 3.7, stiffness = 11, weight = 0.2;
  for (const Subdivision& subdivision : test::allSubdivisions())
    for (const LawInfo& law : allLaws()) {
      const Mesh mesh = test::box(subdivision, {2, 2, 2});
      Mesh larger = mesh;
      larger.X *= size;
      const auto make = [&](const Mesh& m, double young, double density) {
        return Body(m, makeMaterial(law.name, young, 0.4, density), test::onThreads(1));
      };
      const Body plain = make(mesh, test::young, test::density);
      const Body changed = make(larger, stiffness * test::young, weight * test::density);
      const NodeVectors x = mesh.X + random.nodeVectors(mesh.X.cols(), 0.1 * test::cellSize);
      const double factor = stiffness / (weight * size * size);
      for (const MetricInfo& metric : allMetrics()) {
        const double before = evaluateMetric(metric.name, plain, x).lambda,
                     after = evaluateMetric(metric.name, changed, size * x).lambda;
        EXPECT_NEAR(after, factor * before, 1e-8 * after)
            << metric.name << ", " << subdivision.name << ", " << law.name;
      }
      const CriticalStep before = criticalStep(plain, x, limit), after = criticalStep(changed, size * x, limit);
      // The exchange bound is searched in single precision, until the width is reached.
      EXPECT_NEAR(after.safe, before.safe / std::sqrt(factor), 1e-4 * after.safe)
          << subdivision.name << ", " << law.name;
      EXPECT_NEAR(after.optimistic, before.optimistic / std::sqrt(factor), 1e-6 * after.optimistic)
          << subdivision.name << ", " << law.name;
      // The limit of the integrator enters as a factor.
      EXPECT_NEAR(criticalStep(plain, x, 2 * limit).safe, 2 * before.safe, 1e-14 * before.safe);
    }
}

TEST(StepFor, IsInfiniteWithoutFrequencyAndNanForNan) {
  EXPECT_EQ(stepFor(4, 2), 1);
  EXPECT_EQ(stepFor(0, 2), infinity);
  EXPECT_EQ(stepFor(-1, 2), infinity);
  EXPECT_TRUE(std::isnan(stepFor(std::numeric_limits<double>::quiet_NaN(), 2)));
  EXPECT_EQ(safeStep(UpperBound{4}, 2), 1);
  EXPECT_EQ(optimisticStep(LowerBound{4}, 2), 1);
}

}  // namespace
}  // namespace ringwatch
