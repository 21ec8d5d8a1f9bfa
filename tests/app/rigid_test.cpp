// Runs with rigid bodies, and damping by node set.
#include <cmath>
#include <csignal>
#include <filesystem>
#include <numbers>
#include <string>

#include <ringwatch/meshes/mesh_io.h>

#include "program.h"

namespace ringwatch {
namespace {

using test::Json;
using test::Outcome;
using test::Program;
using ::testing::HasSubstr;

/// A bar with a rigid head at its end, held at the other.
constexpr const char* headed =
    R"(mesh = {generate = "bar", size = [0.12, 0.02, 0.02], cells = [12, 2, 2], element = "hex8"}
material = [{where = "x < 0.08", model = "stvk", young = 90e3, poisson = 0.3, density = 100},
            {where = "x > 0.08", model = "stvk", young = 90e9, poisson = 0.3, density = 8000}]
integrator = {method = "verlet", step = 2e-4, end = 0.2}
[[fix]]
where = "x < 1e-6"
[[rigid]]
name = "head"
where = "x > 0.08 - 1e-6"
[[probe]]
name = "head"
what = "centre"
rigid = "head"
[[probe]]
name = "turn"
what = "rotation"
rigid = "head"
[[probe]]
name = "pull"
what = "force"
rigid = "head"
[[probe]]
name = "twist"
what = "torque"
rigid = "head"
[[probe]]
name = "speed"
what = "centre_velocity"
rigid = "head"
[[probe]]
name = "spin"
what = "angular_velocity"
[output]
picture = false
)";

class Rigid : public Program {};

// A heavy head on a light bar: one mass on a spring along the bar. EA/L of uniaxial stress, with the stiffer ends where
// the bar cannot contract; the frequency lies between those of no and of full contraction, and is that of the static
// stiffness, which the run itself is asked for.
TEST_F(Rigid, SwingsAsAMassOnASpring) {
  runScene(std::string(headed) + "[[initial]]\nwhere = \"x > 0.08 - 1e-6\"\nvelocity = [0.02, 0, 0]\n",
           "--set material.0.poisson=0.0");
  const Json& summary = summary_;
  EXPECT_EQ(summary["verdict"], "certified");
  EXPECT_EQ(summary["rigid_bodies"][0]["name"], "head");
  const double head = 8000 * 0.04 * 4e-4, bar = 100 * 0.08 * 4e-4;
  EXPECT_NEAR(summary["rigid_bodies"][0]["mass"].get<double>(), head + 0.5 * bar / 8, 1e-12);
  // Without contraction the bar is a row of springs of 90e3 · 4e-4 / 0.08 N/m. A third of its mass swings along
  // (Rayleigh); of both the error is of the order of the square of the quotient of masses.
  const double stiffness = 90e3 * 4e-4 / 0.08, mass = head + bar / 3;
  const double period = 2 * std::numbers::pi * std::sqrt(mass / stiffness);
  const Table probes = table("r/probes.csv");
  const auto x = [&](std::size_t i) { return probes.number(i, "speed.centre_velocity_x_m/s"); };
  // The velocity is a cosine: its zeros are a quarter, and then halves, of a period apart.
  std::vector<double> zeros;
  for (std::size_t i = 1; i < probes.rows.size(); ++i)
    if (x(i - 1) * x(i) <= 0) {
      const double t = probes.number(i - 1, "time_s");
      zeros.push_back(t + 2e-4 * x(i - 1) / (x(i - 1) - x(i)));
    }
  ASSERT_GE(zeros.size(), 2u);
  EXPECT_NEAR(zeros[0], period / 4, 2e-3 * period);
  EXPECT_NEAR((zeros.back() - zeros[0]) / static_cast<double>(zeros.size() - 1), period / 2, 2e-3 * period);
  // Newton: the head's mass times the change of its velocity in a step of Verlet is the mean of the forces at its ends.
  const double own = summary["rigid_bodies"][0]["mass"];
  const auto force = [&](std::size_t i) { return probes.number(i, "pull.force_x_N"); };
  for (std::size_t i = 0; i + 1 < probes.rows.size(); ++i)
    EXPECT_NEAR(0.5 * (force(i) + force(i + 1)), own * (x(i + 1) - x(i)) / 2e-4, 1e-10);
  for (std::size_t i = 0; i < history_.rows.size(); ++i)
    EXPECT_LE(history_.number(i, "safe_s"), history_.number(i, "optimistic_s"));
  const double energy = history_.largest("kinetic_J");
  EXPECT_NEAR(energy, 0.5 * own * 4e-4, 1e-12 * energy);
  EXPECT_LT(history_.largest("balance_error_J"), 8e-4 * energy);
  // The steel of the head is rigid: the step is that of the bar, 30 times as long as that of elements of it.
  EXPECT_GT(summary["safe_seen"]["least"].get<double>(), 30 * 0.01 / std::sqrt(90e9 / 8000));
}

// A body on a hinge of springs at two of its corners swings as a compound pendulum.
TEST_F(Rigid, SwingsAsACompoundPendulum) {
  runScene(
      R"(mesh = {generate = "bar", size = [0.12, 0.02, 0.02], cells = [12, 2, 2], element = "hex8"}
material = {model = "stvk", young = 90e3, poisson = 0.3, density = 1000}
integrator = {method = "verlet", step = 1e-4, end = 1.2}
[[rigid]]
where = "x < 0.11 + 1e-6"
[[spring]]
where = "x < 1e-6 and abs(z - 0.01) < 1e-6"
stiffness = 2e4
[[force]]
where = "x > -1"
acceleration = [9.81, 0, 0]
[[initial]]
where = "x > -1"
angular_velocity = [0, 0.3, 0]
point = [0, 0, 0.01]
[[probe]]
name = "turn"
what = "rotation"
[[probe]]
name = "spin"
what = "angular_velocity"
[output]
picture = false
history_every = 10
)",
      "--set monitor.mode=threshold");
  // About the axis x = 0: a bar with a square section, J = m (l²/3 + d²/12), the last cell soft and along for the ride.
  const double l = 0.12, d = 0.02, m = 1, inertia = m * (l * l / 3 + d * d / 12);
  const double period = 2 * std::numbers::pi * std::sqrt(inertia / (m * 9.81 * l / 2));
  const Table probes = table("r/probes.csv");
  std::vector<double> zeros;
  const auto turn = [&](std::size_t i) { return probes.number(i, "turn.rotation_y_rad"); };
  for (std::size_t i = 2; i < probes.rows.size(); ++i)
    if (turn(i - 1) * turn(i) < 0)
      zeros.push_back(probes.number(i - 1, "time_s") + 1e-4 * turn(i - 1) / (turn(i - 1) - turn(i)));
  ASSERT_GE(zeros.size(), 3u);
  const double swing = (zeros.back() - zeros.front()) / static_cast<double>(zeros.size() - 1);
  EXPECT_NEAR(swing, period / 2, 0.01 * period);
  EXPECT_LT(std::abs(turn(0)), 1e-12);
}

