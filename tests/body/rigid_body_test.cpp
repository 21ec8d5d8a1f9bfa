// Nodes that are tied to a rigid body: shape, momenta, energy, and a free body
// against Euler's equations.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <ringwatch/base/error.h>
#include <ringwatch/body/rigid_block.h>
#include <ringwatch/integrators/body_system.h>
#include <ringwatch/integrators/pefrl.h>
#include <ringwatch/integrators/stormer_verlet.h>
#include <ringwatch/integrators/symplectic_euler.h>
#include <ringwatch/integrators/yoshida4.h>
#include <tests/support/body_cases.h>
#include <tests/support/random.h>

namespace ringwatch {
namespace {

std::vector<std::int32_t> allNodes(const Mesh& mesh) {
  std::vector<std::int32_t> nodes(mesh.nodeCount());
  std::iota(nodes.begin(), nodes.end(), 0);
  return nodes;
}

/// A box of three lengths, so that its moments of inertia differ, all of it
/// rigid.
Body rigidBox() {
  Body body(test::gridMesh("hex8", {2, 2, 2}, {0.06, 0.04, 0.02}, 0.2, 3), makeMaterial("stvk", 30e3, 0.3, 1000),
            {{}, Lumping::rowSum, 1});
  body.tie("box", allNodes(body.mesh()));
  return body;
}

double kineticEnergy(const Body& body, const NodeVectors& v) {
  return 0.5 * (v.colwise().squaredNorm() * body.lumpedMass()).value();
}

/// The largest change of a distance of two nodes since rest, relative.
double shapeFault(const Mesh& mesh, const NodeVectors& x, const std::vector<std::int32_t>& nodes) {
  double fault = 0;
  for (const std::int32_t i : nodes)
    for (const std::int32_t j : nodes)
      if (i < j) {
        const double rest = (mesh.X.col(i) - mesh.X.col(j)).norm();
        fault = std::max(fault, std::abs((x.col(i) - x.col(j)).norm() / rest - 1));
      }
  return fault;
}

/// Euler's equations in the axes of the body, with the rotation, by the
/// classical Runge-Kutta method in small steps.
struct EulersTop {
  Eigen::Matrix3d inertia;
  Eigen::Vector3d omega;  // rad/s, in the axes of the body
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();

