// Numbers of 16 bits: every pattern there and back, the nearest or the wanted side for random numbers.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include <ringwatch/base/infinity.h>
#include <ringwatch/base/short_floats.h>
#include <tests/support/random.h>

namespace ringwatch {
namespace {

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

TEST(ShortRoot, KnowsSmallNumbersBetter) {
  test::Random random(3);
  for (int trial = 0; trial < 100000; ++trial) {
    const double value = random.uniform(-1, 1) * std::pow(10.0, random.uniform(-8, 0)), kept = ShortRoot(value);
    EXPECT_LE(std::abs(kept - value), 3.1e-5 * std::sqrt(std::abs(value)) + 2.4e-10) << value;
    EXPECT_EQ(static_cast<double>(ShortRoot(kept)), kept);
  }
  for (const double exact : {0.0, 1.0, -1.0}) EXPECT_EQ(static_cast<double>(ShortRoot(exact)), exact);
  EXPECT_NE(static_cast<double>(ShortRoot(1e-9)), 0);
}

TEST(ShortRoot, KnowsItsRange) {
  for (const double other : {notANumber, infinity, -infinity}) EXPECT_EQ(static_cast<double>(ShortRoot(other)), 0);
  EXPECT_EQ(static_cast<double>(ShortRoot(1 + 1e-12)), 1);
  EXPECT_EQ(static_cast<double>(ShortRoot(-2)), -1);
}

TEST(ShortRoot, PacksConvertAsSingleNumbersDo) {
  test::Random random(4);
  for (int trial = 0; trial < 1000; ++trial) {
    NativePack values;
    for (int lane = 0; lane < NativePack::width; ++lane)
      values.set(lane, trial == 0 ? notANumber : trial == 1 ? (lane % 2 == 0 ? 1.0 : -1.0) : random.uniform(-1, 1));
    ShortRoot stored[NativePack::width];
    ShortRoot::store(values, stored);
    const NativePack back = ShortRoot::load(stored);
    for (int lane = 0; lane < NativePack::width; ++lane) {
      EXPECT_EQ(back[lane], static_cast<double>(ShortRoot(values[lane])));
      EXPECT_EQ(back[lane], static_cast<double>(stored[lane]));
    }
  }
}

TEST(Bfloat16, RoundsToTheSafeSide) {
  test::Random random(5);
  for (int trial = 0; trial < 100000; ++trial) {
    const double value = random.uniform(-1, 1) * std::pow(10.0, random.uniform(-30, 30));
    const double down = Bfloat16::down(value), up = Bfloat16::up(value);
    EXPECT_LE(down, value);
    EXPECT_GE(up, value);
    EXPECT_LE(up - down, std::ldexp(std::abs(value), -6)) << value;
  }
  for (const double exact : {0.0, 1.0, -1.0, 0.75, infinity, -infinity}) {
    EXPECT_EQ(static_cast<double>(Bfloat16::down(exact)), exact);
    EXPECT_EQ(static_cast<double>(Bfloat16::up(exact)), exact);
  }
  EXPECT_TRUE(std::isnan(static_cast<double>(Bfloat16::down(notANumber))));
  EXPECT_TRUE(std::isnan(static_cast<double>(Bfloat16::up(notANumber))));
  Bfloat16 stored[NativePack::width];
  for (int lane = 0; lane < NativePack::width; ++lane) stored[lane] = Bfloat16::down(lane - 1.5);
  const NativePack back = Bfloat16::load(stored);
  for (int lane = 0; lane < NativePack::width; ++lane) EXPECT_EQ(back[lane], lane - 1.5);
}

template <class T>
class RoundedTest : public ::testing::Test {};
using StoredTypes = ::testing::Types<float, Bfloat16>;
TYPED_TEST_SUITE(RoundedTest, StoredTypes);

TYPED_TEST(RoundedTest, KeepsItsSideWhateverIsAssigned) {
  test::Random random(6);
  RoundedDown<TypeParam> down;
  RoundedUp<TypeParam> up;
  EXPECT_EQ(static_cast<double>(down), 0);
  EXPECT_EQ(static_cast<double>(up), 0);
  bool differ = false;
  for (int trial = 0; trial < 10000; ++trial) {
    const double value = random.uniform(-1, 1) * std::pow(10.0, random.uniform(-30, 30));
    down = value;
    up = value;
    EXPECT_LE(static_cast<double>(down), value);
    EXPECT_GE(static_cast<double>(up), value);
    EXPECT_LE(up - down, std::ldexp(std::abs(value), -6)) << value;
    differ = differ || down < up;
  }
  EXPECT_TRUE(differ);
  for (const double exact : {0.0, 1.0, -0.75, infinity, -infinity}) {
    EXPECT_EQ(static_cast<double>(RoundedDown<TypeParam>(exact)), exact);
    EXPECT_EQ(static_cast<double>(RoundedUp<TypeParam>(exact)), exact);
  }
  EXPECT_TRUE(std::isnan(static_cast<double>(RoundedDown<TypeParam>(notANumber))));
  EXPECT_TRUE(std::isnan(static_cast<double>(RoundedUp<TypeParam>(notANumber))));
  EXPECT_EQ(sizeof(RoundedDown<TypeParam>), sizeof(TypeParam));
}

TYPED_TEST(RoundedTest, PacksKeepTheirSide) {
  test::Random random(7);
  RoundedDown<TypeParam> down[NativePack::width];
  RoundedUp<TypeParam> up[NativePack::width];
  for (int trial = 0; trial < 10000; ++trial) {
    NativePack values;
    for (int lane = 0; lane < NativePack::width; ++lane) {
      values.set(lane, random.uniform(0, 1) * std::pow(10.0, random.uniform(-44, 30)));
      up[lane] = values[lane];
    }
    RoundedDown<TypeParam>::store(values, down);
    const NativePack below = RoundedDown<TypeParam>::load(down), above = RoundedUp<TypeParam>::load(up);
    for (int lane = 0; lane < NativePack::width; ++lane) {
      EXPECT_EQ(below[lane], static_cast<double>(down[lane]));
      EXPECT_EQ(above[lane], static_cast<double>(up[lane]));
      EXPECT_LE(below[lane], values[lane]);
      EXPECT_GE(below[lane], values[lane] < 1e-37 ? 0 : values[lane] * (1 - 0x1p-6)) << values[lane];
    }
  }
  for (const double exact : {0.0, infinity}) {
    RoundedDown<TypeParam>::store(NativePack(exact), down);
    EXPECT_EQ(static_cast<double>(down[0]), exact);
  }
  RoundedDown<TypeParam>::store(NativePack(notANumber), down);
  EXPECT_EQ(static_cast<double>(down[0]), 0);
}

}  // namespace
}  // namespace ringwatch
