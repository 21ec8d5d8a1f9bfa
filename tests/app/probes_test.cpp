// Probes and reaction forces along a run, against closed forms, momentum and the energies of the history_.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <ringwatch/base/error.h>
#include <ringwatch/meshes/formats/vtu_frame.h>

#include "program.h"

namespace ringwatch {
namespace {

using test::Json;
using test::Outcome;
using test::Program;
using ::testing::HasSubstr;

/// One hexahedron after the other, drawn apart at constant speed, without lateral strain: the state is uniform when
/// each layer of nodes is where the ends have it, as in a bar of one cell.
constexpr const char* drawn =
    R"(mesh = {generate = "bar", size = [0.1, 0.02, 0.03], cells = [1, 1, 1], element = "hex8"}
material = {model = "stvk", young = 30e3, poisson = 0.0, density = 1000}
integrator = {step = 5e-4, end = 0.02}
[[fix]]
where = "x < 1e-6"
components = "x"
[[move]]
where = "x > 0.1 - 1e-6"
components = "x"
velocity = [2, 0, 0]
[output]
picture = false
reactions = true
)";

/// Loads, supports and motions of every kind on a bar of two materials and of several element types.
constexpr const char* busy = R"(mesh = {generate = "mixed", size = [0.1, 0.02, 0.02], cells = [6, 2, 2]}
material = [{where = "x < 0.05", model = "stvk", young = 30e3, poisson = 0.3, density = 1000},
            {where = "x >= 0.05", model = "neo-hookean", young = 90e3, poisson = 0.3, density = 700}]
integrator = {step = 2e-4, end = 0.04}
[[fix]]
where = "x < 1e-6"
[[fix]]
where = "x < 1e-6 or z < 1e-6 and x < 0.05"
components = "z"
[[move]]
where = "x > 0.1 - 1e-6"
velocity = [0.1, 0, 0]
times = [0, 0.03]
factors = [0, 1]
ramp = "smooth"
[[force]]
where = "x > 0.04"
acceleration = [0, -9.81, 0]
[[force]]
where = "0.04 < x < 0.06"
force = [0.02, 0, 0.01]
times = [0, 0.02]
factors = [0, 1]
[[probe]]
name = "all"
what = "momentum"
[[probe]]
name = "all_loads"
what = "load"
[[probe]]
name = "all_supports"
what = "reaction"
[[probe]]
name = "part0"
what = "energy"
material = 0
[[probe]]
name = "part1"
what = "energy"
where = "x >= 0.05"
[output]
picture = false
reactions = true
)";

class Probes : public Program {
 protected:
  Table run(const std::string& scene, const std::string& options = "") {
    EXPECT_THAT(runScene(scene, options).out, HasSubstr("probes.csv"));
    return table("r/probes.csv");
  }
};

