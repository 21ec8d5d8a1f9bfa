// The bound from a region around the top mode: below dense eigenvalues whatever the region, the whole when it holds the
// whole, close to it on a regular grid, and of the masses and constraints of now.
#include <cstring>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include <ringwatch/base/archive.h>
#include <ringwatch/base/error.h>
#include <ringwatch/monitor/bounds/local_mode.h>
#include <ringwatch/monitor/bounds/rayleigh.h>
#include <tests/monitor/monitor_cases.h>
#include <tests/support/meshes.h>

namespace ringwatch {
namespace {

using test::DenseTangent;
using test::Hold;
using test::Subdivision;

NodeVectors anyMode(const Body& body, std::uint64_t seed) {
  test::Random random(seed);
  NodeVectors mode = random.nodeVectors(body.nodeCount(), 1);
  body.constraints().clearConstrained(mode);
  return mode;
}

TEST(LocalMode, IsALowerBoundInAnyRegionOfAnyState) {
  int tried = 0;
  for (const Subdivision& subdivision : test::allSubdivisions())
    for (const LawInfo& law : allLaws())
      for (const Hold hold : {Hold::nothing, Hold::face, Hold::components}) {
        Body body = test::boxBody(subdivision, law.name);
        test::holdBody(body, hold);
        const NodalBound incidences(body);
        for (const std::size_t nodes : {1u, 4u, 1000u}) {
          LocalMode mode(body, incidences, 3, 2);
          for (const test::NamedState& state : test::deformedStates(body.mesh().X, nodes)) {
            if (!Eigen::MatrixXd(body.assembleTangent(state.x)).allFinite()) continue;  // a law without a tangent there
            const double lambda = DenseTangent(body, state.x).largest();
            mode.choose(anyMode(body, nodes), nodes);
            for (int evaluation = 0; evaluation < 4; ++evaluation) {
              EXPECT_LE(mode.evaluate(state.x).value, std::max(lambda, 0.0) * (1 + 1e-12))
                  << subdivision.name << ", " << law.name << ", " << test::holdName(hold) << ", " << state.name;
              ++tried;
            }
          }
        }
      }
  EXPECT_GT(tried, 1000);
}

TEST(LocalMode, FindsTheHighestEigenvalueWhenTheRegionIsTheWhole) {
  for (const Subdivision& subdivision : test::allSubdivisions()) {
    Body body = test::boxBody(subdivision, "stvk");
    test::holdBody(body, Hold::face);
    const NodalBound incidences(body);
    LocalMode mode(body, incidences, 30, 1);
    mode.choose(anyMode(body, 3), 1000);
    const double lambda = DenseTangent(body, body.mesh().X).largest();
    EXPECT_NEAR(mode.evaluate(body.mesh().X).value, lambda, 1e-6 * lambda) << subdivision.name;
  }
}

TEST(LocalMode, HoldsMostOfAModeThatIsSpreadOverARegularGrid) {
  // A fifth of the nodes. Scattered over the grid, as the largest entries are, they would hold half of it.
  const Body body(test::gridMesh("hex8", {8, 8, 8}, {0.08, 0.08, 0.08}),
                  makeMaterial("stvk", test::young, test::poisson, test::density));
  const NodalBound incidences(body);
  const DenseTangent dense(body, body.mesh().X);
  LocalMode mode(body, incidences, 8, 1);
  NodeVectors top = anyMode(body, 1);
  rayleighLowerBound(body, body.mesh().X, top, 30);
  mode.choose(top, 150);
  double bound = 0;
  for (int evaluation = 0; evaluation < 10; ++evaluation) bound = mode.evaluate(body.mesh().X).value;
  EXPECT_GE(bound, 0.9965 * dense.largest());  // measured 0.9988
}

TEST(LocalMode, HandsOutTheModeOfItsRegion) {
  const Body body = test::boxBody(test::allSubdivisions()[0], "stvk");
  const NodalBound incidences(body);
  LocalMode mode(body, incidences, 3, 1);
  EXPECT_FALSE(mode.holds(0));
  EXPECT_EQ(mode.mode(), NodeVectors::Zero(3, body.nodeCount()));
  mode.choose(anyMode(body, 4), 3);
  const double bound = mode.evaluate(body.mesh().X).value;
  NodeVectors whole = mode.mode();
  int held = 0;
  for (std::int32_t i = 0; i < body.nodeCount(); ++i) {
    held += mode.holds(i);
    EXPECT_EQ(mode.holds(i), whole.col(i).norm() > 0) << i;
  }
  EXPECT_EQ(held, 3);
  // Nothing outside of the region moves, so the quotient in the whole body is the same.
  EXPECT_NEAR(rayleighLowerBound(body, body.mesh().X, whole, 1).value, bound, 1e-10 * bound);
}

TEST(LocalMode, FollowsMassesAndConstraints) {
  Body body = test::boxBody(test::allSubdivisions()[0], "corotational");
  const NodalBound incidences(body);
  LocalMode mode(body, incidences, 30, 1);
  mode.choose(anyMode(body, 2), 1000);
  mode.evaluate(body.mesh().X);
  for (std::int32_t i = 0; i < body.nodeCount(); i += 2) body.addNodalMass(i, 0.3 * body.lumpedMass()[i]);
  double lambda = DenseTangent(body, body.mesh().X).largest();
  EXPECT_NEAR(mode.evaluate(body.mesh().X).value, lambda, 1e-6 * lambda);
  for (std::int32_t i = 0; i < body.nodeCount(); i += 3) body.constraints().fix(i);
  lambda = DenseTangent(body, body.mesh().X).largest();
  EXPECT_NEAR(mode.evaluate(body.mesh().X).value, lambda, 1e-6 * lambda);
}

TEST(LocalMode, RefusesSavedNodesAndElementsThatTheBodyHasNot) {
  const Body body = test::boxBody(test::allSubdivisions().front(), "stvk");
  const NodalBound incidences(body);
  LocalMode mode(body, incidences, 3, 2);
  mode.choose(anyMode(body, 1), 4);
  mode.evaluate(body.mesh().X);
  SavingArchive saving;
  mode.archive(saving);
  const std::string saved = saving.take();
  const auto load = [&](const std::string& bytes) {
    LocalMode loaded(body, incidences, 3, 2);
    LoadingArchive archive(bytes);
    loaded.archive(archive);
  };
  load(saved);
  // The size that the region may have and the one that it has come before its nodes, which ascend.
  constexpr std::size_t firstNode = 2 * sizeof(std::size_t);
  for (const std::int32_t node : {-1, body.nodeCount(), std::numeric_limits<std::int32_t>::max()}) {
    std::string forged = saved;
    std::memcpy(forged.data() + firstNode, &node, sizeof node);
    EXPECT_THROW(load(forged), InputError) << node;
  }
  // Whatever four bytes are others, it is refused or what is read is of the body.
  for (std::size_t place = firstNode; place + sizeof(std::int32_t) <= saved.size(); place += sizeof(std::int32_t)) {
    std::string forged = saved;
    std::memset(forged.data() + place, 0x7f, sizeof(std::int32_t));
    LocalMode loaded(body, incidences, 3, 2);
    LoadingArchive archive(forged);
    try {
      loaded.archive(archive);
    } catch (const InputError&) {
      continue;
    }
    const ElementRef highest = loaded.highestElement();
    ASSERT_LT(static_cast<std::size_t>(highest.block), body.blocks().size()) << place;
    ASSERT_LT(highest.element, body.blocks()[highest.block]->elementCount()) << place;
  }
}

TEST(LocalMode, HasNoBoundWithoutAMode) {
  const Body body = test::boxBody(test::allSubdivisions()[0], "linear");
  const NodalBound incidences(body);
  LocalMode mode(body, incidences, 3, 1);
  EXPECT_EQ(mode.evaluate(body.mesh().X).value, 0);
  mode.choose(NodeVectors::Zero(3, body.nodeCount()), 10);
  EXPECT_EQ(mode.evaluate(body.mesh().X).value, 0);
  mode.choose(NodeVectors(3, 0), 10);
  EXPECT_EQ(mode.evaluate(body.mesh().X).value, 0);
}

TEST(LocalMode, NamesTheElementThatHoldsTheMode) {
  // One element that is far stiffer for its size than the others.
  Mesh mesh = test::gridMesh("tet4", {10, 2, 2}, {0.2, 0.04, 0.04});
  const auto node = [](int i, int j, int k) { return i + 11 * (j + 3 * k); };
  mesh.X(0, node(5, 1, 1)) += 0.95 * (mesh.X(0, node(6, 1, 1)) - mesh.X(0, node(5, 1, 1)));
  const Body body(mesh, makeMaterial("stvk", test::young, test::poisson, test::density));
  const NodalBound incidences(body);
  NodeVectors start = NodeVectors::Zero(3, body.nodeCount());
  start.col(node(5, 1, 1)).setOnes();
  LocalMode mode(body, incidences, 20, 1);
  mode.choose(start, 40);
  const double bound = mode.evaluate(body.mesh().X).value;
  EXPECT_GE(bound, 0.98 * DenseTangent(body, body.mesh().X).largest());
  const auto nodes = body.blocks()[0]->nodesOf(mode.highestElement().element);
  EXPECT_NE(std::find(nodes.begin(), nodes.end(), node(5, 1, 1)), nodes.end());
}

}  // namespace
}  // namespace ringwatch
