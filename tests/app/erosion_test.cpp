// Runs whose elements erode.
#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include <ringwatch/base/error.h>
#include <ringwatch/meshes/formats/vtu_frame.h>

#include "program.h"

namespace ringwatch {
namespace {

using test::Json;
using test::Outcome;
using test::Program;
using test::tiny;
using ::testing::HasSubstr;

/// A bar that is torn: two parts with a weak one between them that fly apart.
constexpr const char* torn =
    R"(mesh = {generate = "bar", size = [0.12, 0.02, 0.02], cells = [12, 2, 2], element = "hex8"}
material = [{where = "x < 0.05 or x > 0.07", model = "stvk", young = 90e3, poisson = 0.3, density = 1000},
            {where = "0.05 <= x <= 0.07", model = "neo-hookean", young = 30e3, poisson = 0.3, density = 1000}]
integrator = {method = "verlet", step = 1e-4, end = 0.06}
[[initial]]
where = "x < 0.06 - 1e-6"
velocity = [-2, 0, 0.1]
[[initial]]
where = "x > 0.06 + 1e-6"
velocity = [2, 0, 0]
[erosion]
max_stretch = 1.3
[[probe]]
name = "all"
what = "momentum"
[[probe]]
name = "middle"
what = "velocity"
where = "abs(x - 0.06) < 1e-6"
[[probe]]
name = "weak"
what = "energy"
material = 1
[output]
every = 0.06
picture = false
)";

class Erosion : public Program {};

TEST_F(Erosion, TearsABarAndKeepsMassMomentumAndBalance) {
  EXPECT_THAT(runScene(torn).out, HasSubstr("of 48 elements left, the first, hex8 "));
  const Json &summary = summary_, &erosion = summary["erosion"];
  EXPECT_EQ(summary["certified"], true);
  EXPECT_NEAR(summary["mass"].get<double>(), 1000 * 0.12 * 0.02 * 0.02, 1e-15);
  // Both layers of weak cells go: nodes between them are point masses then.
  ASSERT_EQ(erosion["elements"].size(), 8u);
  EXPECT_EQ(summary["mesh"]["elements"]["hex8"], 40);
  std::set<std::int64_t> gone;
  double strain = 0, last = 0;
  for (const Json& one : erosion["elements"]) {
    EXPECT_EQ(one["cause"], "max_stretch");
    EXPECT_GT(one["value"].get<double>(), 1.3);
    EXPECT_LT(one["value"].get<double>(), 1.4);
    EXPECT_EQ(one["element"]["material"], 1);
    gone.insert(one["element"]["id"].get<std::int64_t>());
    strain += one["strain"].get<double>();
    last = std::max(last, one["time"].get<double>());
  }
  EXPECT_EQ(gone.size(), 8u);
  EXPECT_GT(strain, 0);
  EXPECT_NEAR(erosion["strain"].get<double>(), strain, 1e-15 * strain);
  // The frames have what is left.
  const VtuFrame frame = readVtuFrame(folder_.path() / "r/frames/frame_000002.vtu");
  EXPECT_EQ(frame.mesh.elementCount(), 40u);
  EXPECT_EQ(frame.mesh.nodeCount(), 13u * 9);
  // An event for each time at which elements leave, and the number of those that have left in every row.
  std::size_t events = 0, eventElements = 0;
  for (const Json& event : summary["events"]) {
    if (event["kind"] != "eroded") continue;
    ++events;
    eventElements += event["value"].get<std::size_t>();
    const Json& first = erosion["elements"][eventElements - event["value"].get<std::size_t>()];
    EXPECT_EQ(event["element"]["id"], first["element"]["id"]);
    EXPECT_EQ(event["time"], first["time"]);
    EXPECT_EQ(event["end_step"].get<int>(), event["step"].get<int>() + 1);
    EXPECT_THAT(event["text"].get<std::string>(), HasSubstr("eroded, the first, hex8 element"));
    EXPECT_THAT(event["text"].get<std::string>(), HasSubstr(": max_stretch 1.3"));
  }
  EXPECT_GE(events, 1u);
  EXPECT_EQ(eventElements, 8u);
  const Table &history = history_, probes = table("r/probes.csv");
  EXPECT_EQ(history.number(0, "eroded_elements"), 0);
  EXPECT_EQ(history.last("eroded_elements"), 8);
  double change = 0, middle = 0;
  for (std::size_t i = 0; i < history.rows.size(); ++i) {
    EXPECT_LE(history.number(i, "safe_s"), history.number(i, "optimistic_s"));
    for (const std::string c : {"x", "y", "z"})
      change = std::max(change, std::abs(probes.number(i, "all.momentum_" + c + "_kg m/s") -
                                         probes.number(0, "all.momentum_" + c + "_kg m/s")));
    if (history.number(i, "time_s") <= last) continue;
    EXPECT_EQ(history.number(i, "dissipated_J"), history.last("dissipated_J"));
    EXPECT_EQ(probes.number(i, "weak.energy_strain_J"), 0);
    middle =
        std::max(middle, std::abs(probes.number(i, "middle.velocity_x_m/s") - probes.last("middle.velocity_x_m/s")));
  }
  EXPECT_NEAR(history.last("dissipated_J"), strain, 1e-12 * strain);
  EXPECT_LT(history.largest("balance_error_J"), 3.4e-4 * history.largest("kinetic_J"));  // of second order in the step
  EXPECT_LT(change, 7e-17);
  EXPECT_EQ(middle, 0);  // no force acts on point masses
}

// The free end comes off, and with it nodes that conditions of the scene name.
TEST_F(Erosion, InspectAndReportKnowWhatIsLeft) {
  folder_.write("tiny.toml", tiny + std::string("[erosion]\nmax_stretch = 1.3\n"));
  call(
      "run tiny.toml --out r --set \"move.0.velocity=[20, 0, 0]\" --set integrator.step=5e-4 --set integrator.end=0.02 "
      "--set monitor.on_violation=warn "
      "--set output.every=0.002");
  const Json summary = json("r/summary.json");
  ASSERT_GT(summary["erosion"]["elements"].size(), 0) << summary["exit_reason"];
  const Table history = table("r/history.csv");
  const int frames = summary["frames"];
  int eroded = 0;
  for (int frame = 1; frame < frames; ++frame) {
    const Outcome outcome = call("inspect r --json - --global --frame " + std::to_string(frame));
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const Json report = parse(outcome.out);
    EXPECT_NEAR(report["mass"].get<double>(), 0.04, 1e-12);  // what eroded leaves its mass
    for (std::size_t row = 0; row < history.rows.size(); ++row) {
      if (std::abs(history.number(row, "time_s") - report["state"]["time"].get<double>()) > 1e-9) continue;
      EXPECT_LE(history.number(row, "safe_s"), report["critical_step"]["global"].get<double>() * (1 + 1e-9)) << frame;
      EXPECT_GE(history.number(row, "optimistic_s"), report["critical_step"]["global"].get<double>() * (1 - 1e-9))
          << frame;
      eroded += history.number(row, "eroded_elements") > 0;
    }
  }
  EXPECT_GT(eroded, 1);
  EXPECT_EQ(call("report r").status, 0);
}

TEST_F(Erosion, TakesElementsWhoseStepIsTooSmall) {
  const std::string start(tiny);
  folder_.write("scene.toml", start + "[[probe]]\nwhat = \"step\"\nmetric = \"single-element\"\n");
  const std::string mesh =
      "--set mesh.jitter=0.45 --set mesh.seed=3 --set monitor.on_violation=warn "
      "--set integrator.step=1e-5 --set integrator.end=1e-3 ";
  ASSERT_NE(call("run scene.toml --out a " + mesh).status, 2);
  const double least = table("a/probes.csv").number(0, "probe.0.safe_step_s"), limit = 1.05 * least;
  ASSERT_EQ(call("run scene.toml --out b " + mesh + "--set erosion.least_step=" + test::digits(limit)).status, 0);
  const Json erosion = json("b/summary.json")["erosion"];
  ASSERT_GE(erosion["elements"].size(), 1u);
  EXPECT_EQ(erosion["elements"][0]["step"], 0);
  EXPECT_EQ(erosion["elements"][0]["cause"], "step");
  double smallest = 1;
  for (const Json& one : erosion["elements"]) smallest = std::min(smallest, one["value"].get<double>());
  EXPECT_EQ(smallest, least);
  EXPECT_GE(table("b/probes.csv").number(0, "probe.0.safe_step_s"), limit);
  EXPECT_GT(table("b/history.csv").number(0, "safe_s"), table("a/history.csv").number(0, "safe_s"));
}

TEST_F(Erosion, TakesInvertedElementsAndGoesOnWithContact) {
  folder_.write("scene.toml", R"(mesh = {generate = "bar", size = [0.06, 0.02, 0.02], cells = [6, 2, 2]}
material = {model = "stvk", young = 30e3, poisson = 0.3, density = 1000}
integrator = {step = 1e-4, end = 0.01}
monitor = {on_violation = "warn"}
[[obstacle]]
kind = "plane"
point = [-1e-4, 0, 0]
normal = [1, 0, 0]
[[contact]]
[[initial]]
where = "all"
velocity = [-4, 0, 0]
[erosion]
inverted = true
[output]
picture = false
)");
  const Outcome outcome = call("run scene.toml --out r");
  ASSERT_NE(outcome.status, 2) << outcome.err;
  const Json summary = json("r/summary.json");
  ASSERT_GE(summary["erosion"]["elements"].size(), 1u) << outcome.out;
  for (const Json& one : summary["erosion"]["elements"]) {
    EXPECT_EQ(one["cause"], "inverted");
    EXPECT_LE(one["value"].get<double>(), 0);
  }
  for (const Json& event : summary["events"]) EXPECT_NE(event["kind"], "inverted");
  EXPECT_GT(summary["discrete_forces"]["most_touching"].get<int>(), 0);
}

// What is left damps as before: momentum is kept, and what the damping takes is in the balance.
TEST_F(Erosion, LeavesTheDampingOfElementsThatStay) {
  for (const std::string damping : {"--set damping.bulk_viscosity=true", "--set material.0.shear_viscosity=0.5",
                                    "--set material.1.mass_damping=5"}) {
    runScene(torn, "--set integrator.step=5e-5 " + damping);
    const Json& summary = summary_;
    EXPECT_EQ(summary["erosion"]["elements"].size(), 8u) << damping;
    EXPECT_EQ(summary["certified"], true) << damping;
    const Table &history = history_, probes = table("r/probes.csv");
    const double energy = history.number(0, "kinetic_J");
    EXPECT_GT(history.last("dissipated_J"), summary["erosion"]["strain"].get<double>());
    EXPECT_LE(std::abs(history.last("balance_error_J")), 5e-3 * energy) << damping;
    if (damping.find("mass_damping") == std::string::npos) {
      EXPECT_NEAR(probes.last("all.momentum_x_kg m/s"), probes.number(0, "all.momentum_x_kg m/s"), 1e-12);
    }
  }
}

/// A block that comes down on another one whose stiff layer goes at the start.
constexpr const char* landing = R"([mesh]
generate = "stack"
element = "hex8"
size = [0.04, 0.04, 0.06]
cells = [2, 2, 3]
upper_size = [0.02, 0.02, 0.02]
upper_cells = [1, 1, 1]
gap = 0.001
[[material]]
where = "z < 0.04 or z > 0.06"
model = "stvk"
young = 1e5
poisson = 0.2
density = 1000
[[material]]
where = "0.04 <= z <= 0.06"
model = "stvk"
young = 1e6
poisson = 0.2
density = 1000
[integrator]
step = 2e-4
end = 0.06
[[fix]]
where = "z < 1e-6"
[[initial]]
where = "z > 0.0605"
velocity = [0, 0, -1]
[[contact]]
with = "surface"
penalty = 2e3
[erosion]
least_step = 6e-4
[[probe]]
name = "block"
what = "displacement"
where = "z > 0.0605"
[output]
picture = false
)";

