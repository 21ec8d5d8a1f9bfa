#include <ringwatch/meshes/adjacency.h>

#include <ringwatch/meshes/generators/generators.h>

#include "tests/meshes/mesh_test_tools.h"

namespace ringwatch {
namespace {

TEST(Adjacency, NodeElementsListEveryUseOnce) {
  const Mesh mesh = test::mixedMesh();
  const auto rows = nodeElements(mesh);
  ASSERT_EQ(rows.rowCount(), mesh.nodeCount());
  EXPECT_EQ(rows.values.size(), 2u * 8u + 2u * 4u);
  const std::vector<ElementNode> five(rows.row(5).begin(), rows.row(5).end());
  EXPECT_EQ(five, (std::vector<ElementNode>{{0, 1, 2}, {1, 0, 1}, {1, 1, 0}}));
}

TEST(Adjacency, NodeNeighboursAreSymmetricAndSorted) {
  const Mesh mesh = generateBar({.cells = {3, 2, 2}, .split = 5});
  const auto rows = nodeNeighbours(mesh);
  for (std::size_t n = 0; n < rows.rowCount(); ++n) {
    EXPECT_TRUE(std::is_sorted(rows.row(n).begin(), rows.row(n).end()));
    for (const std::int32_t m : rows.row(n)) {
      EXPECT_NE(m, n);
      const auto back = rows.row(m);
      EXPECT_TRUE(std::binary_search(back.begin(), back.end(), n));
    }
  }
  EXPECT_EQ(nodeNeighbours(generateBar({.cells = {2, 2, 2}, .element = "hex8"})).row(13).size(), 26u);
}

TEST(Adjacency, FaceNeighboursPointBack) {
  for (const char* element : {"tet4", "hex8"}) {
    const Mesh mesh = generateBar({.cells = {3, 2, 2}, .element = element});
    const FaceNeighbours faces = faceNeighbours(mesh);
    ASSERT_EQ(faces.rows.rowCount(), mesh.elementCount());
    EXPECT_TRUE(faces.overfull.empty());
    std::size_t open = 0;
    for (std::size_t e = 0; e < faces.rows.rowCount(); ++e)
      for (std::size_t f = 0; f < faces.rows.row(e).size(); ++f) {
        const ElementFace other = faces.rows.row(e)[f];
        if (other.element < 0) {
          ++open;
          continue;
        }
        const ElementFace back = faces.rows.row(other.element)[other.face];
        EXPECT_EQ(back, (ElementFace{0, static_cast<std::int32_t>(e), static_cast<std::int32_t>(f)}));
      }
    EXPECT_EQ(open, boundaryFaces(mesh).size());
    EXPECT_EQ(open, (3u * 2u + 3u * 2u + 2u * 2u) * 2u * (std::string(element) == "tet4" ? 2u : 1u));
  }
}

TEST(Adjacency, FacesOfThreeElementsAreNamed) {
  Mesh mesh = test::mixedMesh();
  // Two more tetrahedra on the face of the first one.
  for (const std::int32_t n : {2, 5, 8, 13, 2, 5, 8, 0}) mesh.blocks[1].connectivity.push_back(n);
  EXPECT_EQ(faceNeighbours(mesh).overfull.size(), 3u);
}

TEST(Adjacency, PartsAreCountedThroughSharedNodes) {
  Mesh mesh = generateBar({.cells = {2, 1, 1}, .element = "hex8"});
  EXPECT_EQ(connectedParts(mesh).count, 1);
  // A second bar beside the first, and a node of no element.
  const std::int32_t n = mesh.nodeCount();
  NodeVectors X(3, 2 * n + 1);
  X << mesh.X, mesh.X, Eigen::Vector3d::Zero();
  mesh.X = X;
  const std::vector<std::int32_t> first = mesh.blocks[0].connectivity;
  for (const std::int32_t node : first) mesh.blocks[0].connectivity.push_back(node + n);
  const MeshParts parts = connectedParts(mesh);
  EXPECT_EQ(parts.count, 2);
  EXPECT_EQ(parts.partOfElement, (std::vector<std::int32_t>{0, 0, 1, 1}));
  EXPECT_EQ(parts.partOfNode.front(), 0);
  EXPECT_EQ(parts.partOfNode[n], 1);
  EXPECT_EQ(parts.partOfNode.back(), -1);
}

}  // namespace
}  // namespace ringwatch