TEST_F(Rigid, ResumesBitByBit) {
  folder_.write("scene.toml",
                std::string(headed) +
                    "checkpoint_every = 0.03\nevery = 0.04\n[[initial]]\nwhere = \"x > 0.08 - 1e-6\"\n"
                    "velocity = [0.1, 0.4, 0]\nangular_velocity = [9, 3, 5]\npoint = [0.1, 0.01, 0.01]\n");
  ASSERT_EQ(call("run scene.toml --out whole").status, 0);
  ASSERT_EQ(stopRun("", hasCheckpoint, "KILL").status, 128 + SIGKILL);
  ASSERT_EQ(call("run --resume part --threads 2").status, 0);
  for (const char* file : {"/history.csv", "/probes.csv", "/run.pvd"})
    EXPECT_EQ(folder_.read("whole" + std::string(file)), folder_.read("part" + std::string(file))) << file;
  for (const auto& entry : std::filesystem::directory_iterator(folder_.path() / "whole/frames")) {
    const std::string name = entry.path().filename().string();
    EXPECT_EQ(folder_.read("whole/frames/" + name), folder_.read("part/frames/" + name)) << name;
  }
  // The head keeps its shape in the frames.
  const NodeVectors X = readMesh(folder_.path() / "whole/frames/frame_000001.vtu").X;
  const Table probes = table("whole/probes.csv");
  EXPECT_GT(std::abs(probes.number(500, "turn.rotation_y_rad")), 0.05);
}

