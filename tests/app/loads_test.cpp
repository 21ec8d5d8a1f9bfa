// Velocities at the start, and loads and motions that follow tables of time, against analytic answers.
#include <cmath>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include <ringwatch/app/scene/scene_state.h>
#include <ringwatch/app/scene/time_table.h>
#include <ringwatch/base/error.h>
#include <ringwatch/integrators/stormer_verlet.h>
#include <ringwatch/meshes/mesh_io.h>

#include "program.h"

namespace ringwatch {
namespace {

using test::Outcome;
using test::Program;
using ::testing::HasSubstr;

constexpr const char* bar = R"(mesh = {generate = "bar", size = [0.2, 0.04, 0.04], cells = [10, 2, 2], element = "hex8"}
material = {model = "stvk", young = 30e3, poisson = 0.3, density = 1000}
integrator = {method = "verlet", step = 1e-3, end = 0.05}
[output]
every = 0.05
picture = false
)";

class Loads : public Program {
 protected:
  void run(const std::string& more, const std::string& options = "") { runScene(bar + more, options); }
  /// Displacements in the last frame, 3×N, m.
  NodeVectors lastDisplacement() const {
    const MeshState state = lastFrame();
    return state.x - state.mesh.X;
  }
  /// The error of the energy balance over the largest kinetic energy.
  double largestImbalance() const { return history_.largest("balance_error_J") / history_.largest("kinetic_J"); }
  void refuse(const std::string& more, const std::string& what) { refuseScene(bar + more, what); }
};

// x = X + v t + g t²/2, which central differences follow without error.
TEST_F(Loads, LetABodyFlyFreely) {
  run("[[initial]]\nwhere = \"all\"\nvelocity = [1.5, -0.5, 2]\n[[force]]\nwhere = \"all\"\nacceleration = [0, 0, "
      "-9.81]\n");
  const NodeVectors u = lastDisplacement();
  const double t = 0.05;
  const Eigen::Vector3d expected = Eigen::Vector3d(1.5, -0.5, 2) * t + 0.5 * Eigen::Vector3d(0, 0, -9.81) * t * t;
  EXPECT_LT((u.colwise() - expected).cwiseAbs().maxCoeff(), 2.5e-16);
  EXPECT_NEAR(history_.number(0, "kinetic_J"), 0.5 * 0.32 * (1.5 * 1.5 + 0.25 + 4), 6.6e-16);
  EXPECT_LT(largestImbalance(), 4.4e-15);
}

// Lumped masses of a bar of equal cells have the moment m (l²/12 + d²/6) along an axis of length l and cells d: the
// trapezoidal rule of x². Angular momentum is kept by central differences to rounding.
TEST_F(Loads, LetABodyTurnAboutAnAxis) {
  folder_.write("scene.toml", std::string(bar) +
                                  "[[initial]]\nwhere = \"all\"\nangular_velocity = [0, 0, 3]\npoint = [0.1, 0.02, 9]\n"
                                  "[[initial]]\nwhere = \"all\"\nvelocity = [0, 0, 0.25]\n");
  const Scene scene = readScene(folder_.path() / "scene.toml");
  std::vector<std::string> notes;
  const Body body = sceneBody(scene, sceneMesh(scene, notes), 1);
  BodySystem system(body);
  State state = sceneInitialState(scene, system);
  const auto momentum = [&] {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::int32_t i = 0; i < body.nodeCount(); ++i)
      sum += body.lumpedMass()[i] *
             (state.x.col(i) - Eigen::Vector3d(0.1, 0.02, 0.02)).cross(Eigen::Vector3d(state.v.col(i)));
    return sum;
  };
  const double moment = 0.32 * ((0.04 / 12 + 0.0004 / 6) + (0.0016 / 12 + 0.0004 / 6));
  EXPECT_NEAR(momentum()[2] / (3 * moment), 1, 1.9e-15);
  StormerVerlet scheme;
  for (int n = 0; n < 200; ++n) ASSERT_TRUE(scheme.step(system, state, 5e-4).done);
  EXPECT_NEAR(momentum()[2] / (3 * moment), 1, 1.9e-15);
  EXPECT_LT(momentum().head<2>().norm(), 1.4e-18);
  // The program starts from the same.
  runScene(folder_.read("scene.toml"));
  EXPECT_NEAR(history_.number(0, "kinetic_J"), 0.5 * moment * 9 + 0.5 * 0.32 * 0.0625, 2e-17);
}