TEST_F(Probes, TellReactionAndStressOfADrawnBar) {
  const Table found = run(std::string(drawn) + R"([[probe]]
what = "cauchy_stress"
name = "s"
[[probe]]
what = "green_strain"
name = "E"
[[probe]]
what = "max_stretch"
name = "l"
[[probe]]
what = "von_mises"
as = "max"
name = "m"
[[probe]]
what = "displacement"
where = "x > 0.1 - 1e-6"
name = "end"
[[probe]]
what = "velocity"
name = "v"
)");
  ASSERT_EQ(found.rows.size(), 40u);
  for (std::size_t i = 0; i < found.rows.size(); ++i) {
    // St. Venant-Kirchhoff without lateral strain: P = E s (s² - 1) / 2, on the area at rest; σ is the same, as the
    // area stays.
    const double s = 1 + 2 * found.number(i, "time_s") / 0.1, E = 0.5 * (s * s - 1), sigma = 30e3 * s * E;
    const double force = sigma * 0.02 * 0.03, round = 2.6e-14;
    EXPECT_NEAR(found.number(i, "fix.0.reaction_x_N"), -force, round);
    EXPECT_NEAR(found.number(i, "move.0.reaction_x_N"), force, round);
    EXPECT_NEAR(found.number(i, "fix.0.reaction_y_N"), 0, 0);
    EXPECT_NEAR(found.number(i, "s.cauchy_stress_xx_Pa"), sigma, 4.6e-11);
    EXPECT_NEAR(found.number(i, "s.cauchy_stress_yz_Pa"), 0, 2.7e-12);
    EXPECT_NEAR(found.number(i, "E.green_strain_xx"), E, 1.1e-15);
    EXPECT_NEAR(found.number(i, "E.green_strain_yy"), 0, 1.1e-15);
    EXPECT_NEAR(found.number(i, "l.max_stretch"), s, 1.3e-15);
    EXPECT_NEAR(found.number(i, "m.von_mises_Pa"), sigma, 4.6e-11);
    EXPECT_NEAR(found.number(i, "end.displacement_x_m"), 0.1 * (s - 1), 6e-17);
    EXPECT_NEAR(found.number(i, "v.velocity_x_m/s"), 1, 1e-15);  // the mean over both ends
  }
}

TEST_F(Probes, ReactionsAndLoadsChangeTheMomentum) {
  for (const char* motion : {"", "--set move.0.angular_velocity=[3,1,0] --set move.0.point=[0.1,0,0]"}) {
    SCOPED_TRACE(motion);
    const Table found = run(busy, motion);
    ASSERT_EQ(found.rows.size(), 200u);
    double largest = 0, error = 0, split = 0;
    for (std::size_t i = 0; i + 1 < found.rows.size(); ++i)
      for (const std::string c : {"x", "y", "z"}) {
        const double force = found.number(i, "all_loads.load_" + c + "_N") +
                             found.number(i, "all_supports.reaction_" + c + "_N"),
                     change = found.number(i + 1, "all.momentum_" + c + "_kg m/s") -
                              found.number(i, "all.momentum_" + c + "_kg m/s");
        largest = std::max(largest, std::abs(force));
        error = std::max(error, std::abs(force - change / 2e-4));
        double sections = 0;
        for (const std::string section : {"fix.0", "fix.1", "move.0"})
          sections += found.number(i, section + ".reaction_" + c + "_N");
        split = std::max(split, std::abs(sections - found.number(i, "all_supports.reaction_" + c + "_N")));
      }
    EXPECT_GT(largest, 0.1);
    EXPECT_LT(error, 1.4e-12 * largest);
    EXPECT_LT(split, 2.1e-15 * largest);
  }
}

// Eight equal masses at the corners: L = Σ m (|r|² ω - (r·ω) r) about the centre, which is at rest.
TEST_F(Probes, AngularMomentumOfASpinningBarStays) {
  const Table found = run(R"(mesh = {generate = "bar", size = [0.1, 0.02, 0.03], cells = [1, 1, 1], element = "hex8"}
material = {model = "stvk", young = 30e3, poisson = 0.3, density = 1000}
integrator = {method = "symplectic-euler", step = 5e-4, end = 0.1}
[[initial]]
where = "all"
angular_velocity = [0, 10, 20]
point = [0.05, 0.01, 0.015]
[[probe]]
name = "all"
what = "angular_momentum"
[output]
picture = false
)");
  ASSERT_GE(found.rows.size(), 200u);
  const double mass = 0.06, round = 1e-16;
  for (std::size_t i = 0; i < found.rows.size(); ++i) {
    EXPECT_NEAR(found.number(i, "all.angular_momentum_x_kg m2/s"), 0, round) << i;
    EXPECT_NEAR(found.number(i, "all.angular_momentum_y_kg m2/s"), 10 * mass * (0.05 * 0.05 + 0.015 * 0.015), round);
    EXPECT_NEAR(found.number(i, "all.angular_momentum_z_kg m2/s"), 20 * mass * (0.05 * 0.05 + 0.01 * 0.01), round);
  }
}

