#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <ringwatch/base/exact_sum.h>
#include <ringwatch/base/random.h>

namespace ringwatch {
namespace {

double sumOf(const std::vector<double>& terms) {
  ExactSum sum;
  for (const double term : terms) sum.add(term);
  return sum.value();
}

TEST(ExactSum, RoundsOnce) {
  EXPECT_EQ(sumOf({}), 0);
  EXPECT_EQ(sumOf({1e308, 1, -1e308}), 1);
  EXPECT_EQ(sumOf({-1e308, -5e-324, 1e308}), -5e-324);
  EXPECT_EQ(sumOf({0x1p53, 1}), 0x1p53);                 // a tie, to even
  EXPECT_EQ(sumOf({0x1p53, 1, 0x1p-1000}), 0x1p53 + 2);  // and what breaks it
  EXPECT_EQ(sumOf({0x1p53, 3}), 0x1p53 + 4);
  EXPECT_EQ(sumOf({-0x1p53, -1, 0x1p-1000}), -0x1p53);
  EXPECT_EQ(sumOf({1.7976931348623157e308, 1.7976931348623157e308}), HUGE_VAL);
  EXPECT_TRUE(std::isnan(sumOf({1, HUGE_VAL})));
}

/// Of products of small integers and powers of two, whose sums plain integers know.
TEST(ExactSum, AgreesWithIntegers) {
  Random random(3);
  for (int trial = 0; trial < 2000; ++trial) {
    std::int64_t whole = 0;
    std::vector<double> terms;
    const int scale = random.index(1900) - 1000;
    for (int i = 0; i < 40; ++i) {
      const std::int64_t number = static_cast<std::int64_t>(random.uniform(-1, 1) * 0x1p45) * (1 + random.index(60));
      whole += number;
      terms.push_back(std::ldexp(static_cast<double>(number), scale));
    }
    EXPECT_EQ(sumOf(terms), std::ldexp(static_cast<double>(whole), scale)) << trial;
  }
}

TEST(ExactSum, KnowsNoOrderAndNoParts) {
  Random random(5);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<double> terms;
    for (int i = 0; i < 500; ++i) terms.push_back(random.normal() * std::pow(10.0, random.uniform(-200, 200)));
    const double whole = sumOf(terms);
    std::reverse(terms.begin(), terms.end());
    ExactSum parts[5], all;
    ExactSum::Digits digits{};
    for (const double term : terms) parts[random.index(5)].add(term);
    for (ExactSum& part : parts)
      for (std::size_t i = 0; i < digits.size(); ++i) digits[i] += part.digits()[i];
    all.addDigits(digits.data(), 0);
    EXPECT_EQ(all.value(), whole);
  }
}

}  // namespace
}  // namespace ringwatch