TEST_F(Rigid, FallsOnAnObstacleAndBounces) {
  runScene(std::string(headed) + R"([[obstacle]]
kind = "plane"
point = [0.1205, 0, 0]
normal = [-1, 0, 0]
[[contact]]
penalty = 200.0
[[initial]]
where = "x > 0.08 - 1e-6"
velocity = [0.1, 0, 0]
)");
  EXPECT_EQ(summary_["discrete_forces"]["most_touching"], 9);
  const Table probes = table("r/probes.csv");
  double least = 0;
  for (std::size_t i = 0; i < probes.rows.size(); ++i)
    least = std::min(least, probes.number(i, "speed.centre_velocity_x_m/s"));
  EXPECT_NEAR(least, -0.1, 1e-3);                        // thrown back long before the bar would pull it
  EXPECT_LT(history_.largest("balance_error_J"), 6e-7);  // of 6.4e-4 J
}

TEST_F(Rigid, RefusesWhatItDoesNotGoWith) {
  const std::string base(headed);
  const auto refused = [&](const std::string& text, const std::string& what) { refuseScene(text, what); };
  refused(base + "[[fix]]\nwhere = \"x > 0.12 - 1e-6\"\n",
          "rigid.where: 9 of its 45 nodes have a motion that a [[fix]] or [[move]] prescribes, the first is");
  refused(base + "[[rigid]]\nname = \"tip\"\nwhere = \"x > 0.11\"\n",
          "probe.rigid: there are several; name one of head, tip");
  std::string named = base;
  named.replace(named.find("what = \"angular_velocity\""), 25, "rigid = \"head\"\nwhat = \"angular_velocity\"");
  refused(named + "[[rigid]]\nwhere = \"x > 0.11\"\n", "rigid.where: 9 of its 9 nodes are of another [[rigid]]");
  refused(base + "[[rigid]]\nname = \"head\"\nwhere = \"x > 0.11\"\n", "\"head\" is the name of ");
  refused(named + "[[rigid]]\nwhere = \"x > 9\"\n", "selects no node");
  refused(named + "[[rigid]]\nwhere = \"abs(x - 0.04) < 1e-6 and y < 1e-6\"\n", "lie on a line");
  std::string whole = base;
  whole.replace(whole.find("x > 0.08 - 1e-6"), 15, "x > -1");
  whole.erase(whole.find("[[fix]]"), 27);
  refused(whole, "every element is within a rigid body");
  refused(base + "[[probe]]\nwhat = \"centre\"\nrigid = \"haed\"\n", "did you mean \"head\"?");
  refused(base + "[[probe]]\nwhat = \"displacement\"\nrigid = \"head\"\n", "\"displacement\" is of no rigid body");
  refused(base + "[[probe]]\nwhat = \"force\"\nwhere = \"x > 0\"\n", "\"force\" is of a rigid body; give rigid");
  refused(test::tiny + std::string("[[probe]]\nwhat = \"torque\"\n"), "\"torque\" is of a [[rigid]]; there is none");
}

/// The bar with the rigid head, and what holds or moves the head.
std::string guided(const std::string& section) {
  std::string scene(headed);
  scene.insert(scene.find("[output]"), section);
  return scene;
}

