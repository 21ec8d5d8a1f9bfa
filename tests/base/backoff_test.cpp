// Gaps between tries grow while they do not help.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include <ringwatch/base/backoff.h>

namespace ringwatch {
namespace {

/// Ticks at which a try was due, of `ticks`; those with the given numbers help.
std::vector<int> tries(Backoff& backoff, int ticks, const std::vector<int>& helpful) {
  std::vector<int> result;
  for (int tick = 1; tick <= ticks; ++tick) {
    backoff.tick();
    if (!backoff.due()) continue;
    const bool helped = std::find(helpful.begin(), helpful.end(), static_cast<int>(result.size())) != helpful.end();
    result.push_back(tick);
    backoff.tried(helped);
  }
  return result;
}

TEST(Backoff, TriesAtOnceThenMoreAndMoreSeldom) {
  Backoff backoff({.first = 2, .last = 10, .factor = 2});
  EXPECT_EQ(tries(backoff, 40, {}), (std::vector<int>{1, 5, 13, 23, 33}));
}

TEST(Backoff, BeginsAgainAfterATryThatHelped) {
  Backoff backoff({.first = 2, .last = 100, .factor = 4});
  // The second try helps: the gaps are 8, 2, 8.
  EXPECT_EQ(tries(backoff, 19, {1}), (std::vector<int>{1, 9, 11, 19}));
}

TEST(Backoff, WaitsAtLeastAsLongAsItIsTold) {
  Backoff backoff({.first = 2, .last = 8, .factor = 2});
  backoff.tried(true);
  for (int tick = 0; tick < 5; ++tick) backoff.tick();
  EXPECT_TRUE(backoff.due());
  EXPECT_TRUE(backoff.due(5));
  EXPECT_FALSE(backoff.due(6));
  EXPECT_EQ(backoff.since(), 5);
}

TEST(Backoff, RestartsWithTheSameGapAndResetsToTheFirst) {
  Backoff backoff({.first = 2, .last = 8, .factor = 2});
  backoff.tried(false);  // the gap is 4
  for (int tick = 0; tick < 3; ++tick) backoff.tick();
  backoff.restart();
  for (int tick = 0; tick < 3; ++tick) backoff.tick();
  EXPECT_FALSE(backoff.due());
  backoff.tick();
  EXPECT_TRUE(backoff.due());
  backoff.restart();
  EXPECT_FALSE(backoff.due());
  backoff.reset();
  EXPECT_TRUE(backoff.due());
  backoff.tried(true);
  backoff.tick();
  backoff.tick();
  EXPECT_TRUE(backoff.due());
}

}  // namespace
}  // namespace ringwatch
