// Every quadrature rule of every element, one that is added among them: weights, points, and the monomials it
// integrates exactly.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <ringwatch/elements/registry.h>
#include <tests/added/wedge15.h>
#include <tests/support/random.h>
#include <tests/support/registry_types.h>

namespace ringwatch {
namespace {

struct RuleCase {
  const ElementInfo* element;
  QuadratureRule rule;
};
std::vector<RuleCase> allRules() {
  std::vector<RuleCase> cases;
  const auto add = [&](const ElementInfo& element) {
    for (const QuadratureRule& rule : element.rules) cases.push_back({&element, rule});
    cases.push_back({&element, element.massRule});
  };
  for (const ElementInfo& element : allElements()) add(element);
  static const ElementInfo added = elementInfoOf<test::Wedge15>(ElementType{});
  add(added);
  return cases;
}

class RuleTest : public ::testing::TestWithParam<RuleCase> {
 public:
  const ElementInfo& element() const { return *GetParam().element; }
  const QuadratureRule& rule() const { return GetParam().rule; }

  static double monomial(const Eigen::Vector3d& p, int i, int j, int k) {
    return std::pow(p[0], i) * std::pow(p[1], j) * std::pow(p[2], k);
  }
  double byRule(int i, int j, int k) const {
    double sum = 0;
    for (const QuadraturePoint& q : rule().points) sum += q.weight * monomial(Eigen::Vector3d::Map(q.xi), i, j, k);
    return sum;
  }
  /// The integral over the reference element by the divergence theorem, ∫ x^i y^j z^k dV = ∮ x^(i+1) y^j z^k n_x dA /
  /// (i+1), faces cut into triangles, each by a collapsed product rule of degree 9: nothing of the element's own
  /// quadrature.
  double exact(int i, int j, int k) const {
    const double a = std::sqrt(5 - 2 * std::sqrt(10.0 / 7)) / 3, b = std::sqrt(5 + 2 * std::sqrt(10.0 / 7)) / 3;
    const double wa = (322 + 13 * std::sqrt(70.0)) / 900, wb = (322 - 13 * std::sqrt(70.0)) / 900;
    const double x[5] = {0, a, -a, b, -b}, w[5] = {128.0 / 225, wa, wa, wb, wb};
    double sum = 0;
    for (const auto& face : element().faces)
      for (std::size_t t = 1; t < 3; ++t) {
        if (t == 2 && face[3] < 0) continue;
        const auto corner = [&](std::size_t c) {
          return Eigen::Vector3d(Eigen::Vector3d::Map(element().referenceNodes[face[c]].data()));
        };
        const Eigen::Vector3d p = corner(0), q = corner(t) - p, r = corner(t + 1) - p;
        const double normal = q.cross(r)[0];  // twice the area
        for (int m = 0; m < 5; ++m)
          for (int n = 0; n < 5; ++n) {
            const double u = (1 + x[m]) / 2, v = (1 + x[n]) / 2 * (1 - u);
            sum += normal * w[m] * w[n] / 4 * (1 - u) * monomial(p + u * q + v * r, i + 1, j, k) / (i + 1);
          }
      }
    return sum;
  }
  bool exactToDegree(int degree) const {
    for (int i = 0; i <= degree; ++i)
      for (int j = 0; i + j <= degree; ++j)
        for (int k = 0; i + j + k <= degree; ++k)
          if (std::abs(byRule(i, j, k) - exact(i, j, k)) > 1e-14 * element().referenceVolume * 4) return false;
    return true;
  }
};
INSTANTIATE_TEST_SUITE_P(All, RuleTest, ::testing::ValuesIn(allRules()), [](const auto& test) {
  return test::testName(std::string(test.param.element->name) + "_" + std::string(test.param.rule.name)) + "_" +
         std::to_string(test.index);
});

TEST_P(RuleTest, WeightsArePositiveAndSumToTheVolume) {
  double sum = 0;
  for (const QuadraturePoint& q : rule().points) {
    EXPECT_GT(q.weight, 0);
    sum += q.weight;
  }
  EXPECT_NEAR(sum, element().referenceVolume, 1e-14 * element().referenceVolume);
}

TEST_P(RuleTest, PointsLieInside) {
  for (const QuadraturePoint& q : rule().points)
    for (const auto& face : element().faces) {
      const auto corner = [&](std::size_t c) {
        return Eigen::Vector3d(Eigen::Vector3d::Map(element().referenceNodes[face[c]].data()));
      };
      const Eigen::Vector3d normal = (corner(1) - corner(0)).cross(corner(2) - corner(0));
      EXPECT_LT(normal.dot(Eigen::Vector3d::Map(q.xi) - corner(0)), 0);
    }
}

TEST_P(RuleTest, IsExactForLinearFields) { EXPECT_TRUE(exactToDegree(1)); }

TEST_P(RuleTest, HasTheDegreeOfItsName) {
  // A Gauss rule of n points a direction has degree 2n - 1, Keast's four points degree 2.
  const std::string name(rule().name);
  // On the pyramid n Gauss–Legendre points along the axis give up two degrees to the weight (1 - z)²; x^i y^j brings
  // (1 - z)^(i+j) along. Fierz 2013's five points have degree 2 (Felippa 2009).
  const std::map<std::string, int> degrees{{"gauss-1", 1},         {"keast-4", 2},         {"gauss-2x2x2", 3},
                                           {"gauss-3x3x3", 5},     {"gauss-3x2", 2},       {"stroud-15", 5},
                                           {"collapsed-2x2x2", 1}, {"collapsed-3x3x3", 3}, {"jacobi-2x2x1", 1},
                                           {"gauss-3x3", 2},       {"gauss-6x3", 4}};
  const auto known = degrees.find(name);
  if (known == degrees.end() && name != "fierz2013") GTEST_SKIP() << "no degree is claimed for " << name;
  const int degree = name == "fierz2013" ? (element().name == "pyramid5" ? 2 : 1) : known->second;
  EXPECT_TRUE(exactToDegree(degree)) << name;
  EXPECT_FALSE(exactToDegree(degree + 1)) << name;
}

TEST_P(RuleTest, SharesOfEachConstantAddUpToOne) {
  EXPECT_NEAR(rule().shares.pointLambda + rule().shares.meanLambda, 1, 1e-15);
  EXPECT_NEAR(rule().shares.pointMu + rule().shares.meanMu, 1, 1e-15);
}

TEST_P(RuleTest, MassRuleIntegratesProductsOfShapesOfLinearElements) {
  // Lumped masses need ∫ N_a det J: shape times Jacobian; checked on the reference element, ∫ N_a = exact share.
  if (rule().name != element().massRule.name) GTEST_SKIP() << "no mass rule";
  std::vector<double> N(element().nodes), sum(N.size(), 0.0);
  for (const QuadraturePoint& q : rule().points) {
    element().shape(q.xi, N.data());
    for (std::size_t a = 0; a < N.size(); ++a) sum[a] += q.weight * N[a];
  }
  double total = 0;
  bool positive = true;
  for (double s : sum) {
    positive = positive && s > 0;
    total += s;
  }
  EXPECT_EQ(positive, element().positiveRowSums);
  EXPECT_NEAR(total, element().referenceVolume, 1e-14);
}

}  // namespace
}  // namespace ringwatch
