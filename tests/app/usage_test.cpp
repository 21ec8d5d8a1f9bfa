// The program as a whole: wrong usage in one line, and its help.
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ringwatch/app/output/report.h>

#include "program.h"

namespace ringwatch {
namespace {

using test::Outcome;
using test::Program;
using ::testing::HasSubstr;

TEST_F(Program, RefusesBadUsageInOneLine) {
  expectRefused("", "");
  expectRefused("rnu x", "did you mean \"run\"?");
  expectRefused("run", "SCENE is missing");
  expectRefused("run a b", "unknown argument");
  expectRefused("run --threads many x.toml", "--threads");
  expectRefused("run --out", "--out");
  expectRefused("inspect", "MESH is required");
  expectRefused("inspect a.msh --young 1 --poisson 0.3", "a.msh: cannot read: there is no such file");
  ASSERT_EQ(call("mesh generate cube --cells 1 -o a.msh").status, 0);
  expectRefused("inspect a.msh --young 1 --poisson 0.3", "--density is required");
  expectRefused("inspect a.msh", "--young, --poisson and --density are required with a mesh file");
  expectRefused("inspect a.msh --young 1 --poisson 0.3 --density 1 --gloabl",
                "did you mean \"--global\"?; see ringwatch inspect --help");
  expectRefused("mesh", "");
  expectRefused("mesh generate bra -o a.msh", "did you mean \"bar\"?");
  expectRefused("mesh generate bar", "--output is required; see ringwatch mesh generate --help");
  expectRefused("mesh generate bar --cells 2 0 2 -o a.msh", "--cells: [2,0,2] does not fit");
  expectRefused("mesh generate bar --cells two -o a.msh", "--cells: \"two\" does not fit");
  expectRefused("mesh generate bar -o a.xyz", "xyz");
  expectRefused("mesh generate bar -o nowhere/a.msh", "nowhere");
  expectRefused("mesh convert none.msh a.vtu", "none.msh");
  expectRefused("mesh check none.msh", "none.msh");
}

TEST_F(Program, TeachesInItsHelp) {
  const Outcome help = call("--help");
  EXPECT_EQ(help.status, 0);
  for (const char* word : {"run", "inspect", "mesh", "help", "Exit status", "any consistent units", "stvk",
                           "symplectic-euler", "mass-scaling", "hex20", ".inp", "ball"})
    EXPECT_THAT(help.out, HasSubstr(word));
  const Outcome scene = call("run --help-scene");
  EXPECT_EQ(scene.status, 0);
  for (const char* word : {"[material]", "[[fix]]", "young", "Pa", "> -1 and < 0.5", "on_violation"})
    EXPECT_THAT(scene.out, HasSubstr(word));
  const Outcome version = call("--version");
  EXPECT_EQ(version.status, 0);
  EXPECT_EQ(version.out, "ringwatch " + std::string(programVersion()) + "\n");
  for (const char* command : {"run --help", "inspect --help", "mesh --help", "mesh generate --help"})
    EXPECT_EQ(call(command).status, 0) << command;
}

}  // namespace
}  // namespace ringwatch
