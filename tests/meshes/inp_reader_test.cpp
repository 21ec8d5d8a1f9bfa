// Abaqus and CalculiX decks: nodes, elements, sets; the rest skipped with a note; errors with file and line.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include <ringwatch/base/error.h>
#include <ringwatch/meshes/mesh_io.h>
#include <ringwatch/meshes/quality.h>

namespace ringwatch {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class InpTest : public ::testing::Test {
 public:
  std::filesystem::path path =
      std::filesystem::path(::testing::TempDir()) /
      (std::string("deck-") + ::testing::UnitTest::GetInstance()->current_test_info()->name() + ".inp");
  std::vector<std::string> notes;
  Mesh read(const std::string& deck) {
    std::ofstream(path) << deck;
    return loadMesh(path, &notes);
  }
  std::string error(const std::string& deck) {
    try {
      read(deck);
    } catch (const InputError& e) {
      return e.what();
    }
    return "no error";
  }
  void TearDown() override { std::filesystem::remove(path); }

  // A cube of hexahedron and, beside it, two wedges; x up to 2.
  static constexpr const char* nodes = R"(** a comment
*Heading
 anything, at all *here
*Node, nset=ALLNODES
1, 0., 0., 0.
2, 1., 0., 0.
3, 1.0D0, 1., 0.
4, 0., +1., 0.
5,,,1.
6, 1., 0., 1.

7, 1., 1., 1.
8, 0., 1., 1.
9, 2., 0., 0.
10, 2., 1., 0.
11, 2., 0., 1.
12, 2., 1., 1.
)";
  static constexpr const char* elements = R"(*ELEMENT, TYPE=C3D8R, ELSET=Bricks
10, 1, 2, 3, 4,
 5, 6, 7, 8
*element, type=c3d6,
 elset=prisms
20, 2, 9, 3, 6, 11, 7
21, 9, 10, 3, 11, 12, 7
*ELEMENT, TYPE=S4, ELSET=skin
30, 1, 4, 8, 5
*ELEMENT, TYPE=SPRINGA, ELSET=springs
40, 1, 2
)";
  std::string deck(const std::string& rest = "") const { return std::string(nodes) + elements + rest; }
};

TEST_F(InpTest, ReadsNodesAndElements) {
  const Mesh mesh = read(deck());
  EXPECT_EQ(mesh.nodeCount(), 12u);
  EXPECT_EQ(mesh.X.col(2), Eigen::Vector3d(1, 1, 0));
  EXPECT_EQ(mesh.X.col(4), Eigen::Vector3d(0, 0, 1));
  ASSERT_EQ(mesh.blocks.size(), 2u);
  EXPECT_EQ(elementInfo(mesh.blocks[0].type).name, "hex8");
  EXPECT_EQ(elementInfo(mesh.blocks[1].type).name, "wedge6");
  EXPECT_THAT(mesh.blocks[0].ids, ElementsAre(10));
  EXPECT_THAT(mesh.blocks[1].ids, ElementsAre(20, 21));
  EXPECT_NEAR(meshVolume(mesh), 2, 1e-14);
}

