// Springs, point masses, obstacles and contact in scenes, against analytic answers: restitution, work of moving walls,
// friction, damped oscillation; what governs, and what is refused.
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <ringwatch/app/command/schema.h>
#include <ringwatch/app/scene/scene.h>
#include <ringwatch/app/scene/scene_keys.h>
#include <ringwatch/base/error.h>
#include <ringwatch/body/discrete_forces.h>
#include <ringwatch/meshes/mesh_io.h>

#include "program.h"
#include "schema_check.h"

namespace ringwatch {
namespace {

using std::numbers::pi;
using test::Json;
using test::Outcome;
using test::Program;
using ::testing::HasSubstr;

/// A stiff cube of 1 kg, which a soft penalty sees as a rigid body: its own modes are a thousand times as fast as
/// contact.
constexpr const char* cube = R"(mesh = {generate = "bar", size = [0.1, 0.1, 0.1], cells = [1, 1, 1], element = "hex8"}
material = {model = "stvk", young = 1e7, poisson = 0.3, density = 1000}
integrator = {method = "verlet", step = 1e-4, end = 0.4}
[output]
picture = false
)";
constexpr double mass = 1, penalty = 100, stiffness = 4 * penalty;  // of the cube on its four lower nodes

class Contact : public Program {
 protected:
  void run(const std::string& more, const std::string& options = "") { runScene(cube + more, options); }
  void refuse(const std::string& more, const std::string& what, const std::string& options = "") {
    refuseScene(cube + more, what, options);
  }
};

constexpr const char* floor =
    "[[obstacle]]\nkind = \"plane\"\npoint = [0, 0, -0.001]\nnormal = [0, 0, 1]\nname = "
    "\"floor\"\n";
std::string falling(double speed) {
  return "[[initial]]\nwhere = \"all\"\nvelocity = [0, 0, " + test::digits(-speed) + "]\n";
}
std::string contact(const std::string& more = "") { return "[[contact]]\npenalty = 100\n" + more; }

// Half a period of √(stiffness/mass), without loss: the speed comes back, and the deepest point is v √(mass/stiffness).
TEST_F(Contact, ReturnsAllOfTheEnergy) {
  run(floor + falling(0.2) + contact());
  EXPECT_NEAR(history_.largest("kinetic_J"), 0.02, 1e-6);
  EXPECT_NEAR(history_.last("kinetic_J"), 0.02, 2e-6);
  EXPECT_LE(history_.largest("balance_error_J"), 2e-6);
  const Json found = summary_["discrete_forces"];
  EXPECT_EQ(found["contact_nodes"], 8);
  EXPECT_EQ(found["most_touching"], 4);
  EXPECT_NEAR(found["deepest"]["depth"].get<double>(), 0.2 * std::sqrt(mass / stiffness), 1e-5);
  EXPECT_EQ(found["deepest"]["obstacle"], "floor");
  EXPECT_EQ(found["governed_observations"], 0);
  EXPECT_EQ(summary_["verdict"], "certified");
}

// The same bounce on every kind: on a flat end, and on round ones so large that four corners touch at once.
TEST_F(Contact, ReturnsAllOfTheEnergyOfEveryKind) {
  constexpr double loss = 2e-6;
  for (const char* obstacle :
       {"kind = \"box\"\npoint = [0.05, 0.05, -0.101]\nsize = [1, 1, 0.2]\n",
        "kind = \"sphere\"\npoint = [0.05, 0.05, -100.001]\nradius = 100\n",
        "kind = \"sphere\"\nhollow = true\npoint = [0.05, 0.05, 99.99]\nradius = 100\n",
        "kind = \"cylinder\"\npoint = [0.05, 0.05, -0.101]\naxis = [0, 0, 3]\nradius = 0.2\nlength = 0.2\n",
        "kind = \"cylinder\"\npoint = [0.05, 0, -100.001]\naxis = [0, 1, 0]\nradius = 100\n",
        "kind = \"cylinder\"\nhollow = true\npoint = [0.05, 0, 99.99]\naxis = [0, 1, 0]\nradius = 100\n"}) {
    SCOPED_TRACE(obstacle);
    run(std::string("[[obstacle]]\n") + obstacle + falling(0.2) + contact());
    EXPECT_NEAR(history_.last("kinetic_J"), 0.02, loss);
    EXPECT_LE(history_.largest("balance_error_J"), loss);
    const Json found = summary_["discrete_forces"];
    EXPECT_EQ(found["most_touching"], 4);
    EXPECT_NEAR(found["deepest"]["depth"].get<double>(), 0.2 * std::sqrt(mass / stiffness), 1e-5);
    EXPECT_EQ(found["deepest"]["obstacle"], "obstacle 0");
  }
}

// ẍ + 2 ζ ω ẋ + ω² x = 0 while it touches: e = exp(-π ζ/√(1 - ζ²)) when it leaves at x = 0. A node has an eighth of the
// mass and a quarter of the stiffness: the cube's ζ is the nodes' over √2.
TEST_F(Contact, HasTheRestitutionOfItsDamping) {
  double before = 0;
  for (const double step : {2e-4, 1e-4}) {
    run(floor + falling(0.2) + contact("damping = 0.2\n"), "--set integrator.step=" + test::digits(step));
    const double zeta = 0.2 / std::sqrt(2.0), e = std::exp(-pi * zeta / std::sqrt(1 - zeta * zeta));
    const double found = std::sqrt(history_.last("kinetic_J") / 0.02), error = std::abs(found - e);
    EXPECT_LT(error, 1.8e-3) << step;
    if (before > 0) {
      EXPECT_LT(error, 0.7 * before);  // the damping lags: of order one
    }
    before = error;
    EXPECT_NEAR(history_.last("dissipated_J"), 0.02 * (1 - e * e), 1e-4);
    EXPECT_EQ(summary_["verdict"], "certified");
  }
}

// A wall at speed V sends a cube at rest away at 2 V, and does the work M (2V)²/2.
TEST_F(Contact, MovingObstaclesDoWork) {
  run("[[obstacle]]\nkind = \"plane\"\npoint = [-0.001, 0, 0]\nnormal = [1, 0, 0]\nvelocity = [0.1, 0, 0]\n" +
      contact());
  EXPECT_NEAR(history_.last("kinetic_J"), 0.02, 4e-6);
  EXPECT_NEAR(history_.last("external_work_J"), 0.02, 4e-6);
  EXPECT_LE(history_.largest("balance_error_J"), 4e-6);
  // The same wall, whose speed comes as a table.
  run("[[obstacle]]\nkind = \"plane\"\npoint = [-0.001, 0, 0]\nnormal = [1, 0, 0]\nvelocity = [0.2, 0, 0]\n"
      "times = [0, 1]\nfactors = [0.5, 0.5]\n" +
      contact());
  EXPECT_NEAR(history_.last("kinetic_J"), 0.02, 4e-6);
}

// With its own penalty alone the force of the floor is N(t) and friction μ N(t), so ẍ = -μ (z̈ + g) whatever the cube
// does: x = v t - μ (z + g t²/2) at any time, and central differences follow that without error.
TEST_F(Contact, FrictionFollowsCoulombsLaw) {
  const double mu = 0.2, g = 10, speed = 1, t = 0.3;
  run("[[obstacle]]\nkind = \"plane\"\nnormal = [0, 0, 1]\n[[force]]\nwhere = \"all\"\nacceleration = [0, 0, -10]\n"
      "[[initial]]\nwhere = \"all\"\nvelocity = [1, 0, 0]\n" +
          contact("friction = 0.2\nslip = 0.01\n"),
      "--set integrator.end=0.3 --set output.every=0.3 --set contact.0.penalty=2000");
  const MeshState end = lastFrame();
  const Eigen::Vector3d moved = (end.x - end.mesh.X).rowwise().mean();
  const double expected = speed * t - mu * (moved[2] + 0.5 * g * t * t);
  EXPECT_NEAR(moved[0], expected, 6e-8 * mu * g * t * t);
  EXPECT_LE(history_.largest("balance_error_J"), 0.01);
  const Json summary = summary_;
  const Json& notes = summary["notes"];
  EXPECT_GT(summary["discrete_forces"]["deepest"]["depth"].get<double>(), 1e-3);
  bool told = false;
  for (const Json& note : notes) told = told || note.get<std::string>().find("friction: while surfaces slide") == 0;
  EXPECT_TRUE(told);
}

// Friction is of the elastic part of the floor's force. A cube that falls on a damped floor and comes to rest on it at
// the depth d = m g/k has got c d of its momentum from dampers, which friction does not count: it slides at v - μ (g t
// - c d/m).
TEST_F(Contact, FrictionCountsNoDampers) {
  const double mu = 0.2, g = 10, speed = 1, t = 0.3, k = 4 * 2000, c = 4 * 2 * 0.5 * std::sqrt(2000 * mass / 8);
  run(std::string(floor) +
          "[[force]]\nwhere = \"all\"\nacceleration = [0, 0, -10]\n[[initial]]\nwhere = \"all\"\nvelocity = [1, 0, "
          "0]\n" +
          contact("damping = 0.5\nfriction = 0.2\nslip = 0.01\n"),
      "--set integrator.end=0.3 --set contact.0.penalty=2000");
  const double expected = speed - mu * (g * t - c * (mass * g / k) / mass);
  EXPECT_NEAR(std::sqrt(2 * history_.last("kinetic_J")), expected, 2e-3 * expected);
  EXPECT_LE(history_.largest("balance_error_J"), 0.01);
}

// A cube between springs: x(t) = x0 e^(-ζωt) cos …, with its mass doubled by point masses.
TEST_F(Contact, SpringsAndPointMassesOscillate) {
  const double k = 8 * 50, c = 8 * 0.5, m = 2, v = 0.2;
  run("[[spring]]\nwhere = \"all\"\nstiffness = 50\ndamping = 0.5\n[[mass]]\nwhere = \"all\"\nmass = 1\n" + falling(v));
  const double omega = std::sqrt(k / m), zeta = c / (2 * std::sqrt(k * m)), damped = omega * std::sqrt(1 - zeta * zeta);
  EXPECT_NEAR(summary_["mass"].get<double>(), m, 1e-12);
  int compared = 0;
  for (std::size_t i = 0; i < history_.rows.size(); i += 500) {
    const double t = history_.number(i, "time_s"), decay = v * std::exp(-zeta * omega * t);
    const double speed = decay * (std::cos(damped * t) - zeta * omega / damped * std::sin(damped * t));
    EXPECT_NEAR(history_.number(i, "kinetic_J"), 0.5 * m * speed * speed, 3e-5) << t;
    ++compared;
  }
  EXPECT_EQ(compared, 8);
  EXPECT_EQ(summary_["discrete_forces"]["springs"], 8);
}

constexpr const char* block = R"(mesh = {generate = "bar", size = [0.04, 0.04, 0.04], cells = [4, 4, 4], jitter = 0.1}
material = {model = "neo-hookean", young = 1e5, poisson = 0.4, density = 1000}
integrator = {step = 1e-4, end = 0.02}
monitor = {on_violation = "warn"}
[[obstacle]]
kind = "plane"
point = [0, 0, -0.001]
normal = [0, 0, 1]
[[initial]]
where = "all"
velocity = [0, 0, -0.5]
[output]
picture = false
)";

