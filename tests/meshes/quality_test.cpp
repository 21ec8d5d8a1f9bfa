#include <ringwatch/meshes/quality.h>

#include <cmath>
#include <numbers>

#include <ringwatch/meshes/generators.h>

#include "tests/meshes/mesh_test_tools.h"

namespace ringwatch {
namespace {

Mesh oneTet(const Eigen::Matrix<double, 3, 4>& X) {
  Mesh mesh;
  mesh.X = X;
  mesh.nodeIds = {0, 1, 2, 3};
  mesh.blocks = {{elementTypeOf<Tet4>, {0, 1, 2, 3}, {0}}};
  return mesh;
}

TEST(Quality, RegularTetrahedron) {
  Eigen::Matrix<double, 3, 4> X;  // edge √8
  X << 1, -1, -1, 1, 1, -1, 1, -1, 1, 1, -1, -1;
  const Mesh mesh = oneTet(X);
  ElementQuality q = meshQuality(mesh)[0][0];
  const double edge = std::sqrt(8.0);
  EXPECT_NEAR(std::abs(q.volume), 8.0 / 3.0, 1e-14);
  EXPECT_NEAR(q.minDihedral, std::acos(1.0 / 3.0) * 180 / std::numbers::pi, 1e-12);
  EXPECT_NEAR(q.maxDihedral, q.minDihedral, 1e-12);
  EXPECT_NEAR(q.radiusRatio, 1, 1e-14);
  EXPECT_NEAR(q.minHeight, edge * std::sqrt(2.0 / 3.0), 1e-14);
  EXPECT_NEAR(q.minEdge, edge, 1e-14);
  EXPECT_NEAR(q.maxEdge, edge, 1e-14);
  EXPECT_NEAR(std::abs(q.minScaledJacobian), 1, 1e-14);
}

TEST(Quality, CornerTetrahedron) {
  Eigen::Matrix<double, 3, 4> X;
  X << 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1;
  const ElementQuality q = meshQuality(oneTet(X))[0][0];
  EXPECT_NEAR(q.volume, 1.0 / 6.0, 1e-15);
  EXPECT_NEAR(q.minDihedral, std::atan(std::sqrt(2.0)) * 180 / std::numbers::pi, 1e-12);
  EXPECT_NEAR(q.maxDihedral, 90, 1e-12);
  EXPECT_NEAR(q.minHeight, 1 / std::sqrt(3.0), 1e-15);
  // r = 1/(3 + √3), R = √3/2
  EXPECT_NEAR(q.radiusRatio, 3 / (3 + std::sqrt(3.0)) / (std::sqrt(3.0) / 2), 1e-14);
  EXPECT_NEAR(q.minScaledJacobian, std::sqrt(2.0) / 2, 1e-14);
}

TEST(Quality, AFlatTetrahedronHasNoVolumeButNoNaN) {
  Eigen::Matrix<double, 3, 4> X;
  X << 0, 1, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0;
  const ElementQuality q = meshQuality(oneTet(X))[0][0];
  EXPECT_EQ(q.volume, 0);
  EXPECT_EQ(q.minHeight, 0);
  EXPECT_EQ(q.radiusRatio, 0);
  EXPECT_NEAR(q.maxDihedral, 180, 1e-9);
}

TEST(Quality, BrickAndItsSheared) {
  Mesh mesh = generateBar({.size = {3, 2, 0.5}, .cells = {1, 1, 1}, .element = "hex8"});
  ElementQuality q = meshQuality(mesh)[0][0];
  EXPECT_NEAR(q.volume, 3, 1e-14);
  EXPECT_NEAR(q.minHeight, 0.5, 1e-14);
  EXPECT_EQ(q.minEdge, 0.5);
  EXPECT_EQ(q.maxEdge, 3);
  EXPECT_NEAR(q.minScaledJacobian, 1, 1e-14);
  EXPECT_TRUE(std::isnan(q.radiusRatio));
  mesh.X.row(0) += mesh.X.row(2) * 2;  // the angle between x and z becomes atan(1/2)
  q = meshQuality(mesh)[0][0];
  EXPECT_NEAR(q.volume, 3, 1e-14);
  EXPECT_NEAR(q.minScaledJacobian, 1 / std::sqrt(5.0), 1e-14);
}

TEST(Quality, SummaryNamesTheExtremes) {
  const Mesh mesh = test::mixedMesh();
  const auto summaries = summarizeQuality(meshQuality(mesh));
  ASSERT_FALSE(summaries.empty());
  EXPECT_EQ(summaries[0].name, "volume");
  EXPECT_EQ(summaries[0].count, 4u);
  EXPECT_NEAR(summaries[0].mean * 4, meshVolume(mesh), 1e-14);
  EXPECT_EQ(summaries[0].minElement.block, 1);
  for (const QualitySummary& s : summaries)
    if (s.name == "min-dihedral") {
      EXPECT_EQ(s.count, 2u);
    }
}

}  // namespace
}  // namespace ringwatch
