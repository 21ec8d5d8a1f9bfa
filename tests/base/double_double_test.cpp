// Sums of two doubles against the compiler's 113-bit arithmetic, in plain numbers and in packs.
#include <gtest/gtest.h>

#include <ringwatch/base/double_double.h>
#include <ringwatch/base/matrix3.h>
#include <ringwatch/base/pack.h>
#include <tests/support/random.h>

namespace ringwatch {
namespace {

__extension__ typedef __float128 Quad;
using Wide = DoubleDouble<double>;
constexpr double unit = 0x1p-53;

Quad valueOf(const Wide& a) { return static_cast<Quad>(a.high) + static_cast<Quad>(a.low); }
double sizeOf(Quad a) { return static_cast<double>(a < 0 ? -a : a); }

TEST(DoubleDouble, KnowsTwiceAsManyDigits) {
  test::Random random(3);
  for (int i = 0; i < 10000; ++i) {
    const auto number = [&] {
      return Wide::sum(std::ldexp(random.uniform(-1, 1), random.index(60) - 30),
                       std::ldexp(random.uniform(-1, 1), random.index(60) - 90));
    };
    const Wide a = number(), b = number();
    const Quad x = valueOf(a), y = valueOf(b);
    EXPECT_LE(sizeOf(valueOf(a + b) - (x + y)), 8 * unit * unit * (sizeOf(x) + sizeOf(y)));
    EXPECT_LE(sizeOf(valueOf(a - b) - (x - y)), 8 * unit * unit * (sizeOf(x) + sizeOf(y)));
    EXPECT_LE(sizeOf(valueOf(a * b) - x * y), 8 * unit * unit * sizeOf(x * y));
    EXPECT_LE(sizeOf(valueOf(a / b) - x / y), 16 * unit * unit * sizeOf(x / y));
    EXPECT_EQ(a.rounded(), static_cast<double>(x));
    // Exactly.
    EXPECT_EQ(valueOf(Wide::sum(a.high, b.high)), static_cast<Quad>(a.high) + static_cast<Quad>(b.high));
    EXPECT_EQ(valueOf(Wide::product(a.high, b.high)), static_cast<Quad>(a.high) * static_cast<Quad>(b.high));
  }
}

TEST(DoubleDouble, GivesEveryLaneOfAPackWhatANumberGets) {
  test::Random random(4);
  Matrix3<DoubleDouble<NativePack>> packs;
  Matrix3<Wide> numbers[NativePack::width];
  for (int i = 0; i < 9; ++i)
    for (int lane = 0; lane < NativePack::width; ++lane) {
      const Wide number = Wide::sum(random.uniform(-1, 1), 1e-17 * random.uniform(-1, 1));
      numbers[lane].m[i] = number;
      packs.m[i].high.set(lane, number.high);
      packs.m[i].low.set(lane, number.low);
    }
  const auto inverses = inverse(packs);
  for (int lane = 0; lane < NativePack::width; ++lane) {
    const Matrix3<Wide> own = inverse(numbers[lane]);
    for (int i = 0; i < 9; ++i) {
      EXPECT_EQ(inverses.m[i].high[lane], own.m[i].high);
      EXPECT_NEAR(inverses.m[i].low[lane], own.m[i].low, 1e-30 * std::abs(own.m[i].high));
    }
  }
}

TEST(DoubleDouble, InvertsWhatCancelsInSinglePrecision) {
  // The determinant is 2^-60, of products of size one.
  const double t = 0x1p-30;
  const Matrix3<double> plain{{1 + t, 1, 0, 1, 1 - t, 0, 0, 0, 1}};
  Matrix3<Wide> wide;
  for (int i = 0; i < 9; ++i) wide.m[i] = Wide(plain.m[i]);
  EXPECT_EQ(determinant(wide).rounded(), -0x1p-60);
  EXPECT_EQ(inverse(wide).m[0].rounded(), -(1 - t) * 0x1p60);
}

}  // namespace
}  // namespace ringwatch