// Faces that are gone do not push, and those behind them do: the block passes the layer and turns back at what is left.
TEST_F(Erosion, MovesTheSurfacesOfContact) {
  runScene(landing, "--set erosion.least_step=1e-9", 0, "whole");
  runScene(landing);
  const Json& summary = summary_;
  ASSERT_EQ(summary["erosion"]["elements"].size(), 4u);
  const auto lowest = [&](const std::string& folder) {
    const Table probes = table(folder + "/probes.csv");
    double least = 0;
    for (std::size_t i = 0; i < probes.rows.size(); ++i)
      least = std::min(least, probes.number(i, "block.displacement_z_m"));
    return -least;
  };
  // The gap, the layer, and what the surfaces give way.
  EXPECT_GT(lowest("whole"), 0.001);
  EXPECT_LT(lowest("whole"), 0.011);
  EXPECT_GT(lowest("r"), 0.021);
  EXPECT_LT(lowest("r"), 0.031);
  EXPECT_GT(summary["discrete_forces"]["most_touching"].get<int>(), 0);
  EXPECT_LE(std::abs(history_.last("balance_error_J")),
            0.04 * history_.number(0, "kinetic_J"));  // of first order in the step
}

// Springs and obstacles hold nodes that have no element, and blocks become empty.
TEST_F(Erosion, GoesOnWithPointMassesThatSpringsAndObstaclesHold) {
  folder_.write("obstacle.toml", R"(mesh = {generate = "bar", cells = [2, 2, 2]}
material = [{model = "stvk", young = 2e4, poisson = 0.3, density = 3740, where = "x < 0.1"},
            {model = "mooney-rivlin", c10 = 5190, bulk = 1.13e5, density = 2980, where = "x >= 0.1"}]
integrator = {step = 9e-4, end = 0.26}
[[obstacle]]
kind = "cylinder"
axis = [0, 1, 0]
radius = 0.05
point = [0.1, 0.02, -0.052]
velocity = [0, 0, 0.17]
times = [0, 0.05, 0.15]
factors = [0, 1, 2]
[[contact]]
friction = 0.7
[erosion]
max_stretch = 1.01
[output]
picture = false
)");
  folder_.write("springs.toml", R"(mesh = {generate = "ball", cells = 2}
material = [{model = "yeoh", c10 = 7930, bulk = 2.95e5, density = 1660, where = "z < 0"},
            {model = "stvk", young = 2e4, poisson = 0.3, density = 464, where = "z >= 0"}]
integrator = {step = 1e-4, end = 0.045}
[[initial]]
where = "all"
velocity = [-7, 7.5, 1.2]
[[spring]]
where = "z > 0.045"
stiffness = 4.1e4
[[rigid]]
where = "z > -0.0067"
[erosion]
max_stretch = 1.002
[output]
picture = false
)");
  for (const std::string scene : {"obstacle", "springs"}) {
    const Outcome outcome = call("run " + scene + ".toml --out " + scene + " --set monitor.on_violation=warn");
    EXPECT_LT(outcome.status, 2) << outcome.err;
    const Json summary = json(scene + "/summary.json");
    EXPECT_GT(summary["erosion"]["elements"].size(), 1u) << scene;
    EXPECT_NE(summary["exit_reason"], "failed") << outcome.err;
  }
}