TEST_F(Loads, LetABodyFallIntoItsSupports) {
  // Prescribed motion wins over a velocity at the start.
  run("[[initial]]\nwhere = \"all\"\nvelocity = [0, 0, 0.1]\n[[fix]]\nwhere = \"x < 1e-6\"\n");
  const NodeVectors u = lastDisplacement();
  const Mesh mesh = readMesh(folder_.path() / "r/frames/frame_000001.vtu");
  EXPECT_GT(u.row(2).maxCoeff(), 1e-3);
  int held = 0;
  for (Eigen::Index i = 0; i < u.cols(); ++i)
    if (mesh.X(0, i) < 1e-6) {
      EXPECT_EQ(u.col(i).norm(), 0);
      ++held;
    }
  EXPECT_EQ(held, 9);
}

// A force F f(t) on a free body: m v = F ∫ f dt, by the trapezoidal rule of the kicks exact for straight lines between
// steps.
TEST_F(Loads, FollowATable) {
  run("[[force]]\nwhere = \"all\"\nforce = [0.64, 0, 0]\ntimes = [0.01, 0.02, 0.03]\nfactors = [0, 1, 0.5]\n"
      "[[force]]\nwhere = \"all\"\nforce = [0, 0.32, 0]\n");
  // To 0.05 s: 0.005 + 0.0075 + 0.02 * 0.5 = 0.0225 s, and 0.05 s of the constant one.
  const double t = history_.last("time_s"), vx = 0.64 / 0.32 * (0.0125 + 0.5 * (t - 0.03)), vy = t;
  EXPECT_NEAR(history_.last("kinetic_J") / (0.5 * 0.32 * (vx * vx + vy * vy)), 1, 5.6e-15);
  // Work by the trapezoidal rule against kicks: an error of the second order of the step.
  const double coarse = largestImbalance();
  run("[[force]]\nwhere = \"all\"\nforce = [0.64, 0, 0]\ntimes = [0.01, 0.02, 0.03]\nfactors = [0, 1, 0.5]\n"
      "[[force]]\nwhere = \"all\"\nforce = [0, 0.32, 0]\n",
      "--set integrator.step=5e-4");
  EXPECT_GT(coarse, 1e-9);
  EXPECT_LT(coarse, 6.9e-4);
  EXPECT_NEAR(largestImbalance() / coarse, 0.25, 0.015);
}

// A motion V f(t) of all nodes: u = V ∫ f dt at the ends of steps whatever the step, and the supports give ½ m v².
TEST_F(Loads, MoveByATable) {
  for (const char* step : {"1e-3", "7e-4"}) {
    run("[[move]]\nwhere = \"all\"\nvelocity = [0.8, 0, -0.4]\ntimes = [0, 0.04]\nfactors = [0, 1]\nramp = "
        "\"smooth\"\n",
        std::string("--set integrator.step=") + step);
    const NodeVectors u = lastDisplacement();
    const double t = summary_["end_time"].get<double>(), way = 0.02 + (t - 0.04);
    EXPECT_LT((u.colwise() - Eigen::Vector3d(0.8 * way, 0, -0.4 * way)).cwiseAbs().maxCoeff(), 7e-16) << step;
    EXPECT_EQ(history_.number(0, "kinetic_J"), 0);
    EXPECT_NEAR(history_.last("kinetic_J"), 0.5 * 0.32 * 0.8, 8e-16);
    // Work is summed up over steps and nodes, some 4500 of them: their rounding is at most 4500 ulp of it.
    EXPECT_NEAR(history_.last("external_work_J"), 0.5 * 0.32 * 0.8, 1e-14);
    EXPECT_LT(largestImbalance(), 1e-13);
  }
}