TEST_F(Probes, EnergiesOfPartsAddUpToThoseOfTheHistory) {
  const Table found = run(busy);
  ASSERT_EQ(found.rows.size(), history_.rows.size());
  double kinetic = 0, strain = 0;
  // Energies of parts are summed in a loop of their own, that of the history in the one of the force. Their laws take
  // them as differences of terms of the size of modulus × volume, 4 J here; measured: 1.9e-17 J.
  constexpr double rounding = 5.7e-17;
  for (std::size_t i = 0; i < found.rows.size(); ++i)
    for (const std::string kind : {"kinetic", "strain"}) {
      const double total = history_.number(i, kind + "_J");
      EXPECT_NEAR(found.number(i, "part0.energy_" + kind + "_J") + found.number(i, "part1.energy_" + kind + "_J"),
                  total, 2.3e-15 * total + rounding);
      (kind == "kinetic" ? kinetic : strain) = std::max(kind == "kinetic" ? kinetic : strain, total);
    }
  EXPECT_GT(kinetic, 1e-6);
  EXPECT_GT(strain, 1e-6);
}

TEST_F(Probes, TellTheStepOfElementsAsFramesDo) {
  const std::string steps = R"([[probe]]
what = "step"
name = "whole"
[[probe]]
what = "step"
where = "x < 0.05"
name = "left"
[[probe]]
what = "step"
where = "x >= 0.05"
name = "right"
[[probe]]
what = "step"
metric = "single-element"
name = "single"
[[probe]]
what = "step"
metric = "pressure-wave"
name = "wave"
)";
  const Table found = run(busy + steps, "--set output.every=0.01");
  for (const int frame : {0, 1, 2, 3}) {
    const VtuFrame read = readVtuFrame(folder_.path() / joinText("r/frames/frame_00000", frame + 1, ".vtu"));
    const auto field = std::ranges::find(read.cells, "optimistic step by reduced-1-ring (s)", &FrameField::name);
    ASSERT_NE(field, read.cells.end());
    EXPECT_EQ(found.number(50 * static_cast<std::size_t>(frame), "whole.optimistic_step_s"),
              *std::ranges::min_element(field->values));
  }
  double least = 1;
  for (std::size_t i = 0; i < found.rows.size(); ++i) {
    const double all = found.number(i, "whole.optimistic_step_s");
    EXPECT_EQ(all, std::min(found.number(i, "left.optimistic_step_s"), found.number(i, "right.optimistic_step_s")));
    EXPECT_LE(found.number(i, "single.safe_step_s"), all);
    EXPECT_LE(history_.number(i, "safe_s"), all);
    EXPECT_GT(found.number(i, "wave.estimate_step_s"), 0);
    least = std::min(least, all);
  }
  EXPECT_LT(least, found.number(0, "whole.optimistic_step_s"));  // it changes along the run
}

TEST_F(Probes, ComeAtTheirIntervalWithTheirUnitsAndTheSameBitsForAnyNumberOfThreads) {
  const Table found = run(busy, "--set output.probe_every=7 --threads 1");
  const std::string one = folder_.read("r/probes.csv");
  for (std::size_t i = 0; i < found.rows.size(); ++i) EXPECT_EQ(found.at(i, "step"), std::to_string(7 * i));
  const Json columns = summary_["probes"];
  ASSERT_EQ(columns.size() + 2, found.columns.size());
  for (std::size_t i = 0; i < columns.size(); ++i) EXPECT_EQ(columns[i]["column"], found.columns[i + 2]);
  EXPECT_EQ(columns[0]["unit"], "kg m/s");
  EXPECT_EQ(columns.back()["unit"], "N");
  run(busy, "--set output.probe_every=7 --threads 3");
  EXPECT_EQ(folder_.read("r/probes.csv"), one);
  // A run without probes leaves none of an earlier one.
  folder_.write("plain.toml", test::tiny);
  EXPECT_EQ(call("run plain.toml --out r").status, 0);
  EXPECT_FALSE(exists("r/probes.csv"));
}