// A node alone stays in contact for 20 steps: k = m (π/20h)².
TEST_F(Contact, APenaltyMadeForTheStepLeavesIt) {
  runScene(std::string(block) + "[[contact]]\n");
  const Json summary = summary_;
  EXPECT_EQ(summary["verdict"], "certified");
  EXPECT_EQ(summary["certified_steps"], summary["steps"]);
  EXPECT_GT(summary["discrete_forces"]["most_touching"].get<int>(), 20);
  EXPECT_LE(history_.largest("balance_error_J"), 0.04 * history_.number(0, "kinetic_J"));
  // For a step twice as large it is a quarter of that.
  const auto penalty = [&](const std::string& options) {
    const Outcome again = call("run scene.toml --out again --set integrator.end=1e-3 " + options);
    EXPECT_EQ(again.status, 0) << again.out << again.err;
    return json("again/summary.json")["discrete_forces"]["penalty"];
  };
  const double slow = pi / (20 * 1e-4), least = summary["discrete_forces"]["penalty"]["least"].get<double>();
  const Json twice = penalty("--set contact.0.step=2e-4");
  EXPECT_NEAR(twice["least"].get<double>(), least / 4, 1e-12 * least);
  std::vector<std::string> notes;
  const Scene scene = readScene(folder_.path() / "scene.toml");
  const Body body = sceneBody(scene, sceneMesh(scene, notes), 1);
  const PenaltyContact& surface = body.discreteForces()->contacts().front();
  EXPECT_GT(surface.nodes.size(), 90U);
  for (std::size_t k = 0; k < surface.nodes.size(); ++k) {
    const double expected = body.lumpedMass()[surface.nodes[k]] * slow * slow;
    EXPECT_NEAR(surface.penalty[k], expected, 1e-14 * expected) << k;
  }
  // Near the step that the elements alone prove the room decides, and damping takes its part of it.
  const Outcome refused = call("run scene.toml --out refused --set contact.0.step=1e-2");
  std::smatch alone;
  ASSERT_TRUE(std::regex_search(refused.err, alone, std::regex("prove steps up to ([0-9.e-]+) s"))) << refused.err;
  const std::string near = "--set contact.0.step=" + test::digits(0.999 * std::stod(alone[1]));
  const double free = penalty(near)["least"].get<double>();
  EXPECT_LT(free,
            0.2 * penalty("--set contact.0.step=" + test::digits(0.9 * std::stod(alone[1])))["least"].get<double>());
  EXPECT_LT(penalty(near + " --set contact.0.damping=0.2")["least"].get<double>(), 0.9 * free);
}

