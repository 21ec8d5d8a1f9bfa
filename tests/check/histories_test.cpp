// Elements are proven in ball arithmetic along the histories of `ringwatch verify monitor`.
//   RINGWATCH_HISTORY_CHECKS=N   the full histories, some N elements in all (by default short ones)
//   RINGWATCH_HISTORY=NAME       only this one, so that processes side by side take one each
#include <cstdlib>
#include <functional>
#include <iostream>

#include <gtest/gtest.h>

#include <check/proof.h>
#include <ringwatch/base/error.h>
#include <ringwatch/integrators/symplectic_euler.h>
#include <ringwatch/monitor/certificate_file.h>
#include <ringwatch/verify/monitor/monitor_histories.h>

namespace ringwatch {
namespace {

/// The states of a history until it has blown up: visit(step, x) says whether to go on. Returns the number of steps.
int follow(const detail::History& history, const std::function<bool(int, const NodeVectors&)>& visit) {
  const NodeVectors& X = history.body.mesh().X;
  const double size = (X.rowwise().maxCoeff() - X.rowwise().minCoeff()).norm();
  BodySystem system(history.body);
  State state = detail::gentleStart(system);
  SymplecticEuler integrator;
  int step = 0;
  for (; step <= history.steps && (state.x - X).cwiseAbs().maxCoeff() < 2 * size; ++step) {
    if (!visit(step, state.x)) break;
    integrator.step(system, state, history.h);
  }
  return step;
}

TEST(CheckedHistories, ProveEveryElementOnTheWay) {
  const char *asked = std::getenv("RINGWATCH_HISTORY_CHECKS"), *only = std::getenv("RINGWATCH_HISTORY");
  std::int64_t total = 0;
  int tried = 0;
  const std::vector<detail::History> histories =
      detail::monitorHistories(asked ? StudyEffort::full : StudyEffort::quick);
  for (const detail::History& history : histories) {
    if (only && history.name != only) continue;
    ++tried;
    const auto elements = static_cast<double>(history.body.mesh().elementCount());
    const double share = asked ? std::atof(asked) / static_cast<double>(histories.size()) : 800;
    const auto looks = static_cast<int>(std::max(4.0, share / elements));
    const int steps = follow(history, [](int, const NodeVectors&) { return true; }), every = std::max(1, steps / looks);
    std::int64_t proven = 0;
    follow(history, [&](int step, const NodeVectors& x) {
      if (step % every != 0) return true;
      std::string bytes;
      try {
        bytes = makeCertificate(history.body, x).bytes;
      } catch (const NumericalError&) {
        return false;  // numbers have become too large
      }
      const check::Verdict verdict = check::verify(bytes);
      EXPECT_EQ(verdict.status, check::Verdict::Status::proven)
          << history.name << ", step " << step << ": " << verdict.reason;
      proven += verdict.status == check::Verdict::Status::proven ? verdict.elements : 0;
      return verdict.status == check::Verdict::Status::proven;
    });
    EXPECT_GE(static_cast<double>(proven), 3 * elements) << history.name;
    total += proven;
    if (asked) std::cout << history.name << ": " << proven << " elements proven in " << steps << " steps" << std::endl;
  }
  EXPECT_GE(tried, only ? 1 : 5);
  if (asked) std::cout << total << " elements proven, none rejected\n";
}

}  // namespace
}  // namespace ringwatch
