// The words for why an element is in the way, on elements whose deformation and shape are known.
#include <gtest/gtest.h>

#include <limits>

#include <ringwatch/base/error.h>
#include <ringwatch/meshes/quality.h>
#include <ringwatch/monitor/element_cause.h>
#include <tests/monitor/monitor_cases.h>

namespace ringwatch {
namespace {

/// A box of regular enough elements of one type.
Body plainBox(const char* element) {
  BarOptions options;
  options.size = {0.03, 0.02, 0.02};
  options.cells = {3, 2, 2};
  options.element = element;
  return Body(generateBar(options), makeMaterial("stvk", test::young, test::poisson, test::density),
              test::onThreads(1));
}

TEST(ElementCause, NamesTheLargestDepartureFromRest) {
  for (const ElementInfo& element : allElements()) {
    const Body body = plainBox(std::string(element.name).c_str());
    const NodeVectors& X = body.mesh().X;
    EXPECT_EQ(causeText(elementCause(body, X, {0, 1})), "well shaped, unstrained") << element.name;
    test::Random random(3);
    const auto moved = [&](double a, double b, double c) {
      return NodeVectors(random.rotation() * Eigen::Vector3d(a, b, c).asDiagonal() * X);
    };
    EXPECT_EQ(causeText(elementCause(body, moved(1.6, 0.9, 0.9), {0, 1})), "stretched 1.6") << element.name;
    EXPECT_EQ(causeText(elementCause(body, moved(1.1, 1.1, 0.5), {0, 1})), "compressed to 0.5") << element.name;
    EXPECT_EQ(causeText(elementCause(body, moved(1, 1.02, 1), {0, 1})), "well shaped, unstrained") << element.name;
    EXPECT_EQ(causeText(elementCause(body, moved(1, 1, -0.3), {0, 1})), "inverted, det F = -0.3") << element.name;
    EXPECT_EQ(causeText(elementCause(body, std::numeric_limits<double>::quiet_NaN() * X, {0, 1})), "not finite")
        << element.name;
  }
}

TEST(ElementCause, NamesABadShapeAtRest) {
  Mesh mesh = plainBox("tet4").mesh();
  mesh.X.row(2) *= 0.01;
  const Body flat(mesh, makeMaterial("stvk", test::young, test::poisson, test::density), test::onThreads(1));
  for (std::int32_t e = 0; e < 4; ++e) {
    const ElementShape shape = elementShape(flat.mesh().blocks[0], e, flat.mesh().X, 0);
    EXPECT_NE(shape.shape, ShapeClass::round);
    EXPECT_EQ(causeText(elementCause(flat, flat.mesh().X, {0, e})), shape.text());
    EXPECT_EQ(causeText(elementCause(flat, 1.6 * flat.mesh().X, {0, e})), joinText("stretched 1.6; ", shape.text()));
  }
  Mesh bricks = plainBox("hex8").mesh();
  bricks.X.row(2) *= 0.1;
  const Body slender(bricks, makeMaterial("stvk", test::young, test::poisson, test::density), test::onThreads(1));
  EXPECT_EQ(causeText(elementCause(slender, slender.mesh().X, {0, 0})), "dihedral angles 90° to 90°, aspect 10");
}

}  // namespace
}  // namespace ringwatch
