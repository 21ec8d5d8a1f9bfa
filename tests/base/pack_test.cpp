// Pack against plain numbers, lane by lane, for every width and number type.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <type_traits>
#include <vector>

#include <ringwatch/base/pack.h>
#include <tests/support/random.h>

namespace ringwatch {
namespace {

template <class P>
class PackTest : public ::testing::Test {
 public:
  using Number = std::remove_cvref_t<decltype(P{}[0])>;
  static constexpr int lanes = P::width;

  P random(double low, double high) {
    P p{};
    for (int i = 0; i < lanes; ++i) p.set(i, static_cast<Number>(random_.uniform(low, high)));
    return p;
  }
  /// expected(lane) for all lanes of p, to the last bit.
  template <class Expected>
  static void expectLanes(const P& p, const Expected& expected) {
    for (int i = 0; i < lanes; ++i) EXPECT_EQ(p[i], static_cast<Number>(expected(i))) << "lane " << i;
  }
  test::Random random_{1};
};
using Packs = ::testing::Types<Pack<double, 2>, Pack<double, 4>, Pack<double, 8>, Pack<float, 4>, Pack<float, 8>,
                               Pack<float, 16>>;
struct PackNames {
  template <class P>
  static std::string GetName(int) {
    return (std::is_same_v<typename PackTest<P>::Number, double> ? "double" : "float") + std::to_string(P::width);
  }
};
TYPED_TEST_SUITE(PackTest, Packs, PackNames);

TYPED_TEST(PackTest, ScalarFillsAllLanes) {
  this->expectLanes(TypeParam(2.5f), [](int) { return 2.5f; });
}

TYPED_TEST(PackTest, LoadAndStoreAreInverse) {
  using T = typename TestFixture::Number;
  std::vector<T> in(TestFixture::lanes + 1), out(in.size());
  for (std::size_t i = 0; i < in.size(); ++i) in[i] = static_cast<T>(i) + T(0.25);
  // From an address that is no multiple of the pack's size.
  const TypeParam p = TypeParam::load(in.data() + 1);
  this->expectLanes(p, [&](int i) { return in[static_cast<std::size_t>(i) + 1]; });
  p.store(out.data() + 1);
  for (std::size_t i = 1; i < in.size(); ++i) EXPECT_EQ(out[i], in[i]);
}

TYPED_TEST(PackTest, ArithmeticIsThatOfItsLanes) {
  for (int trial = 0; trial < 100; ++trial) {
    const TypeParam a = this->random(-3, 3), b = this->random(0.5, 3);
    this->expectLanes(a + b, [&](int i) { return a[i] + b[i]; });
    this->expectLanes(a - b, [&](int i) { return a[i] - b[i]; });
    this->expectLanes(a * b, [&](int i) { return a[i] * b[i]; });
    this->expectLanes(a / b, [&](int i) { return a[i] / b[i]; });
    this->expectLanes(-a, [&](int i) { return -a[i]; });
    TypeParam c = a;
    this->expectLanes(c += b, [&](int i) { return a[i] + b[i]; });
    c = a;
    this->expectLanes(c -= b, [&](int i) { return a[i] - b[i]; });
    c = a;
    this->expectLanes(c *= b, [&](int i) { return a[i] * b[i]; });
  }
}

TYPED_TEST(PackTest, FunctionsAreThoseOfItsLanes) {
  for (int trial = 0; trial < 100; ++trial) {
    const TypeParam a = this->random(-3, 3), b = this->random(-3, 3), p = this->random(0, 10);
    this->expectLanes(math::sqrt(p), [&](int i) { return math::sqrt(p[i]); });
    this->expectLanes(math::abs(a), [&](int i) { return math::abs(a[i]); });
    this->expectLanes(math::max(a, b), [&](int i) { return math::max(a[i], b[i]); });
    this->expectLanes(math::min(a, b), [&](int i) { return math::min(a[i], b[i]); });
  }
  // Special values.
  EXPECT_TRUE(std::isnan(math::sqrt(TypeParam(-1))[0]));
  EXPECT_TRUE(std::isnan(math::log(TypeParam(-1))[TestFixture::lanes - 1]));
  EXPECT_TRUE(std::isinf((TypeParam(1) / TypeParam(0))[0]));
}

// Against long doubles, over the whole range, close to 1 and at its ends: in units in the last place.
TYPED_TEST(PackTest, LogarithmAndCubeRootAreWithinAUnitInTheLastPlace) {
  using T = typename TestFixture::Number;
  using Limits = std::numeric_limits<T>;
  const auto error = [](T found, long double exact) {
    const T size = static_cast<T>(std::abs(exact));
    return static_cast<double>(std::abs(static_cast<long double>(found) - exact) /
                               (std::nextafter(size, Limits::infinity()) - size));
  };
  double worst[2] = {};
  for (int trial = 0; trial < 30000; ++trial) {
    const double exponent = trial % 2
                                ? this->random_.uniform(Limits::min_exponent - Limits::digits, Limits::max_exponent)
                                : this->random_.uniform(-2, 2);
    const T fraction = static_cast<T>(this->random_.uniform(1, 2));
    const T a = trial % 3 ? std::ldexp(fraction, static_cast<int>(std::floor(exponent)))
                          : T(1) + std::ldexp(fraction, -1 - trial % Limits::digits) * T(trial % 2 ? -0.5 : 1);
    if (!(a > 0) || a == T(1) || !(a <= Limits::max())) continue;
    const int lane = trial % TestFixture::lanes;
    TypeParam p(2);
    p.set(lane, a);
    worst[0] = std::max(worst[0], error(math::log(p)[lane], std::log(static_cast<long double>(a))));
    worst[1] = std::max(worst[1], error(math::cbrt(p)[lane], std::cbrt(static_cast<long double>(a))));
    ASSERT_EQ(math::cbrt(-p)[lane], -math::cbrt(p)[lane]);
  }
  EXPECT_LE(worst[0], 1);
  EXPECT_LE(worst[1], 1);
  EXPECT_GT(worst[0], 0.4);  // half a unit is the best that rounding allows
  EXPECT_EQ(math::log(TypeParam(1))[0], 0);
  EXPECT_EQ(math::log(TypeParam(0))[0], -Limits::infinity());
  EXPECT_EQ(math::log(TypeParam(Limits::infinity()))[0], Limits::infinity());
  EXPECT_TRUE(std::isnan(math::log(TypeParam(-Limits::infinity()))[0]));
  EXPECT_EQ(math::cbrt(TypeParam(0))[0], 0);
  EXPECT_EQ(math::cbrt(TypeParam(-27))[0], -3);
  EXPECT_EQ(math::cbrt(TypeParam(-Limits::infinity()))[0], -Limits::infinity());
  for (const TypeParam& of : {math::log(TypeParam(Limits::quiet_NaN())), math::cbrt(TypeParam(Limits::quiet_NaN()))})
    EXPECT_TRUE(std::isnan(of[TestFixture::lanes - 1]));
}

TYPED_TEST(PackTest, ComparisonsAndSelectGoLaneByLane) {
  for (int trial = 0; trial < 100; ++trial) {
    const TypeParam a = this->random(-1, 1);
    TypeParam b = this->random(-1, 1);
    b.set(trial % TestFixture::lanes, a[trial % TestFixture::lanes]);  // an equal pair
    this->expectLanes(select(a < b, a, b), [&](int i) { return a[i] < b[i] ? a[i] : b[i]; });
    this->expectLanes(select(a > b, a, -b), [&](int i) { return a[i] > b[i] ? a[i] : -b[i]; });
    this->expectLanes(select(a <= b, a, -b), [&](int i) { return a[i] <= b[i] ? a[i] : -b[i]; });
    this->expectLanes(select(a >= b, a, -b), [&](int i) { return a[i] >= b[i] ? a[i] : -b[i]; });
    this->expectLanes(select(a == b, TypeParam(1), TypeParam(0)), [&](int i) { return a[i] == b[i] ? 1 : 0; });
  }
}

TYPED_TEST(PackTest, AnyAndAllSeeEveryLane) {
  const TypeParam zero(0);
  EXPECT_FALSE(anyOf(zero > zero));
  EXPECT_TRUE(allOf(zero == zero));
  for (int lane = 0; lane < TestFixture::lanes; ++lane) {
    TypeParam one(0);
    one.set(lane, 1);
    EXPECT_TRUE(anyOf(one > zero)) << lane;
    EXPECT_FALSE(allOf(one > zero)) << lane;
    EXPECT_FALSE(allOf(one == zero)) << lane;
  }
}

/// Rows for every lane, some of them shared.
template <int width>
std::array<std::uint16_t, width> rowsWithRepeats(test::Random& random, int rows) {
  std::array<std::uint16_t, width> row;
  for (auto& r : row) r = static_cast<std::uint16_t>(random.index(rows));
  row[width - 1] = row[0];
  return row;
}

TYPED_TEST(PackTest, LoadRowsTransposesTheRowOfEachLane) {
  using T = typename TestFixture::Number;
  constexpr int width = TestFixture::lanes, rows = 7;
  std::vector<T> table(4 * rows);
  for (std::size_t i = 0; i < table.size(); ++i) table[i] = static_cast<T>(this->random_.uniform(-1, 1));
  for (int trial = 0; trial < 50; ++trial) {
    const auto row = rowsWithRepeats<width>(this->random_, rows);
    TypeParam c[3];
    loadRows(table.data(), row.data(), c);
    for (int k = 0; k < 3; ++k)
      this->expectLanes(c[k], [&](int i) { return table[4u * row[i] + static_cast<unsigned>(k)]; });
  }
}

TYPED_TEST(PackTest, AddRowsAddsLaneAfterLaneEvenWhereLanesShareARow) {
  using T = typename TestFixture::Number;
  constexpr int width = TestFixture::lanes, rows = 3;
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<T> table(4 * rows, T(1)), expected = table;
    const auto row = rowsWithRepeats<width>(this->random_, rows);
    const TypeParam c[3] = {this->random(-1, 1), this->random(-1, 1), this->random(-1, 1)};
    addRows(table.data(), row.data(), c);
    for (unsigned i = 0; i < width; ++i)
      for (unsigned k = 0; k < 3; ++k) expected[4u * row[i] + k] += c[k][static_cast<int>(i)];
    EXPECT_EQ(table, expected);  // the padding stays too
  }
}

TYPED_TEST(PackTest, AllLanesInOneRowAddUp) {
  using T = typename TestFixture::Number;
  std::vector<T> table(8, T(0));
  const std::array<std::uint16_t, TestFixture::lanes> row{};  // all zero
  const TypeParam c[3] = {TypeParam(1), TypeParam(2), TypeParam(3)};
  addRows(table.data(), row.data(), c);
  for (unsigned k = 0; k < 3; ++k) EXPECT_EQ(table[k], static_cast<T>((k + 1) * TestFixture::lanes));
  for (unsigned k = 3; k < 8; ++k) EXPECT_EQ(table[k], T(0));
}

}  // namespace
}  // namespace ringwatch
