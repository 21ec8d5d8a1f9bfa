// A monitor that goes on from the bytes of another one says what that one would have said, to the last bit.
#include <gtest/gtest.h>

#include <cmath>

#include <ringwatch/base/error.h>
#include <ringwatch/monitor/stability_monitor.h>
#include <tests/monitor/monitor_cases.h>

namespace ringwatch {
namespace {

struct SavedCase {
  const char* name;
  MonitorOptions options;
  double h;  // over the safe step at rest
};

std::vector<SavedCase> savedCases() {
  std::vector<SavedCase> cases{
      {"bracket", {}, 0.9},       {"threshold", {}, 0.6}, {"threshold, not certified", {}, 1.05},
      {"little budget", {}, 0.9}, {"metric", {}, 0.8},    {"every third", {}, 1.2}};
  cases[1].options.mode = cases[2].options.mode = MonitorMode::threshold;
  cases[3].options.budget = 0.05;
  cases[3].options.workInAdvance = 0;
  cases[4].options.mode = MonitorMode::metric;
  cases[4].options.metric = "reduced-1-ring";
  cases[5].options.every = 3;
  cases[5].options.metric = "fried";
  return cases;
}

Body savedBar(int cells, int threads) {
  BarOptions options;
  options.cells = {cells, 2, 2};
  options.size = {0.01 * cells, 0.02, 0.02};
  options.jitter = 0.2;
  Body body(generateBar(options), makeMaterial("stvk", 30e3, 0.3, 1000), test::onThreads(threads));
  for (std::int32_t i = 0; i < body.nodeCount(); ++i)
    if (body.mesh().X(0, i) < 1e-9) body.constraints().fix(i);
  return body;
}

/// The bar stretched more and more, compressed again, while a wave runs along it; nothing of it repeats.
NodeVectors waved(const NodeVectors& X, int k) {
  NodeVectors x = X;
  x.row(0) *= 1 + 0.5 * std::sin(0.06 * k);
  for (Eigen::Index i = 0; i < x.cols(); ++i) x(1, i) += 2e-3 * std::sin(60 * X(0, i) - 0.5 * k);
  return x;
}

void expectSame(const MonitorReport& a, const MonitorReport& b) {
  EXPECT_EQ(a.fresh, b.fresh);
  EXPECT_EQ(a.evaluatedAt, b.evaluatedAt);
  EXPECT_EQ(a.certified, b.certified);
  EXPECT_EQ(a.verdict, b.verdict);
  EXPECT_EQ(a.elementsRefreshed, b.elementsRefreshed);
  EXPECT_EQ(a.spent.of, b.spent.of);
  EXPECT_EQ(a.metricStep, b.metricStep);
  EXPECT_EQ(a.newEvents.size(), b.newEvents.size());
  ASSERT_EQ(a.bracket.has_value(), b.bracket.has_value());
  if (!a.bracket) return;
  EXPECT_EQ(a.bracket->safe, b.bracket->safe);
  EXPECT_EQ(a.bracket->optimistic, b.bracket->optimistic);
  EXPECT_EQ(a.bracket->controlling, b.bracket->controlling);
  EXPECT_EQ(a.bracket->safeBy, b.bracket->safeBy);
  EXPECT_EQ(a.bracket->optimisticBy, b.bracket->optimisticBy);
  EXPECT_EQ(a.bracket->lowestRing, b.bracket->lowestRing);
}

TEST(SavedMonitor, GoesOnWithTheSameBits) {
  bool events = false;
  for (const SavedCase& c : savedCases()) {
    SCOPED_TRACE(c.name);
    const Body body = savedBar(8, 1), again = savedBar(8, 2);
    const NodeVectors &X = body.mesh().X, v = NodeVectors::Zero(3, body.nodeCount());
    const double h = c.h * criticalStep(body, X, c.options.limit).safe;
    StabilityMonitor whole(body, c.options);
    bool evaluated = false;
    for (int k = 0; k < 120; ++k) {
      // Of a few steps on either side of whatever may begin there.
      if (k % 7 == 3) {
        const std::string bytes = whole.save();
        StabilityMonitor other(again, c.options), twin(body, c.options);
        other.load(bytes);
        twin.load(bytes);
        EXPECT_EQ(twin.save(), bytes);
        for (int later = k; later < k + 25; ++later) {
          SCOPED_TRACE(later);
          const NodeVectors x = waved(X, later);
          expectSame(twin.observe(later, h * later, x, v, h), other.observe(later, h * later, x, v, h));
        }
        // And the one that is saved goes on as if nothing had been.
        StabilityMonitor next(again, c.options);
        next.load(bytes);
        expectSame(whole.observe(k, h * k, waved(X, k), v, h), next.observe(k, h * k, waved(X, k), v, h));
        EXPECT_EQ(whole.events().size(), next.events().size());
      } else {
        evaluated = whole.observe(k, h * k, waved(X, k), v, h).elementsRefreshed > 0 || evaluated;
      }
      evaluated = evaluated || whole.observe(k, h * k, waved(X, k), v, h).elementsRefreshed > 0;
      events = events || !whole.events().empty();
      if (::testing::Test::HasFailure()) return;
    }
    EXPECT_TRUE(evaluated);
  }
  EXPECT_TRUE(events);
}

TEST(SavedMonitor, RefusesWhatIsNotItsOwn) {
  const Body body = savedBar(8, 1), longer = savedBar(9, 1);
  const NodeVectors v = NodeVectors::Zero(3, body.nodeCount());
  StabilityMonitor monitor(body, {});
  monitor.observe(0, 0, body.mesh().X, v, 1e-4);
  const std::string bytes = monitor.save();
  MonitorOptions threshold;
  threshold.mode = MonitorMode::threshold;
  EXPECT_THROW(StabilityMonitor(longer, {}).load(bytes), InputError);
  EXPECT_THROW(StabilityMonitor(body, threshold).load(bytes), InputError);
  for (const double share : {0.0, 0.3, 0.7, 0.9999})
    EXPECT_THROW(StabilityMonitor(body, {}).load(std::string_view(bytes).substr(
                     0, static_cast<std::size_t>(share * static_cast<double>(bytes.size())))),
                 InputError);
  EXPECT_THROW(StabilityMonitor(body, {}).load(bytes + "x"), InputError);
  for (std::size_t place = 0; place < bytes.size(); place += bytes.size() / 50) {
    std::string damaged = bytes;
    damaged[place] ^= static_cast<char>(1 << place % 8);
    EXPECT_THROW(StabilityMonitor(body, {}).load(damaged), InputError) << place;
  }
  StabilityMonitor(body, {}).load(bytes);
}

}  // namespace
}  // namespace ringwatch