TEST_F(InpTest, ReadsSets) {
  const Mesh mesh = read(deck(R"(*NSET, NSET=left, GENERATE
1, 4, 3
5, 8, 3
*NSET, NSET="tip"
9, 10, left,
*ELSET, ELSET=both
prisms, 10
*ELSET, ELSET=gaps, GENERATE
1, 100
)"));
  EXPECT_EQ(mesh.nodeSets.at("ALLNODES").size(), 12u);
  EXPECT_THAT(mesh.nodeSets.at("left"), ElementsAre(0, 3, 4, 7));
  EXPECT_THAT(mesh.nodeSets.at("tip"), ElementsAre(0, 3, 4, 7, 8, 9));
  EXPECT_THAT(mesh.nodeSets.at("skin"), ElementsAre(0, 3, 4, 7));  // a surface keeps its nodes
  EXPECT_EQ(mesh.elementSets.at("Bricks").size(), 1u);
  EXPECT_EQ(mesh.elementSets.at("prisms").size(), 2u);
  EXPECT_EQ(mesh.elementSets.at("both").size(), 3u);
  EXPECT_EQ(mesh.elementSets.at("gaps").size(), 3u);
}

TEST_F(InpTest, SkipsTheRestWithANote) {
  read(deck(R"(*MATERIAL, NAME=EL
*ELASTIC
30000., 0.3
*STEP, NLGEOM
*STATIC
*NODE PRINT, NSET=ALLNODES
U
*END STEP
)"));
  ASSERT_FALSE(notes.empty());
  EXPECT_THAT(notes, ::testing::Contains(HasSubstr("*MATERIAL")));
  EXPECT_THAT(notes, ::testing::Contains(HasSubstr("*NODE PRINT")));
  EXPECT_THAT(notes, ::testing::Contains(HasSubstr("*ELEMENT, TYPE=SPRINGA")));
}

TEST_F(InpTest, ReadsQuadraticElementsInTheirOrder) {
  std::string text = "*NODE\n";
  const ElementInfo& hex = *findElementByName("hex20");
  for (int a = 0; a < 20; ++a) {
    const auto& X = hex.referenceNodes[a];
    text += joinText(a + 1, ", ", X[0], ", ", X[1], ", ", X[2], "\n");
  }
  text += "*ELEMENT, TYPE=C3D20R\n1, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15,\n16, 17, 18, 19, 20\n";
  EXPECT_NEAR(meshVolume(read(text)), 8, 1e-13);
  text = "*NODE\n";
  const ElementInfo& tet = *findElementByName("tet10");
  for (int a = 0; a < 10; ++a) {
    const auto& X = tet.referenceNodes[a];
    text += joinText(a + 1, ", ", X[0], ", ", X[1], ", ", X[2], "\n");
  }
  text += "*ELEMENT, TYPE=C3D10M\n1, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10\n";
  EXPECT_NEAR(meshVolume(read(text)), 1.0 / 6, 1e-14);
}

TEST_F(InpTest, NamesFileAndLineOfWhatIsWrong) {
  const auto expectError = [&](const std::string& text, const std::string& line, const std::string& what) {
    const std::string found = error(text);
    EXPECT_THAT(found, HasSubstr(path.string() + ":" + line + ":")) << what;
    EXPECT_THAT(found, HasSubstr(what));
    EXPECT_EQ(found.find('\n'), std::string::npos);
  };
  expectError("1, 2, 3\n", "1", "before the first keyword");
  expectError("*NODE\n1, a, 0, 0\n", "2", "must be a number");
  expectError("*NODE\n1.5, 0, 0, 0\n", "2", "whole number");
  expectError("*NODE\n1, 0, 0, 0\n1, 1, 0, 0\n*ELEMENT, TYPE=C3D4\n1, 1, 1, 1, 1\n", "3", "a second time");
  expectError(deck("*ELEMENT, TYPE=C3D4\n10, 1, 2, 3, 5\n"), "30", "a second time");
  expectError(deck("*ELEMENT, TYPE=C3D4\n50, 1, 2, 3\n"), "30", "must have 4");
  expectError(deck("*ELEMENT, TYPE=C3D4\n50, 1, 2, 3, 5, 6\n"), "30", "must have 4");
  expectError(deck("*ELEMENT, TYPE=C3D4\n50, 1, 2, 3, 99\n"), "30", "99");
  expectError(deck("*ELEMENT\n"), "29", "TYPE=");
  expectError(deck("*NSET\n1\n"), "29", "name of the set");
  expectError(deck("*NSET, NSET=a\n1, nowhere\n"), "30", "not defined above");
  expectError(deck("*NSET, NSET=a\n99\n"), "30", "node 99");
  expectError(deck("*NSET, NSET=a, GENERATE\n9, 1\n"), "30", "must not be below");
  expectError(deck("*INCLUDE, INPUT=more.inp\n"), "29", "not followed");
  expectError(deck("*NGEN\n1, 2, 1\n"), "29", "not supported");
  expectError(deck("*ELEMENT, TYPE=C3D15\n60, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 1, 2, 3\n"), "30", "wedge15");
}

TEST_F(InpTest, RefusesWhatIsCutShort) {
  const auto expectError = [&](const std::string& text, const std::string& line, const std::string& what) {
    const std::string found = error(text);
    EXPECT_THAT(found, HasSubstr(path.string() + ":" + line + ": " + what));
    EXPECT_EQ(found.find('\n'), std::string::npos);
  };
  const std::string whole = deck();
  expectError(whole + "*NSET, NSET=a\n1, 2, 1", "30", "the last line, of *NSET, has no line end");
  expectError(whole + "*NODE\n1", "30", "a node has 1 entries");
  expectError(whole + "*ELEMENT, TYPE=C3D4\n50, 1, 2, 3, 5", "30", "the last line, of *ELEMENT, has no line end");
  expectError(whole + "*NSET, NSET=a\n", "29", "the file ends after the line of *NSET");
  expectError(whole + "*ELSET, ELSET=a, GEN", "29", "the file ends after the line of *ELSET");
  expectError(whole + "*ELEMENT, TYPE=C3D", "29", "the file ends after the line of *ELEMENT");
  expectError(whole + "*STEP\n*STATIC\n", "29", "*STEP is never ended by *END STEP");
  expectError("*PART, NAME=p\n" + whole, "1", "*PART is never ended by *END PART");
  expectError("*PART, NAME=p\n" + whole + "*END PART\n*ASSEMBLY\n*INSTANCE, NAME=i, PART=p\n*END INSTANCE\n", "31",
              "*ASSEMBLY is never ended by *END ASSEMBLY");
  // Every cut of a deck with a step is refused: it is in the middle of a line, or the step is not there or open.
  const std::string stepped = whole + "*STEP\n*STATIC\n1., 1.\n*END STEP";
  for (std::size_t end = whole.size() + 6; end < stepped.size(); ++end)
    EXPECT_NE(error(stepped.substr(0, end)), "no error") << end;

  read(stepped);
  read(stepped + "\n");
  read(whole + "*STEP\n*STATIC\n*ENDSTEP\n*STEP\n*END  STEP\n");
  read(whole + "*NSET, NSET=fromElements, ELSET=Bricks\n");
}

TEST_F(InpTest, KeepsRangesOfSets) {
  const Mesh mesh = read(deck(R"(*NSET, NSET=all, GENERATE
1, 1000000000, 1
*NSET, NSET=odd, GENERATE
1, 9223372036854775807, 2
*NSET, NSET=far, GENERATE
5, 9223372036854775807, 9000000000000000000
*NSET, NSET=twice
odd, odd, far, 1, 2, 3, odd
*ELSET, ELSET=tens, GENERATE
10, 20, 10
*ELSET, ELSET=more
tens, 21, tens
)"));
  EXPECT_EQ(mesh.nodeSets.at("all").size(), 12u);
  EXPECT_THAT(mesh.nodeSets.at("odd"), ElementsAre(0, 2, 4, 6, 8, 10));
  EXPECT_THAT(mesh.nodeSets.at("far"), ElementsAre(4));
  EXPECT_THAT(mesh.nodeSets.at("twice"), ElementsAre(0, 1, 2, 4, 6, 8, 10));
  EXPECT_EQ(mesh.elementSets.at("tens").size(), 2u);
  EXPECT_EQ(mesh.elementSets.at("more").size(), 3u);
}

TEST_F(InpTest, RefusesSetsThatHoldFarMoreThanTheFile) {
  std::string text = deck();
  text += "*NODE\n";
  for (int i = 13; i <= 2000; ++i) text += joinText(i, ", ", i, ", 0, 0\n");
  for (int i = 0; i < 8000; ++i) text += joinText("*NSET, NSET=s", i, ", GENERATE\n1, 2000\n");
  EXPECT_THAT(error(text), HasSubstr("the sets of this file hold more than"));
}

}  // namespace
}  // namespace ringwatch
