// The rotation that keeps the angular momentum of handled elements, and runs with it and without.
#include <gtest/gtest.h>

#include <cmath>

#include <Eigen/Geometry>

#include <ringwatch/handlers/angular_momentum.h>
#include <ringwatch/handlers/imex/imex.h>
#include <tests/handlers/handler_cases.h>

namespace ringwatch {
namespace {

Eigen::Vector3d angularMomentumOf(const Body& body, const NodeVectors& x, const NodeVectors& v) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::int32_t i = 0; i < body.nodeCount(); ++i)
    sum += body.lumpedMass()[i] * Eigen::Vector3d(x.col(i)).cross(Eigen::Vector3d(v.col(i)));
  return sum;
}

// Theorem 68: sums, and one linear map of where the step ends.
TEST(KeepAngularMomentum, TakesTheTorqueAndNothingElse) {
  const Body body = test::sliverBody("corotational", 0.95, false);
  const std::int32_t n = body.nodeCount();
  std::vector<std::int32_t> nodes;
  for (std::int32_t i = 0; i < n; i += 2) nodes.push_back(i);
  test::Random random(3);
  const double h = 0.01;
  const NodeVectors x = body.mesh().X + random.nodeVectors(n, 2e-3), v = random.nodeVectors(n, 1.0),
                    before = random.nodeVectors(n, 10.0), all = random.nodeVectors(n, 10.0);
  NodeVectors a = all;
  keepAngularMomentum(body, nodes, x, v, h, before(Eigen::all, nodes), a);
  Eigen::Vector3d change = Eigen::Vector3d::Zero(), torque = change, torqueWithout = change, sum = change,
                  mean = change;
  double mass = 0;
  for (const std::int32_t i : nodes) {
    const Eigen::Vector3d at = x.col(i);
    change += body.lumpedMass()[i] * Eigen::Vector3d(a.col(i) - all.col(i));
    torque += body.lumpedMass()[i] * at.cross(Eigen::Vector3d(a.col(i) - before.col(i)));
    torqueWithout += body.lumpedMass()[i] * at.cross(Eigen::Vector3d(all.col(i) - before.col(i)));
    sum += body.lumpedMass()[i] * Eigen::Vector3d(all.col(i) - before.col(i));
    mean += body.lumpedMass()[i] * at;
    mass += body.lumpedMass()[i];
  }
  // About the centre of the nodes: the sum of what changes has a torque about the origin.
  mean /= mass;
  torque -= mean.cross(sum);
  torqueWithout -= mean.cross(sum);
  EXPECT_LE(torque.norm(), 1e-12 * torqueWithout.norm());
  EXPECT_LE(change.norm(), 1e-12 * mass * 10);
  for (std::int32_t i = 1; i < n; i += 2) EXPECT_EQ(a.col(i), all.col(i));
  // Where the step ends differs by w × (y - c): no distance changes to first order, and the symmetric part is none.
  Eigen::Matrix3d moved = Eigen::Matrix3d::Zero(), gram = moved;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  const NodeVectors ends = x + h * (v + h * all), shifts = h * h * (a - all);
  for (const std::int32_t i : nodes) centre += body.lumpedMass()[i] / mass * ends.col(i);
  for (const std::int32_t i : nodes) {
    moved += shifts.col(i) * (ends.col(i) - centre).transpose();
    gram += (ends.col(i) - centre) * (ends.col(i) - centre).transpose();
  }
  const Eigen::Matrix3d map = moved * gram.inverse();
  EXPECT_LE((map + map.transpose()).norm(), 1e-9 * map.norm());
  for (const std::int32_t i : nodes)
    EXPECT_LE((shifts.col(i) - map * (ends.col(i) - centre)).norm(), 1e-9 * shifts.cwiseAbs().maxCoeff());
}

