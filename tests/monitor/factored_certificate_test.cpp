// The certificate by factorisation against dense eigenvalues: yes just above the truth, never below.
#include <gtest/gtest.h>

#include <ringwatch/base/error.h>
#include <ringwatch/base/infinity.h>
#include <ringwatch/monitor/exact_step.h>
#include <tests/monitor/monitor_cases.h>

namespace ringwatch {
namespace {

using test::DenseTangent;
using test::Hold;
using test::Subdivision;

TEST(FactoredCertificate, SaysYesAboveTheTruthAndNeverBelow) {
  int states = 0, finite = 0, withSteps = 0;
  for (const Subdivision& subdivision : test::allSubdivisions())
    for (const LawInfo& law : allLaws())
      for (const Hold hold : {Hold::nothing, Hold::face, Hold::components}) {
        Body body = test::boxBody(subdivision, law.name);
        test::holdBody(body, hold);
        for (const test::NamedState& state : test::deformedStates(body.mesh().X, 4)) {
          const DenseTangent dense(body, state.x);
          const std::string what =
              joinText(subdivision.name, ", ", law.name, ", ", test::holdName(hold), ", ", state.name);
          ++states;
          if (!dense.finite()) {
            EXPECT_FALSE(FactoredCertificate(body, state.x).certifies(1e30)) << what;
            continue;
          }
          ++finite;
          const Eigen::VectorXd lambda = dense.eigenvalues();
          const double top = lambda[lambda.size() - 1], size = std::max(top, -lambda[0]);
          for (const double near : {1e-9, 1e-6, 1e-3, 1.0}) {
            EXPECT_TRUE(FactoredCertificate(body, state.x).certifies(top + near * size)) << what << ", " << near;
            EXPECT_FALSE(FactoredCertificate(body, state.x).certifies(top - near * size)) << what << ", " << near;
          }
          EXPECT_FALSE(FactoredCertificate(body, state.x).certifies(top)) << what;
          if (!(top > 0)) continue;
          ++withSteps;
          const double h = 2 / std::sqrt(top);
          EXPECT_EQ(proveStep(body, state.x, 2, 0.999 * h), Verdict::certified) << what;
          EXPECT_NE(proveStep(body, state.x, 2, 1.001 * h), Verdict::certified) << what;
          EXPECT_EQ(proveStep(body, state.x, 2.8, 1.399 * h), Verdict::certified) << what;
          EXPECT_NE(proveStep(body, state.x, 2.8, 1.401 * h), Verdict::certified) << what;
        }
      }
  EXPECT_GE(4 * finite, 3 * states);
  EXPECT_GE(4 * withSteps, 3 * finite);
}

TEST(FactoredCertificate, OfABodyWithNothingFree) {
  Body body = test::boxBody(test::allSubdivisions()[0], "stvk");
  for (std::int32_t i = 0; i < body.nodeCount(); ++i) body.constraints().fix(i);
  EXPECT_TRUE(FactoredCertificate(body, body.mesh().X).certifies(4e-12));
}

TEST(FactoredCertificate, KnowsNoFrequencyThatIsNone) {
  const Body body = test::boxBody(test::allSubdivisions()[0], "stvk");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {0.0, -1.0, nan})
    EXPECT_FALSE(FactoredCertificate(body, body.mesh().X).certifies(bad)) << bad;
  EXPECT_FALSE(FactoredCertificate(body, body.mesh().X).certifies(infinity));
}

}  // namespace
}  // namespace ringwatch
