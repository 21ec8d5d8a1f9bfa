// The critical step by factorisation against dense eigenvalues: both sides proven and close.
#include <gmock/gmock.h>
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

TEST(ExactStep, HoldsTheDenseEigenvalueWithinAMillionth) {
  int positive = 0, found = 0;
  for (const Subdivision& subdivision : test::allSubdivisions())
    for (const LawInfo& law : allLaws())
      for (const Hold hold : {Hold::nothing, Hold::face}) {
        Body body = test::boxBody(subdivision, law.name);
        test::holdBody(body, hold);
        for (const test::NamedState& state : test::deformedStates(body.mesh().X, 4)) {
          const DenseTangent dense(body, state.x);
          if (!dense.finite()) continue;
          const Eigen::VectorXd lambda = dense.eigenvalues();
          const double top = lambda[lambda.size() - 1];
          if (!(top > 0)) continue;
          ++positive;
          const double h = 2 / std::sqrt(top);
          const std::string what =
              joinText(subdivision.name, ", ", law.name, ", ", test::holdName(hold), ", ", state.name);
          const std::optional<ExactStep> exact = exactCriticalStep(body, state.x, 2);
          if (!exact) continue;
          ++found;
          // The dense solver errs by some 1e-14 of the largest eigenvalue, whatever its sign.
          const double rounding = 1e-13 * std::max(top, -lambda[0]) / top;
          EXPECT_LE(exact->safe, h * (1 + rounding)) << what;
          EXPECT_GE(exact->optimistic, h * (1 - rounding)) << what;
          EXPECT_LE(exact->optimistic / exact->safe - 1, 1e-6) << what;
          EXPECT_EQ(proveStep(body, state.x, 2, exact->safe * (1 - 1e-6)), Verdict::certified) << what;
          EXPECT_EQ(proveStep(body, state.x, 2, exact->optimistic * (1 + 1e-6)), Verdict::violated) << what;
          EXPECT_NE(proveStep(body, state.x, 2, exact->optimistic * (1 - 4e-16)), Verdict::violated) << what;
        }
      }
  EXPECT_GE(positive, 300);
  EXPECT_GE(20 * found, 19 * positive) << "states without an answer, of " << positive;
}

TEST(ExactStep, CountsTheFactorBeforeItIsMade) {
  Body body = test::boxBody(test::allSubdivisions()[0], "stvk");
  test::holdBody(body, Hold::face);
  FactorisationCost told{};
  ASSERT_TRUE(exactCriticalStep(body, body.mesh().X, 2, 1e-6, [&](const FactorisationCost& cost) { told = cost; }));
  // A dense matrix of the same rows has n (n - 1) / 2 numbers below its diagonal, and n (n - 1) (n + 1) / 3 operations.
  double n = 0;
  for (std::int32_t i = 0; i < body.nodeCount(); ++i)
    for (int c = 0; c < 3; ++c) n += body.constraints().isConstrained(i, c) ? 0 : 1;
  EXPECT_GT(told.numbers, 3 * n);
  EXPECT_LE(told.numbers, n * (n - 1) / 2);
  EXPECT_GE(told.bytes, 12 * told.numbers);
  EXPECT_GT(told.operations, told.numbers);
  EXPECT_THROW(
      exactCriticalStep(body, body.mesh().X, 2, 1e-6, [](const FactorisationCost&) { throw InputError("no"); }),
      InputError);
}

TEST(ExactStep, RefusesWhatIsNoStepOrNoProof) {
  const Body body = test::boxBody(test::allSubdivisions()[0], "stvk");
  const NodeVectors& X = body.mesh().X;
  for (const double bad : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), infinity})
    EXPECT_THROW(proveStep(body, X, 2, bad), InputError) << bad;
  EXPECT_THROW(exactCriticalStep(body, X, 2, 0), InputError);
  const StepRule guess([](double lambda) { return stepFor(lambda, 2); }, false);
  EXPECT_THROW(exactCriticalStep(body, X, guess), InputError);
  EXPECT_THROW(proveStep(body, X, guess, 1e-3), InputError);
  EXPECT_THROW(exactCriticalStep(body, NodeVectors::Zero(3, 1), 2), InputError);
}

TEST(ExactStep, OfABodyWithNothingFree) {
  Body body = test::boxBody(test::allSubdivisions()[0], "stvk");
  for (std::int32_t i = 0; i < body.nodeCount(); ++i) body.constraints().fix(i);
  EXPECT_EQ(proveStep(body, body.mesh().X, 2, 1e6), Verdict::certified);
  EXPECT_FALSE(exactCriticalStep(body, body.mesh().X, 2));
}

}  // namespace
}  // namespace ringwatch
