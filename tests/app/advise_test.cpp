// `ringwatch advise`: what it finds in the way, what its trials measure, and what it refuses.
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
using test::tiny;
using ::testing::HasSubstr;
using ::testing::Not;

const Json* wayOf(const Json& advice, const std::string& name) {
  for (const Json& way : advice["ways"])
    if (way["name"] == name) return &way;
  return nullptr;
}

TEST_F(Program, AdvisesByTrialsThatCompareAndRunsConfirm) {
  folder_.write("tiny.toml", tiny);
  const Outcome outcome =
      call("advise tiny.toml --set integrator.method=verlet --step 4e-3 --time 0.04 --error 0.05 --json a.json");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json advice = json("a.json");
  EXPECT_EQ(advice["needed"], true);
  EXPECT_LT(advice["safe"], 4e-3);
  const Json& plain = advice["ways"][0];
  EXPECT_EQ(plain["kind"], "explicit");
  EXPECT_LT(plain["step"], advice["safe"]);

  // Runs of the scene decide, here its 12 steps: the best is the fastest of those within the error.
  EXPECT_EQ(advice["runs"]["steps"], 12);
  // They pay for the monitor that the scene asks for.
  EXPECT_EQ(advice["runs"]["mode"], "bracket");
  for (const auto& [asked, mode] : {std::pair{"threshold", "threshold"}, {"metric", "threshold"}})
    EXPECT_EQ(parse(call("advise tiny.toml --step 4e-3 --time 0.02 --json - --set monitor.metric=single-element --set "
                         "monitor.mode=" +
                         std::string(asked))
                        .out)["runs"]["mode"],
              mode);
  EXPECT_FALSE(advice["runs"].contains("no_reference"));
  const Json& plainRun = plain["run"];
  int within = 0, handlers = 0, implicit = 0;
  const Json& best = *wayOf(advice, advice["best"]);
  for (const Json& way : advice["ways"]) {
    EXPECT_FALSE(way.contains("gain")) << "a trial is not watched, and its gain is not what the answer counts";
    handlers += way["kind"] == "handler";
    implicit += way["kind"] == "implicit";
    if (way.contains("why_not") || way["error"] > advice["allowed_error"]) continue;
    if (!way.contains("run") || way["run"].contains("why_not") || way["run"]["error"] > advice["allowed_error"])
      continue;
    ++within;
    const Json& run = way["run"];
    EXPECT_GE(1.25 * run["seconds"].get<double>(), best["run"]["seconds"]) << way;
    EXPECT_NEAR(run["gain"].get<double>() * run["seconds"].get<double>(), plainRun["seconds"], 1e-9);
  }
  EXPECT_GE(within, 2);
  EXPECT_GE(handlers, 5);
  EXPECT_GE(implicit, 1);
  EXPECT_LE(best["error"], 0.05);
  EXPECT_THAT(outcome.out, HasSubstr("within an error of 5 %"));
  EXPECT_THAT(outcome.out, Not(HasSubstr("not watched")));

  // `compare` over the same time finds the same errors, but for that of the motion compared with: 1e-4 at most here.
  const Outcome compared = call(
      "compare tiny.toml --integrators verlet --handlers imex,mass-scaling --step 4e-3 --set integrator.end=0.04 "
      "--json c.json --out c");
  ASSERT_EQ(compared.status, 0) << compared.err;
  const Json comparison = json("c.json");
  int same = 0;
  for (const Json& run : comparison["runs"])
    if (const Json* way = wayOf(advice, run["integrator"]); way && (*way)["kind"] == "handler") {
      EXPECT_NEAR((*way)["error"].get<double>(), run["error"].get<double>(), 1e-4) << run;
      ++same;
    }
  EXPECT_EQ(same, 2);

  // A run with the handler handles as many elements and adds the same mass.
  for (const std::string handler : {"imex", "mass-scaling"}) {
    const Outcome run = call("run tiny.toml --out " + handler + " --set handler.method=" + handler +
                             " --set integrator.method=verlet --set integrator.step=4e-3 --set integrator.end=4e-3");
    ASSERT_LE(run.status, 3) << run.err;
    const Json summary = json(handler + "/summary.json");
    EXPECT_EQ(summary["handler"]["handled_elements"], (*wayOf(advice, handler))["elements"]) << handler;
    if (handler == "mass-scaling") {
      EXPECT_NEAR(summary["handler"]["added_mass_kg"].get<double>(),
                  (*wayOf(advice, handler))["added_mass"].get<double>(), 1e-12);
    }
  }
}