// With step "auto" the penalty is made for the safe step of the elements alone, and leaves it.
TEST_F(Contact, StepAndPenaltyAutoGoTogether) {
  const std::string follow = "--set integrator.step=auto";
  runScene(std::string(block) + "[[contact]]\ndamping = 0.1\nfriction = 0.3\n", follow);
  const Json with = summary_;
  runScene(std::string(block).substr(0, std::string(block).find("[[obstacle]]")) +
               "[[initial]]\nwhere = \"all\"\nvelocity = [0, 0, -0.5]\n[output]\npicture = false\n",
           follow, 0, "free");
  const Json without = summary_;
  EXPECT_EQ(with["verdict"], "certified");
  EXPECT_GT(with["discrete_forces"]["most_touching"].get<int>(), 20);
  // A node alone for twenty of these steps.
  const double slow = pi / (20 * without["largest_step"].get<double>());
  std::vector<std::string> notes;
  const Scene scene = readScene(folder_.path() / "scene.toml");
  const Body body = sceneBody(scene, sceneMesh(scene, notes), 1);
  const double least = body.lumpedMass().minCoeff() * slow * slow;
  EXPECT_NEAR(with["discrete_forces"]["penalty"]["least"].get<double>(), least, 0.3 * least);
  EXPECT_LT(with["steps"].get<int>(), 1.3 * without["steps"].get<int>());
}

