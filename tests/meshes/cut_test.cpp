#include <gmock/gmock.h>

#include <random>

#include <Eigen/Geometry>

#include <ringwatch/meshes/check.h>
#include <ringwatch/meshes/generators/generators.h>
#include <ringwatch/meshes/modify/cut.h>
#include <ringwatch/meshes/quality.h>

#include "tests/meshes/mesh_test_tools.h"

namespace ringwatch {
namespace {

using Eigen::Vector3d;
using ::testing::HasSubstr;

Mesh box(double jitter) {
  BarOptions o;
  o.size = {0.2, 0.1, 0.1};
  o.cells = {6, 3, 3};
  o.jitter = jitter;
  return generateBar(o);
}

/// What holds of every cut: nothing lost, nothing overlapping, no element of no volume, boundary grown by two lips.
void expectSound(const CutMesh& cut, const Mesh& before) {
  EXPECT_TRUE(checkMesh(cut.mesh).empty());
  EXPECT_TRUE(faceNeighbours(cut.mesh).overfull.empty());
  EXPECT_NEAR(meshVolume(cut.mesh), meshVolume(before), 1e-12 * meshVolume(before));
  EXPECT_NEAR(test::boundaryArea(cut.mesh), test::boundaryArea(before) + 2 * cut.area,
              1e-10 * test::boundaryArea(before));
  ASSERT_EQ(cut.origin.size(), cut.mesh.nodeCount());
  ASSERT_EQ(cut.mesh.nodeIds.size(), cut.mesh.nodeCount());
  EXPECT_EQ(cut.nodesAdded, cut.mesh.nodeCount() - before.nodeCount());
  EXPECT_LT((carriedOver(cut, before.X) - cut.mesh.X).norm(), 1e-15 * before.X.norm());
  const JacobianProbe probe(elementInfo(cut.mesh.blocks[0].type));
  std::vector<double> volume(before.elementCount(), 0);
  for (std::size_t e = 0; e < cut.mesh.elementCount(); ++e) {
    const double own = probe.volume(cut.mesh.X, cut.mesh.blocks[0].element(e));
    EXPECT_GT(own, 0);
    volume[cut.parent[0][e]] += own;
  }
  for (std::size_t e = 0; e < volume.size(); ++e)
    EXPECT_NEAR(volume[e], probe.volume(before.X, before.blocks[0].element(e)), 1e-12 * volume[e]);
}

/// Every element lies on one side of a plane, but for what snapping bends.
double deepestAcross(const CutMesh& cut, const Vector3d& point, const Vector3d& normal) {
  double deepest = 0;
  for (std::size_t e = 0; e < cut.mesh.elementCount(); ++e) {
    double low = 0, high = 0;
    for (int a = 0; a < 4; ++a) {
      const double d = normal.dot(Vector3d(cut.mesh.X.col(cut.mesh.blocks[0].element(e)[a])) - point);
      low = std::min(low, d);
      high = std::max(high, d);
    }
    deepest = std::max(deepest, std::min(-low, high));
  }
  return deepest;
}

TEST(Cut, PlaneAcrossGivesTwoPartsAndTheSectionsArea) {
  for (const double jitter : {0.0, 0.2})
    for (const double at : {0.07, 0.1, 0.1 + 1e-9, 0.123}) {
      SCOPED_TRACE(joinText(jitter, " ", at));
      const Mesh mesh = box(jitter);
      const CutMesh cut = cutMesh(mesh, CutSurface::plane({at, 0, 0}, {2, 0, 0}), mesh.X, 0);
      expectSound(cut, mesh);
      EXPECT_NEAR(cut.area, 0.01, 1e-7);
      EXPECT_EQ(connectedParts(cut.mesh).count, 2);
      EXPECT_LT(deepestAcross(cut, {at, 0, 0}, Vector3d::UnitX()), 2e-7);  // a millionth of an edge
      // Through nodes of the regular grid nothing is subdivided.
      if (jitter == 0 && std::abs(at - 0.1) < 1e-8) {
        EXPECT_EQ(cut.elementsCut, 0u);
        EXPECT_EQ(cut.nodesAdded, 16u);
      } else {
        EXPECT_GT(cut.elementsCut, 50u);
      }
    }
}

TEST(Cut, RandomPlanesAndSnapsAreSound) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < 60; ++i) {
    SCOPED_TRACE(i);
    const Mesh mesh = box(i % 2 == 0 ? 0.0 : 0.25);
    const double snap = std::array{0.0, 0.05, 0.2, 0.5}[static_cast<std::size_t>(i) % 4];
    const Vector3d point(0.2 * unit(random), 0.1 * unit(random), 0.1 * unit(random));
    const Vector3d direction = Vector3d(normal(random), normal(random), normal(random)).normalized();
    const CutMesh cut = cutMesh(mesh, CutSurface::plane(point, direction), mesh.X, snap);
    expectSound(cut, mesh);
    ASSERT_GT(cut.facesOpened, 0u);
    // Snapping may leave a rim of the body in one piece, never join the two sides again elsewhere.
    if (snap > 0) continue;
    EXPECT_EQ(connectedParts(cut.mesh).count, 2);
    EXPECT_LT(deepestAcross(cut, point, direction), 1e-6);
  }
}

