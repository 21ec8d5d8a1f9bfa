// With little to spend the bracket is wide, but what is proven unstable is still said in time.
#include <gtest/gtest.h>

#include <ringwatch/integrators/symplectic_euler.h>
#include <ringwatch/monitor/bounds/global_frequency.h>
#include <ringwatch/monitor/stability_monitor.h>
#include <ringwatch/verify/monitor/monitor_histories.h>

namespace ringwatch {
namespace {

/// Steps at which a run's step first lay above the exact critical one, and at which that was said; -1 for never.
struct Crossing {
  std::int64_t exactAt = -1, saidAt = -1;
};

Crossing follow(const detail::History& history, double budget) {
  constexpr double limit = 2;
  BodySystem system(history.body);
  State state = detail::gentleStart(system);
  SymplecticEuler integrator;
  MonitorOptions options;
  options.limit = limit;
  options.budget = budget;
  options.workInAdvance = 0;
  StabilityMonitor monitor(history.body, options);
  StepEvaluation evaluation;
  Crossing crossing;
  for (std::int64_t step = 0; step <= history.steps && crossing.saidAt < 0; ++step) {
    const MonitorReport& seen = monitor.observe(step, state.time, state.x, state.v, history.h, &evaluation);
    if (seen.verdict == Verdict::violated) crossing.saidAt = step;
    if (seen.verdict != Verdict::certified && crossing.exactAt < 0) {
      const GlobalFrequency top = globalFrequency(history.body, state.x, 1e-9);
      if (top.converged && limit / std::sqrt(top.lambda) < history.h) crossing.exactAt = step;
    }
    system.complete(state, evaluation);
    integrator.advance(system, state, history.h);
  }
  return crossing;
}

TEST(VerdictUnderABudget, ComesInTime) {
  // Steps. Measured: 0 and 1; of the ball, whose top mode moves from place to place, 0 to 23 with other gaps and
  // searches of BracketPolicy.
  constexpr std::int64_t late = 20;
  int tried = 0;
  for (const detail::History& history : detail::monitorHistories(StudyEffort::quick)) {
    if (history.indefinite) continue;
    for (const double budget : {0.1, 0.3}) {
      const Crossing crossing = follow(history, budget);
      ASSERT_GE(crossing.exactAt, 0) << history.name << ", " << budget;
      ASSERT_GE(crossing.saidAt, crossing.exactAt) << history.name << ", " << budget;
      EXPECT_LE(crossing.saidAt, crossing.exactAt + late) << history.name << ", " << budget;
      RecordProperty(history.name + std::to_string(budget), std::to_string(crossing.saidAt - crossing.exactAt));
      ++tried;
    }
  }
  EXPECT_GE(tried, 8);
}

}  // namespace
}  // namespace ringwatch