// The same body in metres and kilograms and in millimetres and tonnes takes the same steps, friction and all.
TEST_F(Contact, NoDefaultHasADimension) {
  const std::set<std::string> numbers{"", "degrees", "steps", "edge lengths"};
  for (const SceneKey& key : sceneKeys())
    if (!numbers.contains(key.unit) && key.section != "mesh") {
      EXPECT_EQ(key.fallback.find_first_of("123456789"), std::string::npos) << key.section << "." << key.key;
    }
  const std::string of =
      "[mesh]\ngenerate = \"bar\"\nsize = [LLL, LLL, LLL]\ncells = [3, 3, 3]\n[material]\n"
      "model = \"neo-hookean\"\nyoung = EEE\npoisson = 0.3\ndensity = RRR\n[integrator]\n"
      "step = \"auto\"\nend = 1e-4\n[[obstacle]]\nkind = \"plane\"\npoint = [0, 0, PPP]\n"
      "normal = [0, 0, 1]\n[[initial]]\nwhere = \"all\"\nvelocity = [VVV, 0, -VVV]\n[[contact]]\n"
      "friction = 0.3\ndamping = 0.1\n[output]\npicture = false\n";
  std::vector<Json> found;
  for (const auto& values :
       {std::map<std::string, std::string>{
            {"LLL", "0.03"}, {"EEE", "2.1e11"}, {"RRR", "7850"}, {"PPP", "-1e-5"}, {"VVV", "2.0"}},
        {{"LLL", "30.0"}, {"EEE", "2.1e5"}, {"RRR", "7.85e-9"}, {"PPP", "-1e-2"}, {"VVV", "2e3"}}}) {
    std::string text = of;
    for (const auto& [name, value] : values)
      for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name)) text.replace(at, 3, value);
    runScene(text);
    found.push_back(summary_);
  }
  EXPECT_GT(found[0]["discrete_forces"]["most_touching"].get<int>(), 10);
  EXPECT_EQ(found[0]["steps"], found[1]["steps"]);
  EXPECT_NEAR(1000 * found[0]["discrete_forces"]["deepest"]["depth"].get<double>(),
              found[1]["discrete_forces"]["deepest"]["depth"].get<double>(),
              1e-6 * found[1]["discrete_forces"]["deepest"]["depth"].get<double>());
}

TEST_F(Contact, SaysWhenContactGovernsAndWhichPenaltyWouldNot) {
  EXPECT_THAT(runScene(std::string(block) + "[[contact]]\npenalty = 1e5\n", "", 1).out,
              HasSubstr("springs or contact govern"));
  const Json& summary = summary_;
  const Json& found = summary["discrete_forces"];
  EXPECT_GT(found["governed_observations"].get<int>(), 0);
  ASSERT_FALSE(summary["first_violated"].is_null());
  bool named = false;
  for (const Json& event : summary["events"])
    if (event["kind"] == "violated")
      named = named || event["text"].get<std::string>().find("springs or contact govern it, most at tet4 element ") !=
                           std::string::npos;
  EXPECT_TRUE(named) << summary["events"];
  // Named before the energy shows it.
  if (!summary["energy_runaway"].is_null()) {
    EXPECT_LT(summary["first_violated"]["step"].get<int>(), summary["energy_runaway"]["step"].get<int>());
  }
  // With the penalty that it names the step is proven.
  const double room = found["room"]["penalty"].get<double>();
  ASSERT_GT(room, 0);
  const Outcome again = call("run scene.toml --out again --set contact.0.penalty=" + test::digits(room));
  EXPECT_EQ(again.status, 0) << again.out << again.err;
  EXPECT_EQ(json("again/summary.json")["discrete_forces"]["governed_observations"], 0);
}

