// `ringwatch judge`: rules of others through the command line.
#include <cmath>
#include <filesystem>
#include <string>
#include <utility>

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
  const std::string junit = folder_.read("j.xml");
  EXPECT_THAT(junit,
              HasSubstr("<testcase classname=\"ringwatch.judge\" name=\"slivers: largest step over the exact one\""));
  EXPECT_THAT(junit, HasSubstr("<failure"));
  // What the schema of Jenkins' xunit plugin requires of a suite.
  EXPECT_THAT(
      junit, HasSubstr("<testsuite name=\"ringwatch judge\" tests=\"10\" failures=\"10\" errors=\"0\" skipped=\"0\">"));
}

// The files of the worst case have its exact step, by the call that is written with it.
class JudgesWorst : public Program {
 protected:
  Json worstOf(const std::string& arguments) {
    const Outcome outcome = call("judge --metric " + arguments + " --worst bad --json a.json");
    EXPECT_EQ(outcome.status, 1) << outcome.err;
    return json("a.json")["worst"];
  }
  /// The exact step by a call of inspect.
  double inspected(const std::string& typed) {
    const std::string program = "ringwatch ";
    EXPECT_EQ(typed.rfind(program, 0), 0U);
    const Outcome outcome = call(typed.substr(program.size()) + " --json -");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return parse(outcome.out)["critical_step"]["global"];
  }
  static constexpr double ofRounding = 1e-12;
};

TEST_F(JudgesWorst, ShapesAreReproduced) {
  for (const auto& [element, deckRule] :
       {std::pair{"tet4", ""}, {"hex8", ""}, {"wedge6", " --rule wedge6=gauss-3x2"}, {"pyramid5", nullptr}}) {
    std::filesystem::remove_all(folder_.path() / "bad");
    const Json worst = worstOf(std::string("pressure-wave:shortest-edge --shapes 4 --elements ") + element);
    const double exact = worst["exact"];
    EXPECT_GT(worst["given"], exact) << element;
    EXPECT_NEAR(inspected(worst["inspect"]), exact, ofRounding * exact) << element;
    EXPECT_EQ(std::filesystem::exists(folder_.path() / "bad/worst.inp"), deckRule != nullptr) << element;
    if (!deckRule) continue;
    EXPECT_NEAR(inspected(std::string("ringwatch inspect bad/worst.inp --model linear --global") + deckRule), exact,
                ofRounding * exact)
        << element;
  }
}

TEST_F(JudgesWorst, StatesOfMotionsAreReproduced) {
  const Json worst = worstOf("pressure-wave:nodal --shapes 0 --histories");
  EXPECT_THAT(worst["inspect"].get<std::string>(),
              HasSubstr("--displacement displacement --fix set:held --model stvk"));
  const double exact = worst["exact"];
  EXPECT_NEAR(inspected(worst["inspect"]), exact, ofRounding * exact);
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
  // Whatever the command says before its last line, and on standard error, is not the step.
  EXPECT_EQ(call("judge bar.msh --command 'echo a warning; seq 1 5000; echo " + test::digits(0.1 * crossing) +
                 "; echo done >&2'")
                .status,
            0);
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
  expectRefused("judge bar.msh", "the rule: must be one of --command, --library and --metric");
  expectRefused("judge bar.msh --metric crossing", "--metric \"crossing\": must be one of");
  expectRefused("judge bar.msh --library none.so", "--library none.so: ");
  expectRefused("judge bar.msh --command false", "--command: false: ended with status 1");
  expectRefused("judge bar.msh --command 'echo no number'", "no number; must be the step alone");
  expectRefused("judge bar.msh --command 'echo 1e-3; echo elapsed 0.1 s'", "no number; must be the step alone");
  expectRefused("judge bar.msh --command 'echo -1'", "bar.msh: the rule gives -1 s; must be above 0 and finite");
  expectRefused("judge bar.msh --metric single-element --command 'echo 1'", "the rule: must be one of --command");
  expectRefused("judge bar.msh --command 'true'", "the last line of its standard output, \"\", is no number");
  expectRefused("judge bar.msh --command 'echo nan'", "\"nan\", is no number");
  expectRefused("judge bar.msh --command 'kill -SEGV $$'", "ended with status 139");
  expectRefused("judge bar.msh --command 'echo lost >&2; exit 3'", "ended with status 3 and said \"lost");
  expectRefused("judge bar.msh --timeout 0.2 --command 'sleep 20 | cat; echo 1'", "took longer than 0.2 s");
  expectRefused("judge --elements pyramid5 --command 'wc -l {mesh.inp}'", "a deck has no element for pyramid5");
  expectRefused("judge --shapes 0 --metric single-element", "nothing to judge the rule on");
  expectRefused("judge none.msh --metric single-element", "none.msh");
  expectRefused("judge --metric single-element --elements hex20", "element \"hex20\": has no shapes to judge by");
}

}  // namespace
}  // namespace ringwatch