struct SpinCase {
  std::string_view handler, solver;
};
class SpinningBar : public ::testing::TestWithParam<SpinCase> {};
INSTANTIATE_TEST_SUITE_P(All, SpinningBar,
                         ::testing::Values(SpinCase{"imex", Imex::newton}, SpinCase{"imex", "cholesky"},
                                           SpinCase{"imex", "cg"}, SpinCase{"local-time-stepping", "auto"}),
                         [](const auto& test) {
                           return test::testName(test.param.handler) + "_" + test::testName(test.param.solver);
                         });

TEST_P(SpinningBar, KeepsItsAngularMomentum) {
  double change[2];
  for (const bool keeps : {false, true}) {
    Body body = test::sliverBody("corotational", 0.98, false);
    auto handler = makeHandler(
        GetParam().handler, body, makeIntegrator("symplectic-euler"),
        {.own = {{"solver", GetParam().solver}, {"dissipation", 0.3}, {"momentum", keeps ? "keep" : "free"}}});
    const double h = 5 * test::criticalStepOf(body);
    handler->prepare(body.mesh().X, h);
    ASSERT_FALSE(handler->elements().empty());
    BodySystem system(body);
    State state = system.initialState();
    const Eigen::Vector3d spin(0, 10, 20), centre(0.1, 0.02, 0.02);
    for (Eigen::Index i = 0; i < state.v.cols(); ++i)
      state.v.col(i) = spin.cross(Eigen::Vector3d(state.x.col(i)) - centre);
    const Eigen::Vector3d first = angularMomentumOf(body, state.x, state.v);
    for (int step = 0; step < 300; ++step) ASSERT_TRUE(handler->step(system, state, h).done);
    change[keeps] = (angularMomentumOf(body, state.x, state.v) - first).norm() / first.norm();
  }
  EXPECT_LE(change[true], 1e-11);
  EXPECT_GT(change[false], 1e-7);
}

TEST(KeepMomenta, TakesTheRigidMotionThatMassHasBrought) {
  Body body = test::sliverBody("stvk", 0.95, false);
  test::Random random(3);
  const NodeVectors x = body.mesh().X + random.nodeVectors(body.nodeCount(), 2e-3),
                    own = random.nodeVectors(body.nodeCount(), 1.0);
  const Eigen::VectorXd before = body.lumpedMass();
  const Eigen::Vector3d linear = own * before, angular = angularMomentumOf(body, x, own);
  for (std::int32_t i = 0; i < body.nodeCount(); i += 3) body.addNodalMass(i, (1 + i % 5) * before[i]);
  NodeVectors v = own;
  ASSERT_GT((own * body.lumpedMass() - linear).norm(), 0.1 * linear.norm());
  keepMomenta(body, before, x, v);
  EXPECT_LE((v * body.lumpedMass() - linear).norm(), 1e-12 * linear.norm());
  EXPECT_LE((angularMomentumOf(body, x, v) - angular).norm(), 1e-12 * angular.norm());
  // What is taken is rigid: it changes no distance.
  for (std::int32_t i = 1; i < body.nodeCount(); ++i) {
    const Eigen::Vector3d arm = x.col(i) - x.col(0), change = (v - own).col(i) - (v - own).col(0);
    EXPECT_NEAR(arm.dot(change), 0, 1e-13);
  }
}

TEST(KeepAngularMomentum, LeavesHeldBodiesAndLinearLawsAlone) {
  const auto isFree = [](const Body& body) {
    const auto all = test::everyElement(body);
    std::vector<std::int32_t> nodes(body.nodeCount());
    for (std::int32_t i = 0; i < body.nodeCount(); ++i) nodes[i] = i;
    return isFreeOfTorque(body, all, nodes);
  };
  EXPECT_TRUE(isFree(test::sliverBody("stvk", 0.95, false)));
  EXPECT_FALSE(isFree(test::sliverBody("stvk", 0.95, true)));
  EXPECT_FALSE(isFree(test::sliverBody("linear", 0.95, false)));
}

}  // namespace
}  // namespace ringwatch
