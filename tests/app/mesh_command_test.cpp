// `ringwatch mesh`: generate, convert, check, repair.
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ringwatch/meshes/mesh_io.h>

#include "program.h"

namespace ringwatch {
namespace {

using test::material;
using test::Outcome;
using test::Program;
using ::testing::AllOf;
using ::testing::HasSubstr;

TEST_F(Program, ConvertsAndChecksMeshes) {
  ASSERT_EQ(call("mesh generate ball --radius 0.05 --cells 4 -o ball.msh").status, 0);
  EXPECT_EQ(call("mesh convert ball.msh ball.vtu").status, 0);
  EXPECT_EQ(call("mesh convert ball.vtu back.msh").status, 0);
  const Mesh first = readMesh(folder_.path() / "ball.msh"), back = readMesh(folder_.path() / "back.msh");
  EXPECT_EQ(first.X, back.X);
  EXPECT_EQ(first.blocks[0].connectivity, back.blocks[0].connectivity);
  const Outcome good = call("mesh check ball.msh");
  EXPECT_EQ(good.status, 0);
  EXPECT_THAT(good.out, HasSubstr("nothing wrong"));

  folder_.write(
      "bad.msh",
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n5\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 0 0 2\n$EndNodes\n"
      "$Elements\n2\n1 4 2 1 1 1 2 3 4\n2 4 2 1 1 1 3 2 5\n$EndElements\n");
  const Outcome bad = call("mesh check bad.msh");
  EXPECT_EQ(bad.status, 1);
  EXPECT_THAT(bad.out, AllOf(HasSubstr("inverted"), HasSubstr("1 problem\n")));
  expectRefused(std::string("inspect bad.msh") + material, "bad.msh");

  // Only numbered the other way, on the other side of the common face: turned round by all that read it.
  folder_.write("mirrored.msh", folder_.read("bad.msh")
                                    .replace(folder_.read("bad.msh").find("5 0 0 2"), 7, "5 0 0 -2")
                                    .replace(folder_.read("bad.msh").find("1 3 2 5") + 1, 7, "1 2 3 5"));
  const Outcome mirrored = call("mesh check mirrored.msh");
  EXPECT_EQ(mirrored.status, 0);
  EXPECT_THAT(mirrored.out, AllOf(HasSubstr("1 of 2 tet4 are of the other handedness"), HasSubstr("nothing wrong")));
  EXPECT_THAT(call(std::string("inspect mirrored.msh") + material).out, HasSubstr("volume 0.5 m3"));
  ASSERT_EQ(call("mesh convert mirrored.msh turned.msh").status, 0);
  EXPECT_TRUE(checkMesh(readMesh(folder_.path() / "turned.msh")).empty());
  ASSERT_EQ(call("mesh convert bad.msh still_bad.msh").status, 0);
  EXPECT_EQ(call("mesh check still_bad.msh").status, 1);
}

// A cube of two wedges, a hexahedron as which a deck writes a wedge beside, one element twice, one mirrored, one that
// has nodes of its own at the common face, and a node of no element.
TEST_F(Program, RepairsMeshes) {
  folder_.write("damaged.msh",
                "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n3 1 \"left\"\n3 2 \"right\"\n"
                "$EndPhysicalNames\n$Nodes\n17\n"
                "1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 0 0 1\n6 1 0 1\n7 1 1 1\n8 0 1 1\n"
                "9 2 0 0\n10 2 1 0\n11 2 0 1\n12 2 1 1\n13 1 0 0\n14 1 1 0\n15 1 0 1\n16 1 1 1\n17 9 9 9\n$EndNodes\n"
                "$Elements\n5\n1 6 2 1 1 1 2 3 5 6 7\n2 6 2 1 1 1 4 3 5 8 7\n3 6 2 2 1 1 3 2 5 7 6\n"
                "4 5 2 2 1 13 9 10 10 15 11 12 12\n5 6 2 2 1 13 10 14 15 12 16\n$EndElements\n");
  const Outcome check = call("mesh check damaged.msh");
  EXPECT_EQ(check.status, 1);
  EXPECT_THAT(check.out, AllOf(HasSubstr("has the same nodes as element 1, and `ringwatch mesh repair` leaves it out"),
                               HasSubstr("4 nodes lie where another node lies"),
                               HasSubstr("`ringwatch mesh repair --join 0` joins them")));
  expectRefused(std::string("inspect damaged.msh") + material, "`ringwatch mesh repair` leaves it out");

  // Where it is read, as the file that would be written.
  EXPECT_THAT(call("mesh repair damaged.msh apart.msh").out, HasSubstr("; left: the mesh falls into "));
  EXPECT_THAT(call("mesh repair damaged.msh apart.msh").out, HasSubstr("; 4 nodes lie where another node lies"));
  const Outcome apart = call(std::string("inspect apart.msh --json -") + material),
                asRead = call(std::string("inspect damaged.msh --repair --json -") + material);
  ASSERT_EQ(asRead.status, 0) << asRead.err;
  EXPECT_EQ(parse(asRead.out)["critical_step"], parse(apart.out)["critical_step"]);
  folder_.write("repaired.toml",
                "[mesh]\nfile = \"damaged.msh\"\nrepair = true\n[material]\nmodel = \"stvk\"\nyoung = 1e6\npoisson = "
                "0.3\ndensity = 1000\n[integrator]\nstep = \"auto\"\nend = 0.01\n[output]\npicture = false\n");
  const Outcome ran = call("run repaired.toml --out repaired");
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_THAT(ran.out, HasSubstr("1 element that stands a second time"));
  expectRefused("run repaired.toml --set mesh.repair=false", "`ringwatch mesh repair` leaves it out");
  expectRefused(std::string("inspect apart.msh --repair --displacement u") + material,
                "--repair: is of a mesh at rest");

  const Outcome repair = call("mesh repair damaged.msh mended.msh --join 0");
  EXPECT_EQ(repair.status, 0) << repair.out << repair.err;
  EXPECT_THAT(repair.out, AllOf(HasSubstr("damaged.msh: 4 nodes were joined with another at the same place\n"),
                                HasSubstr("1 element that stands a second time"),
                                HasSubstr("1 hex8 that hold a node several times are read as the wedge6"),
                                HasSubstr("1 of 4 wedge6 are of the other handedness and were turned round\n"),
                                HasSubstr("1 nodes that no element uses are dropped, the first is node 17"),
                                HasSubstr("mended.msh: 12 nodes, 4 wedge6\n")));
  EXPECT_THAT(call("mesh check mended.msh").out, ::testing::StrEq("conclusion: mended.msh: nothing wrong\n"));
  const Outcome inspect = call(std::string("inspect mended.msh") + material);
  EXPECT_EQ(inspect.status, 0);
  EXPECT_THAT(inspect.out, HasSubstr("volume 2 m3"));
  const Mesh mended = readMesh(folder_.path() / "mended.msh");
  EXPECT_EQ(mended.elementSets.at("left").size(), 2u);
  EXPECT_EQ(mended.elementSets.at("right").size(), 3u);  // the element that stood twice is in both

  EXPECT_THAT(call("mesh repair mended.msh again.vtu").out, HasSubstr("mended.msh: nothing more to repair\n"));
  expectRefused("mesh repair damaged.msh mended.msh --join close", "--join: \"close\"; a distance in m is needed");
  expectRefused("mesh repair damaged.msh mended.msh --join=-1", "--join: \"-1\"; a distance in m is needed");
  folder_.write("folded.msh",
                "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n5\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 0 0 2\n"
                "$EndNodes\n$Elements\n2\n1 4 2 1 1 1 2 3 4\n2 4 2 1 1 1 3 2 5\n$EndElements\n");
  const Outcome folded = call("mesh repair folded.msh left.msh");
  EXPECT_EQ(folded.status, 1);
  EXPECT_THAT(folded.out, HasSubstr("left.msh: 5 nodes, 2 tet4; left: 1 inverted\n"));
}

}  // namespace
}  // namespace ringwatch