TEST_F(Program, AdvisesByTrialsAloneWithoutRuns) {
  folder_.write("tiny.toml", tiny);
  const Outcome outcome =
      call("advise tiny.toml --set integrator.method=verlet --step 4e-3 --time 0.04 --run-steps 0 --json a.json");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json advice = json("a.json");
  EXPECT_FALSE(advice.contains("runs"));
  // The time of a trial decides, and both the table and the answer say that it lacks the monitor's.
  EXPECT_THAT(outcome.out, HasSubstr("10 steps, not watched; error"));
  EXPECT_THAT(outcome.out, HasSubstr("in trials of 10 steps, not watched, within"));
  const Json& plain = advice["ways"][0];
  EXPECT_EQ(plain["gain"], 1);
  const Json& best = *wayOf(advice, advice["best"]);
  for (const Json& way : advice["ways"]) {
    EXPECT_FALSE(way.contains("run"));
    if (!way.contains("why_not")) {
      EXPECT_NEAR(way["gain"].get<double>() * way["seconds"].get<double>(), plain["seconds"], 1e-9);
    }
    if (!way.contains("why_not") && way["error"] <= advice["allowed_error"]) {
      EXPECT_GE(1.25 * way["seconds"].get<double>(), best["seconds"]) << way;
    }
  }
}

TEST_F(Program, AdvisesDampedScenesByDampedTrials) {
  folder_.write("tiny.toml", tiny);
  const std::string arguments = "advise tiny.toml --set integrator.method=verlet --step 4e-3 --time 0.04 --run-steps 0";
  ASSERT_EQ(call(arguments + " --json plain.json").status, 0);
  const Outcome outcome = call(arguments + " --set damping.mass=300 --json damped.json");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json plain = json("plain.json"), damped = json("damped.json");
  EXPECT_LT(damped["safe"], plain["safe"]);
  // Each has the step that the damping leaves, and those without damping say so.
  EXPECT_LT(damped["ways"][0]["step"], plain["ways"][0]["step"]);
  EXPECT_TRUE(wayOf(damped, "imex")->contains("error"));
  EXPECT_THAT((*wayOf(damped, "fe-pbd"))["why_not"].get<std::string>(), HasSubstr("without mass-proportional damping"));
}

// What is said of the end of a run is of what was run to it, and all else is named with why it was not.
TEST_F(Program, AdvisesOfNothingThatWasNotRun) {
  folder_.write("tiny.toml", tiny);
  const Outcome outcome =
      call("advise tiny.toml --set integrator.method=verlet --step 4e-3 --time 4e-3 --error 1e-6 --json a.json");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json advice = json("a.json");
  int run = 0, told = 0;
  for (const Json& way : advice["ways"]) {
    EXPECT_EQ(way.contains("run") + way.contains("not_run") + way.contains("why_not"), 1) << way;
    run += way.contains("run");
    told += way.contains("not_run");
    if (way.contains("not_run")) {
      EXPECT_THAT(outcome.out, HasSubstr(way["name"].get<std::string>() + " "));
    }
  }
  EXPECT_GE(told, 1);
  EXPECT_TRUE(advice["best"].is_null());
  EXPECT_THAT(outcome.out, HasSubstr("none of those that were run keeps the error over"));
  EXPECT_GE(run, 1);
}

TEST_F(Program, AdvisesNothingWhereTheStepIsProven) {
  folder_.write("tiny.toml", tiny);
  const Outcome outcome = call("advise tiny.toml --json a.json");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(json("a.json")["needed"], false);
  EXPECT_FALSE(json("a.json").contains("ways"));
  EXPECT_THAT(outcome.out, HasSubstr("is proven stable as the scene starts"));
}

TEST_F(Program, RefusesToAdviseWhatNoHandlerTakes) {
  folder_.write("tiny.toml", tiny);
  expectRefused("advise tiny.toml --step 4e-3 --run-steps -1", "--run-steps");
  expectRefused("advise tiny.toml --step 0", "--step: \"0\"");
  expectRefused("advise tiny.toml --step 4e-3 --time 1e-3", "--time: 0.001 s is less than one step of 0.004 s");
  expectRefused("advise tiny.toml --step 0.1", "integrator.end: 0.05 s is less than one step of 0.1 s");
  expectRefused("advise tiny.toml --step 4e-3 --set integrator.method=rk4",
                "it takes no handler; choose from symplectic-euler and verlet");
  expectRefused("advise tiny.toml --set integrator.step=\"auto\"", "give the step that you want with --step");
  expectRefused("advise tiny.toml --step 4e-3 --set move.0.velocity=\"[0, 0, 0]\"", "nothing moves in");
}

}  // namespace
}  // namespace ringwatch
