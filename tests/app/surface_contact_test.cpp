// Contact of surfaces through the command line: two cubes that collide against the closed form, momentum, energy,
// restitution; what governs, checkpoints, threads, and what is refused.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include <ringwatch/base/error.h>
#include <ringwatch/meshes/generators/generators.h>
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

/// Two stiff cubes of 1 kg, 1 mm apart, which a soft penalty sees as rigid bodies.
constexpr const char* twoCubes = R"([mesh]
generate = "stack"
size = [0.1, 0.1, 0.1]
cells = [1, 1, 1]
upper_size = [0.1, 0.1, 0.1]
upper_cells = [1, 1, 1]
gap = 0.001
element = "hex8"
[material]
model = "stvk"
young = 1e7
poisson = 0.3
density = 1000
[integrator]
method = "verlet"
step = 1e-4
end = 0.3
[output]
every = 0.3
picture = false
)";
constexpr double cubeMass = 1, cubeSpeed = 0.2;
constexpr const char* upperFalls = "[[initial]]\nset = \"upper\"\nvelocity = [0, 0, -0.2]\n";

class SurfaceContactRuns : public Program {
 protected:
  void run(const std::string& more, const std::string& options = "") { runScene(twoCubes + more, options); }
  /// How far the middles of the two cubes have come, m.
  std::array<Eigen::Vector3d, 2> moved() const {
    const MeshState state = lastFrame();
    const NodeVectors moved = state.x - state.mesh.X;
    return {Eigen::Vector3d(moved.leftCols(8).rowwise().mean()), Eigen::Vector3d(moved.rightCols(8).rowwise().mean())};
  }
  void refuse(const std::string& more, const std::string& what, const std::string& options = "") {
    refuseScene(twoCubes + more, what, options);
  }
};

// Equal masses exchange their speeds: eight springs of 100 N/m between the four pairs of nodes, whose deepest point is
// v √(μ/κ) with the reduced mass μ = m/2.
TEST_F(SurfaceContactRuns, CubesThatCollideExchangeTheirSpeeds) {
  run(std::string(upperFalls) + "[[contact]]\nwith = \"surface\"\npenalty = 100\n");
  EXPECT_NEAR(history_.largest("kinetic_J"), 0.02, 1e-6);
  EXPECT_NEAR(history_.last("kinetic_J"), 0.02, 2e-6);
  EXPECT_LE(history_.largest("balance_error_J"), 2e-6);
  const Json& found = summary_["discrete_forces"];
  EXPECT_EQ(found["contact_nodes"], 16);
  EXPECT_EQ(found["most_touching"], 8);
  const double kappa = 800, deepest = cubeSpeed * std::sqrt(0.5 * cubeMass / kappa),
               lasts = pi * std::sqrt(0.5 * cubeMass / kappa);
  EXPECT_NEAR(found["deepest"]["depth"].get<double>(), deepest, 1e-5);
  EXPECT_EQ(found["deepest"]["obstacle"], "surface");
  EXPECT_EQ(found["governed_observations"], 0);
  EXPECT_EQ(summary_["verdict"], "certified");
  EXPECT_EQ(summary_["certified_steps"], summary_["steps"]);
  // Together they keep their momentum to rounding; the lower one has all of it after contact.
  const auto [lower, upper] = moved();
  EXPECT_NEAR(lower[2] + upper[2], -cubeSpeed * 0.3, 1e-12);
  const double meets = 0.001 / cubeSpeed, after = 0.3 - meets - lasts;
  EXPECT_NEAR(lower[2], -cubeSpeed * (after + 0.5 * lasts), 3e-6);
  EXPECT_LE(std::abs(lower[0]) + std::abs(lower[1]) + std::abs(upper[0]) + std::abs(upper[1]), 1e-9);
}

// One-sided contact of the upper cube's nodes on a lower cube that is held: ẍ + 2 ζ ω ẋ + ω² x = 0 while it touches,
// and e = exp(-π ζ/√(1 - ζ²)); the cube's ζ is the nodes' over √2.
TEST_F(SurfaceContactRuns, HasTheRestitutionOfItsDamping) {
  run(std::string(upperFalls) +
      "[[fix]]\nset = \"lower\"\n[[contact]]\nwith = \"surface\"\nset = \"upper\"\nto_set = \"lower\"\npenalty = 100\n"
      "damping = 0.2\n");
  const double zeta = 0.2 / std::sqrt(2.0), e = std::exp(-pi * zeta / std::sqrt(1 - zeta * zeta));
  EXPECT_NEAR(std::sqrt(history_.last("kinetic_J") / 0.02), e, 1.8e-3);
  EXPECT_NEAR(history_.last("dissipated_J"), 0.02 * (1 - e * e), 1e-4);
  EXPECT_EQ(summary_["discrete_forces"]["most_touching"], 4);
  EXPECT_EQ(summary_["verdict"], "certified");
}

