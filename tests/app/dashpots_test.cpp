// The exact criterion of damping of any kind (Theorem 47): the rule of the step against the spectral radius of the
// recursion, and damped oscillators in closed form.
#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include <ringwatch/app/scene/integrator_catalog.h>
#include <ringwatch/body/body.h>
#include <ringwatch/body/discrete_forces.h>
#include <ringwatch/monitor/critical_step.h>
#include <tests/support/dense.h>
#include <tests/support/meshes.h>
#include <tests/support/random.h>

namespace ringwatch {
namespace {

using Eigen::MatrixXd;

/// The largest root of M (x⁺ - 2x + x⁻)/h² + C (x - x⁻)/h + K x = 0 by size.
double largestRoot(const MatrixXd& M, const MatrixXd& C, const MatrixXd& K, double h) {
  const Eigen::Index n = M.rows();
  const MatrixXd inverse = M.diagonal().cwiseInverse().asDiagonal();
  MatrixXd T = MatrixXd::Zero(2 * n, 2 * n);
  T.topLeftCorner(n, n) = 2 * MatrixXd::Identity(n, n) - inverse * (h * C + h * h * K);
  T.topRightCorner(n, n) = -MatrixXd::Identity(n, n) + h * inverse * C;
  T.bottomLeftCorner(n, n).setIdentity();
  return test::spectralRadius(T);
}

/// A random positive semidefinite matrix of some rank.
MatrixXd semidefinite(test::Random& random, int n, int rank, double size) {
  const MatrixXd G = MatrixXd::NullaryExpr(n, rank, [&] { return random.uniform(-1, 1); });
  return size * G * G.transpose();
}

TEST(Dashpots, RulesAreExactAtTheirReferenceAndOnTheirSideElsewhere) {
  int tight = 0, below = 0, above = 0, sharper = 0;
  for (int trial = 0; trial < 400; ++trial) {
    test::Random random(100 + trial);
    const int n = 2 + static_cast<int>(random.index(5));
    MatrixXd M = MatrixXd::Zero(n, n);
    for (int i = 0; i < n; ++i) M(i, i) = random.uniform(0.5, 2);
    const MatrixXd K = semidefinite(random, n, n, 1), Cx = semidefinite(random, n, 1, random.uniform(0, 3));
    const RayleighDamping rayleigh{random.index(2) ? random.uniform(0, 0.3) : 0,
                                   random.index(2) ? random.uniform(0, 0.3) : 0};
    const MatrixXd C = rayleigh.alpha * M + rayleigh.beta * K + Cx;
    const IntegratorInfo& info = *integratorCatalog().find(trial % 2 ? "verlet" : "symplectic-euler");
    const auto ruled = [&](double reference) {
      const MatrixXd dashpots = dampingFactor(rayleigh, reference) * Cx;
      const auto modes = test::generalizedEigen(K + dashpots, M);
      const double highest = modes.values[n - 1];
      const Eigen::VectorXd top = modes.vectors.col(n - 1);
      const double part = top.dot(dashpots * top) / top.dot(M * top);
      const StepRule rule = stepRuleWithDashpots(info, rayleigh, reference);
      EXPECT_TRUE(rule.proven());
      return std::tuple{rule(highest), rule.optimistic({highest}), rule.optimistic({highest, part, part})};
    };
    // The reference that the rule gives back is the limit itself.
    double h = std::get<0>(ruled(0.5));
    for (int i = 0; i < 200; ++i) h = std::sqrt(h * std::get<0>(ruled(h)));
    EXPECT_LE(largestRoot(M, C, K, h * (1 - 1e-7)), 1 + 1e-9) << trial;
    EXPECT_GT(largestRoot(M, C, K, h * (1 + 1e-6)), 1) << trial;
    const auto [safe, optimistic, known] = ruled(h);
    EXPECT_NEAR(safe, h, 1e-8 * h) << trial;
    EXPECT_NEAR(optimistic, h, 1e-8 * h) << trial;
    EXPECT_NEAR(known, h, 1e-8 * h) << trial;
    ++tight;
    for (const double reference : {0.3 * h, 0.9 * h, 1.2 * h, 4 * h}) {
      const auto [low, high, vectors] = ruled(reference);
      EXPECT_LE(low, h * (1 + 1e-9)) << trial << " " << reference / h;
      EXPECT_GE(high, h * (1 - 1e-9)) << trial << " " << reference / h;
      // The vector's own damping says more, and no more than is true.
      EXPECT_GE(vectors, h * (1 - 1e-9)) << trial << " " << reference / h;
      EXPECT_LE(vectors, high * (1 + 1e-12)) << trial << " " << reference / h;
      sharper += vectors < 0.99 * high;
      // What counts for a run at the reference is right: it is certified or refused as it should be.
      EXPECT_EQ(reference <= low, reference < h) << trial << " " << reference / h;
      EXPECT_EQ(reference > high, reference > h) << trial << " " << reference / h;
      below += low < 0.99 * h;
      above += high > 1.01 * h;
    }
  }
  EXPECT_EQ(tight, 400);
  EXPECT_GT(below, 50);
  EXPECT_GT(above, 50);
  EXPECT_GT(sharper, 50);
}

// One free component of a cube: m h⁻² ≥ … has the limit h = (√(c² + 4 k m) - c)/k.
TEST(Dashpots, OscillatorsHaveTheirClosedFormInTheBracket) {
  int compared = 0;
  for (const double ratio : {0.01, 0.3, 1.0, 3.0, 30.0}) {
    Body body(test::gridMesh("hex8", {1, 1, 1}, {0.1, 0.1, 0.1}), makeMaterial("linear", 1e4, 0.3, 1000));
    for (std::int32_t i = 0; i < body.nodeCount(); ++i)
      for (int c = 0; c < 3; ++c)
        if (i != 0 || c != 0) body.constraints().fix(i, c);
    const double own = Eigen::MatrixXd(body.assembleTangent(body.mesh().X))(0, 0), m = body.lumpedMass()[0];
    const double k = own + 500, c = ratio * 2 * std::sqrt(k * m);
    const double h = (std::sqrt(c * c + 4 * k * m) - c) / k;
    DiscreteForces forces(body.nodeCount());
    // Across the free component in part: 0.36 of spring and dashpot act along it.
    forces.add(std::vector<Spring>{
        {.node = 0, .direction = Eigen::Vector3d(0.6, 0.8, 0), .stiffness = 500 / 0.36, .damping = c / 0.36}});
    body.setDiscreteForces(std::move(forces));
    // The optimistic side knows what the dashpot gives, and is exact for all reference steps.
    for (const double reference : {1.0, 0.1, 10.0}) {
      body.discreteForces()->setDampingFactor(dampingFactor({}, reference * h));
      const StepRule rule = stepRuleWithDashpots(*integratorCatalog().find("verlet"), {}, reference * h);
      const CriticalStep step = criticalStep(body, body.mesh().X, rule);
      if (reference == 1) {
        EXPECT_NEAR(step.safe, h, 1e-8 * h) << ratio;
      }
      EXPECT_LE(step.safe, h) << ratio << " " << reference;
      EXPECT_GE(step.optimistic, h * (1 - 1e-12)) << ratio << " " << reference;
      EXPECT_NEAR(step.optimistic, h, 5e-8 * h) << ratio << " " << reference;
      ++compared;
    }
  }
  EXPECT_EQ(compared, 15);
}

}  // namespace
}  // namespace ringwatch