// Moved as a whole a rigid body is nodes that are moved, whose support is the sum of their reactions.
TEST_F(Rigid, MovedAsAWholeItIsNodesThatAreMoved) {
  const std::string motion =
      "velocity = [-0.1, 0.03, 0]\nangular_velocity = [2, 0, 1]\npoint = [0.1, 0, 0]\n"
      "times = [0, 0.1, 0.2]\nfactors = [0, 1, 0.5]\nramp = \"smooth\"\n";
  const std::string probes =
      "[[probe]]\nname = \"by\"\nwhat = \"support_force\"\n[[probe]]\nname = \"about\"\n"
      "what = \"support_torque\"\n[[probe]]\nname = \"nodes\"\nwhat = \"reaction\"\n"
      "where = \"x > 0.08 - 1e-6\"\n";
  folder_.write("rigid.toml", guided("[[move]]\nrigid = \"head\"\n" + motion + probes) + "reactions = true\n");
  std::string nodes(headed);
  nodes.erase(nodes.find("[[rigid]]"), nodes.find("[output]") - nodes.find("[[rigid]]"));
  folder_.write("nodes.toml", nodes + "[[move]]\nwhere = \"x > 0.08 - 1e-6\"\n" + motion);
  for (const char* name : {"rigid", "nodes"}) {
    const Outcome outcome = call(std::string("run ") + name + ".toml --out " + name);
    ASSERT_EQ(outcome.status, 0) << outcome.err << outcome.out;
  }
  const Json summary = json("rigid/summary.json");
  EXPECT_EQ(summary["rigid_bodies"][0]["name"], "head");
  EXPECT_EQ(summary["verdict"], "certified");
  EXPECT_TRUE(summary["notes"].empty()) << summary["notes"].dump();
  const Table a = table("rigid/history.csv"), b = table("nodes/history.csv"), values = table("rigid/probes.csv");
  ASSERT_EQ(a.rows.size(), b.rows.size());
  double work = 0, error = 0;
  for (std::size_t i = 0; i < a.rows.size(); ++i) {
    work = std::max(work, std::abs(a.number(i, "external_work_J")));
    error = std::max(error, std::abs(a.number(i, "balance_error_J")));
    EXPECT_NEAR(a.number(i, "safe_s"), b.number(i, "safe_s"), 0.02 * b.number(i, "safe_s"));
    EXPECT_NEAR(a.number(i, "strain_J"), b.number(i, "strain_J"), 1e-8 * work + 1e-15);
    EXPECT_NEAR(a.number(i, "external_work_J"), b.number(i, "external_work_J"), 1e-8 * work + 1e-15);
    for (const char* axis : {"x", "y", "z"}) {
      const double force = values.number(i, std::string("by.support_force_") + axis + "_N");
      EXPECT_NEAR(values.number(i, std::string("nodes.reaction_") + axis + "_N"), force, 3.6e-5);
      EXPECT_NEAR(values.number(i, std::string("move.0.reaction_") + axis + "_N"), force, 3.6e-5);
    }
  }
  EXPECT_LT(error, 1e-6 * work);
  EXPECT_NEAR(values.number(values.rows.size() - 1, "turn.rotation_x_rad"), 2 * (0.05 + 0.075), 2e-3);
}

