// A check names the elements outside their balls, and few are compared with these.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include <Eigen/Dense>

#include <ringwatch/body/body.h>
#include <ringwatch/meshes/generators/generators.h>
#include <ringwatch/monitor/energy_balance.h>
#include <ringwatch/monitor/incremental/validity_balls.h>
#include <tests/support/random.h>

namespace ringwatch {
namespace {

using test::Random;

struct Checked final : PatchVisitor {
  explicit Checked(const Body& b) : body(b), block(*b.blocks()[0]), balls(block) {}
  std::size_t placeOf(std::int32_t e) const { return static_cast<std::size_t>(block.layout().batchOfElement[e]); }
  Eigen::Matrix3d gradient(std::int32_t e, const NodeVectors& x) const {
    const auto nodes = block.nodesOf(e);
    Eigen::Matrix3d now, reference;
    for (int j = 0; j < 3; ++j) {
      now.col(j) = x.col(nodes[static_cast<std::size_t>(j) + 1]) - x.col(nodes[0]);
      reference.col(j) = body.mesh().X.col(nodes[static_cast<std::size_t>(j) + 1]) - body.mesh().X.col(nodes[0]);
    }
    return now * reference.inverse();
  }
  /// The same for all elements, told to the balls.
  void setBalls(const NodeVectors& x, double radius) {
    for (std::int32_t e = 0; e < block.elementCount(); ++e) setBall(e, x, radius);
  }
  void setBall(std::int32_t e, const NodeVectors& x, double radius) {
    std::int32_t elements[lanes];
    std::fill(elements, elements + lanes, -1);
    elements[0] = e;
    TangentDrift drift[lanes];
    double F[9 * lanes];
    block.deformationOf(elements, x.data(), F, drift);
    balls.setRadius(placeOf(e), radius, balls.setReferenceGradient(placeOf(e), F, 1, 0));
  }
  void visitPatch(std::size_t, const PatchPass& pass) override { balls.checkPatch(pass, outside); }
  /// Those that left, after which they have new balls.
  std::set<std::int32_t> check(const NodeVectors& x) { return evaluate(x, false, false); }
  /// The same in the pass that computes force and energy, which must be what they are without a check.
  std::set<std::int32_t> checkWithForce(const NodeVectors& x) { return evaluate(x, true, true); }

  const Body& body;
  const ElementBlock& block;
  ValidityBalls balls;
  std::vector<std::int32_t> outside;