TEST(Cut, SnappingSavesSlivers) {
  const Mesh mesh = box(0.2);
  const CutSurface plane = CutSurface::plane({0.103, 0, 0}, {1, 0.1, 0});
  const auto leastHeight = [](const Mesh& m) {
    double least = 1;
    const auto quality = meshQuality(m);
    for (const ElementQuality& own : quality[0]) least = std::min(least, own.minHeight);
    return least;
  };
  const CutMesh exact = cutMesh(mesh, plane, mesh.X, 0), snapped = cutMesh(mesh, plane, mesh.X, 0.25);
  EXPECT_LT(leastHeight(exact.mesh), 0.2 * leastHeight(snapped.mesh));
  EXPECT_LT(snapped.mesh.elementCount(), exact.mesh.elementCount());
}

TEST(Cut, ASlitLeavesTheBodyInOnePieceAndEndsWhereItEnds) {
  const Mesh mesh = box(0.1);
  // From above to the middle of the height, across the whole width.
  const CutSurface slit = CutSurface::swept({{0.09, -0.01, 0.05}, {0.09, 0.11, 0.05}}, {0, 0, 0.06});
  const CutMesh cut = cutMesh(mesh, slit, mesh.X, 0);
  expectSound(cut, mesh);
  EXPECT_EQ(connectedParts(cut.mesh).count, 1);
  // Whole faces open, so the rim is good to an element.
  EXPECT_NEAR(cut.area, 0.1 * 0.05, 0.1 * 0.035);
  EXPECT_GT(cut.area, 0.1 * 0.02);
  double lowest = 1;
  for (std::size_t n = 0; n < cut.origin.size(); ++n)
    if (cut.origin[n].t != 0) lowest = std::min(lowest, cut.mesh.X(2, n));
  EXPECT_GE(lowest, 0.05 - 1e-12);
}

TEST(Cut, PolylineWithACornerCutsAlongBothPieces) {
  const Mesh mesh = box(0);
  // A wedge out of the long side: in the plane x, y, swept through the whole height.
  const CutSurface corner =
      CutSurface::swept({{0.05, -0.01, -0.01}, {0.1, 0.06, -0.01}, {0.15, -0.01, -0.01}}, {0, 0, 0.12});
  const CutMesh cut = cutMesh(mesh, corner, mesh.X, 0);
  expectSound(cut, mesh);
  EXPECT_EQ(connectedParts(cut.mesh).count, 2);
  const double length = 2 * (Vector3d(0.1, 0.06, 0) - Vector3d(0.05, -0.01, 0)).norm() * 0.06 / 0.07;
  EXPECT_NEAR(cut.area, length * 0.1, 0.1 * length * 0.1);  // the corner is rounded by an element
}

TEST(Cut, DeformedPositionsDecideWhereItCuts) {
  const Mesh mesh = box(0.1);
  NodeVectors x = mesh.X;
  x.row(0) *= 2;  // stretched to twice its length
  const CutMesh cut = cutMesh(mesh, CutSurface::plane({0.2, 0, 0}, {1, 0, 0}), x, 0);
  expectSound(cut, mesh);
  EXPECT_LT(deepestAcross(cut, {0.1, 0, 0}, Vector3d::UnitX()), 2e-7);
}

