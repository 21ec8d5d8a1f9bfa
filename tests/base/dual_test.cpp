// Dual numbers against derivatives known in closed form.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include <ringwatch/base/dual.h>

namespace ringwatch {
namespace {

double number(int low, int high) { return *rc::gen::inRange(low, high) / 64.0; }

RC_GTEST_PROP(Dual, ObeysProductQuotientAndChainRule, ()) {
  const double x = number(16, 640);
  const Dual d(x, 1);
  const auto near = [](double a, double b) { return std::abs(a - b) <= 1e-14 * (1 + std::abs(b)); };
  RC_ASSERT(near((d * d * d).derivative, 3 * x * x));
  RC_ASSERT(near((Dual(1) / d).derivative, -1 / (x * x)));
  RC_ASSERT(near((d / (d + Dual(1))).derivative, 1 / ((x + 1) * (x + 1))));
  RC_ASSERT(near(math::sqrt(d).derivative, 0.5 / std::sqrt(x)));
  RC_ASSERT(near(math::log(d).derivative, 1 / x));
  RC_ASSERT(near(math::log(math::sqrt(d * d + Dual(1))).derivative, x / (x * x + 1)));
  RC_ASSERT(near((-d - d).derivative, -2.0));
}

RC_GTEST_PROP(Dual, ValuesAreThoseOfPlainNumbers, ()) {
  const double x = number(-640, 640), y = number(1, 640);
  const Dual a(x, 3), b(y, -2);
  RC_ASSERT((a + b).value == x + y);
  RC_ASSERT((a - b).value == x - y);
  RC_ASSERT((a * b).value == x * y);
  RC_ASSERT((a / b).value == x / y);
  RC_ASSERT(math::sqrt(b).value == std::sqrt(y));
  RC_ASSERT(math::log(b).value == std::log(y));
  RC_ASSERT((a < b) == (x < y));
  RC_ASSERT((a >= b) == (x >= y));
}

TEST(Dual, CompoundOperatorsCarryTheDerivative) {
  Dual a(3, 1);
  a += Dual(1);
  a *= Dual(2, 1);
  a -= Dual(0, 5);
  EXPECT_EQ(a.value, 8);
  EXPECT_EQ(a.derivative, 4 * 1 + 1 * 2 - 5);
}

TEST(Dual, AbsMaxMinAndSelectPassTheDerivativeOfTheBranchTaken) {
  EXPECT_EQ(math::abs(Dual(-2, 3)).derivative, -3);
  EXPECT_EQ(math::abs(Dual(2, 3)).derivative, 3);
  EXPECT_EQ(math::max(Dual(1, 5), Dual(2, 7)).derivative, 7);
  EXPECT_EQ(math::min(Dual(1, 5), Dual(2, 7)).derivative, 5);
  EXPECT_EQ(select(true, Dual(1, 5), Dual(2, 7)).derivative, 5);
  EXPECT_EQ(select(false, Dual(1, 5), Dual(2, 7)).derivative, 7);
}

}  // namespace
}  // namespace ringwatch
