// Elements that damp in the bracket: both sides against dense eigenvalues of K + f C, from scratch and along runs, and
// the drift by which a proof is kept.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <ringwatch/base/error.h>
#include <ringwatch/monitor/bounds/rayleigh.h>
#include <ringwatch/monitor/certificate_file.h>
#include <ringwatch/monitor/incremental/tangent_growth.h>
#include <ringwatch/monitor/incremental/work_account.h>
#include <tests/monitor/bracket_checks.h>

namespace ringwatch {
namespace {

using test::DenseTangent;
using test::Hold;
using test::Subdivision;

/// Damping of all kinds that counts as much as the stiffness, and of each kind alone; of quadratic bulk viscosity or
/// without.
struct Kind {
  std::string name;
  DampingConstants constants;
};
std::vector<Kind> kinds() {
  // The damping of a cell is about that of its own stiffness at the factor 1e3/s.
  const double viscosity = test::young / 1e3;
  return {{"linear", {0.5, 0, 0, 0, 0}},
          {"quadratic", {0.06, 1.2, 0, 0, 0}},
          {"viscous", {0, 0, 0.4 * viscosity, viscosity, 0}},
          {"shear alone", {0, 0, viscosity, 0, 0}},
          {"mass", {0, 0, 0, 0, 300}},
          {"all", {0.2, 1.2, 0.1 * viscosity, 0.2 * viscosity, 100}}};
}
constexpr double factor = 1e3;

void damp(Body& body, const DampingConstants& constants) {
  body.setElementDamping(std::vector<DampingConstants>(body.blocks().size(), constants));
  body.elementDamping()->setFactor(factor);
}

constexpr std::string_view onePoint = "hex8_of_one_point";
/// All subdivisions, and hexahedra of uniform strain.
std::vector<Subdivision> cases() {
  std::vector<Subdivision> all = test::allSubdivisions();
  Subdivision own;
  own.element = "hex8";
  own.name = onePoint;
  all.push_back(own);
  return all;
}
Body elasticBox(const Subdivision& subdivision, std::string_view law, std::array<int, 3> cells = {2, 2, 2}) {
  if (subdivision.name != onePoint) return test::boxBody(subdivision, law, cells);
  return Body(test::box(subdivision, cells), makeMaterial(law, test::young, test::poisson, test::density),
              {{{"hex8", "uniform-strain"}}, Lumping::rowSum, 1, {0.1}});
}

class ElementDampingTest : public ::testing::TestWithParam<Subdivision> {};
INSTANTIATE_TEST_SUITE_P(Subdivisions, ElementDampingTest, ::testing::ValuesIn(cases()),
                         [](const auto& test) { return test::testName(test.param.name); });

TEST_P(ElementDampingTest, BracketsHoldFromScratch) {
  int brackets = 0, damped = 0;
  for (const Kind& kind : kinds())
    for (const std::string_view law : {"stvk", "neo-hookean", "corotational"})
      for (const Hold hold : {Hold::nothing, Hold::components}) {
        Body body = elasticBox(GetParam(), law);
        test::holdBody(body, hold);
        damp(body, kind.constants);
        for (const test::NamedState& state : test::deformedStates(body.mesh().X, 3)) {
          const NodeVectors v = test::Random(brackets).nodeVectors(body.nodeCount(), 1);
          body.followDampingRates(state.x, v);
          const DenseTangent dense(body, state.x);
          if (!dense.finite()) continue;
          const double largest = dense.largest();
          if (!(largest > 0)) continue;
          const std::string what = joinText(kind.name, ", ", law, ", ", test::holdName(hold), ", ", state.name);
          const CriticalStep step = criticalStep(body, state.x, 2.0);
          test::expectHolds(step, largest, what);
          EXPECT_GE(step.safe, 0.85 * test::stepOf(largest)) << what;
          body.elementDamping()->setFactor(0);
          damped += largest > 1.02 * DenseTangent(body, state.x).largest();
          body.elementDamping()->setFactor(factor);
          ++brackets;
        }
      }
  EXPECT_GT(brackets, 200);
  EXPECT_GT(damped, brackets / 3);
}

TEST_P(ElementDampingTest, QuotientsKnowWhatDampingGives) {
  for (const Kind& kind : kinds()) {
    Body body = elasticBox(GetParam(), "stvk", {3, 2, 2});
    damp(body, kind.constants);
    const NodeVectors x = test::strained(body.mesh().X, 5, 0.05);
    NodeVectors mode = test::Random(3).nodeVectors(body.nodeCount(), 1);
    const LowerBound bound = rayleighLowerBound(body, x, mode, 12);
    // The mode is scaled by the root of mass.
    const Eigen::Map<const Eigen::VectorXd> u(mode.data(), mode.size());
    const Eigen::MatrixXd all = DenseTangent(body, x).matrix;
    body.elementDamping()->setFactor(0);
    const Eigen::MatrixXd alone = DenseTangent(body, x).matrix;
    const double part = u.dot((all - alone) * u);
    EXPECT_LE(bound.value, u.dot(all * u) * (1 + 1e-13)) << kind.name;
    EXPECT_LE(bound.dampingFrom, part) << kind.name;
    EXPECT_GE(bound.dampingTo, part) << kind.name;
    EXPECT_LE(bound.dampingTo - bound.dampingFrom, 1e-8 * bound.value) << kind.name;
  }
}

TEST_P(ElementDampingTest, ExchangeAndFactorisationHold) {
  Body body = elasticBox(GetParam(), "stvk", {3, 2, 2});
  test::holdBody(body, Hold::face);
  damp(body, kinds().back().constants);
  const NodeVectors x = test::strained(body.mesh().X, 5, 0.05);
  const double largest = DenseTangent(body, x).largest();
  EXPECT_LT(test::expectProofsHold(body, x, largest, ""), 1.2 * largest);
}

TEST_P(ElementDampingTest, ProofsHoldAlongRuns) {
  std::int64_t states = 0, kept = 0;
  for (const Kind& kind : kinds())
    for (const std::string_view law : {"stvk", "neo-hookean"})
      for (const double budget : {infinity, 0.0}) {
        Body body = elasticBox(GetParam(), law);
        damp(body, kind.constants);
        const NodeVectors& X = body.mesh().X;
        const NodeVectors shake = test::Random(12).nodeVectors(X.cols(), 0.06 * test::cellSize);
        WorkAccount account(body, budget);
        IncrementalNodalBound bound(body, {}, &account);
        RunBracket bracket(body, 0.05, budget);
        for (int step = 0; step < 40; ++step) {
          const double at = 0.05 * step, speed = 30;
          const NodeVectors x = test::turningPath(X, at, shake),
                            v = speed / 2e-6 *
                                (test::turningPath(X, at + 1e-6, shake) - test::turningPath(X, at - 1e-6, shake));
          account.earn();
          body.followDampingRates(x, v);
          const DenseTangent dense(body, x);
          ASSERT_TRUE(dense.finite());
          const double lambda = dense.largest();
          const std::string what = joinText(kind.name, ", ", law, ", budget ", budget, ", step ", step);
          test::expectProves(bound, x, lambda, what);
          kept += bound.statistics().evaluated < static_cast<std::int64_t>(body.mesh().elementCount()) / 2;
          test::expectProvesTightened(bound, x, lambda, what);
          test::expectHolds(bracket, x, lambda, what);
          ++states;
        }
      }
  EXPECT_EQ(states, 40 * 6 * 2 * 2);
  EXPECT_GT(kept, states / 4);
}

// The drift of an element of K + f C: what its highest eigenvalue grows to within the radius is within the bound of it,
// and comes near it now and then (Theorem 58).
TEST(ElementDampingDrift, BoundsTheGrowthOfElementValues) {
  test::Random random(8);
  int tried = 0;
  double nearest = 0;
  for (const Subdivision& subdivision : cases()) {
    if (!subdivision.other.empty()) continue;
    for (const Kind& kind : kinds()) {
      if (kind.name == "mass") continue;
      Body body = elasticBox(subdivision, "linear", {1, 1, 1});
      damp(body, kind.constants);
      body.elementDamping()->setFactor(100 * factor);  // the law's own drift is nothing, and its stiffness little
      const ElementBlock& block = *body.blocks()[0];
      const int n = block.nodesPerElement(), points = static_cast<int>(block.rule().points.size());
      std::int32_t elements[lanes];
      std::fill(elements, elements + lanes, -1);
      elements[0] = 0;
      AlignedVector<double> F(9 * points * lanes), F0(9 * points * lanes), L(n * n * lanes), unusedRounding(n * lanes);
      TangentDrift drift[lanes];
      block.laplacianOf(elements, L.data(), unusedRounding.data());
      Eigen::MatrixXd B = Eigen::MatrixXd::Zero(3 * n, 3 * n);
      for (int a = 0; a < n; ++a)
        for (int b = 0; b < n; ++b) B.block<3, 3>(3 * a, 3 * b) = L[(a * n + b) * lanes] * Eigen::Matrix3d::Identity();
      const double strainNorm = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(B).eigenvalues()[3 * n - 1];
      const auto valueAt = [&](const NodeVectors& x) {
        return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(body.elementTangent({0, 0}, x)).eigenvalues()[3 * n - 1];
      };
      for (int state = 0; state < 8; ++state) {
        const NodeVectors x0 = (Eigen::Matrix3d::Identity() + random.matrix(0.3)) * body.mesh().X;
        block.deformationOf(elements, x0.data(), F0.data(), drift);
        const TangentGrowth growth = growthOf(drift[0].law, valueAt(x0), strainNorm);
        for (int trial = 0; trial < 25; ++trial) {
          const double size = drift[0].law.radius < infinity ? drift[0].law.radius : 0.1;
          const NodeVectors x = x0 + random.uniform(0, 1) * size * 0.3 * random.matrix(1) * body.mesh().X +
                                random.nodeVectors(x0.cols(), random.index(2) * 0.05 * size * test::cellSize);
          TangentDrift unused[lanes];
          block.deformationOf(elements, x.data(), F.data(), unused);
          double distance = 0;
          for (int q = 0; q < points; ++q) {
            double square = 0;
            for (int i = 0; i < 9; ++i) {
              const std::size_t at = (9 * q + i) * lanes;
              square += (F[at] - F0[at]) * (F[at] - F0[at]);
            }
            distance = std::max(distance, std::sqrt(square));
          }
          if (!(distance <= drift[0].law.radius)) continue;
          const double value = valueAt(x), most = growth.at(distance);
          ASSERT_LE(value, most * (1 + 1e-12)) << subdivision.name << ", " << kind.name;
          nearest = std::max(nearest, (value - growth.value) / (most - growth.value));
          ++tried;
        }
      }
    }
  }
  EXPECT_GT(tried, 2000);
  EXPECT_GT(nearest, 0.2);
}

TEST(ElementDamping, SameBitsForAnyNumberOfThreads) {
  test::expectSameBitsForAnyThreads(
      [](int threads) {
        Body body = test::boxBody(test::allSubdivisions()[0], "stvk", {6, 4, 4}, 0.2, 3, threads);
        damp(body, kinds().back().constants);
        return body;
      },
      [shake = NodeVectors()](Body& body, int step) mutable {
        if (step == 0) shake = test::Random(12).nodeVectors(body.nodeCount(), 0.06 * test::cellSize);
        const NodeVectors x = test::turningPath(body.mesh().X, 0.1 * step, shake);
        body.followDampingRates(x, 50 * (x - body.mesh().X));
        return x;
      });
}

TEST(ElementDamping, CertificatesInFilesAreRefused) {
  Body body = test::boxBody(test::allSubdivisions()[0], "stvk");
  damp(body, kinds().front().constants);
  EXPECT_THROW(requireCertifiable(body), InputError);
}

}  // namespace
}  // namespace ringwatch
