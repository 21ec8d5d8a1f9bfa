// Elements are proven in ball arithmetic along the histories of `ringwatch verify monitor`.
//   RINGWATCH_HISTORY_CHECKS=N   the full histories, some N elements in all (by default short ones)
//   RINGWATCH_HISTORY=NAME       only this one, so that processes side by side take one each
#include <cstdlib>
#include <iostream>

#include <gtest/gtest.h>

#include <check/proof.h>
#include <ringwatch/base/error.h>
#include <ringwatch/integrators/symplectic_euler.h>
#include <ringwatch/monitor/certificate_file.h>
#include <ringwatch/verify/monitor/monitor_histories.h>

namespace ringwatch {
namespace {

TEST(CheckedHistories, ProveEveryElementOnTheWay) {
  const char *asked = std::getenv("RINGWATCH_HISTORY_CHECKS"), *only = std::getenv("RINGWATCH_HISTORY");
  std::int64_t total = 0;
  int tried = 0;
  const std::vector<detail::History> histories =
      detail::monitorHistories(asked ? StudyEffort::full : StudyEffort::quick);
  for (const detail::History& history : histories) {
    if (only && history.name != only) continue;
    ++tried;
    const double share = asked ? std::atof(asked) / static_cast<double>(histories.size()) : 1200;
    const auto looks = static_cast<int>(std::max(3.0, share / static_cast<double>(history.body.mesh().elementCount())));
    const int every = std::max(1, history.steps / looks);
    BodySystem system(history.body);
    State state = detail::gentleStart(system);
    SymplecticEuler integrator;
    std::int64_t proven = 0;
    for (int step = 0; step <= history.steps; ++step) {
      if (step % every == 0) {
        std::string bytes;
        try {
          bytes = makeCertificate(history.body, state.x).bytes;
        } catch (const NumericalError&) {
          break;  // it has blown up
        }
        const check::Verdict verdict = check::verify(bytes);
        ASSERT_EQ(verdict.status, check::Verdict::Status::proven)
            << history.name << ", step " << step << ": " << verdict.reason;
        proven += verdict.elements;
      }
      integrator.step(system, state, history.h);
      if (!state.x.allFinite()) break;
    }
    EXPECT_GE(proven, static_cast<std::int64_t>(3 * history.body.mesh().elementCount())) << history.name;
    total += proven;
    if (asked) std::cout << history.name << ": " << proven << " elements proven" << std::endl;
  }
  EXPECT_GE(tried, only ? 1 : 5);
  if (asked) std::cout << total << " elements proven, none rejected\n";
}

}  // namespace
}  // namespace ringwatch
