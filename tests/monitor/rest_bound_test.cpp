// The nodal bound at rest that moves with a body: proven at every state of random paths by dense eigenvalues, and what
// it costs where a body only turns or stretches evenly.
#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <utility>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <ringwatch/materials/principal_tangent.h>
#include <ringwatch/monitor/incremental/rest_bound.h>
#include <tests/monitor/discrete_cases.h>

namespace ringwatch {
namespace {

using test::DenseTangent;
using test::Hold;
using test::Subdivision;

/// Leaves room for the rounding of dense eigenvalues.
constexpr double rounding = 1e-9, ofSingles = 1e-5;

class RestBoundTest : public ::testing::TestWithParam<Subdivision> {};
INSTANTIATE_TEST_SUITE_P(Subdivisions, RestBoundTest, ::testing::ValuesIn(test::allSubdivisions()),
                         [](const auto& test) { return test::testName(test.param.name); });

RestBound boundAtRest(const Body& body, const RestBoundPolicy& policy = {}) {
  NodalBound weights(body);
  weights.evaluate(body.mesh().X, 4);
  RestBound bound(body, policy);
  bound.start(std::move(weights));
  return bound;
}

TEST_P(RestBoundTest, HoldsAtEveryStateOfAPath) {
  std::int64_t bounded = 0;
  for (const LawInfo& law : allLaws())
    for (const Hold hold : {Hold::nothing, Hold::face, Hold::components})
      for (const auto& [size, touched] : {std::pair{0.005, false}, {0.05, false}, {0.05, true}}) {
        Body body = test::boxBody(GetParam(), law.name);
        test::holdBody(body, hold);
        if (touched) test::addForces(body, 10 * test::cellStiffness, 3);
        if (!RestBound::serves(body)) continue;
        const NodeVectors& X = body.mesh().X;
        test::Random random(12);
        const NodeVectors shake = random.nodeVectors(X.cols(), size * test::cellSize);
        RestBound bound = boundAtRest(body, {.gradientsOfGroup = 1, .groupsOfRegion = 2, .turns = 3});
        constexpr int steps = 40;
        for (int step = 0; step <= steps; ++step) {
          const NodeVectors x = test::pathState(X, static_cast<double>(step) / steps, size > 0.01 ? 2 : 0.3, shake);
          const DenseTangent dense(body, x);
          const std::string what =
              joinText(law.name, ", ", test::holdName(hold), ", ", size, touched ? ", touched" : "", ", step ", step);
          StepEvaluation evaluation;
          const bool withForce = step % 4 > 1;
          // By turns as the motions give it, with some regions gone through again, and with all of them.
          const std::int64_t most = step % 3 == 0 ? 0 : step % 3 == 1 ? 16 : body.mesh().elementCount();
          const double value = bound.update(x, withForce ? &evaluation : nullptr, 0, most).value;
          ASSERT_GE(value, dense.largest() * (1 - rounding)) << what;
          bounded += value < infinity;
          if (withForce) test::expectForce(body, x, evaluation, what);
        }
      }
  EXPECT_GT(bounded, 0);
}

/// A body of the first elements of a box alone: what is said of them is tight there.
Body bodyOfFirst(const Subdivision& subdivision, std::string_view law, std::size_t count) {
  Mesh mesh = test::box(subdivision, {1, 1, 1});
  MeshBlock& block = mesh.blocks.front();
  const auto n = static_cast<std::size_t>(block.nodesPerElement());
  block.connectivity.resize(std::min(block.connectivity.size(), n * count));
  block.ids.resize(block.connectivity.size() / n);
  std::map<std::int32_t, std::int32_t> numbers;
  NodeVectors X(3, mesh.X.cols());
  for (std::int32_t& node : block.connectivity) {
    const auto [at, isNew] = numbers.try_emplace(node, static_cast<std::int32_t>(numbers.size()));
    if (isNew) X.col(at->second) = mesh.X.col(node);
    node = at->second;
  }
  Mesh first;
  first.X = X.leftCols(static_cast<Eigen::Index>(numbers.size()));
  first.blocks = {std::move(block)};
  return {std::move(first), {makeMaterial(law, test::young, test::poisson, test::density)}};
}

/// The statement itself, of which the bound of a body may hide a fault.
TEST_P(RestBoundTest, HasAMajorantOfTheTangentAtEveryState) {
  if (!GetParam().other.empty()) return;
  for (const LawInfo& law : allLaws())
    for (const auto& [count, size] : {std::pair<std::size_t, double>{1, 0.03}, {1, 0.001}, {2, 0.15}, {3, 0.03}}) {
      Body body = bodyOfFirst(GetParam(), law.name, count);
      if (!RestBound::serves(body)) continue;
      const NodeVectors& X = body.mesh().X;
      test::Random random(7);
      const NodeVectors shake = random.nodeVectors(X.cols(), size * test::cellSize);
      RestBound bound = boundAtRest(body, {.gradientsOfGroup = 1, .turns = 3, .same = 0});
      constexpr int steps = 60, statesOfReference = 15;
      for (int step = 0; step <= steps; ++step) {
        const NodeVectors x = test::pathState(X, static_cast<double>(step) / steps, 2, shake);
        const double value =
            bound.update(x, nullptr, 0, step % statesOfReference == 0 ? body.mesh().elementCount() : 0).value;
        Eigen::MatrixXd excess = DenseTangent(body, x).matrix;
        double highest = 0;
        for (std::int32_t i = 0; i < body.nodeCount(); ++i) {
          const Eigen::Matrix3d majorant = bound.majorantAt(i);
          excess.block<3, 3>(3 * i, 3 * i) -= majorant;
          highest = std::max(highest, majorant.selfadjointView<Eigen::Lower>().eigenvalues().maxCoeff());
        }
        EXPECT_TRUE(std::isinf(value) || std::abs(value - highest) <= ofSingles * highest)
            << law.name << ", step " << step;
        const Eigen::VectorXd eigenvalues = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(excess).eigenvalues();
        ASSERT_LE(eigenvalues.maxCoeff(), rounding * eigenvalues.cwiseAbs().maxCoeff())
            << law.name << ", " << count << " elements, shaken by " << size << ", step " << step;
      }
    }
}

/// What regions are moved by is at least what their nodes come to, but for the single precision of nodes' parts.
TEST_P(RestBoundTest, MovesRegionsNoLowerThanTheirNodes) {
  for (const LawInfo& law : allLaws()) {
    Body body = test::boxBody(GetParam(), law.name);
    if (!RestBound::serves(body)) continue;
    const NodeVectors& X = body.mesh().X;
    test::Random random(9);
    const NodeVectors shake = random.nodeVectors(X.cols(), 0.004 * test::cellSize);
    const RestBoundPolicy policy{.gradientsOfGroup = 1, .groupsOfRegion = 2, .same = 0};
    RestBound byNodes = boundAtRest(body, policy), byRegions = boundAtRest(body, policy);
    byRegions.update(X, nullptr, 0, 0);
    byNodes.update(X, nullptr, 0, 0);
    for (int step = 1; step <= 30; ++step) {
      const NodeVectors x = test::pathState(X, 0.02 * step, 1, shake);
      const double byThese = byNodes.update(x, nullptr, 0, 0).value;
      if (byNodes.statistics().elements > 0) break;  // from here on they have other references
      EXPECT_GE(byRegions.update(x, nullptr, infinity, 0).value, byThese * (1 - ofSingles)) << law.name << ", " << step;
    }
  }
}

TEST_P(RestBoundTest, TurnsWithABody) {
  for (const LawInfo& law : allLaws()) {
    if (!law.objective) continue;
    Body body = test::boxBody(GetParam(), law.name);
    if (!RestBound::serves(body)) continue;
    const NodeVectors& X = body.mesh().X;
    RestBound bound = boundAtRest(body);
    const double atRest = bound.update(X, nullptr, 0, body.mesh().elementCount()).value;
    for (int step = 1; step <= 50; ++step) {
      const Eigen::AngleAxisd turn(0.06 * step, Eigen::Vector3d(3, 1, 2).normalized());
      const NodeVectors x = turn.toRotationMatrix() * X;
      EXPECT_LE(bound.update(x, nullptr, 0, body.mesh().elementCount()).value, 1.01 * atRest)
          << law.name << ", " << step;
    }
  }
}

TEST(RestBound, FollowsAnEvenStretchOfStVenantKirchhoff) {
  Body body = test::boxBody(test::allSubdivisions().front(), "stvk");
  const NodeVectors& X = body.mesh().X;
  RestBound bound = boundAtRest(body, {.gradientsOfGroup = 1, .turns = 1});
  const double looseAtRest = bound.update(X, nullptr, 0, 0).value / DenseTangent(body, X).largest();
  for (int step = 1; step <= 30; ++step) {
    const NodeVectors x = Eigen::Vector3d(1 + 0.01 * step, 1, 1).asDiagonal() * X;
    const double value = bound.update(x, nullptr, 0, body.mesh().elementCount()).value;
    // The largest stretch and the stress count in all directions, along and across the pull.
    EXPECT_LE(value, 1.45 * looseAtRest * DenseTangent(body, x).largest()) << step;
  }
}

/// The quadratic form of the tangent at diag(s), from its nine columns.
TEST(PrincipalTangent, HasTheEigenvaluesOfTheTangent) {
  test::Random random(3);
  for (const LawInfo& info : allLaws()) {
    if (!info.isotropic || !info.objective) continue;
    const Material material = makeMaterial(info.name, 1e6, 0.3, 1000);
    for (int trial = 0; trial < 200; ++trial) {
      double stretches[3];
      for (double& stretch : stretches) stretch = random.uniform(0.7, 1.5);
      std::visit(
          [&](const auto& law) {
            PrincipalTangent<double> tangent;
            ASSERT_TRUE(principalTangent(law, stretches, tangent));
            Matrix3<double> F = Matrix3<double>::zero();
            for (int i = 0; i < 3; ++i) F(i, i) = stretches[i];
            const auto linearization = law.linearize(F);
            Eigen::Matrix<double, 9, 9> A;
            for (int k = 0; k < 9; ++k) {
              Matrix3<double> dF = Matrix3<double>::zero();
              dF.m[k] = 1;
              const Matrix3<double> dP = linearization(dF);
              for (int i = 0; i < 9; ++i) A(i, k) = dP.m[i];
            }
            Eigen::Matrix3d normal;
            for (int i = 0; i < 3; ++i)
              for (int j = 0; j < 3; ++j) normal(i, j) = tangent.normal[i][j];
            const double highest = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(normal).eigenvalues()[2];
            const double all = Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 9, 9>>(A).eigenvalues()[8];
            EXPECT_NEAR(std::max({highest, tangent.flip, tangent.twist}), all, 1e-9 * all) << info.name;
          },
          material.law);
    }
  }
}

TEST(RestBound, DoesNotDependOnThreadsAndGoesOnFromWhatIsSaved) {
  std::vector<double> bounds[3];
  for (int run = 0; run < 3; ++run) {
    Body body = test::boxBody(test::allSubdivisions().front(), "neo-hookean", {3, 3, 3}, 0.2, 3, run == 1 ? 4 : 1);
    const NodeVectors& X = body.mesh().X;
    test::Random random(5);
    const NodeVectors shake = random.nodeVectors(X.cols(), 0.004 * test::cellSize);
    std::optional<RestBound> bound(boundAtRest(body, {.gradientsOfGroup = 1}));
    for (int step = 0; step <= 20; ++step) {
      if (run == 2 && step == 9) {
        SavingArchive saving;
        bound->archive(saving);
        const std::string saved = saving.take();
        bound.emplace(body, RestBoundPolicy{.gradientsOfGroup = 1});
        LoadingArchive loading(saved);
        bound->archive(loading);
      }
      bounds[run].push_back(bound->update(test::pathState(X, 0.05 * step, 0.5, shake), nullptr, 0, 8).value);
    }
  }
  EXPECT_EQ(bounds[0], bounds[1]);
  EXPECT_EQ(bounds[0], bounds[2]);
}

TEST(RestBound, SeesElementsBeforeTheyInvert) {
  Body body = test::boxBody(test::allSubdivisions().front(), "stvk");
  NodeVectors x = body.mesh().X;
  RestBound bound = boundAtRest(body, {.gradientsOfGroup = 1});
  for (int step = 0; step < 20; ++step) {
    x(2, 0) += 0.1 * test::cellSize;
    bound.update(x, nullptr, infinity, 0);
    const Body::LeastDeterminant least = body.leastDeterminant(x);
    if (least.value > 0) continue;
    double seen = 1;
    for (const auto& element : bound.seen()) seen = std::min(seen, element.determinant);
    EXPECT_EQ(seen, least.value);
  }
}

}  // namespace
}  // namespace ringwatch
