// What the watch promises: whoever is not named is inside its ball, while most groups rest.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include <Eigen/Dense>

#include <ringwatch/body/body.h>
#include <ringwatch/body/deformation_watch.h>
#include <ringwatch/meshes/generators.h>
#include <tests/support/random.h>

namespace ringwatch {
namespace {

using test::Random;

constexpr int lanes = PatchLayout::lanes;

struct Watched {
  explicit Watched(const Body& b) : body(b), block(*b.blocks()[0]), watch(block) {}
  std::size_t placeOf(std::int32_t e) const {
    return static_cast<std::size_t>(block.layout().batchOfElement[static_cast<std::size_t>(e)]);
  }
  Eigen::Matrix3d gradient(std::int32_t e, const NodeVectors& x) const {
    const auto nodes = block.nodesOf(e);
    Eigen::Matrix3d now, rest;
    for (int j = 0; j < 3; ++j) {
      now.col(j) = x.col(nodes[static_cast<std::size_t>(j) + 1]) - x.col(nodes[0]);
      rest.col(j) = body.mesh().X.col(nodes[static_cast<std::size_t>(j) + 1]) - body.mesh().X.col(nodes[0]);
    }
    return now * rest.inverse();
  }
  void anchor(std::int32_t e, const NodeVectors& x, double radius) {
    std::int32_t elements[lanes];
    std::fill(elements, elements + lanes, -1);
    elements[0] = e;
    TangentDrift drift[lanes];
    double F[9 * lanes];
    block.deformationOf(elements, x.data(), F, drift);
    watch.setRadius(placeOf(e), radius, watch.setAnchor(placeOf(e), F, 1, 0));
  }
  /// Those that left, after which they have new balls.
  std::set<std::int32_t> look(const NodeVectors& x) {
    ++watch.looks;
    std::vector<std::int32_t> left;
    for (std::size_t p = 0; p < block.layout().patches.size(); ++p)
      block.lookAtPatch(static_cast<std::int32_t>(p), x.data(), watch, left);
    return {left.begin(), left.end()};
  }
  /// The same in the pass that computes the force, which must be the force.
  std::set<std::int32_t> lookWithForce(const NodeVectors& x) {
    ++watch.looks;
    std::vector<std::int32_t> left;
    Body::Workspace workspace;
    NodeVectors force, expected;
    body.sumOverPatches(force, workspace, [&](std::size_t, std::int32_t p, double* slots) {
      block.forceAndLookPatch(p, x.data(), watch, slots, left);
    });
    body.internalForce(x, expected, workspace);
    // Compilers contract products and sums in two loops differently.
    if (expected.allFinite()) {
      EXPECT_LE((force - expected).norm(), 1e-13 * expected.norm() + 1e-15);
    }
    return {left.begin(), left.end()};
  }