// Pulled slowly by a smooth ramp, a bar without lateral contraction ends up as statics has it: twice the energy, the
// work of a dead load of constant size, would tell of a jump instead.
TEST_F(Loads, PullSmoothlyWithoutVibration) {
  run("[[fix]]\nwhere = \"x < 1e-6\"\n[[force]]\nset = \"x-max\"\nforce = [0.048, 0, 0]\ntimes = [0, 1.6]\nfactors = "
      "[0, 1]\n"
      "ramp = \"smooth\"\n",
      "--set integrator.end=2 --set material.model=linear --set material.poisson=0 --set output.every=1");
  const double elongation = 0.048 * 0.2 / (0.0016 * 30e3);
  EXPECT_NEAR(history_.last("strain_J") / (0.5 * 0.048 * elongation), 1, 3e-3);
  EXPECT_LT(history_.last("kinetic_J"), 1e-5 * history_.last("strain_J"));
}

TEST(TimeTable, IntegratesWhatItSays) {
  for (const Ramp ramp : {Ramp::linear, Ramp::smooth}) {
    const TimeTable table({1, 2, 4}, {0.5, 3, -1}, ramp);
    EXPECT_EQ(table.at(0), 0.5);
    EXPECT_EQ(table.at(2), 3);
    EXPECT_EQ(table.at(9), -1);
    EXPECT_DOUBLE_EQ(table.at(3), 1);
    EXPECT_NEAR((table.at(2 + 1e-6) - 3) / 1e-6, ramp == Ramp::smooth ? 0 : -2, 1e-5);
    for (const auto& [from, to] : {std::pair{0.0, 0.5}, {0.3, 1.7}, {1.2, 1.3}, {1.5, 3.1}, {3.0, 6.0}}) {
      constexpr int parts = 20000;  // the midpoint rule
      double sum = 0;
      for (int i = 0; i < parts; ++i) sum += table.at(from + (to - from) * (i + 0.5) / parts) / parts;
      EXPECT_NEAR(table.mean(from, to - from), sum, 2e-8) << from;
    }
  }
}

TEST_F(Loads, RefuseWhatMakesNoSense) {
  const std::string force = "[[force]]\nwhere = \"all\"\nforce = [1, 0, 0]\n",
                    table = "times = [0, 1]\nfactors = [0, 1]\n";
  refuse(force + "times = [0, 1]\n", "force.factors: missing; it goes with times");
  refuse(force + "factors = [0, 1]\n", "force.times: missing; it goes with factors");
  refuse(force + "ramp = \"smooth\"\n", "force.ramp: there is no table");
  refuse(force + "times = [0, 1]\nfactors = [1]\n", "force.times: 2 times and 1 factors; give as many of both");
  refuse(force + "times = [1]\nfactors = [1]\n", "1 points; a table needs two and more");
  refuse(force + "times = [0, 1, 1]\nfactors = [1, 2, 3]\n",
         "scene.toml:10: force.times: the times must increase, but 1 s follows 1 s");
  refuse(force + "times = [-1, 1]\nfactors = [1, 2]\n", "force.times: -1 is out of range; must be >= 0 s");
  refuse(force + "times = 3\nfactors = [1, 2]\n", "force.times: the number 3 where a list of numbers is needed");
  refuse(force + table + "ramp = \"smoth\"\n", "did you mean \"smooth\"?");
  refuse("[[initial]]\nwhere = \"all\"\n",
         "initial.velocity: missing; give velocity (m/s) or angular_velocity (rad/s)");
  refuse("[[initial]]\nwhere = \"x > 9\"\nvelocity = [1, 0, 0]\n", "\"x > 9\" selects no node");
  refuse("[[initial]]\nwhere = \"all\"\nvelocity = [1, 0, 0]\npoint = [1, 0, 0]\n",
         "initial.point: there is no angular_velocity");
  refuse("[[initial]]\nwhere = \"all\"\nangular_velocity = [1, 0]\n", "initial.angular_velocity: a list of 2");
  refuse(
      "[[move]]\nwhere = \"all\"\nvelocity = [1, 0, 0]\n[[move]]\nwhere = \"x < 0.1\"\nvelocity = [1, 0, 0]\n" + table,
      "it prescribes another velocity than");
}

}  // namespace
}  // namespace ringwatch
