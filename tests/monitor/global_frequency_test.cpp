// The global frequency against dense eigenvalues.
#include <gtest/gtest.h>

#include <ringwatch/base/error.h>
#include <ringwatch/monitor/bounds/global_frequency.h>
#include <tests/monitor/monitor_cases.h>

namespace ringwatch {
namespace {

using test::DenseTangent;
using test::Hold;
using test::Subdivision;

TEST(GlobalFrequency, IsTheLargestDenseEigenvalue) {
  int states = 0, tried = 0;
  for (const Subdivision& subdivision : test::allSubdivisions())
    for (const LawInfo& law : allLaws())
      for (const Hold hold : {Hold::nothing, Hold::face, Hold::components}) {
        Body body = test::boxBody(subdivision, law.name);
        test::holdBody(body, hold);
        for (const test::NamedState& state : test::deformedStates(body.mesh().X, 4)) {
          const DenseTangent dense(body, state.x);
          ++states;
          if (!dense.finite()) continue;
          ++tried;
          const double lambda = dense.largest();
          const GlobalFrequency found = globalFrequency(body, state.x);
          const std::string what =
              joinText(subdivision.name, ", ", law.name, ", ", test::holdName(hold), ", ", state.name);
          ASSERT_TRUE(found.converged) << what;
          EXPECT_NEAR(found.lambda, lambda, 1e-9 * lambda) << what;
          EXPECT_GT(found.products, 0) << what;
          // M u lambda = K u over the free components, u mass-normalised and zero where held.
          NodeVectors product, mode = found.mode;
          body.constraints().clearConstrained(mode);
          EXPECT_EQ(mode, found.mode) << what;
          Body::Workspace workspace;
          body.tangentProduct(state.x, found.mode, product, workspace);
          body.constraints().clearConstrained(product);
          const Eigen::VectorXd root = body.lumpedMass().cwiseSqrt();
          const NodeVectors scaled = found.mode * root.asDiagonal();
          EXPECT_NEAR(scaled.norm(), 1, 1e-10) << what;
          EXPECT_LE((product * root.cwiseInverse().asDiagonal() - lambda * scaled).norm(), 1e-6 * lambda) << what;
        }
      }
  EXPECT_GE(4 * tried, 3 * states);
}

TEST(GlobalFrequency, OfABodyWithNothingFreeIsZero) {
  Body body = test::boxBody(test::allSubdivisions()[0], "stvk");
  for (std::int32_t i = 0; i < body.nodeCount(); ++i) body.constraints().fix(i);
  const GlobalFrequency found = globalFrequency(body, body.mesh().X);
  EXPECT_TRUE(found.converged);
  EXPECT_EQ(found.lambda, 0);
  EXPECT_EQ(found.products, 0);
}

TEST(GlobalFrequency, OfOneFreeNodeOrComponent) {
  for (const Subdivision& subdivision : test::allSubdivisions())
    for (const int components : {1, 2, 3}) {
      Body body = test::boxBody(subdivision, "stvk");
      for (std::int32_t i = 0; i < body.nodeCount(); ++i)
        for (int c = 0; c < 3; ++c)
          if (i != 13 || c >= components) body.constraints().fix(i, c);
      const double lambda = DenseTangent(body, body.mesh().X).largest();
      const GlobalFrequency found = globalFrequency(body, body.mesh().X);
      ASSERT_TRUE(found.converged) << subdivision.name << ", " << components;
      EXPECT_NEAR(found.lambda, lambda, 1e-9 * lambda) << subdivision.name << ", " << components;
    }
}

TEST(GlobalFrequency, OfASingleElement) {
  for (const ElementInfo& info : allElements()) {
    Mesh mesh;
    MeshBlock block{info.type, {}, {0}};
    mesh.X.resize(3, info.nodes);
    for (std::int32_t a = 0; a < info.nodes; ++a) {
      mesh.X.col(a) = Eigen::Vector3d::Map(info.referenceNodes[a].data());
      mesh.nodeIds.push_back(a);
      block.connectivity.push_back(a);
    }
    mesh.blocks.push_back(block);
    const Body body(mesh, makeMaterial("linear", 1, 0.3, 1), test::onThreads(1));
    const double lambda = DenseTangent(body, mesh.X).largest();
    const GlobalFrequency found = globalFrequency(body, mesh.X);
    ASSERT_TRUE(found.converged) << info.name;
    EXPECT_NEAR(found.lambda, lambda, 1e-9 * lambda) << info.name;
  }
}

TEST(GlobalFrequency, IsTheLargestDenseEigenvalueInAnyUnits) {
  const Subdivision subdivision = test::allSubdivisions()[0];
  const NodeVectors X = test::box(subdivision, {4, 2, 2}).X;
  for (const double young : {1e-200, 1e-100, 1e-30, 1e-16, 1e-8, 1e8, 1e30, 1e100, 1e200}) {
    Body body(test::box(subdivision, {4, 2, 2}), makeMaterial("linear", young, 0.3, 1000), test::onThreads(1));
    test::holdBody(body, Hold::face);
    // The dense problem at E = 1, where its solver is at home: eigenvalues are proportional to E.
    Body unit(test::box(subdivision, {4, 2, 2}), makeMaterial("linear", 1, 0.3, 1000), test::onThreads(1));
    test::holdBody(unit, Hold::face);
    const double lambda = young * DenseTangent(unit, X).largest();
    const GlobalFrequency found = globalFrequency(body, X);
    ASSERT_TRUE(found.converged) << young;
    EXPECT_NEAR(found.lambda, lambda, 1e-9 * lambda) << young;
  }
}

TEST(GlobalFrequency, ThatDidNotConvergeHasNoValue) {
  const Body body = test::boxBody(test::allSubdivisions()[0], "linear", {10, 5, 5}, 0);
  const GlobalFrequency found = globalFrequency(body, body.mesh().X, 1e-15, 1);
  EXPECT_FALSE(found.converged);
  EXPECT_EQ(found.lambda, 0);
  EXPECT_EQ(found.mode.size(), 0);
  EXPECT_GT(found.products, 0);
}

TEST(GlobalFrequency, OfAStateWithoutTangentHasNoValue) {
  const Body body = test::boxBody(test::allSubdivisions()[0], "neo-hookean");
  const GlobalFrequency found = globalFrequency(body, Eigen::Vector3d(-0.5, 1, 1).asDiagonal() * body.mesh().X);
  EXPECT_FALSE(found.converged);
}

TEST(GlobalFrequency, IsTheSameEveryTime) {
  const Body body = test::boxBody(test::allSubdivisions()[0], "stvk", {4, 3, 3});
  const GlobalFrequency a = globalFrequency(body, body.mesh().X), b = globalFrequency(body, body.mesh().X);
  EXPECT_EQ(a.lambda, b.lambda);
  EXPECT_EQ(a.mode, b.mode);
}

}  // namespace
}  // namespace ringwatch