// A bar of thin slices of hex8, held but along x, that runs into a wall: with a spring k at the nodes of its end its
// highest mode decays into it, u_i = (-q)^i, and λ = (2d/m)(1 + √(1 + (k/d)²)) for its chain of masses m and springs d.
TEST_F(Contact, ABarAgainstAPenaltyHasTheStepOfItsClosedForm) {
  constexpr const char* bar =
      R"(mesh = {generate = "bar", size = [0.04, 0.01, 0.01], cells = [40, 1, 1], element = "hex8"}
material = {model = "linear", young = 30e3, poisson = 0, density = 1000}
integrator = {step = 1e-5, end = 2e-3}
[[fix]]
where = "all"
components = "yz"
[output]
every = 1e-3
picture = false
)";
  const double d = 30e3 * 1e-4 / 4 / 1e-3, m = 1000 * 1e-4 * 1e-3 / 4;  // of a node
  for (const double ratio : {1.0, 3.0}) {
    const double k = ratio * d, expected = 2 / std::sqrt(2 * d / m * (1 + std::sqrt(1 + ratio * ratio)));
    const std::string stiffness = test::digits(k);
    folder_.write("spring.toml",
                  bar + ("[[spring]]\nwhere = \"x > 0.0395\"\ndirection = [2, 0, 0]\nstiffness = " + stiffness + "\n"));
    folder_.write("wall.toml", bar + ("[[obstacle]]\nkind = \"plane\"\npoint = [0.0401, 0, 0]\nnormal = [-1, 0, 0]\n"
                                      "[[initial]]\nwhere = \"all\"\nvelocity = [0.2, 0, 0]\n"
                                      "[[contact]]\nwhere = \"x > 0.0395\"\npenalty = " +
                                      stiffness + "\n"));
    for (const char* name : {"spring", "wall"}) {
      const Outcome outcome = call(std::string("run ") + name + ".toml --out " + name);
      ASSERT_EQ(outcome.status, 0) << outcome.out << outcome.err;
      const Outcome found = call(std::string("inspect ") + name + " --frame 3 --global --json -");
      ASSERT_EQ(found.status, 0) << found.err;
      const Json step = parse(found.out)["critical_step"];
      EXPECT_NEAR(step["global"].get<double>(), expected, 1e-8 * expected) << name << ratio;
      EXPECT_LE(step["safe"].get<double>(), expected * (1 + 1e-9));
      EXPECT_GE(step["optimistic"].get<double>(), expected * (1 - 1e-9));
      EXPECT_GE(step["safe"].get<double>(), 0.94 * expected);
    }
    // Before it touches, the wall is nothing.
    const Json before = parse(call("inspect wall --frame 1 --global --json -").out)["critical_step"];
    EXPECT_NEAR(before["global"].get<double>(), std::sqrt(m / d), 1e-8 * std::sqrt(m / d));
  }
}

// Both sides hold at every frame, whatever touches there, against the exact eigenvalue.
TEST_F(Contact, TheBracketHoldsWhileNodesTouchAndLeave) {
  folder_.write("scene.toml",
                std::string(block) +
                    "every = 1e-3\n[[contact]]\npenalty = 300\ndamping = 0.2\n[[obstacle]]\nkind = \"cylinder\"\n"
                    "axis = [0, 1, 0]\npoint = [0.02, 0, 0.055]\nradius = 0.01\nvelocity = [0, 0, -1.2]\n"
                    "[[spring]]\nset = \"x-min\"\nto_set = \"x-max\"\nstiffness = 2\ndamping = 1e-3\n");
  const Outcome outcome = call("run scene.toml --out r");
  ASSERT_NE(outcome.status, 2) << outcome.err;
  const Table history = table("r/history.csv");
  constexpr double rounding = 1e-9;
  std::set<double> exact;
  int compared = 0;
  for (std::size_t row = 0; row < history.rows.size(); row += 10) {
    const auto frame = std::to_string(row / 10 + 1);
    const Outcome found = call("inspect r --global --json - --frame " + frame);
    ASSERT_EQ(found.status, 0) << found.err;
    const Json inspected = parse(found.out);
    ASSERT_NEAR(inspected["state"]["time"].get<double>(), history.number(row, "time_s"), 1e-12);
    const double global = inspected["critical_step"]["global"].get<double>();
    ASSERT_LE(history.number(row, "safe_s"), global * (1 + rounding)) << frame;
    ASSERT_GE(history.number(row, "optimistic_s"), global * (1 - rounding)) << frame;
    exact.insert(global);
    ++compared;
  }
  EXPECT_EQ(compared, 20);
  EXPECT_GT(exact.size(), 15U);
  EXPECT_GT(json("r/summary.json")["discrete_forces"]["most_touching"].get<int>(), 20);
}

// Each example is certified, and with a penalty that is too stiff it is violated, by contact, before its energies tell.
TEST_F(Contact, ExamplesThatBlowUpAreNamedBeforeTheirEnergies) {
  struct Example {
    const char *name, *stiff;
    int touching;  // nodes, more at the most; a ring touches the floor with two rows
  };
  for (const auto& [name, key, touching] :
       {Example{"rubber_block", "contact.0.penalty=3e6", 20}, Example{"pressed_block", "contact.1.penalty=2e5", 20},
        Example{"hammered_bar", "contact.0.penalty=1e6", 20}, Example{"rolling_ring", "contact.0.penalty=4e6", 5},
        Example{"pressed_gear", "contact.1.penalty=2e6", 15}, Example{"punched_block", "contact.0.penalty=3e5", 40}}) {
    SCOPED_TRACE(name);
    const std::string run = "run '" RINGWATCH_EXAMPLES "/" + std::string(name) + ".toml' --quiet --out ";
    ASSERT_EQ(call(run + name).status, 0);
    const Json good = json(std::string(name) + "/summary.json");
    EXPECT_EQ(good["verdict"], "certified");
    EXPECT_GT(good["discrete_forces"]["most_touching"].get<int>(), touching);
    ASSERT_EQ(call(run + "stiff --set monitor.budget=100 --set " + key).status, 1);
    const Json bad = json("stiff/summary.json");
    ASSERT_FALSE(bad["first_violated"].is_null());
    const int violated = bad["first_violated"]["step"].get<int>();
    EXPECT_GT(violated, 0);
    ASSERT_FALSE(bad["energy_runaway"].is_null());
    EXPECT_LT(violated, bad["energy_runaway"]["step"].get<int>());
    // With a tenth of a step to spend it is said at the same step as without a limit, as measured.
    ASSERT_EQ(call(run + "sparing --set monitor.budget=0.1 --set " + key).status, 1);
    const Json sparing = json("sparing/summary.json");
    ASSERT_FALSE(sparing["first_violated"].is_null());
    EXPECT_EQ(sparing["first_violated"]["step"].get<int>(), violated);
    const Json& events = bad["events"];
    EXPECT_EQ(events[0]["kind"], "violated");
    EXPECT_THAT(events[0]["text"].get<std::string>(), HasSubstr("springs or contact govern it, most at "));
    int off = 0;
    for (const Json& event : events) {
      if (event["kind"] != "energy-balance") continue;
      ++off;
      EXPECT_LT(violated, event["step"].get<int>());
    }
    EXPECT_GT(off, 0);
  }
}

