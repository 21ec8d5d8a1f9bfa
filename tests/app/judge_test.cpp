// `ringwatch judge`: rules of others through the command line.
#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "program.h"

namespace ringwatch {
namespace {

using test::Json;
using test::Outcome;
using test::Program;
using ::testing::HasSubstr;

TEST_F(Program, JudgesAMetricAndWritesItsWorstCase) {
  const Outcome outcome = call(
      "judge --metric pressure-wave:shortest-edge --elements tet4 --shapes 4 --worst bad --junit j.xml --json a.json");
  ASSERT_EQ(outcome.status, 1) << outcome.err;
  const Json found = json("a.json");
  EXPECT_EQ(found["passed"], false);
  const double given = found["worst"]["given"], exact = found["worst"]["exact"];
  EXPECT_GT(given, exact);
  double largest = 0;
  for (const Json& row : found["studies"]["judge"]["tables"]["judge"])
    largest = std::max(largest, row["largest step over exact"].get<double>());
  EXPECT_NEAR(largest, given / exact, 1e-9 * largest);
  // Both files are that case.
  for (const char* file : {"bad/worst.msh --young 1e6 --poisson 0.3 --density 1000", "bad/worst.inp"}) {
    const Outcome inspected = call(std::string("inspect ") + file + " --model linear --global --json -");
    ASSERT_EQ(inspected.status, 0) << inspected.err;
    const Json bracket = parse(inspected.out)["critical_step"];
    EXPECT_LE(bracket["safe"].get<double>(), exact * (1 + 1e-9)) << file;
    EXPECT_GE(bracket["optimistic"].get<double>(), exact * (1 - 1e-9)) << file;
  }
  const std::string junit = folder_.read("j.xml");
  EXPECT_THAT(junit,
              HasSubstr("<testcase classname=\"ringwatch.judge\" name=\"slivers: largest step over the exact one\""));
  EXPECT_THAT(junit, HasSubstr("<failure"));
}

TEST_F(Program, JudgesACommandAndALibrary) {
  call("mesh generate bar --size 0.3 0.1 0.1 --cells 3 1 1 --element hex8 -o bar.msh");
  // Edges of 0.1 m: crossed by a pressure wave in 0.1/c.
  const double crossing = 0.1 / std::sqrt(1e6 * 0.7 / (1.3 * 0.4) / 1000);
  folder_.write("rule.sh", "test -s $1 && echo \"with $2, $3 and $4 the step is\" && echo $5\n");
  const auto command = [&](const char* mesh, double step) {
    return call(std::string("judge bar.msh --json - --command 'sh rule.sh ") + mesh + " {young} {poisson} {density} " +
                test::digits(step) + "'");
  };
  for (const char* mesh : {"{mesh}", "{mesh.vtu}", "{mesh.inp}"}) {
    const Outcome safe = command(mesh, 0.1 * crossing);
    ASSERT_EQ(safe.status, 0) << safe.err << safe.out;
    const Json row = parse(safe.out)["studies"]["judge"]["tables"]["judge"][0];
    EXPECT_EQ(row["on"], "bar.msh");
    EXPECT_EQ(row["unsafe"], 0);
    EXPECT_EQ(command(mesh, 10 * crossing).status, 1);
  }
  folder_.write("rule.c", R"(
double ringwatch_step_rule(int nodes, const double* points, int elements, int n, const int* cells, double young,
                           double poisson, double density) {
  double c2 = young * (1 - poisson) / ((1 + poisson) * (1 - 2 * poisson)) / density, edge = points[3 * cells[1]] - points[3 * cells[0]];
  double t = 1;
  for (int i = 0; i < 60; ++i) t = 0.5 * (t + edge * edge / c2 / t);
  return nodes == 16 && elements == 3 && n == 8 ? t : -1;
})");
  ASSERT_EQ(shell("cc -shared -fPIC -O1 -o rule.so rule.c").status, 0);
  const Json byLibrary = parse(call("judge bar.msh --library rule.so --json -").out),
             byMetric = parse(call("judge bar.msh --metric pressure-wave:shortest-edge --json -").out);
  const auto ratio = [](const Json& found) {
    return found["studies"]["judge"]["tables"]["judge"][0]["largest step over exact"].get<double>();
  };
  EXPECT_NEAR(ratio(byLibrary), ratio(byMetric), 1e-9);
}

TEST_F(Program, RefusesARuleThatIsNone) {
  call("mesh generate bar --size 0.3 0.1 0.1 --cells 3 1 1 --element hex8 -o bar.msh");
  expectRefused("judge bar.msh", "Exactly 1 option from [--command,--library,--metric] is required");
  expectRefused("judge bar.msh --metric crossing", "--metric \"crossing\": must be one of");
  expectRefused("judge bar.msh --library none.so", "--library none.so: ");
  expectRefused("judge bar.msh --command false", "--command: false: ended with status 1");
  expectRefused("judge bar.msh --command 'echo no number'", "no number; must be the step alone");
  expectRefused("judge bar.msh --command 'echo 1e-3; echo elapsed 0.1 s'", "no number; must be the step alone");
  expectRefused("judge bar.msh --command 'echo -1'", "bar.msh: the rule gives -1 s; must be above 0 and finite");
  expectRefused("judge none.msh --metric single-element", "none.msh");
  expectRefused("judge --metric single-element --elements hex20", "element \"hex20\": has no shapes to judge by");
}

}  // namespace
}  // namespace ringwatch