 private:
  std::set<std::int32_t> evaluate(const NodeVectors& x, bool force, bool energy) {
    outside.clear();
    Body::Workspace workspace;
    StepEvaluation with;
    with.wantsForce = force;
    with.wantsEnergy = energy;
    with.visitor = this;
    body.evaluate(x, with, workspace);
    NodeVectors forceAlone;
    if (force) body.internalForce(x, forceAlone, workspace);
    if (force && forceAlone.allFinite()) {
      EXPECT_TRUE(with.internalForce == forceAlone);
      // Groups are summed apart.
      const double alone = body.energy(x, workspace);
      EXPECT_NEAR(with.strainEnergy, alone, 1e-13 * alone + roundingEnergy(body));
    }
    return {outside.begin(), outside.end()};
  }
};

/// What storing a reference gradient and a radius may take from a ball: bits of the radius, relative, and a distance.
constexpr double radiusBits = 1.0 / 64, offset = 2 * ValidityBalls::storageError;

Body longBar() {
  BarOptions options;
  options.element = "tet4";
  options.cells = {30, 6, 6};
  options.size = {0.3, 0.06, 0.06};
  options.jitter = 0.2;
  return {generateBar(options), makeMaterial("stvk", 1e4, 0.3, 1000), {{}, Lumping::rowSum, 1}};
}

// What cancels in |F|² - 2C:F + |C|² does not hide that an element has left a small ball of a large gradient.
TEST(ValidityBalls, FindsWhatIsBarelyOutsideWhereMuchCancels) {
  const Body body = longBar();
  const NodeVectors& X = body.mesh().X;
  Random random(77);
  for (const double size : {0.05, 1.0, 6.0})
    for (const auto& [radius, withForce] :
         std::vector<std::pair<double, bool>>{{2e-3, false}, {2e-3, true}, {0.02, true}, {0.5, false}, {0.5, true}}) {
      Checked checked(body);
      const auto check = [&, force = withForce](const NodeVectors& x) {
        return force ? checked.checkWithForce(x) : checked.check(x);
      };
      const Eigen::Matrix3d F0 = size * random.rotation();
      const Eigen::Matrix3d direction = random.matrix(1).normalized();
      checked.setBalls(F0 * X, radius);
      const std::set<std::int32_t> none = check(F0 * X);
      EXPECT_TRUE(none.empty()) << size << ", " << radius;
      // Beside this comparison a ball loses what storing its centre and its radius does.
      const double inside = (radius - ValidityBalls::storageError) * (1 - radiusBits) - ValidityBalls::storageError;
      const Eigen::Matrix3d near = F0 + 0.99 * inside * direction, far = F0 + 1.000001 * radius * direction;
      EXPECT_TRUE(check(near * X).empty()) << size << ", " << radius;
      EXPECT_EQ(check(far * X).size(), static_cast<std::size_t>(checked.block.elementCount()))
          << size << ", " << radius;
    }
}

TEST(ValidityBalls, FindsTheElementsThatLeaveAndComparesFewWithTheirOwn) {
  const Body body = longBar();
  const NodeVectors& X = body.mesh().X;
  // A smooth wave, motions of the whole, noise at a few nodes; slow and fast. Apart from the force, with it, in turn.
  for (const auto& [rate, pass] : std::vector<std::pair<double, int>>{{1e-5, 0},
                                                                      {1e-5, 1},
                                                                      {1e-5, 2},
                                                                      {1e-4, 0},
                                                                      {1e-4, 2},
                                                                      {1e-3, 0},
                                                                      {1e-3, 1},
                                                                      {1e-3, 2},
                                                                      {1e-2, 1},
                                                                      {1e-2, 2}}) {
    Random random(31);
    Checked checked(body);
    std::vector<Eigen::Matrix3d> reference(checked.block.elementCount(), Eigen::Matrix3d::Zero());
    std::vector<double> radius(reference.size(), 0);
    NodeVectors x = X;
    constexpr int steps = 120;
    std::int64_t tested = 0, left = 0;
    double work = 0;
    for (int step = 0; step <= steps; ++step) {
      if (step > 0) {
        const double time = rate * step;
        for (Eigen::Index i = 0; i < X.cols(); ++i) {
          const double phase = 20 * X(0, i) - 30 * time;
          x.col(i) = X.col(i) + 0.01 * Eigen::Vector3d(std::sin(phase), 0.3 * std::cos(phase) - 0.3, 0);
        }
        x = ((Eigen::Matrix3d::Identity() + time * random.matrix(0.1)) * x).colwise() + random.vector(0.1);
        x.col(random.index(body.nodeCount())) += random.vector(rate * 0.02);
      }
      const bool withForce = pass == 1 || (pass == 2 && step / 3 % 2 == 1);
      const std::set<std::int32_t> gone = withForce ? checked.checkWithForce(x) : checked.check(x);
      tested += static_cast<std::int64_t>(checked.balls.testedBatches());
      work += checked.balls.workOfCheck();
      for (std::int32_t e = 0; e < checked.block.elementCount(); ++e) {
        const std::size_t at = e;
        const Eigen::Matrix3d F = checked.gradient(e, x);
        const double distance = (F - reference[at]).norm();
        if (gone.count(e) > 0) {
          ASSERT_GE(distance, radius[at] * (1 - radiusBits) - offset) << "element " << e << ", step " << step;
          reference[at] = F;
          radius[at] = random.uniform(0.02, 0.1);
          checked.setBall(e, x, radius[at]);
        } else {
          ASSERT_LE(distance, radius[at] * (1 + 1e-6)) << "element " << e << ", step " << step;
        }
      }
      left += static_cast<std::int64_t>(gone.size());
    }
    if (rate > 5e-5) {
      EXPECT_GT(left, checked.block.elementCount());  // some after the first observation
    }
    const std::int64_t batches = checked.balls.batchCount();
    EXPECT_GT(batches, 500);
    printf("rate %g, %d: %.3f of the batches compared with their own balls, %.2f units an element\n", rate, pass,
           static_cast<double>(tested) / static_cast<double>(batches * steps),
           work / steps / static_cast<double>(checked.block.elementCount()));
  }
}

TEST(ValidityBalls, WhatTheyFindDoesNotDependOnEarlierChecks) {
  const Body body = longBar();
  const NodeVectors& X = body.mesh().X;
  Checked often(body), once(body);
  Random random(11);
  for (std::int32_t e = 0; e < often.block.elementCount(); ++e) {
    const double radius = random.uniform(0.005, 0.06);
    often.setBall(e, X, radius);
    once.setBall(e, X, radius);
  }
  NodeVectors direction(3, X.cols());
  for (Eigen::Index i = 0; i < X.cols(); ++i) direction.col(i) = random.vector(2e-5);
  std::set<std::int32_t> gone;
  for (int step = 1; step <= 10; ++step) gone = often.check(X + step * direction);
  EXPECT_EQ(gone, once.check(X + 10 * direction));
  EXPECT_GT(gone.size(), 10U);
  EXPECT_LT(gone.size(), often.block.elementCount() - 10);
}

TEST(ValidityBalls, TremblingAndRestingBatchesAreHardlyComparedWithTheirOwn) {
  const Body body = longBar();
  Checked checked(body);
  const NodeVectors& X = body.mesh().X;
  EXPECT_EQ(checked.check(X).size(), checked.block.elementCount());
  checked.setBalls(X, 0.1);
  // New balls have no centre yet.
  EXPECT_TRUE(checked.check(X).empty());
  EXPECT_EQ(checked.balls.testedBatches(), checked.balls.batchCount());
  Random random(7);
  for (int step = 0; step < 60; ++step) {
    NodeVectors now = X;
    for (Eigen::Index i = 0; i < X.cols(); ++i) now.col(i) += random.vector(5e-5);
    EXPECT_TRUE(checked.check(now).empty());
    EXPECT_EQ(checked.balls.testedBatches(), 0U);
  }
}

TEST(ValidityBalls, ABallThatIsTooSmallOrANumberThatIsNotOneIsFound) {
  BarOptions options;
  options.element = "tet4";
  options.cells = {4, 4, 4};
  const Body body(generateBar(options), makeMaterial("stvk", 1e4, 0.3, 1000), {{}, Lumping::rowSum, 1});
  Checked checked(body);
  NodeVectors x = body.mesh().X;
  EXPECT_EQ(checked.check(x).size(), checked.block.elementCount());
  checked.setBalls(x, 0.1);
  for (int waiting = 0; waiting < 3; ++waiting) EXPECT_TRUE(checked.check(x).empty());
  ASSERT_EQ(checked.balls.testedBatches(), 0U);
  // Too small for any motion.
  checked.setBall(7, x, 1e-6);
  x.col(checked.block.nodesOf(7)[0]) += Eigen::Vector3d(1e-4, 0, 0);
  EXPECT_EQ(checked.check(x), std::set<std::int32_t>{7});
  checked.setBall(7, x, 0.1);
  EXPECT_TRUE(checked.check(x).empty());
  // Positions whose squares overflow: every element leaves, and no other one.
  const NodeVectors huge = 1e200 * x;
  for (const bool withForce : {false, true}) {
    const std::set<std::int32_t> left = withForce ? checked.checkWithForce(huge) : checked.check(huge);
    EXPECT_EQ(left.size(), checked.block.elementCount());
    EXPECT_GE(*left.begin(), 0);
  }
  x(1, checked.block.nodesOf(9)[2]) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(checked.check(x).count(9), 1U);
  EXPECT_EQ(checked.checkWithForce(x).count(9), 1U);
}

TEST(ValidityBalls, RadiiThatMoveMoveWhatIsFound) {
  const Body body = longBar();
  const NodeVectors& X = body.mesh().X;
  const Eigen::Matrix3d stretch = Eigen::Vector3d(1.05, 1, 1).asDiagonal();
  Checked checked(body);
  checked.setBalls(X, 0.2);
  EXPECT_TRUE(checked.check(stretch * X).empty());
  const auto setAll = [&](double radius) {
    for (std::int32_t batch = 0; batch < checked.block.layout().batchCount(); ++batch)
      checked.balls.setRadii(batch, NativePack(radius));
  };
  // |F - F0| = 0.05.
  for (const auto& [radius, gone] : std::vector<std::pair<double, bool>>{
           {0.06, false}, {0.04, true}, {0.03, true}, {0.06, false}, {1e300, false}, {0.04, true}}) {
    setAll(radius);
    for (int again = 0; again < 2; ++again)
      EXPECT_EQ(checked.check(stretch * X).size(), gone ? checked.block.elementCount() : 0) << radius;
  }
  // What grows and shrinks keeps its centre where it can.
  setAll(0.1);
  EXPECT_TRUE(checked.check(stretch * X).empty());
  for (const double radius : {0.11, 0.1, 0.09}) {
    setAll(radius);
    EXPECT_TRUE(checked.check(stretch * X).empty());
    EXPECT_EQ(checked.balls.testedBatches(), 0U) << radius;
  }
  for (std::int32_t e = 0; e < checked.block.elementCount(); ++e) checked.balls.setNeverOutside(checked.placeOf(e));
  EXPECT_TRUE(checked.check(3 * X).empty());
}

TEST(ValidityBalls, AreComparedWithDiagonalCentresWhereLittleIsBesideTheDiagonal) {
  const Body body = longBar();
  const NodeVectors& X = body.mesh().X;
  Checked checked(body);
  checked.setBalls(X, 0.2);
  const Eigen::Matrix3d stretch = Eigen::Vector3d(1.05, 1, 1).asDiagonal();
  Eigen::Matrix3d little = stretch, sheared = stretch;
  little(0, 1) = 0.01;   // less than a tenth of the radius
  sheared(0, 1) = 0.05;  // more
  const auto workAt = [&](const Eigen::Matrix3d& F) {
    EXPECT_TRUE(checked.check(F * X).empty());  // gets its centres
    EXPECT_TRUE(checked.checkWithForce(F * X).empty());
    EXPECT_EQ(checked.balls.testedBatches(), 0U);
    // Just outside of every ball, beside the diagonal: whatever the centre, no element is missed.
    Eigen::Matrix3d far = F;
    far(2, 1) = 0.2;
    return std::pair{checked.balls.workOfCheck(), checked.checkWithForce(far * X).size()};
  };
  const auto [ofLittle, foundBesideLittle] = workAt(little);
  checked.setBalls(X, 0.2);
  const auto [ofSheared, foundBesideSheared] = workAt(sheared);
  EXPECT_EQ(foundBesideLittle, checked.block.elementCount());
  EXPECT_EQ(foundBesideSheared, checked.block.elementCount());
  EXPECT_NEAR(ofSheared / ofLittle, 1.5, 1e-12);
}

TEST(ValidityBalls, AnElementThatIsEvaluatedKeepsTheCentreOfItsBatch) {
  const Body body = longBar();
  const NodeVectors& X = body.mesh().X;
  for (const bool withForce : {false, true}) {
    Checked checked(body);
    const auto check = [&](const NodeVectors& x) { return withForce ? checked.checkWithForce(x) : checked.check(x); };
    checked.setBalls(X, 0.1);
    EXPECT_TRUE(check(X).empty());  // gets its centres
    Eigen::Matrix3d near = Eigen::Matrix3d::Identity();
    near(0, 1) = 0.02;
    const NodeVectors x = near * X;
    EXPECT_TRUE(check(x).empty());
    for (const std::int32_t e : {3, 700, 701}) checked.setBall(e, x, 0.05);
    EXPECT_TRUE(check(x).empty());
    EXPECT_EQ(checked.balls.testedBatches(), 0U);
    // Outside of these balls, inside of all others: at first as far from the centre as they may be from theirs.
    for (const double shear : {-0.0301, 0.0701}) {
      near(0, 1) = shear;
      EXPECT_EQ(check(near * X), (std::set<std::int32_t>{3, 700, 701})) << shear;
    }
    // A gradient far from the centre has none there.
    const NodeVectors far = 2 * X;
    checked.setBall(700, far, 0.05);
    EXPECT_EQ(check(X), std::set<std::int32_t>{700});
  }
}

TEST(ValidityBalls, OneNodeThatMovesHasFewBatchesTested) {
  const Body body = longBar();
  Checked checked(body);
  NodeVectors x = body.mesh().X;
  EXPECT_EQ(checked.check(x).size(), checked.block.elementCount());
  checked.setBalls(x, 0.1);
  EXPECT_TRUE(checked.check(x).empty());
  const std::int32_t node = checked.block.nodesOf(static_cast<std::int32_t>(checked.block.elementCount() / 2))[0];
  std::size_t tested = 0, left = 0;
  constexpr int steps = 200;
  for (int step = 0; step < steps; ++step) {
    x(1, node) += 5e-6;
    for (const std::int32_t e : checked.check(x)) {
      const auto nodes = checked.block.nodesOf(e);
      EXPECT_NE(std::find(nodes.begin(), nodes.end(), node), nodes.end()) << e;
      checked.setBall(e, x, 0.1);
      ++left;
    }
    tested += checked.balls.testedBatches();
  }
  EXPECT_GT(left, 5U);
  EXPECT_LT(tested, 8U * steps);
}

TEST(ValidityBalls, LoseWhatStoringTheirCentreCosts) {
  const Body body(generateBar({}), makeMaterial("stvk", 1e4, 0.3, 1000), {{}, Lumping::rowSum, 1});
  ValidityBalls balls(*body.blocks()[0]);
  balls.setRadius(0, 0.5, 0.25);
  EXPECT_LE(balls.radius(0), 0.25);
  EXPECT_GE(balls.radius(0), 0.25 * (1 - 1.0 / 64));
  balls.setRadius(0, 0.125, 0.25);
  EXPECT_LT(balls.radius(0), 0);
}

}  // namespace
}  // namespace ringwatch
