#include <ringwatch/meshes/modify/repair.h>

#include <gmock/gmock.h>

#include <algorithm>

#include <ringwatch/base/infinity.h>
#include <ringwatch/meshes/generators/generators.h>
#include <ringwatch/meshes/quality.h>

#include "tests/meshes/mesh_test_tools.h"

namespace ringwatch {
namespace {

using namespace test;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(Repair, AGoodMeshStaysWhatItIs) {
  const RepairedMesh same = repairMesh(mixedMesh(), "m");
  EXPECT_TRUE(same.done.empty() && same.problems.empty());
  expectSame(same.mesh, mixedMesh());
}

TEST(Repair, AnElementThatStandsTwiceIsInTheSetsOfBoth) {
  Mesh mesh = mixedMesh();
  for (const std::int32_t n : {5, 8, 2, 12}) mesh.blocks[1].connectivity.push_back(n);  // turned and mirrored
  mesh.blocks[1].ids.push_back(300);
  mesh.elementSets["second"] = {{1, 2}};
  const RepairedMesh repaired = repairMesh(mesh, "m");
  EXPECT_THAT(repaired.done, ElementsAre(HasSubstr("m: 1 element that stands a second time")));
  Mesh expected = mixedMesh();
  expected.elementSets["second"] = {{1, 0}};
  expectSame(repaired.mesh, expected);
}

TEST(Repair, NodesAtOnePlaceAreJoinedOnlyWhereThatIsAskedFor) {
  const Mesh one = generateBar({.size = {1, 1, 1}, .cells = {2, 1, 1}, .element = "hex8"});
  Mesh two = one;
  const auto nodes = static_cast<std::int32_t>(one.nodeCount());
  constexpr double gap = 1e-3;  // m, of edges of 0.5 m and 1 m
  two.X.conservativeResize(3, 2 * nodes);
  two.X.rightCols(nodes) = one.X.colwise() + Eigen::Vector3d(1 + gap, 0, 0);
  for (const std::int32_t n : one.blocks[0].connectivity) two.blocks[0].connectivity.push_back(n + nodes);
  two.nodeIds.resize(2 * static_cast<std::size_t>(nodes));
  for (std::int32_t n = 0; n < nodes; ++n) two.nodeIds[nodes + n] = 100 + n;
  two.blocks[0].ids = {0, 1, 2, 3};
  two.nodeSets = {{"face", {nodes}}};
  const std::int32_t corner = nodes;  // of the second bar, at x = 1
  ASSERT_EQ(two.X(0, corner), 1 + gap);
  EXPECT_EQ(repairMesh(two, "m").mesh.nodeCount(), 2 * one.nodeCount());
  EXPECT_TRUE(repairMesh(two, "m", 0).done.empty());  // twice a thousandth of the shortest edge
  const RepairedMesh joined = repairMesh(two, "m", 2 * gap);
  EXPECT_THAT(joined.done, ElementsAre(HasSubstr("m: 4 nodes were joined with another at the same place")));
  EXPECT_TRUE(joined.problems.empty());
  EXPECT_EQ(joined.mesh.nodeCount(), 2 * one.nodeCount() - 4);
  EXPECT_NEAR(boundaryArea(joined.mesh), 10, 10 * gap);  // a bar of 2 m whose halves have no faces between them
  ASSERT_EQ(joined.mesh.nodeSets.at("face").size(), 1u);
  EXPECT_EQ(joined.mesh.X(0, joined.mesh.nodeSets.at("face")[0]), 1);  // the node that is left
  EXPECT_TRUE(meshNotes(joined.mesh, "m").empty());
}

// Beside a layer that is thinner than the distance of doubles a node is joined with the nearest one, not with the
// first.
TEST(Repair, BlocksBesideAThinLayerKeepTheirShape) {
  for (const double thickness : {1e-2, 1e-3, 1e-5, 1e-7}) {
    Mesh all;
    all.X.resize(3, 24);
    all.blocks = {{findElementByName("hex8")->type, {}, {}}};
    const double from[] = {0, 1, 1 + thickness}, size[] = {1, thickness, 1};
    for (int block = 0; block < 3; ++block) {
      const Mesh one = generateBar({.size = {size[block], 1, 1}, .cells = {1, 1, 1}, .element = "hex8"});
      all.X.middleCols(8 * block, 8) = one.X;
      // The same numbers on both sides of an interface.
      for (Eigen::Index n = 8 * block; n < 8 * block + 8; ++n)
        all.X(0, n) = all.X(0, n) > 0 ? (block < 2 ? from[block + 1] : 2 + thickness) : from[block];
      for (const std::int32_t n : one.blocks[0].connectivity) all.blocks[0].connectivity.push_back(n + 8 * block);
    }
    const RepairedMesh joined = repairMesh(all, "m", 0.0);
    EXPECT_EQ(joined.mesh.nodeCount(), 16u) << thickness;
    const Mesh& mesh = joined.mesh;
    ASSERT_EQ(mesh.elementCount(), 3u) << thickness;
    for (int block = 0; block < 3; ++block) {
      double low = infinity, high = -infinity;
      for (int a = 0; a < 8; ++a) {
        low = std::min(low, mesh.X(0, mesh.blocks[0].element(block)[a]));
        high = std::max(high, mesh.X(0, mesh.blocks[0].element(block)[a]));
      }
      EXPECT_EQ(low, from[block]) << thickness;
      EXPECT_EQ(high, block < 2 ? from[block + 1] : 2 + thickness) << thickness;
    }
  }
}

TEST(Repair, ElementsThatHaveNoInsideAreLeftOut) {
  // A layer without thickness between two cubes, as for a joint: its nodes are at two times the same places.
  const Mesh one = generateBar({.size = {1, 1, 1}, .cells = {1, 1, 1}, .element = "hex8"});
  for (const bool wedges : {false, true}) {
    Mesh mesh = one;
    const std::int32_t* const hex = one.blocks[0].connectivity.data();
    std::vector<std::int32_t> top;  // copies of the nodes 4 to 7 of the hexahedron
    mesh.X.conservativeResize(3, 12);
    for (std::int32_t k = 0; k < 4; ++k) {
      mesh.X.col(8 + k) = one.X.col(hex[4 + k]);
      top.push_back(8 + k);
    }
    mesh.nodeIds.clear();
    std::vector<std::int32_t> bottom(hex + 4, hex + 8);
    if (wedges)
      mesh.blocks.push_back({elementTypeOf<Wedge6>,
                             {bottom[0], bottom[1], bottom[2], top[0], top[1], top[2],  //
                              bottom[0], bottom[2], bottom[3], top[0], top[2], top[3]},
                             {}});
    else
      for (const auto* side : {&bottom, &top})
        mesh.blocks[0].connectivity.insert(mesh.blocks[0].connectivity.end(), side->begin(), side->end());
    mesh.blocks[0].ids.clear();
    mesh.elementSets.clear();
    const RepairedMesh repaired = repairMesh(mesh, "m", 0);
    ASSERT_EQ(repaired.done.size(), 2u) << repaired.done.back();
    EXPECT_THAT(repaired.done[1], HasSubstr(wedges ? "2 elements without an inside" : "1 element without an inside"));
    EXPECT_EQ(repaired.mesh.elementCount(), 1u);
    EXPECT_EQ(repaired.mesh.nodeCount(), 8u);
    EXPECT_DOUBLE_EQ(meshVolume(repaired.mesh), 1);
  }
}

TEST(Repair, TheProgramWhoseOrderItIsIsNamed) {
  for (const auto& [element, program] : {std::pair{"hex20", "Exodus' and Nastran's order"},
                                         {"hex20", "gmsh's order"},
                                         {"tet10", "gmsh's order"},
                                         {"hex20", "another program's order"}}) {
    SCOPED_TRACE(program);
    const Mesh right = generateBar({.cells = {2, 1, 1}, .element = element, .jitter = 0.1});
    Mesh mesh = right;
    const ElementInfo& info = elementInfo(mesh.blocks[0].type);
    for (std::size_t e = 0; e < mesh.blocks[0].elementCount(); ++e) {
      std::int32_t* const nodes = mesh.blocks[0].connectivity.data() + e * static_cast<std::size_t>(info.nodes);
      const std::vector<std::int32_t> before(nodes, nodes + info.nodes);
      for (int a = cornerCount(info); a < info.nodes; ++a)
        if (std::string_view(program).starts_with("gmsh"))
          nodes[info.gmshOrder[a]] = before[a];
        else if (std::string_view(program).starts_with("Exodus"))
          nodes[a < 12 ? a : a < 16 ? a + 4 : a - 4] = before[a];
        else
          nodes[a == 19 ? 8 : a + 1] = before[a];
    }
    EXPECT_FALSE(checkMesh(mesh).empty());
    EXPECT_THAT(checkMesh(mesh)[0].text, HasSubstr(program));
    const RepairedMesh repaired = repairMesh(mesh, "m");
    EXPECT_THAT(repaired.done, ElementsAre(HasSubstr(program)));
    EXPECT_TRUE(repaired.problems.empty());
    expectSame(repaired.mesh, right);
  }
}

TEST(Repair, EveryOtherOrderOfTheNodesOnEdgesIsTold) {
  const Mesh right = generateBar({.cells = {1, 1, 1}, .element = "tet10", .jitter = 0.1});
  for (int i = 4; i < 10; ++i)
    for (int k = 4; k < i; ++k) {
      Mesh mesh = right;
      for (std::size_t e = 0; e < mesh.blocks[0].elementCount(); ++e)
        std::swap(mesh.blocks[0].connectivity[10 * e + i], mesh.blocks[0].connectivity[10 * e + k]);
      const std::vector<MeshProblem> problems = checkMesh(mesh);
      ASSERT_EQ(problems.size(), mesh.elementCount()) << i << " " << k;
      EXPECT_THAT(problems[0].text, HasSubstr(i == 9 && k == 8 ? "gmsh's order" : "another program's order"));
      expectSame(repairMesh(mesh, "m").mesh, right);
    }
}

TEST(Repair, NodesInRowsAreTold) {
  for (const char* element : {"hex8", "pyramid5"}) {
    const Mesh right = generateBar({.cells = {2, 2, 1}, .element = element, .jitter = 0.1});
    Mesh mesh = right;
    MeshBlock& block = mesh.blocks[0];
    const auto width = static_cast<std::size_t>(block.nodesPerElement());
    for (std::size_t e = 0; e < block.elementCount(); e += 2)  // some of them
      for (std::size_t a = 2; a + 1 < width; a += 4)
        std::swap(block.connectivity[e * width + a], block.connectivity[e * width + a + 1]);
    ASSERT_FALSE(checkMesh(mesh).empty());
    EXPECT_THAT(checkMesh(mesh)[0].text, HasSubstr("its nodes go in rows, as those of VTK's voxels"));
    const RepairedMesh repaired = repairMesh(mesh, "m");
    EXPECT_THAT(repaired.done, ElementsAre(HasSubstr("have their nodes in rows, as VTK's voxels")));
    expectSame(repaired.mesh, right);
  }
}

TEST(Repair, NodesOfASoundElementAreNotJoined) {
  // A layer of 1e-4 on a bar of 1: a distance above that would take it out.
  const Mesh mesh = [] {
    Mesh bar = generateBar({.size = {3, 1, 1}, .cells = {3, 1, 1}, .element = "hex8"});
    for (Eigen::Index n = 0; n < bar.X.cols(); ++n)
      if (bar.X(0, n) == 1) bar.X(0, n) = 2 - 1e-4;
    return bar;
  }();
  EXPECT_TRUE(repairMesh(mesh, "m", 0.9e-4).done.empty());
  EXPECT_THAT(errorOf([&] { repairMesh(mesh, "m", 1.1e-4); }),
              testing::AllOf(HasSubstr("m: --join 0.00011 would join nodes "), HasSubstr("whose shape is sound")));
}

TEST(Repair, SetsOfWhichNothingIsLeftAreNamed) {
  Mesh mesh = mixedMesh();
  const auto far = static_cast<Eigen::Index>(mesh.nodeCount());
  mesh.X.conservativeResize(3, far + 1);
  mesh.X.col(far) << 9, 9, 9;
  mesh.nodeIds.push_back(9000);
  mesh.nodeSets["apart"] = {static_cast<std::int32_t>(far)};
  const std::vector<std::string> done = repairMesh(mesh, "m").done;
  EXPECT_THAT(done, testing::Contains(HasSubstr("the node set \"apart\" has no node left")));
}

TEST(Repair, WhatIsLeftIsListed) {
  Mesh mesh = generateBar({.cells = {2, 2, 2}});
  mesh.X.col(13) << 1.7, 1.8, 1.9;  // tetrahedra around the middle lie on each other
  EXPECT_GT(repairMesh(mesh, "m").problems.size(), 3u);
  EXPECT_THAT(errorOf([&] { repairMesh(mesh, "m", 100); }),
              HasSubstr("whose shape is sound; a smaller distance is needed"));
}

}  // namespace
}  // namespace ringwatch
