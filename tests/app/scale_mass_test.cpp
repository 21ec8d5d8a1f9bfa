// `ringwatch scale-mass`: what a plan of added mass says, and what it refuses.
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
using ::testing::AllOf;
using ::testing::HasSubstr;

TEST_F(Program, PlansAddedMassByPartAndInAll) {
  folder_.write("two.toml", R"(mesh = {generate = "bar", size = [0.1, 0.02, 0.02], cells = [10, 2, 2], jitter = 0.25}
material = [{where = "x < 0.05", model = "stvk", young = 30e3, poisson = 0.3, density = 1000},
            {where = "x >= 0.05", model = "neo-hookean", young = 120e3, poisson = 0.3, density = 1000}]
integrator = {step = 1e-3, end = 0.05}
[[fix]]
where = "x < 1e-6"
)");
  const Json start = parse(call("suggest two.toml --frame 1 --json -").out);
  const double safe = start["start"]["safe"], step = 1.3 * start["start"]["optimistic"].get<double>();
  const Outcome outcome = call("scale-mass two.toml --step " + test::digits(step) + " --json a.json");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              AllOf(HasSubstr("little, at nodes"), HasSubstr("by element frequency"), HasSubstr("by material (kg):")));
  const Json report = json("a.json");
  EXPECT_EQ(report["needed"], true);
  EXPECT_EQ(report["safe"], safe);
  for (const char* which : {"by_node", "by_element"}) {
    const Json& plan = report["plans"][which];
    EXPECT_GE(plan["optimistic"].get<double>(), step) << which;
    EXPECT_GE(plan["safe"].get<double>(), step) << which;
    EXPECT_NEAR(plan["parts"][0].get<double>() + plan["parts"][1].get<double>(), plan["added_mass"].get<double>(),
                1e-12 * report["mass"].get<double>());
    EXPECT_NEAR(plan["added_share"].get<double>() * report["mass"].get<double>(), plan["added_mass"].get<double>(),
                1e-15);
    ASSERT_EQ(plan["masses"].size(), plan["nodes"]);
    double listed = 0;
    for (const Json& one : plan["masses"]) {
      EXPECT_EQ(one["id"], one["node"]);
      listed += one["mass"].get<double>();
    }
    EXPECT_NEAR(listed, plan["added_mass"].get<double>(), 1e-12 * listed);
    ASSERT_EQ(plan["frequencies"].size(), 3u);
    for (int k = 0; k < 3; ++k) EXPECT_LT(plan["frequencies"][k], report["frequencies"][k]);
  }
  EXPECT_LT(report["plans"]["by_node"]["added_mass"], report["plans"]["by_element"]["added_mass"]);
  // The stiffer half needs more.
  EXPECT_GT(report["plans"]["by_node"]["parts"][1], report["plans"]["by_node"]["parts"][0]);
  // The third answer is that of a run with the handler, which leaves room; both are told which question they answer.
  const std::string handled =
      "run two.toml --quiet --out h --set handler.method=mass-scaling --set integrator.end=1e-2 "
      "--set integrator.step=" +
      test::digits(step);
  for (const char* margin : {"", " --set handler.method=mass-scaling --set handler.margin=0.3"}) {
    ASSERT_LE(call(handled + margin).status, 3);
    const Json added = json("h/summary.json")["handler"]["added_mass_kg"];
    const Json plans = parse(call("scale-mass two.toml --json - --step " + test::digits(step) + margin).out)["plans"];
    EXPECT_NEAR(plans["by_handler"]["added_mass"].get<double>() / added.get<double>(), 1, 1e-12) << margin;
    EXPECT_GT(plans["by_handler"]["added_mass"], plans["by_node"]["added_mass"]);
  }
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("handler, 15 % room"),
                                 HasSubstr("are for the state at the start; the handler "
                                           "mass-scaling leaves room"),
                                 HasSubstr(" s at the start; ")));
  const Outcome none = call("scale-mass two.toml --step " + test::digits(0.99 * safe));
  EXPECT_EQ(none.status, 0);
  EXPECT_THAT(none.out, HasSubstr("is proven stable without added mass"));
  expectRefused("scale-mass two.toml --step 0", "--step: \"0\" is no time");
  expectRefused("scale-mass two.toml --step 1e-3 --set integrator.method=explicit-euler", "is unstable at every step");
}

}  // namespace
}  // namespace ringwatch