// An element that inverts has no energy by this law: neither sums nor balance may keep that.
TEST_F(Erosion, KeepsTheEnergiesNumbersWhereElementsInvert) {
  folder_.write("scene.toml",
                R"(mesh = {generate = "bar", size = [0.2, 0.04, 0.04], cells = [5, 1, 1], element = "hex8"}
material = {model = "neo-hookean", young = 30e3, poisson = 0.3, density = 1000}
integrator = {method = "symplectic-euler", step = 1e-3, end = 0.1}
monitor = {on_violation = "warn"}
[[fix]]
where = "x < 1e-6"
[[move]]
where = "x > 0.2 - 1e-6"
velocity = [-8, 0, 0]
times = [0, 0.006, 0.0061]
factors = [1, 1, 0]
[erosion]
inverted = true
[output]
picture = false
)");
  call("run scene.toml --out r");
  ASSERT_GE(json("r/summary.json")["erosion"]["elements"].size(), 1u);
  const Table history = table("r/history.csv");
  for (std::size_t i = 0; i < history.rows.size(); ++i)
    for (const char* column : {"strain_J", "external_work_J", "balance_error_J", "dissipated_J"})
      EXPECT_TRUE(std::isfinite(history.number(i, column))) << column << " of row " << i;
}

TEST_F(Erosion, EndsWhereNothingIsLeftAndHasTheSameBitsForAnyNumberOfThreads) {
  const Outcome outcome = runScene(std::string(tiny) + "[erosion]\nmax_stretch = 1.0001\n",
                                   "--set integrator.end=0.5 --set erosion.every=50", 1);
  EXPECT_THAT(outcome.out, HasSubstr("every element that is left meets a criterion of [erosion] before step "));
  expectSameForAnyThreads(torn, "--set integrator.method=symplectic-euler --set integrator.step=auto");
  EXPECT_EQ(folder_.read("one/probes.csv"), folder_.read("three/probes.csv"));
  EXPECT_EQ(json("one/summary.json")["erosion"], json("three/summary.json")["erosion"]);
}