  void advance(double time, int steps) {
    const double h = time / steps;
    using State = Eigen::Matrix<double, 7, 1>;
    const auto slope = [&](const State& s) {
      const Eigen::Vector3d w = s.head<3>();
      State d;
      d.head<3>() = inertia.inverse() * (inertia * w).cross(w);
      const Eigen::Quaterniond q(s[3], s[4], s[5], s[6]), dq = q * Eigen::Quaterniond(0, w[0], w[1], w[2]);
      d.tail<4>() << 0.5 * dq.w(), 0.5 * dq.x(), 0.5 * dq.y(), 0.5 * dq.z();
      return d;
    };
    State s;
    s << omega, rotation.w(), rotation.x(), rotation.y(), rotation.z();
    for (int i = 0; i < steps; ++i) {
      const State k1 = slope(s), k2 = slope(s + 0.5 * h * k1), k3 = slope(s + 0.5 * h * k2), k4 = slope(s + h * k3);
      s += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
      s.tail<4>().normalize();
    }
    omega = s.head<3>();
    rotation = Eigen::Quaterniond(s[3], s[4], s[5], s[6]);
  }
};

/// Turned about nearly the middle axis of inertia, where the motion tumbles.
Eigen::Vector3d tumbling(const RigidBody& rigid) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(rigid.inertia());
  return 40 * axes.eigenvectors().col(1) + 2 * axes.eigenvectors().col(0) + 1 * axes.eigenvectors().col(2);
}

State turning(const Body& body, const Eigen::Vector3d& omega, const Eigen::Vector3d& velocity) {
  State state = BodySystem(body).initialState();
  const Eigen::Vector3d centre = (body.mesh().X * body.lumpedMass()) / body.totalMass();
  for (std::int32_t i = 0; i < body.nodeCount(); ++i)
    state.v.col(i) = velocity + omega.cross(Eigen::Vector3d(state.x.col(i) - centre));
  return state;
}

TEST(RigidBody, TumblesAsEulersEquationsSay) {
  const Body body = rigidBox();
  const RigidBody& rigid = body.constraints().rigidBodies().front();
  const Eigen::Vector3d omega = tumbling(rigid), velocity(0.3, -0.2, 0.1);
  constexpr double end = 0.4;  // two and a half turns, and the tumbling
  EulersTop exact{rigid.inertia(), omega};
  exact.advance(end, 100000);
  const Eigen::Vector3d exactOmega = exact.rotation * exact.omega;
  EXPECT_GT((exact.omega - omega).norm(), 0.1 * omega.norm()) << "it must tumble";
  double errors[2];
  for (int k = 0; k < 2; ++k) {
    const int steps = 400 << k;
    BodySystem system(body);
    State state = turning(body, omega, velocity);
    const RigidBody::Motion first = rigid.motion(state.x, state.v);
    const double energy = kineticEnergy(body, state.v);
    StormerVerlet verlet;
    double energyFault = 0;
    for (int i = 0; i < steps; ++i) {
      ASSERT_TRUE(verlet.step(system, state, end / steps).done);
      energyFault = std::max(energyFault, std::abs(kineticEnergy(body, state.v) / energy - 1));
    }
    const RigidBody::Motion last = rigid.motion(state.x, state.v);
    EXPECT_LE((last.angularMomentum - first.angularMomentum).norm(), 1e-12 * first.angularMomentum.norm());
    EXPECT_LE((last.velocity - velocity).norm(), 3e-13);
    EXPECT_LE((last.centre - first.centre - end * velocity).norm(), 6e-14);
    EXPECT_LE(shapeFault(body.mesh(), state.x, rigid.nodes()), 1e-13);
    // The discrete motion is the exact one at other times (McLachlan & Zanna
    // 2005): the energy stays too.
    EXPECT_LE(energyFault, 2.7e-13);
    errors[k] = Eigen::AngleAxisd(last.rotation * exact.rotation.toRotationMatrix().transpose()).angle();
    EXPECT_LE((last.angularVelocity - exactOmega).norm(), (k == 0 ? 4e-2 : 1e-2) * omega.norm());
  }
  EXPECT_LE(errors[0], 0.06);  // rad, of sixteen
  EXPECT_NEAR(errors[0] / errors[1], 4, 0.4);
}

TEST(RigidBody, IsRigidInEverySchemeThatDrifts) {
  for (const IntegratorInfo& info : allIntegrators()) {
    if (!info.drifts) continue;
    const Body body = rigidBox();
    const RigidBody& rigid = body.constraints().rigidBodies().front();
    BodySystem system(body);
    State state = turning(body, tumbling(rigid), {0.1, 0, 0});
    const Eigen::Vector3d momentum = rigid.motion(state.x, state.v).angularMomentum;
    const auto integrator = makeIntegrator(info.name);
    for (int i = 0; i < 200; ++i) ASSERT_TRUE(integrator->step(system, state, 1e-3).done) << info.name;
    EXPECT_LE(shapeFault(body.mesh(), state.x, rigid.nodes()), 1e-13) << info.name;
    EXPECT_LE((rigid.motion(state.x, state.v).angularMomentum - momentum).norm(), 1e-12 * momentum.norm()) << info.name;
    NodeVectors v = state.v;
    rigid.project(state.x, v);
    EXPECT_LE((v - state.v).norm(), 1e-13 * v.norm()) << info.name << ": velocities are those of a rigid motion";
  }
  int drifting = 0;
  for (const IntegratorInfo& info : allIntegrators()) drifting += info.drifts;
  EXPECT_EQ(drifting, 4);
}

TEST(RigidBody, MovesByTheForcesAndTorquesOfItsNodes) {
  Body body = rigidBox();
  const RigidBody& rigid = body.constraints().rigidBodies().front();
  // A force at one corner, in the first moment: the centre gets F/m, the
  // turning J⁻¹ s × F.
  const Eigen::Vector3d force(0.01, -0.02, 0.03);
  body.externalForce().col(0) = force;
  BodySystem system(body);
  State state = system.initialState();
  const Eigen::Vector3d arm = state.x.col(0) - rigid.motion(state.x, state.v).centre;
  constexpr double h = 1e-6;
  SymplecticEuler().step(system, state, h);
  const RigidBody::Motion motion = rigid.motion(state.x, state.v);
  EXPECT_LE((motion.velocity - h * force / rigid.mass()).norm(), 1e-12 * h * force.norm() / rigid.mass());
  const Eigen::Vector3d rate = h * (rigid.inertia().inverse() * arm.cross(force));
  EXPECT_LE((motion.angularVelocity - rate).norm(), 3e-11 * rate.norm());
  NodeVectors forces = body.externalForce();
  const RigidBody::Load load = rigid.load(body.mesh().X, forces);
  EXPECT_LE((load.force - force).norm(), 1e-16);
  EXPECT_LE((load.torque - arm.cross(force)).norm(), 1e-16);
}

TEST(RigidBody, ProjectsToTheNearestRigidVelocities) {
  const Body body = rigidBox();
  const RigidBody& rigid = body.constraints().rigidBodies().front();
  test::Random random(7);
  NodeVectors v = random.nodeVectors(body.nodeCount(), 1.0);
  const NodeVectors before = v;
  const NodeVectors& X = body.mesh().X;
  rigid.project(X, v);
  // What is left is orthogonal, in the masses, to every rigid motion.
  const NodeVectors rest = (before - v) * body.lumpedMass().asDiagonal();
  const double scale = (before * body.lumpedMass().asDiagonal()).norm();
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_LE(std::abs(rest.row(axis).sum()), 1e-14 * scale);
    double turn = 0;
    for (std::int32_t i = 0; i < body.nodeCount(); ++i)
      turn += Eigen::Vector3d::Unit(axis).cross(Eigen::Vector3d(X.col(i))).dot(rest.col(i));
    EXPECT_LE(std::abs(turn), 1e-15 * scale);
  }
  NodeVectors again = v;
  rigid.project(X, again);
  EXPECT_LE((again - v).norm(), 1e-14 * v.norm());
}

