// LS-DYNA decks: columns, wide columns and commas, elements in one line and in two, sets; errors with their field.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include <ringwatch/meshes/quality.h>

#include "deck_file.h"

namespace ringwatch {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class DynaMeshes : public test::DeckFile {
 public:
  DynaMeshes() : DeckFile("deck.k") {}

  static constexpr const char* tetrahedron = R"($# a comment
*KEYWORD
*NODE
$#   nid               x               y               z      tc      rc
      11              0.              0.              0.       0       0
      12          1.0+00              0.              0.
      13              0.           1.D+0              0.
      14              0.              0.             1E0
      15             0.5             0.5             0.5
)";
};

// Numbers that touch are told apart by their columns.
TEST_F(DynaMeshes, ReadColumns) {
  const Mesh mesh = read(R"(*KEYWORD
*NODE
10000001-1.23456789E+000 0.00000000E+000 0.00000000E+000       0       0
10000002 1.00000000E+000-1.50000000E+000 0.00000000E+000
10000003 1.00000000E+000 1.50000000E+000 0.00000000E+000
10000004 0.00000000E+000 0.00000000E+000 2.00000000E+000
*ELEMENT_SOLID
90000001       71000000110000002100000031000000410000004100000041000000410000004
*END
what stands here is not read
)");
  EXPECT_THAT(mesh.nodeIds, ElementsAre(10000001, 10000002, 10000003, 10000004));
  EXPECT_EQ(mesh.X.col(0), Eigen::Vector3d(-1.23456789, 0, 0));
  EXPECT_EQ(mesh.X.col(1), Eigen::Vector3d(1, -1.5, 0));
  ASSERT_EQ(mesh.blocks.size(), 1u);
  EXPECT_EQ(elementInfo(mesh.blocks[0].type).name, "tet4");
  EXPECT_THAT(mesh.blocks[0].ids, ElementsAre(90000001));
  EXPECT_EQ(mesh.elementSets.at("part-7").size(), 1u);
}

// The same tetrahedron in every form that there is.
TEST_F(DynaMeshes, ReadEveryFormOfATetrahedron) {
  int count = 0;
  for (const char* const element :
       {"*ELEMENT_SOLID\n       1       3      11      12      13      14      14      14      "
        "14      14\n",
        "*ELEMENT_SOLID\n       1       3      11      12      13      14\n",
        "*ELEMENT_SOLID (ten nodes format)\n       1       3\n      11      12      13      14  "
        "    14      14      14      14       0       0\n",
        "*ELEMENT_SOLID\n1,3\n11,12,13,14,14,14,14,14\n", "*ELEMENT_SOLID\n1,3,11,12,13,13,14,14,14,14\n",
        "*ELEMENT_SOLID %\n         1         3\n        11        12        13        14\n",
        "*ELEMENT_SOLID +\n                   1                   3\n                  11     "
        "             12                  13                  14\n"}) {
    const Mesh mesh = read(std::string(tetrahedron) + element);
    ASSERT_EQ(mesh.blocks.size(), 1u) << element;
    EXPECT_EQ(elementInfo(mesh.blocks[0].type).name, "tet4") << element;
    EXPECT_NEAR(meshVolume(mesh), 1.0 / 6, 1e-15) << element;
    EXPECT_EQ(mesh.nodeCount(), 4u);  // the last node is of no element
    ++count;
  }
  EXPECT_EQ(count, 7);
}

TEST_F(DynaMeshes, ReadSets) {
  const std::string elements =
      "*ELEMENT_SOLID\n1,3,11,12,13,14\n2,4,12,13,14,15\n*SET_NODE_LIST_TITLE\nthe end\n5,\n11,12,\n14\n";
  const Mesh mesh =
      read(std::string(tetrahedron) + elements +
           "*SET_NODE_LIST_GENERATE\n6\n12,13,15,99\n*SET_PART_LIST\n7\n3,4,8\n*SET_PART\n8\n4\n*SET_SOLID\n9\n2, "
           "77\n*MAT_ELASTIC\n1,1,1,0.3\n*ELEMENT_SHELL\n1,1,11,12,13,14\n");
  EXPECT_THAT(mesh.nodeSets.at("nodeset-5"), ElementsAre(0, 1, 3));
  EXPECT_THAT(mesh.nodeSets.at("nodeset-6"), ElementsAre(1, 2, 4));
  EXPECT_THAT(mesh.nodeSets.at("part-4"), ElementsAre(1, 2, 3, 4));
  EXPECT_EQ(mesh.nodeSets.at("partset-7").size(), 5u);
  EXPECT_EQ(mesh.elementSets.at("part-3").size(), 1u);
  EXPECT_EQ(mesh.elementSets.at("partset-7").size(), 2u);
  EXPECT_THAT(mesh.elementSets.at("partset-8"), ElementsAre(ElementRef{0, 1}));
  EXPECT_THAT(mesh.elementSets.at("solidset-9"), ElementsAre(ElementRef{0, 1}));
  EXPECT_THAT(notes, Contains(HasSubstr("skipped, only nodes, elements and their sets are read: *ELEMENT_SHELL, "
                                        "*MAT_ELASTIC")));
}

TEST_F(DynaMeshes, NameTheFieldThatIsWrong) {
  const std::string deck = tetrahedron, element = "*ELEMENT_SOLID\n1,3,11,12,13,14\n";
  EXPECT_THAT(error(deck + element + "*NODE\n      16             0,5\n"),
              HasSubstr(".k:13: field 1 of *NODE, NID, is \"16"));
  EXPECT_THAT(error(deck + element + "*NODE\n      16             0x5\n"),
              HasSubstr(".k:13: field 2 of *NODE, X, is \"0x5\"; it must be a number"));
  EXPECT_THAT(error(deck + element + "*NODE\n      11\n"), HasSubstr(".k:13: node 11 is defined a second time"));
  EXPECT_THAT(error(deck + element + "1,3,11,12,13,15\n"), HasSubstr("element 1 is defined a second time"));
  EXPECT_THAT(error(deck + "*ELEMENT_SOLID\n1,3,11,12,13,16\n"), HasSubstr("node 16"));
  EXPECT_THAT(error(deck + "*ELEMENT_SOLID\n1,3\n"), HasSubstr(".k:11: element 1 has no line of nodes"));
  EXPECT_THAT(error(deck + "*ELEMENT_SOLID\n1,3,11,12,13,14,15,0,0,0\n"),
              HasSubstr(".k:11: field 8 of *ELEMENT_SOLID, N6, is \"0\"; it must be the number of a node"));
  EXPECT_THAT(error(deck + element + "*SET_NODE\n5\n17\n"), HasSubstr("set 5 holds node 17, which no *NODE defines"));
  EXPECT_THAT(error(deck + element + "*SET_NODE\n5\n11\n*SET_NODE_LIST\n5\n12\n"),
              HasSubstr("set 5 is defined a second"));
  EXPECT_THAT(error(deck + "*ELEMENT_SOLID_H20\n"), HasSubstr("*ELEMENT_SOLID_H20 is not read"));
  EXPECT_THAT(error(deck + "*INCLUDE_TRANSFORM\n"), HasSubstr("*INCLUDE_TRANSFORM is not read"));
  EXPECT_THAT(error(deck + "*INCLUDE\n*END\n"), HasSubstr("*INCLUDE above has no name of a file"));
  EXPECT_THAT(error("*KEYWORD LONG=K\n"), HasSubstr("LONG=K is not known"));
}

}  // namespace
}  // namespace ringwatch
