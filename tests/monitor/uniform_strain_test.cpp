// Hexahedra of uniform strain in the bracket: hourglass stiffness and viscosity on both sides, from scratch, along runs
// whose hourglass modes move, and for ranges of states, against dense eigenvalues.
#include <gtest/gtest.h>

#include <ringwatch/base/error.h>
#include <ringwatch/monitor/bounds/range_bound.h>
#include <ringwatch/monitor/certificate_file.h>
#include <ringwatch/monitor/incremental/work_account.h>
#include <tests/monitor/bracket_checks.h>

namespace ringwatch {
namespace {

using test::DenseTangent;

/// viscosity: of hourglass modes, at such a factor that it counts as much as their stiffness.
Body uniformStrainBody(std::string_view law, double stiffness, double viscosity, std::array<int, 3> cells = {2, 2, 2}) {
  BodyOptions options{{{"hex8", "uniform-strain"}}, Lumping::rowSum, 1};
  options.hourglassControl.stiffness = stiffness;
  Body body(test::box({"hex8_1", "hex8", 1, "", 0}, cells),
            makeMaterial(law, test::young, test::poisson, test::density), options);
  if (viscosity > 0) {
    body.setElementDamping({{.hourglassViscosity = viscosity}});
    body.elementDamping()->setFactor(3e3);
  }
  return body;
}

TEST(UniformStrainBracket, HoldsFromScratchForEveryLaw) {
  int brackets = 0, damped = 0;
  for (const LawInfo& law : allLaws())
    for (const double stiffness : {0.0, 0.05, 1.0})
      for (const double viscosity : {0.0, 2.0}) {
        Body body = uniformStrainBody(law.name, stiffness, viscosity);
        for (const test::NamedState& state : test::deformedStates(body.mesh().X, 3)) {
          const DenseTangent dense(body, state.x);
          if (!dense.finite() || !(dense.largest() > 0)) continue;
          const CriticalStep step = criticalStep(body, state.x, 2.0);
          const std::string what = joinText(law.name, ", ", stiffness, ", ", viscosity, ", ", state.name);
          test::expectHolds(step, dense.largest(), what);
          EXPECT_GE(step.safe, 0.8 * test::stepOf(dense.largest())) << what;
          ++brackets;
          if (viscosity == 0) continue;
          body.elementDamping()->setFactor(0);
          damped += dense.largest() > 1.02 * DenseTangent(body, state.x).largest();
          body.elementDamping()->setFactor(3e3);
        }
      }
  EXPECT_GT(brackets, 150);
  EXPECT_GT(damped, brackets / 6);
}

// Hourglass modes move by as much as the mean strain does: proofs that are kept in balls of the mean gradient hold.
TEST(UniformStrainBracket, ProofsHoldAlongRuns) {
  std::int64_t kept = 0, states = 0;
  for (const LawInfo& law : allLaws())
    for (const double viscosity : {0.0, 2.0})
      for (const double budget : {infinity, 0.0}) {
        Body body = uniformStrainBody(law.name, 0.2, viscosity);
        const NodeVectors& X = body.mesh().X;
        const NodeVectors shake = test::Random(12).nodeVectors(X.cols(), 0.08 * test::cellSize);
        WorkAccount account(body, budget);
        IncrementalNodalBound bound(body, {}, &account);
        RunBracket bracket(body, 0.05, budget);
        for (int step = 0; step < 30; ++step) {
          const NodeVectors x = test::turningPath(X, 0.05 * step, shake);
          account.earn();
          const DenseTangent dense(body, x);
          ASSERT_TRUE(dense.finite());
          const double lambda = dense.largest();
          const std::string what = joinText(law.name, ", ", viscosity, ", budget ", budget, ", step ", step);
          test::expectProves(bound, x, lambda, what);
          kept += bound.statistics().evaluated < static_cast<std::int64_t>(body.mesh().elementCount()) / 2;
          test::expectHolds(bracket, x, lambda, what);
          ++states;
        }
      }
  EXPECT_GT(kept, states / 4);
}

// States of mean gradients in the range with hourglass modes of any size: the stiffness of a coefficient of 3 is most
// of the highest eigenvalue.
TEST(UniformStrainBracket, RangesOfStretchesCountTheHourglassStiffness) {
  test::Random random(32);
  const StretchRange range{0.8, 1.3};
  int stiffer = 0;
  double tightest = 0;
  for (const double stiffness : {0.05, 3.0})
    for (const std::string_view law : {"stvk", "neo-hookean", "linear"}) {
      const Body body = uniformStrainBody(law, stiffness, 0), soft = uniformStrainBody(law, 0, 0);
      const RangeStep step = rangeStep(body, range, StepRule(2.0));
      for (int trial = 0; trial < 10; ++trial) {
        const Eigen::Vector3d s = Eigen::Vector3d::NullaryExpr([&] { return random.uniform(0.82, 1.28); });
        const NodeVectors x = random.rotation() * s.asDiagonal() * random.rotation() * body.mesh().X;
        const double largest = DenseTangent(body, x).largest();
        ASSERT_LE(largest, step.lambda.value) << law << stiffness;
        tightest = std::max(tightest, largest / step.lambda.value);
        stiffer += DenseTangent(soft, x).largest() < 0.9 * largest;
      }
    }
  EXPECT_GE(stiffer, 25);
  EXPECT_GE(tightest, 0.3);  // of lambda
}

TEST(UniformStrainBracket, CertificatesInFilesAreRefused) {
  const Body body = uniformStrainBody("stvk", 0.05, 0);
  EXPECT_THROW(makeCertificate(body, body.mesh().X), InputError);
}

}  // namespace
}  // namespace ringwatch
