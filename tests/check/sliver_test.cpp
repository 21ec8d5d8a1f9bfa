// The bracket of single flat tetrahedra, turned in space, against their exact critical step in ball arithmetic. Before
// the margins of Theorem 42 (docs/theory/floating_point.md) the safe step of one of height 1e-6 lay 2.6e-11 above it,
// and at 1e-10 either side was wrong by 1e-7.
#include <optional>

#include <gtest/gtest.h>

#include <ringwatch/base/infinity.h>
#include <ringwatch/monitor/critical_step.h>
#include <ringwatch/monitor/incremental/run_bracket.h>
#include <tests/check/exact_element.h>
#include <tests/support/random.h>

namespace ringwatch {
namespace {

using check::Ball;
constexpr double stepLimit = 2;

/// A tetrahedron of edge 1 cm with its top `height` edges above the middle of its base, or above a corner.
Body sliver(double height, bool overCorner, double distance, test::Random& random) {
  Mesh mesh;
  mesh.blocks.push_back({findElementByName("tet4")->type, {0, 1, 2, 3}, {0}});
  mesh.X.resize(3, 4);
  mesh.X << 0, 1, 0.4, overCorner ? 0 : 0.45, 0, 0, 0.9, overCorner ? 0 : 0.3, 0, 0, 0, height;
  const Eigen::Vector3d away = distance * Eigen::Vector3d(1, -0.7, 0.4);
  mesh.X = 0.01 * ((random.rotation() * mesh.X).colwise() + away);
  return Body(std::move(mesh), makeMaterial("stvk", 30e3, 0.3, 1000));
}

/// Whether lambda_max(M⁻¹K) < sigma, exactly.
bool below(const Body& body, const check::Square& K, double sigma) {
  check::Square rest(K.size);
  for (int i = 0; i < K.size; ++i)
    for (int j = 0; j < K.size; ++j)
      rest(i, j) = (i == j ? Ball(sigma) * Ball(body.lumpedMass()[i / 3]) : Ball(0.0)) - K(i, j);
  return test::definite(rest);
}

/// Both sides hold exactly; the eigenvalue of a step is rounded to the side that makes the test harder.
void expectBracket(const CriticalStep& step, const Body& body, const check::Square& K, const std::string& which) {
  const double upper = stepLimit / step.safe * (stepLimit / step.safe),
               lower = stepLimit / step.optimistic * (stepLimit / step.optimistic);
  constexpr double ofSquare = 1e-15;
  EXPECT_TRUE(below(body, K, upper * (1 - ofSquare))) << which << ": the safe side, " << step.safe;
  EXPECT_FALSE(below(body, K, lower * (1 - ofSquare))) << which << ": the optimistic side, " << step.optimistic;
}

TEST(Sliver, HasABracketThatHolds) {
  test::Random random(11);
  Ball::precision = 256;
  int tried = 0;
  for (const double height : {1e-2, 1e-4, 1e-6, 1e-8, 1e-9, 1e-10})
    for (const bool overCorner : {false, true})
      for (const double distance : {0.0, 1e5})
        for (int turn = 0; turn < 4; ++turn) {
          if (distance * 1e-14 > height) continue;  // stored positions no longer have that height
          const Body body = sliver(height, overCorner, distance, random);
          const std::string which = "height " + std::to_string(height) + ", distance " + std::to_string(distance);
          check::Square K(0);
          ASSERT_TRUE(test::exactTangent(body, body.mesh().X, K));
          const CriticalStep step = criticalStep(body, body.mesh().X, stepLimit);
          expectBracket(step, body, K, which);
          // Shapes leave the safe side a little short, and no more than a part in a hundred.
          EXPECT_LT(step.optimistic / step.safe, 1.011) << which;
          RunBracket run(body, 0.05, infinity);
          NodeVectors x = body.mesh().X;
          for (int observation = 0; observation < 3; ++observation) {
            ASSERT_TRUE(test::exactTangent(body, x, K));
            const std::optional<CriticalStep>& bracket = run.evaluate(x, stepLimit, std::nullopt, nullptr);
            ASSERT_TRUE(bracket) << which;
            expectBracket(*bracket, body, K, which + ", along a run");
            const Eigen::Vector3d centre = x.col(0);
            x = ((Eigen::Matrix3d::Identity() + random.matrix(0.01)) * (x.colwise() - centre)).colwise() + centre;
          }
          ++tried;
        }
  EXPECT_GT(tried, 70);
}

}  // namespace
}  // namespace ringwatch
