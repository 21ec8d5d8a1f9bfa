// Pressure that follows the surface, and sets that turn about an axis, against analytic answers.
#include <cmath>
#include <string>

#include <Eigen/Geometry>

#include <ringwatch/app/scene/scene_pressure.h>
#include <ringwatch/base/error.h>
#include <ringwatch/body/body.h>
#include <ringwatch/meshes/mesh_io.h>
#include <tests/support/meshes.h>

#include "program.h"

namespace ringwatch {
namespace {

using test::Json;
using test::Outcome;
using test::Program;

// -p ∫ N n dA over a closed surface is p times the derivative of the volume, with a minus.
TEST(Pressure, IsTheDerivativeOfTheVolume) {
  for (const char* element : {"hex8", "tet4", "wedge6", "pyramid5", "tet10", "hex20"}) {
    Mesh mesh = test::gridMesh(element, {2, 3, 2}, {0.2, 0.3, 0.2}, 0.3);
    Scene::Pressure load{NodeSelection::parse("all", "test"), 7, std::nullopt, "test"};
    NodeVectors force = NodeVectors::Zero(3, mesh.X.cols());
    for (const PressedFace& face : pressedFaces(load, mesh))
      addPressure(face, 7, mesh.X, [&](std::int32_t node, const Eigen::Vector3d& own) { force.col(node) += own; });
    EXPECT_LE(force.rowwise().sum().norm(), 1e-14) << element;
    const NodeVectors u = test::Random(3).nodeVectors(mesh.X.cols(), 1);
    const auto volume = [&](double h) {
      Mesh moved = mesh;
      moved.X += h * u;
      return Body(moved, makeMaterial("linear", 1, 0, 1)).volume();
    };
    constexpr double h = 1e-5;
    EXPECT_NEAR(force.cwiseProduct(u).sum(), -7 * (volume(h) - volume(-h)) / (2 * h), 1e-8) << element;
  }
}

constexpr const char* cube = R"(mesh = {generate = "bar", size = [0.1, 0.1, 0.1], cells = [1, 1, 1], element = "hex8"}
material = {model = "stvk", young = 1e7, poisson = 0.3, density = 1000}
integrator = {method = "verlet", step = 1e-4, end = 0.2}
[output]
every = 0.2
picture = false
)";

class Pressed : public Program {
 protected:
  NodeVectors run(const std::string& more) {
    runScene(cube + more);
    const MeshState state = lastFrame();
    X_ = state.mesh.X;
    return state.x;
  }
  void refuse(const std::string& more, const std::string& what) { refuseScene(cube + more, what); }
  NodeVectors X_;
};

// A cube of 1 kg that turns at ω and is pressed on one of its faces through its centre: the force turns with it, and
// its centre moves by (pA/m ω²) (1 - cos ωt, ωt - sin ωt).
TEST_F(Pressed, FollowsTheFaceThatItActsOn) {
  const double omega = 5, force = 2, t = 0.2;
  const NodeVectors x = run(
      "[[pressure]]\nwhere = \"x < 1e-6\"\npressure = 200\n[[initial]]\nwhere = \"all\"\nangular_velocity = [0, 0, 5]\n"
      "point = [0.05, 0.05, 0.05]\n");
  const Eigen::Vector3d moved = (x - X_).rowwise().mean();
  const double scale = force / (omega * omega);
  EXPECT_NEAR(moved[0], scale * (1 - std::cos(omega * t)), 1e-4 * scale);
  EXPECT_NEAR(moved[1], scale * (omega * t - std::sin(omega * t)), 1e-4 * scale);
  EXPECT_NEAR(moved[2], 0, 1e-12);
  EXPECT_LE(history_.largest("balance_error_J"), 1e-6);
  bool told = false;
  const Json notes = summary_["notes"];
  for (const Json& note : notes)
    told = told || note.get<std::string>().find("pressure: its load stiffness is not symmetric") == 0;
  EXPECT_TRUE(told);
}

// With a ramp the impulse is p A ∫ factor dt.
TEST_F(Pressed, FollowsItsTable) {
  run("[[pressure]]\nwhere = \"x < 1e-6\"\npressure = 200\ntimes = [0, 0.1]\nfactors = [0, 1]\n");
  const double speed = 2 * (0.05 + 0.1);
  EXPECT_NEAR(history_.last("kinetic_J"), 0.5 * speed * speed, 1e-3 * speed * speed);
  EXPECT_LE(history_.largest("balance_error_J"), 1e-5);
}

// All nodes turn and move as one: positions at the ends of steps are exact.
TEST_F(Pressed, SetsTurnAboutAnAxis) {
  const NodeVectors x =
      run("[[move]]\nwhere = \"all\"\nangular_velocity = [0, 0, 20]\npoint = [0.3, 0, 0]\nvelocity = [0, 0, 1]\n"
          "times = [0, 0.1]\nfactors = [0, 1]\nramp = \"smooth\"\n");
  const double way = 0.05 + 0.1;
  const Eigen::Vector3d point(0.3, 0, 0);
  const Eigen::Matrix3d R = Eigen::AngleAxisd(20 * way, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  const NodeVectors expected = ((R * (X_.colwise() - point)).colwise() + (point + Eigen::Vector3d(0, 0, way))).eval();
  EXPECT_LE((x - expected).cwiseAbs().maxCoeff(), 1e-12);
  // A face that turns takes the rest of a body with it, and the support's work is what the body gains.
  run("[[move]]\nwhere = \"x < 1e-6\"\nangular_velocity = [2, 0, 0]\npoint = [0, 0.05, 0.05]\ntimes = [0, 0.1]\n"
      "factors = [0, 1]\nramp = \"smooth\"\n");
  // ½ J ω², J of eight equal masses at the corners.
  const double expectedEnergy = 0.5 * (1.0 * 0.1 * 0.1 / 2) * 4;
  EXPECT_NEAR(history_.last("kinetic_J"), expectedEnergy, 0.05 * expectedEnergy);
  EXPECT_LE(history_.largest("balance_error_J"), 1e-3 * expectedEnergy);
}

TEST_F(Pressed, RefusesWhatCannotBe) {
  refuse("[[pressure]]\nwhere = \"x < 1e-6 and y < 0.05\"\npressure = 1\n",
         "pressure.where: no face of the surface has all of its corners among the selected nodes; widen it");
  refuse("[[pressure]]\nwhere = \"x > 5\"\npressure = 1\n", "pressure.where: \"x > 5\" selects no node");
  refuse("[[pressure]]\nset = \"x-mni\"\npressure = 1\n", "did you mean \"x-min\"?");
  refuse("[[pressure]]\nwhere = \"all\"\n", "pressure.pressure: missing; give a number in Pa");
  refuse("[[move]]\nwhere = \"all\"\n",
         "move.velocity: missing; give velocity (m/s), angular_velocity (rad/s) or displacement (m)");
  refuse("[[move]]\nwhere = \"all\"\nvelocity = [0, 0, 0]\npoint = [1, 0, 0]\n",
         "move.point: there is no angular_velocity for it");
  refuse("[[move]]\nwhere = \"x < 1e-6\"\nangular_velocity = [1, 0, 0]\n[[fix]]\nwhere = \"y < 1e-6\"\n",
         "prescribe the motion of 2 nodes of both along x");
}

}  // namespace
}  // namespace ringwatch