TEST(RigidBody, HasElementsWithoutForcesWhereAllOfABlockIsTied) {
  Mesh mesh = test::distortedBox("tet4", {4, 2, 2});
  Body whole(mesh, makeMaterial("neo-hookean", 30e3, 0.3, 1000), {{}, Lumping::rowSum, 1});
  const auto half = test::nodesWhere(mesh, [](const Eigen::Vector3d& p) { return p[0] < 0.02 + 1e-9; });
  whole.tie("half", half);
  EXPECT_EQ(dynamic_cast<const RigidBlock*>(whole.blocks()[0].get()), nullptr);
  Body rigid = rigidBox();
  EXPECT_NE(dynamic_cast<const RigidBlock*>(rigid.blocks()[0].get()), nullptr);
  Body::Workspace workspace;
  StepEvaluation evaluation;
  evaluation.wantsEnergy = true;
  const NodeVectors x = test::strained(rigid.mesh().X);
  rigid.evaluate(x, evaluation, workspace);
  EXPECT_EQ(evaluation.internalForce, NodeVectors::Zero(3, rigid.nodeCount()));
  EXPECT_EQ(evaluation.strainEnergy, 0);
  EXPECT_EQ(rigid.elementTangent({0, 0}, x), Eigen::MatrixXd::Zero(24, 24));
}

// A step that a body turns too far for is not taken, and the state is as
// before.
TEST(RigidBody, RefusesToTurnTooFarInAStep) {
  const Body body = rigidBox();
  BodySystem system(body);
  for (const char* name : {"verlet", "symplectic-euler", "yoshida4", "pefrl"}) {
    State state = turning(body, {0, 0, 1000}, {0, 0, 0});
    const State before = state;
    const StepStatus status = makeIntegrator(name)->step(system, state, 1e-2);
    EXPECT_FALSE(status.done) << name;
    EXPECT_NE(status.reason.find("right angle"), std::string::npos);
    EXPECT_EQ(state.x, before.x) << name;
    EXPECT_EQ(state.v, before.v) << name;
    EXPECT_EQ(state.time, before.time);
  }
}

