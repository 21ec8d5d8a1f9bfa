#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <functional>

#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/base/options.h>

namespace ringwatch {
namespace {

constexpr std::array<std::string_view, 2> shapes{"round", "square"};
constexpr std::array<std::string_view, 1> squareAlone{"square"};
constexpr std::array table{
    OptionInfo{.name = "width", .unit = "m", .range = NumberRange::positive(), .help = "how wide"},
    OptionInfo{.name = "count", .type = OptionType::integer, .range = {1, 12, true, true}, .fallback = "6"},
    OptionInfo{.name = "passes", .type = OptionType::integer, .range = {1, infinity, true, true}, .fallback = "1"},
    OptionInfo{.name = "shape", .type = OptionType::text, .choices = shapes, .automatic = true, .fallback = "auto"},
    OptionInfo{.name = "tolerance", .range = {0, 1, false, true}, .automatic = true, .fallback = "auto"},
    OptionInfo{.name = "corner", .fallback = "0.5", .onlyWith = {"shape", squareAlone}},
};

std::string refusal(const Options& given) {
  try {
    completed("wall", table, given);
  } catch (const InputError& fault) {
    return fault.what();
  }
  return "";
}

TEST(Options, AreFilledInFromTheirTable) {
  const Options options = completed("wall", table, {{"width", 2}});
  EXPECT_EQ(options.number("width"), 2);
  EXPECT_EQ(options.integer("count"), 6);
  EXPECT_EQ(options.text("shape"), "round");
  EXPECT_TRUE(options.automatic("tolerance"));
  EXPECT_EQ(completed("wall", table, {{"width", 2}, {"tolerance", 0.25}}).number("tolerance"), 0.25);
  EXPECT_EQ(completed("wall", table, {{"width", 2}, {"shape", "square"}, {"corner", 1}}).number("corner"), 1);
}

TEST(Options, AreRefusedWithWhatWouldBeRight) {
  EXPECT_EQ(refusal({{"width", -1}}), "wall: width -1: must be > 0");
  EXPECT_EQ(refusal({{"width", std::numeric_limits<double>::quiet_NaN()}}),
            "wall: width nan: must be a finite number > 0");
  EXPECT_EQ(refusal({}), "wall: width: missing; must be > 0 m");
  EXPECT_EQ(refusal({{"width", "wide"}}), "wall: width \"wide\": is a text where a number is needed");
  EXPECT_EQ(refusal({{"width", 1}, {"count", 13}}), "wall: count 13: must be >= 1 and <= 12");
  EXPECT_EQ(refusal({{"width", 1}, {"count", 1.5}}), "wall: count 1.5: must be an integer");
  EXPECT_EQ(findOption(table, "passes")->range.text(), ">= 1");
  EXPECT_EQ(refusal({{"width", 1}, {"passes", 2147483648.0}}),
            "wall: passes 2.14748365e+09: must be an integer from -2147483648 to 2147483647");
  EXPECT_EQ(refusal({{"width", 1}, {"shape", "oval"}}), "wall: shape \"oval\": must be one of round, square");
  EXPECT_EQ(refusal({{"width", 1}, {"shape", 1}}), "wall: shape 1: is a number where a text is needed");
  EXPECT_EQ(refusal({{"width", 1}, {"corner", 1}}), "wall: corner 1: goes with shape square, not with \"round\"");
  EXPECT_THAT(refusal({{"widht", 1}}), ::testing::HasSubstr("did you mean \"width\"?"));
}

}  // namespace
}  // namespace ringwatch
