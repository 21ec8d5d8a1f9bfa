// `ringwatch suggest` and `ringwatch inspect --stretch`: steps for a time, and what they refuse.
#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ringwatch/base/error.h>

#include "program.h"

namespace ringwatch {
namespace {

using test::Json;
using test::material;
using test::Outcome;
using test::Program;
using test::tiny;
using ::testing::AllOf;
using ::testing::HasSubstr;

TEST_F(Program, SuggestsStepsThatTheScenesBracketAllows) {
  folder_.write("tiny.toml", tiny);
  const Outcome outcome = call("suggest tiny.toml --frame 1/60 --stretch 0.7:1.5 --json a.json");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_THAT(outcome.out,
              AllOf(HasSubstr("in 0.0166667 s:"), HasSubstr("as the scene starts"), HasSubstr("proven unstable"),
                    HasSubstr("stretches 0.7 to 1.5"), HasSubstr("the step of the scene     0.001 s, 17 steps")));
  const Json report = json("a.json");
  // The bracket is that of inspect on the same mesh with the same supports.
  ASSERT_EQ(call("mesh generate bar --size 0.1 0.02 0.02 --cells 5 1 1 -o bar.msh").status, 0);
  const Outcome inspected = call(
      "inspect bar.msh --fix \"x < 1e-6\" --fix \"x > 0.1 - 1e-6\" --stretch 0.7:1.5 --json -" + std::string(material));
  ASSERT_EQ(inspected.status, 0) << inspected.err;
  const Json same = parse(inspected.out);
  EXPECT_EQ(report["start"]["safe"], same["critical_step"]["safe"]);
  EXPECT_EQ(report["start"]["optimistic"], same["critical_step"]["optimistic"]);
  EXPECT_EQ(report["range"]["safe"], same["stretch"]["safe"]);
  for (const char* part : {"start", "range"}) {
    const double safe = report[part]["safe"], step = report[part]["step"];
    const std::int64_t count = report[part]["steps"];
    EXPECT_NEAR(step * static_cast<double>(count), 1.0 / 60, 1e-15);
    EXPECT_LE(step, safe);
    EXPECT_GT(1.0 / 60 / static_cast<double>(count - 1), safe);  // one step fewer is not proven
  }
  EXPECT_GE(report["range"]["steps"], report["start"]["steps"]);
  const std::int64_t unstable = report["start"]["unstable_steps"];
  EXPECT_GT(1.0 / 60 / static_cast<double>(unstable), report["start"]["optimistic"].get<double>());

  // The steps keep: a run with them is certified, and one with the last that is proven unstable is named.
  const std::string step = test::digits(report["start"]["step"]);
  EXPECT_NE(call("run tiny.toml --out good --set integrator.end=0.02 --set move.0.velocity=\"[0, 0, 0]\" --set "
                 "integrator.step=" +
                 step)
                .status,
            1);
  EXPECT_GE(json("good/summary.json")["certified_steps"].get<int>(), 1);
  EXPECT_EQ(call("run tiny.toml --out bad --set integrator.end=0.02 --set move.0.velocity=\"[0, 0, 0]\" --set "
                 "integrator.step=" +
                 test::digits(1.0 / 60 / static_cast<double>(unstable)))
                .status,
            1);
}

TEST_F(Program, SuggestsWithDampingAndSaysWhatAHandlerWouldDo) {
  folder_.write("tiny.toml", tiny);
  const Json plain = parse(call("suggest tiny.toml --frame 0.02 --json -").out);
  const Json damped =
      parse(call("suggest tiny.toml --frame 0.02 --stretch 0.9:1.1 --set damping.stiffness=1e-4 --json -").out);
  EXPECT_LT(damped["start"]["safe"], plain["start"]["safe"]);
  EXPECT_EQ(damped["damped"], true);
  EXPECT_LE(damped["range"]["safe"], damped["start"]["safe"]);
  EXPECT_THAT(call("suggest tiny.toml --frame 0.02 --set handler.method=imex").out,
              HasSubstr("handlers: without the handler"));
}

TEST_F(Program, SuggestsForSpringsContactAndSeveralMaterialsWhateverTouches) {
  folder_.write("block.toml",
                R"(mesh = {generate = "bar", size = [0.1, 0.02, 0.02], cells = [6, 2, 2], element = "hex8"}
material = [{where = "x < 0.05", model = "linear", young = 30e3, poisson = 0.3, density = 1000},
            {where = "x >= 0.05", model = "linear", young = 90e3, poisson = 0.3, density = 1100}]
integrator = {step = 2e-4, end = 0.02}
monitor = {on_violation = "warn"}
[[spring]]
where = "x < 1e-6"
stiffness = 500
damping = 0.05
[[obstacle]]
kind = "plane"
point = [0, 0, -0.001]
normal = [0, 0, 1]
[[contact]]
damping = 0.1
penalty = 300
[[initial]]
where = "all"
velocity = [0, 0, -0.5]
[output]
picture = false
)");
  const Outcome outcome = call("suggest block.toml --frame 0.02");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("note: contact counts at every node that it can have, touching or not"));
  const auto suggested = [&](const std::string& options) {
    return parse(call("suggest block.toml --frame 0.02 --json - " + options).out)["start"];
  };
  const auto run = [&](double h, const std::string& options) {
    call("run block.toml --out r --set integrator.step=" + test::digits(h) + " " + options);
    return json("r/summary.json");
  };
  // The laws are linear: what is proven at the start is proven of every state, whatever touches.
  for (const std::string options : {"", "--set spring.0.stiffness=2e4", "--set contact.0.penalty=1e5"}) {
    SCOPED_TRACE(options);
    const Json start = suggested(options);
    const Json good = run(start["step"], options);
    EXPECT_EQ(good["steps"], start["steps"]);
    EXPECT_TRUE(good["first_violated"].is_null());
    EXPECT_GT(good["discrete_forces"]["most_touching"], 0);
    EXPECT_EQ(good["exit_reason"], "end");
    // Fewer than are known to be unstable of what holds from the start.
    const Json bad = run(0.02 / start["unstable_steps"].get<double>(), options);
    EXPECT_FALSE(bad["first_violated"].is_null());
  }
  // A range of stretches counts them too, and at a frame of a run as at the start.
  for (const std::string options : {"", "--set spring.0.stiffness=2e4", "--set contact.0.penalty=1e5"}) {
    SCOPED_TRACE(options);
    const Json both = parse(call("suggest block.toml --frame 0.02 --stretch 0.5:2 --json - " + options).out);
    EXPECT_LE(both["range"]["safe"], both["start"]["safe"]);
    EXPECT_GE(both["range"]["safe"], 0.4 * both["start"]["safe"].get<double>());
    EXPECT_TRUE(run(both["range"]["step"], options)["first_violated"].is_null());
  }
  ASSERT_EQ(call("run block.toml --out framed --set output.every=0.01").status, 0);
  const Outcome framed = call("inspect framed --frame 1 --stretch 0.5:2 --json -");
  ASSERT_EQ(framed.status, 0) << framed.err;
  const Json inspected = parse(framed.out);
  EXPECT_GT(inspected["stretch"]["safe"], 0);
  EXPECT_LE(inspected["stretch"]["safe"], inspected["critical_step"]["safe"]);
  // Each of them counts.
  EXPECT_LT(suggested("--set spring.0.stiffness=2e4")["optimistic"], 0.8 * suggested("")["optimistic"].get<double>());
  EXPECT_LT(suggested("--set contact.0.penalty=1e5")["safe"], 0.8 * suggested("")["safe"].get<double>());
  EXPECT_LT(suggested("--set material.1.young=360e3")["safe"], 0.8 * suggested("")["safe"].get<double>());
}

TEST_F(Program, RefusesTimesStretchesAndIntegratorsThatSaySomethingElse) {
  folder_.write("tiny.toml", tiny);
  for (const std::string bad : {"0", "-1", "1/0", "x", "1/60x", "inf"})
    expectRefused("suggest tiny.toml --frame=" + bad,
                  "--frame: \"" + bad + "\" is no time; must be a number > 0 or a fraction");
  for (const std::string bad : {"1", "0:1", "1.5:0.7", "0.7:", "a:b", "0.7:1.5:2"})
    expectRefused("suggest tiny.toml --frame 1/60 --stretch=" + bad,
                  "--stretch: \"" + bad + "\" is no range of stretches; must be a:b with 0 < a <= b");
  expectRefused("suggest tiny.toml --frame 1/60 --set integrator.method=explicit-euler", "is unstable at every step");
  expectRefused("suggest tiny.toml --frame 1/60 --set integrator.method=implicit-euler", "has no critical step");
  folder_.write("held.toml", std::string(tiny) + "[[spring]]\nwhere = \"x > 0.1 - 1e-6\"\nstiffness = 10\n");
  expectRefused("scale-mass held.toml --step 1e-3",
                "held.toml:21: [[spring]]: scale-mass takes no springs and contact");
  folder_.write("rubbing.toml", std::string(tiny) +
                                    "[[obstacle]]\nkind = \"plane\"\npoint = [0, 0, -1]\nnormal = [0, 0, 1]\n"
                                    "[[contact]]\npenalty = 10\nfriction = 0.3\nslip = 0.1\n");
  expectRefused("suggest rubbing.toml --frame 1/60 --stretch 0.7:1.5",
                "--stretch takes no friction: its damping grows");
}

// One along each edge of a tetrahedron is six springs; masses of nodes are theirs whatever the elements give.
TEST_F(Program, TakesSpringsAlongEdgesAndMassesOfNodes) {
  folder_.write("one.inp",
                "*NODE\n1, 0, 0, 0\n2, 0.1, 0, 0\n3, 0, 0.1, 0\n4, 0, 0, 0.12\n*ELEMENT, TYPE=C3D4\n1, 1, 2, 3, 4\n");
  const std::string head = R"(mesh = {file = "one.inp"}
material = {model = "stvk", young = 3e4, poisson = 0.3, density = 10}
integrator = {step = 0.002, end = 1}
[[mass]]
where = "all"
)";
  const auto start = [&](const std::string& more) {
    folder_.write("one.toml", head + more);
    return parse(call("suggest one.toml --frame 0.01 --json -").out)["start"];
  };
  std::string six;
  for (int i = 1; i <= 4; ++i)
    for (int j = i + 1; j <= 4; ++j)
      six += joinText("[[spring]]\nset = \"#", i, "\"\nto_set = \"#", j, "\"\nstiffness = 900\ndamping = 2\n");
  const std::string edges = "[[spring]]\nwhere = \"all\"\nedges = true\nstiffness = 900\ndamping = 2\n";
  const Json along = start("mass = 1\n" + edges), each = start("mass = 1\n" + six), without = start("mass = 1\n");
  EXPECT_NEAR(along["safe"].get<double>(), each["safe"].get<double>(), 1e-9);
  EXPECT_LT(along["safe"], without["safe"]);
  // Elements give each node a quarter of density × volume.
  const double own = 10 * 0.1 * 0.1 * 0.12 / 24;
  EXPECT_NEAR(start("nodal_mass = " + test::digits(own + 0.25) + "\n")["safe"].get<double>(),
              without["safe"].get<double>(), 1e-12);

