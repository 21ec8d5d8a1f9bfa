#include <gmock/gmock.h>

#include <limits>
#include <random>

#include <ringwatch/base/error.h>
#include <ringwatch/meshes/adjacency.h>
#include <ringwatch/meshes/check.h>
#include <ringwatch/meshes/generators/generators.h>
#include <ringwatch/meshes/modify/bisection.h>
#include <ringwatch/meshes/quality.h>

#include "tests/meshes/mesh_test_tools.h"

namespace ringwatch {
namespace {

using ::testing::HasSubstr;

Mesh jitteredBar() {
  BarOptions o;
  o.size = {0.2, 0.1, 0.1};
  o.cells = {4, 2, 2};
  o.jitter = 0.2;
  return generateBar(o);
}

/// Every inner face has two elements and the boundary is that of the box: nothing hangs.
void expectConforming(const Mesh& mesh, const Mesh& before) {
  EXPECT_TRUE(checkMesh(mesh).empty());
  EXPECT_TRUE(faceNeighbours(mesh).overfull.empty());
  EXPECT_NEAR(meshVolume(mesh), meshVolume(before), 1e-13 * meshVolume(before));
  EXPECT_NEAR(test::boundaryArea(mesh), test::boundaryArea(before), 1e-13 * test::boundaryArea(before));
}

std::vector<EdgePoint> someEdges(const Mesh& mesh, double share, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  const CompressedRows<std::int32_t> neighbours = nodeNeighbours(mesh);
  std::vector<EdgePoint> edges;
  for (std::size_t n = 0; n < mesh.nodeCount(); ++n)
    for (const std::int32_t m : neighbours.row(n))
      if (static_cast<std::int32_t>(n) < m && unit(random) < share)
        edges.push_back({static_cast<std::int32_t>(n), m, 0.05 + 0.9 * unit(random)});
  return edges;
}

TEST(Bisection, AnySetOfEdgesGivesAConformingMesh) {
  const Mesh mesh = jitteredBar();
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    const auto edges = someEdges(mesh, std::array{0.02, 0.2, 0.6, 1.0}[seed % 4], seed);
    const BisectedMesh bisected = bisectEdges(mesh, edges);
    expectConforming(bisected.mesh, mesh);
    ASSERT_EQ(bisected.newNodes.size(), edges.size());
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const Eigen::Vector3d expected = (1 - edges[i].t) * mesh.X.col(edges[i].a) + edges[i].t * mesh.X.col(edges[i].b);
      // To a rounding: compilers may fuse the products here and not there.
      EXPECT_LE((bisected.mesh.X.col(mesh.nodeCount() + i) - expected).norm(),
                std::numeric_limits<double>::epsilon() * expected.norm());
    }
    std::vector<double> volumes(mesh.elementCount(), 0);
    const JacobianProbe probe(elementInfo(mesh.blocks[0].type));
    const MeshBlock& parts = bisected.mesh.blocks[0];
    for (std::size_t e = 0; e < parts.elementCount(); ++e) {
      const double volume = probe.volume(bisected.mesh.X, parts.element(e));
      EXPECT_GT(volume, 0);
      volumes[bisected.parent[0][e]] += volume;
    }
    for (std::size_t e = 0; e < volumes.size(); ++e)
      EXPECT_NEAR(volumes[e], probe.volume(mesh.X, mesh.blocks[0].element(e)), 1e-18);
  }
}

TEST(Bisection, SetsAndNumbersFollow) {
  Mesh mesh = jitteredBar();
  mesh.elementSets["one"] = {{0, 7}};
  const BisectedMesh bisected = bisectEdges(mesh, someEdges(mesh, 1, 1));
  for (const std::int32_t n : bisected.mesh.nodeSets.at("x-min")) EXPECT_EQ(bisected.mesh.X(0, n), 0);
  std::size_t onFace = 0;
  for (Eigen::Index n = 0; n < bisected.mesh.X.cols(); ++n) onFace += bisected.mesh.X(0, n) == 0;
  EXPECT_EQ(bisected.mesh.nodeSets.at("x-min").size(), onFace);
  for (const ElementRef& e : bisected.mesh.elementSets.at("one")) EXPECT_EQ(bisected.parent[0][e.element], 7);
  EXPECT_GT(bisected.mesh.elementSets.at("one").size(), 7u);
  EXPECT_EQ(bisected.mesh.elementSets.at("all").size(), bisected.mesh.elementCount());
  std::vector<std::int64_t> ids = bisected.mesh.blocks[0].ids;
  std::sort(ids.begin(), ids.end());
  EXPECT_EQ(std::adjacent_find(ids.begin(), ids.end()), ids.end());
}