TEST(RigidBody, RefusesNodesThatMakeNoBody) {
  Body body(test::distortedBox("hex8", {4, 2, 2}, 0), makeMaterial("stvk", 30e3, 0.3, 1000));
  const auto expect = [&](std::vector<std::int32_t> nodes, const char* what) {
    try {
      body.tie("part", std::move(nodes));
      ADD_FAILURE() << what;
    } catch (const InputError& fault) {
      EXPECT_NE(std::string(fault.what()).find(what), std::string::npos) << fault.what();
    }
  };
  expect({0, 1}, "has 2 nodes");
  expect(test::nodesWhere(body.mesh(), [](const Eigen::Vector3d& p) { return p[1] < 1e-9 && p[2] < 1e-9; }),
         "lie on a line");
  body.constraints().fix(0, 1);
  expect({0, 1, 5}, "has a prescribed motion");
  const auto face = test::nodesWhere(body.mesh(), [](const Eigen::Vector3d& p) { return p[0] > 0.04 - 1e-9; });
  body.tie("face", face);
  expect(face, "is of another rigid body");
  EXPECT_THROW(body.constraints().fix(face.front()), InputError);
}

/// A box that is guided, with gravity.
Body guidedBox(const RigidGuide& guide, const Eigen::Vector3d& gravity = {0, 0, -9.81}) {
  Body body(test::gridMesh("hex8", {2, 2, 2}, {0.06, 0.04, 0.02}, 0.2, 3), makeMaterial("stvk", 30e3, 0.3, 1000),
            {{}, Lumping::rowSum, 1});
  body.tie("box", allNodes(body.mesh()), guide);
  body.addBodyForce(gravity);
  return body;
}
constexpr std::array<bool, 3> all{true, true, true};

// A compound pendulum at a large amplitude: its period is that of the elliptic
// integral, its point stays, its energy errs in second order.
TEST(GuidedRigidBody, SwingsAboutAPointAsACompoundPendulum) {
  const Eigen::Vector3d point(0.003, 0.011, 0.01), axis(0, 3, 0);
  for (const RigidGuide::Turning turning : {RigidGuide::Turning::aboutAxis, RigidGuide::Turning::free}) {
    const Body body = guidedBox({.components = all, .turning = turning, .axis = axis, .point = point});
    const RigidBody& rigid = body.constraints().rigidBodies().front();
    BodySystem system(body);
    State state = system.initialState();
    const Eigen::Vector3d arm = rigid.motion(state.x, state.v).centre - point;
    if (turning == RigidGuide::Turning::free) {
      // About a point it turns as Euler's equations say too: energy and the
      // moment about the vertical stay.
      for (std::int32_t i = 0; i < body.nodeCount(); ++i)
        state.v.col(i) = Eigen::Vector3d(3, 9, 5).cross(Eigen::Vector3d(state.x.col(i) - point));
      const auto momentAboutVertical = [&] {
        double sum = 0;
        for (std::int32_t i = 0; i < body.nodeCount(); ++i) {
          const Eigen::Vector3d s = state.x.col(i) - point, v = state.v.col(i);
          sum += body.lumpedMass()[i] * s.cross(v)[2];
        }
        return sum;
      };
      const double moment = momentAboutVertical(), energy = kineticEnergy(body, state.v);
      const double height = rigid.motion(state.x, state.v).centre[2];
      double worst = 0;
      StormerVerlet verlet;
      for (int i = 0; i < 4000; ++i) {
        ASSERT_TRUE(verlet.step(system, state, 5e-4).done);
        const double now =
            kineticEnergy(body, state.v) + rigid.mass() * 9.81 * (rigid.motion(state.x, state.v).centre[2] - height);
        worst = std::max(worst, std::abs(now - energy));
        EXPECT_LE((rigid.point(state.x) - point).norm(), 1e-14);
      }
      EXPECT_LE(worst, 3e-4 * energy);
      EXPECT_NEAR(momentAboutVertical(), moment, 1.5e-12 * moment);
      EXPECT_LE(shapeFault(body.mesh(), state.x, allNodes(body.mesh())), 3.3e-15);
      continue;
    }
    // Let go with the centre at rest beside the point; the least angle is that
    // of the arm to straight down.
    const Eigen::Vector3d n = axis.normalized(), across = arm - n * n.dot(arm);
    double inertia = 0;
    for (std::int32_t i = 0; i < body.nodeCount(); ++i)
      inertia += body.lumpedMass()[i] * n.cross(Eigen::Vector3d(state.x.col(i) - point)).squaredNorm();
    const double amplitude = std::acos(-across.normalized()[2]);
    EXPECT_GT(amplitude, 0.5);
    const double period =
        4 * std::sqrt(inertia / (rigid.mass() * 9.81 * across.norm())) * std::comp_ellint_1(std::sin(0.5 * amplitude));
    // The state after a whole period is the one before.
    double errors[2];
    for (int k = 0; k < 2; ++k) {
      const int steps = 500 << k;
      State now = system.initialState();
      StormerVerlet verlet;
      for (int i = 0; i < steps; ++i) ASSERT_TRUE(verlet.step(system, now, period / steps).done);
      errors[k] = (now.x - state.x).norm() / state.x.norm();
      EXPECT_LE((rigid.point(now.x) - point).norm(), 1e-15 * steps);
      // About a fixed axis points keep their place along it.
      for (std::int32_t i = 0; i < body.nodeCount(); ++i)
        EXPECT_NEAR(n.dot(now.x.col(i)), n.dot(state.x.col(i)), 1e-16 * steps);
    }
    // Where it turns back, errors of the period count in second order: that of
    // fourth.
    EXPECT_LE(errors[0], 2.5e-9);
    EXPECT_NEAR(errors[1] / errors[0], 0.0625, 1e-3);
  }
}

