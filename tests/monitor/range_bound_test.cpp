// What is proven for all stretches in a range, against dense eigenvalues of random states in it and closed forms.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>

#include <ringwatch/base/error.h>
#include <ringwatch/body/discrete_forces.h>
#include <ringwatch/meshes/surface.h>
#include <ringwatch/monitor/bounds/range_bound.h>
#include <ringwatch/monitor/critical_step.h>
#include <tests/monitor/monitor_cases.h>

namespace ringwatch {
namespace {

using ::testing::HasSubstr;

/// The largest eigenvalue of ∂P/∂F, Pa.
double topOf(const Material& material, const Eigen::Matrix3d& F) {
  Eigen::MatrixXd A(9, 9);
  for (int c = 0; c < 9; ++c) {
    Matrix3<double> unit = Matrix3<double>::zero();
    unit.m[c] = 1;
    const Matrix3<double> column = material.stressDifferential(test::toMatrix3(F), unit);
    for (int r = 0; r < 9; ++r) A(r, c) = column.m[r];
  }
  const Eigen::MatrixXd symmetric = 0.5 * (A + A.transpose());
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric, Eigen::EigenvaluesOnly).eigenvalues()[8];
}

std::vector<LawInfo> isotropicLaws() {
  std::vector<LawInfo> laws(allLaws().begin(), allLaws().end());
  std::erase_if(laws, [](const LawInfo& law) { return !law.isotropic; });
  return laws;
}

TEST(RangeBound, RefusesALawWithADirection) {
  EXPECT_THROW(largestModulus(makeMaterial("transversely-isotropic", test::young, test::poisson, 1), {0.9, 1.1}),
               InputError);
}

TEST(RangeBound, HoldsForTheModulusOfEveryStretchInTheRange) {
  test::Random random(31);
  for (const LawInfo& law : isotropicLaws())
    for (const StretchRange range : {StretchRange{0.7, 1.5}, StretchRange{0.3, 1.1}, StretchRange{1, 1}}) {
      const Material material = makeMaterial(law.name, test::young, test::poisson, test::density);
      const ModulusRange modulus = largestModulus(material, range);
      double largest = 0;
      for (int trial = 0; trial < 300; ++trial) {
        Eigen::Vector3d s = Eigen::Vector3d::NullaryExpr([&] { return random.uniform(range.low, range.high); });
        if (trial < 8)
          for (int i = 0; i < 3; ++i) s[i] = (trial >> i & 1) != 0 ? range.low : range.high;
        const double top = topOf(material, random.rotation() * s.asDiagonal() * random.rotation());
        largest = std::max(largest, top);
        ASSERT_LE(top, modulus.bound) << law.name << ", stretches " << s.transpose();
      }
      // Where 200 000 states did not suffice it is wider.
      EXPECT_LE(modulus.bound, (modulus.states < 200000 ? 1.0101 : 1.1) * modulus.reached) << law.name;
      // Corners are among the trials, and most laws have their largest modulus there.
      EXPECT_LE(modulus.bound, 1.1 * largest) << law.name << " " << range.low;
    }
}

TEST(RangeBound, HasTheModulusOfClosedForms) {
  // At rest all laws are linear: 3 λ + 2 μ. Linear everywhere. StVK between a and b is stiffest along b at (b, b, b):
  // S = (3 λ + 2 μ)(b² - 1)/2, and the stretches' matrix adds b² (3 λ + 2 μ).
  const Lame c = lameConstants(test::young, test::poisson);
  const double rest = 3 * c.lambda + 2 * c.mu;
  for (const LawInfo& law : isotropicLaws())
    EXPECT_NEAR(largestModulus(makeMaterial(law.name, test::young, test::poisson, 1), {1, 1}).bound, rest, 1e-10 * rest)
        << law.name;
  EXPECT_NEAR(largestModulus(makeMaterial("linear", test::young, test::poisson, 1), {0.5, 2}).bound, rest,
              1e-10 * rest);
  const double b = 1.4, expected = rest * (b * b + (b * b - 1) / 2);
  const double bound = largestModulus(makeMaterial("stvk", test::young, test::poisson, 1), {0.7, b}).bound;
  EXPECT_GE(bound, expected * (1 - 1e-12));
  EXPECT_LE(bound, 1.0101 * expected);
  // A neo-Hookean solid squeezed to a: μ + (μ - λ ln J)/a² + 3 λ/a² at (a, a, a).
  const double a = 0.5, logJ = 3 * std::log(a);
  const double squeezed = c.mu + (c.mu - c.lambda * logJ + 3 * c.lambda) / (a * a);
  const double neo = largestModulus(makeMaterial("neo-hookean", test::young, test::poisson, 1), {a, 1.2}).bound;
  EXPECT_GE(neo, squeezed * (1 - 1e-12));
  EXPECT_LE(neo, 1.0101 * squeezed);
}

/// A state of the body whose deformation gradients have their stretches in the range; empty where none was found.
std::optional<NodeVectors> stateIn(const Body& body, StretchRange range, test::Random& random) {
  const NodeVectors& X = body.mesh().X;
  const auto inside = [&](const NodeVectors& x) {
    for (const auto& block : body.blocks()) {
      std::vector<double> F(9 * block->rule().points.size() * lanes);
      for (std::int32_t e = 0; e < block->elementCount(); ++e) {
        std::int32_t pack[lanes];
        std::fill_n(pack, lanes, -1);
        pack[0] = e;
        TangentDrift drift[lanes];
        block->deformationOf(pack, x.data(), F.data(), drift);
        for (std::size_t q = 0; q < block->rule().points.size(); ++q) {
          Eigen::Matrix3d own;
          for (int i = 0; i < 9; ++i) own(i / 3, i % 3) = F[(9 * q + i) * lanes];
          const Eigen::Vector3d s = Eigen::JacobiSVD<Eigen::Matrix3d>(own).singularValues();
          if (!(own.determinant() > 0 && s[2] >= range.low && s[0] <= range.high)) return false;
        }
      }
    }
    return true;
  };
  Eigen::Vector3d s = Eigen::Vector3d::NullaryExpr([&] { return random.uniform(range.low, range.high); });
  if (random.index(3) == 0) s.setConstant(0.02 * range.low + 0.98 * range.high);
  const Eigen::Matrix3d F = random.rotation() * s.asDiagonal() * random.rotation();
  for (double share = 0.1; share > 1e-4; share *= 0.6) {
    NodeVectors x = F * X + random.nodeVectors(X.cols(), share * test::cellSize);
    if (inside(x)) return x;
  }
  return std::nullopt;
}

TEST(RangeBound, HoldsForDenseEigenvaluesOfStatesInTheRange) {
  const StretchRange range{0.75, 1.4};
  test::Random random(32);
  int tried = 0;
  double tightest = 0;
  for (const test::Subdivision& subdivision : test::allSubdivisions())
    for (const LawInfo& law : isotropicLaws()) {
      Body body = test::boxBody(subdivision, law.name, {2, 1, 1}, 0.15);
      if (random.index(2) == 0) test::holdBody(body, test::Hold::face, 3);
      const RangeStep step = rangeStep(body, range, StepRule(2.0));
      EXPECT_EQ(step.modulus.size(), body.blocks().size());
      for (int trial = 0; trial < 2; ++trial) {
        const std::optional<NodeVectors> x = stateIn(body, range, random);
        if (!x) continue;
        const double largest = test::DenseTangent(body, *x).largest();
        ASSERT_LE(largest, step.lambda.value) << subdivision.name << ", " << law.name;
        ASSERT_LE(step.safe, stepFor(largest, 2));
        tightest = std::max(tightest, largest / step.lambda.value);
        ++tried;
      }
    }
  EXPECT_GE(tried, 40);
  EXPECT_GE(tightest, 0.3);  // of lambda
}

TEST(RangeBound, IsNoWiderThanTheorySaysAtRest) {
  // A step of 0.5 to 0.8 of the true one at ν = 0.3, docs/theory/tangent_drift.md: κ = 3 λ + 2 μ for all directions.
  for (const test::Subdivision& subdivision : test::allSubdivisions()) {
    const Body body = test::boxBody(subdivision, "stvk");
    const double exact = stepFor(test::DenseTangent(body, body.mesh().X).largest(), 2);
    const double share = rangeStep(body, {1, 1}, StepRule(2.0)).safe / exact;
    EXPECT_GE(share, 0.5) << subdivision.name;
    EXPECT_LE(share, 0.9) << subdivision.name;
  }
}

TEST(RangeBound, CountsTheMeanOfARuleThatHasOne) {
  const test::Subdivision hexes{"", "hex8", 1, "", 0};
  BodyOptions options;
  options.rules["hex8"] = "selective";
  test::Random random(33);
  for (const LawInfo& law : isotropicLaws()) {
    const Body body(test::box(hexes, {2, 1, 1}, 0.1), makeMaterial(law.name, test::young, 0.4, test::density), options);
    const RangeStep step = rangeStep(body, {0.8, 1.3}, StepRule(2.0));
    for (int trial = 0; trial < 3; ++trial) {
      // One gradient for all points, so that the mean has it too.
      const Eigen::Vector3d s = Eigen::Vector3d::NullaryExpr([&] { return random.uniform(0.8, 1.3); });
      const NodeVectors x = random.rotation() * s.asDiagonal() * random.rotation() * body.mesh().X;
      EXPECT_LE(test::DenseTangent(body, x).largest(), step.lambda.value) << law.name;
    }
  }
}

/// Springs of all kinds, and every node against a floor, a ball and the inside of a cylinder, which the body can be in
/// to any depth. stiffness: of the stiffest, N/m.
DiscreteForces forcesOf(const Body& body, double stiffness, test::Random& random) {
  DiscreteForces forces(body.nodeCount());
  const auto constant = [&] { return stiffness * std::pow(10.0, -random.uniform(0, 2)); };
  const Eigen::Vector3d middle = body.mesh().X.rowwise().mean();
  std::vector<Spring> springs;
  for (int i = 0; i < 8; ++i) {
    Spring spring;
    spring.node = static_cast<std::int32_t>(random.index(body.nodeCount()));
    spring.stiffness = constant();
    spring.damping = 1e-4 * constant();
    spring.anchor = middle;
    if (i == 1) spring.direction = random.vector(1).normalized();
    if (i >= 2)
      spring.other =
          (spring.node + 1 + static_cast<std::int32_t>(random.index(body.nodeCount() - 1))) % body.nodeCount();
    if (i >= 4) spring.length = random.uniform(0.1, 3) * test::cellSize;
    springs.push_back(spring);
  }
  forces.add(springs);
  const auto touch = [&](std::unique_ptr<Obstacle> obstacle) {
    PenaltyContact contact;
    contact.obstacle = forces.add(std::move(obstacle));
    for (std::int32_t i = 0; i < body.nodeCount(); ++i) contact.nodes.push_back(i);
    contact.penalty.assign(contact.nodes.size(), constant());
    contact.damping.assign(contact.nodes.size(), 1e-4 * constant());
    forces.add(std::move(contact));
  };
  touch(planeObstacle(middle, random.vector(1).normalized()));
  touch(sphereObstacle(middle + random.vector(test::cellSize), test::cellSize, false));
  touch(cylinderObstacle(middle + random.vector(test::cellSize), random.vector(1).normalized(),
                         random.uniform(0.05, 1) * test::cellSize, {}, true));
  if (random.index(2) == 0) forces.setDampingFactor(random.uniform(0, 1e4));
  return forces;
}

// Theorem 66: whatever touches, however deep, and however long springs are.
TEST(RangeBound, CountsSpringsAndObstaclesWhereverNodesAre) {
  const StretchRange range{0.75, 1.4};
  test::Random random(34);
  int tried = 0, touching = 0;
  std::array<double, 3> tightest{};
  constexpr std::array<double, 3> shares{0.1, 1, 30};  // of an element's own stiffness
  for (const test::Subdivision& subdivision : test::allSubdivisions())
    for (std::size_t s = 0; s < shares.size(); ++s) {
      Body body = test::boxBody(subdivision, "stvk", {2, 1, 1}, 0.15);
      if (random.index(2) == 0) test::holdBody(body, test::Hold::components, 3);
      body.setDiscreteForces(forcesOf(body, shares[s] * test::young * test::cellSize, random));
      const RangeStep step = rangeStep(body, range, StepRule(2.0));
      for (int trial = 0; trial < 6; ++trial) {
        std::optional<NodeVectors> x = stateIn(body, range, random);
        if (!x) continue;
        x->colwise() += random.vector(3 * test::cellSize);
        touching += body.discreteForces()->contactState(*x).touching > 0;
        const double largest = test::DenseTangent(body, *x).largest();
        ASSERT_LE(largest, step.lambda.value) << subdivision.name << ", " << shares[s];
        tightest[s] = std::max(tightest[s], largest / step.lambda.value);
        ++tried;
      }
    }
  EXPECT_GE(tried, 60);
  EXPECT_GE(touching, tried - 5);
  for (const double share : tightest) EXPECT_GE(share, 0.2);
  RecordProperty("tightest", joinText(tightest[0], " ", tightest[1], " ", tightest[2]));
}

// A light node that a stiff spring holds to the ground: λ = (k + f c)/m, which is all that counts. And two nodes that a
// spring ties, of the masses m and M: k (1/m + 1/M).
TEST(RangeBound, HasTheLimitOfAStiffSpring) {
  Body body = test::boxBody({"", "hex8", 1, "", 0}, "stvk", {1, 1, 1}, 0);
  const double m = body.lumpedMass()[0], k = 1e8 * test::young * test::cellSize;
  const auto lambdaWith = [&](const std::vector<Spring>& springs, double f) {
    DiscreteForces forces(body.nodeCount());
    forces.add(springs);
    forces.setDampingFactor(f);
    body.setDiscreteForces(std::move(forces));
    return rangeStep(body, {0.9, 1.1}, StepRule(2.0)).lambda.value;
  };
  EXPECT_NEAR(lambdaWith({{.node = 0, .stiffness = k, .damping = 1e-3 * k}}, 500) / (1.5 * k / m), 1, 1e-6);
  EXPECT_NEAR(lambdaWith({{.node = 0, .other = 7, .length = 1, .stiffness = k}}, 0) / (2 * k / m), 1, 1e-6);
}

TEST(RangeBound, RefusesWhatItCannotProve) {
  const auto refused = [](std::string_view law, StretchRange range) -> std::string {
    try {
      largestModulus(makeMaterial(law, test::young, test::poisson, 1), range);
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_THAT(refused("stvk", {0, 1}), HasSubstr("0 to 1 is no range of stretches; must be two numbers a <= b"));
  EXPECT_THAT(refused("stvk", {1.2, 1.1}), HasSubstr("1.2 to 1.1"));
  EXPECT_EQ(refused("neo-hookean", {0.9, 1.1}), "accepted");

  const auto refusedWith = [](const std::function<void(DiscreteForces&, const Mesh&)>& add) -> std::string {
    Body body = test::boxBody({"", "hex8", 1, "", 0}, "stvk", {1, 1, 1}, 0);
    DiscreteForces forces(body.nodeCount());
    add(forces, body.mesh());
    body.setDiscreteForces(std::move(forces));
    try {
      rangeStep(body, {0.9, 1.1}, StepRule(2.0));
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_THAT(refusedWith([](DiscreteForces& forces, const Mesh&) {
                const std::size_t floor = forces.add(planeObstacle({0, 0, 0}, {0, 0, 1}));
                forces.add(PenaltyContact{floor, {0}, {1}, {0}, 0.2, 0.1});
              }),
              HasSubstr("stretch: contact has friction"));
  EXPECT_THAT(refusedWith([](DiscreteForces& forces, const Mesh& mesh) {
                SurfaceContact contact = surfaceContact(mesh, {0}, surfaceNodes(mesh));
                contact.penalty = {1};
                contact.damping = {0};
                forces.add(std::move(contact));
              }),
              HasSubstr("stretch: contact of surfaces"));
}

}  // namespace
}  // namespace ringwatch
