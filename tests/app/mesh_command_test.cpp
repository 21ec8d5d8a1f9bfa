// `ringwatch mesh`: generate, convert, check.
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

}  // namespace
}  // namespace ringwatch
