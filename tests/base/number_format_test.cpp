#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <ringwatch/base/error.h>
#include <ringwatch/base/number_format.h>
#include <tests/support/comma_locale.h>

namespace ringwatch {
namespace {

TEST(NumberFormat, ReadsWholeTextsAlone) {
  EXPECT_EQ(readNumber("1.5"), 1.5);
  EXPECT_EQ(readNumber("-2.5e-3"), -2.5e-3);
  EXPECT_EQ(readNumber("+7"), 7);
  EXPECT_EQ(readNumber("1.5e-400"), 0);
  EXPECT_EQ(readNumber("1.5e400"), INFINITY);
  for (const char* text : {"", "1,5", "1.5x", "x", "1.5 ", " 1.5"}) EXPECT_FALSE(readNumber(text)) << text;
}

RC_GTEST_PROP(NumberFormat, IsThatOfPrintfInEveryLocale, (double number)) {
  char general[400], hexadecimal[40];
  std::snprintf(general, sizeof general, "%.9g", number);
  std::snprintf(hexadecimal, sizeof hexadecimal, "%a", number);
  const test::CommaLocale comma;
  RC_ASSERT(digitsOf(number, 9) == general);
  RC_ASSERT(joinText(number) == general);
  RC_ASSERT(hexadecimalOf(number) == hexadecimal);
  RC_ASSERT(readNumber(hexadecimal) == number);
}

}  // namespace
}  // namespace ringwatch
