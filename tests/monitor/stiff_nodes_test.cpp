// The nodes with the longest diagonals, against the assembled tangent.
#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include <ringwatch/monitor/bounds/stiff_nodes.h>
#include <tests/monitor/monitor_cases.h>
#include <tests/support/meshes.h>

namespace ringwatch {
namespace {

using test::Hold;
using test::Subdivision;

TEST(StiffNodes, AreThoseOfTheAssembledTangentAndShareNoElement) {
  int tried = 0;
  for (const Subdivision& subdivision : test::allSubdivisions())
    for (const Hold hold : {Hold::nothing, Hold::face, Hold::components}) {
      Body body = test::boxBody(subdivision, "stvk");
      test::holdBody(body, hold);
      body.addNodalMass(0, 0.3 * body.lumpedMass()[0]);
      const NodalBound incidences(body);
      StiffNodes stiff(body, incidences);
      for (const test::NamedState& state : test::deformedStates(body.mesh().X, 1)) {
        SCOPED_TRACE(subdivision.name + ", " + test::holdName(hold) + ", " + state.name);
        const Eigen::MatrixXd K = body.assembleTangent(state.x);
        if (!K.allFinite()) continue;
        Eigen::VectorXd length(body.nodeCount());
        for (std::int32_t i = 0; i < body.nodeCount(); ++i) {
          Eigen::Vector3d diagonal = K.diagonal().segment<3>(3 * i);
          for (int c = 0; c < 3; ++c)
            if (body.constraints().isConstrained(i, c)) diagonal[c] = 0;
          length[i] = diagonal.norm() / body.lumpedMass()[i];
        }
        const double tolerance = 1e-11 * length.maxCoeff();
        const std::vector<std::int32_t> found = stiff.find(state.x, 3);
        ASSERT_FALSE(found.empty());
        EXPECT_NEAR(length[found.front()], length.maxCoeff(), tolerance);
        std::set<std::int32_t> near;  // the nodes of all elements at those before
        for (const std::int32_t node : found) {
          EXPECT_EQ(near.count(node), 0U);
          double most = 0;
          for (std::int32_t i = 0; i < body.nodeCount(); ++i)
            if (near.count(i) == 0) most = std::max(most, length[i]);
          EXPECT_NEAR(length[node], most, tolerance);
          near.insert(node);
          for (const auto& block : body.blocks())
            for (std::int32_t e = 0; e < block->elementCount(); ++e) {
              const auto nodes = block->nodesOf(e);
              if (std::find(nodes.begin(), nodes.end(), node) != nodes.end()) near.insert(nodes.begin(), nodes.end());
            }
        }
        ++tried;
      }
    }
  EXPECT_GT(tried, 50);
}

TEST(StiffNodes, AreNoneWhereNothingIsFree) {
  Body body = test::boxBody(test::allSubdivisions()[0], "stvk");
  for (std::int32_t i = 0; i < body.nodeCount(); ++i) body.constraints().fix(i);
  const NodalBound incidences(body);
  StiffNodes stiff(body, incidences);
  EXPECT_TRUE(stiff.find(body.mesh().X, 3).empty());
}

}  // namespace
}  // namespace ringwatch
