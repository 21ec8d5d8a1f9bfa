// Tetrahedra in batches without common nodes: the rotations that they follow, and any number of threads.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <ringwatch/extensions/fe_pbd/relaxed_tetrahedra.h>
#include <ringwatch/extensions/tetrahedra/corotated_tetrahedron.h>
#include <tests/handlers/handler_cases.h>

namespace ringwatch {
namespace {

/// A turned, strained body with a fixed node, one held in a component, and a count of elements that leaves lanes empty.
Body body(int threads = 1) {
  Mesh mesh = test::gridMesh("tet4", {5, 3, 2}, {0.1, 0.06, 0.04});
  Body result(mesh, makeMaterial("corotational", test::young, test::poisson, test::density),
              {{}, Lumping::rowSum, threads});
  result.constraints().fix(0);
  result.constraints().fix(7, 1);
  return result;
}
NodeVectors moved(const Body& b, double angle) {
  test::Random random(3);
  const Eigen::Matrix3d Q(Eigen::AngleAxisd(angle, Eigen::Vector3d(1, -2, 0.5).normalized()));
  return Q * (b.mesh().X + random.nodeVectors(b.nodeCount(), 2e-3));
}

TEST(FollowedRotation, IsTheClosestOneToThirdOrder) {
  const Eigen::Vector3d axis = Eigen::Vector3d(2, -1, 0.7).normalized();
  const auto from = [](const Eigen::Matrix3d& m) {
    Matrix3<NativePack> r;
    for (int i = 0; i < 9; ++i) r.m[i] = NativePack(m(i / 3, i % 3));
    return r;
  };
  Eigen::Matrix3d U;
  U << 1.3, 0.1, -0.05, 0.1, 0.8, 0.2, -0.05, 0.2, 1;
  const auto errorOf = [&](double angle) {
    const Matrix3<NativePack> R =
        followedRotation(from(Eigen::AngleAxisd(angle, axis).toRotationMatrix() * U), Matrix3<NativePack>::identity());
    const Eigen::Matrix3d exact(Eigen::AngleAxisd(angle, axis));
    double error = 0;
    for (int i = 0; i < 9; ++i) error = std::max(error, std::abs(R.m[i][0] - exact(i / 3, i % 3)));
    return error;
  };
  EXPECT_LT(errorOf(0.04), std::pow(0.04, 3));
  EXPECT_NEAR(errorOf(0.04) / errorOf(0.02), 8, 0.5);
  EXPECT_LT(errorOf(0.1), 1e-14);  // from scratch
  EXPECT_LT(errorOf(3), 1e-14);
}

TEST(ColouredTetrahedra, DoNotDependOnTheNumberOfThreads) {
  NodeVectors first;
  for (const int threads : {1, 2, 5}) {
    const Body b = body(threads);
    RelaxedTetrahedra tetrahedra(b, test::everyElement(b), 2e-3, GoalShape::linear, 2);
    const NodeVectors v = NodeVectors::Zero(3, b.nodeCount());
    NodeVectors a = v;
    ASSERT_TRUE(tetrahedra.relax(moved(b, 0.3), v, a));
    if (threads == 1) first = a;
    EXPECT_EQ(a, first);
    EXPECT_GT(a.norm(), 0);
  }
}

}  // namespace
}  // namespace ringwatch
