// Random numbers that are the same on every machine.
#include <gtest/gtest.h>

#include <cmath>

#include <ringwatch/base/random.h>

namespace ringwatch {
namespace {

TEST(Random, EntriesAreTheOutputsOfSplitMix64) {
  // The first outputs of the published generator (Vigna, splitmix64.c) from the seeds 0 and 1234567.
  const auto entryOf = [](std::uint64_t bits) { return static_cast<double>(bits >> 11) * 0x1p-52 - 1; };
  EXPECT_EQ(randomEntry(0, 0), entryOf(0xe220a8397b1dcdafULL));
  EXPECT_EQ(randomEntry(0, 1), entryOf(0x6e789e6aa1b965f4ULL));
  EXPECT_EQ(randomEntry(0, 2), entryOf(0x06c45d188009454fULL));
  EXPECT_EQ(randomEntry(1234567, 0), entryOf(6457827717110365317ULL));
  EXPECT_EQ(randomEntry(1234567, 1), entryOf(3203168211198807973ULL));
}

TEST(Random, NumbersHaveTheMomentsOfTheirDistributions) {
  constexpr int count = 200'000;
  Random random(3);
  double sums[3][4] = {};
  for (int i = 0; i < count; ++i) {
    const double values[3] = {random.uniform(-1, 1), random.normal(), randomEntry(5, static_cast<std::uint64_t>(i))};
    for (int kind = 0; kind < 3; ++kind)
      for (int power = 0; power < 4; ++power) sums[kind][power] += std::pow(values[kind], power + 1) / count;
  }
  const double expected[3][4] = {{0, 1.0 / 3, 0, 1.0 / 5}, {0, 1, 0, 3}, {0, 1.0 / 3, 0, 1.0 / 5}};
  // Four standard deviations of the mean of the fourth power of a normal number.
  const double tolerance = 4 * std::sqrt(96.0 / count);
  for (int kind = 0; kind < 3; ++kind)
    for (int power = 0; power < 4; ++power)
      EXPECT_NEAR(sums[kind][power], expected[kind][power], tolerance) << kind << ", power " << power + 1;
}

}  // namespace
}  // namespace ringwatch
