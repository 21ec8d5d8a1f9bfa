// on_violation = "repeat": a run that goes back to its last certified state.
#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ringwatch/app/scene/scene.h>
#include <ringwatch/app/scene/scene_state.h>
#include <ringwatch/integrators/body_system.h>

#include "program.h"

namespace ringwatch {
namespace {

using test::Json;
using test::Outcome;
using test::Program;
using test::tiny;
using ::testing::HasSubstr;

/// A bar that is pulled fast, and stiffens.
const std::string pulled =
    " --set move.0.velocity=\"[2, 0, 0]\" --set output.picture=false --set "
    "monitor.energy_tolerance=1 ";

double safeAtStart(const Json& suggestion) { return suggestion["start"]["safe"]; }

class Repeats : public Program {
 protected:
  void SetUp() override { folder_.write("tiny.toml", tiny); }
  double startStep() { return safeAtStart(parse(call("suggest tiny.toml --frame 0.02 --json -").out)); }
  Outcome run(const std::string& options, double h) {
    return call("run tiny.toml --set integrator.step=" + test::digits(h) + pulled + options);
  }
};

TEST_F(Repeats, GoesBackToTheStartAndIsTheRunWithTheSmallerStep) {
  const double h = 0.999 * startStep();
  const std::string until = " --set integrator.end=" + test::digits(25 * h) + " --set monitor.every=20 ";
  const Outcome outcome = run("--out r --set monitor.on_violation=repeat" + until, h);
  ASSERT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  const Json summary = json("r/summary.json");
  EXPECT_TRUE(summary["certified"]);
  EXPECT_GE(summary["repeats"]["count"], 1);
  // The bar had stiffened so far before the observation after 20 steps that it did not come to it.
  EXPECT_GE(summary["repeats"]["dropped_steps"], 1);
  EXPECT_LE(summary["repeats"]["dropped_steps"], 20);
  EXPECT_THAT(outcome.out, HasSubstr("after going back "));
  EXPECT_THAT(outcome.out, HasSubstr("step 0, t = 0 s: repeated from here with h = "));

  const double smaller = summary["largest_step"];
  EXPECT_LT(smaller, h);
  ASSERT_EQ(summary["smallest_step"], smaller);  // it went back to the start alone
  ASSERT_EQ(run("--out direct" + until, smaller).status, 0);
  const Table repeated = table("r/history.csv"), direct = table("direct/history.csv");
  ASSERT_EQ(repeated.rows.size(), direct.rows.size());
  for (std::size_t i = 0; i < direct.rows.size(); ++i)
    for (const char* column :
         {"step", "time_s", "h_s", "kinetic_J", "strain_J", "external_work_J", "balance_error_J", "verdict"})
      EXPECT_EQ(repeated.at(i, column), direct.at(i, column)) << i << " " << column;
  EXPECT_EQ(repeated.number(0, "repeats"), summary["repeats"]["count"].get<double>());
  EXPECT_EQ(summary["frames"], json("direct/summary.json")["frames"]);
}

// The step is shortened before the first one is taken; what comes of it goes back to there.
TEST_F(Repeats, GoesBackToAStartWhoseStepWasShortened) {
  const double h = 1.5 * startStep();
  const Outcome outcome = run(
      "--out r --set monitor.on_violation=repeat --set monitor.every=60 --set integrator.end=" + test::digits(60 * h),
      h);
  ASSERT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  const Json summary = json("r/summary.json");
  EXPECT_TRUE(summary["certified"]);
  EXPECT_GE(summary["repeats"]["count"], 1);
  EXPECT_LT(summary["largest_step"].get<double>(), startStep());
}

// The run observes its start and its end alone.
TEST_F(Repeats, JudgesTheEndOfTheRun) {
  const double h = 0.999 * startStep();
  const std::string options =
      " --set monitor.every=100 --set monitor.on_violation=repeat --set integrator.end=" + test::digits(8 * h) +
      " --set output.every=" + test::digits(8 * h);
  const Outcome outcome = run("--out r" + options, h);
  ASSERT_LE(outcome.status, 3) << outcome.err;
  const Json summary = json("r/summary.json");
  EXPECT_GE(summary["repeats"]["count"], 1);
  EXPECT_LT(summary["largest_step"].get<double>(), h);
  const std::string last = "inspect r --frame " + std::to_string(summary["frames"].get<int>()) + " --json - --prove ";
  EXPECT_EQ(call(last + test::digits(summary["largest_step"])).status, 0);
  EXPECT_NE(call(last + test::digits(h)).status, 0);
}

/// By the step that a run goes back to, a timed load has done the work that it had done there the first time.
TEST_F(Repeats, CountsTheWorkOfTimedLoadsOnce) {
  folder_.write("timed.toml", R"toml([mesh]
generate = "bar"
size = [0.2, 0.04, 0.04]
cells = [6, 2, 2]
element = "tet4"
[material]
model = "neo-hookean"
young = 30e3
poisson = 0.3
density = 1000
[integrator]
method = "verlet"
step = 2e-3
end = 0.15
[monitor]
mode = "bracket"
every = 10
[[fix]]
where = "x < 1e-6"
[[force]]
where = "x > 0.2 - 1e-6"
force = [6,0,0]
factor = "sin(20*t)"
)toml");
  ASSERT_LE(call("run timed.toml --out direct --set output.picture=false").status, 1);
  const Outcome outcome = call("run timed.toml --out r --set output.picture=false --set monitor.on_violation=repeat");
  ASSERT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  const Table rows = table("r/history.csv"), direct = table("direct/history.csv");
  std::size_t compared = 0;
  for (; compared < rows.rows.size() && rows.at(compared, "time_s") == direct.at(compared, "time_s"); ++compared)
    EXPECT_EQ(rows.at(compared, "external_work_J"), direct.at(compared, "external_work_J")) << compared;
  EXPECT_GT(compared, 10);
  EXPECT_LT(compared, rows.rows.size());
}

TEST_F(Repeats, ComesToTheStatesOfTheStepsThatAreLeft) {
  const double h = 0.999 * startStep();
  const Outcome outcome =
      run("--out r --set monitor.on_violation=repeat --set integrator.end=" + test::digits(120 * h) +
              " --set monitor.every=4 --set output.reactions=true",
          h);
  ASSERT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  const Json summary = json("r/summary.json");
  const Table rows = table("r/history.csv");
  EXPECT_GE(summary["repeats"]["count"], 2);
  EXPECT_EQ(rows.number(rows.rows.size() - 1, "repeats"), summary["repeats"]["count"].get<double>());
  ASSERT_EQ(rows.rows.size(), summary["steps"].get<std::size_t>());
  ASSERT_EQ(table("r/probes.csv").rows.size(), rows.rows.size());
  EXPECT_LT(summary["smallest_step"], summary["largest_step"]);

  // The steps of the history, taken by the integrator alone.
  const Scene scene = readScene(folder_.path() / "tiny.toml", {"move.0.velocity=[2, 0, 0]"});
  std::vector<std::string> notes;
  const Body body = sceneBody(scene, sceneMesh(scene, notes), 1);
  BodySystem system(body);
  const auto integrator = makeIntegrator(scene.method);
  State state = sceneInitialState(scene, system);
  Body::Workspace workspace;
  for (std::size_t i = 0; i < rows.rows.size(); ++i) {
    EXPECT_EQ(rows.number(i, "step"), static_cast<double>(i));
    EXPECT_EQ(rows.at(i, "verdict"), "certified");
    EXPECT_NEAR(rows.number(i, "time_s"), state.time, 1e-12);
    const double strain = body.energy(state.x, workspace), scale = 1e-9 * (strain + 1e-9);
    EXPECT_NEAR(rows.number(i, "strain_J"), strain, scale) << i;
    // Of a scheme of first order.
    EXPECT_LE(std::abs(rows.number(i, "balance_error_J")),
              0.2 * (rows.number(i, "kinetic_J") + rows.number(i, "strain_J")));
    ASSERT_TRUE(integrator->step(system, state, rows.number(i, "h_s")).done);
  }
}

TEST_F(Repeats, EndsWhereItHasGoneBackOftenEnough) {
  const double h = 0.999 * startStep();
  // Four times as long after so many steps: each halving of the step still leaves too much.
  const std::string far = "--set monitor.every=" + std::to_string(static_cast<int>(0.3 / (2 * h))) +
                          " --set integrator.end=0.2 --set monitor.on_violation=repeat ";
  const Outcome outcome = run("--out r --set monitor.repeats=1 " + far, h);
  EXPECT_EQ(outcome.status, 1);
  const Json summary = json("r/summary.json");
  EXPECT_EQ(summary["exit_reason"], "step-collapsed");
  EXPECT_NE(summary["verdict"], "certified");
  EXPECT_THAT(summary["exit_text"].get<std::string>(),
              HasSubstr("went back to step 0, t = 0 s, as often as monitor.repeats = 1 allows"));
  EXPECT_EQ(summary["repeats"]["count"], 1);
  EXPECT_EQ(run("--out s " + far, h).status, 0);
}

// In the middle of a stretch a signal leaves the state that it began with: the run goes on with the bits that it would
// have had.
TEST_F(Repeats, GoOnBehindASignal) {
  const double h = 0.999 * startStep();
  std::string scene = tiny;
  const auto set = [&](const std::string& from, const std::string& to) {
    scene.replace(scene.find(from), from.size(), to);
  };
  set("step = 1e-3", "step = " + test::digits(h));
  set("end = 0.05", "end = 80\n[monitor]\non_violation = \"repeat\"\nevery = 500");
  set("velocity = [0.05, 0, 0]", "velocity = [2e-3, 0, 0]");
  set("every = 1e-2", "every = 10\nhistory_every = 100\npicture = false");
  folder_.write("scene.toml", scene);
  ASSERT_EQ(call("run scene.toml --out whole --quiet").status, 0);
  const Json whole = json("whole/summary.json");
  EXPECT_GE(whole["repeats"]["count"], 2);
  EXPECT_TRUE(whole["certified"]);
  const Outcome stopped = stopRun("", hasTenRows, "TERM");
  ASSERT_EQ(stopped.status, 4) << stopped.err;
  EXPECT_EQ(json("part/summary.json")["steps"].get<std::int64_t>() % 500, 0);
  ASSERT_EQ(call("run --resume part --quiet").status, 0);
  EXPECT_EQ(folder_.read("part/history.csv"), folder_.read("whole/history.csv"));
  EXPECT_EQ(json("part/summary.json")["repeats"], whole["repeats"]);
}

TEST_F(Repeats, AreRefusedWhereNothingCanGoBack) {
  const std::string run = "run tiny.toml --set monitor.on_violation=repeat --set ";
  expectRefused(run + "integrator.step=auto", "monitor.on_violation: \"repeat\" is for a step that is given");
  expectRefused(run + "monitor.mode=metric --set monitor.metric=pressure-wave",
                "\"repeat\" goes back to certified states");
  expectRefused("run tiny.toml --set monitor.repeats=3", "monitor.repeats: is for on_violation = \"repeat\"");
}

// Contact that begins sets a step far below a millionth of the first: no shorter one is worth while.
TEST_F(Repeats, EndWhereTheStepGoesToNothing) {
  folder_.write("tiny.toml", std::string(tiny) + R"(
[[obstacle]]
kind = "plane"
point = [0, 0, -1e-3]
normal = [0, 0, 1]
velocity = [0, 0, 1]
[[contact]]
penalty = 1e20
)");
  EXPECT_EQ(run("--out r --set monitor.on_violation=repeat", 1e-4).status, 1);
  const Json summary = json("r/summary.json");
  EXPECT_EQ(summary["exit_reason"], "step-collapsed");
  EXPECT_THAT(summary["exit_text"].get<std::string>(), HasSubstr("no step can be certified"));
}

}  // namespace
}  // namespace ringwatch