// Prescribed components and turning are exact, and the free components fall as
// a body of that mass.
TEST(GuidedRigidBody, MovesAsPrescribedAndFreelyInTheRest) {
  const Eigen::Vector3d omega(2, -3, 5), speed(0.1, 0.2, 0);
  const Body body = guidedBox({.components = {true, true, false},
                               .turning = RigidGuide::Turning::prescribed,
                               .velocity = speed,
                               .angularVelocity = omega});
  const RigidBody& rigid = body.constraints().rigidBodies().front();
  EXPECT_TRUE(body.constraints().moving());
  EXPECT_FALSE(body.constraints().any());
  for (const char* name : {"symplectic-euler", "verlet", "yoshida4", "pefrl"}) {
    BodySystem system(body);
    State state = system.initialState();
    const RigidBody::Motion first = rigid.motion(state.x, state.v);
    EXPECT_LE((first.velocity - speed).norm(), 1e-15);
    EXPECT_LE((first.angularVelocity - omega).norm(), 2e-14 * omega.norm());
    constexpr int steps = 100;
    constexpr double h = 1e-3;
    for (int i = 0; i < steps; ++i) ASSERT_TRUE(makeIntegrator(name)->step(system, state, h).done);
    const RigidBody::Motion last = rigid.motion(state.x, state.v);
    const double time = steps * h;
    const Eigen::Vector3d way = last.centre - first.centre;
    EXPECT_NEAR(way[0], speed[0] * time, 4e-15) << name;
    EXPECT_NEAR(way[1], speed[1] * time, 4e-15) << name;
    const double fall =
        std::string(name) == "symplectic-euler" ? 0.5 * 9.81 * time * (time + h) : 0.5 * 9.81 * time * time;
    EXPECT_NEAR(way[2], -fall, 7e-15) << name;
    const Eigen::AngleAxisd turn(omega.norm() * time, omega.normalized());
    EXPECT_LE((last.rotation - turn.toRotationMatrix()).norm(), 3.4e-14) << name;
    EXPECT_LE((last.angularVelocity - omega).norm(), 9e-14) << name;
    EXPECT_LE(shapeFault(body.mesh(), state.x, allNodes(body.mesh())), 1e-14) << name;
  }
}