// A cube that bounces under its weight on another comes back to where it fell from, time and again: v t - g t²/2 in the
// air, and half a period and a little more on the penalty.
TEST_F(SurfaceContactRuns, BouncingCubeKeepsItsEnergy) {
  run("[[fix]]\nset = \"lower\"\n[[force]]\nset = \"upper\"\nacceleration = [0, 0, -10]\n"
      "[[contact]]\nwith = \"surface\"\nset = \"upper\"\nto_set = \"lower\"\npenalty = 2000\n",
      "--set integrator.end=1.0 --set mesh.gap=0.02");
  const double g = 10, height = 0.02, kappa = 4 * 2000, omega = std::sqrt(kappa / cubeMass),
               v = std::sqrt(2 * g * height);
  // On the penalty z = -(v/ω) sin ωt - (g/ω²)(1 - cos ωt) returns to zero after (2/ω)(π - atan(v ω/g)).
  const double contact = 2 / omega * (pi - std::atan(v * omega / g)), period = 2 * v / g + contact;
  EXPECT_LE(history_.largest("balance_error_J"), 2e-3 * cubeMass * g * height);
  std::vector<double> tops;
  for (std::size_t i = 1; i + 1 < history_.rows.size(); ++i) {
    const double before = history_.number(i - 1, "kinetic_J"), now = history_.number(i, "kinetic_J"),
                 after = history_.number(i + 1, "kinetic_J");
    if (now < before && now <= after && now < 1e-3 * cubeMass * g * height &&
        history_.number(i, "strain_J") < 1e-3 * cubeMass * g * height)
      tops.push_back(history_.number(i, "time_s"));
  }
  ASSERT_GE(tops.size(), 4U);
  for (std::size_t k = 0; k < tops.size(); ++k)
    EXPECT_NEAR(tops[k], static_cast<double>(k + 1) * period, 3e-3 * period) << k;
}

// A small block falls on a coarse plate, in the middle, at the rim and flush with it: nothing touches before √(2 h/g),
// and some of it has then.
TEST_F(SurfaceContactRuns, NothingTouchesBeforeItCan) {
  const double height = 0.002, g = 9.81, meets = std::sqrt(2 * height / g);
  for (const char* mesh : {"cells = [1, 1, 1]\nupper_cells = [3, 3, 3]\noffset = [1.7, -1.454]\nelement = \"hex8\"\n",
                           "cells = [3, 3, 2]\nupper_cells = [4, 4, 4]\noffset = [1.7, -1.218]\nelement = \"tet4\"\n",
                           "cells = [3, 3, 2]\nupper_cells = [3, 3, 3]\noffset = [1.7, -1.053]\nelement = \"hex8\"\n",
                           "cells = [2, 2, 2]\nupper_cells = [3, 3, 3]\noffset = [1.7, 1.7]\nelement = \"hex8\"\n",
                           "cells = [2, 2, 2]\nupper_cells = [3, 3, 3]\noffset = [0.3, 1.5]\nelement = \"hex8\"\n"}) {
    folder_.write("scene.toml",
                  std::string("[mesh]\ngenerate = \"stack\"\nsize = [4.0, 4.0, 0.8]\nupper_size = [0.6, 0.6, 0.6]\n"
                              "gap = 0.002\n") +
                      mesh +
                      "[material]\nmodel = \"neo-hookean\"\nyoung = 2e8\npoisson = 0.2\ndensity = 2000\n"
                      "[integrator]\nmethod = \"verlet\"\nstep = 1e-4\nend = 0.02\n[[fix]]\nwhere = \"z < 1e-6\"\n"
                      "[[force]]\nset = \"upper\"\nacceleration = [0, 0, -9.81]\n[[contact]]\nwith = \"surface\"\n"
                      "[output]\npicture = false\n");
    for (const double share : {0.98, 1.05}) {
      const Outcome outcome = call("run scene.toml --out r --set integrator.end=" + test::digits(share * meets));
      ASSERT_EQ(outcome.status, 0) << mesh << outcome.out << outcome.err;
      const Json found = json("r/summary.json")["discrete_forces"];
      EXPECT_EQ(found["most_touching"].get<int>() > 0, share > 1) << mesh;
      if (share < 1) continue;
      // No deeper than without contact.
      EXPECT_LE(found["deepest"]["depth"].get<double>(), g * meets * meets * 0.06);
    }
  }
}