TEST(Cut, MissesAndGrazesLeaveTheMesh) {
  const Mesh mesh = box(0.2);
  for (const CutSurface& surface :
       {CutSurface::plane({0.3, 0, 0}, {1, 0, 0}), CutSurface::plane({0.2, 0, 0}, {1, 0, 0}),
        CutSurface::plane({0, 0, 0}, {1, 1, 1}), CutSurface::swept({{0.1, 0.2, 0}, {0.1, 0.3, 0}}, {0, 0, 0.1}),
        CutSurface::swept({{0.1, 0, 0.2}, {0.1, 0.1, 0.2}}, {0, 0, 0.1})}) {
    const CutMesh cut = cutMesh(mesh, surface, mesh.X, 0.1);
    EXPECT_EQ(cut.facesOpened, 0u);
    EXPECT_EQ(cut.elementsCut, 0u);
    EXPECT_EQ(cut.mesh.X, mesh.X);
    EXPECT_EQ(cut.mesh.blocks[0].connectivity, mesh.blocks[0].connectivity);
    EXPECT_EQ(std::count(cut.changed[0].begin(), cut.changed[0].end(), true), 0);
  }
}

TEST(Cut, ChangedElementsAreThoseAroundTheCut) {
  const Mesh mesh = box(0);
  const CutMesh cut = cutMesh(mesh, CutSurface::plane({0.05, 0, 0}, {1, 0, 0}), mesh.X, 0);
  // Cells are 1/30 long: those from 1/30 to 2/30 are cut, their neighbours share nodes with them.
  for (std::size_t e = 0; e < cut.mesh.elementCount(); ++e) {
    double low = 1, high = 0;
    for (int a = 0; a < 4; ++a) {
      const double at = cut.mesh.X(0, cut.mesh.blocks[0].element(e)[a]);
      low = std::min(low, at);
      high = std::max(high, at);
    }
    EXPECT_EQ(cut.changed[0][e], low < 2.01 / 30 && high > 0.99 / 30) << low << " " << high;
  }
}

TEST(Cut, FourCutsInARowAndSetsFollow) {
  Mesh mesh = box(0.2);
  const double volume = meshVolume(mesh);
  for (const double at : {0.05, 0.09, 0.13, 0.16}) {
    const CutMesh cut = cutMesh(mesh, CutSurface::plane({at, 0.05, 0.05}, {1, 0.4, -0.2}), mesh.X, 0.05);
    expectSound(cut, mesh);
    mesh = cut.mesh;
  }
  EXPECT_EQ(connectedParts(mesh).count, 5);
  EXPECT_NEAR(meshVolume(mesh), volume, 1e-12 * volume);
  std::size_t onFace = 0;
  for (Eigen::Index n = 0; n < mesh.X.cols(); ++n) onFace += mesh.X(1, n) == 0;
  EXPECT_EQ(mesh.nodeSets.at("y-min").size(), onFace);
}

TEST(Cut, RefusesBadSurfaces) {
  const auto message = [](const auto& call) {
    try {
      call();
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  const Mesh mesh = box(0);
  EXPECT_THAT(message([] { CutSurface::plane({0, 0, 0}, {0, 0, 0}); }), HasSubstr("must not be zero"));
  EXPECT_THAT(message([] { CutSurface::plane({0, 0, NAN}, {0, 0, 1}); }), HasSubstr("finite"));
  EXPECT_THAT(message([] { CutSurface::swept({{0, 0, 0}}, {0, 0, 1}); }), HasSubstr("two or more"));
  EXPECT_THAT(message([] { CutSurface::swept({{0, 0, 0}, {0, 0, 1}}, {0, 0, 1}); }), HasSubstr("coincide"));
  EXPECT_THAT(message([&] {
                cutMesh(mesh, CutSurface::plane({0, 0, 0}, {1, 0, 0}), mesh.X, 0.6);
              }),
              HasSubstr("<= 0.5"));
  BarOptions hexes;
  hexes.element = "hex8";
  const Mesh other = generateBar(hexes);
  EXPECT_THAT(message([&] { cutMesh(other, CutSurface::plane({0.5, 0, 0}, {1, 0, 0}), other.X); }), HasSubstr("hex8"));
}

}  // namespace
}  // namespace ringwatch
