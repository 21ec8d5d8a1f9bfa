// The explicit integrators one by one: names, closed forms of their limits, failure texts. What holds for all of them
// is checked by the study of tests/verify.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include <ringwatch/base/error.h>
#include <ringwatch/integrators/integrator.h>
#include <ringwatch/verify/integrators/oscillator.h>

namespace ringwatch {
namespace {

TEST(ExplicitIntegrators, KnowsTheirNames) {
  for (const char* name : {"explicit-euler", "symplectic-euler", "verlet", "rk4", "rkn4", "yoshida4", "pefrl"}) {
    ASSERT_NE(findIntegrator(name), nullptr) << name;
    EXPECT_EQ(makeIntegrator(name)->info().name, name);
  }
  EXPECT_EQ(findIntegrator("rk5"), nullptr);
  EXPECT_EQ(allIntegrators().size(), coreIntegrators().size());
}

TEST(ExplicitIntegrators, UnknownNameListsTheKnownOnes) {
  try {
    makeIntegrator("rk5");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(),
                ::testing::AllOf(::testing::HasSubstr("\"rk5\""), ::testing::HasSubstr("rkn4, yoshida4, pefrl")));
  }
}

TEST(ExplicitIntegrators, CatalogJoinsLists) {
  const IntegratorCatalog catalog{coreIntegrators(), coreIntegrators().first(1)};
  EXPECT_EQ(catalog.entries().size(), coreIntegrators().size() + 1);
  EXPECT_EQ(catalog.find("rk4"), coreIntegrators()[3].info);
}

TEST(ExplicitIntegrators, DeclareTheKnownLimits) {
  EXPECT_EQ(findIntegrator("explicit-euler")->imaginaryLimit, 0);
  EXPECT_EQ(findIntegrator("symplectic-euler")->imaginaryLimit, 2);
  EXPECT_EQ(findIntegrator("verlet")->imaginaryLimit, 2);
  EXPECT_DOUBLE_EQ(findIntegrator("rk4")->imaginaryLimit, 2 * std::sqrt(2.0));
  // 1 + trace + det = 0 in u = z².
  const double u = std::pow(findIntegrator("rkn4")->imaginaryLimit, 2);
  EXPECT_NEAR(4 - u + u * u / 12 - u * u * u / 288, 0, 1e-14);
  EXPECT_NEAR(findIntegrator("yoshida4")->imaginaryLimit, 1.5734, 5e-5);
  EXPECT_NEAR(findIntegrator("pefrl")->imaginaryLimit, 2.989, 5e-4);
}

/// A force that depends on time alone: x'' = 6 t, x = t³ from rest.
class TimeForce final : public SecondOrderSystem {
 public:
  void acceleration(double time, const NodeVectors& x, const NodeVectors&, NodeVectors& a) override {
    a.setConstant(3, x.cols(), 6 * time);
  }
};

TEST(ExplicitIntegrators, EvaluateForcesAtTheRightTimes) {
  int tried = 0;
  for (const IntegratorEntry& entry : coreIntegrators()) {
    if (entry.info->order < 4) continue;
    ++tried;
    const auto integrator = entry.make();
    TimeForce system;
    State state{0, NodeVectors::Zero(3, 2), NodeVectors::Zero(3, 2)};
    for (int k = 0; k < 4; ++k) EXPECT_TRUE(integrator->step(system, state, 0.25).done);
    EXPECT_NEAR(state.x(2, 1), 1, 1e-13) << entry.info->name;
    EXPECT_NEAR(state.v(2, 1), 3, 1e-13) << entry.info->name;
    EXPECT_EQ(state.time, 1);
  }
  EXPECT_GT(tried, 0);
}

}  // namespace
}  // namespace ringwatch
