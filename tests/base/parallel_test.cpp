// parallelFor, aligned memory, lists of types, nearest names and error texts.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

#include <ringwatch/base/aligned.h>
#include <ringwatch/base/error.h>
#include <ringwatch/base/nearest_name.h>
#include <ringwatch/base/parallel.h>
#include <ringwatch/base/type_list.h>

namespace ringwatch {
namespace {

TEST(ParallelFor, CallsEveryIndexOnceForAnyNumberOfThreads) {
  for (const int threads : {0, 1, 2, 3, 7})
    for (const std::int64_t count : {0, 1, 2, 5, 1000}) {
      std::vector<std::atomic<int>> calls(static_cast<std::size_t>(count));
      parallelFor(10, 10 + count, threads, [&](std::int64_t i) { ++calls[static_cast<std::size_t>(i - 10)]; });
      for (std::int64_t i = 0; i < count; ++i)
        EXPECT_EQ(calls[static_cast<std::size_t>(i)], 1) << threads << " threads, index " << i << " of " << count;
    }
}

TEST(ParallelFor, DoesNothingForAnEmptyRange) {
  parallelFor(5, 5, 2, [](std::int64_t) { FAIL(); });
  parallelFor(5, 3, 2, [](std::int64_t) { FAIL(); });
}

TEST(ParallelFor, ThreadCountTakesTheRequestOrAll) {
  EXPECT_EQ(threadCount(3), 3);
  EXPECT_GE(threadCount(0), 1);
}

TEST(AlignedVector, StartsOnACacheLine) {
  for (std::size_t size : {1u, 3u, 100u}) {
    const AlignedVector<double> v(size);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(v.data()) % 64, 0u);
  }
}

TEST(TypeList, IsVisitedInOrder) {
  std::string sizes;
  forEachType(TypeList<char, std::int16_t, std::int32_t>{},
              [&](auto tag) { sizes += std::to_string(sizeof(typename decltype(tag)::type)); });
  EXPECT_EQ(sizes, "124");
}

TEST(NearestName, FindsWhatWasProbablyMeant) {
  const std::vector<std::string> names{"young", "poisson", "density"};
  EXPECT_EQ(nearestName("yuong", names), "young");
  EXPECT_EQ(nearestName("denisty", names), "density");
  EXPECT_EQ(nearestName("", names), "young");
  EXPECT_EQ(nearestName("x", std::vector<std::string>{}), "");
}

TEST(NearestName, CountsEdits) {
  EXPECT_EQ(editDistance("", "abc"), 3u);
  EXPECT_EQ(editDistance("abc", "abc"), 0u);
  EXPECT_EQ(editDistance("abc", "acb"), 1u);  // neighbours swapped
  EXPECT_EQ(editDistance("kitten", "sitting"), 3u);
}

TEST(JoinText, KeepsNineDigits) {
  EXPECT_EQ(joinText("h = ", 1.23456789012, " s, step ", 7), "h = 1.23456789 s, step 7");
}

}  // namespace
}  // namespace ringwatch