constexpr const char* softBlocks = R"([mesh]
generate = "stack"
size = [0.04, 0.04, 0.02]
cells = [4, 4, 2]
upper_size = [0.03, 0.03, 0.03]
upper_cells = [3, 3, 3]
gap = 0.001
jitter = 0.1
[material]
model = "neo-hookean"
young = 1e5
poisson = 0.4
density = 1000
[integrator]
step = 1e-4
end = 0.02
[monitor]
on_violation = "warn"
[[initial]]
set = "upper"
velocity = [0.1, 0, -0.8]
[output]
picture = false
)";

TEST_F(SurfaceContactRuns, APenaltyMadeForTheStepLeavesIt) {
  const Outcome outcome = runScene(std::string(softBlocks) + "[[contact]]\nwith = \"surface\"\n");
  EXPECT_EQ(summary_["verdict"], "certified");
  EXPECT_EQ(summary_["certified_steps"], summary_["steps"]);
  EXPECT_GT(summary_["discrete_forces"]["most_touching"].get<int>(), 10);
  EXPECT_LE(history_.largest("balance_error_J"), 0.03 * history_.number(0, "kinetic_J"));
  EXPECT_THAT(outcome.out, HasSubstr("deep into surface"));
}

TEST_F(SurfaceContactRuns, SaysWhenContactGovernsAndWhichPenaltyWouldNot) {
  EXPECT_THAT(runScene(std::string(softBlocks) + "[[contact]]\nwith = \"surface\"\npenalty = 5e4\n", "", 1).out,
              HasSubstr("springs or contact govern"));
  const Json& found = summary_["discrete_forces"];
  EXPECT_GT(found["governed_observations"].get<int>(), 0);
  const double room = found["room"]["penalty"].get<double>();
  ASSERT_GT(room, 0);
  const Outcome again = call("run scene.toml --out again --set contact.0.penalty=" + test::digits(room));
  EXPECT_EQ(again.status, 0) << again.out << again.err;
  EXPECT_EQ(json("again/summary.json")["discrete_forces"]["governed_observations"], 0);
}

TEST_F(SurfaceContactRuns, IsTheSameForAnyNumberOfThreads) {
  expectSameForAnyThreads(std::string(softBlocks) + "[[contact]]\nwith = \"surface\"\ndamping = 0.1\nfriction = 0.2\n");
}

TEST_F(SurfaceContactRuns, ResumedRunsHaveTheBitsOfTheOneThatWasNotStopped) {
  // The upper block hangs over the lower one's edges, which its own edges cross.
  expectSameWhenKilled(std::string(softBlocks) +
                           "checkpoint_every = 1e-3\n[[contact]]\nwith = \"surface\"\ndamping = 0.1\nfriction = 0.3\n",
                       "--set integrator.end=0.05 --set mesh.upper_size=[0.05,0.03,0.03] --set contact.0.edges=true");
  EXPECT_GT(summary_["discrete_forces"]["most_touching"].get<int>(), 0);
}

