// Bad meshes through other programs, in short; and the surfaces that they get.
#include <gtest/gtest.h>

#include <map>
#include <set>

#include <ringwatch/base/error.h>
#include <ringwatch/meshes/generators/generators.h>
#include <ringwatch/meshes/quality.h>
#include <ringwatch/verify/remeshing/mesh_programs.h>
#include <ringwatch/verify/remeshing/remeshing.h>
#include <ringwatch/verify/remeshing/surfaces.h>

#include "report_tools.h"

namespace ringwatch {
namespace {

using namespace detail;

/// Every edge has two triangles, in opposite directions, and Euler's number is that of a sphere.
void expectClosed(const TriangleSurface& surface) {
  std::set<std::pair<std::int32_t, std::int32_t>> edges;
  for (const auto& t : surface.triangles)
    for (int k = 0; k < 3; ++k) EXPECT_TRUE(edges.emplace(t[k], t[(k + 1) % 3]).second) << "two triangles turn alike";
  for (const auto& [a, b] : edges) EXPECT_TRUE(edges.contains({b, a})) << "an open edge";
  EXPECT_EQ(surface.X.cols() - static_cast<Eigen::Index>(edges.size() / 2) +
                static_cast<Eigen::Index>(surface.triangles.size()),
            2);
}

TEST(RemeshingSurfaces, AreClosedAndBadlyShapedByTheirSeedAlone) {
  for (const auto& make : {bumpyBall, jack}) {
    const TriangleSurface surface = make(3, 150, 1);
    expectClosed(surface);
    EXPECT_EQ(surface.X.cols(), 150);
    EXPECT_GT(enclosedVolume(surface), 0);
    EXPECT_LT(leastAngle(surface), 12);
    EXPECT_GT(leastAngle(surface), 1);
    EXPECT_EQ(make(3, 150, 1).X, surface.X);
    EXPECT_NE(make(3, 150, 2).X, surface.X);
  }
  // The whole icosphere, as a ball: the volume tends to that of the body.
  const double whole = enclosedVolume(bumpyBall(5, 1 << 20, 1)), coarse = enclosedVolume(bumpyBall(3, 1 << 20, 1));
  EXPECT_NEAR(coarse / whole, 1, 0.03);
}

TEST(RemeshingSurfaces, OfAMeshAreItsBoundaryOutwards) {
  BarOptions options;
  options.size = {2, 3, 4};
  options.cells = {2, 2, 3};
  const Mesh mesh = generateBar(options);
  std::vector<std::int32_t> nodes;
  const TriangleSurface surface = boundarySurface(mesh, &nodes);
  expectClosed(surface);
  EXPECT_NEAR(enclosedVolume(surface), 24, 24 * 1e-14);
  ASSERT_EQ(nodes.size(), static_cast<std::size_t>(surface.X.cols()));
  for (std::size_t n = 0; n < nodes.size(); ++n)
    EXPECT_EQ(surface.X.col(static_cast<Eigen::Index>(n)), mesh.X.col(nodes[n]));
  options.element = "hex8";
  EXPECT_THROW(boundarySurface(generateBar(options)), InputError);
}

TEST(RemeshingStudy, HoldsMeshesAndRunsToTheirCriteria) {
  const StudyReport report = verifyRemeshing(StudyEffort::quick);
  const TriangleSurface ball = bumpyBall(2, 60, 1);
  for (const ProgramMesh& made : {meshByTetgen(ball, "-pq"), meshByGmsh(ball, GmshOptimizer::own)})
    if (!made.mesh) {
      // Whatever is missing is told, by name.
      EXPECT_GE(test::tableOf(report, "skipped").rows.size(), 2U);
      GTEST_SKIP() << made.note << " (scripts/setup --remeshing)";
    }
  test::expectHolds(report);
  // Each mesher that is there meshes each body.
  std::map<std::string, std::set<std::string>> meshers;
  for (const auto& row : test::tableOf(report, "meshes").rows)
    meshers[std::get<std::string>(row[0])].insert(std::get<std::string>(row[1]));
  ASSERT_EQ(meshers.size(), 2U);
  for (const auto& [body, names] : meshers)
    for (const char* name : {"tetgen -p", "tetgen -pq", "tetgen -pqa", "gmsh", "gmsh -optimize"})
      EXPECT_TRUE(names.contains(name)) << body << ", " << name;
  EXPECT_EQ(test::textsOf(test::tableOf(report, "cut_steps"), 0).size(), 6U);  // ours and Fierz 2013's
}

}  // namespace
}  // namespace ringwatch
