// What the odometer promises: no deformation gradient changes by more than its readings allow.
#include <gtest/gtest.h>

#include <limits>
#include <numeric>

#include <Eigen/Dense>

#include <ringwatch/body/motion_odometer.h>
#include <tests/support/random.h>

namespace ringwatch {
namespace {

using test::Random;

std::vector<std::int32_t> inOrder(std::int32_t nodes) {
  std::vector<std::int32_t> order(static_cast<std::size_t>(nodes));
  std::iota(order.begin(), order.end(), 0);
  return order;
}

/// Readings of the runs at some nodes, as DeformationWatch uses them.
double moved(const MotionOdometer& odometer, const std::vector<std::int32_t>& nodes) {
  Eigen::Vector3d common = Eigen::Vector3d::Zero();
  for (const std::int32_t i : nodes)
    common +=
        odometer.courses()[static_cast<std::size_t>(odometer.runOf(i))].middle / static_cast<double>(nodes.size());
  double most = 0;
  for (const std::int32_t i : nodes) {
    const MotionOdometer::Course& course = odometer.courses()[static_cast<std::size_t>(odometer.runOf(i))];
    most = std::max(most, (course.middle - common).norm() + course.about);
  }
  return most;
}

class OdometerTest : public ::testing::TestWithParam<std::int32_t> {};
INSTANTIATE_TEST_SUITE_P(Nodes, OdometerTest, ::testing::Values(4, 7, 8, 9, 127, 128, 129, 1000),
                         [](const auto& test) { return std::to_string(test.param); });

TEST_P(OdometerTest, BoundsTheChangeOfEveryDeformationGradient) {
  const std::int32_t nodes = GetParam();
  Random random(21);
  for (int trial = 0; trial < 20; ++trial) {
    const NodeVectors X = random.nodeVectors(nodes, 1);
    NodeVectors x = X;
    MotionOdometer odometer(inOrder(nodes), 1);
    odometer.advance(x);
    const double scale = std::pow(10.0, random.uniform(-6, -1));
    double largest = 0;  // |F| on the way
    struct Tet {
      std::vector<std::int32_t> nodes;
      Eigen::Matrix3d inverse;
      double gradientNorm;
    };
    std::vector<Tet> tets;
    for (int k = 0; k < 50; ++k) {
      Tet tet;
      while (tet.nodes.size() < 4) {
        const std::int32_t node = random.index(nodes);
        if (std::find(tet.nodes.begin(), tet.nodes.end(), node) == tet.nodes.end()) tet.nodes.push_back(node);
      }
      Eigen::Matrix3d edges;
      for (int j = 0; j < 3; ++j)
        edges.col(j) = X.col(tet.nodes[static_cast<std::size_t>(j) + 1]) - X.col(tet.nodes[0]);
      if (std::abs(edges.determinant()) < 1e-3) continue;
      tet.inverse = edges.inverse();
      tet.gradientNorm = tet.inverse.colwise().sum().norm() + tet.inverse.rowwise().norm().sum();
      tets.push_back(tet);
    }
    const auto gradient = [&](const Tet& tet) {
      Eigen::Matrix3d edges;
      for (int j = 0; j < 3; ++j)
        edges.col(j) = x.col(tet.nodes[static_cast<std::size_t>(j) + 1]) - x.col(tet.nodes[0]);
      return Eigen::Matrix3d(edges * tet.inverse);
    };
    std::vector<double> most(tets.size(), std::sqrt(3.0));
    for (int step = 0; step < 10; ++step) {
      const Eigen::Matrix3d A = random.matrix(0.1);
      x += (A * x).colwise() + random.vector(1);
      x += random.nodeVectors(nodes, scale);
      odometer.advance(x);
      for (std::size_t k = 0; k < tets.size(); ++k) {
        const Eigen::Matrix3d F = gradient(tets[k]);
        most[k] = std::max(most[k], F.norm());
        EXPECT_LE((F - Eigen::Matrix3d::Identity()).norm(),
                  odometer.turned() * most[k] + tets[k].gradientNorm * moved(odometer, tets[k].nodes) + 1e-12);
        largest = std::max(largest, most[k]);
      }
    }
    EXPECT_GT(largest, 0);
  }
}

TEST(MotionOdometer, DoesNotSeeARigidMove) {
  Random random(22);
  NodeVectors x = random.nodeVectors(500, 1);
  MotionOdometer odometer(inOrder(500), 1);
  for (int step = 0; step < 100; ++step) {
    odometer.advance(x);
    x = x.colwise() + Eigen::Vector3d(0.3, -0.2, 0.1);
  }
  EXPECT_LE(odometer.turned(), 1e-11);
  for (const MotionOdometer::Course& course : odometer.courses()) EXPECT_LE(course.middle.norm() + course.about, 1e-10);
}

TEST(MotionOdometer, TellsRunsApart) {
  // One end is still; shaking the other must not count there.
  Random random(23);
  NodeVectors X = random.nodeVectors(1024, 1);
  MotionOdometer odometer(inOrder(1024), 1);
  for (int step = 0; step < 20; ++step) {
    NodeVectors x = X;
    x.rightCols(16) += random.nodeVectors(16, 1e-3);
    odometer.advance(x);
  }
  EXPECT_GT(odometer.courses().back().about, 5e-3);
  EXPECT_LT(odometer.courses().front().about, 0.5 * odometer.courses().back().about);
}

TEST(MotionOdometer, AStateThatIsNotFiniteIsNeverForgotten) {
  Random random(24);
  const NodeVectors X = random.nodeVectors(100, 1);
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    MotionOdometer odometer(inOrder(100), 1);
    odometer.advance(X);
    NodeVectors x = X;
    x(1, 37) = bad;
    odometer.advance(x);
    odometer.advance(X);
    const MotionOdometer::Course& course = odometer.courses()[static_cast<std::size_t>(odometer.runOf(37))];
    EXPECT_FALSE(std::isfinite(course.about));
  }
}

TEST(MotionOdometer, DoesNotDependOnThreads) {
  Random random(25);
  const NodeVectors X = random.nodeVectors(5000, 1), step = random.nodeVectors(5000, 1e-3);
  MotionOdometer one(inOrder(5000), 1), three(inOrder(5000), 3);
  for (MotionOdometer* odometer : {&one, &three}) {
    odometer->advance(X);
    odometer->advance(X + step);
  }
  EXPECT_EQ(one.turned(), three.turned());
  for (std::size_t run = 0; run < one.courses().size(); ++run)
    EXPECT_EQ(one.courses()[run].about, three.courses()[run].about);
}

}  // namespace
}  // namespace ringwatch