TEST_F(Contact, IsTheSameForAnyNumberOfThreads) {
  expectSameForAnyThreads(std::string(block) +
                          "[[contact]]\ndamping = 0.1\n[[spring]]\nwhere = \"z > 0.039\"\n"
                          "to_where = \"z < 0.021\"\nstiffness = 1\ndamping = 0.001\n");
}

TEST_F(Contact, ResumedRunsHaveTheBitsOfTheOneThatWasNotStopped) {
  expectSameWhenKilled(std::string(block) +
                           "checkpoint_every = 1e-3\n[[contact]]\ndamping = 0.1\nfriction = 0.3\n[[obstacle]]\n"
                           "kind = \"sphere\"\npoint = [0.02, 0.02, 0.062]\nradius = 0.02\nvelocity = [0, 0, -0.3]\n",
                       "--set integrator.end=0.05");
  EXPECT_GT(summary_["discrete_forces"]["most_touching"].get<int>(), 0);
}

TEST_F(Contact, RefusesWhatCannotBe) {
  refuse("[[contact]]\n", "[[contact]]: there is no [[obstacle]] to touch; give one, with its kind");
  refuse(floor, "there is no [[contact]] with it; give one, which may be empty for the surface");
  refuse(std::string(floor) + contact("obstacle = \"flor\"\n"),
         "contact.obstacle: no [[obstacle]] is named \"flor\"; did you mean \"floor\"? the scene has floor");
  refuse("[[obstacle]]\nkind = \"cube\"\n" + contact(), "obstacle.kind: unknown \"cube\"");
  refuse("[[obstacle]]\nkind = \"plan\"\n" + contact(), "obstacle.kind: unknown \"plan\"; did you mean \"plane\"?");
  refuse("[[obstacle]]\nkind = \"sphere\"\n" + contact(), "obstacle.radius: missing; a sphere needs it");
  refuse("[[obstacle]]\nkind = \"sphere\"\nradius = 1\nnormal = [0, 0, 1]\n" + contact(),
         "obstacle.normal: is no parameter of a sphere; it takes point, radius, hollow");
  refuse("[[obstacle]]\nkind = \"plane\"\nnormal = [0, 0, 0]\n" + contact(),
         "[[obstacle]]: normal = [0, 0, 0]: must be finite and not zero");
  refuse("[[obstacle]]\nkind = \"plane\"\npoint = [0, 0, 0.02]\nnormal = [0, 0, 1]\n" + contact(),
         "[[obstacle]]: \"obstacle 0\" begins inside the body: node 0 at (0, 0, 0) is 0.02 m deep in it, the deepest "
         "of 4; "
         "move it, or leave the nodes out of [[contact]]");
  // Each kind names the deepest node; a ball within the body holds none of the surface.
  refuse("[[obstacle]]\nkind = \"sphere\"\npoint = [0.1, 0, 0.01]\nradius = 0.03\nname = \"ball\"\n" + contact(),
         "\"ball\" begins inside the body: node 1 at (0.1, 0, 0) is 0.02 m deep in it, the deepest of 1;");
  refuse("[[obstacle]]\nkind = \"box\"\npoint = [0, 0.1, 0.11]\nsize = [0.02, 0.03, 0.04]\n" + contact(),
         "node 6 at (0, 0.1, 0.1) is 0.01 m deep in it, the deepest of 1;");
  refuse("[[obstacle]]\nkind = \"cylinder\"\npoint = [0, 0.01, 0]\naxis = [1, 0, 0]\nradius = 0.03\n" + contact(),
         "node 0 at (0, 0, 0) is 0.02 m deep in it, the deepest of 2;");
  refuse("[[obstacle]]\nkind = \"sphere\"\npoint = [0.05, 0.05, 0.05]\nradius = 0.01\n" + contact(),
         "node 13 at (0.05, 0.05, 0.05) is 0.01 m deep in it, the deepest of 1;", "--set \"mesh.cells=[2, 2, 2]\"");
  refuse("[[obstacle]]\nkind = \"sphere\"\nhollow = true\nradius = 0.1\n" + contact("where = \"x > 0.09\"\n"),
         "node 7 at (0.1, 0.1, 0.1) is 0.07321 m deep in it, the deepest of 3;");
  refuse(std::string(floor) + floor + contact(), "obstacle.name: \"floor\" is the name of ");
  refuse("[[obstacle]]\nkind = \"cylinder\"\naxis = [0, 0, 1]\nradius = 1\nlength = 1\nhollow = true\n" + contact(),
         "length: a hollow cylinder has no ends; take one of the two out");
  refuse(std::string(floor) + "ramp = \"smooth\"\n" + contact(), "obstacle.ramp: there is no table");
  refuse(std::string(floor) + "times = [0, 0]\nfactors = [0, 1]\n" + contact(), "obstacle.times: ");
  refuse(std::string(floor) + contact("where = \"x > 5\"\n"), "\"x > 5\" selects no node");
  refuse(std::string(floor) + contact("where = \"all\"\nset = \"x-min\"\n"),
         "contact.where: both where and set are given; give one of them");
  refuse("[[spring]]\nwhere = \"x > 5\"\nstiffness = 1\n", "spring.where: \"x > 5\" selects no node");
  refuse("[[spring]]\nwhere = \"all\"\nto_where = \"x > 5\"\nstiffness = 1\n",
         "spring.to_where: \"x > 5\" selects no node");
  refuse("[[spring]]\nwhere = \"all\"\nto_where = \"all\"\nto_set = \"x-min\"\nstiffness = 1\n",
         "spring.to_where: both to_where and to_set are given; give one of them");
  refuse("[[spring]]\nset = \"x-mni\"\nstiffness = 1\n", "did you mean \"x-min\"?");
  refuse("[[spring]]\nwhere = \"all\"\nstiffness = 1\ndirection = [0, 0, 0]\n",
         "spring.direction: [0, 0, 0] is no direction");
  refuse("[[mass]]\nwhere = \"x > 5\"\nmass = 1\n", "mass.where: \"x > 5\" selects no node");
  refuse(std::string(floor) + "[[contact]]\n[[spring]]\nset = \"top\"\nstiffness = 1\n", "unknown node set \"top\"");
  refuse(std::string(floor) + "[[contact]]\nstep = 1e-2\n",
         "\"auto\" has no room: the elements alone prove steps up to");
  refuse(std::string(floor) + "[[contact]]\npenalty = -1\n", "contact.penalty: -1 is out of range; must be > 0 N/m");
  refuse(std::string(floor) + contact("step = 1e-4\n"),
         "contact.step: is what penalty = \"auto\" is made of; take one of them out");
  refuse("[[spring]]\nwhere = \"all\"\n", "spring.stiffness: missing; give a number in N/m");
  refuse("[[spring]]\nwhere = \"all\"\nstiffness = 1\nlength = 0.1\n",
         "spring.length: a spring to the ground is at rest where its node is; give to_where or to_set, or take it out");
  refuse("[[spring]]\nwhere = \"all\"\nstiffness = 1\nto_where = \"all\"\ndirection = [1, 0, 0]\n",
         "spring.direction: a spring between two nodes acts along their line");
  refuse("[[mass]]\nwhere = \"all\"\nmass = 0\n", "mass.mass: 0 is out of range; must be > 0 kg");
}

