// The bracket of bodies with rigid parts against dense eigenvalues of Pᵀ K P and Pᵀ M P, P the motions that leave them
// rigid.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <ringwatch/integrators/body_system.h>
#include <ringwatch/integrators/stormer_verlet.h>
#include <ringwatch/monitor/bounds/global_frequency.h>
#include <ringwatch/monitor/bounds/lanczos_bound.h>
#include <ringwatch/monitor/bounds/lowest_mode.h>
#include <ringwatch/monitor/bounds/rayleigh.h>
#include <ringwatch/monitor/critical_step.h>
#include <ringwatch/monitor/energy_balance.h>
#include <ringwatch/monitor/exact_step.h>
#include <ringwatch/monitor/metrics/metrics.h>
#include <ringwatch/monitor/stability_monitor.h>
#include <tests/monitor/monitor_cases.h>

namespace ringwatch {
namespace {

/// The motions that leave rigid bodies rigid at x, 3N × m: free components of other nodes, and of each body six or what
/// its guide leaves.
Eigen::MatrixXd rigidMotions(const Body& body, const NodeVectors& x) {
  std::vector<Eigen::VectorXd> columns;
  const Eigen::Index size = 3 * body.nodeCount();
  for (std::int32_t i = 0; i < body.nodeCount(); ++i)
    for (int c = 0; c < 3; ++c)
      if (!body.constraints().isTied(i) && !body.constraints().isConstrained(i, c))
        columns.emplace_back(Eigen::VectorXd::Unit(size, 3 * i + c));
  for (const RigidBody& rigid : body.constraints().rigidBodies()) {
    const RigidGuide& guide = rigid.guide();
    const Eigen::Vector3d centre = rigid.point(x);
    for (int axis = 0; axis < 6; ++axis) {
      if (axis < 3 ? guide.components[static_cast<std::size_t>(axis)]
                   : guide.turning == RigidGuide::Turning::prescribed ||
                         (guide.turning == RigidGuide::Turning::aboutAxis && axis > 3))
        continue;
      const Eigen::Vector3d turning = guide.turning == RigidGuide::Turning::aboutAxis
                                          ? guide.axis
                                          : Eigen::Vector3d(Eigen::Vector3d::Unit(axis % 3));
      Eigen::VectorXd& column = columns.emplace_back(Eigen::VectorXd::Zero(size));
      for (const std::int32_t node : rigid.nodes())
        column.segment<3>(3 * node) = axis < 3 ? Eigen::Vector3d(Eigen::Vector3d::Unit(axis))
                                               : turning.cross(Eigen::Vector3d(x.col(node) - centre));
    }
  }
  Eigen::MatrixXd P(size, static_cast<Eigen::Index>(columns.size()));
  for (std::size_t k = 0; k < columns.size(); ++k) P.col(static_cast<Eigen::Index>(k)) = columns[k];
  return P;
}

/// Eigenvalues of the constrained problem, ascending, rad²/s².
Eigen::VectorXd exactEigenvalues(const Body& body, const NodeVectors& x) {
  const Eigen::MatrixXd P = rigidMotions(body, x), K = body.assembleTangent(x);
  Eigen::VectorXd mass(3 * body.nodeCount());
  for (std::int32_t i = 0; i < body.nodeCount(); ++i) mass.segment<3>(3 * i).setConstant(body.lumpedMass()[i]);
  const Eigen::MatrixXd reduced = P.transpose() * K * P, M = P.transpose() * mass.asDiagonal() * P;
  return Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(reduced, M, Eigen::EigenvaluesOnly).eigenvalues();
}

double exactStepOf(const Body& body, const NodeVectors& x) {
  return 2 / std::sqrt(exactEigenvalues(body, x).tail<1>()[0]);
}

/// A bar along x of two materials; nodes with x >= tiedFrom are a rigid body. The end x = 0 is held.
Body makeBar(const std::string& element, const std::string& law, double stiff, double tiedFrom, double jitter = 0.15,
             const RigidGuide& guide = {}) {
  Mesh mesh = test::distortedBox(element, {4, 2, 2}, jitter);
  MeshBlock all = std::move(mesh.blocks.front());
  mesh.blocks = {{all.type, {}, {}}, {all.type, {}, {}}};
  for (std::size_t e = 0; e < all.elementCount(); ++e) {
    double x = 0;
    for (int a = 0; a < all.nodesPerElement(); ++a) x += mesh.X(0, all.element(e)[a]) / all.nodesPerElement();
    std::vector<std::int32_t>& to = mesh.blocks[x > 0.02 ? 1 : 0].connectivity;
    to.insert(to.end(), all.element(e), all.element(e) + all.nodesPerElement());
  }
  mesh.nodeSets.clear();
  mesh.elementSets.clear();
  Body body(std::move(mesh), {makeMaterial(law, 30e3, 0.3, 1000), makeMaterial(law, stiff * 30e3, 0.3, 1000)},
            {{}, Lumping::rowSum, 1});
  body.tie("end", test::nodesWhere(body.mesh(), [&](const Eigen::Vector3d& p) { return p[0] > tiedFrom; }), guide);
  for (const std::int32_t node : test::nodesWhere(body.mesh(), [](const Eigen::Vector3d& p) { return p[0] < 1e-9; }))
    body.constraints().fix(node);
  return body;
}

/// Strained, with the rigid part turned and moved.
NodeVectors bent(const Body& body) {
  NodeVectors x = body.mesh().X;
  test::Random random(11);
  const NodeVectors noise = random.nodeVectors(x.cols(), 5e-4);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.2, Eigen::Vector3d(0.3, 1, 0.2).normalized()).toRotationMatrix();
  for (std::int32_t i = 0; i < body.nodeCount(); ++i) {
    const Eigen::Vector3d X = x.col(i);
    const double share = std::min(1.0, X[0] / 0.03);
    x.col(i) += share * (turn * X - X + Eigen::Vector3d(2e-3, 0, 0));
    if (!body.constraints().isTied(i) && X[0] > 1e-9) x.col(i) += noise.col(i);
  }
  const Eigen::Vector3d move(2e-3, 0, 0);
  for (const RigidBody& rigid : body.constraints().rigidBodies())
    for (const std::int32_t node : rigid.nodes()) x.col(node) = turn * body.mesh().X.col(node) + move;
  return x;
}

TEST(RigidBracket, HoldsTheDenseEigenvalue) {
  double widest = 0;
  for (const char* element : {"tet4", "hex8", "wedge6"})
    for (const char* law : {"stvk", "neo-hookean"})
      // Some elements of the stiff part are within the rigid body, some half of it; or all are within.
      for (const double tiedFrom : {0.025, 0.02 - 1e-3})
        for (const double stiff : {1.0, 400.0}) {
          const Body body = makeBar(element, law, stiff, tiedFrom);
          for (const bool rest : {true, false}) {
            const NodeVectors x = rest ? body.mesh().X : bent(body);
            const double exact = exactStepOf(body, x);
            const CriticalStep step = criticalStep(body, x, StepRule(2.0));
            const std::string name =
                joinText(element, " ", law, " ", stiff, " tied from ", tiedFrom, rest ? "" : " bent");
            EXPECT_LE(step.safe, exact) << name;
            EXPECT_GE(step.optimistic, exact * (1 - 1e-9)) << name;
            EXPECT_LE(step.optimistic, 1.01 * exact) << name;
            widest = std::max(widest, step.optimistic / step.safe);
            // Wholly rigid elements do not set the step.
            if (tiedFrom < 0.02) {
              EXPECT_GE(step.safe, 0.6 * exact) << name;
            }
            const GlobalFrequency top = globalFrequency(body, x);
            ASSERT_TRUE(top.converged) << name;
            EXPECT_NEAR(2 / std::sqrt(top.lambda), exact, 1e-8 * exact) << name;
            const LanczosBound likely = lanczosUpperBound(body, x);
            EXPECT_GE(likely.upper.value, top.lambda * (1 - 1e-9)) << name;
            EXPECT_LE(likely.upper.value, 1.05 * top.lambda) << name;
          }
        }
  EXPECT_LE(widest, 25);
}

const std::vector<RigidGuide> guides{
    {.components = {true, false, false}},
    {.components = {false, true, true}, .turning = RigidGuide::Turning::prescribed},
    {.components = {true, true, true},
     .turning = RigidGuide::Turning::aboutAxis,
     .axis = {0.2, 1, 0.1},
     .point = Eigen::Vector3d(0.05, 0.01, 0.002)},
    {.components = {true, true, true}, .turning = RigidGuide::Turning::free, .point = Eigen::Vector3d(0.03, 0, 0)},
    {.turning = RigidGuide::Turning::prescribed}};

// Theorem 91: what a guide takes is taken from the motions on both sides.
TEST(RigidBracket, HoldsTheDenseEigenvalueOfGuidedBodies) {
  double widest = 0, changes = 0;
  for (const char* element : {"tet4", "hex8"})
    for (const RigidGuide& guide : guides) {
      const Body body = makeBar(element, "neo-hookean", 1, 0.025, 0.15, guide);
      const Body loose = makeBar(element, "neo-hookean", 1, 0.025);
      for (const bool rest : {true, false}) {
        const NodeVectors x = rest ? body.mesh().X : bent(body);
        const double exact = exactStepOf(body, x);
        changes = std::max(changes, exact / exactStepOf(loose, x) - 1);
        const CriticalStep step = criticalStep(body, x, StepRule(2.0));
        EXPECT_LE(step.safe, exact) << element;
        EXPECT_GE(step.optimistic, exact * (1 - 1e-9)) << element;
        EXPECT_LE(step.optimistic, 1.01 * exact) << element;
        widest = std::max(widest, step.optimistic / step.safe);
        const GlobalFrequency top = globalFrequency(body, x);
        ASSERT_TRUE(top.converged) << element;
        EXPECT_NEAR(2 / std::sqrt(top.lambda), exact, 1e-8 * exact) << element;
        test::Random random(3);
        for (int trial = 0; trial < 20; ++trial) {
          NodeVectors start = random.nodeVectors(body.nodeCount(), 1);
          EXPECT_LE(rayleighLowerBound(body, x, start, 1 + trial % 12).value, top.lambda * (1 + 1e-12));
        }
        EXPECT_LE(evaluateMetric("reduced-1-ring", body, x).lambda, top.lambda * (1 + 1e-9));
      }
    }
  EXPECT_LE(widest, 1.5);
  EXPECT_GT(changes, 1e-4) << "the guides must matter";
}

// What would be a lower bound of the body without ties is none of this one.
TEST(RigidBracket, LowerSidesAreOfMotionsThatLeaveTheBodyRigid) {
  const Body body = makeBar("tet4", "stvk", 400, 0.025);
  const NodeVectors& X = body.mesh().X;
  const double exact = exactEigenvalues(body, X).tail<1>()[0];
  Mesh mesh = body.mesh();
  Body loose(mesh, {makeMaterial("stvk", 30e3, 0.3, 1000), makeMaterial("stvk", 400 * 30e3, 0.3, 1000)});
  ASSERT_GT(globalFrequency(loose, X).lambda, 1.1 * exact) << "else nothing is tested";
  test::Random random(3);
  for (int trial = 0; trial < 200; ++trial) {
    NodeVectors start = random.nodeVectors(body.nodeCount(), 1);
    EXPECT_LE(rayleighLowerBound(body, X, start, 1 + trial % 12).value, exact * (1 + 1e-12));
  }
  EXPECT_LE(evaluateMetric("reduced-1-ring", body, X).lambda, exact * (1 + 1e-9));
  EXPECT_EQ(metricDirection("reduced-1-ring", body), Direction::lowerBound);
  for (const char* metric : {"shewchuk-lower", "fried-lower"}) {
    EXPECT_EQ(metricDirection(metric, loose), Direction::lowerBound) << metric;
    EXPECT_EQ(metricDirection(metric, body), Direction::estimate) << metric;
  }
}

// One heavy block on soft elements: its own motion has the lowest frequencies, and directions of negative stiffness are
// sought beside it.
TEST(RigidBracket, NegativeDirectionsAreThoseOfTheRest) {
  const Body body = makeBar("hex8", "stvk", 1, 0.02 - 1e-3);
  NodeVectors x = body.mesh().X;
  for (std::int32_t i = 0; i < body.nodeCount(); ++i) x(0, i) -= std::min(0.35 * x(0, i), 0.35 * 0.02);
  const double exact = exactEigenvalues(body, x)[0];
  ASSERT_LT(exact, 0);
  const LowestMode found = LowestModeSearch(body).find(x, 60);
  EXPECT_LT(found.value, 0);
  EXPECT_GE(found.value, exact * (1 + 1e-9));
}

TEST(RigidBracket, ExactStepsAreProven) {
  const Body body = makeBar("tet4", "neo-hookean", 1, 0.02 - 1e-3);
  const StepRule rule(2.0);
  const double exact = exactStepOf(body, body.mesh().X);
  EXPECT_EQ(proveStep(body, body.mesh().X, rule, 1.001 * exact), Verdict::violated);
  const double safe = criticalStep(body, body.mesh().X, rule).safe;
  EXPECT_EQ(proveStep(body, body.mesh().X, rule, 0.999 * safe), Verdict::certified);
}

// A body that is moved along its guide and bends what it is tied to: work, strain energy and its own.
TEST(RigidBracket, WorkOfWhatMovesABodyIsInTheEnergyBalance) {
  for (const bool turns : {false, true}) {
    double errors[2];
    for (int k = 0; k < 2; ++k) {
      Body body(test::distortedBox("hex8", {4, 2, 2}), makeMaterial("neo-hookean", 30e3, 0.3, 1000),
                {{}, Lumping::rowSum, 1});
      RigidGuide guide{.components = {true, false, false}, .velocity = {0.15, 0, 0}};
      if (turns)
        guide = {.components = {true, true, false},
                 .turning = RigidGuide::Turning::prescribed,
                 .velocity = {0.05, 0.05, 0},
                 .angularVelocity = {8, 3, 0}};
      body.tie("end", test::nodesWhere(body.mesh(), [](const Eigen::Vector3d& p) { return p[0] > 0.03 - 1e-9; }),
               guide);
      for (const std::int32_t node :
           test::nodesWhere(body.mesh(), [](const Eigen::Vector3d& p) { return p[0] < 1e-9; }))
        body.constraints().fix(node);
      body.addBodyForce({0, 0, -9.81});
      BodySystem system(body);
      State state = system.initialState();
      EnergyBalance balance(body);
      const int steps = 200 << k;
      StormerVerlet verlet;
      double worst = 0, most = 0, work = 0;
      for (int i = 0; i <= steps; ++i) {
        const Energies energies = balance.evaluate(state.x, state.v);
        worst = std::max(worst, std::abs(energies.balanceError));
        most = std::max(most, energies.kinetic + energies.strain);
        work = energies.externalWork;
        ASSERT_TRUE(verlet.step(system, state, 0.06 / steps).done);
      }
      EXPECT_GT(work, 0.3 * most);
      errors[k] = worst / most;
    }
    EXPECT_LE(errors[1], 1.5e-5) << turns;
    EXPECT_NEAR(errors[1] / errors[0], 0.25, 0.01) << turns;
  }
}

TEST(RigidBracket, HoldsAlongARun) {
  std::vector<RigidGuide> all = guides;
  all.resize(guides.size() + 2);  // and both elements without a guide
  for (std::size_t k = 0; k < all.size(); ++k) {
    const RigidGuide& guide = all[k];
    const std::string element = k % 2 == 0 ? "hex8" : "tet4";
    Body body = makeBar(element, "stvk", 1, 0.025, 0.15, guide);
    body.addBodyForce({0, 0, -9.81});
    BodySystem system(body);
    State state = system.initialState();
    const auto& rigid = body.constraints().rigidBodies().front();
    for (const std::int32_t node : rigid.nodes())
      state.v.col(node) += Eigen::Vector3d(8, 4, 6).cross(Eigen::Vector3d(state.x.col(node)));
    body.constraints().imposeTied(state.x, state.v);
    StabilityMonitor monitor(body, {});
    StormerVerlet verlet;
    const double h = 0.5 * exactStepOf(body, state.x);
    for (int step = 0; step < (guide.any() ? 50 : 150); ++step) {
      const MonitorReport& report = monitor.observe(step, state.time, state.x, state.v, h);
      ASSERT_TRUE(report.bracket) << step;
      const double exact = exactStepOf(body, state.x);
      EXPECT_LE(report.bracket->safe, exact) << element << " " << step;
      EXPECT_GE(report.bracket->optimistic, exact * (1 - 1e-9)) << element << " " << step;
      EXPECT_EQ(report.verdict, Verdict::certified);
      ASSERT_TRUE(verlet.step(system, state, h).done);
    }
    EXPECT_GT((state.x - body.mesh().X).norm(), 1e-4) << "it must have moved";
  }
}

}  // namespace
}  // namespace ringwatch
