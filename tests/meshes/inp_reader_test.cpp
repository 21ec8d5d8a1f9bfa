// Abaqus and CalculiX decks: nodes, elements, sets; the rest skipped with a note; errors with file and line.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include <ringwatch/base/error.h>
#include <ringwatch/meshes/formats/mesh_readers.h>
#include <ringwatch/meshes/mesh_io.h>
#include <ringwatch/meshes/quality.h>

#include "deck_file.h"

namespace ringwatch {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class InpTest : public test::DeckFile {
 public:
  InpTest() : DeckFile("deck.inp") {}

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

TEST_F(InpTest, ReadsADeckThatBeginsWithAByteOrderMark) {
  const Mesh plain = read(std::string(nodes) + elements),
             marked = read("\xEF\xBB\xBF" + std::string("*Heading\n") + nodes + elements);
  EXPECT_TRUE(marked.X == plain.X);
  EXPECT_EQ(marked.elementCount(), plain.elementCount());
}

TEST_F(InpTest, ReadsKeywordsWithBlanks) {
  const std::string deck =
      "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 0, 1, 0\n4, 0, 0, 1\n*ELEMENT, TYPE=C3D4, ELSET=e\n1, 1, 2, 3, 4\n";
  std::string blanks = deck;
  blanks.replace(0, 5, "* NO DE").replace(blanks.find("*ELEMENT, TYPE"), 14, "*ELE MENT, TY PE");
  EXPECT_EQ(read(blanks).elementSets, read(deck).elementSets);
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

TEST_F(InpTest, NotesFormulationsThatAreNotTaken) {
  const auto notesOf = [&](const std::string& type) {
    std::vector<std::string> notes;
    detail::readInp("m.inp",
                    "*NODE\n1,0,0,0\n2,1,0,0\n3,1,1,0\n4,0,1,0\n5,0,0,1\n6,1,0,1\n7,1,1,1\n8,0,1,1\n*ELEMENT, TYPE=" +
                        type + "\n1,1,2,3,4,5,6,7,8\n",
                    &notes, nullptr);
    return notes;
  };
  EXPECT_TRUE(notesOf("C3D8").empty());
  EXPECT_EQ(notesOf("C3D8R").at(0),
            "m.inp: skipped, only nodes, elements and their sets are read: the formulation of C3D8R, which rules = "
            "[\"hex8=uniform-strain\"] has");
  EXPECT_NE(notesOf("C3D8I").at(0).find("the formulation of C3D8I"), std::string::npos);
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
  expectError(deck("*INCLUDE, INPUT=nowhere.inp\n"), "29", "there is no such file");
  expectError(deck("*INCLUDE\n"), "29", "INPUT=");
  expectError(deck("*NCOPY\n1, 2, 1\n"), "29", "not supported");
  expectError(deck("*STEP\n*STATIC\n*END STEP\n1, 2\n"), "32", "a line of data below *END STEP, which has none");
  expectError("*PART, NAME=p\n1.\n" + deck(), "2", "a line of data below *PART, which has none");
  expectError(deck("*NSET, NSET=a, NSET=b\n1\n"), "29", "*NSET has NSET twice, \"a\" and \"b\"; leave one out");
}

TEST_F(InpTest, RefusesWhatIsCutShort) {
  const auto expectError = [&](const std::string& text, const std::string& line, const std::string& what) {
    const std::string found = error(text);
    EXPECT_THAT(found, HasSubstr(path.string() + ":" + line + ": " + what));
    EXPECT_EQ(found.find('\n'), std::string::npos);
  };
  const std::string whole = deck();
  expectError(whole + "*NODE\n1", "30", "a node has 1 entries");
  expectError(whole + "*NSET, NSET=a\n", "29", "the file ends after the line of *NSET");
  expectError(whole + "*ELSET, ELSET=a, GEN", "29", "*ELSET, GEN is not supported");
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

TEST_F(InpTest, TakesALastLineWithoutALineEndWithANote) {
  const Mesh mesh = read(deck("*NSET, NSET=a\n1, 2, 12"));
  EXPECT_THAT(mesh.nodeSets.at("a"), ElementsAre(0, 1, 11));
  EXPECT_THAT(notes, ::testing::Contains(path.string() +
                                         ":30: the last line, of *NSET, has no line end; it is taken as whole"));
}

// As preprocessors write them: sets above the nodes, and nodes again.
TEST_F(InpTest, TakesSetsAboveTheirNodesAndNodesAgain) {
  const Mesh mesh = read("*NSET, NSET=early\n1, 4\n" + deck("*NODE, NSET=again\n1, 0., 0., 0.\n3, 1., 1., 0.\n"));
  EXPECT_EQ(mesh.nodeCount(), 12u);
  EXPECT_THAT(mesh.nodeSets.at("early"), ElementsAre(0, 3));
  EXPECT_THAT(mesh.nodeSets.at("again"), ElementsAre(0, 2));
  EXPECT_THAT(error("*NSET, NSET=early\n1, 99\n" + deck()),
              HasSubstr(":2: set early holds node 99, which no *NODE defines"));
  EXPECT_THAT(error(deck("*NODE\n1, 0., 0., 1e-9\n")),
              HasSubstr(":30: node 1 is defined a second time, at another place"));
}

// A node or element of the assembly is another one than that of an instance with its number, wherever it lies.
TEST_F(InpTest, KeepsNumbersOfTheAssemblyApart) {
  const std::string part =
      "*PART, NAME=p\n" + deck() + "*END PART\n*ASSEMBLY\n*INSTANCE, NAME=i, PART=p\n*END INSTANCE\n";
  const std::string second = "*INSTANCE, NAME=j, PART=p\n9., 0., 0.\n*END INSTANCE\n", end = "*END ASSEMBLY\n";
  const std::string own = "*NODE, NSET=own\n1, 0., 0., 0.5\n*ELEMENT, TYPE=MASS\n10, 1\n";
  const std::string sets =
      "*NSET, NSET=rp\n1\n*NSET, NSET=range, GENERATE\n1, 2\n*NSET, NSET=its, INSTANCE=i\n1\n*NSET, NSET=named\ni.2, "
      "I.4\n*ELSET, ELSET=point\n10\n*ELSET, ELSET=solid\ni.10\n";
  const auto hasMembers = [](const auto& all, const std::string& name) {
    const auto set = all.find(name);
    return set != all.end() && !set->second.empty();
  };
  for (const std::string& instances : {part, part + second}) {
    const Mesh mesh = read(instances + own + sets + end);
    EXPECT_EQ(mesh.nodeCount(), instances == part ? 12u : 24u);
    for (const char* name : {"own", "rp", "range"}) EXPECT_FALSE(hasMembers(mesh.nodeSets, name)) << name;
    EXPECT_THAT(mesh.nodeSets.at("its"), ElementsAre(0));
    EXPECT_THAT(mesh.nodeSets.at("named"), ElementsAre(1, 3));
    EXPECT_EQ(mesh.elementSets.at("solid").size(), 1u);
    EXPECT_FALSE(hasMembers(mesh.elementSets, "point"));
  }
  // Those of the only instance, where the assembly has none of that number.
  EXPECT_THAT(read(part + own + "*NSET, NSET=its\n2\n" + end).nodeSets.at("its"), ElementsAre(1));
  const auto expectError = [&](const std::string& text, const std::string& what) {
    EXPECT_THAT(error(text + end), HasSubstr(what));
  };
  expectError(part + second + own + "*NSET, NSET=its\n2\n", "set its holds node 2, which is none of the assembly");
  expectError(part + second + own + "*NSET, NSET=named\nj.99\n", "the instance has no node \"j.99\"");
  expectError(part + "*NSET, NSET=early\n1\n" + own, "node 1 of the assembly stands below a set that names it");
  expectError(part + own + "*ELEMENT, TYPE=C3D4\n99, 1, 2, 3, 4\n", "element 99 of the assembly has node 1, a number");
}

// The axes of *SYSTEM turn a unit cube by a right angle about z and move it: x' is y, y' is -x.
TEST_F(InpTest, TakesNodesInAxesOfTheirOwn) {
  const std::string cube =
      "1,0,0,0\n2,1,0,0\n3,1,1,0\n4,0,1,0\n5,0,0,1\n6,1,0,1\n7,1,1,1\n8,0,1,1\n*ELEMENT, "
      "TYPE=C3D8\n1,1,2,3,4,5,6,7,8\n";
  const Mesh turned = read("*SYSTEM\n1., 0., 0., 1., 2., 0.\n0., 0., 0.\n*NODE\n" + cube);
  EXPECT_NEAR(meshVolume(turned), 1, 1e-15);
  EXPECT_LT((turned.X.col(1) - Eigen::Vector3d(1, 1, 0)).norm(), 1e-15);
  EXPECT_LT((turned.X.col(3) - Eigen::Vector3d(0, 0, 0)).norm(), 1e-15);
  EXPECT_LT((turned.X.col(4) - Eigen::Vector3d(1, 0, 1)).norm(), 1e-15);
  // An empty one takes the axes of the model again.
  EXPECT_EQ(read("*SYSTEM\n5., 0., 0.\n*NODE\n" + cube).X.col(0), Eigen::Vector3d(5, 0, 0));
  EXPECT_EQ(read("*SYSTEM\n5., 0., 0.\n*SYSTEM\n*NODE\n" + cube).X.col(0), Eigen::Vector3d(0, 0, 0));
  EXPECT_THAT(error("*SYSTEM\n1., 0., 0., 1., 2., 0.\n*NODE\n" + cube), HasSubstr(":1: *SYSTEM has 6 numbers"));
  EXPECT_THAT(error("*SYSTEM\n0,0,0,1,0,0\n2,0,0\n*NODE\n" + cube), HasSubstr(":3: *SYSTEM: the three points lie"));
}

// A bar of 3 x 2 x 2 cubes by lines, faces and rows is the one whose nodes and elements are written out.
TEST_F(InpTest, TakesNodesAndElementsThatAreMade) {
  const std::string made = R"(*NODE
1, 0., 0., 0.
4, 3., 0., 0.
201, 0., 2., 0.
204, 3., 2., 0.
10001, 0., 0., 2.
10004, 3., 0., 2.
10201, 0., 2., 2.
10204, 3., 2., 2.
*NGEN, NSET=a
1, 4
*NGEN, NSET=b
201, 204, 1
*NGEN, NSET=c
10001, 10004
*NGEN, NSET=d
10201, 10204
*NFILL, NSET=below
a, b, 2, 100
*NFILL, NSET=above
c, d, 2, 100
*NFILL, NSET=all
below, above, 2, 5000
*ELEMENT, TYPE=C3D8
1, 1, 2, 102, 101, 5001, 5002, 5102, 5101
*ELGEN, ELSET=bar
1, 3, 1, 1, 2, 100, 10, 2, 5000, 100
)";
  const Mesh mesh = read(made);
  ASSERT_EQ(mesh.nodeCount(), 36u);
  ASSERT_EQ(mesh.elementCount(), 12u);
  EXPECT_EQ(mesh.elementSets.at("bar").size(), 12u);
  EXPECT_EQ(mesh.nodeSets.at("below").size(), 12u);
  EXPECT_EQ(mesh.nodeSets.at("all").size(), 36u);
  for (std::int32_t node = 0; node < 36; ++node) {
    const std::int64_t id = mesh.nodeId(node) - 1, x = id % 100, y = id % 5000 / 100, z = id / 5000;
    const Eigen::Vector3d place = Eigen::Vector<std::int64_t, 3>(x, y, z).cast<double>();
    EXPECT_LT((mesh.X.col(node) - place).norm(), 1e-15) << id + 1;
  }
  for (std::size_t e = 0; e < 12; ++e) {
    const std::int64_t id = mesh.blocks[0].id(e) - 1, x = id % 10, y = id % 100 / 10, z = id / 100;
    EXPECT_EQ(mesh.nodeId(mesh.blocks[0].element(e)[0]), 1 + x + 100 * y + 5000 * z);
  }
  EXPECT_NEAR(meshVolume(mesh), 12, 1e-13);

  EXPECT_THAT(error(deck("*NGEN\n1, 99\n")), HasSubstr(":30: *NGEN: node 99 is not defined above"));
  EXPECT_THAT(error(deck("*NGEN\n1, 4, 2\n")), HasSubstr(":30: *NGEN goes from 1 to 4 by 2"));
  EXPECT_THAT(error(deck("*NGEN, LINE=C\n1, 4\n")), HasSubstr(":29: *NGEN, LINE is not supported; NSET is"));
  EXPECT_THAT(error(deck("*NGEN, NSET\n1, 4\n")), HasSubstr(":29: *NGEN, NSET: needs a name, NSET="));
  EXPECT_THAT(error(deck("*ELEMENT, TYPE=C3D6, ELSET=\n")), HasSubstr(":29: *ELEMENT, ELSET: needs a name, ELSET="));
  EXPECT_THAT(error(deck("*ELGEN, NSET=a\n10, 2\n")), HasSubstr(":29: *ELGEN, NSET is not supported; ELSET is"));
  EXPECT_THAT(error(deck("*NGEN\n, 4\n")), HasSubstr(":30: *NGEN has no entry 1; it must be there"));
  EXPECT_THAT(error(deck("*NGEN\n")), HasSubstr(":29: the file ends after the line of *NGEN"));
  EXPECT_THAT(error(deck("*ELGEN\n, 4\n")), HasSubstr(":30: *ELGEN has no entry 1"));
  EXPECT_THAT(error(deck("*NSET, NSET=a\n1\n*NSET, NSET=b\n3\n*NFILL\na, b\n")),
              HasSubstr(":34: *NFILL has no entry 3"));
  EXPECT_THAT(error(deck("*NSET, NSET=a, UNSORTED\n4, 1\n*NSET, NSET=b\n5, 8\n*NFILL\na, b, 2, 100\n")),
              HasSubstr(":34: *NFILL: a is UNSORTED"));
  EXPECT_THAT(error(deck("*NSET, NSET=a\n1, 2\n*NSET, NSET=b\n3\n*NFILL\na, b, 2, 100\n")),
              HasSubstr(":34: *NFILL is between sets of 2 and 1 nodes"));
  EXPECT_THAT(error(deck("*NFILL\na, b, 2, 100\n")), HasSubstr(":30: *NFILL needs two node sets"));
  EXPECT_THAT(error(deck("*ELGEN\n99, 2\n")), HasSubstr(":30: *ELGEN: element 99 is not defined above"));
  EXPECT_THAT(error(deck("*ELGEN\n10, 2, 1000000000000\n")), HasSubstr(":30: entry 3 of *ELGEN is 1000000000000; it"));
  EXPECT_THAT(error(deck("*ELGEN\n10, 2000000, 1, 1, 2000000\n")), HasSubstr(":30: *ELGEN makes more than"));
}

/// Writes files beside each other; the first name is the deck's.
class InpFilesTest : public ::testing::Test {
 public:
  std::filesystem::path folder =
      std::filesystem::path(::testing::TempDir()) /
      (std::string("decks-") + ::testing::UnitTest::GetInstance()->current_test_info()->name());
  std::vector<std::string> notes;
  void SetUp() override { std::filesystem::create_directories(folder / "parts"); }
  void TearDown() override { std::filesystem::remove_all(folder); }
  void write(const std::string& name, const std::string& text) const { std::ofstream(folder / name) << text; }
  Mesh read(const std::string& name = "deck.inp") { return loadMesh(folder / name, &notes); }
  std::string error(const std::string& name = "deck.inp") {
    try {
      read(name);
    } catch (const InputError& e) {
      return e.what();
    }
    return "no error";
  }
  std::string at(const std::string& name, int line) const {
    return (folder / name).string() + ":" + std::to_string(line) + ": ";
  }
  static constexpr const char* tetrahedron = "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 0, 1, 0\n4, 0, 0, 1\n";
};

TEST_F(InpFilesTest, FollowsIncludes) {
  write("deck.inp", "*HEADING\n*INCLUDE, INPUT=parts\\all.inp\n*NSET, NSET=tip\n*INCLUDE, INPUT=tip.txt\n3\n");
  write("parts/all.inp", joinText("** nodes\n", tetrahedron, "*include, input = \"more.inp\"\n"));  // beside it
  write("parts/more.inp", "*ELEMENT, TYPE=C3D4, ELSET=all\n7, 1, 2, 3, 4\n");
  write("tip.txt", "4,\n");
  const Mesh mesh = read();
  EXPECT_NEAR(meshVolume(mesh), 1.0 / 6, 1e-15);
  EXPECT_THAT(mesh.nodeSets.at("tip"), ElementsAre(2, 3));
  EXPECT_THAT(mesh.blocks[0].ids, ElementsAre(7));

  write("input.inp", "*NODE, INPUT=nodes.txt\n*ELEMENT, TYPE=C3D4\n1, 1, 2, 3, 4\n");
  write("nodes.txt", std::string(tetrahedron).substr(6));
  EXPECT_NEAR(meshVolume(read("input.inp")), 1.0 / 6, 1e-15);
}

TEST_F(InpFilesTest, NamesTheIncludedFileAndItsLine) {
  write("deck.inp", "*INCLUDE, INPUT=nodes.inp\n*ELEMENT, TYPE=C3D4\n1, 1, 2, 3, 9\n");
  write("nodes.inp", tetrahedron);
  EXPECT_THAT(error(), HasSubstr(at("deck.inp", 3)));  // behind the file that was taken in, the deck's own lines
  write("nodes.inp", joinText(tetrahedron, "5, 0, x, 0\n"));
  EXPECT_THAT(error(), HasSubstr(at("nodes.inp", 6) + "coordinate y of node 5"));
  write("nodes.inp", joinText(tetrahedron, "*INCLUDE, INPUT=nowhere.inp\n"));
  EXPECT_THAT(error(), HasSubstr(at("nodes.inp", 6) + "*INCLUDE takes in "));
}

TEST_F(InpFilesTest, RefusesIncludesWithoutEnd) {
  write("deck.inp", "*INCLUDE, INPUT=one.inp\n");
  write("one.inp", "*INCLUDE, INPUT=./parts/../two.inp\n");
  write("two.inp", "*NODE\n*INCLUDE, INPUT=one.inp\n");
  EXPECT_THAT(error(), HasSubstr("two.inp:2: "));
  EXPECT_THAT(error(), HasSubstr("must not include itself"));
  write("self.inp", "*INCLUDE, INPUT=self.inp\n");
  EXPECT_THAT(error("self.inp"), HasSubstr(at("self.inp", 1)));

  for (int i = 0; i < 30; ++i) write(joinText("deep", i, ".inp"), joinText("*INCLUDE, INPUT=deep", i + 1, ".inp\n"));
  write("deep30.inp", tetrahedron);
  EXPECT_THAT(error("deep0.inp"), HasSubstr("at most 20 are followed"));
  EXPECT_EQ(error("deep12.inp").find("at most"), std::string::npos);

  // Two files that each include the next one twice: 2^18 of them.
  for (int i = 0; i < 18; ++i)
    write(joinText("twice", i, ".inp"),
          joinText("*INCLUDE, INPUT=twice", i + 1, ".inp\n*INCLUDE, INPUT=twice", i + 1, ".inp\n"));
  write("twice18.inp", "** nothing\n");
  EXPECT_THAT(error("twice0.inp"), HasSubstr("at most 10000 are followed"));
}

TEST_F(InpFilesTest, TellsADeckByItsContent) {
  write("all.msh",
        joinText("** as cgx writes it\n\n", tetrahedron, "*ELEMENT, TYPE=C3D4, ELSET=Eall\n1, 1, 2, 3, 4\n"));
  EXPECT_NEAR(meshVolume(read("all.msh")), 1.0 / 6, 1e-15);
  write("other.msh", "* not a keyword\n");
  EXPECT_NE(error("other.msh"), "no error");
}

TEST_F(InpFilesTest, PlacesInstances) {
  const std::string part = joinText("*PART, NAME=corner\n", tetrahedron,
                                    "*ELEMENT, TYPE=C3D4, ELSET=body\n1, 1, 2, 3, 4\n*NSET, NSET=foot\n1\n*END PART\n");
  write("deck.inp", part + R"(*ASSEMBLY, NAME=a
*INSTANCE, NAME=first-1, PART=corner
*END INSTANCE
*INSTANCE, NAME=second-1, PART=CORNER
10., 0., 0.
10., 0., 0., 10., 0., 1., 90.
*END INSTANCE
*NSET, NSET=tips, INSTANCE=second-1
4, foot
*NSET, NSET=tips, INSTANCE=first-1
2
*ELSET, ELSET=both, INSTANCE=first-1
body
*ELSET, ELSET=both, INSTANCE=second-1
1
*END ASSEMBLY
)");
  const Mesh mesh = read();
  ASSERT_EQ(mesh.nodeCount(), 8u);
  EXPECT_NEAR(meshVolume(mesh), 2.0 / 6, 1e-15);
  EXPECT_THAT(mesh.blocks[0].ids, ElementsAre(1, 11));
  EXPECT_EQ(mesh.X.col(1), Eigen::Vector3d(1, 0, 0));
  // Moved by 10 along x, then turned by 90 degrees about z through (10, 0, 0).
  EXPECT_LT((mesh.X.col(5) - Eigen::Vector3d(10, 1, 0)).norm(), 1e-15);
  EXPECT_LT((mesh.X.col(6) - Eigen::Vector3d(9, 0, 0)).norm(), 4e-15);
  EXPECT_THAT(mesh.nodeSets.at("first-1.foot"), ElementsAre(0));
  EXPECT_THAT(mesh.nodeSets.at("second-1.foot"), ElementsAre(4));
  EXPECT_THAT(mesh.nodeSets.at("tips"), ElementsAre(1, 4, 7));
  EXPECT_EQ(mesh.elementSets.at("both").size(), 2u);
  EXPECT_THAT(notes,
              ::testing::Contains(HasSubstr("2 instances, their sets are INSTANCE.SET and their numbers those of "
                                            "the file plus: first-1, second-1 + 10")));

  // The sets of an only instance keep the names of its part, unless the assembly has one of that name.
  write("one.inp", part +
                       "*ASSEMBLY, NAME=a\n*INSTANCE, NAME=i, PART=corner\n*END INSTANCE\n*NSET, NSET=foot, "
                       "INSTANCE=i\n3\n*END ASSEMBLY\n");
  const Mesh one = read("one.inp");
  EXPECT_THAT(one.nodeSets.at("i.foot"), ElementsAre(0));
  EXPECT_THAT(one.nodeSets.at("foot"), ElementsAre(2));
  EXPECT_EQ(one.elementSets.at("body").size(), 1u);

  const auto expectError = [&](const std::string& rest, const std::string& what) {
    write("bad.inp", part + "*ASSEMBLY, NAME=a\n" + rest + "*END ASSEMBLY\n");
    EXPECT_THAT(error("bad.inp"), HasSubstr(what));
  };
  expectError("*INSTANCE, NAME=i, PART=edge\n*END INSTANCE\n", "is of the part \"edge\", which is not defined above");
  expectError("*INSTANCE, NAME=i, PART=corner\n1, 2\n*END INSTANCE\n", "it must have 3, its translation");
  expectError("*INSTANCE, NAME=i, PART=corner\n*END INSTANCE\n*INSTANCE, NAME=I, PART=corner\n*END INSTANCE\n",
              "has the name of an instance above");
  expectError("*INSTANCE, NAME=i, PART=corner\n*END INSTANCE\n*NSET, NSET=s, INSTANCE=j\n1\n",
              "is of the instance \"j\", which is not defined above");
  expectError("", "no *INSTANCE of one");
  // The numbers of the only instance are those of its part.
  expectError("*NODE\n7, 1., 1., 1.\n*INSTANCE, NAME=i, PART=corner\n*END INSTANCE\n", "write that *NODE below");
}

TEST_F(InpFilesTest, TakesTheNodesOfElementsAsASet) {
  const std::string body = joinText("*PART, NAME=p\n", tetrahedron,
                                    "5, 0., 0., -1.\n*ELEMENT, TYPE=C3D4, ELSET=body\n1, 1, 2, 3, 4\n2, 1, 3, 2, 5\n"
                                    "*ELSET, ELSET=lower\n2\n*ELSET, ELSET=more\n2, 3\n");
  const std::string placed = "*END PART\n*ASSEMBLY, NAME=a\n*INSTANCE, NAME=i, PART=p\n*END INSTANCE\n";
  write("deck.inp", body + "*NSET, NSET=low, ELSET=Lower\n" + placed + "*NSET, NSET=its, ELSET=lower, INSTANCE=i\n" +
                        "*NSET, NSET=its\n4\n*END ASSEMBLY\n");
  const Mesh mesh = read();
  EXPECT_THAT(mesh.nodeSets.at("low"), ElementsAre(0, 1, 2, 4));
  EXPECT_THAT(mesh.nodeSets.at("its"), ElementsAre(0, 1, 2, 3, 4));
  const auto expectError = [&](const std::string& rest, const std::string& what) {
    write("bad.inp", body + rest + placed + "*END ASSEMBLY\n");
    EXPECT_THAT(error("bad.inp"), HasSubstr(what));
  };
  expectError("*NSET, NSET=n, ELSET=upper\n", "the element set \"upper\", which is not defined above");
  expectError("*NSET, NSET=n, ELSET=lower\n3\n", "has no lines of its own");
  expectError("*NSET, NSET=n, ELSET=more\n", "of element 3 of more, which is not defined above");
  // What would change the mesh.
  expectError("*NODE, SCALE=2\n6, 1., 1., 1.\n", "*NODE, SCALE is not supported; NSET, SYSTEM, INPUT are");
  expectError("*ELEMENT, TYPE=C3D4, OFFSET=10\n3, 1, 2, 3, 4\n", "*ELEMENT, OFFSET is not supported");
  expectError("*NSET, NSET=n, EXCLUDE\n3\n", "*NSET, EXCLUDE is not supported");
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

// Numbers of elements without a shape are there; those of no element or node are told.
TEST_F(InpTest, TellsWhatSetsNameInVain) {
  const auto told = [&](const std::string& sets) {
    notes.clear();
    read(deck("*ELEMENT, TYPE=SPRING1, ELSET=springs\n500, 1\n501, 2\n" + sets));
    std::string text;
    for (const std::string& note : notes)
      if (note.find("what the deck does not have") != std::string::npos) text = note.substr(note.rfind(": ") + 2);
    return text;
  };
  EXPECT_EQ(told("*ELSET, ELSET=a\n10, 500, 501, 20\n*NSET, NSET=b, GENERATE\n1, 12\n"), "");
  EXPECT_EQ(told("*ELSET, ELSET=a\n10, 77, 78\n"), "a (element 77)");
  EXPECT_EQ(told("*ELSET, ELSET=a, GENERATE\n10, 70, 60\n*NSET, NSET=b, GENERATE\n1, 13\n"),
            "a (element 70), b (node 13)");
}

TEST_F(InpTest, ReadsNumbersAsFortranWritesThem) {
  const Mesh mesh = read(
      "*NODE\n1, 1.D-3, .5, -2.\n2, +1.5E+2, 1d0, 1.5-3\n3,0,0,0\n4,1,1,1\n*ELEMENT, TYPE=C3D4\n"
      "1,1,2,3,4\n");
  EXPECT_EQ(mesh.X.col(0), Eigen::Vector3d(1e-3, 0.5, -2));
  EXPECT_EQ(mesh.X.col(1), Eigen::Vector3d(150, 1, 1.5e-3));
}

TEST_F(InpTest, RefusesSetsThatHoldFarMoreThanTheFile) {
  std::string text = deck();
  text += "*NODE\n";
  for (int i = 13; i <= 2000; ++i) text += joinText(i, ", ", i, ", 0, 0\n");
  for (int i = 0; i < 8000; ++i) text += joinText("*NSET, NSET=s", i, ", GENERATE\n1, 2000\n");
  EXPECT_THAT(error(text), HasSubstr("with which this file holds more than "));
  EXPECT_THAT(error("*NODE\n1, 0, 0, 0\n2000000000, 1, 0, 0\n*NGEN\n1, 2000000000, 1\n"),
              HasSubstr(":5: *NGEN makes 1999999999 entries"));
}

}  // namespace
}  // namespace ringwatch
