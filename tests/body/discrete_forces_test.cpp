// Springs, dashpots and penalty contact: forces against energies, tangents against forces, majorants against both, and
// their place in a body.
#include <gtest/gtest.h>

#include <functional>
#include <numeric>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <ringwatch/base/error.h>
#include <ringwatch/body/body.h>
#include <ringwatch/body/discrete_forces.h>
#include <ringwatch/body/sub_body.h>
#include <tests/body/discrete_matrices.h>
#include <tests/support/body_cases.h>
#include <tests/support/random.h>

namespace ringwatch {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using test::denseOf;

struct NamedObstacle {
  std::string name;
  std::function<std::unique_ptr<Obstacle>()> make;
};
/// All kinds, near the origin.
std::vector<NamedObstacle> allObstacles() {
  const Vector3d point(0.01, -0.02, 0.03), axis(1, 2, -0.5);
  return {{"plane", [=] { return planeObstacle(point, axis); }},
          {"sphere", [=] { return sphereObstacle(point, 0.8, false); }},
          {"hollow_sphere", [=] { return sphereObstacle(point, 0.8, true); }},
          {"cylinder", [=] { return cylinderObstacle(point, axis, 0.7, std::nullopt, false); }},
          {"short_cylinder", [=] { return cylinderObstacle(point, axis, 0.7, 0.9, false); }},
          {"hollow_cylinder", [=] { return cylinderObstacle(point, axis, 0.7, std::nullopt, true); }},
          {"box", [=] {
             return boxObstacle(point, {0.9, 1.3, 0.7});
           }}};
}

TEST(Obstacles, DistancesHaveTheDerivativesThatTheyTell) {
  test::Random random(3);
  int compared = 0;
  for (const NamedObstacle& named : allObstacles()) {
    const std::unique_ptr<Obstacle> obstacle = named.make();
    for (int trial = 0; trial < 200; ++trial) {
      const Vector3d x = random.vector(1), along = random.vector(1).normalized();
      constexpr double h = 1e-5;
      const Obstacle::Surface at = obstacle->at(x), after = obstacle->at(x + h * along),
                              before = obstacle->at(x - h * along);
      // Not across an edge of the distance.
      if ((after.normal - before.normal).norm() > 1e-3) continue;
      ++compared;
      EXPECT_NEAR(at.normal.norm(), 1, 1e-14) << named.name;
      EXPECT_NEAR(at.normal.dot(along), (after.gap - before.gap) / (2 * h), 1e-7) << named.name;
      EXPECT_LE((at.curvature * along - (after.normal - before.normal) / (2 * h)).norm(), 6e-6) << named.name;
    }
  }
  EXPECT_GT(compared, 1200);
}

TEST(Obstacles, LieWhereTheyAreSaidTo) {
  const auto gap = [](const std::unique_ptr<Obstacle>& obstacle, const Vector3d& x) { return obstacle->at(x).gap; };
  const auto plane = planeObstacle({0, 0, 1}, {0, 0, 2});
  EXPECT_DOUBLE_EQ(gap(plane, {5, 6, 1.25}), 0.25);
  const auto sphere = sphereObstacle({1, 0, 0}, 2, false), hollow = sphereObstacle({1, 0, 0}, 2, true);
  EXPECT_DOUBLE_EQ(gap(sphere, {1, 3, 0}), 1);
  EXPECT_DOUBLE_EQ(gap(hollow, {1, 3, 0}), -1);
  const auto cylinder = cylinderObstacle({0, 0, 0}, {0, 0, 1}, 1, 4.0, false);
  EXPECT_DOUBLE_EQ(gap(cylinder, {3, 0, 0}), 2);
  EXPECT_DOUBLE_EQ(gap(cylinder, {0.1, 0, 1.8}), -0.2);
  const auto box = boxObstacle({1, 1, 1}, {2, 4, 6});
  EXPECT_NEAR(gap(box, {1.9, 1, 1}), -0.1, 3e-16);
  EXPECT_DOUBLE_EQ(gap(box, {1, 1, 5}), 1);
}

TEST(Obstacles, TellManyNodesAsTheyTellOne) {
  test::Random random(11);
  std::size_t found = 0;
  for (const NamedObstacle& named : allObstacles()) {
    const std::unique_ptr<Obstacle> obstacle = named.make();
    const NodeVectors x = random.nodeVectors(300, 1.5);
    std::vector<std::int32_t> nodes;
    for (std::int32_t node = 0; node < 300; ++node)
      if (random.index(4) > 0) nodes.push_back(node);
    std::vector<std::int32_t> near(nodes.size());
    for (int trial = 0; trial < 20; ++trial) {
      const Vector3d displacement = random.vector(0.3);
      std::vector<std::int32_t> expected;
      // The distance of one of the nodes itself, too.
      const double gap =
          trial % 2 == 0 ? random.uniform(-0.5, 0.5) : obstacle->at(x.col(nodes[trial]) - displacement).gap;
      for (std::size_t k = 0; k < nodes.size(); ++k)
        if (obstacle->at(x.col(nodes[k]) - displacement).gap <= gap) expected.push_back(static_cast<std::int32_t>(k));
      const std::size_t count = obstacle->within(gap, x, nodes, displacement, near.data());
      EXPECT_EQ(std::vector<std::int32_t>(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(count)), expected)
          << named.name;
      found += count;
    }
  }
  EXPECT_GT(found, 5000u);
}

/// Springs of every kind and contact with every obstacle, on `nodes` nodes at random places around the origin.
struct Made {
  DiscreteForces forces;
  NodeVectors x;
  Made(std::int32_t nodes, std::uint64_t seed, double friction = 0) : forces(nodes) {
    test::Random random(seed);
    x = random.nodeVectors(nodes, 1);
    std::vector<Spring> springs;
    for (int i = 0; i < nodes; ++i) {
      Spring spring;
      spring.node = i;
      spring.stiffness = random.uniform(0, 10);
      spring.damping = random.uniform(0, 1);
      const auto kind = random.index(5);
      if (kind == 0) spring.anchor = random.vector(1);
      if (kind == 1) spring.direction = random.vector(1).normalized();
      if (kind >= 2) spring.other = static_cast<std::int32_t>((i + 1 + random.index(nodes - 1)) % nodes);
      if (kind >= 3) spring.length = random.uniform(0.1, 2);
      springs.push_back(spring);
    }
    forces.add(springs);
    for (const NamedObstacle& named : allObstacles()) {
      PenaltyContact contact;
      contact.obstacle = forces.add(named.make());
      forces.place(contact.obstacle, random.vector(0.1), random.vector(1));
      for (std::int32_t i = 0; i < nodes; ++i)
        if (random.index(2) == 0) {
          contact.nodes.push_back(i);
          contact.penalty.push_back(random.uniform(0, 10));
          contact.damping.push_back(random.uniform(0, 1));
        }
      contact.friction = friction;
      contact.slip.speed = 0.3;
      forces.add(std::move(contact));
    }
  }
};

TEST(DiscreteForces, ForcesAreDerivativesOfTheEnergyAndTangentsOfForces) {
  int compared = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const Made made(6, seed);
    test::Random random(seed + 1000);
    const NodeVectors u = random.nodeVectors(6, 1);
    constexpr double h = 1e-6;
    const NodeVectors after = made.x + h * u, before = made.x - h * u;
    NodeVectors f = NodeVectors::Zero(3, 6), fAfter = f, fBefore = f, Ku = f;
    made.forces.addInternalForce(made.x, f);
    const double slope = (made.forces.energy(after) - made.forces.energy(before)) / (2 * h);
    EXPECT_NEAR(f.cwiseProduct(u).sum(), slope, 1e-6 * (1 + f.norm())) << seed;
    made.forces.addInternalForce(after, fAfter);
    made.forces.addInternalForce(before, fBefore);
    made.forces.addTangentProduct(made.x, u, Ku);
    const NodeVectors difference = (fAfter - fBefore) / (2 * h);
    EXPECT_LE((denseOf(made.forces, made.x) * u.reshaped() - Ku.reshaped()).norm(), 1e-12 * Ku.norm()) << seed;
    EXPECT_NEAR(made.forces.form(made.x, u), u.cwiseProduct(Ku).sum(), 1e-12 * Ku.norm() * u.norm());
    // Contact that begins or ends in between, or an edge of a box, has no tangent there.
    if ((difference - Ku).norm() > 1e-5 * Ku.norm()) continue;
    ++compared;
  }
  EXPECT_GE(compared, 55);
}

