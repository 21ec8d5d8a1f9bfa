// The study that `ringwatch verify integrators` runs: all of the library pass, wrong declarations fail.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include <ringwatch/base/infinity.h>
#include <ringwatch/integrators/symplectic_euler.h>
#include <ringwatch/verify/integrators/integrators.h>

#include "report_tools.h"

namespace ringwatch {
namespace {

TEST(VerifyIntegrators, TheLibrarysOwnLiveUpToTheirDeclarations) {
  const StudyReport report = verifyIntegrators(StudyEffort::quick);
  test::expectHolds(report);
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
  EXPECT_THAT(failures(info),
              ::testing::ElementsAre(::testing::HasSubstr("order"), ::testing::HasSubstr("forces of time")));
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
    EXPECT_THAT(names, ::testing::IsSupersetOf({::testing::HasSubstr("time advances by h in every step"),
                                                ::testing::HasSubstr("time advances by 100 h in 100 steps")}))
        << share;
  }
}

using Step = std::function<void(SecondOrderSystem& system, State& state, double h)>;

/// A scheme that is right, until a fault is planted in it: leapfrog that drifts first, or RK4.
class Planted final : public Integrator {
 public:
  static constexpr IntegratorInfo leapfrog{"leapfrog", "", 2, 1, 2.0, true, true};
  static constexpr IntegratorInfo rk4{"rk4", "", 4, 4, 2.8284271247461903, false, false, 4};
  Planted(const IntegratorInfo& info, Step step) : info_(info), step_(std::move(step)) {}
  const IntegratorInfo& info() const override { return info_; }
  StepStatus step(SecondOrderSystem& system, State& state, double h) override {
    step_(system, state, h);
    state.time += h;
    return {};
  }

 private:
  const IntegratorInfo& info_;
  Step step_;
};

/// Asks for the force at state.time + share · h, and changes what was made at the end.
Step leapfrog(
    double share, const std::function<void(State&)>& change = [](State&) {}) {
  return [=](SecondOrderSystem& system, State& state, double h) {
    NodeVectors a;
    state.x += h / 2 * state.v;
    system.acceleration(state.time + share * h, state.x, state.v, a);
    state.v += h * a;
    state.x += h / 2 * state.v;
    change(state);
  };
}

/// The last stage at its place, or as the one half as far away says, which is the same where forces are linear.
Step rungeKutta(bool extrapolated) {
  return [=](SecondOrderSystem& system, State& state, double h) {
    const auto at = [&](double c, const NodeVectors& dx, const NodeVectors& dv) {
      NodeVectors a;
      system.acceleration(state.time + c * h, state.x + h * dx, state.v + h * dv, a);
      return a;
    };
    const NodeVectors none = 0 * state.x, a1 = at(0, none, none), v2 = state.v + h / 2 * a1,
                      a2 = at(0.5, state.v / 2, a1 / 2), v3 = state.v + h / 2 * a2, a3 = at(0.5, v2 / 2, a2 / 2),
                      v4 = state.v + h * a3,
                      a4 = extrapolated ? NodeVectors(2 * at(0.5, v3 / 2, a3 / 2) - a1) : at(1, v3, a3);
    state.x += h / 6 * (state.v + 2 * v2 + 2 * v3 + v4);
    state.v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
  };
}

std::vector<std::string> failuresOf(const IntegratorInfo& info, const Step& step) {
  std::vector<std::string> names;
  for (const StudyCheck& check :
       verifyIntegrator([&] { return std::make_unique<Planted>(info, step); }, StudyEffort::quick).checks)
    if (!check.passed()) names.push_back(check.name);
  return names;
}

TEST(VerifyIntegrators, PlantedFaultsAreFound) {
  EXPECT_THAT(failuresOf(Planted::leapfrog, leapfrog(0.5)), ::testing::IsEmpty());
  EXPECT_THAT(failuresOf(Planted::rk4, rungeKutta(false)), ::testing::IsEmpty());
  const auto nodes = [](int at, double by) {
    return leapfrog(0.5, [=](State& state) {
      if (at < state.v.cols()) state.v.col(at) *= 1 + by;
    });
  };
  const auto last = [](State& state) { state.v.rightCols(1) *= 1 + 1e-6; };
  const auto component = [](int c) { return leapfrog(0.5, [=](State& state) { state.v.row(c) *= 1 + 1e-8; }); };
  const auto swaps = [](State& state) {
    if (state.v.cols() > 9) state.v.col(2).swap(state.v.col(9));
  };
  const struct {
    const char* fault;
    Step step;
    const char* found;
  } faults[] = {
      {"the force of the step's begin", leapfrog(0), "at the times of their positions"},
      {"the force of the step's end", leapfrog(1), "at the times of their positions"},
      {"the force of a moment later", leapfrog(0.5 + 1e-9), "at the times of their positions"},
      {"a node's velocity", nodes(7, 1e-6), "components of"},
      {"the first node's velocity", nodes(0, 1e-6), "components of"},
      {"a node far behind", nodes(1099, 1e-12), "components of"},
      {"the last node, however many", leapfrog(0.5, last), "components of"},
      {"the first component", component(0), "components of"},
      {"the second component", component(1), "components of"},
      {"the third component", component(2), "components of"},
      {"two nodes for each other", leapfrog(0.5, swaps), "components of"},
      {"an acceleration of before", leapfrog(0.5, [](State& state) { state.a = state.v; }), "what a step leaves"},
      {"a lag", leapfrog(0.5, [](State& state) { state.lag = 1e-6; }), "what a step leaves"}};
  for (const auto& [fault, step, found] : faults)
    EXPECT_THAT(failuresOf(Planted::leapfrog, step), ::testing::Contains(::testing::HasSubstr(found))) << fault;
  EXPECT_THAT(failuresOf(Planted::rk4, rungeKutta(true)), ::testing::Contains(::testing::HasSubstr("not linear")));
}

TEST(VerifyIntegrators, BetterThanDeclaredPassesAndIsTold) {
  const IntegratorInfo modest{"leapfrog", "", 1, 1, 2.0, true, true};
  EXPECT_THAT(failuresOf(modest, leapfrog(0.5)), ::testing::IsEmpty());
  const StudyReport report =
      verifyIntegrator([&] { return std::make_unique<Planted>(modest, leapfrog(0.5)); }, StudyEffort::quick);
  EXPECT_TRUE(std::any_of(report.checks.begin(), report.checks.end(), [](const StudyCheck& check) {
    return check.name == "leapfrog: order, which is better than declared";
  }));
}

}  // namespace
}  // namespace ringwatch