// On an axle the head turns about it alone, and the bar twists it back and forth.
TEST_F(Rigid, TurnsOnAnAxle) {
  runScene(guided("[[fix]]\nrigid = \"head\"\nturns = true\naxis = [1, 0, 0]\npoint = [0, 0.012, 0.01]\n"
                  "[[probe]]\nname = \"hold\"\nwhat = \"support_force\"\n[[probe]]\nname = \"bend\"\n"
                  "what = \"support_torque\"\n[[initial]]\nwhere = \"x > 0.08 - 1e-6\"\n"
                  "angular_velocity = [4, 0, 0]\npoint = [0, 0.012, 0.01]\n") +
               "reactions = true\n",
           "--set integrator.end=1");
  EXPECT_EQ(summary_["verdict"], "certified");
  const Table values = table("r/probes.csv");
  const double mass = summary_["rigid_bodies"][0]["mass"];
  int back = 0;
  double holds = 0;
  for (std::size_t i = 0; i < values.rows.size(); ++i) {
    const auto at = [&](const char* column) { return values.number(i, column); };
    EXPECT_NEAR(at("head.centre_x_m"), values.number(0, "head.centre_x_m"), 1e-14);
    EXPECT_NEAR(std::hypot(at("head.centre_y_m") - 0.012, at("head.centre_z_m") - 0.01), 0.002, 1e-14);
    EXPECT_NEAR(at("turn.rotation_y_rad"), 0, 1e-12);
    EXPECT_NEAR(at("bend.support_torque_x_N m"), 0, 1e-12);
    if (i > 0) back += values.number(i - 1, "spin.angular_velocity_x_rad/s") * at("spin.angular_velocity_x_rad/s") < 0;
    EXPECT_NEAR(at("fix.1.reaction_y_N"), at("hold.support_force_y_N"), 1e-15);
    holds = std::max(holds, std::abs(at("hold.support_force_y_N")));
    EXPECT_LE(history_.number(i, "safe_s"), history_.number(i, "optimistic_s"));
  }
  EXPECT_GT(back, 2);
  // At the start it holds the centre on its circle, 2 mm around the point, as nothing is strained yet.
  EXPECT_NEAR(values.number(0, "hold.support_force_y_N"), 4 * 4 * mass * 0.002, 0.02 * 16 * mass * 0.002);
  EXPECT_GT(holds, 0);
  EXPECT_LT(history_.largest("balance_error_J"), 2e-4 * history_.largest("kinetic_J"));
}

// Pushed along x by a table, free across and to turn: work is counted, and a run that is stopped goes on bit by bit.
TEST_F(Rigid, PushedInOneDirectionItsWorkIsCounted) {
  folder_.write("scene.toml",
                guided("[[move]]\nrigid = \"head\"\nturns = true\ncomponents = \"x\"\ndisplacement = [-0.01, 0, 0]\n"
                       "factor = \"sin(2*pi*8*t)^2\"\n[[probe]]\nname = \"push\"\nwhat = \"support_force\"\n"
                       "[[force]]\nwhere = \"x > 0.08 - 1e-6\"\nacceleration = [3, 0, -9.81]\n") +
                    "reactions = true\ncheckpoint_every = 0.03\n");
  ASSERT_EQ(call("run scene.toml --out whole --set monitor.every=5").status, 0);
  const Table values = table("whole/probes.csv"), history = table("whole/history.csv");
  const double first = values.number(0, "head.centre_x_m"),
               mass = json("whole/summary.json")["rigid_bodies"][0]["mass"];
  double work = 0, error = 0, drop = 0;
  for (std::size_t i = 1; i + 1 < values.rows.size(); ++i) {  // at the start nothing moved before: half of it
    const double t = values.number(i, "time_s");
    EXPECT_NEAR(values.number(i, "head.centre_x_m") - first,
                -0.01 * std::pow(std::sin(2 * std::numbers::pi * 8 * t), 2), 3.2e-15);
    EXPECT_EQ(values.number(i, "push.support_force_y_N"), 0);
    EXPECT_EQ(values.number(i, "push.support_force_z_N"), 0);
    EXPECT_EQ(values.number(i, "move.0.reaction_x_N"), values.number(i, "push.support_force_x_N"));
    // Newton's second law along x, with the exact acceleration.
    const double w = 4 * std::numbers::pi * 8, a = -0.01 * 0.5 * w * w * std::cos(w * t);
    EXPECT_NEAR(values.number(i, "push.support_force_x_N") + values.number(i, "pull.force_x_N"), mass * a,
                1e-4 * mass * 0.005 * w * w);
    work = std::max(work, std::abs(history.number(i, "external_work_J")));
    error = std::max(error, std::abs(history.number(i, "balance_error_J")));
    drop = std::max(drop, std::abs(values.number(i, "turn.rotation_y_rad")));
  }
  EXPECT_GT(drop, 0.01);
  EXPECT_LT(error, 3.8e-5 * work);
  ASSERT_EQ(stopRun("--set monitor.every=5", hasCheckpoint, "KILL").status, 128 + SIGKILL);
  ASSERT_EQ(call("run --resume part --threads 2").status, 0);
  for (const char* file : {"/history.csv", "/probes.csv"})
    EXPECT_EQ(folder_.read("whole" + std::string(file)), folder_.read("part" + std::string(file))) << file;
}

