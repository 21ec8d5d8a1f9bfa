// The study of handlers that the command line runs, quick.
#include <gtest/gtest.h>

#include <ringwatch/handlers/handler.h>
#include <ringwatch/verify/handlers/handlers.h>

#include "criteria.h"
#include "report_tools.h"

namespace ringwatch {
namespace {

const StudyReport& handlersReport() {
  static const StudyReport made = verifyHandlers(StudyEffort::quick);
  return made;
}

TEST(HandlersStudy, HoldsHandlersToTheirCriteria) {
  using test::Basis;
  test::expectCriteria(
      handlersReport(),
      {// Errors of the step, three times the critical one, over the largest displacement.
       {"bar with slivers, *, imex: mean error", 3e-4, Basis::measured},
       {"bar with slivers, *, imex, no dissipation: mean error", 2.5e-4, Basis::measured},
       {"bar with slivers, *, imex, dissipation 0.3: mean error", 4e-4, Basis::measured},
       {"bar with slivers, *, imex, implicit Euler: mean error", 9e-4, Basis::measured},
       {"bar with slivers, *, imex, cg: mean error", 3.6e-4, Basis::measured},
       {"bar with slivers, *, imex, cg to 1e-6: mean error", 3e-4, Basis::measured},
       {"bar with slivers, *, imex, fierz-ring: mean error", 9e-4, Basis::measured},
       {"bar with slivers, *, local-time-stepping: mean error", 8e-4, Basis::measured},
       {"bar with slivers, *, local-time-stepping, no dissipation: mean error", 2.8e-4, Basis::measured},
       {"bar with slivers, *, local-time-stepping, fierz-ring: mean error", 8.5e-4, Basis::measured},
       {"bar with slivers, *, fe-pbd: mean error", 9e-4, Basis::measured},
       {"bar with slivers, *, fe-pbd, three passes: mean error", 8e-4, Basis::measured},
       {"bar with slivers, *, fe-pbd, rigid: mean error", 0.03, Basis::measured},
       {"bar with slivers, *, modal-filter: mean error", 7e-4, Basis::measured},
       {"graded cube, *, imex: mean error", 0.011, Basis::measured},
       {"graded cube, *, imex, no dissipation: mean error", 4.5e-3, Basis::measured},
       {"graded cube, *, imex, dissipation 0.3: mean error", 0.03, Basis::measured},
       {"graded cube, *, imex, implicit Euler: mean error", 0.08, Basis::measured},
       {"graded cube, *, imex, cg: mean error", 0.011, Basis::measured},
       {"graded cube, *, imex, cg to 1e-6: mean error", 0.011, Basis::measured},
       {"graded cube, *, imex, fierz-ring: mean error", 0.012, Basis::measured},
       {"graded cube, *, local-time-stepping: mean error", 0.012, Basis::measured},
       {"graded cube, *, local-time-stepping, no dissipation: mean error", 3.2e-3, Basis::measured},
       {"graded cube, *, local-time-stepping, fierz-ring: mean error", 0.013, Basis::measured},
       {"*: h times the explicit part's highest frequency / 2", 0.9, Basis::theory},
       // A tangent that turns with its element feeds a little energy in, which dissipation takes out again.
       {"*, imex, 4000 steps: largest energy", 5e-5, Basis::measured},
       {"*, imex, cg, 4000 steps: largest energy", 9e-5, Basis::measured},
       {"*, imex, cg to 1e-6, 4000 steps: largest energy", 5e-5, Basis::measured},
       {"*, imex, fierz-ring, 4000 steps: largest energy", 5e-5, Basis::measured},
       {"*, local-time-stepping, 4000 steps: largest energy", 3.5e-5, Basis::measured},
       {"*, local-time-stepping, fierz-ring, 4000 steps: largest energy", 4e-5, Basis::measured},
       {"*, 4000 steps: largest energy", 9e-5, Basis::measured},
       // 2.6e-13 to 1.9e-12 by build.
       {"*, imex*, 4000 steps: momentum error", 4e-12, Basis::rounding},
       {"*, 4000 steps: momentum error", 2e-14, Basis::rounding},
       // A rotation of each cluster takes the moment of implicit forces, and of levels that step at different times.
       {"*, imex*, 4000 steps: angular momentum error", 4e-12, Basis::rounding},
       {"*, 4000 steps: angular momentum error", 2e-14, Basis::rounding},
       // The energy of Verlet swings with its step; what is missing is lost to dissipation and passes.
       {"cutting, verlet: largest energy over four cuts / start", 3.5e-3, Basis::measured},
       {"cutting, *: largest energy over four cuts / start", 1e-3, Basis::measured},
       {"cutting, verlet: energy after four cuts / start", 0.009, Basis::measured},
       {"cutting, fe-pbd, *: energy after four cuts / start", 0.05, Basis::measured},
       {"cutting, modal-filter, *: energy after four cuts / start", 0.05, Basis::measured},
       {"cutting, *: energy after four cuts / start", 0.04, Basis::measured},
       {"cutting, verlet: critical step after / before four cuts", 0.065, Basis::measured},
       {"cutting, mass-scaling, *: lost", 0, Basis::theory},
       {"*: largest spectral radius", 2e-14, Basis::rounding}});
}

TEST(HandlersStudy, PutsEveryHandlerToEveryTest) {
  test::expectWellFormed(handlersReport());
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
