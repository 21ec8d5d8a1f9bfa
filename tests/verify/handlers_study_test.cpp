// The study of handlers that the command line runs, quick.
#include <gtest/gtest.h>

#include <ringwatch/handlers/handler.h>
#include <ringwatch/verify/handlers/handlers.h>

#include "report_tools.h"

namespace ringwatch {
namespace {

const StudyReport& handlersReport() {
  static const StudyReport made = verifyHandlers(StudyEffort::quick);
  return made;
}

TEST(HandlersStudy, HoldsHandlersToTheirCriteria) { test::expectHolds(handlersReport()); }

TEST(HandlersStudy, PutsEveryHandlerToEveryTest) {
  EXPECT_EQ(test::tableNames(handlersReport()),
            (std::set<std::string>{"selection", "motions", "energies", "cutting", "resonance"}));
  for (const HandlerEntry& entry : allHandlers()) {
    const std::string name(entry.info->name);
    EXPECT_EQ(test::textsOf(test::tableOf(handlersReport(), "motions"), 2).count(name), 1u) << name;
    EXPECT_EQ(test::textsOf(test::tableOf(handlersReport(), "energies"), 1).count(name), 1u) << name;
    EXPECT_EQ(test::textsOf(test::tableOf(handlersReport(), "cutting"), 0).count(name), 1u) << name;
  }
}

}  // namespace
}  // namespace ringwatch