// The free part is orthogonal, in the masses, to what is left out, and what is
// imposed differs from it by what is prescribed.
TEST(GuidedRigidBody, ProjectsToTheNearestVelocitiesThatAreFree) {
  const Eigen::Vector3d axis(0.2, 1, -0.4), point(0.01, 0.03, -0.02);
  const RigidGuide guides[] = {
      {.components = {true, false, false}},
      {.components = {false, false, true}, .turning = RigidGuide::Turning::aboutAxis, .axis = axis},
      {.components = all, .turning = RigidGuide::Turning::aboutAxis, .axis = axis, .point = point},
      {.components = all, .turning = RigidGuide::Turning::free, .point = point},
      {.components = {true, true, false}, .turning = RigidGuide::Turning::prescribed},
      {.turning = RigidGuide::Turning::prescribed}};
  for (const RigidGuide& guide : guides) {
    const Body body = guidedBox(guide);
    const RigidBody& rigid = body.constraints().rigidBodies().front();
    test::Random random(7);
    const Eigen::Matrix3d turned = random.rotation();
    const NodeVectors x = turned * body.mesh().X, before = random.nodeVectors(body.nodeCount(), 1.0);
    const Eigen::Vector3d about = rigid.point(x);
    if (guide.point) {
      EXPECT_LE((about - turned * point).norm(), 1e-15);
    }
    NodeVectors v = before;
    rigid.project(x, v);
    const NodeVectors rest = (before - v) * body.lumpedMass().asDiagonal();
    const double scale = (before * body.lumpedMass().asDiagonal()).norm();
    int free = 0;
    for (int k = 0; k < 6; ++k) {
      const int c = k % 3;
      Eigen::Vector3d linear = Eigen::Vector3d::Zero(), angular = linear;
      if (k < 3) {
        if (guide.components[static_cast<std::size_t>(c)]) continue;
        linear = Eigen::Vector3d::Unit(c);
      } else {
        if (guide.turning == RigidGuide::Turning::prescribed) continue;
        if (guide.turning == RigidGuide::Turning::aboutAxis && c > 0) continue;
        angular = guide.turning == RigidGuide::Turning::aboutAxis ? axis : Eigen::Vector3d(Eigen::Vector3d::Unit(c));
      }
      ++free;
      double product = 0;
      for (std::int32_t i = 0; i < body.nodeCount(); ++i)
        product += (linear + angular.cross(Eigen::Vector3d(x.col(i) - about))).dot(rest.col(i));
      EXPECT_LE(std::abs(product), 2e-14 * scale);
    }
    EXPECT_GT(free, 0);
    NodeVectors again = v;
    rigid.project(x, again);
    EXPECT_LE((again - v).norm(), 1e-13 * v.norm());
    // What is free of it is its own: one direction less for each that is
    // prescribed.
    const RigidBody::Motion motion = rigid.motion(x, v);
    const Eigen::Vector3d ofPoint = motion.velocity + motion.angularVelocity.cross(about - motion.centre);
    for (int c = 0; c < 3; ++c)
      if (guide.components[static_cast<std::size_t>(c)]) {
        EXPECT_NEAR(ofPoint[c], 0, 1e-14);
      }
    if (guide.turning == RigidGuide::Turning::aboutAxis) {
      EXPECT_LE(motion.angularVelocity.cross(axis).norm(), 1e-12 * motion.angularVelocity.norm());
    }
    if (guide.turning == RigidGuide::Turning::prescribed) {
      EXPECT_LE(motion.angularVelocity.norm(), 1e-12);
    }
    RigidBody moved = rigid;
    const Eigen::Vector3d speed(0.4, -0.3, 0.7), rate(3, 2, -4);
    moved.guideAt(speed, rate);
    NodeVectors imposed = before;
    moved.impose(x, imposed);
    const NodeVectors added = imposed - before;
    const NodeVectors moment = added * body.lumpedMass().asDiagonal();
    const RigidBody::Motion now = rigid.motion(x, imposed);
    const Eigen::Vector3d nowOfPoint = now.velocity + now.angularVelocity.cross(about - now.centre);
    for (int c = 0; c < 3; ++c)
      if (guide.components[static_cast<std::size_t>(c)]) {
        EXPECT_NEAR(nowOfPoint[c], guide.point ? 0 : speed[c], 1e-14);
      } else {
        EXPECT_NEAR(moment.row(c).sum(), 0, 1e-14 * scale) << "no force where nothing is prescribed";
      }
    if (guide.turning == RigidGuide::Turning::prescribed) {
      EXPECT_LE((now.angularVelocity - rate).norm(), 1e-12);
    }
  }
}

