// Plans of added mass: the proof against dense eigenvalues, and how little they take.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include <ringwatch/base/error.h>
#include <ringwatch/handlers/mass_scaling/mass_plan.h>
#include <ringwatch/meshes/generators/generators.h>
#include <tests/handlers/handler_cases.h>

namespace ringwatch {
namespace {

using test::denseHighest;

/// The highest eigenvalue with added mass.
double highestWith(const Body& body, const Eigen::VectorXd& added) {
  return denseHighest(body, Eigen::MatrixXd(body.assembleTangent(body.mesh().X)), body.lumpedMass() + added);
}

TEST(MassPlan, ProvesTheLimitWithLessThanHandlerAndElementFormula) {
  int tried = 0;
  for (const char* law : {"linear", "stvk"})
    for (const double factor : {1.1, 1.5, 2.5, 5.0}) {
      Body body = test::sliverBody(law, 0.98);
      const NodeVectors& X = body.mesh().X;
      const double lambda = denseHighest(body, X) / (factor * factor);
      const MassPlan plan = planAddedMass(body, X, lambda), usual = addedMassByElement(body, X, lambda);
      EXPECT_GE(plan.added.minCoeff(), 0);
      EXPECT_LE(highestWith(body, plan.added), lambda) << law << " " << factor;
      EXPECT_LE(highestWith(body, usual.added), lambda) << law << " " << factor;
      EXPECT_LT(plan.total(), 0.8 * usual.total()) << law << " " << factor;
      // Not less than some node must have: K_ii <= lambda (m_i + added_i).
      const Eigen::MatrixXd K = body.assembleTangent(X);
      for (std::int32_t i = 0; i < body.nodeCount(); ++i)
        for (int c = 0; c < 3; ++c)
          if (!body.constraints().isConstrained(i, c)) {
            EXPECT_GE(body.lumpedMass()[i] + plan.added[i], K(3 * i + c, 3 * i + c) / lambda * (1 - 1e-12));
          }
      Body scaled = test::sliverBody(law, 0.98);
      HandlerOptions options;
      options.margin = 0;
      const auto handler = makeHandler("mass-scaling", scaled, makeIntegrator("symplectic-euler"), options);
      handler->prepare(X, 2 / std::sqrt(lambda));
      EXPECT_LE(plan.total(), (scaled.totalMass() - body.totalMass()) * (1 + 1e-12));
      ++tried;
    }
  EXPECT_EQ(tried, 8);
}

/// What single nodes of a plan can do without, one after the other, while lambda (M + added) - K stays positive
/// definite, kg.
double superfluous(const Body& body, const Eigen::MatrixXd& K, Eigen::VectorXd added, double lambda) {
  std::vector<Eigen::Index> free;
  for (std::int32_t i = 0; i < body.nodeCount(); ++i)
    for (int c = 0; c < 3; ++c)
      if (!body.constraints().isConstrained(i, c)) free.push_back(3 * i + c);
  const Eigen::MatrixXd freeK = K(free, free);
  const auto holds = [&] {
    Eigen::MatrixXd A = -freeK;
    for (std::size_t k = 0; k < free.size(); ++k) {
      const Eigen::Index node = free[k] / 3, row = static_cast<Eigen::Index>(k);
      A(row, row) += lambda * (body.lumpedMass()[node] + added[node]);
    }
    return Eigen::LLT<Eigen::MatrixXd>(A).info() == Eigen::Success;
  };
  const double before = added.sum();
  for (std::int32_t i = 0; i < body.nodeCount(); ++i) {
    double low = 0, high = added[i];
    for (int k = 0; k < 7 && high > 0; ++k) {
      added[i] = k == 0 ? 0 : 0.5 * (low + high);
      (holds() ? high : low) = added[i];
    }
    added[i] = high;
  }
  return before - added.sum();
}

TEST(MassPlan, HasLittleThatANodeCouldDoWithout) {
  BarOptions options;
  options.size = {0.1, 0.04, 0.04};
  options.cells = std::array<int, 3>{5, 2, 2};
  options.jitter = 0.35;
  options.seed = 3;
  Body body(generateBar(options), makeMaterial("stvk", test::young, test::poisson, test::density),
            {{}, Lumping::rowSum, 1});
  for (const std::int32_t i : body.mesh().nodeSets.at("x-min")) body.constraints().fix(i);
  const NodeVectors& X = body.mesh().X;
  const Eigen::MatrixXd K = body.assembleTangent(X);
  for (const double factor : {1.2, 1.5}) {
    const double lambda = denseHighest(body, X) / (factor * factor);
    const MassPlan plan = planAddedMass(body, X, lambda);
    EXPECT_LE(highestWith(body, plan.added), lambda);
    EXPECT_LE(superfluous(body, K, plan.added, lambda), 0.01 * plan.total()) << factor;
    // What the usual formula adds is in good part superfluous.
    const MassPlan usual = addedMassByElement(body, X, lambda);
    EXPECT_GE(superfluous(body, K, usual.added, lambda), 0.05 * usual.total()) << factor;
    EXPECT_LE(plan.total(), 1.02 * (usual.total() - superfluous(body, K, usual.added, lambda))) << factor;
  }
}

TEST(MassPlan, IsExactForOneFreeNode) {
  // One tetrahedron held at three nodes: the free one needs lambda_max(K_aa)/lambda, and its single block reaches that.
  Body body(test::firstElements(test::sliverBar(0), 1),
            makeMaterial("linear", test::young, test::poisson, test::density), {{}, Lumping::rowSum, 1});
  for (std::int32_t i = 1; i < 4; ++i) body.constraints().fix(i);
  const NodeVectors& X = body.mesh().X;
  const Eigen::MatrixXd K = body.assembleTangent(X);
  const Eigen::Matrix3d block = K.block<3, 3>(0, 0);
  const double top = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(block).eigenvalues()[2],
               lambda = 0.25 * top / body.lumpedMass()[0];
  const double needed = top / lambda - body.lumpedMass()[0];
  EXPECT_NEAR(planAddedMass(body, X, lambda).total(), needed, 1e-6 * needed);
  EXPECT_NEAR(addedMassByElement(body, X, lambda).added[0], needed, 1e-6 * needed);
}

TEST(MassPlan, AddsNothingWhereTheStepIsProvenWithout) {
  const Body body = test::sliverBody("stvk", 0.98);
  const double lambda = 1.5 * denseHighest(body, body.mesh().X);
  EXPECT_EQ(planAddedMass(body, body.mesh().X, lambda).total(), 0);
  EXPECT_THROW(planAddedMass(body, body.mesh().X, 0), InputError);
}

}  // namespace
}  // namespace ringwatch