  const auto refuse = [&](const std::string& more, const std::string& what) {
    folder_.write("one.toml", head + more);
    expectRefused("suggest one.toml --frame 0.01", what);
  };
  refuse("nodal_mass = 1e-9\n", "one.toml:4: [[mass]]: nodal_mass = 1e-09 kg: node ");
  refuse("nodal_mass = 1\nmass = 2\n", "one.toml:7: mass.mass: both mass and nodal_mass are given; give one of them");
  refuse("", "one.toml:4: mass.mass: missing; give mass (kg) or nodal_mass (kg)");
  refuse("mass = 1\n" + edges + "to_set = \"x\"\n", "spring.edges: both edges and to_set are given");
}

// Without a time the step of the scene is answered for.
TEST_F(Program, SuggestsForTheStepOfTheScene) {
  folder_.write("tiny.toml", tiny);
  const Outcome outcome = call("suggest tiny.toml --set integrator.step=4e-3 --json a.json");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("your timestep 0.004 s is proven unstable, as is every one above "));
  const Json report = json("a.json");
  EXPECT_EQ(report["frame"], 4e-3);
  EXPECT_EQ(report["timestep"]["steps"], report["start"]["steps"]);
  EXPECT_FALSE(parse(call("suggest tiny.toml --frame 0.02 --json -").out).contains("timestep"));
  expectRefused("suggest tiny.toml --set integrator.step=auto",
                "tiny.toml: integrator.step = \"auto\": the time in which steps are counted is needed; give --frame");
}