  const Body& body;
  const ElementBlock& block;
  DeformationWatch watch;
};

TEST(DeformationWatch, NamesWhoeverLeavesItsBallAndLetsOthersRest) {
  BarOptions options;
  options.element = "tet4";
  options.cells = {30, 6, 6};
  options.size = {0.3, 0.06, 0.06};
  options.jitter = 0.2;
  const Body body(generateBar(options), makeMaterial("stvk", 1e4, 0.3, 1000), {{}, Lumping::rowSum, 1});
  const NodeVectors& X = body.mesh().X;
  // A smooth wave, motions of the whole, noise at a few nodes; slow and fast. Apart from the force, with it, by turns.
  for (const auto& [rate, pass] : std::vector<std::pair<double, int>>{{1e-5, 0},
                                                                      {1e-5, 1},
                                                                      {1e-5, 2},
                                                                      {1e-4, 0},
                                                                      {1e-4, 2},
                                                                      {1e-3, 0},
                                                                      {1e-3, 1},
                                                                      {1e-3, 2},
                                                                      {1e-2, 1},
                                                                      {1e-2, 2}}) {
    Random random(31);
    Watched watched(body);
    std::vector<Eigen::Matrix3d> anchors(static_cast<std::size_t>(watched.block.elementCount()));
    std::vector<double> radius(anchors.size());
    NodeVectors x = X;
    constexpr int steps = 120;
    std::int64_t looks = 0, left = 0;
    for (int step = 0; step <= steps; ++step) {
      if (step > 0) {
        const double time = rate * step;
        for (Eigen::Index i = 0; i < X.cols(); ++i) {
          const double phase = 20 * X(0, i) - 30 * time;
          x.col(i) = X.col(i) + 0.01 * Eigen::Vector3d(std::sin(phase), 0.3 * std::cos(phase) - 0.3, 0);
        }
        x = ((Eigen::Matrix3d::Identity() + time * random.matrix(0.1)) * x).colwise() + random.vector(0.1);
        x.col(random.index(body.nodeCount())) += random.vector(rate * 0.02);
      }
      const bool withForce = pass == 1 || (pass == 2 && step / 3 % 2 == 1);
      const std::set<std::int32_t> gone = withForce ? watched.lookWithForce(x) : watched.look(x);
      for (std::int32_t e = 0; e < watched.block.elementCount(); ++e) {
        const auto at = static_cast<std::size_t>(e);
        const Eigen::Matrix3d F = watched.gradient(e, x);
        if (gone.count(e) > 0) {
          anchors[at] = F;
          radius[at] = random.uniform(0.02, 0.1);
          watched.anchor(e, x, radius[at]);
        } else {
          ASSERT_LE((F - anchors[at]).norm(), radius[at] * (1 + 1e-6)) << "element " << e << ", step " << step;
        }
      }
      for (const std::int32_t e : gone) watched.watch.noteBall(watched.placeOf(e));
      left += static_cast<std::int64_t>(gone.size());
      for (const DeformationWatch::Group& group : watched.watch.groups) looks += group.lookedAt == watched.watch.looks;
    }
    if (rate > 5e-5) {
      EXPECT_GT(left, watched.block.elementCount());  // some after the first look
    }
    const auto groups = static_cast<std::int64_t>(watched.watch.groups.size());
    EXPECT_GT(groups, 4);
    if (rate < 5e-5) {
      EXPECT_LT(looks, groups * steps / 4);
    }
  }
}

TEST(DeformationWatch, AGroupWithoutRoomOrWithNaNIsLookedAt) {
  BarOptions options;
  options.element = "tet4";
  options.cells = {4, 4, 4};
  const Body body(generateBar(options), makeMaterial("stvk", 1e4, 0.3, 1000), {{}, Lumping::rowSum, 1});
  Watched watched(body);
  NodeVectors x = body.mesh().X;
  EXPECT_EQ(watched.look(x).size(), static_cast<std::size_t>(watched.block.elementCount()));
  for (std::int32_t e = 0; e < watched.block.elementCount(); ++e) {
    watched.anchor(e, x, 0.1);
    watched.watch.noteBall(watched.placeOf(e));
  }
  EXPECT_TRUE(watched.look(x).empty());
  // A ball that is too small for any motion of its group.
  watched.anchor(7, x, 1e-6);
  watched.watch.noteBall(watched.placeOf(7));
  x.col(watched.block.nodesOf(7)[0]) += Eigen::Vector3d(1e-4, 0, 0);
  EXPECT_EQ(watched.look(x), std::set<std::int32_t>{7});
  // Positions whose squares overflow: every element leaves, and nobody else.
  const NodeVectors huge = 1e200 * x;
  for (const bool withForce : {false, true}) {
    const std::set<std::int32_t> left = withForce ? watched.lookWithForce(huge) : watched.look(huge);
    EXPECT_EQ(left.size(), static_cast<std::size_t>(watched.block.elementCount()));
    EXPECT_GE(*left.begin(), 0);
  }
  x(1, watched.block.nodesOf(9)[2]) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(watched.look(x).count(9), 1U);
  EXPECT_EQ(watched.lookWithForce(x).count(9), 1U);
}

}  // namespace
}  // namespace ringwatch