TEST(DiscreteForces, DampingForcesAreThoseOfTheDampingMatrix) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Made made(6, seed);
    for (std::size_t k = 0; k < allObstacles().size(); ++k) made.forces.place(k, Vector3d::Zero(), Vector3d::Zero());
    test::Random random(seed + 1000);
    const NodeVectors v = random.nodeVectors(6, 1);
    NodeVectors force = NodeVectors::Zero(3, 6), Kv = force, both = force;
    made.forces.addDampingForce(made.x, v, force);
    made.forces.setDampingFactor(0);
    made.forces.addTangentProduct(made.x, v, Kv);
    made.forces.addTangentProduct(made.x, v, both, 7.0);
    EXPECT_LE((7 * force - (both - Kv)).norm(), 1e-12 * both.norm()) << seed;
    EXPECT_GE(force.cwiseProduct(v).sum(), 0) << seed;
  }
}

TEST(DiscreteForces, FrictionResistsAlongTheSurface) {
  DiscreteForces forces(1);
  PenaltyContact contact;
  contact.obstacle = forces.add(planeObstacle({0, 0, 0}, {0, 0, 1}));
  contact.nodes = {0};
  contact.penalty = {100};
  contact.damping = {0};
  contact.friction = 0.5;
  contact.slip.speed = 0.01;
  forces.add(contact);
  forces.place(0, Vector3d::Zero(), {1, 0, 0});
  NodeVectors x(3, 1), v(3, 1), force = NodeVectors::Zero(3, 1);
  x << 0, 0, -0.02;  // a normal force of 2 N
  v << 4, 4, 7;      // 3 and 4 m/s along the surface
  forces.addDampingForce(x, v, force);
  EXPECT_LE((force - Vector3d(0.6, 0.8, 0)).norm(), 1e-15);
  v << 1.003, 0.004, 0;  // half of the speed at which it slips
  force.setZero();
  forces.addDampingForce(x, v, force);
  EXPECT_LE((force - 0.5 * Vector3d(0.6, 0.8, 0)).norm(), 3e-14);
  EXPECT_NEAR(forces.obstaclePower(x, v).damping, -0.3, 3e-14);
  EXPECT_EQ(forces.obstaclePower(x, v).elastic, 0);
  EXPECT_TRUE(forces.friction());
  EXPECT_TRUE(forces.damped());
  EXPECT_EQ(forces.contactState(x).touching, 1);
  EXPECT_DOUBLE_EQ(forces.contactState(x).deepest, 0.02);
}