TEST_F(Erosion, IsRefusedWithWhatItDoesNotGoWith) {
  const auto refused = [&](const std::string& options, const std::string& what) {
    refuseScene(std::string(tiny) + "[erosion]\nmax_stretch = 1.5\n", what, options);
  };
  refused("--set erosion.max_stretch=1", "must be > 1");
  refused("--set erosion.least_step=-1", "must be > 0");
  refused("--set erosion.max_strech=2", "did you mean \"max_stretch\"?");
  refuseScene(std::string(tiny) + "[erosion]\nevery = 3\n", "[erosion]: there is no criterion; give inverted = true");
}

// All elements behind a plane go; their nodes are left on springs, h = 2 √(m/k), and no element proves more.
TEST_F(Erosion, InspectKnowsTheStepOfNodesWithoutElements) {
  folder_.write("scene.toml", R"(mesh = {generate = "bar", size = [0.2, 0.1, 0.1], cells = [2, 1, 1], element = "hex8"}
material = {model = "neo-hookean", young = 1e5, poisson = 0.3, density = 1000}
integrator = {method = "verlet", step = 1e-3, end = 0.01}
[[fix]]
where = "x < 0.11"
[[initial]]
where = "x > 0.19"
velocity = [5, 0, 0]
[[spring]]
where = "x > 0.15"
stiffness = 1e3
[erosion]
max_stretch = 1.01
[output]
every = 5e-3
picture = false
)");
  ASSERT_EQ(call("run scene.toml --out r").status, 0);
  ASSERT_GE(json("r/summary.json")["erosion"]["elements"].size(), 1u);
  const Json step = parse(call("inspect r --frame 3 --json -").out)["critical_step"];
  const double h = 2 * std::sqrt(1.0 / 8 / 1e3);
  EXPECT_NEAR(step["safe"].get<double>(), h, 1e-6 * h);
  EXPECT_NEAR(step["optimistic"].get<double>(), h, 1e-6 * h);
}

}  // namespace
}  // namespace ringwatch
