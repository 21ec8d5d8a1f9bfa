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
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n5\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 0 0 -1\n$EndNodes\n"
      "$Elements\n2\n1 4 2 1 1 1 2 3 4\n2 4 2 1 1 1 2 3 5\n$EndElements\n");
  const Outcome bad = call("mesh check bad.msh");
  EXPECT_EQ(bad.status, 1);
  EXPECT_THAT(bad.out, AllOf(HasSubstr("inverted"), HasSubstr("1 problem\n")));
  expectRefused(std::string("inspect bad.msh") + material, "bad.msh");
}

}  // namespace
}  // namespace ringwatch
