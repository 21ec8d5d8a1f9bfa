// Lumped masses of quadratic elements: positive, and those that the scheme's authors give.
#include <gtest/gtest.h>

#include <ringwatch/body/body.h>
#include <ringwatch/meshes/generators/generators.h>

namespace ringwatch {
namespace {

Mesh referenceMesh(std::string_view name) {
  const ElementInfo& info = *findElementByName(name);
  Mesh mesh;
  mesh.X.resize(3, info.nodes);
  mesh.blocks.push_back({info.type, {}, {0}});
  for (int a = 0; a < info.nodes; ++a) {
    mesh.X.col(a) = Eigen::Vector3d::Map(info.referenceNodes[a].data());
    mesh.blocks[0].connectivity.push_back(a);
  }
  return mesh;
}

TEST(Lumping, DiagonalScalingOfTheQuadraticTetrahedronGivesCornersOne36thAndMiddlesFour27ths) {
  // Diagonal of the consistent mass ρV/420 · (6 at corners, 32 at middles), hence 6/216 and 32/216 of the mass.
  const Body body(referenceMesh("tet10"), makeMaterial("linear", 30e3, 0.3, 1000));
  const double mass = 1000.0 / 6;
  for (int a = 0; a < 10; ++a) EXPECT_NEAR(body.lumpedMass()[a] / mass, a < 4 ? 1.0 / 36 : 4.0 / 27, 1e-14) << a;
}

TEST(Lumping, EveryNodeOfEveryElementHasPositiveMassUnderEveryScheme) {
  for (const CellSubdivision& split : allCellSubdivisions())
    for (const Lumping lumping : {Lumping::rowSum, Lumping::equal, Lumping::diagonalScaling}) {
      BarOptions options;
      options.cells = {3, 2, 2};
      options.element = split.element;
      options.split = split.elementsPerCell;
      options.jitter = 0.15;
      const Body body(generateBar(options), makeMaterial("linear", 30e3, 0.3, 1000), {{}, lumping, 0});
      EXPECT_GT(body.lumpedMass().minCoeff(), 0) << split.element;
      EXPECT_NEAR(body.totalMass(), 1000, 1e-9) << split.element;
      EXPECT_NEAR(body.volume(), 1, 1e-12) << split.element;
    }
}

TEST(Lumping, RowSumsOfLinearElementsStayWhatTheyAre) {
  const Body body(referenceMesh("hex8"), makeMaterial("linear", 30e3, 0.3, 1000));
  for (int a = 0; a < 8; ++a) EXPECT_NEAR(body.lumpedMass()[a], 1000, 1e-9);
}

}  // namespace
}  // namespace ringwatch
