// The example of docs/integrators.md, word for word, as a test.
#include <gtest/gtest.h>

// [example]
#include <ringwatch/verify/integrators.h>

/// The Newmark method with beta = 1/6, gamma = 1/2 (linear acceleration), its equation solved by two fixed-point
/// sweeps.
class MyNewmark final : public ringwatch::Integrator {
 public:
  static constexpr ringwatch::IntegratorInfo description{.name = "my-newmark",
                                                         .help = "linear acceleration, two sweeps",
                                                         .order = 2,
                                                         .forceEvaluations = 3,
                                                         .imaginaryLimit = 0,
                                                         .symplectic = false,
                                                         .dampedOrder = 2};
  const ringwatch::IntegratorInfo& info() const override { return description; }
  ringwatch::StepStatus step(ringwatch::SecondOrderSystem& system, ringwatch::State& state, double h) override {
    ringwatch::NodeVectors a, next;
    system.acceleration(state.time, state.x, state.v, a);
    next = a;
    ringwatch::NodeVectors x, v;
    for (int sweep = 0; sweep < 2; ++sweep) {
      x = state.x + h * state.v + h * h / 6 * (2 * a + next);
      v = state.v + h / 2 * (a + next);
      system.acceleration(state.time + h, x, v, next);
    }
    state.x += h * state.v + h * h / 6 * (2 * a + next);
    state.v += h / 2 * (a + next);
    state.time += h;
    return {};
  }
};

ringwatch::StudyReport studyMine() {
  return ringwatch::verifyIntegrator([] { return std::make_unique<MyNewmark>(); }, ringwatch::StudyEffort::quick);
}
// [example]

TEST(OwnIntegrator, IsStudied) {
  const ringwatch::StudyReport report = studyMine();
  for (const ringwatch::StudyCheck& check : report.checks)
    EXPECT_TRUE(check.passed) << check.name << ": " << check.measured << ", expected " << check.expected << " within "
                              << check.tolerance;
}