/// Two stiff cubes of 1 kg with an edge towards each other, 1 mm apart, which cross.
class CrossedEdgeRuns : public SurfaceContactRuns {
 protected:
  void SetUp() override {
    SurfaceContactRuns::SetUp();
    writeCubes(0.001);
  }
  void writeCubes(double gap) {
    StackOptions options;
    options.lower.element = "hex8";
    options.lower.size = options.upperSize = {0.1, 0.1, 0.1};
    Mesh mesh = generateStack(options);
    const double half = 0.1 / std::sqrt(2.0);
    for (const std::string name : {"lower", "upper"}) {
      const bool lower = name == "lower";
      const Eigen::AngleAxisd tip(pi / 4, lower ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitY());
      const auto& nodes = mesh.nodeSets.at(name);
      const Eigen::Vector3d centre = mesh.X(Eigen::all, nodes).rowwise().mean();
      for (const std::int32_t node : nodes)
        mesh.X.col(node) = tip * (mesh.X.col(node) - centre) + Eigen::Vector3d(0, 0, lower ? -half : half + gap);
    }
    writeMesh(mesh, folder_.path() / "cubes.msh");
  }
  std::string scene(const std::string& more) const {
    const std::string all(twoCubes);
    return "[mesh]\nfile = \"cubes.msh\"\n" + all.substr(all.find("[material]")) +
           "[[initial]]\nwhere = \"z > 0\"\nvelocity = [0, 0, -0.2]\n[[contact]]\nwith = \"surface\"\n" + more;
  }
  void collide(const std::string& more, const std::string& options = "") { runScene(scene(more), options); }
};

// One spring of 800 N/m between the two ridges: as two masses on it, equal cubes exchange their speeds.
TEST_F(CrossedEdgeRuns, EdgesThatCollideExchangeTheirSpeeds) {
  collide("penalty = 800\nedges = true\n");
  const double kappa = 800, deepest = cubeSpeed * std::sqrt(0.5 * cubeMass / kappa),
               lasts = pi * std::sqrt(0.5 * cubeMass / kappa);
  const Json& found = summary_["discrete_forces"];
  EXPECT_EQ(found["most_touching"], 1);
  EXPECT_NEAR(found["deepest"]["depth"].get<double>(), deepest, 0.01 * deepest);
  EXPECT_EQ(summary_["verdict"], "certified");
  EXPECT_EQ(summary_["certified_steps"], summary_["steps"]);
  EXPECT_NEAR(history_.last("kinetic_J"), 0.02, 2e-4);
  EXPECT_LE(history_.largest("balance_error_J"), 2e-4);
  const auto [lower, upper] = moved();
  EXPECT_NEAR(lower[2] + upper[2], -cubeSpeed * 0.3, 1e-12);
  const double after = 0.3 - 0.001 / cubeSpeed - lasts;
  EXPECT_NEAR(lower[2], -cubeSpeed * (after + 0.5 * lasts), 0.01 * cubeSpeed * after);
  EXPECT_LE(std::abs(lower[0]) + std::abs(lower[1]) + std::abs(upper[0]) + std::abs(upper[1]), 1e-9);
}

// Without edges the same cubes go through one another.
TEST_F(CrossedEdgeRuns, NodesAgainstFacesAloneLetThemThrough) {
  collide("penalty = 800\n", "--set integrator.end=0.1");
  EXPECT_EQ(summary_["discrete_forces"]["most_touching"], 0);
  EXPECT_NEAR(moved()[1][2], -cubeSpeed * 0.1, 1e-9);
}

// Half a period of ẍ + 2 ζ ω ẋ + ω² x = 0, ω² = k/μ, with the damper 2 ζ_n √(k m/8) of a node's mass m/8.
TEST_F(CrossedEdgeRuns, HaveTheRestitutionOfTheirDamping) {
  collide("penalty = 800\nedges = true\ndamping = 0.4\n");
  const double c = 2 * 0.4 * std::sqrt(800 * cubeMass / 8), zeta = c / (2 * std::sqrt(800 * 0.5 * cubeMass)),
               e = std::exp(-pi * zeta / std::sqrt(1 - zeta * zeta));
  // Their common speed stays: v²/4 each.
  EXPECT_NEAR(history_.last("kinetic_J"), 0.01 * (1 + e * e), 2e-4);
  EXPECT_NEAR(history_.last("dissipated_J"), 0.01 * (1 - e * e), 2e-4);
  EXPECT_EQ(summary_["verdict"], "certified");
}

TEST_F(CrossedEdgeRuns, APenaltyMadeForTheStepLeavesIt) {
  collide("edges = true\n");
  EXPECT_EQ(summary_["discrete_forces"]["most_touching"], 1);
  EXPECT_EQ(summary_["verdict"], "certified");
  EXPECT_EQ(summary_["certified_steps"], summary_["steps"]);
  // A node's mass for twenty steps: m/8 (π/20h)².
  EXPECT_NEAR(summary_["discrete_forces"]["penalty"]["largest"].get<double>(),
              cubeMass / 8 * std::pow(pi / (20 * 1e-4), 2), 1.0);
  EXPECT_LE(history_.largest("balance_error_J"), 0.03 * 0.02);
  EXPECT_GT(moved()[0][2] * -1, 0.9 * cubeSpeed * 0.29);
}

