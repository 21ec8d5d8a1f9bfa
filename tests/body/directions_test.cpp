// The operators of hexahedra and wedges that go one direction after the other, against sums over the tables of ∂N/∂ξ.
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include <ringwatch/body/element_operators.h>
#include <ringwatch/elements/hex8.h>
#include <ringwatch/elements/wedge6.h>
#include <tests/support/random.h>

namespace ringwatch {
namespace {

template <class E>
class Directions : public testing::Test {};
struct Names {
  template <class E>
  static std::string GetName(int) {
    return std::string(E::name);
  }
};
using Elements = testing::Types<Hex8, Wedge6>;
TYPED_TEST_SUITE(Directions, Elements, Names);

TYPED_TEST(Directions, AreTheSumsOverTheTables) {
  using E = TypeParam;
  using Operators = ElementOperators<E, double>;
  constexpr int n = E::nodes;
  // Edges are up to 2, stresses up to 1. Measured: 4.4e-16 and 1.8e-15, in sums over all points.
  constexpr double gradientTolerance = 1.3e-15, forceTolerance = 4e-15;
  test::Random random(1);
  for (int trial = 0; trial < 1000; ++trial) {
    double u[n][3], force[n][3], expected[n][3] = {};
    for (int i = 0; i < 3; ++i) {
      u[0][i] = 0;
      for (int a = 1; a < n; ++a) u[a][i] = random.uniform(-2, 2);
    }
    const typename E::Directions::template Field<double> field(u);
    typename E::Directions::template Forces<double> forces;
    for (int q = 0; q < static_cast<int>(E::Directions::points.size()); ++q) {
      double dN[n][3];
      E::shapeGradient(E::Directions::points[q].xi, dN);
      const Matrix3<double> D = Operators::naturalGradient([&](int a, int i) { return u[a][i]; }, dN);
      Matrix3<double> stress;
      for (int i = 0; i < 9; ++i) {
        ASSERT_NEAR(field(q).m[i], D.m[i], gradientTolerance) << q;
        stress.m[i] = random.uniform(-1, 1);
      }
      forces.add(q, stress);
      Operators::addForces(stress, dN, expected);
    }
    forces.store(force);
    for (int a = 0; a < n; ++a)
      for (int i = 0; i < 3; ++i) ASSERT_NEAR(force[a][i], expected[a][i], forceTolerance) << a;
  }
}

TYPED_TEST(Directions, ServeTheRulesWithTheirPoints) {
  using E = TypeParam;
  int served = 0;
  for (const QuadratureRule& rule : E::rules) {
    const bool serves = haveDirections<typename E::Directions>(rule);
    EXPECT_EQ(serves, rule.points.size() == E::Directions::points.size()) << rule.name;
    served += serves ? 1 : 0;
  }
  EXPECT_GE(served, 2);
  // The same points in another order are left to the tables.
  auto turned = E::Directions::points;
  std::swap(turned[0], turned[1]);
  EXPECT_FALSE(haveDirections<typename E::Directions>({"turned", "", turned}));
}

}  // namespace
}  // namespace ringwatch
