// The first scene: `ringwatch init` and `ringwatch examples`.
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "program.h"

namespace ringwatch {
namespace {

using test::material;
using test::Outcome;
using test::Program;
using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST_F(Program, InitWritesASceneThatRunsAndNamesItsSchema) {
  const Outcome made = call("init first/scene.toml");
  EXPECT_EQ(made.status, 2);  // there is no such folder
  ASSERT_EQ(shell("mkdir first").status, 0);
  ASSERT_EQ(call("init first/scene.toml").status, 0);
  EXPECT_THAT(folder_.read("first/scene.toml"), StartsWith("#:schema ./scene.schema.json\n"));
  EXPECT_TRUE(folder_.read("first/scene.schema.json") == call("schema scene").out);
  const Outcome run = call("run first/scene.toml --out out");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(json("out/summary.json")["certified"].get<bool>());
  expectRefused("init first/scene.toml", "first/scene.toml is there already");
}

TEST_F(Program, InitTakesAMeshWithItsMaterial) {
  ASSERT_EQ(shell("mkdir scenes").status, 0);
  ASSERT_EQ(call("mesh generate bar --cells 4 1 1 -o bar.msh").status, 0);
  expectRefused("init scenes/bar.toml --mesh bar.msh", "--young, --poisson and --density are required with a mesh");
  expectRefused("init scenes/bar.toml --mesh bar.msh --young 1e6", "--poisson and --density are required with a mesh");
  expectRefused("init bar.msh", "with a mesh: ringwatch init --mesh bar.msh");
  expectRefused("init scenes/bar.toml --mesh none.msh" + std::string(material), "none.msh");
  expectRefused("init scenes/bar.toml --mesh bar.msh --fix 'q < 1'" + std::string(material), "q");
  EXPECT_EQ(shell("ls scenes").out, "");
  ASSERT_EQ(call("init scenes/bar.toml --mesh bar.msh --fix 'x > 0.199' --end 0.01" + std::string(material)).status, 0);
  ASSERT_EQ(call("run scenes/bar.toml --out out").status, 0);
  // The same mesh and the same material: the bracket is that of inspect, with the end held.
  ASSERT_EQ(call("inspect bar.msh --fix 'x > 0.199' --json bar.json" + std::string(material)).status, 0);
  EXPECT_NEAR(table("out/history.csv").number(0, "safe_s") / json("bar.json")["critical_step"]["safe"].get<double>(), 1,
              0.03);
}

// The strains of its first steps under its weight are so small that the law's energy of them is rounding.
TEST_F(Program, InitsSceneOfASmallPartOfSteelIsStable) {
  ASSERT_EQ(call("mesh generate bar --size 20 4 4 --cells 5 1 1 -o bar.msh").status, 0);
  ASSERT_EQ(call("init --mesh bar.msh --young 210e3 --poisson 0.3 --density 7.85e-9 --units mm-t-s").status, 0);
  const Outcome run = call("run scene.toml --out out");
  EXPECT_EQ(run.status, 0) << run.out;
  EXPECT_TRUE(json("out/summary.json")["stable"].get<bool>());
}

TEST_F(Program, InitAsksOnATerminal) {
  const std::string program = "'" + executable() + "' init scene.toml";
  const Outcome asked =
      shell("printf '\\n2e5 0.4 1100\\nx < 1e-3\\n0.02\\n' | script -qec \"" + program + "\" typescript");
  ASSERT_EQ(asked.status, 0) << asked.out << asked.err;
  for (const char* line : {"generate = \"bar\"", "young = 200000", "poisson = 0.4", "density = 1100",
                           "where = \"x < 1e-3\"", "end = 0.02"})
    EXPECT_THAT(folder_.read("scene.toml"), HasSubstr(line));
}

TEST_F(Program, InitAsksAgainWhereAnAnswerIsNone) {
  ASSERT_EQ(call("mesh generate bar --size 20 4 4 --cells 5 1 1 -o bar.msh").status, 0);
  const std::string program = "'" + executable() + "' init scene.toml";
  const Outcome asked = shell(
      "printf 'bra.msh\\nbar.msh\\nmm\\nmm-t-s\\n\\n210e3 0.3\\n210e3, 0.5, 7.85e-9\\n210e3, 0.3, "
      "7.85e-9\\nq < 1\\n\\nsoon\\n1e-5\\n' | script -qec \"" +
      program + "\" typescript");
  ASSERT_EQ(asked.status, 0) << asked.out << asked.err;
  for (const char* fault :
       {"bra.msh: cannot read", "\"mm\"", "\"210e3 0.3\": three numbers are needed", "poisson = 0.5", "q", "\"soon\"",
        "Young's modulus (MPa), Poisson's ratio, density (t/mm3)"})
    EXPECT_THAT(asked.out, HasSubstr(fault));
  for (const char* line : {"system = \"mm-t-s\"", "file = \"bar.msh\"", "young = 210000", "density = 7.85e-09",
                           "acceleration = [0, 0, -9810]", "end = 1e-05"})
    EXPECT_THAT(folder_.read("scene.toml"), HasSubstr(line));
}

TEST_F(Program, ExamplesAreListedAndCopied) {
  EXPECT_THAT(call("examples").out, HasSubstr("stretch_bar "));
  ASSERT_EQ(call("examples swinging_bar --out mine").status, 0);
  const std::string source = RINGWATCH_SOURCE_DIR "/examples/swinging_bar.toml";
  EXPECT_EQ(shell("tail -n +2 '" + source + "' > a; tail -n +2 mine/swinging_bar.toml > b; cmp a b").status, 0);
  EXPECT_EQ(call("run mine/swinging_bar.toml --set integrator.end=0.01 --out out").status, 0);
  expectRefused("examples swinging_bar --out mine", "mine/swinging_bar.toml is there already");
  expectRefused("examples all --out mine", "mine/swinging_bar.toml is there already");
  EXPECT_EQ(shell("ls mine").out, "scene.schema.json\nswinging_bar.toml\n");
  expectRefused("examples swinging_bra", "did you mean \"swinging_bar\"?");
}

}  // namespace
}  // namespace ringwatch
