#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ringwatch/base/error.h>
#include <ringwatch/base/name_table.h>

namespace ringwatch {
namespace {

enum class Colour { red, darkGreen, blue, none };
constexpr auto colours = nameTable<Colour>({
    {Colour::red, "red", "as blood"},
    {Colour::darkGreen, "dark-green", "as a wood", "green"},
    {Colour::blue, "blue"},
});

TEST(NameTable, FindsNamesOfValuesAndValuesOfNames) {
  static_assert(colours.nameOf(Colour::darkGreen) == "dark-green");
  EXPECT_EQ(colours.nameOf(Colour::none), "");
  for (const auto& colour : colours) EXPECT_EQ(colours.valueOf("colour", colour.name), colour.value);
  EXPECT_EQ(colours.valueOf("colour", "green"), Colour::darkGreen);
  EXPECT_EQ(colours.find(""), nullptr);
  EXPECT_THAT(colours.names(), ::testing::ElementsAre("red", "dark-green", "blue"));
  EXPECT_EQ(colours.listing(), "red: as blood; dark-green: as a wood; blue");
}

TEST(NameTable, ListsTheNamesWhereThereIsNone) {
  try {
    colours.valueOf("scene.toml:3: wall.colour", "bleu");
    ADD_FAILURE();
  } catch (const InputError& fault) {
    EXPECT_STREQ(fault.what(),
                 "scene.toml:3: wall.colour: unknown \"bleu\"; did you mean \"blue\"? must be one of red, dark-green, "
                 "blue");
  }
}

}  // namespace
}  // namespace ringwatch
