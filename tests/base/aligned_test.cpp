// Arrays start on cache lines, large ones on huge pages, whatever their size.
#include <gtest/gtest.h>

#include <cstdint>
#include <numeric>

#include <ringwatch/base/aligned.h>

namespace ringwatch {
namespace {

constexpr std::size_t cacheLine = 64, hugePage = std::size_t{2} << 20;

bool startsOn(const void* memory, std::size_t border) { return reinterpret_cast<std::uintptr_t>(memory) % border == 0; }

TEST(AlignedVector, StartsOnACacheLineOrAHugePage) {
  for (const std::size_t bytes : {std::size_t{1}, std::size_t{100}, hugePage, 2 * hugePage - 1})
    EXPECT_TRUE(startsOn(AlignedVector<char>(bytes).data(), cacheLine)) << bytes;
  for (const std::size_t bytes : {2 * hugePage, 2 * hugePage + 1, 5 * hugePage + 12345})
    EXPECT_TRUE(startsOn(AlignedVector<char>(bytes).data(), hugePage)) << bytes;
}

TEST(AlignedVector, KeepsWhatItHoldsWhileItGrowsAndShrinksAcrossThatSize) {
  AlignedVector<std::int64_t> numbers;
  constexpr std::int64_t count = 1 << 20;
  for (std::int64_t i = 0; i < count; ++i) numbers.push_back(i);
  const AlignedVector<std::int64_t> copy = numbers;
  numbers.resize(1000);
  numbers.shrink_to_fit();
  EXPECT_EQ(std::accumulate(copy.begin(), copy.end(), std::int64_t{0}), count / 2 * (count - 1));
  EXPECT_EQ(numbers.back(), 999);
}

}  // namespace
}  // namespace ringwatch