/// Springs that push at rest make the tangent indefinite.
TEST_F(Program, SuggestsNoStepOfAnIndefiniteTangent) {
  folder_.write("pushed.toml", tiny + std::string("[[spring]]\nwhere = \"x > 0.01 and x < 0.03\"\nto_where = "
                                                  "\"x > 0.07 and x < 0.09\"\nstiffness = 1e3\nlength = 1\n"));
  const Outcome outcome = call("suggest pushed.toml --frame 0.02 --json pushed.json");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("the tangent is indefinite, eigenvalue -"));
  EXPECT_THAT(outcome.out, HasSubstr("as the scene starts       no number of steps is known to be stable"));
  EXPECT_TRUE(json("pushed.json")["start"]["steps"].is_null());
  const Outcome step = call("suggest pushed.toml --json pushed.json");
  EXPECT_EQ(json("pushed.json")["timestep"]["verdict"], "not-certified");
  EXPECT_THAT(step.out, HasSubstr("is not proven stable (the tangent is indefinite, eigenvalue -"));
  // Steps of a run are certified for the highest frequency, and it says so.
  const Outcome run =
      call("run pushed.toml --out r --set integrator.step=1e-5 --set integrator.end=1e-4 --set output.picture=false");
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("every step was safe for the highest frequency, which is all that is proven"));
  EXPECT_THAT(run.out, ::testing::Not(HasSubstr("proven stable")));
}

}  // namespace
}  // namespace ringwatch
