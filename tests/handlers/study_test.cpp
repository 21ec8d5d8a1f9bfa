// The study that the command line runs, quick.
#include <gtest/gtest.h>

#include <ringwatch/verify/handlers.h>

namespace ringwatch {
namespace {

TEST(HandlersStudy, FindsAllHandlersAsGoodAsTheyClaim) {
  const StudyReport report = verifyHandlers(StudyEffort::quick);
  EXPECT_EQ(report.study, "handlers");
  ASSERT_EQ(report.tables.size(), 3u);
  EXPECT_GT(report.checks.size(), 20u);
  for (const StudyCheck& check : report.checks) EXPECT_TRUE(check.passed) << check.name << ": " << check.measured;
}

}  // namespace
}  // namespace ringwatch
