#include <ringwatch/meshes/check.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <random>

#include <ringwatch/meshes/generators/generators.h>
#include <ringwatch/meshes/jacobian.h>
#include <ringwatch/meshes/mesh_io.h>
#include <ringwatch/meshes/quality.h>

#include "tests/meshes/mesh_test_tools.h"

namespace ringwatch {
namespace {

using namespace test;
using ::testing::HasSubstr;
using Kind = MeshProblem::Kind;

void expectOne(const Mesh& mesh, Kind kind, std::int64_t id) {
  const auto problems = checkMesh(mesh);
  ASSERT_EQ(problems.size(), 1u) << problems.back().text;
  EXPECT_EQ(problems[0].kind, kind) << problems[0].text;
  EXPECT_EQ(problems[0].id, id);
  EXPECT_THAT(problems[0].text, HasSubstr(std::to_string(id)));
  EXPECT_FALSE(problemName(kind).empty());
  if (kind == Kind::unusedNode) return;
  Mesh copy = mesh;
  const std::string text = errorOf([&] { requireSound(copy, "bad.msh"); });
  EXPECT_THAT(text, HasSubstr("bad.msh: 1 problem: "));
  EXPECT_THAT(text, HasSubstr(problems[0].text));
}

TEST(Check, ASoundMeshHasNoProblem) {
  EXPECT_TRUE(checkMesh(mixedMesh()).empty());
  Mesh mesh = mixedMesh();
  std::vector<std::string> notes;
  requireSound(mesh, "m", &notes);
  EXPECT_TRUE(notes.empty());
  expectSame(mesh, mixedMesh());
}

TEST(Check, EachSeededFaultIsFound) {
  const Mesh good = mixedMesh();
  Mesh mesh = good;  // both hexahedra share nodes 1, 4, 7, 10: only a corner of one is turned in
  mesh.X.col(0) << 1.3, 0.9, 0.9;
  expectOne(mesh, Kind::inverted, 11);

  mesh = good;
  mesh.X.col(12) << 2, 0.25, 0.5;  // in the plane of the other three
  expectOne(mesh, Kind::degenerate, 101);

  mesh = good;
  mesh.blocks[1].connectivity[7] = 99;
  ASSERT_EQ(checkMesh(mesh).size(), 2u);  // and node 13 is not used any more
  EXPECT_EQ(checkMesh(mesh)[0].kind, Kind::missingNode);
  mesh.blocks[1].connectivity[7] = -1;
  EXPECT_EQ(checkMesh(mesh)[0].kind, Kind::missingNode);

  mesh = good;
  mesh.blocks[1].connectivity[1] = mesh.blocks[1].connectivity[0];
  expectOne(mesh, Kind::repeatedNode, 101);

  mesh = good;
  mesh.X(2, 13) = NAN;
  expectOne(mesh, Kind::nonFinite, mesh.nodeIds[13]);

  mesh = good;
  mesh.X.conservativeResize(3, 15);
  mesh.X.col(14).setZero();
  mesh.nodeIds.push_back(500);
  expectOne(mesh, Kind::unusedNode, 500);

  mesh = good;
  for (const std::int32_t n : {5, 8, 2, 12}) mesh.blocks[1].connectivity.push_back(n);
  mesh.blocks[1].ids.push_back(300);
  expectOne(mesh, Kind::duplicateElement, 300);
}

TEST(Check, HexahedronTurnedInAtOneCornerWithPositiveVolumeIsInverted) {
  Mesh mesh = generateBar({.cells = {1, 1, 1}, .element = "hex8"});
  mesh.X.col(7) << 0.3, 0.3, 0.3;  // the corner goes through the diagonal plane of its neighbours
  EXPECT_GT(meshVolume(mesh), 0);
  expectOne(mesh, Kind::inverted, 0);
}

// The determinant may be positive at every corner and quadrature point of an element that passes through itself.
TEST(Check, ElementsFoldedInTheirMiddleAreFound) {
  const auto numbered = [](const char* element, double jitter, const std::vector<int>& order) {
    Mesh mesh = generateBar({.cells = {1, 1, 1}, .element = element, .jitter = jitter});
    MeshBlock& block = mesh.blocks[0];
    const std::vector<std::int32_t> before = block.connectivity;
    for (std::size_t a = 0; a < order.size(); ++a) block.connectivity[a] = before[static_cast<std::size_t>(order[a])];
    return mesh;
  };
  const std::vector<int> half{0, 1, 2, 3, 6, 7, 4, 5};
  // Half a turn on, the top of a hexahedron meets its bottom's mirror image.
  expectOne(numbered("hex8", 0, half), Kind::degenerate, 0);
  std::vector<int> ofQuadratic = half;
  for (const int middle : {8, 9, 10, 11, 14, 15, 12, 13}) ofQuadratic.push_back(middle);
  Mesh quadratic = numbered("hex20", 0, ofQuadratic);
  const ElementInfo& info = elementInfo(quadratic.blocks[0].type);
  for (std::size_t edge = 8; edge < info.edges.size(); ++edge) {  // upright ones, where they are now
    const std::int32_t* const nodes = quadratic.blocks[0].element(0);
    quadratic.X.col(nodes[8 + edge]) =
        (quadratic.X.col(nodes[info.edges[edge][0]]) + quadratic.X.col(nodes[info.edges[edge][1]])) / 2;
  }
  EXPECT_FALSE(checkMesh(quadratic).empty());
  // No exact half turn: the determinant changes its sign between the middle and the sides. The judge is the least one
  // on a fine grid.
  int folded = 0;
  for (std::uint32_t seed = 1; seed < 30; ++seed) {
    Mesh mesh = numbered("hex8", 0, half);
    std::mt19937 random(seed);
    for (double& x : mesh.X.reshaped()) x += std::uniform_real_distribution<double>(-0.02, 0.02)(random);
    const ElementInfo& hexahedron = elementInfo(mesh.blocks[0].type);
    double least = 1;
    constexpr int cells = 20;
    for (int i = 0; i <= cells; ++i)
      for (int j = 0; j <= cells; ++j)
        for (int k = 0; k <= cells; ++k) {
          const double xi[3] = {2. * i / cells - 1, 2. * j / cells - 1, 2. * k / cells - 1};
          double dN[8][3];
          hexahedron.shapeGradient(xi, dN);
          least = std::min(least, jacobianOf(mesh.X, mesh.blocks[0].element(0), 8, dN[0]).determinant());
        }
    if (least >= 0) continue;
    ++folded;
    EXPECT_FALSE(checkMesh(mesh).empty()) << seed << " " << least;
  }
  EXPECT_GT(folded, 20);
}

TEST(Check, WedgesAloneOfTheOtherHandednessAreTurnedRoundWithANote) {
  BarOptions options;
  options.cells = {5, 1, 1};
  const Mesh right = generateMixedBar(options);
  Mesh mesh = right;
  std::size_t block = 0;
  while (elementInfo(mesh.blocks[block].type).name != "wedge6") ++block;
  // The order in which VTK's book draws a wedge.
  for (std::size_t e = 0; e < mesh.blocks[block].elementCount(); ++e) {
    std::int32_t* nodes = mesh.blocks[block].connectivity.data() + 6 * e;
    std::swap(nodes[1], nodes[2]);
    std::swap(nodes[4], nodes[5]);
  }
  std::vector<std::string> notes;
  requireSound(mesh, "book.vtk", &notes);
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_THAT(notes[0], HasSubstr("wedge6 are of the other handedness and were turned round"));
  EXPECT_DOUBLE_EQ(meshVolume(mesh), meshVolume(right));
}

TEST(Check, ElementsOfTheOtherHandednessAmongOthersAreTurnedRoundWithTheirNumber) {
  for (const char* element : {"tet4", "tet10", "hex8", "hex20", "wedge6", "pyramid5"}) {
    const Mesh right = generateBar({.cells = {3, 3, 3}, .element = element});
    Mesh mesh = right;
    mesh.X.row(0) *= -1;
    std::vector<std::string> notes;
    requireSound(mesh, "m", &notes);  // all of them, so that mesh.blocks are those of the mirrored bar
    ASSERT_EQ(notes.size(), 1u) << element;
    EXPECT_THAT(notes[0], HasSubstr("elements are of the other handedness and were turned round"));
    mesh.X.row(0) *= -1;
    const auto width = static_cast<std::size_t>(mesh.blocks[0].nodesPerElement());
    Mesh some = right;
    std::copy_n(mesh.blocks[0].connectivity.begin(), 7 * width, some.blocks[0].connectivity.begin());
    ASSERT_EQ(checkMesh(some).size(), 7u) << element;
    notes.clear();
    requireSound(some, "m", &notes);
    ASSERT_EQ(notes.size(), 1u) << element;
    EXPECT_THAT(notes[0], HasSubstr("m: 7 of "));
    EXPECT_NEAR(meshVolume(some), meshVolume(right), 1e-14) << element;
  }
}

TEST(Check, AnElementThatIsFoldedOverIsAnErrorThatNamesCountAndSome) {
  Mesh mesh = generateBar({.cells = {2, 2, 2}});
  const std::int32_t middle = 13;
  mesh.X.col(middle) << 1.7, 1.8, 1.9;  // far outside: tetrahedra around it lie on each other
  const std::size_t negative = checkMesh(mesh).size();
  EXPECT_GT(negative, 3u);
  const std::string text = errorOf([&] { requireSound(mesh, "bad.msh"); });
  EXPECT_THAT(text, HasSubstr("bad.msh: "));
  EXPECT_THAT(text, HasSubstr(" problems: element "));
  EXPECT_THAT(text, HasSubstr("is inverted: it lies on the same side of a face as element "));
  EXPECT_THAT(text, HasSubstr("run `ringwatch mesh check --all bad.msh` for all of them"));
}

TEST(Check, QuadraticElementsInAnotherProgramsOrderAreToldSo) {
  for (const char* element : {"hex20", "tet10"}) {
    Mesh mesh = generateBar({.cells = {1, 1, 1}, .element = element});
    std::vector<std::int32_t>& nodes = mesh.blocks[0].connectivity;
    if (mesh.blocks[0].nodesPerElement() == 20)  // decks and VTK have the vertical edges last, .frd before the top
      std::rotate(nodes.begin() + 12, nodes.begin() + 16, nodes.begin() + 20);
    else  // gmsh and VTK have the last two the other way round
      std::swap(nodes[8], nodes[9]);
    const auto problems = checkMesh(mesh);
    ASSERT_EQ(problems.size(), 1u) << element;
    EXPECT_THAT(problems[0].text, HasSubstr("which `ringwatch mesh repair` puts right")) << element;
  }
  Mesh bent = generateBar({.cells = {1, 1, 1}, .element = "hex20"});
  bent.X.col(0) << 0.9, 0.9, 0.9;
  EXPECT_THAT(checkMesh(bent)[0].text, ::testing::Not(HasSubstr(" order")));
}

TEST(Check, PartsThatHangByAnEdgeOrANodeAreNoted) {
  const auto notesOfTwo = [](const Eigen::Vector3d& shift) {
    const Mesh one = generateBar({.size = {1, 1, 1}, .cells = {1, 1, 1}, .element = "hex8"});
    Mesh two = one;
    two.X.conservativeResize(3, 16);
    two.X.rightCols(8) = one.X.colwise() + shift;
    for (const std::int32_t local : one.blocks[0].connectivity) {
      std::int32_t node = 8 + local;
      for (std::int32_t k = 0; k < 8; ++k)
        if ((one.X.col(k) - two.X.col(8 + local)).norm() < 1e-12) node = k;
      two.blocks[0].connectivity.push_back(node);
    }
    two.blocks[0].ids = {0, 1};
    return meshNotes(two, "m");
  };
  EXPECT_TRUE(notesOfTwo({1, 0, 0}).empty());  // a face
  ASSERT_EQ(notesOfTwo({1, 1, 0}).size(), 1u);
  EXPECT_THAT(notesOfTwo({1, 1, 0})[0], HasSubstr("m: at 2 nodes, the first is node "));
  EXPECT_THAT(notesOfTwo({1, 1, 0})[0], HasSubstr("hang together by an edge or a node alone"));
  EXPECT_THAT(notesOfTwo({1, 1, 1}).at(0), HasSubstr("m: at 1 node, the first is node "));
}

TEST(Check, SliversAndScalesAreNotDegenerate) {
  for (const double scale : {1e-9, 1.0, 1e6}) {
    Mesh mesh = generateBar({.size = {scale, scale, 1e-7 * scale}, .cells = {1, 1, 1}});
    EXPECT_TRUE(checkMesh(mesh).empty()) << scale;
  }
}

TEST(Check, FilesAreListedWithLinesWhereTheParserKnowsThem) {
  const TemporaryFolder folder;
  writeBytes(folder / "m.msh",
             "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n6\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 nan 0 1\n6 0 0 "
             "0\n$EndNodes\n"
             "$Elements\n4\n1 4 0 1 2 3 4\n2 4 0 1 2 3 9\n3 4 0 1 2 3 5\n4 4 0 2 1 3 4\n$EndElements\n");
  const auto problems = checkMeshFile(folder / "m.msh");
  std::string all;
  for (const MeshProblem& p : problems) all += p.text + "\n";
  EXPECT_THAT(all, HasSubstr("m.msh:10: coordinate x of node 5 is nan"));
  EXPECT_THAT(all, HasSubstr("m.msh:16: element 2 (tet4) refers to node 9"));
  EXPECT_THAT(all, HasSubstr(") has the same nodes as element 1"));  // turned round, as inspect does
  EXPECT_THAT(all, HasSubstr("node 6 belongs to no element"));
  EXPECT_EQ(problems.size(), 4u) << all;
}

TEST(Check, NotesTellOfPartsAndOfNodesAtTheSamePlace) {
  for (const char* element : {"tet4", "hex8", "hex20"})
    EXPECT_TRUE(meshNotes(generateBar({.cells = {9, 4, 3}, .element = element, .jitter = 0.2}), "m").empty())
        << element;
  EXPECT_TRUE(meshNotes(mixedMesh(), "m").empty());
  // A bar and a copy of it beside, whose nodes meet at a face but are not shared.
  const Mesh one = generateBar({.size = {1, 1, 1}, .cells = {2, 1, 1}, .element = "hex8"});
  Mesh two = one;
  const Eigen::Index nodes = one.nodeCount();
  two.X.conservativeResize(3, 2 * nodes);
  two.X.rightCols(nodes) = one.X.colwise() + Eigen::Vector3d(1 + 1e-12, -1e-12, 0);
  for (std::int32_t n = 0; n < nodes; ++n) two.nodeIds.push_back(100 + n);
  for (const std::int32_t n : one.blocks[0].connectivity)
    two.blocks[0].connectivity.push_back(n + static_cast<std::int32_t>(nodes));
  two.blocks[0].ids = {0, 1, 2, 3};
  const std::vector<std::string> notes = meshNotes(two, "two.msh");
  ASSERT_EQ(notes.size(), 2u);
  EXPECT_THAT(notes[0], HasSubstr("two.msh: the mesh falls into 2 parts that share no node, of 2, 2 elements"));
  EXPECT_THAT(notes[1], HasSubstr("two.msh: 4 nodes lie where another node lies, e.g. nodes "));
  // What counts is the distance against the shortest edge, 0.5 m, and not the size of the mesh.
  for (const auto& [gap, told] :
       {std::pair{4e-7, "where another node lies"}, {4e-4, "to another, e.g. nodes 2 and 100"}, {6e-4, ""}})
    for (const double far : {10.0, 1e4}) {
      Mesh apart = two;
      apart.X.rightCols(nodes).row(0).array() += gap;
      const Eigen::Index own = apart.nodeCount();  // a third bar, far away
      apart.X.conservativeResize(3, own + nodes);
      apart.X.rightCols(nodes) = one.X.colwise() + Eigen::Vector3d(0, far, 0);
      for (std::int32_t n = 0; n < nodes; ++n) apart.nodeIds.push_back(200 + n);
      for (const std::int32_t n : one.blocks[0].connectivity)
        apart.blocks[0].connectivity.push_back(n + static_cast<std::int32_t>(own));
      apart.blocks[0].ids.insert(apart.blocks[0].ids.end(), {4, 5});
      const std::vector<std::string> ofGap = meshNotes(apart, "m");
      EXPECT_EQ(ofGap.size(), *told != 0 ? 2u : 1u) << gap << " " << far;
      EXPECT_THAT(ofGap.back(), HasSubstr(told));
    }
  // The same far from the origin and in other units.
  two.X = (1e-6 * two.X).colwise() + Eigen::Vector3d(0, 0.5, 0);
  EXPECT_EQ(meshNotes(two, "m").size(), 2u);
  two.X.rightCols(nodes).row(0).array() += 1e-8;  // a gap that is meant
  EXPECT_EQ(meshNotes(two, "m").size(), 1u);
  // Coordinates in single precision, far from the origin.
  two.X = (1e6 * (two.X.colwise() - Eigen::Vector3d(0, 0.5, 0))).colwise() + Eigen::Vector3d(0, 1e3, 0);
  two.X.rightCols(nodes).row(0).array() -= 1e-2;
  two.X.rightCols(nodes).row(1).array() += 6e-5;  // an edge of 1 m, whose place single precision has to 6e-5 m
  EXPECT_THAT(meshNotes(two, "m").back(), HasSubstr("4 nodes lie where another node lies"));
}

// Doubles are told by the edges at the nodes themselves: elements that are far smaller or larger elsewhere in the mesh
// neither hide them nor make them. The pairs are found again by comparing all of them.
TEST(Check, DoublesAreToldByTheEdgesAtTheNodes) {
  int compared = 0;
  for (const char* element : {"tet4", "hex8", "hex20"})
    for (const double gap : {0.9e-6, 1.1e-6, 0.9e-3, 1.1e-3})  // of the shortest edge
      for (const double size : {1.0, 1e-5})                    // m, of a pair of cubes that meet at a gap
        for (const double other : {1e-7, 1e-4, 1e3, 1e6}) {    // m, of a cube elsewhere
          const Mesh one = generateBar({.size = {1, 1, 1}, .cells = {2, 2, 2}, .element = element});
          const Eigen::Index nodes = one.nodeCount();
          double shortest = 0.5;  // m, of a cube of 1 m
          Mesh all = one;
          all.X.resize(3, 3 * nodes);
          all.X.leftCols(nodes) = size * one.X;
          all.X.middleCols(nodes, nodes) = size * (one.X.colwise() + Eigen::Vector3d(1 + gap * shortest, 0, 0));
          all.X.rightCols(nodes) = (other * one.X).colwise() + Eigen::Vector3d(0, 3, 0) * std::max(size, other);
          all.nodeIds.clear();
          for (Eigen::Index n = 0; n < 3 * nodes; ++n) all.nodeIds.push_back(1 + n);
          MeshBlock& block = all.blocks[0];
          for (const int copy : {1, 2})
            for (const std::int32_t n : one.blocks[0].connectivity)
              block.connectivity.push_back(n + copy * static_cast<std::int32_t>(nodes));
          block.ids.clear();
          for (std::size_t e = 0; e < block.elementCount(); ++e) block.ids.push_back(static_cast<std::int64_t>(e));
          std::int64_t pairs = 0;
          for (Eigen::Index a = 0; a < nodes; ++a)
            for (Eigen::Index b = nodes; b < 2 * nodes; ++b) {
              pairs += (all.X.col(a) - all.X.col(b)).norm() <= (gap < 1e-5 ? 1e-6 : 1e-3) * shortest * size ? 1 : 0;
            }
          std::string told;
          for (const std::string& note : meshNotes(all, "m"))
            if (note.find(" lie ") != std::string::npos) told = note;
          const std::string what = joinText(element, " ", gap, " ", size, " ", other);
          const bool rounding = gap < 1e-6;
          EXPECT_EQ(pairs > 0, rounding || gap == 0.9e-3) << what;
          if (pairs > 0)
            EXPECT_THAT(told, HasSubstr(joinText("m: ", pairs, " nodes lie ",
                                                 rounding ? "where another node lies" : "closer than a thousandth")))
                << what;
          else if (gap > 1e-3)
            EXPECT_EQ(told, "") << what;
          else
            EXPECT_THAT(told, HasSubstr("closer than a thousandth")) << what;
          ++compared;
        }
  EXPECT_EQ(compared, 96);
}

TEST(Check, AnEmptyMeshIsRefused) {
  Mesh mesh;
  EXPECT_THAT(errorOf([&] { requireSound(mesh, "none"); }), HasSubstr("no elements"));
}

}  // namespace
}  // namespace ringwatch
