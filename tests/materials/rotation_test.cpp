// The closest rotation against Eigen's singular value decomposition.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include <ringwatch/base/pack.h>
#include <ringwatch/materials/rotation.h>
#include <tests/support/deformations.h>

namespace ringwatch {
namespace {

using test::withSingularValues;

Eigen::Matrix3d closest(const Eigen::Matrix3d& F) { return test::toEigen(closestRotation(test::toMatrix3(F))); }

/// U diag(1, 1, ±1) Vᵀ with determinant +1.
Eigen::Matrix3d closestBySvd(const Eigen::Matrix3d& F) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(F, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double sign = (svd.matrixU() * svd.matrixV().transpose()).determinant();
  return svd.matrixU() * Eigen::Vector3d(1, 1, sign).asDiagonal() * svd.matrixV().transpose();
}

void expectRotation(const Eigen::Matrix3d& R, double tolerance = 1e-13) {
  EXPECT_LE((R.transpose() * R - Eigen::Matrix3d::Identity()).norm(), tolerance);
  EXPECT_NEAR(R.determinant(), 1, tolerance);
}

void expectClosest(const Eigen::Matrix3d& F, double tolerance = 1e-12) {
  const Eigen::Matrix3d R = closest(F);
  expectRotation(R);
  EXPECT_LE((R - closestBySvd(F)).norm(), tolerance) << F;
}

TEST(ClosestRotation, IsThePolarFactorOfRandomMatrices) {
  test::Random random(1);
  for (int i = 0; i < 2000; ++i)
    expectClosest(withSingularValues(random, {random.uniform(0.2, 3), random.uniform(0.2, 3), random.uniform(0.2, 3)}));
}

TEST(ClosestRotation, IsTheRotationItselfAndNearIt) {
  test::Random random(2);
  expectClosest(Eigen::Matrix3d::Identity(), 1e-15);
  for (int i = 0; i < 300; ++i) {
    const Eigen::Matrix3d Q = random.rotation();
    EXPECT_LE((closest(Q) - Q).norm(), 1e-14);
    for (const double noise : {1e-15, 1e-12, 1e-9, 1e-6, 1e-3}) expectClosest(Q + random.matrix(noise));
  }
}

TEST(ClosestRotation, HandlesInvertedMatrices) {
  test::Random random(3);
  for (int i = 0; i < 1000; ++i)
    expectClosest(
        withSingularValues(random, {random.uniform(0.5, 3), random.uniform(0.5, 1), -random.uniform(0.0, 0.4)}));
}

TEST(ClosestRotation, HandlesNearlyEqualSingularValues) {
  test::Random random(4);
  for (int i = 0; i < 200; ++i)
    for (const double gap : {0.0, 1e-15, 1e-12, 1e-9, 1e-6}) {
      expectClosest(withSingularValues(random, {1 + gap, 1, 1 - gap}));
      expectClosest(withSingularValues(random, {2 + gap, 2, 0.5}));
      expectClosest(withSingularValues(random, {3, 0.5 + gap, 0.5}));
      expectClosest(withSingularValues(random, {1 + gap, 1, -0.5}));
    }
}

TEST(ClosestRotation, HandlesMatricesFlattenedToAPlane) {
  test::Random random(5);
  for (int i = 0; i < 300; ++i) {
    expectClosest(withSingularValues(random, {random.uniform(0.5, 2), random.uniform(0.5, 2), 0}));
    expectClosest(withSingularValues(random, {random.uniform(0.5, 2), random.uniform(0.5, 2), 1e-10}));
  }
}

TEST(ClosestRotation, StaysFiniteWhereTheRotationIsNotUnique) {
  test::Random random(6);
  for (int i = 0; i < 300; ++i) {
    const Eigen::Matrix3d line = withSingularValues(random, {random.uniform(0.5, 2), 0, 0});
    const Eigen::Matrix3d mirror = withSingularValues(random, {1, 1, -1});
    EXPECT_TRUE(closest(line).allFinite()) << line;
    EXPECT_TRUE(closest(mirror).allFinite()) << mirror;
  }
  EXPECT_EQ(closest(Eigen::Matrix3d::Zero()), Eigen::Matrix3d::Identity());
}

TEST(ClosestRotation, StaysARotationOnTheWayToALine) {
  test::Random random(7);
  for (double width = 1; width > 1e-16; width *= 0.5)
    for (int i = 0; i < 50; ++i) {
      const Eigen::Matrix3d R = closest(withSingularValues(random, {1, width, random.uniform(0, 1) * width}));
      SCOPED_TRACE(width);
      expectRotation(R, 1e-8);
    }
}

TEST(ClosestRotation, DoesNotDependOnScale) {
  test::Random random(8);
  for (int i = 0; i < 100; ++i) {
    const Eigen::Matrix3d F = withSingularValues(random, {2, 1, 0.5});
    for (const double scale : {1e-30, 1e-10, 1e10, 1e30})
      EXPECT_LE((closest(scale * F) - closest(F)).norm(), 1e-13) << scale;
  }
}

TEST(ClosestRotation, IsTheSameInEveryLaneOfAPack) {
  test::Random random(9);
  for (int i = 0; i < 200; ++i) {
    std::array<Eigen::Matrix3d, NativePack::width> F;
    Matrix3<NativePack> packed;
    for (int lane = 0; lane < NativePack::width; ++lane) {
      F[lane] = withSingularValues(random, {random.uniform(0.5, 3), random.uniform(0.5, 1), random.uniform(-0.4, 1)});
      for (int k = 0; k < 9; ++k) packed.m[k].set(lane, F[lane](k / 3, k % 3));
    }
    const Matrix3<NativePack> R = closestRotation(packed);
    for (int lane = 0; lane < NativePack::width; ++lane) {
      const Eigen::Matrix3d expected = closest(F[lane]);
      for (int k = 0; k < 9; ++k) EXPECT_NEAR(R.m[k][lane], expected(k / 3, k % 3), 1e-13);
    }
  }
}

RC_GTEST_PROP(ClosestRotation, RotatesWithItsArgument, ()) {
  test::Random random(*rc::gen::arbitrary<std::uint64_t>());
  const Eigen::Matrix3d F =
      withSingularValues(random, {random.uniform(1, 3), random.uniform(0.5, 1), random.uniform(-0.4, 1)});
  const Eigen::Matrix3d Q = random.rotation();
  RC_ASSERT((closest(Q * F) - Q * closest(F)).norm() <= 1e-13);
  RC_ASSERT((closest(F * Q) - closest(F) * Q).norm() <= 1e-13);
}

}  // namespace
}  // namespace ringwatch