// A body that is turned at a rate while gravity lets it fall, and one held against turning.
TEST_F(Rigid, TurnedAtARateWhileItFalls) {
  const std::string gravity = "[[force]]\nwhere = \"x > 0.08 - 1e-6\"\nacceleration = [0, 0, -9.81]\n";
  folder_.write("turned.toml", guided("[[move]]\nrigid = \"head\"\ncomponents = \"xy\"\n"
                                      "angular_velocity = [0, 0, 2]\n" +
                                      gravity));
  folder_.write("upright.toml", guided("[[fix]]\nrigid = \"head\"\ncomponents = \"xy\"\n" + gravity));
  for (const char* name : {"turned", "upright"}) {
    const Outcome outcome = call(std::string("run ") + name + ".toml --set integrator.end=0.1 --out " + name);
    ASSERT_EQ(outcome.status, 0) << outcome.err << outcome.out;
    const Table values = table(std::string(name) + "/probes.csv"), history = table(std::string(name) + "/history.csv");
    const std::size_t last = values.rows.size() - 1;
    EXPECT_NEAR(values.number(last, "turn.rotation_z_rad"), name[0] == 't' ? 2 * values.number(last, "time_s") : 0,
                1e-12);
    EXPECT_NEAR(values.number(last, "turn.rotation_y_rad"), 0, 1e-12);
    EXPECT_NEAR(values.number(last, "head.centre_x_m"), values.number(0, "head.centre_x_m"), 1e-14);
    EXPECT_LT(values.number(last, "head.centre_z_m"), values.number(0, "head.centre_z_m") - 1e-4);
    double energy = 0, error = 0;
    for (std::size_t i = 0; i < history.rows.size(); ++i) {
      energy = std::max(energy, history.number(i, "kinetic_J") + history.number(i, "strain_J"));
      error = std::max(error, std::abs(history.number(i, "balance_error_J")));
    }
    EXPECT_LT(error, 8.7e-6 * energy) << name;
  }
}

TEST_F(Rigid, RefusesGuidesThatDoNotFit) {
  const auto refused = [&](const std::string& section, const std::string& what) { refuseScene(guided(section), what); };
  refused("[[fix]]\nrigid = \"haed\"\n", "fix.rigid: no [[rigid]] is named \"haed\"; did you mean \"head\"?");
  refused("[[fix]]\nrigid = \"head\"\nwhere = \"x > 0\"\n", "fix.where: both where and rigid are given");
  refused("[[fix]]\nwhere = \"x > 0.115\"\nturns = true\n", "fix.turns: goes with rigid");
  refused("[[move]]\nwhere = \"x > 0.115\"\nvelocity = [1, 0, 0]\naxis = [1, 0, 0]\n", "move.axis: goes with rigid");
  refused("[[fix]]\nwhere = \"x > 0.115\"\npoint = [0, 0, 0]\n", "fix.point: goes with rigid and turns = true");
  refused("[[fix]]\nrigid = \"head\"\naxis = [1, 0, 0]\n", "fix.axis: goes with turns = true");
  refused("[[fix]]\nrigid = \"head\"\nturns = true\naxis = [0, 0, 0]\n", "fix.axis: has no direction");
  refused("[[fix]]\nrigid = \"head\"\npoint = [0, 0, 0]\n", "fix.point: goes with turns = true");
  refused("[[fix]]\nrigid = \"head\"\nturns = true\ncomponents = \"x\"\npoint = [0, 0, 0]\n",
          "fix.point: goes with all three components");
  refused("[[fix]]\nrigid = \"head\"\n[[move]]\nrigid = \"head\"\nvelocity = [1, 0, 0]\n",
          "move.rigid: \"head\" is held or moved by ");
  refused("[[move]]\nrigid = \"head\"\nangular_velocity = [1, 0, 0]\nturns = true\n",
          "move.turns: the body turns as angular_velocity says");
  refused("[[move]]\nrigid = \"head\"\nvelocity = [1, 0, 0]\nturns = true\npoint = [0, 0, 0]\n",
          "move.point: what turns about a moving point");
  refused("[[move]]\nrigid = \"head\"\n", "move.velocity: missing");
  refused("[[probe]]\nname = \"s\"\nwhat = \"support_force\"\n", "\"head\" is neither held nor moved");
  refuseScene(std::string(test::tiny) + "[[fix]]\nrigid = \"head\"\n", "names a [[rigid]]; there is none");
}

