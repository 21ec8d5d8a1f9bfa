// Faces by the numbers of decks, and sets of nodes that select them.
#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include <ringwatch/app/scene/deck_faces.h>
#include <ringwatch/app/scene/scene_pressure.h>
#include <ringwatch/body/body.h>
#include <tests/support/meshes.h>
#include <tests/support/random.h>

namespace ringwatch {
namespace {

using Nodes = std::set<std::int32_t>;

// User's manual of CalculiX: a hexahedron's face 1 is 1-2-3-4, 2 is 5-8-7-6, 3 is 1-5-6-2, 4 is 2-6-7-3, 5 is 3-7-8-4,
// 6 is 4-8-5-1; a tetrahedron's 1-2-3, 1-4-2, 2-4-3, 3-4-1; a wedge's 1-2-3, 4-5-6, 1-2-5-4, 2-3-6-5, 3-1-4-6.
TEST(DeckFaces, HaveCalculixNumbers) {
  const std::vector<std::pair<const char*, std::vector<Nodes>>> manual{
      {"hex8", {{1, 2, 3, 4}, {5, 8, 7, 6}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 8, 4}, {4, 8, 5, 1}}},
      {"tet4", {{1, 2, 3}, {1, 4, 2}, {2, 4, 3}, {3, 4, 1}}},
      {"wedge6", {{1, 2, 3}, {4, 5, 6}, {1, 2, 5, 4}, {2, 3, 6, 5}, {3, 1, 4, 6}}}};
  for (const auto& [element, faces] : manual) {
    Mesh mesh = test::gridMesh(element, {1, 1, 1}, {1, 1, 1}, 0);
    // One element: each of its faces is of the surface.
    const auto n = static_cast<std::size_t>(mesh.blocks[0].nodesPerElement());
    mesh.blocks[0].connectivity.resize(n);
    mesh.blocks[0].ids.clear();
    const DeckFaces all(mesh);
    for (std::size_t number = 1; number <= faces.size(); ++number) {
      const auto face = all.find({0, 0}, static_cast<int>(number));
      ASSERT_TRUE(face && *face >= 0) << element << ", " << number;
      const std::vector<std::string> sets = all.nodeSetsOf({*face});
      ASSERT_EQ(sets.size(), 1u);
      Scene::Pressure load{NodeSelection::parse("set:" + sets[0], "test"), 1, std::nullopt, "test"};
      const std::vector<PressedFace> pressed = pressedFaces(load, mesh);
      ASSERT_EQ(pressed.size(), 1u) << element << ", " << number;
      Nodes found;
      for (const std::int32_t node : pressed[0].nodes)
        found.insert(1 + static_cast<std::int32_t>(
                             std::find(mesh.blocks[0].connectivity.begin(), mesh.blocks[0].connectivity.end(), node) -
                             mesh.blocks[0].connectivity.begin()));
      EXPECT_EQ(found, faces[number - 1]) << element << ", " << number;
    }
    EXPECT_FALSE(all.find({0, 0}, static_cast<int>(faces.size()) + 1));
    EXPECT_FALSE(all.find({0, 0}, 0));
  }
}

TEST(DeckFaces, AreInsideWhereTwoElementsMeet) {
  const Mesh mesh = test::gridMesh("hex8", {2, 1, 1}, {2, 1, 1}, 0);
  const DeckFaces faces(mesh);
  int inside = 0;
  for (std::int32_t e = 0; e < 2; ++e)
    for (int number = 1; number <= 6; ++number) inside += *faces.find({0, e}, number) < 0 ? 1 : 0;
  EXPECT_EQ(inside, 2);
}

// Whatever faces are chosen: those that the sets select, by pressedFaces, are these, each once. A plate of one layer
// has all nodes of its sides in its two large faces.
TEST(DeckFaces, AreSelectedByTheirSetsAndNoOthersAre) {
  test::Random random(17);
  int several = 0;
  for (const char* element : {"hex8", "tet4", "wedge6"})
    for (const std::array<int, 3> cells : {std::array{2, 3, 2}, std::array{3, 3, 1}}) {
      const Mesh mesh = test::gridMesh(element, cells, {2, 3, 1}, 0);
      const DeckFaces all(mesh);
      const auto count = static_cast<std::int32_t>(boundaryFaces(mesh).size());
      const NodeVectors& X = mesh.X;
      const auto chosenWhere = [&](const auto& take) {
        std::vector<std::int32_t> chosen;
        for (std::int32_t face = 0; face < count; ++face)
          if (take(face)) chosen.push_back(face);
        return chosen;
      };
      std::vector<std::vector<std::int32_t>> cases;
      for (const double share : {0.02, 0.3, 0.7, 1.0})
        cases.push_back(chosenWhere([&](std::int32_t) { return random.uniform(0, 1) <= share; }));
      const auto corners = [&](std::int32_t face) {
        Nodes nodes;
        const ElementFace one = boundaryFaces(mesh)[static_cast<std::size_t>(face)];
        const MeshBlock& block = mesh.blocks[static_cast<std::size_t>(one.block)];
        for (const int corner : elementInfo(block.type).faces[static_cast<std::size_t>(one.face)])
          if (corner >= 0) nodes.insert(block.element(static_cast<std::size_t>(one.element))[corner]);
        return nodes;
      };
      cases.push_back(chosenWhere([&](std::int32_t face) {
        const Nodes nodes = corners(face);
        return std::ranges::all_of(nodes, [&](std::int32_t n) { return X(2, n) < 1e-9; }) ||
               std::ranges::all_of(nodes, [&](std::int32_t n) { return X(2, n) > X.row(2).maxCoeff() - 1e-9; });
      }));
      for (const std::vector<std::int32_t>& chosen : cases) {
        std::multiset<Nodes> wanted, found;
        for (const std::int32_t face : chosen) wanted.insert(corners(face));
        const std::vector<std::string> sets = all.nodeSetsOf(chosen);
        several += sets.size() > 1 ? 1 : 0;
        for (const std::string& set : sets) {
          Scene::Pressure load{NodeSelection::parse("set:" + set, "test"), 1, std::nullopt, "test"};
          for (const PressedFace& face : pressedFaces(load, mesh)) found.insert({face.nodes.begin(), face.nodes.end()});
        }
        EXPECT_EQ(found, wanted) << element << ", " << chosen.size() << " faces in " << sets.size() << " sets";
      }
    }
  EXPECT_GT(several, 0);
}

}  // namespace
}  // namespace ringwatch