/// A key of a scene as it ought to be refused, apart from the program's own table.
struct Key {
  std::string section, key, type, range, unit;
};
const std::vector<Key>& newKeys() {
  static const std::string number = "a number", vector = "a list of three numbers", text = "a text";
  static const std::vector<Key> keys{
      {"pressure", "where", text, "", ""},
      {"pressure", "set", text, "", ""},
      {"pressure", "pressure", number, "", "Pa"},
      {"pressure", "times", "a list of numbers", "", "s"},
      {"pressure", "factors", "a list of numbers", "", ""},
      {"pressure", "ramp", text, "", ""},
      {"pressure", "factor", text, "", ""},
      {"mass", "where", text, "", ""},
      {"mass", "set", text, "", ""},
      {"mass", "mass", number, "> 0", "kg"},
      {"mass", "nodal_mass", number, "> 0", "kg"},
      {"mass_damping", "where", text, "", ""},
      {"mass_damping", "set", text, "", ""},
      {"mass_damping", "rate", number, ">= 0", "1/s"},
      {"rigid", "where", text, "", ""},
      {"rigid", "set", text, "", ""},
      {"rigid", "name", text, "", ""},
      {"spring", "where", text, "", ""},
      {"spring", "set", text, "", ""},
      {"spring", "to_where", text, "", ""},
      {"spring", "to_set", text, "", ""},
      {"spring", "stiffness", number, ">= 0", "N/m"},
      {"spring", "damping", number, ">= 0", "N s/m"},
      {"spring", "direction", vector, "", ""},
      {"spring", "length", number, ">= 0", "m"},
      {"spring", "edges", "true or false", "", ""},
      {"obstacle", "kind", text, "", ""},
      {"obstacle", "name", text, "", ""},
      {"obstacle", "point", vector, "", "m"},
      {"obstacle", "normal", vector, "", ""},
      {"obstacle", "axis", vector, "", ""},
      {"obstacle", "radius", number, "> 0", "m"},
      {"obstacle", "length", number, "> 0", "m"},
      {"obstacle", "size", vector, "> 0", "m"},
      {"obstacle", "hollow", "true or false", "", ""},
      {"obstacle", "velocity", vector, "", "m/s"},
      {"obstacle", "times", "a list of numbers", "", "s"},
      {"obstacle", "factors", "a list of numbers", "", ""},
      {"obstacle", "ramp", text, "", ""},
      {"obstacle", "factor", text, "", ""},
      {"contact", "where", text, "", ""},
      {"contact", "set", text, "", ""},
      {"contact", "with", text, "", ""},
      {"contact", "obstacle", text, "", ""},
      {"contact", "to_where", text, "", ""},
      {"contact", "to_set", text, "", ""},
      {"contact", "edges", "true or false", "", ""},
      {"contact", "edge_angle", number, "> 0 and < 180", "degrees"},
      {"contact", "penalty", "a number or \"auto\"", "> 0", "N/m"},
      {"contact", "step", number, "> 0", "s"},
      {"contact", "damping", number, ">= 0", ""},
      {"contact", "friction", number, ">= 0", ""},
      {"contact", "slip", "a number or \"auto\"", "> 0", "m/s"},
      {"move", "angular_velocity", vector, "", "rad/s"},
      {"move", "point", vector, "", "m"},
      {"move", "displacement", vector, "", "m"},
      {"move", "factor", text, "", ""},
  };
  return keys;
}

