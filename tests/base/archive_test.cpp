// Objects written as bytes and read back.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <ringwatch/base/archive.h>

namespace ringwatch {
namespace {

struct Part {
  std::vector<float> numbers;
  std::string_view name;

  template <class Archive>
  void archive(Archive& a) {
    a(numbers, name);
  }
};

struct Whole {
  double number = 0;
  std::vector<Part> parts;
  std::vector<bool> flags;
  std::vector<std::vector<int>> lists;
  std::optional<Part> maybe, none;
  std::string text;
  Eigen::Matrix<double, 3, Eigen::Dynamic> vectors;
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  Eigen::Quaternionf rotation = Eigen::Quaternionf::Identity();

  template <class Archive>
  void archive(Archive& a) {
    a(number, parts, flags, lists, maybe, none, text, vectors, matrix, rotation);
  }
};

Whole example() {
  static const std::string gone = "a name";
  Whole whole;
  whole.number = std::nextafter(0.1, 1);
  whole.parts = {{{1, 2, 3}, gone}, {{}, "other"}};
  whole.flags = {true, false, true};
  whole.lists = {{}, {1, 2}};
  whole.maybe = Part{{-0.0F}, ""};
  whole.text = std::string("with \0 in it", 12);
  whole.vectors = Eigen::Matrix<double, 3, Eigen::Dynamic>::Random(3, 5);
  whole.matrix(0, 2) = 4;
  whole.rotation = Eigen::Quaternionf(0.5F, 0.5F, -0.5F, 0.5F);
  return whole;
}

std::string bytesOf(Whole& whole) {
  SavingArchive archive;
  archive(whole);
  return archive.take();
}

TEST(Archive, GivesBackWhatItWasGiven) {
  Whole first = example();
  const std::string bytes = bytesOf(first);
  Whole second;
  second.none.emplace();
  second.text = "old";
  LoadingArchive archive(bytes);
  archive(second);
  archive.end();
  EXPECT_EQ(second.number, first.number);
  ASSERT_EQ(second.parts.size(), 2u);
  EXPECT_EQ(second.parts[0].numbers, first.parts[0].numbers);
  EXPECT_EQ(second.parts[0].name, "a name");
  EXPECT_NE(second.parts[0].name.data(), first.parts[0].name.data());
  EXPECT_EQ(second.flags, first.flags);
  EXPECT_EQ(second.lists, first.lists);
  ASSERT_TRUE(second.maybe);
  EXPECT_TRUE(std::signbit(second.maybe->numbers.at(0)));
  EXPECT_FALSE(second.none);
  EXPECT_EQ(second.text, first.text);
  EXPECT_EQ(second.vectors, first.vectors);
  EXPECT_EQ(second.matrix, first.matrix);
  EXPECT_EQ(second.rotation.coeffs(), first.rotation.coeffs());
  EXPECT_EQ(bytesOf(second), bytes);
}

TEST(Archive, RefusesBytesThatEndEarlyOrLate) {
  Whole whole = example();
  const std::string bytes = bytesOf(whole);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    Whole other;
    LoadingArchive archive(std::string_view(bytes).substr(0, size));
    EXPECT_THROW(archive(other), InputError) << size;
  }
  const std::string more = bytes + "x";
  Whole other;
  LoadingArchive archive(more);
  archive(other);
  EXPECT_THROW(archive.end(), InputError);
}

}  // namespace
}  // namespace ringwatch
