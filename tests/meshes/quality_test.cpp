#include <ringwatch/meshes/quality.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include <Eigen/Geometry>

#include <ringwatch/meshes/generators/generators.h>

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

/// The class of a tetrahedron, the same for any size, position and order of its nodes.
ShapeClass classOf(const Eigen::Matrix<double, 3, 4>& corners, double meanVolume = 0) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  std::optional<ShapeClass> shape;
  std::array<std::int32_t, 4> order{0, 1, 2, 3};
  do {
    Mesh mesh = oneTet((turn * corners * 1e-3).colwise() + Eigen::Vector3d(1, 2, 3));
    mesh.blocks[0].connectivity.assign(order.begin(), order.end());
    const ShapeClass now = elementShape(mesh.blocks[0], 0, mesh.X, 1e-9 * meanVolume).shape;
    EXPECT_EQ(now, shape.value_or(now));
    shape = now;
  } while (std::next_permutation(order.begin(), order.end()));
  return *shape;
}

TEST(Shape, ClassesOfFigure41) {
  Eigen::Matrix<double, 3, 4> X;
  X << 1, -1, -1, 1, 1, -1, 1, -1, 1, 1, -1, -1;
  EXPECT_EQ(classOf(X), ShapeClass::round);
  EXPECT_EQ(classOf(X, 8.0 / 3 * 7.9), ShapeClass::round);
  EXPECT_EQ(classOf(X, 8.0 / 3 * 8.1), ShapeClass::small);
  X << 0, 1, 1, 1, 0, 0, 1, 1, 0, 0, 0, 1;  // Kuhn's
  EXPECT_EQ(classOf(X), ShapeClass::round);
  X << 0, 0.1, 0.05, 0.05, 0, 0, 0.09, 0.03, 0, 0, 0, 1;  // a small base and a far apex
  EXPECT_EQ(classOf(X), ShapeClass::needle);
  X << 0, 0.1, 0.05, 0.05, 0, 0, -0.05, 0.05, 0, 0, 1, 1;  // two far pairs
  EXPECT_EQ(classOf(X), ShapeClass::needle);
  X << 0, 0, 1, 1, 0, 0, 0.5, -0.5, 0.05, -0.05, 0, 0;  // one short edge, the others long
  EXPECT_EQ(classOf(X), ShapeClass::wedge);
  X << -1, 1, 0, 0, 0, 0, -1, 1, 0.03, 0.03, -0.03, -0.03;  // two diagonals of a square, a little apart
  EXPECT_EQ(classOf(X), ShapeClass::sliver);
  X << -1, 1, 0, 0, 0, 0, -0.3, 0.3, 0.03, 0.03, -0.03, -0.03;  // of a slender rhombus
  EXPECT_EQ(classOf(X), ShapeClass::spindle);
  X << 0, 1, 0, 0.33, 0, 0, 1, 0.33, 0, 0, 0, 0.05;  // a node just above the middle of a face
  EXPECT_EQ(classOf(X), ShapeClass::cap);
}

TEST(Shape, AnglesOfATetrahedronAreThoseOfItsQuality) {
  Eigen::Matrix<double, 3, 4> X;
  X << 0, 1, 0.2, 0.1, 0, 0.1, 1, 0.2, 0, 0, 0.1, 0.4;
  const Mesh mesh = oneTet(X);
  const ElementQuality q = meshQuality(mesh)[0][0];
  const ElementShape shape = elementShape(mesh.blocks[0], 0, mesh.X, 0);
  EXPECT_NEAR(shape.minDihedral, q.minDihedral, 1e-11);
  EXPECT_NEAR(shape.maxDihedral, q.maxDihedral, 1e-11);
  EXPECT_NEAR(shape.aspect, q.maxEdge / q.minEdge, 1e-13);
}

TEST(Shape, OfOthersIsToldByAnglesAndAspect) {
  BarOptions options;
  options.size = {3, 1, 2};
  options.cells = {1, 1, 1};
  options.element = "hex8";
  Mesh mesh = generateBar(options);
  EXPECT_EQ(elementShape(mesh.blocks[0], 0, mesh.X, 0).text(), "dihedral angles 90° to 90°, aspect 3");
  mesh.X.row(0) += mesh.X.row(1);  // sheared by 45°
  const ElementShape sheared = elementShape(mesh.blocks[0], 0, mesh.X, 0);
  EXPECT_NEAR(sheared.minDihedral, 45, 1e-10);
  EXPECT_NEAR(sheared.maxDihedral, 135, 1e-10);
  EXPECT_EQ(sheared.shape, ShapeClass::other);
}

}  // namespace
}  // namespace ringwatch