// Each key by type, by range with its unit, by what is no number, and by a name that is nearly its own.
TEST_F(Contact, RefusesEveryKeyByTypeRangeAndName) {
  using Lines = std::map<std::string, std::string>;
  const test::SchemaCheck schema(Json::parse(schemaOf("scene").dump()));
  const std::map<std::string, Lines> good{
      {"pressure", {{"where", "\"all\""}, {"pressure", "1"}}},
      {"mass", {{"where", "\"all\""}, {"mass", "1"}}},
      {"mass_damping", {{"where", "\"all\""}, {"rate", "1"}}},
      {"rigid", {{"where", "\"x < 1e-6\""}}},
      {"spring", {{"where", "\"all\""}, {"stiffness", "1"}}},
      {"obstacle", {{"kind", "\"plane\""}, {"normal", "[0, 0, 1]"}, {"point", "[0, 0, -1]"}}},
      {"contact", {}},
      {"move", {{"where", "\"x < 1e-6\""}, {"velocity", "[1, 0, 0]"}}}};
  const auto expect = [&](const Key& key, const std::string& name, const std::string& value, const std::string& what) {
    std::string text = cube;
    for (const auto& [section, lines] : good) {
      text += "[[" + section + "]]\n";
      for (const auto& [own, line] : lines)
        if (section != key.section || own != key.key) text += own + " = " + line + "\n";
      if (section == key.section) text += name + " = " + value + "\n";
    }
    EXPECT_NE(schema.faultOf(test::jsonOfToml(text)), "") << text;
    folder_.write("scene.toml", text);
    try {
      readScene(folder_.path() / "scene.toml");
      ADD_FAILURE() << "no fault: " << text;
    } catch (const InputError& fault) {
      EXPECT_THAT(fault.what(), HasSubstr(what)) << text;
    }
  };
  int ranges = 0;
  for (const Key& key : newKeys()) {
    const std::string named = key.section + "." + key.key + ": ";
    const bool list = key.type.find("list") != std::string::npos;
    const std::string wrong = key.type == "a text" ? "3" : list ? "[1, \"a\"]" : "\"soft\"";
    expect(key, key.key, wrong, named);
    expect(key, key.key, wrong, " where " + key.type + " is needed");
    expect(
        key, key.key + key.key.back(), wrong,
        "unknown key \"" + key.key + key.key.back() + "\" in [" + key.section + "]; did you mean \"" + key.key + "\"?");
    if (key.type == "a text" || key.type == "true or false") continue;
    const auto filled = [&](const std::string& value) {
      return list ? "[" + value + ", " + value + ", " + value + "]" : value;
    };
    expect(key, key.key, filled("nan"), named + "nan is not a finite number");
    if (key.range.empty()) continue;
    const std::string of = key.unit.empty() ? "" : " " + key.unit;
    expect(key, key.key, filled("-2"), named + "-2 is out of range; must be " + key.range + of);
    if (key.range == "> 0") expect(key, key.key, filled("0"), named + "0 is out of range; must be " + key.range + of);
    ++ranges;
  }
  EXPECT_EQ(ranges, 15);
  // The table has no key that is not tried above.
  for (const SceneKey& key : sceneKeys()) {
    if (!good.contains(key.section) || key.section == "move") continue;
    const bool known = std::any_of(newKeys().begin(), newKeys().end(), [&](const Key& one) {
      return one.section == key.section && one.key == key.key && one.unit == key.unit;
    });
    EXPECT_TRUE(known) << key.section << "." << key.key;
  }
}

}  // namespace
}  // namespace ringwatch
