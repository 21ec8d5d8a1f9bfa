#include <ringwatch/app/scene/where_expression.h>

#include <random>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <ringwatch/base/error.h>

namespace ringwatch {
namespace {

using ::testing::HasSubstr;

bool holds(const std::string& text, double x, double y = 0, double z = 0) {
  return WhereExpression(text).holdsAt({x, y, z});
}

std::string faultOfExpression(const std::string& text) {
  try {
    const WhereExpression parsed(text);
  } catch (const InputError& fault) {
    return fault.what();
  }
  return "no fault";
}

TEST(WhereExpression, ComparesCoordinates) {
  EXPECT_TRUE(holds("x < 1e-6", 0));
  EXPECT_FALSE(holds("x < 1e-6", 0.1));
  EXPECT_TRUE(holds("x > 0.2 - 1e-6", 0.2));
  EXPECT_TRUE(holds("y >= 2", 0, 2));
  EXPECT_TRUE(holds("z <= -1", 0, 0, -1));
  EXPECT_TRUE(holds("x == 0.5", 0.5));
  EXPECT_TRUE(holds("x != 0.5", 0.25));
}

TEST(WhereExpression, KnowsArithmeticAndItsOrder) {
  EXPECT_TRUE(holds("1 + 2 * 3 == 7", 0));
  EXPECT_TRUE(holds("(1 + 2) * 3 == 9", 0));
  EXPECT_TRUE(holds("8 / 4 / 2 == 1", 0));
  EXPECT_TRUE(holds("5 - 2 - 1 == 2", 0));
  EXPECT_TRUE(holds("-2 ^ 2 == -4", 0));
  EXPECT_TRUE(holds("2 ^ 3 ^ 2 == 512", 0));
  EXPECT_TRUE(holds("2 ^ -1 == 0.5", 0));
  EXPECT_TRUE(holds("- -x == x", 3));
  EXPECT_TRUE(holds("r == 5", 3, 4));
  EXPECT_TRUE(holds("sqrt(y^2 + z^2) < 0.3", 9, 0.1, 0.1));
  EXPECT_TRUE(holds("abs(x) == 2 and min(x, y, z) == -2 and max(x, y, z) == 7", -2, 7, 1));
  EXPECT_TRUE(holds("1.5e2 == 150", 0));
}

TEST(WhereExpression, KnowsLogicInWordsAndSigns) {
  EXPECT_TRUE(holds("x < 1 and y < 1", 0));
  EXPECT_TRUE(holds("x < 1 && !(y > 1)", 0));
  EXPECT_TRUE(holds("x > 1 || y < 1", 0));
  EXPECT_TRUE(holds("not x > 1 or x > 5", 0));
  EXPECT_TRUE(holds("x<0 or x<1and y<1", 0.5));  // and binds closer; a number may touch a word
  EXPECT_TRUE(holds("x < 1 or x < 2 and x < 0", 0.5));
  EXPECT_FALSE(holds("(x < 1 or x < 2) and x < 0", 0.5));
  EXPECT_TRUE(holds("all", 1));
  EXPECT_FALSE(holds("none", 1));
  EXPECT_TRUE(holds("not none", 1));
}

TEST(WhereExpression, ChainsComparisons) {
  EXPECT_TRUE(holds("0 < x < 1", 0.5));
  EXPECT_FALSE(holds("0 < x < 1", 2));
  EXPECT_FALSE(holds("0 < x < 1", -2));
  EXPECT_TRUE(holds("0 <= x <= y < z", 0, 1, 2));
}

TEST(WhereExpression, RefusesWhatWouldSilentlyMeanSomething) {
  EXPECT_THAT(faultOfExpression("x"), HasSubstr("number, not a condition"));
  EXPECT_THAT(faultOfExpression("x = 0"), HasSubstr("=="));
  EXPECT_THAT(faultOfExpression("(x < 1) + 1 > 0"), HasSubstr("a condition where a number is needed"));
  EXPECT_THAT(faultOfExpression("x and y < 1"), HasSubstr("a number where a condition is needed"));
  EXPECT_THAT(faultOfExpression("not x"), HasSubstr("a number where a condition is needed"));
  EXPECT_THAT(faultOfExpression("all < 1"), HasSubstr("a condition where a number is needed"));
  EXPECT_THAT(faultOfExpression("x < 0,1"), HasSubstr("column 6"));
  EXPECT_THAT(faultOfExpression("min(x) < 1"), HasSubstr("two numbers or more"));
}

TEST(WhereExpression, NamesColumnAndNearestWord) {
  EXPECT_THAT(faultOfExpression("x < "), HasSubstr("column 5: found the end"));
  EXPECT_THAT(faultOfExpression("x < 1 y"), HasSubstr("column 7: found \"y\""));
  EXPECT_THAT(faultOfExpression("(x < 1"), HasSubstr("expected \")\""));
  EXPECT_THAT(faultOfExpression("sqr(x) < 1"), HasSubstr("did you mean \"sqrt\"?"));
  EXPECT_THAT(faultOfExpression(""), HasSubstr("column 1: found the end"));
  EXPECT_THAT(faultOfExpression("x < 1e999"), HasSubstr("column 5"));
}

TEST(WhereExpression, HasNoValueWhereArithmeticHasNone) {
  EXPECT_THROW(holds("sqrt(x) < 1", -1), InputError);
  EXPECT_THROW(holds("not (0 / x < 1)", 0), InputError);
  EXPECT_THROW(holds("min(sqrt(x), 1) < 2", -1), InputError);
  EXPECT_TRUE(holds("1 / x > 5", 0));  // infinity is a value
}

TEST(WhereExpression, BoundsNesting) {
  EXPECT_THAT(faultOfExpression(std::string(1500, '(')), HasSubstr("nested"));
  EXPECT_THAT(faultOfExpression(std::string(1500, '-')), HasSubstr("nested"));
  EXPECT_THAT(faultOfExpression(std::string(1500, '!')), HasSubstr("nested"));
  EXPECT_THAT(faultOfExpression(std::string(5000, 'x')), HasSubstr("longer"));
  std::string sum = "x";
  while (sum.size() < 1990) sum += "+x";
  EXPECT_TRUE(holds(sum + ">0", 1));
}

RC_GTEST_PROP(WhereExpression, RandomBytesNeverCrash, (const std::string& text)) {
  try {
    WhereExpression(text).holdsAt({0.1, -0.2, 0.3});
  } catch (const InputError&) {
  }
}

// Random sequences of valid words get past the first error far more often than bytes do.
TEST(WhereExpression, RandomWordsNeverCrash) {
  const std::vector<std::string> words{"x", "y", "z",    "r",   "all", "none", "and", "or",  "not", "&&", "||", "!",
                                       "(", ")", "<",    "<=",  ">",   "==",   "!=",  "=",   "+",   "-",  "*",  "/",
                                       "^", ",", "sqrt", "abs", "min", "max",  "1",   "0.5", "1e3", "."};
  std::mt19937 engine(7);
  int accepted = 0;
  for (int i = 0; i < 20000; ++i) {
    std::string text;
    for (unsigned n = engine() % 9; n-- > 0;) text += words[engine() % words.size()] + " ";
    try {
      WhereExpression(text).holdsAt({0.1, -0.2, 0.3});
      ++accepted;
    } catch (const InputError&) {
    }
  }
  EXPECT_GT(accepted, 50);
}

}  // namespace
}  // namespace ringwatch
