// `ringwatch compare`: integrators and handlers on one motion.
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ringwatch/handlers/handler.h>

#include "handled_program.h"

namespace ringwatch {
namespace {

using test::HandledProgram;
using test::Json;
using test::Outcome;
using test::Program;
using test::tiny;
using ::testing::AllOf;
using ::testing::HasSubstr;

TEST_F(Program, ComparesIntegratorsOnAScene) {
  folder_.write("tiny.toml", tiny);
  const Outcome outcome =
      call("compare tiny.toml --integrators verlet,pefrl,implicit-euler,arkode-ark --json c.json --out pictures");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              AllOf(HasSubstr("cheapest for 1 %"), HasSubstr("cheapest for 1e-6"), HasSubstr("reference converged")));
  const Json result = json("c.json");
  EXPECT_LT(result["reference_error"], 1e-8);
  std::map<std::string, std::vector<double>> errors;
  for (const Json& run : result["runs"]) {
    EXPECT_GT(run["seconds"], 0);
    EXPECT_GT(run["forces"], 0);
    errors[run["integrator"]].push_back(run["error"].is_null() ? NAN : run["error"].get<double>());
  }
  EXPECT_EQ(errors.size(), 4u);
  // Implicit Euler, of order 1, has taken most of the motion out of this run at all but its smallest step.
  for (const auto& [name, values] : errors)
    EXPECT_LT(values.back(), (name == "implicit-euler" ? 0.7 : 0.1) * values.front()) << name;
  for (const char* label : {"1 %", "0.1 %", "1e-6"}) EXPECT_TRUE(result["cheapest"].contains(label)) << label;
  EXPECT_TRUE(exists("pictures/work_precision_tiny_time.gp"));
  EXPECT_TRUE(exists("pictures/work_precision_tiny_forces.dat"));

  const Outcome fixed = call("compare tiny.toml --integrators verlet --step 1e-3,5e-4 --json -");
  EXPECT_EQ(fixed.status, 0) << fixed.err;
  const Json printed = parse(fixed.out);
  ASSERT_EQ(printed["runs"].size(), 2u);
  EXPECT_NEAR(printed["runs"][0]["h"].get<double>(), 1e-3, 1e-12);
  EXPECT_EQ(printed["runs"][1]["forces"], 101);  // a hundred steps and the start

  expectRefused("compare tiny.toml --integrators verlett", "did you mean \"verlet\"");
  expectRefused("compare tiny.toml --step 0", "--step: \"0\" is no time");
  expectRefused("compare tiny.toml --step 1", "beyond the end");
  expectRefused("compare absent.toml", "absent.toml");
  expectRefused("compare tiny.toml --integrators verlet --set move.0.velocity=\"[0, 0, 0]\"", "nothing moves;");
}

TEST_F(HandledProgram, ComparesHandlersWithIntegrators) {
  const Outcome outcome = call("compare slivers.toml --integrators verlet --handlers all --json c.json --step " +
                               number(step_) + "," + number(critical_ / 2));
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json runs = json("c.json")["runs"];
  ASSERT_EQ(runs.size(), 2 * (1 + allHandlers().size()));
  for (const Json& run : runs) {
    const bool large = run["h"].get<double>() > critical_;
    if (run["integrator"] == "verlet" && large)
      EXPECT_TRUE(run["error"].is_null() || run["error"].get<double>() > 1);
    else if (run["integrator"] == "imex" || run["integrator"] == "local-time-stepping" ||
             run["integrator"] == "modal-filter" || !large)
      EXPECT_LT(run["error"].get<double>(), large ? 0.02 : 1e-3) << run;
    else if (run["integrator"] == "fe-pbd")
      EXPECT_LT(run["error"].get<double>(), 0.1) << run;
    else
      EXPECT_TRUE(run["error"].is_number());  // mass scaling runs; with what error is its own affair
  }
  expectRefused("compare slivers.toml --handlers magic", "--handlers: unknown \"magic\"");
}

TEST_F(HandledProgram, ComparesDampedHandlersAndRefusesThoseThatTakeNoDamping) {
  const Outcome outcome = call("compare slivers.toml --integrators verlet --handlers imex --json c.json --step " +
                               number(critical_ / 2) + " --set damping.mass=5");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  // Steps without elements to handle: the handler and its integrator take the same ones, of the damped body.
  const Json runs = json("c.json")["runs"];
  ASSERT_EQ(runs.size(), 2);
  EXPECT_LT(runs[0]["error"].get<double>(), 0.01);
  EXPECT_LT(runs[1]["error"].get<double>(), 0.01);
  expectRefused("compare slivers.toml --handlers fe-pbd --set damping.mass=1",
                "damping.mass: the handler \"fe-pbd\" works without mass-proportional damping");
}

TEST_F(Program, ComparesNoSceneWhoseBodyChanges) {
  folder_.write("tiny.toml", tiny);
  expectRefused("compare tiny.toml --set erosion.max_stretch=1.3", "[erosion]: compare takes no elements that erode");
  folder_.write("cut.toml", std::string(tiny) + "[[cut]]\ntime = 0.01\npoint = [0.05, 0, 0]\nnormal = [1, 0, 0]\n");
  expectRefused("compare cut.toml", "[[cut]]: compare takes no cuts");
  const Outcome suggested = call("suggest cut.toml --frame 0.02");
  EXPECT_EQ(suggested.status, 0) << suggested.err;
  EXPECT_THAT(suggested.out, HasSubstr("note: cuts: it is of the body before the first cut"));
}

}  // namespace
}  // namespace ringwatch