TEST_F(CrossedEdgeRuns, EdgesThatOverlapAreRefused) {
  writeCubes(-0.002);
  folder_.write("scene.toml", scene("edges = true\n"));
  expectRefused("run scene.toml --out refused", "surfaces overlap at the start: the edge of nodes ");
  expectRefused("run scene.toml --out refused", " is 0.002 m beyond that of nodes ");
}

TEST_F(SurfaceContactRuns, PartsThatOverlapAreRefused) {
  StackOptions options;
  options.lower.size = {0.1, 0.1, 0.1};
  options.lower.cells = {4, 4, 4};
  options.upperSize = {0.05, 0.05, 0.05};
  options.upperCells = {2, 2, 2};
  Mesh mesh = generateStack(options);
  for (const std::int32_t node : mesh.nodeSets.at("upper")) mesh.X(2, node) -= 0.004;
  writeMesh(mesh, folder_.path() / "overlap.msh");
  folder_.write("scene.toml", "[mesh]\nfile = \"overlap.msh\"\n" +
                                  std::string(twoCubes).substr(std::string(twoCubes).find("[material]")) +
                                  "[[contact]]\nwith = \"surface\"\n");
  expectRefused("run scene.toml --out refused", "surfaces overlap at the start: node ");
  expectRefused("run scene.toml --out refused", " is 0.004 m deep behind the face of nodes ");
  // Without the nodes that are too deep it begins.
  const Outcome outcome = call("run scene.toml --out r --set integrator.end=1e-3 --set contact.0.where='\"z > 0.12\"'");
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
}

TEST_F(SurfaceContactRuns, TheExampleIsCertifiedAndBlowsUpWithAStiffPenalty) {
  const std::string example = "run '" RINGWATCH_EXAMPLES "/two_blocks.toml' --quiet --out ";
  ASSERT_EQ(call(example + "good").status, 0);
  const Json good = json("good/summary.json");
  EXPECT_EQ(good["verdict"], "certified");
  EXPECT_EQ(good["certified_steps"], good["steps"]);
  EXPECT_GT(good["discrete_forces"]["most_touching"].get<int>(), 30);
  ASSERT_EQ(call(example + "stiff --set contact.0.penalty=3e5").status, 1);
  const Json bad = json("stiff/summary.json");
  EXPECT_THAT(bad["events"][0]["text"].get<std::string>(), HasSubstr("springs or contact govern it, most at "));
}

TEST_F(SurfaceContactRuns, WhatDoesNotGoTogetherIsRefused) {
  const std::string own = "[[contact]]\nwith = \"surface\"\n";
  refuse(own + "obstacle = \"floor\"\n",
         "contact.obstacle: this contact is with = \"surface\"; take one of the two out");
  refuse("[[contact]]\nto_set = \"lower\"\n", "contact.to_set: needs with = \"surface\"; obstacles have no nodes");
  refuse("[[contact]]\nwith = \"surfaces\"\n", "did you mean \"surface\"");
  refuse("[[contact]]\n", "there is no [[obstacle]] to touch; give one, with its kind, or with = \"surface\"");
  refuse(own + "set = \"uper\"\n", "did you mean \"upper\"");
  refuse(own + "to_where = \"z < 0.05 and x < 0.05\"\n",
         "to_where, to_set: no face of the surface has all of its corners among the nodes; change the condition");
  refuse(own + "to_where = \"z < 0.05\"\nto_set = \"lower\"\n", "to_where");
  refuse(own + "friction = -1\n", "contact.friction");
  refuse(own + "edge_angle = 30\n", "contact.edge_angle: needs edges = true");
  refuse(own + "edges = true\nedge_angle = 180\n", "180 is out of range; must be > 0 and < 180 degrees");
  refuse("[[contact]]\nedges = true\n", "contact.edges: needs with = \"surface\"; obstacles have no edges");
  refuse(own + "[[obstacle]]\nkind = \"plane\"\nnormal = [0, 0, 1]\npoint = [0, 0, -1]\n",
         "there is no [[contact]] with it");
}

}  // namespace
}  // namespace ringwatch
