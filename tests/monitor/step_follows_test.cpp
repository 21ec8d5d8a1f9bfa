// Runs whose steps follow the bracket: the moved bound serves where it saves more than it takes, what it proves holds
// by dense eigenvalues, and a saved state goes on bit by bit.
#include <gtest/gtest.h>

#include <algorithm>

#include <Eigen/Geometry>

#include <ringwatch/base/archive.h>
#include <ringwatch/monitor/incremental/run_bracket.h>
#include <tests/monitor/discrete_cases.h>
#include <tests/monitor/monitor_cases.h>

namespace ringwatch {
namespace {

constexpr double rounding = 1e-9;  // of dense eigenvalues
constexpr double width = 0.05, budget = 0.1;
constexpr int states = 160;

/// A box that is wrung out and shaken: uneven motion, in which validity balls do not last.
NodeVectors wrung(const NodeVectors& X, double at, const NodeVectors& shake) {
  NodeVectors x = X;
  for (Eigen::Index i = 0; i < X.cols(); ++i)
    x.col(i) = Eigen::AngleAxisd(0.6 * at * X(0, i) / test::cellSize, Eigen::Vector3d::UnitX()) * X.col(i);
  return x + std::sin(25 * at) * shake;
}

struct Followed {
  int byMoved = 0;
  double steps = 0;  // that a time takes, relative to the critical step
};

Followed follow(const Body& body, const NodeVectors& shake, double share) {
  RunBracket bracket(body, width, share);
  Followed followed;
  for (int k = 0; k <= states; ++k) {
    const NodeVectors x = wrung(body.mesh().X, static_cast<double>(k) / states, shake);
    const double h = 2 / std::sqrt(test::DenseTangent(body, x).largest());
    const auto& found = bracket.evaluate(x, 2.0, std::nullopt, nullptr);
    EXPECT_TRUE(found.has_value());
    if (!found) return followed;
    EXPECT_LE(found->safe, h * (1 + rounding)) << k;
    EXPECT_GE(found->optimistic, h * (1 - rounding)) << k;
    followed.byMoved += found->safeBy == "moved-nodal-bound" ? 1 : 0;
    followed.steps += h / found->safe;
  }
  return followed;
}

TEST(StepThatFollows, IsProvenByTheMovedBoundWhereThatSavesSteps) {
  for (const test::Subdivision& subdivision : test::allSubdivisions()) {
    const Body body = test::boxBody(subdivision, "neo-hookean");
    const NodeVectors shake = test::Random(5).nodeVectors(body.nodeCount(), 0.12 * test::cellSize);
    const Followed followed = follow(body, shake, budget), without = follow(body, shake, 0);
    EXPECT_GT(followed.byMoved, 0) << subdivision.name;
    EXPECT_EQ(without.byMoved, 0) << subdivision.name;
    EXPECT_LT(followed.steps, without.steps) << subdivision.name;
  }
}

// A node whose elements have eroded, with a spring that sets the step: no ring is left to look at there.
TEST(StepThatFollows, IsProvenWhereANodeWithoutElementsSetsIt) {
  constexpr std::int32_t node = 0;
  for (const test::Subdivision& subdivision : test::allSubdivisions()) {
    const Body whole = test::boxBody(subdivision, "neo-hookean");
    std::vector<std::vector<bool>> stays;
    for (const auto& block : whole.blocks())
      for (std::int32_t e = (stays.emplace_back(), 0); e < block->elementCount(); ++e) {
        const auto nodes = block->nodesOf(e);
        stays.back().push_back(std::find(nodes.begin(), nodes.end(), node) == nodes.end());
      }
    Body body(whole, stays);
    DiscreteForces forces(body.nodeCount());
    forces.add(std::vector<Spring>{{.node = node, .stiffness = 1e3 * test::cellStiffness}});
    body.setDiscreteForces(std::move(forces));
    const NodeVectors shake = test::Random(5).nodeVectors(body.nodeCount(), 0.12 * test::cellSize);
    EXPECT_GT(follow(body, shake, budget).byMoved, 0) << subdivision.name;
  }
}

TEST(StepThatFollows, GoesOnFromASavedStateBitByBit) {
  const Body body = test::boxBody(test::allSubdivisions().front(), "neo-hookean");
  const NodeVectors shake = test::Random(5).nodeVectors(body.nodeCount(), 0.12 * test::cellSize);
  RunBracket whole(body, width, budget), resumed(body, width, budget);
  bool moved = false;
  for (int k = 0; k <= states; ++k) {
    const NodeVectors x = wrung(body.mesh().X, static_cast<double>(k) / states, shake);
    whole.evaluate(x, 2.0, std::nullopt, nullptr);
    if (moved) {
      resumed.evaluate(x, 2.0, std::nullopt, nullptr);
      ASSERT_TRUE(resumed.last() && whole.last());
      ASSERT_EQ(resumed.last()->safe, whole.last()->safe) << k;
      ASSERT_EQ(resumed.last()->optimistic, whole.last()->optimistic) << k;
    } else if (whole.last() && whole.last()->safeBy == "moved-nodal-bound") {
      moved = true;
      SavingArchive saving;
      saving(whole);
      const std::string saved = saving.take();
      LoadingArchive loading(saved);
      loading(resumed);
      loading.end();
    }
  }
  EXPECT_TRUE(moved);
}

}  // namespace
}  // namespace ringwatch
