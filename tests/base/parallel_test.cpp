// parallelFor, aligned memory, lists of types, nearest names and error texts.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <new>
#include <string>
#include <vector>

#include <ringwatch/base/error.h>
#include <ringwatch/base/nearest_name.h>
#include <ringwatch/base/parallel.h>
#include <ringwatch/base/type_list.h>
#include <ringwatch/base/user_text.h>

namespace ringwatch {
namespace {

TEST(ParallelFor, CallsEveryIndexOnceForAnyNumberOfThreads) {
  for (const int threads : {0, 1, 2, 3, 7})
    for (const std::int64_t count : {0, 1, 2, 5, 1000}) {
      std::vector<std::atomic<int>> calls(count);
      parallelFor(10, 10 + count, threads, [&](std::int64_t i) { ++calls[i - 10]; });
      for (std::int64_t i = 0; i < count; ++i)
        EXPECT_EQ(calls[i], 1) << threads << " threads, index " << i << " of " << count;
    }
}

TEST(ParallelFor, DoesNothingForAnEmptyRange) {
  parallelFor(5, 5, 2, [](std::int64_t) { FAIL(); });
  parallelFor(5, 3, 2, [](std::int64_t) { FAIL(); });
}

TEST(ParallelParts, CoverEveryIndexOnceWithNoShortPart) {
  for (const int threads : {0, 1, 2, 3, 7})
    for (const std::int64_t count : {0, 1, 5, 99, 1000}) {
      constexpr std::int64_t grain = 100;
      std::vector<std::atomic<int>> calls(count);
      parallelParts(count, threads, grain, [&](std::int64_t begin, std::int64_t end) {
        EXPECT_GE(end - begin, std::min(count, grain));
        for (std::int64_t i = begin; i < end; ++i) ++calls[i];
      });
      for (std::int64_t i = 0; i < count; ++i) EXPECT_EQ(calls[i], 1) << i << " of " << count;
    }
}

TEST(ParallelSum, HasTheSameBitsForAnyNumberOfThreads) {
  const auto sum = [](std::int64_t count, int threads) {
    return parallelSum(count, threads, [](std::int64_t begin, std::int64_t end) {
      double part = 0;
      for (std::int64_t i = begin; i < end; ++i) part += 1 / (1.0 + static_cast<double>(i));
      return part;
    });
  };
  EXPECT_EQ(sum(0, 4), 0);
  EXPECT_EQ(sum(1, 4), 1);
  const double alone = sum(100'000, 1);
  // H_n = ln n + gamma + 1/(2n) - …
  EXPECT_NEAR(alone, std::log(1e5) + 0.57721566490153286 + 0.5e-5, 1e-11);
  for (const int threads : {0, 2, 3, 7}) EXPECT_EQ(sum(100'000, threads), alone) << threads;
}

TEST(ParallelFor, ThrowsTheExceptionOfTheLowestIndexForAnyNumberOfThreads) {
  for (const int threads : {1, 2, 3, 7})
    for (const std::int64_t first : {0, 17, 99}) {
      std::string told;
      try {
        parallelFor(0, 100, threads, [&](std::int64_t i) {
          if (i >= first) throw InputError(joinText("index ", i));
        });
      } catch (const InputError& fault) {
        told = fault.what();
      }
      EXPECT_EQ(told, joinText("index ", first)) << threads;
      EXPECT_THROW(parallelSum(4096, threads, [&](std::int64_t, std::int64_t) -> double { throw std::bad_alloc(); }),
                   std::bad_alloc);
      EXPECT_THROW(parallelParts(100, threads, 1, [](std::int64_t, std::int64_t) { throw std::bad_alloc(); }),
                   std::bad_alloc);
    }
}

TEST(ParallelFor, ThreadCountTakesTheRequestOrAll) {
  EXPECT_EQ(threadCount(3), 3);
  EXPECT_GE(threadCount(0), 1);
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
  EXPECT_EQ(nearestName("", names), "");
  EXPECT_EQ(nearestName("x", std::vector<std::string>{}), "");
}

TEST(NearestName, SaysNothingWhereNothingIsNear) {
  const std::vector<std::string> integrators{"verlet", "rk4", "pefrl", "implicit-euler"};
  for (const char* word : {"bathe", "q", "verlet-with-a-tail-that-nobody-means"})
    EXPECT_EQ(nearestName(word, integrators), "") << word;
  EXPECT_EQ(nearestName("rk5", integrators), "rk4");
  EXPECT_EQ(nearestName("implict-eular", integrators), "implicit-euler");
  EXPECT_EQ(nearestName("y", std::vector<std::string>{"x"}), "") << "no letter in common";
  EXPECT_EQ(nearestName(std::string(1000000, 'x'), integrators), "");
  EXPECT_EQ(didYouMean("verlett", integrators), "did you mean \"verlet\"? ");
  EXPECT_EQ(didYouMean("bathe", integrators), "");
}

TEST(UserText, IsShortenedBetweenCharacters) {
  EXPECT_EQ(shortened("young"), "young");
  EXPECT_EQ(shortened("a\nb\tc\x7f"), "a?b?c?");
  EXPECT_EQ(shortened(std::string(longestUserText, 'x')), std::string(longestUserText, 'x'));
  EXPECT_EQ(shortened(std::string(100000, 'x')), std::string(longestUserText, 'x') + "…");
  std::string umlauts;
  for (int i = 0; i < 100; ++i) umlauts += "ü";
  EXPECT_EQ(shortened("a" + umlauts), "a" + umlauts.substr(0, longestUserText - 2) + "…");
  EXPECT_EQ(inQuotes("x"), "\"x\"");
  EXPECT_EQ(shortList(std::vector<std::string>{"a", "b"}), "a, b");
  const std::vector<std::string> many(longestUserList + 3, "a");
  EXPECT_TRUE(shortList(many).ends_with("a, a and 3 more"));
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