TEST_F(Probes, DoNotChangeTheRun) {
  run(busy);
  const std::string with = folder_.read("r/history_.csv");
  const std::string scene(busy);
  runScene(scene.substr(0, scene.find("[[probe]]")) + "[output]\npicture = false\n");
  EXPECT_EQ(folder_.read("r/history_.csv"), with);
}

TEST_F(Probes, GoOnThroughHandlersAndCuts) {
  const std::string more = R"([[cut]]
time = 0.02
point = [0.05, 0, 0.012]
normal = [0.2, 0, 1]
[handler]
method = "imex"
[[probe]]
what = "energy"
[[probe]]
what = "reaction"
)";
  const Table found = run(test::tiny + more);
  ASSERT_EQ(found.rows.size(), history_.rows.size());
  EXPECT_EQ(summary_["cuts"].size(), 1u);
  for (std::size_t i = 0; i < found.rows.size(); ++i) {
    EXPECT_NEAR(found.number(i, "probe.0.energy_strain_J"), history_.number(i, "strain_J"),
                2.3e-15 * history_.number(i, "strain_J"));
    EXPECT_NEAR(found.number(i, "probe.0.energy_kinetic_J"), history_.number(i, "kinetic_J"),
                2.3e-15 * history_.number(i, "kinetic_J"));
  }
}

TEST_F(Probes, AreRefusedWhereTheyMakeNoSense) {
  const auto refused = [&](const std::string& more, const std::string& what) { refuseScene(drawn + more, what); };
  refused("[[probe]]\nwhere = \"all\"\n", "probe.what: missing");
  refused("[[probe]]\nwhat = \"displacment\"\n", "did you mean \"displacement\"?");
  refused("[[probe]]\nwhat = \"energy\"\nas = \"mean\"\n",
          "\"mean\" does not go with what = \"energy\"; must be \"sum\"");
  refused("[[probe]]\nwhat = \"energy\"\nmetric = \"fried\"\n", "goes with what = \"step\" alone, not with \"energy\"");
  refused("[[probe]]\nwhat = \"velocity\"\nmaterial = 0\n", "\"velocity\" is of nodes; give where or set");
  refused("[[probe]]\nwhat = \"energy\"\nmaterial = 2\n", "2 is no material; there is 1, counted from 0");
  refused("[[probe]]\nwhat = \"energy\"\nmaterial = 0\nwhere = \"all\"\n", "both where and material are given");
  refused("[[probe]]\nwhat = \"energy\"\nname = \"a,b\"\n", "must be made of letters, digits, _ and -");
  refused("[[probe]]\nwhat = \"energy\"\nname = \"a\"\n[[probe]]\nwhat = \"energy\"\nname = \"a\"\n",
          "is the name of scene.toml:");
  refused("[[probe]]\nwhat = \"velocity\"\nwhere = \"x > 5\"\n", "selects no node");
  refused("[[probe]]\nwhat = \"energy\"\nwhere = \"x > 5\"\n", "selects no element");
  refused("[[probe]]\nwhat = \"energy\"\nset = \"nothing\"\n", "unknown element set \"nothing\"");
  folder_.write("plain.toml", test::tiny);
  expectRefused("run plain.toml --out bad --set output.probe_every=2", "there is nothing to write");
  expectRefused("run plain.toml --out bad --set output.probe_every=0", "must be >= 1");
  folder_.write("implicit.toml", std::string(test::tiny) + "[[probe]]\nwhat = \"step\"\n");
  expectRefused("run implicit.toml --out bad --set integrator.method=implicit-euler",
                "has no critical step of elements");
}

}  // namespace
}  // namespace ringwatch
