// Elements that damp: forces in closed form, their derivative by the velocities, and what counts of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/body/body.h>
#include <ringwatch/body/sub_body.h>
#include <tests/support/body_cases.h>
#include <tests/support/random.h>

namespace ringwatch {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;

constexpr DampingConstants all{0.06, 1.2, 3.0, 7.0, 2.5};

/// The elements of a distorted box, each rule of each element once. Those of uniform strain have hourglass viscosity
/// where others damp by more than their mass.
std::vector<test::BodyCase> casesOfRules() {
  std::vector<test::BodyCase> cases;
  for (const test::BodyCase& c : test::allBodyCases())
    if (c.law == "stvk") cases.push_back(c);
  return cases;
}
Body damped(const test::BodyCase& c, const DampingConstants& damping, test::Cells cells = {1, 1, 1}, int threads = 1) {
  Body body(test::distortedBox(c.element->name, cells), test::materialOf(c), test::optionsOf(c, threads));
  DampingConstants own = damping;
  if (c.rule->uniformStrain && damping.bulk() && damping.viscous()) own.hourglassViscosity = 0.1;
  body.setElementDamping(std::vector<DampingConstants>(body.blocks().size(), own));
  return body;
}
NodeVectors forceOf(const Body& body, const NodeVectors& x, const NodeVectors& v) {
  Body::Workspace workspace;
  NodeVectors force = NodeVectors::Zero(3, x.cols());
  body.addElementDampingForce(x, v, force, workspace);
  return force;
}
double powerOf(const NodeVectors& force, const NodeVectors& v) { return force.cwiseProduct(v).sum(); }
/// f C of what counts, from tangents.
MatrixXd countedDamping(Body& body, const NodeVectors& x) {
  body.elementDamping()->setFactor(0);
  const MatrixXd K = body.assembleTangent(x);
  body.elementDamping()->setFactor(1);
  const MatrixXd all = body.assembleTangent(x);
  return all - K;
}

TEST(ElementDamping, OneElementOfEachTypeUnderUniformDilationIsInClosedForm) {
  int elements = 0;
  std::vector<test::BodyCase> cases;
  for (const ElementInfo& element : allElements()) cases.push_back({&element, "stvk", true, &element.rules.front()});
  const ElementInfo& hexahedron = *findElementByName("hex8");
  cases.push_back({&hexahedron, "stvk", true, findRule(hexahedron, "uniform-strain")});
  for (const test::BodyCase& c : cases) {
    const ElementInfo& element = *c.element;
    const Mesh one = test::firstElements(test::distortedBox(element.name, {1, 1, 1}), 1);
    const Material material = test::materialOf(c);
    const double speed = material.waveSpeed();
    for (const double stretch : {1.0, 0.7, 1.2})
      for (const double rate : {-3.0, 2.0}) {
        Body body(one, material, test::optionsOf(c));
        const double rest = body.volume(), volume = rest * std::pow(stretch, 3), L = std::cbrt(rest);
        const NodeVectors x = stretch * body.mesh().X, v = rate / 3 * x;
        const double density = test::density / std::pow(stretch, 3);
        const double linear = density * L * 0.06 * speed * rate,
                     square = rate < 0 ? density * std::pow(1.2 * L * rate, 2) : 0;
        body.setElementDamping({{0.06, 1.2, 0, 0, 0}});
        const NodeVectors bulk = forceOf(body, x, v);
        // The pressure q = square - linear on the surface; the derivative of the volume by a node's position is what it
        // acts on, of the mesh moved there: by finite differences of its volume.
        for (std::int32_t a = 0; a < body.nodeCount(); ++a)
          for (int i = 0; i < 3; ++i) {
            const double h = 1e-4 * L;
            Mesh after = one, before = one;
            after.X = before.X = x;
            after.X(i, a) += h;
            before.X(i, a) -= h;
            const double slope = (Body(after, material, test::optionsOf(c)).volume() -
                                  Body(before, material, test::optionsOf(c)).volume()) /
                                 (2 * h);
            EXPECT_NEAR(bulk(i, a), (linear - square) * slope, 3e-7 * std::abs(linear - square) * L * L)
                << element.name << stretch << rate;
          }
        EXPECT_NEAR(powerOf(bulk, v), (linear - square) * rate * volume, 1e-12 * std::abs(linear * rate * volume))
            << element.name;
        // Kelvin-Voigt: S = volumeViscosity tr(Ė) I, Ė = stretch² rate/3 I.
        Body viscous(one, material, test::optionsOf(c));
        viscous.setElementDamping({{0, 0, 3, 7, 0}});
        const double trace = stretch * stretch * rate;
        EXPECT_NEAR(powerOf(forceOf(viscous, x, v), v), 7 * trace * trace * rest, 1e-12 * 7 * trace * trace * rest)
            << element.name;
        ++elements;
      }
  }
  EXPECT_EQ(elements, 6 * static_cast<int>(cases.size()));
}

TEST(ElementDamping, KelvinVoigtIsObjectiveAndHasItsPowerInShear) {
  test::Random random(4);
  for (const test::BodyCase& c : casesOfRules()) {
    Body body = damped(c, {0, 0, 3, 7, 0}, {2, 1, 1});
    const NodeVectors& X = body.mesh().X;
    const Matrix3d F = Matrix3d::Identity() + random.matrix(0.2), dF = random.matrix(5), R = random.rotation();
    const NodeVectors x = F * X, v = dF * X;
    const Matrix3d rate = 0.5 * (F.transpose() * dF + dF.transpose() * F);
    const Matrix3d deviator = rate - rate.trace() / 3 * Matrix3d::Identity();
    double rest = 0, volumes[lanes];
    for (std::int32_t batch = 0; batch < body.blocks()[0]->layout().batchCount(); ++batch) {
      body.blocks()[0]->volumeBatch(batch, volumes);
      for (const double volume : volumes) rest += volume;
    }
    const double expected = (7 * rate.trace() * rate.trace() + 2 * 3 * deviator.squaredNorm()) * rest;
    const NodeVectors force = forceOf(body, x, v);
    EXPECT_NEAR(powerOf(force, v), expected, 1e-11 * expected) << test::bodyCaseName(c);
    // A body that turns with it, at any rate of turning, feels the turned forces.
    const Matrix3d spin = 40 * (R - R.transpose());
    EXPECT_LE((forceOf(body, R * x, R * v + spin * (R * x)) - R * force).norm(), 3e-10 * force.norm())
        << test::bodyCaseName(c);
  }
}

TEST(ElementDamping, MassDampingActsOnTheElementsMass) {
  for (const test::BodyCase& c : casesOfRules()) {
    Body body = damped(c, {0, 0, 0, 0, 2.5}, {2, 1, 1});
    body.addNodalMass(0, 5);  // which no element has
    Body alone(body.mesh(), test::materialOf(c), test::optionsOf(c));
    const NodeVectors v = test::Random(2).nodeVectors(body.nodeCount(), 1);
    const NodeVectors expected = 2.5 * v * alone.lumpedMass().asDiagonal();
    EXPECT_LE((forceOf(body, body.mesh().X, v) - expected).norm(), 1e-14 * expected.norm()) << test::bodyCaseName(c);
  }
}

// C is the derivative of the forces by the velocities, symmetric and without negative eigenvalues; where it depends on
// the velocities a little more of it counts.
TEST(ElementDamping, DerivativeByVelocitiesIsSymmetricAndSemidefinite) {
  int counted = 0;
  for (const test::BodyCase& c : casesOfRules()) {
    for (const bool quadratic : {false, true}) {
      DampingConstants constants = all;
      if (!quadratic) constants.quadraticBulk = 0;
      Body body = damped(c, constants, {2, 1, 1});
      const NodeVectors x = test::strained(body.mesh().X), v = test::Random(9).nodeVectors(body.nodeCount(), 1);
      body.followDampingRates(x, v);
      const MatrixXd C = countedDamping(body, x);
      EXPECT_LE((C - C.transpose()).norm(), 1e-12 * C.norm());
      const Eigen::VectorXd eigenvalues = Eigen::SelfAdjointEigenSolver<MatrixXd>(C).eigenvalues();
      EXPECT_GE(eigenvalues[0], -1e-11 * C.norm()) << test::bodyCaseName(c);
      MatrixXd differences(C.rows(), C.cols());
      const double h = 1e-6;
      for (Eigen::Index k = 0; k < C.cols(); ++k) {
        NodeVectors after = v, before = v;
        after.data()[k] += h;
        before.data()[k] -= h;
        const NodeVectors slope = (forceOf(body, x, after) - forceOf(body, x, before)) / (2 * h);
        differences.col(k) = Eigen::Map<const Eigen::VectorXd>(slope.data(), slope.size());
      }
      if (!quadratic) {
        EXPECT_LE((C - differences).norm(), 1e-7 * C.norm()) << test::bodyCaseName(c);
        continue;
      }
      const double rounding = 1e-7 * C.norm();
      const Eigen::VectorXd above = Eigen::SelfAdjointEigenSolver<MatrixXd>(C - differences).eigenvalues(),
                            below = Eigen::SelfAdjointEigenSolver<MatrixXd>(1.05 * differences - C).eigenvalues();
      EXPECT_GE(above[0], -rounding) << test::bodyCaseName(c);
      EXPECT_GE(below[0], -rounding) << test::bodyCaseName(c);
      counted += above[above.size() - 1] > 1e-3 * C.norm();
    }
  }
  EXPECT_GT(counted, 3);
}

TEST(ElementDamping, ProductsFormsAndPartsAgreeWithTheMatrix) {
  for (const test::BodyCase& c : casesOfRules()) {
    Body body = damped(c, all, {2, 2, 1});
    const NodeVectors x = test::strained(body.mesh().X), v = test::Random(9).nodeVectors(body.nodeCount(), 1);
    body.followDampingRates(x, v);
    const MatrixXd C = countedDamping(body, x);
    body.elementDamping()->setFactor(0);
    const MatrixXd K = body.assembleTangent(x);
    body.elementDamping()->setFactor(70);
    const Eigen::Map<const Eigen::VectorXd> flat(v.data(), v.size());
    Body::Workspace workspace;
    NodeVectors product;
    const auto isProduct = [&](const MatrixXd& A) {
      const Eigen::VectorXd expected = A * flat;
      EXPECT_LE((Eigen::Map<const Eigen::VectorXd>(product.data(), product.size()) - expected).norm(),
                1e-12 * (K + 70 * C).norm() * flat.norm())
          << test::bodyCaseName(c);
    };
    body.tangentProduct(x, v, product, workspace);
    isProduct(K + 70 * C);
    body.tangentProduct(x, v, product, workspace, 0.0);
    isProduct(K);
    body.tangentProduct(x, v, product, workspace, 200.0);
    isProduct(K + 200 * C);
    const double form = 70 * flat.dot(C * flat);
    EXPECT_NEAR(body.elementDampingForm(x, v, workspace), form, 1e-12 * form);

    // A part counts what the whole does, wherever that changes.
    std::vector<ElementRef> some;
    for (std::int32_t e = 1; e < body.blocks()[0]->elementCount(); e += 2) some.push_back({0, e});
    std::vector<std::int32_t> nodes(body.nodeCount());
    for (std::int32_t i = 0; i < body.nodeCount(); ++i) nodes[i] = i;
    const Body part = subBody(body, some, nodes, body.lumpedMass(), 1);
    for (const double faster : {1.0, 30.0}) {
      body.followDampingRates(x, faster * v);
      MatrixXd expected = MatrixXd::Zero(C.rows(), C.cols());
      for (const ElementRef e : some) {
        const MatrixXd own = body.elementTangent(e, x);
        const auto at = body.blocks()[0]->nodesOf(e.element);
        for (std::size_t a = 0; a < at.size(); ++a)
          for (std::size_t b = 0; b < at.size(); ++b)
            expected.block<3, 3>(3 * at[a], 3 * at[b]) +=
                own.block<3, 3>(3 * static_cast<Eigen::Index>(a), 3 * static_cast<Eigen::Index>(b));
      }
      EXPECT_LE((MatrixXd(part.assembleTangent(x)) - expected).norm(), 1e-12 * expected.norm())
          << test::bodyCaseName(c);
    }
  }
}

// Forces of elements and of their damping, in one pass and in two; of every law, as each has a kernel of its own.
TEST(ElementDamping, OnePassHasTheForcesOfTwo) {
  class SeesAll final : public PatchVisitor {
   public:
    // By turns of batches with a common centre and with centres of their own.
    void visitPatch(std::size_t, const PatchPass& pass) override {
      constexpr std::size_t mostPoints = 64;
      const auto batches = static_cast<std::size_t>(pass.patch().batchEnd);
      const std::vector<double> centre(BatchBalls::centreSize * batches);
      const std::vector<RoundedDown<Bfloat16>> radius(batches * lanes, infinity);
      const std::vector<std::int16_t> ownCentre(9 * batches * mostPoints * lanes);
      std::vector<std::uint8_t> diagonal(batches), byOwn(batches), left(batches, 1);
      for (std::size_t batch = 0; batch < batches; ++batch) {
        diagonal[batch] = batch / 2 % 2;
        byOwn[batch] = batch % 2;
      }
      const BatchBalls balls{centre.data(), diagonal.data(), radius.data(), byOwn.data(), ownCentre.data(), 1,
                             radius.data(), left.data()};
      pass.run(&balls);
      for (auto batch = static_cast<std::size_t>(pass.patch().batchBegin); batch < batches; ++batch)
        EXPECT_EQ(left[batch], 0);
    }
  } visitor;
  // The two energies come of loops of their own, which Clang 14 rounds otherwise (3.2e-16 measured) and GCC alike.
#ifdef __clang__
  constexpr double energyRounding = 9e-16;
#else
  constexpr double energyRounding = 0;
#endif
  for (const test::BodyCase& c : test::allBodyCases())
    for (const DampingConstants& constants : {DampingConstants{0.06, 1.2, 0, 0, 0}, {0.06, 0, 0, 0, 0}, all}) {
      const Body body = damped(c, constants, {2, 1, 1});
      const NodeVectors x = test::strained(body.mesh().X), v = test::Random(9).nodeVectors(body.nodeCount(), 3);
      Body::Workspace workspace;
      NodeVectors elastic, both;
      body.internalForce(x, elastic, workspace);
      const NodeVectors damping = forceOf(body, x, v);
      body.resistingForce(x, v, both, workspace);
      const double size = elastic.norm() + damping.norm();
      EXPECT_GT(damping.norm(), 0.03 * size) << test::bodyCaseName(c);
      EXPECT_LE((both - elastic - damping).norm(), 1.5e-15 * size) << test::bodyCaseName(c);
      StepEvaluation evaluation;
      evaluation.velocities = &v;
      evaluation.wantsEnergy = true;
      evaluation.visitor = &visitor;
      body.evaluate(x, evaluation, workspace);
      EXPECT_EQ(evaluation.internalForce, both) << test::bodyCaseName(c);
      const double energy = body.energy(x, workspace);
      EXPECT_NEAR(evaluation.strainEnergy, energy, energyRounding * energy) << test::bodyCaseName(c);
      evaluation.velocities = nullptr;
      body.evaluate(x, evaluation, workspace);
      EXPECT_EQ(evaluation.internalForce, elastic) << test::bodyCaseName(c);
    }
}

// What lies within a rigid body has no forces of its own and damps all the same.
TEST(ElementDamping, RigidElementsDampInOnePassToo) {
  const test::BodyCase c = casesOfRules().front();
  Body body(test::distortedBox(c.element->name, {2, 1, 1}), test::materialOf(c), test::optionsOf(c));
  std::vector<std::int32_t> nodes(body.nodeCount());
  for (std::int32_t i = 0; i < body.nodeCount(); ++i) nodes[i] = i;
  body.tie("all", nodes);
  body.setElementDamping({{0.06, 1.2, 0, 0, 2.5}});
  const NodeVectors x = test::strained(body.mesh().X), v = test::Random(9).nodeVectors(body.nodeCount(), 3);
  Body::Workspace workspace;
  NodeVectors both;
  body.resistingForce(x, v, both, workspace);
  const NodeVectors damping = forceOf(body, x, v);
  EXPECT_GT(damping.norm(), 0);
  EXPECT_EQ(both, damping);
}

// Volumes by the element's own rule, in plain doubles, and their differences: hexahedra take them from their modes.
TEST(ElementDamping, VolumesAndTheirGradientsAreThoseOfTheRule) {
  for (const test::BodyCase& c : casesOfRules()) {
    const Body body = damped(c, {0.06, 0, 0, 0, 0}, {2, 1, 1});
    const DampedBlock& block = *body.elementDamping()->blocks()[0];
    const int n = block.nodesPerElement();
    test::Random random(12);
    const NodeVectors x =
        random.rotation() * test::strained(body.mesh().X) + random.nodeVectors(body.nodeCount(), 0.1 * test::cellSize);
    const auto volumeOf = [&](std::int32_t e, const NodeVectors& at) {
      double volume = 0, dN[maxElementNodes][3];
      const auto gradientOf = [&](const NodeVectors& positions) {
        Matrix3d D = Matrix3d::Zero();
        for (int a = 0; a < n; ++a)
          D += (positions.col(block.nodesOf(e)[a]) - positions.col(block.nodesOf(e)[0])) *
               Eigen::RowVector3d(dN[a][0], dN[a][1], dN[a][2]);
        return D;
      };
      // Of uniform strain: the volume at rest times the determinant of the mean deformation gradient.
      const bool mean = block.rule().uniformStrain;
      Matrix3d F = Matrix3d::Zero();
      for (const QuadraturePoint& point :
           mean ? findRule(block.element(), "gauss-2x2x2")->points : block.rule().points) {
        block.element().shapeGradient(point.xi, dN);
        const Matrix3d D = gradientOf(mean ? body.mesh().X : at);
        volume += point.weight * D.determinant();
        if (mean) F += point.weight * D.determinant() * gradientOf(at) * D.inverse();
      }
      return mean ? volume * (F / volume).determinant() : volume;
    };
    std::vector<double> gradient(static_cast<std::size_t>(3 * n * lanes));
    double volumes[lanes];
    block.volumeGradient(0, x.data(), volumes, gradient.data());
    for (int lane = 0; lane < lanes; ++lane) {
      const std::int32_t e = block.layout().elements[lane];
      if (e < 0) continue;
      const double expected = volumeOf(e, x), size = std::cbrt(expected);
      EXPECT_NEAR(volumes[lane], expected, 1e-13 * expected) << test::bodyCaseName(c);
      for (int k = 0; k < 3 * n; ++k) {
        // The volume is at most quadratic in one coordinate: the difference is exact but for rounding.
        const double h = 0.1 * size;
        NodeVectors after = x, before = x;
        after(k % 3, block.nodesOf(e)[k / 3]) += h;
        before(k % 3, block.nodesOf(e)[k / 3]) -= h;
        EXPECT_NEAR(gradient[static_cast<std::size_t>(k * lanes + lane)],
                    (volumeOf(e, after) - volumeOf(e, before)) / (2 * h), 1e-13 * size * size)
            << test::bodyCaseName(c);
      }
    }
  }
}

// What rounding is said to be covers how much two tangents of one state differ that are rounded otherwise.
TEST(ElementDamping, RoundingOfTangentsIsBoundedAndSmall) {
  for (const test::BodyCase& c : casesOfRules()) {
    Body body = damped(c, all, {2, 2, 1});
    body.elementDamping()->setFactor(100);
    const NodeVectors x = test::strained(body.mesh().X);
    Body::Workspace workspace;
    const Eigen::VectorXd T = body.tangentRounding(x, workspace);
    EXPECT_TRUE(T.allFinite()) << test::bodyCaseName(c);
    const MatrixXd K = body.assembleTangent(x);
    // Turned by a right angle nothing is rounded alike but positions.
    Matrix3d R;
    R << 0, -1, 0, 1, 0, 0, 0, 0, 1;
    const MatrixXd turned = body.assembleTangent(R * x);
    for (std::int32_t i = 0; i < body.nodeCount(); ++i) {
      EXPECT_LE(T[i], 1e-8 * K.norm()) << test::bodyCaseName(c);
      for (std::int32_t j = 0; j < body.nodeCount(); ++j) {
        const Matrix3d difference = R.transpose() * turned.block<3, 3>(3 * i, 3 * j) * R - K.block<3, 3>(3 * i, 3 * j);
        EXPECT_LE(difference.norm(), 2 * std::sqrt(T[i] * T[j])) << test::bodyCaseName(c);
      }
    }
  }
}

TEST(ElementDamping, GivesTheSameBitsForAnyNumberOfThreads) {
  const test::BodyCase c = casesOfRules().front();
  std::vector<NodeVectors> forces, together;
  std::vector<double> coefficients;
  for (const int threads : {1, 2, 4}) {
    Body body = damped(c, all, {8, 6, 6}, threads);
    const NodeVectors x = test::strained(body.mesh().X), v = test::Random(9).nodeVectors(body.nodeCount(), 1);
    forces.push_back(forceOf(body, x, v));
    Body::Workspace workspace;
    StepEvaluation evaluation;
    evaluation.velocities = &v;
    body.evaluate(x, evaluation, workspace);
    together.push_back(evaluation.internalForce);
    body.followDampingRates(x, v);
    double sum = 0;
    for (std::size_t place = 0; place < body.blocks()[0]->layout().elements.size(); ++place)
      sum += body.elementDamping()->blocks()[0]->coefficient(place);
    coefficients.push_back(sum);
    EXPECT_EQ(forces.back(), forces.front());
    EXPECT_EQ(together.back(), together.front());
    EXPECT_EQ(coefficients.back(), coefficients.front());
  }
}

// Coefficients that count stay while they are neither too small nor too large.
TEST(ElementDamping, CoefficientsFollowTheRatesWithinTheirShare) {
  const test::BodyCase c = casesOfRules().front();
  Body body = damped(c, {0.06, 1.2, 0, 0, 0}, {2, 2, 2});
  const DampedBlock& block = *body.elementDamping()->blocks()[0];
  const double time = std::cbrt(body.volume() / body.blocks()[0]->elementCount()) / test::materialOf(c).waveSpeed();
  const NodeVectors& X = body.mesh().X;
  int changes = 0, kept = 0;
  double before = block.coefficient(0);
  EXPECT_EQ(before, 0.06);
  double volumes[lanes];
  body.blocks()[0]->volumeBatch(0, volumes);
  const double own = std::cbrt(volumes[0]) / test::materialOf(c).waveSpeed();
  for (int k = 0; k <= 400; ++k) {
    const double rate = -0.3 / time * std::sin(0.05 * k);
    body.followDampingRates(X, rate / 3 * X);
    const double needed = 0.06 + 2 * 1.44 * own * std::max(-rate, 0.0), counted = block.coefficient(0);
    EXPECT_GE(counted, needed * (1 - 1e-12));
    EXPECT_LE(counted, needed * (1 + DampedBlock::overcount) * (1 + 1e-12));
    changes += counted != before;
    kept += counted == before;
    before = counted;
  }
  EXPECT_GT(changes, 10);
  EXPECT_GT(kept, 50);
  body.elementDamping()->forgetRates();
  EXPECT_EQ(block.coefficient(0), 0.06);
}

// A part damps as it does in the whole, and two parts that are all of it together as the whole does.
TEST(ElementDamping, PartsOfABodyDampAsInTheWhole) {
  for (const test::BodyCase& c : casesOfRules()) {
    Body whole = damped(c, all, {2, 2, 1});
    whole.elementDamping()->setFactor(0.3);
    std::vector<std::vector<bool>> one, other;
    for (const auto& block : whole.blocks()) {
      one.emplace_back(block->elementCount());
      other.emplace_back(block->elementCount());
      for (std::int32_t e = 0; e < block->elementCount(); ++e) (e % 3 == 0 ? one : other).back()[e] = true;
    }
    Body first(whole, one), second(whole, other);
    const NodeVectors x = test::strained(whole.mesh().X), v = test::Random(9).nodeVectors(whole.nodeCount(), 1);
    for (Body* body : {&whole, &first, &second}) body->followDampingRates(x, v);
    const NodeVectors force = forceOf(whole, x, v), parts = forceOf(first, x, v) + forceOf(second, x, v);
    EXPECT_LE((force - parts).norm(), 1e-12 * force.norm()) << test::bodyCaseName(c);
    EXPECT_EQ(first.elementDamping()->factor(), 0.3);
    const MatrixXd tangent = whole.assembleTangent(x);
    EXPECT_LE((tangent - MatrixXd(first.assembleTangent(x)) - MatrixXd(second.assembleTangent(x))).norm(),
              1e-12 * tangent.norm())
        << test::bodyCaseName(c);
  }
}

TEST(ElementDamping, AnElementWithoutVolumeDampsByATenthOfIt) {
  const test::BodyCase c = casesOfRules().front();
  Body body = damped(c, {0.06, 1.2, 0, 0, 0});
  const NodeVectors& X = body.mesh().X;
  const NodeVectors v = test::Random(9).nodeVectors(body.nodeCount(), 1);
  for (const double flat : {0.05, 0.0, -0.5}) {
    const NodeVectors x = Eigen::Vector3d(1, 1, flat).asDiagonal() * X;
    EXPECT_TRUE(forceOf(body, x, v).allFinite()) << flat;
    EXPECT_GE(powerOf(forceOf(body, x, v), v), 0) << flat;
    EXPECT_TRUE(countedDamping(body, x).allFinite()) << flat;
  }
}

TEST(ElementDamping, RefusesWhatItCannotHave) {
  const test::BodyCase c = casesOfRules().front();
  Body body(test::distortedBox(c.element->name, {1, 1, 1}), test::materialOf(c));
  const auto refuses = [&](const std::vector<DampingConstants>& constants, const std::string& text) {
    try {
      body.setElementDamping(constants);
      ADD_FAILURE() << text;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(text), std::string::npos) << error.what();
    }
  };
  refuses({}, "0 constants of damping for 1 blocks");
  refuses({{-1, 0, 0, 0, 0}}, "must be >= 0 and finite");
  refuses({{0, 0, std::nan(""), 0, 0}}, "must be >= 0 and finite");
  body.setElementDamping({all});
  refuses({all}, "has it already");
}

}  // namespace
}  // namespace ringwatch
