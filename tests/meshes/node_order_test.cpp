#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include <ringwatch/meshes/generators/generators.h>
#include <ringwatch/meshes/node_order.h>

namespace ringwatch {
namespace {

TEST(NodeOrder, TheCurveGoesThroughTheOctantsInOrder) {
  const double low = 0.2, high = 0.7;
  std::uint64_t before = 0;
  for (int octant = 0; octant < 8; ++octant) {
    const auto pick = [&](int axis) { return (octant >> axis & 1) != 0 ? high : low; };
    const std::uint64_t key = mortonKey({pick(0), pick(1), pick(2)});
    EXPECT_TRUE(octant == 0 || key > before) << octant;
    before = key;
  }
  EXPECT_EQ(mortonKey({-1, 0.5, 2}), mortonKey({0, 0.5, 1})) << "outside counts as the nearest point";
}

Mesh scatteredBar() {
  BarOptions options;
  options.cells = {24, 10, 10};
  options.size = {2.4, 1, 1};
  options.jitter = 0.2;
  Mesh mesh = generateBar(options);
  // Numbers far apart: node i goes to 1009 i modulo their count, which shares no factor with it.
  const std::size_t count = mesh.nodeCount();
  std::vector<std::int32_t> place(count);
  for (std::size_t i = 0; i < count; ++i) place[i] = static_cast<std::int32_t>(1009 * i % count);
  Mesh result = mesh;
  for (std::size_t i = 0; i < count; ++i) {
    result.X.col(place[i]) = mesh.X.col(i);
    result.nodeIds[place[i]] = 100 + static_cast<std::int64_t>(i);
  }
  for (MeshBlock& block : result.blocks)
    for (std::int32_t& node : block.connectivity) node = place[node];
  for (auto& [name, nodes] : result.nodeSets)
    for (std::int32_t& node : nodes) node = place[node];
  return result;
}

/// Mean distance of an element's first and last node in memory.
double spread(const Mesh& mesh) {
  double sum = 0;
  for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
    const auto [least, most] = std::minmax_element(mesh.blocks[0].element(e), mesh.blocks[0].element(e) + 4);
    sum += *most - *least;
  }
  return sum / static_cast<double>(mesh.elementCount());
}

TEST(NodeOrder, RenumberingKeepsTheMeshAndItsNumbers) {
  const Mesh before = scatteredBar();
  Mesh after = before;
  renumberNodes(after);
  ASSERT_EQ(after.nodeCount(), before.nodeCount());
  std::map<std::int64_t, Eigen::Vector3d> placeOf;
  for (std::size_t i = 0; i < before.nodeCount(); ++i) placeOf[before.nodeIds[i]] = before.X.col(i);
  ASSERT_EQ(placeOf.size(), before.nodeCount());
  for (std::size_t i = 0; i < after.nodeCount(); ++i) EXPECT_EQ(after.X.col(i), placeOf.at(after.nodeIds[i]));

  const auto idsOf = [](const Mesh& mesh, const std::vector<std::int32_t>& nodes) {
    std::vector<std::int64_t> ids;
    for (const std::int32_t node : nodes) ids.push_back(mesh.nodeIds[node]);
    return ids;
  };
  EXPECT_EQ(idsOf(after, after.blocks[0].connectivity), idsOf(before, before.blocks[0].connectivity));
  EXPECT_EQ(after.blocks[0].ids, before.blocks[0].ids);
  ASSERT_EQ(after.nodeSets.size(), before.nodeSets.size());
  for (const auto& [name, nodes] : after.nodeSets) {
    EXPECT_TRUE(std::is_sorted(nodes.begin(), nodes.end())) << name;
    auto now = idsOf(after, nodes), then = idsOf(before, before.nodeSets.at(name));
    std::sort(now.begin(), now.end());
    std::sort(then.begin(), then.end());
    EXPECT_EQ(now, then) << name;
  }
}

TEST(NodeOrder, RenumberingAMeshWithoutNumbersKeepsItsPositions) {
  Mesh mesh = scatteredBar();
  mesh.nodeIds.clear();
  const NodeVectors before = mesh.X;
  renumberNodes(mesh);
  for (std::int32_t i = 0; i < mesh.X.cols(); ++i) EXPECT_EQ(mesh.X.col(i), before.col(mesh.nodeId(i)));
}

TEST(NodeOrder, RenumberingBringsTheNodesOfAnElementTogether) {
  const Mesh before = scatteredBar();
  Mesh after = before;
  renumberNodes(after);
  EXPECT_LT(spread(after), 0.2 * spread(before));
  Mesh again = after;
  renumberNodes(again);
  EXPECT_TRUE(again.X == after.X) << "a second time changes nothing";
}

}  // namespace
}  // namespace ringwatch