// What holds a body puts on it what its momenta and the other forces leave,
// along a run.
TEST(GuidedRigidBody, SupportsKeepTheBalanceOfMomenta) {
  const Eigen::Vector3d point(0.003, 0.011, 0.01), axis(0.3, 1, 0.2);
  for (const RigidGuide::Turning turning : {RigidGuide::Turning::aboutAxis, RigidGuide::Turning::free}) {
    const Body body = guidedBox({.components = all, .turning = turning, .axis = axis, .point = point});
    const RigidBody& rigid = body.constraints().rigidBodies().front();
    BodySystem system(body);
    State state = system.initialState();
    for (std::int32_t i = 0; i < body.nodeCount(); ++i)
      state.v.col(i) = Eigen::Vector3d(6, 20, 4).cross(Eigen::Vector3d(state.x.col(i) - point));
    rigid.impose(state.x, state.v);
    double errors[2];
    for (int k = 0; k < 2; ++k) {
      const double h = 4e-4 / (1 << k);
      State now = state;
      StormerVerlet verlet;
      const auto momenta = [&](Eigen::Vector3d& linear, Eigen::Vector3d& angular) {
        linear.setZero();
        angular.setZero();
        for (std::int32_t i = 0; i < body.nodeCount(); ++i) {
          const Eigen::Vector3d p = body.lumpedMass()[i] * now.v.col(i), s = now.x.col(i) - point;
          linear += p;
          angular += s.cross(p);
        }
      };
      Eigen::Vector3d p[3], L[3];
      RigidBody::Load support{};
      for (int i = 0; i < 3; ++i) {
        momenta(p[i], L[i]);
        if (i == 1)
          support = rigid.support(now.x, now.v, body.externalForce(), Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero());
        if (i == 1) {
          const RigidBody::Load load = rigid.loadAbout(point, now.x, body.externalForce());
          support.force += load.force;
          support.torque += load.torque;
        }
        ASSERT_TRUE(verlet.step(system, now, h).done);
      }
      const Eigen::Vector3d force = (p[2] - p[0]) / (2 * h), torque = (L[2] - L[0]) / (2 * h);
      errors[k] = (support.force - force).norm() / force.norm() + (support.torque - torque).norm() / torque.norm();
    }
    EXPECT_LE(errors[1], 5e-5);
    EXPECT_NEAR(errors[1] / errors[0], 0.25, 2e-3);
  }
}

TEST(GuidedRigidBody, RefusesGuidesThatItCannotFollow) {
  const auto refuses = [](const RigidGuide& guide, const char* what) {
    try {
      guidedBox(guide);
      ADD_FAILURE() << what;
    } catch (const InputError& fault) {
      EXPECT_NE(std::string(fault.what()).find(what), std::string::npos) << fault.what();
    }
  };
  refuses({.components = {true, true, false}, .point = Eigen::Vector3d(0, 0, 0)}, "goes with all three components");
  refuses({.components = all, .point = Eigen::Vector3d(0, 0, 0), .velocity = {1, 0, 0}}, "must stay");
  refuses({.turning = RigidGuide::Turning::aboutAxis}, "has no direction");
  refuses({.components = all, .turning = RigidGuide::Turning::prescribed}, "has no prescribed motion");
  // A body of which nothing is free has its nodes constrained.
  Body body(test::distortedBox("hex8", {4, 2, 2}, 0), makeMaterial("stvk", 30e3, 0.3, 1000));
  const auto face = test::nodesWhere(body.mesh(), [](const Eigen::Vector3d& p) { return p[0] > 0.04 - 1e-9; });
  for (const std::int32_t node : face) body.constraints().fix(node);
  body.tie("face", face, {.components = all, .turning = RigidGuide::Turning::prescribed});
  EXPECT_TRUE(body.constraints().rigidBodies().empty());
  EXPECT_EQ(body.constraints().rigidBody("face").nodes(), face);
  EXPECT_FALSE(body.constraints().isTied(face.front()));
}

}  // namespace
}  // namespace ringwatch
