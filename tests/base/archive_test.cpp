// Objects written as bytes and read back.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <new>
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

/// Has padding, and an optional whose value may not be there.
struct Padded {
  bool first = true;
  double second = 2;
  std::int16_t third = 3;
  std::optional<std::array<int, 3>> fourth = {};
};

struct Whole {
  double number = 0;
  std::vector<Part> parts;
  std::vector<bool> flags;
  std::vector<std::vector<int>> lists;
  std::optional<Part> maybe, none;
  std::vector<Padded> padded;
  std::string text;
  Eigen::Matrix<double, 3, Eigen::Dynamic> vectors;
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  Eigen::Quaternionf rotation = Eigen::Quaternionf::Identity();

  template <class Archive>
  void archive(Archive& a) {
    a(number, parts, flags, lists, maybe, none, padded, text, vectors, matrix, rotation);
  }
};

Whole example() {
  static const std::string gone = "a name";
  Whole whole;
  whole.number = std::nextafter(0.1, 1);
  whole.parts = {{{1, 2, 3}, gone}, {{}, "other"}};
  whole.flags = {true, false, true};
  whole.lists = {{}, {1, 2}};
  whole.padded = {{}, {false, -1, 7, {{1, 2, 3}}}};
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
  ASSERT_EQ(second.padded.size(), 2u);
  EXPECT_FALSE(second.padded[0].fourth);
  EXPECT_EQ(second.padded[1].third, 7);
  EXPECT_EQ(second.padded[1].fourth, first.padded[1].fourth);
  EXPECT_EQ(second.text, first.text);
  EXPECT_EQ(second.vectors, first.vectors);
  EXPECT_EQ(second.matrix, first.matrix);
  EXPECT_EQ(second.rotation.coeffs(), first.rotation.coeffs());
  EXPECT_EQ(bytesOf(second), bytes);
}

/// An object in memory that held `before`.
std::string bytesOver(unsigned char before) {
  alignas(Padded) unsigned char memory[sizeof(Padded)];
  std::memset(memory, before, sizeof memory);
  auto* padded = new (memory) Padded;
  SavingArchive archive;
  archive(*padded);
  return archive.take();
}

TEST(Archive, GivesBytesThatDoNotDependOnWhatWasInMemory) {
  EXPECT_EQ(bytesOver(0x00), bytesOver(0xff));
  // A flag, a double, a short and whether there is an optional.
  EXPECT_EQ(bytesOver(0).size(), 1u + 8 + 2 + 1);
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

TEST(Archive, RefusesSizesThatNoMatrixHas) {
  constexpr std::int64_t huge = std::int64_t{1} << 61;  // of doubles: 0 bytes, counted in 64 bits
  for (const auto& [rows, columns] : {std::pair{huge, std::int64_t{1}},
                                      {std::int64_t{1}, huge},
                                      {huge, huge},
                                      {std::int64_t{-1}, std::int64_t{1}},
                                      {std::int64_t{1}, std::int64_t{-1}}}) {
    SavingArchive saving;
    std::int64_t sizes[] = {rows, columns};
    saving(sizes);
    const std::string bytes = saving.take() + std::string(64, 'x');
    LoadingArchive archive(bytes);
    Eigen::MatrixXd matrix;
    EXPECT_THROW(archive(matrix), InputError) << rows << " " << columns;
  }
  SavingArchive saving;
  Eigen::MatrixXd wide = Eigen::MatrixXd::Zero(4, 2);
  saving(wide);
  const std::string bytes = saving.take();
  Eigen::Matrix3Xd three;  // has three rows
  LoadingArchive archive(bytes);
  EXPECT_THROW(archive(three), InputError);
}

}  // namespace
}  // namespace ringwatch
