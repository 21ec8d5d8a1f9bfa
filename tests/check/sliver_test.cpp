// The bracket of single flat tetrahedra, turned in space, against their exact critical step in ball arithmetic. Before
// the margins of Theorem 42 (docs/theory/floating_point.md) the safe step of one of height 1e-6 lay 2.6e-11 above it,
// and at 1e-10 either side was wrong by 1e-7.
#include <algorithm>
#include <array>
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

/// Edges from the first node of a tetrahedron, one a column.
using Matrix = std::array<std::array<Ball, 3>, 3>;
Matrix edgesOf(const NodeVectors& x) {
  Matrix edges;
  for (int i = 0; i < 3; ++i)
    for (int a = 0; a < 3; ++a) edges[i][a] = Ball(x(i, a + 1)) - Ball(x(i, 0));
  return edges;
}
Ball cofactor(const Matrix& A, int i, int j) {
  const int r = (i + 1) % 3, s = (i + 2) % 3, c = (j + 1) % 3, d = (j + 2) % 3;
  return A[r][c] * A[s][d] - A[r][d] * A[s][c];
}

TEST(Sliver, HasADeformationGradientAsExactAsIsSaid) {
  test::Random random(12);
  Ball::precision = 256;
  double least = infinity;
  for (const double height : {1.0, 1e-2, 1e-4, 1e-6, 1e-8})
    for (int turn = 0; turn < 16; ++turn) {
      const Body body = sliver(height, turn % 2 == 0, 0, random);
      const NodeVectors x = random.rotation() * (Eigen::Matrix3d::Identity() + random.matrix(0.3)) * body.mesh().X;
      std::int32_t elements[lanes];
      std::fill(elements, elements + lanes, -1);
      elements[0] = 0;
      double F[9 * lanes];
      TangentDrift drift[lanes];
      body.blocks()[0]->deformationOf(elements, x.data(), F, drift);
      const Matrix present = edgesOf(x), J = edgesOf(body.mesh().X);
      const Ball det = J[0][0] * cofactor(J, 0, 0) + J[0][1] * cofactor(J, 0, 1) + J[0][2] * cofactor(J, 0, 2);
      Ball sum;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
          Ball exact;
          for (int k = 0; k < 3; ++k) exact.addProduct(present[i][k], cofactor(J, j, k) / det);
          const Ball off = exact - Ball(F[(3 * i + j) * lanes]);
          sum.addProduct(off, off);
        }
      // It is said of two gradients, twice each.
      const double error = std::sqrt(sum.size().rounded()), said = drift[0].gradientRounding / 4;
      least = std::min(least, said / error);
      EXPECT_GE(said, 10 * error) << "height " << height;
    }
  EXPECT_LT(least, 1e4);
}

}  // namespace
}  // namespace ringwatch