TEST(DiscreteForces, MajorantsHoldWhicheverNodesTouch) {
  std::int64_t trials = 0;
  test::Random random(8);
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Made made(6, seed);
    made.forces.setDampingFactor(random.index(2) == 0 ? 0 : random.uniform(0, 20));
    made.forces.setReach(0.2);
    std::vector<Matrix3d> majorants, withRoom;
    made.forces.majorants(made.x, false, majorants);
    made.forces.majorants(made.x, true, withRoom);
    for (std::size_t k = 0; k < majorants.size(); ++k) {
      EXPECT_GE(test::leastEigenvalue(majorants[k]), 0);
      EXPECT_GE(test::leastEigenvalue(withRoom[k] - majorants[k]), -1e-12);
    }
    Eigen::MatrixXd bound = test::majorantOf(made.forces, made.x);
    for (int trial = 0; trial < 50; ++trial) {
      // Some of the nodes within reach touch: another state, whose contact is a subset of what majorants count.
      test::expectAbove(bound, denseOf(made.forces, made.x), static_cast<std::int64_t>(seed));
      ++trials;
      // A step along the plane's normal within the reach: the plane's contact toggles, round ones turn a little.
      made.x.col(random.index(6)) += random.vector(1e-4);
      bound = test::majorantOf(made.forces, made.x);
    }
  }
  EXPECT_EQ(trials, 5000);
}

