// Long and hard runs, in short.
#include <gtest/gtest.h>

#include <cmath>

#include <ringwatch/verify/robustness/robustness.h>

#include "report_tools.h"

namespace ringwatch {
namespace {

TEST(VerifyRobustness, StableStepsSurviveAndOthersDoNot) {
  const StudyReport report = verifyRobustness(StudyEffort::quick);
  test::expectHolds(report);
  // Every integrator with a limit goes through every case.
  std::set<std::pair<std::string, std::string>> expected, found;
  for (const IntegratorEntry& entry : coreIntegrators())
    if (entry.info->imaginaryLimit > 0 && std::isfinite(entry.info->imaginaryLimit))
      for (const char* what :
           {"cube", "stiffness contrast 1e8", "Poisson ratio 0.4999", "sliver of 1e-6", "jittered cube", "3 turns"})
        expected.insert({std::string(entry.info->name), what});
  for (const auto& row : test::tableOf(report, "robustness").rows)
    found.insert({std::get<std::string>(row[0]), std::get<std::string>(row[1])});
  EXPECT_EQ(found, expected);
  EXPECT_FALSE(expected.empty());
}

}  // namespace
}  // namespace ringwatch
