// The study that `ringwatch verify integrators` runs: all of the library pass, wrong declarations fail.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include <ringwatch/base/infinity.h>
#include <ringwatch/integrators/symplectic_euler.h>
#include <ringwatch/verify/integrators/integrators.h>

#include "integrator_criteria.h"
#include "report_tools.h"

namespace ringwatch {
namespace {

TEST(VerifyIntegrators, TheLibrarysOwnLiveUpToTheirDeclarations) {
  const StudyReport report = verifyIntegrators(StudyEffort::quick);
  test::expectCriteria(report, test::integratorCriteria());
  test::expectWellFormed(report);
  EXPECT_EQ(test::tableNames(report),
            (std::set<std::string>{"limits", "damped_limits", "orders", "periods", "drift", "observed"}));
  EXPECT_EQ(test::figureNames(report),
            (std::set<std::string>{"integrators_spectral_radius", "integrators_limit_over_damping",
                                   "integrators_stability_regions", "integrators_phase_error"}));
  std::set<std::string> names;
  for (const IntegratorEntry& entry : coreIntegrators()) names.insert(std::string(entry.info->name));
  for (const char* table : {"limits", "damped_limits", "orders", "periods", "drift"})
    EXPECT_EQ(test::textsOf(test::tableOf(report, table), 0), names) << table;
}

/// Symplectic Euler under a false flag.
class Liar final : public Integrator {
 public:
  explicit Liar(IntegratorInfo info) : info_(info) {}
  const IntegratorInfo& info() const override { return info_; }
  StepStatus step(SecondOrderSystem& system, State& state, double h) override { return honest_.step(system, state, h); }

 private:
  IntegratorInfo info_;
  SymplecticEuler honest_;
};

std::vector<std::string> failures(const IntegratorInfo& info) {
  std::vector<std::string> names;
  for (const StudyCheck& check :
       verifyIntegrator([&] { return std::make_unique<Liar>(info); }, StudyEffort::quick).checks)
    if (!check.passed()) names.push_back(check.name);
  return names;
}

TEST(VerifyIntegrators, WrongDeclarationsFail) {
  const IntegratorInfo honest = SymplecticEuler::description;
  EXPECT_THAT(failures(honest), ::testing::IsEmpty());

  IntegratorInfo info = honest;
  info.imaginaryLimit = 2.1;
  EXPECT_THAT(failures(info), ::testing::Contains(::testing::HasSubstr("limit on the imaginary axis")));
  EXPECT_THAT(failures(info), ::testing::Contains(::testing::HasSubstr("critical step of real runs")));
  info = honest;
  info.imaginaryLimit = 2 + 1e-6;
  EXPECT_THAT(failures(info), ::testing::Contains(::testing::HasSubstr("limit on the imaginary axis")));
  info.imaginaryLimit = infinity;
  EXPECT_THAT(failures(info), ::testing::Contains(::testing::HasSubstr("limit on the imaginary axis")));
  info = honest;
  info.order = 2;
  EXPECT_THAT(failures(info), ::testing::ElementsAre(::testing::HasSubstr("order")));
  info = honest;
  info.forceEvaluations = 2;
  EXPECT_THAT(failures(info), ::testing::ElementsAre(::testing::HasSubstr("forces a step")));
  info = honest;
  info.reversible = true;
  EXPECT_THAT(failures(info), ::testing::ElementsAre(::testing::HasSubstr("reversible")));
  info = honest;
  info.dampedLimit = [](double) { return 2.0; };
  EXPECT_THAT(failures(info), ::testing::Contains(::testing::HasSubstr("limit at damping ratio")));
}

/// Loses a little at every step.
class Leaky final : public Integrator {
 public:
  static constexpr IntegratorInfo description{"leaky", "", 1, 1, 2.0, true};
  const IntegratorInfo& info() const override { return description; }
  StepStatus step(SecondOrderSystem& system, State& state, double h) override {
    StepStatus status = inner_.step(system, state, h);
    state.v *= 1 - 1e-9;
    return status;
  }

 private:
  SymplecticEuler inner_;
};

TEST(VerifyIntegrators, ASmallLeakIsFound) {
  std::vector<std::string> names;
  for (const StudyCheck& check : verifyIntegrator([] { return std::make_unique<Leaky>(); }, StudyEffort::quick).checks)
    if (!check.passed()) names.push_back(check.name);
  EXPECT_THAT(names, ::testing::Contains(::testing::HasSubstr("symplectic")));
  EXPECT_THAT(names, ::testing::Contains(::testing::HasSubstr("energy drift")));
}

/// Advances positions and velocities, but the time by another share of the step.
class Clockless final : public Integrator {
 public:
  static constexpr IntegratorInfo description = SymplecticEuler::description;
  explicit Clockless(double share) : share_(share) {}
  const IntegratorInfo& info() const override { return description; }
  StepStatus step(SecondOrderSystem& system, State& state, double h) override {
    const double before = state.time;
    const StepStatus status = inner_.step(system, state, h);
    state.time = before + share_ * h;
    return status;
  }

 private:
  double share_;
  SymplecticEuler inner_;
};

TEST(VerifyIntegrators, TimeMustAdvanceByTheStep) {
  for (const double share : {0.0, 0.5, 1 + 1e-9, std::nan("")}) {
    std::vector<std::string> names;
    for (const StudyCheck& check :
         verifyIntegrator([&] { return std::make_unique<Clockless>(share); }, StudyEffort::quick).checks)
      if (!check.passed()) names.push_back(check.name);
    EXPECT_THAT(names, ::testing::ElementsAre(::testing::HasSubstr("time advances by h in every step"),
                                              ::testing::HasSubstr("time advances by 100 h in 100 steps")))
        << share;
  }
}

}  // namespace
}  // namespace ringwatch