TEST(DiscreteForces, OneLookServesAllCallsAtItsPositions) {
  std::int64_t touching = 0;
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    Made made(40, seed, 0.3);
    test::Random random(seed + 500);
    made.forces.setReach(random.index(2) == 0 ? 0 : random.uniform(0, 0.3));
    const NodeVectors v = random.nodeVectors(40, 1);
    struct All {
      NodeVectors force, damping;
      double energy;
      std::vector<Matrix3d> majorants, toCome;
      Eigen::MatrixXd tangent;
      bool operator==(const All&) const = default;
    };
    const std::vector<double> further(made.forces.nodes().size(), 0.1);
    const auto ask = [&](const NodeVectors& x) {
      All all{NodeVectors::Zero(3, 40), NodeVectors::Zero(3, 40), made.forces.energy(x), {}, {},
              denseOf(made.forces, x)};
      made.forces.addInternalForce(x, all.force);
      made.forces.addDampingForce(x, v, all.damping);
      made.forces.majorants(x, true, all.majorants);
      made.forces.majorantsToCome(x, further, all.toCome);
      return all;
    };
    const NodeVectors elsewhere = made.x + random.nodeVectors(40, 0.5);
    const All here = ask(made.x), there = ask(elsewhere);
    {
      const DiscreteForces::ContactAt contact(&made.forces, made.x);
      EXPECT_EQ(ask(made.x), here) << seed;
      EXPECT_EQ(ask(elsewhere), there) << seed;
    }
    touching += made.forces.contactState(made.x).touching;
    // The same array with other numbers.
    made.x = elsewhere;
    EXPECT_EQ(ask(made.x), there) << seed;
    // An obstacle that moves ends what was seen.
    const DiscreteForces::ContactAt contact(&made.forces, made.x);
    for (std::size_t k = 0; k < allObstacles().size(); ++k) made.forces.place(k, {0.2, 0.1, -0.3}, Vector3d::Zero());
    const All moved = ask(made.x);
    EXPECT_EQ(ask(NodeVectors(made.x)), moved) << seed;
    EXPECT_FALSE(moved == there) << seed;
  }
  EXPECT_GT(touching, 1000);
}

TEST(DiscreteForces, CountContactWithinReach) {
  DiscreteForces forces(2);
  PenaltyContact contact;
  contact.obstacle = forces.add(planeObstacle({0, 0, 0}, {0, 0, 1}));
  contact.nodes = {0, 1};
  contact.penalty = {100, 100};
  contact.damping = {0, 0};
  forces.add(contact);
  NodeVectors x(3, 2);
  x << 0, 0, 0, 0, 0.01, 0.03;
  std::vector<Matrix3d> majorants;
  forces.majorants(x, false, majorants);
  EXPECT_EQ(majorants[0].norm(), 0);
  forces.setReach(0.02);
  forces.majorants(x, false, majorants);
  EXPECT_NEAR(majorants[0](2, 2), 100, 1e-6);
  EXPECT_EQ(majorants[1].norm(), 0);
  EXPECT_EQ(denseOf(forces, x).norm(), 0);  // from below only what touches counts
}

