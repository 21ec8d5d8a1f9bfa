// The example of docs/verify_your_own.md, word for word, as a test.
#include <gtest/gtest.h>

// [example]
#include <ringwatch/verify/integrators/integrators.h>

/// Leapfrog that starts with half a drift instead of half a kick.
class DriftKickDrift final : public ringwatch::Integrator {
 public:
  static constexpr ringwatch::IntegratorInfo description{.name = "drift-kick-drift",
                                                         .help = "leapfrog, half a drift first",
                                                         .order = 2,
                                                         .forceEvaluations = 1,
                                                         .imaginaryLimit = 2,
                                                         .symplectic = true,
                                                         .reversible = true};
  const ringwatch::IntegratorInfo& info() const override { return description; }
  ringwatch::StepStatus step(ringwatch::SecondOrderSystem& system, ringwatch::State& state, double h) override {
    state.x += h / 2 * state.v;
    system.acceleration(state.time + h / 2, state.x, state.v, a_);
    state.v += h * a_;
    state.x += h / 2 * state.v;
    state.time += h;
    return {};
  }

 private:
  ringwatch::NodeVectors a_;
};

ringwatch::StudyReport studyMine() {
  return ringwatch::verifyIntegrator([] { return std::make_unique<DriftKickDrift>(); }, ringwatch::StudyEffort::quick);
}
// [example]

TEST(OwnIntegrator, IsStudied) {
  const ringwatch::StudyReport report = studyMine();
  for (const ringwatch::StudyCheck& check : report.checks)
    EXPECT_TRUE(check.passed()) << check.name << ": " << check.measured << ", expected " << check.expected << " within "
                                << check.tolerance;
}