// Damping by node set: of all nodes it is Rayleigh's mass damping.
TEST_F(Rigid, MassDampingOfAllNodesIsRayleighs) {
  const std::string swing = std::string(test::tiny) +
                            "[[initial]]\nwhere = \"x > 0.02\"\nvelocity = [0, 0.2, 0]\n[[probe]]\nwhat = "
                            "\"displacement\"\nwhere = \"x > 0.1 - 1e-6\"\n";
  std::string free = swing;
  free.erase(free.find("[[move]]"), free.find("[output]") - free.find("[[move]]"));
  folder_.write("rayleigh.toml", free + "[damping]\nmass = 30.0\n");
  folder_.write("nodes.toml", free + "[[mass_damping]]\nwhere = \"x > -1\"\nrate = 30.0\n");
  folder_.write("half.toml", free + "[[mass_damping]]\nwhere = \"x > 0.05\"\nrate = 30.0\n");
  for (const char* name : {"rayleigh", "nodes", "half"})
    ASSERT_EQ(call(std::string("run ") + name + ".toml --out " + name).status, 0) << name;
  const Table a = table("rayleigh/probes.csv"), b = table("nodes/probes.csv"), c = table("half/probes.csv");
  const Table own = table("rayleigh/history.csv"), nodes = table("nodes/history.csv"), half = table("half/history.csv");
  double largest = 0;
  for (std::size_t i = 0; i < a.rows.size(); ++i) {
    const double y = a.number(i, "probe.0.displacement_y_m");
    largest = std::max(largest, std::abs(y));
    EXPECT_NEAR(b.number(i, "probe.0.displacement_y_m"), y, 1e-14);
    EXPECT_NEAR(nodes.number(i, "dissipated_J"), own.number(i, "dissipated_J"), 1e-15);
    // The exchange bound, which makes the other one tighter, knows no dashpots.
    EXPECT_NEAR(nodes.number(i, "safe_s"), own.number(i, "safe_s"), 0.15 * own.number(i, "safe_s"));
    EXPECT_LE(nodes.number(i, "safe_s"), nodes.number(i, "optimistic_s"));
  }
  EXPECT_GT(largest, 1e-3);
  const std::size_t last = a.rows.size() - 1;
  EXPECT_GT(half.number(last, "dissipated_J"), 0.3 * own.number(last, "dissipated_J"));
  EXPECT_LT(half.number(last, "dissipated_J"), own.number(last, "dissipated_J"));
  folder_.write("bad.toml",
                free + "[[mass_damping]]\nwhere = \"x > -1\"\nrate = 30.0\n[integrator]\nmethod = \"rk4\"\n");
  expectRefused("run half.toml --out bad --set integrator.method=rk4", "[[mass_damping]]");
}

}  // namespace
}  // namespace ringwatch