TEST(DiscreteForces, ArePartOfABody) {
  for (const char* element : {"tet4", "hex8"}) {
    Body body(test::distortedBox(element, {2, 2, 2}), makeMaterial("stvk", test::young, test::poisson, test::density));
    const NodeVectors x = test::strained(body.mesh().X);
    const Eigen::MatrixXd before = body.assembleTangent(x);
    Body::Workspace workspace;
    const double energy = body.energy(x, workspace);
    DiscreteForces forces(body.nodeCount());
    // Corners far from one another share no element.
    forces.add(std::vector<Spring>{{.node = 0, .other = body.nodeCount() - 1, .length = 0.01, .stiffness = 300},
                                   {.node = 1, .other = 2, .length = 0.01, .stiffness = 200},
                                   {.node = 3, .direction = Vector3d(0, 0, 1), .stiffness = 100}});
    PenaltyContact contact;
    contact.obstacle = forces.add(sphereObstacle({0, 0, 0}, 0.015, false));
    contact.nodes.resize(body.nodeCount());
    std::iota(contact.nodes.begin(), contact.nodes.end(), 0);
    contact.penalty.assign(body.nodeCount(), 500);
    contact.damping.assign(body.nodeCount(), 0);
    forces.add(contact);
    ASSERT_GT(forces.contactState(x).touching, 0);
    const Eigen::MatrixXd own = denseOf(forces, x);
    const double ownEnergy = forces.energy(x);
    NodeVectors ownForce = NodeVectors::Zero(3, x.cols()), f;
    forces.addInternalForce(x, ownForce);
    body.internalForce(x, f, workspace);
    const NodeVectors expected = f + ownForce;
    const std::int64_t version = body.version();
    body.setDiscreteForces(std::move(forces));
    EXPECT_GT(body.version(), version);
    // Twice: the pattern is kept, the numbers are not.
    SparseTangent tangent;
    for (int pass = 0; pass < 2; ++pass) {
      body.assembleTangent(x, tangent);
      EXPECT_LE((Eigen::MatrixXd(tangent.matrix) - before - own).norm(), 1e-12 * before.norm()) << element << pass;
    }
    StepEvaluation evaluation;
    evaluation.wantsEnergy = true;
    body.evaluate(x, evaluation, workspace);
    EXPECT_LE((evaluation.internalForce - expected).norm(), 1e-14 * expected.norm());
    EXPECT_NEAR(evaluation.strainEnergy, energy + ownEnergy, 1e-14 * (energy + ownEnergy));
    NodeVectors Kv;
    const NodeVectors v = test::Random(4).nodeVectors(x.cols(), 1);
    body.tangentProduct(x, v, Kv, workspace);
    EXPECT_LE((Kv.reshaped() - tangent.matrix * v.reshaped()).norm(), 1e-12 * Kv.norm());

    // A part has its principal submatrix, the springs' other ends included.
    const std::vector<ElementRef> elements{{0, 0}};
    std::vector<std::int32_t> nodes;
    for (const std::int32_t node : body.blocks()[0]->nodesOf(0)) nodes.push_back(node);
    std::sort(nodes.begin(), nodes.end());
    const DiscreteForces part = body.discreteForces()->restrictedTo(nodes);
    const NodeVectors xPart = x(Eigen::all, nodes);
    Eigen::MatrixXd partTangent = denseOf(part, xPart);
    for (const std::int32_t other : body.discreteForces()->partners(nodes))
      EXPECT_TRUE(other == 0 || other == body.nodeCount() - 1 || other == 1 || other == 2);
    EXPECT_EQ(part.nodeCount(), static_cast<std::int32_t>(nodes.size()));
    EXPECT_GT(partTangent.norm(), 0);

    std::vector<std::vector<bool>> chosen{std::vector<bool>(body.mesh().blocks[0].elementCount(), true)};
    EXPECT_THROW(Body(body, chosen), InputError);
  }
}

TEST(DiscreteForces, RefuseWhatIsNoForce) {
  const auto text = [](const auto& call) {
    try {
      call();
    } catch (const InputError& fault) {
      return std::string(fault.what());
    }
    return std::string();
  };
  DiscreteForces forces(3);
  EXPECT_EQ(text([&] { forces.add(std::vector<Spring>{{.node = 3}}); }), "node 3: must be one of 3");
  EXPECT_EQ(text([&] { forces.add(std::vector<Spring>{{.node = 1, .other = 1}}); }),
            "node 1: a spring to the node itself");
  EXPECT_EQ(text([&] { forces.add(std::vector<Spring>{{.node = 1, .stiffness = -1}}); }),
            "stiffness = -1: must be >= 0");
  EXPECT_EQ(text([] { planeObstacle({0, 0, 0}, {0, 0, 0}); }), "normal = [0, 0, 0]: must be finite and not zero");
  EXPECT_EQ(text([] { sphereObstacle({0, 0, 0}, -1, false); }), "radius = -1 m: must be > 0");
  EXPECT_EQ(text([] {
              cylinderObstacle({0, 0, 0}, {0, 0, 1}, 1, 2.0, true);
            }),
            "length: a hollow cylinder has no ends; take one of the two out");
  EXPECT_EQ(text([&] { forces.add(PenaltyContact{.obstacle = 0, .nodes = {0}, .penalty = {1}, .damping = {0}}); }),
            "obstacle 0: there are 0");
}

}  // namespace
}  // namespace ringwatch