TEST(Bisection, OfAMeshWithoutNumbersIsTheSame) {
  const Mesh mesh = jitteredBar();  // numbered 0, 1, …
  Mesh bare = mesh;
  bare.nodeIds.clear();
  for (MeshBlock& block : bare.blocks) block.ids.clear();
  const auto edges = someEdges(mesh, 0.3, 1);
  const Mesh with = bisectEdges(mesh, edges).mesh, without = bisectEdges(bare, edges).mesh;
  EXPECT_EQ(without.blocks[0].connectivity, with.blocks[0].connectivity);
  EXPECT_EQ(without.blocks[0].ids, with.blocks[0].ids);
  EXPECT_EQ(without.nodeIds, with.nodeIds);
}

TEST(Bisection, NothingToCutLeavesTheMesh) {
  const Mesh mesh = jitteredBar();
  const BisectedMesh same = bisectEdges(mesh, {});
  EXPECT_EQ(same.mesh.X, mesh.X);
  EXPECT_EQ(same.mesh.blocks[0].connectivity, mesh.blocks[0].connectivity);
  EXPECT_EQ(same.mesh.blocks[0].ids, mesh.blocks[0].ids);
}

TEST(Bisection, RefinementMeetsTheWantedLengthAndKeepsShapes) {
  const Mesh mesh = jitteredBar();
  const auto wanted = [](const Eigen::Vector3d& middle) { return 0.01 + 0.3 * middle.x(); };
  const Mesh fine = refineTetrahedra(mesh, wanted);
  expectConforming(fine, mesh);
  const MeshBlock& block = fine.blocks[0];
  double leastAngle = 180;
  for (std::size_t e = 0; e < block.elementCount(); ++e) {
    const ElementQuality q = elementQuality(block, e, fine.X);
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (int a = 0; a < 4; ++a) middle += fine.X.col(block.element(e)[a]) / 4;
    EXPECT_LE(q.maxEdge, wanted(middle));
    leastAngle = std::min(leastAngle, q.minDihedral);
  }
  double leastBefore = 180;
  for (std::size_t e = 0; e < mesh.blocks[0].elementCount(); ++e)
    leastBefore = std::min(leastBefore, elementQuality(mesh.blocks[0], e, mesh.X).minDihedral);
  EXPECT_GT(leastAngle, leastBefore / 3);
}

TEST(Bisection, RefusesWhatItCannotCut) {
  BarOptions hexes;
  hexes.element = "hex8";
  const auto message = [](const auto& call) {
    try {
      call();
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  EXPECT_THAT(message([&] { bisectEdges(generateBar(hexes), {}); }), HasSubstr("hex8"));
  EXPECT_THAT(message([&] { bisectEdges(jitteredBar(), {{0, 1, 0.0}}); }), HasSubstr("between 0 and 1"));
  EXPECT_THAT(message([&] { bisectEdges(jitteredBar(), {{0, 1000, 0.5}}); }), HasSubstr("edge 0 to 1000"));
  EXPECT_THAT(message([&] { bisectEdges(jitteredBar(), {{0, 1, 0.5}, {1, 0, 0.5}}); }), HasSubstr("twice"));
  EXPECT_THAT(message([&] { refineTetrahedra(jitteredBar(), [](const Eigen::Vector3d&) { return 0.0; }); }),
              HasSubstr("above 0"));
}

TEST(Bisection, RefinedBarIsLikeTheCubeOfFierz2013) {
  RefinedBarOptions o;
  o.coarse.size = {0.05, 0.05, 0.05};
  o.coarse.cells = {5, 5, 5};
  o.coarse.jitter = 0.25;
  o.finest = 0.005;
  o.growth = 0.5;
  const Mesh cube = generateRefinedBar(o);  // Fierz 2013's: 1428 nodes, 5889 tetrahedra
  EXPECT_NEAR(static_cast<double>(cube.nodeCount()), 1428, 0.05 * 1428);
  EXPECT_NEAR(static_cast<double>(cube.elementCount()), 5889, 0.03 * 5889);
  o.finest = 0;
  EXPECT_THROW(generateRefinedBar(o), InputError);
  o.finest = 0.005;
  o.growth = -1;
  EXPECT_THROW(generateRefinedBar(o), InputError);
}

}  // namespace
}  // namespace ringwatch
