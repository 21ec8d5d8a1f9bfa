// Handlers with Rayleigh damping: no mode of the step grows, the motion is the damped one, and what cannot be is
// refused.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include <Eigen/Eigenvalues>

#include <ringwatch/base/error.h>
#include <ringwatch/handlers/local_time_stepping/local_time_stepping.h>
#include <ringwatch/integrators/body_system.h>
#include <tests/handlers/handler_cases.h>

namespace ringwatch {
namespace {

/// Spectral radius of the step of a linear body with damping, as test::spectralRadius. With Verlet the velocities of
/// two steps are half a step apart from those of the recursion, which is similar.
double radiusOf(const Body& body, const RayleighDamping& damping, Integrator& integrator, double h) {
  constexpr double unit = 1e-3;
  BodySystem system(body, damping);
  std::vector<Eigen::Index> free;
  for (Eigen::Index d = 0; d < 3 * body.nodeCount(); ++d)
    if (!body.constraints().isConstrained(static_cast<std::int32_t>(d / 3), static_cast<int>(d % 3))) free.push_back(d);
  const auto n = static_cast<Eigen::Index>(free.size());
  Eigen::MatrixXd G(2 * n, 2 * n);
  for (Eigen::Index k = 0; k < 2 * n; ++k) {
    State state{0, body.mesh().X, NodeVectors::Zero(3, body.nodeCount())};
    (k < n ? state.x : state.v).data()[free[k % n]] += k < n ? unit : unit / h;
    integrator.reset();
    EXPECT_TRUE(integrator.step(system, state, h).done);
    for (Eigen::Index i = 0; i < n; ++i) {
      G(i, k) = (state.x.data()[free[i]] - body.mesh().X.data()[free[i]]) / unit;
      G(n + i, k) = state.v.data()[free[i]] * h / unit;
    }
  }
  return test::spectralRadius(G);
}

struct Case {
  const char* handler;
  double alphaOfStep, betaOfStep;  // alpha h and beta / h
};

std::unique_ptr<Handler> handlerFor(Body& body, const Case& c, double h, double dissipation, const char* base) {
  HandlerOptions options;
  options.damping = {c.alphaOfStep / h, c.betaOfStep * h};
  if (std::string_view(c.handler) != "mass-scaling") options.own.set("dissipation", dissipation);
  auto handler = makeHandler(c.handler, body, makeIntegrator(base), options);
  handler->prepare(body.mesh().X, h);
  return handler;
}

constexpr Case cases[] = {{"imex", 0.5, 0},
                          {"imex", 0, 0.3},
                          {"imex", 1.2, 2},
                          {"local-time-stepping", 0.3, 0},
                          {"local-time-stepping", 1.2, 0},
                          {"mass-scaling", 0.5, 0.3}};

TEST(DampedHandlers, LetNoModeGrowAtThreeTimesTheCriticalStep) {
  for (const Case& c : cases)
    for (const double dissipation : {0.0, 0.5}) {
      Body body = test::sliverBody("linear", 0.95);
      const double h = 3 * test::criticalStepOf(body);
      const RayleighDamping damping{c.alphaOfStep / h, c.betaOfStep * h};
      const std::string name = joinText(c.handler, " ", c.alphaOfStep, " ", c.betaOfStep, " ", dissipation);
      const auto handler = handlerFor(body, c, h, dissipation, "symplectic-euler");
      ASSERT_FALSE(handler->elements().empty()) << name;
      EXPECT_LE(radiusOf(body, damping, *handler, h), 1 + 1e-6) << name;
      if (handler->handlerInfo().addsMass) continue;
      EXPECT_GT(radiusOf(body, damping, *makeIntegrator("symplectic-euler"), h), 1.5) << name << ": the test can fail";
    }
}

// Without the parts that the damping adds to the implicit matrix and to the choice, steps are not stable.
TEST(DampedHandlers, NeedWhatTheDampingAdds) {
  Body body = test::sliverBody("linear", 0.95);
  const double h = 3 * test::criticalStepOf(body);
  const RayleighDamping damping{0, 2 * h};
  const auto undamped = makeHandler("imex", body, makeIntegrator("symplectic-euler"), {});
  undamped->prepare(body.mesh().X, h);
  EXPECT_GT(radiusOf(body, damping, *undamped, h), 1.1);
}

// The motion of a slowly swinging bar, against Verlet in small steps with the same damping.
TEST(DampedHandlers, DampAsTheBodyDoes) {
  constexpr double end = 0.08;
  for (const auto& [handler, damping] : {std::pair<const char*, RayleighDamping>{"imex", {20, 0}},
                                         {"imex", {5, 2e-4}},
                                         {"local-time-stepping", {20, 0}}}) {
    const auto run = [&, handler = handler](bool handled, const RayleighDamping& own) {
      Body body = test::sliverBody("corotational", 0.95);
      body.addBodyForce({0, 0, -2});
      const double critical = test::criticalStepOf(body);
      const int steps = static_cast<int>(std::ceil(end / (handled ? 2 * critical : 0.05 * critical)));
      std::unique_ptr<Integrator> integrator = makeIntegrator("verlet");
      if (handled) {
        HandlerOptions options;
        options.damping = own;
        options.own.set("dissipation", 0.0);
        auto made = makeHandler(handler, body, std::move(integrator), options);
        made->prepare(body.mesh().X, end / steps);
        EXPECT_FALSE(made->elements().empty());
        integrator = std::move(made);
      }
      BodySystem system(body, own);
      State state = system.initialState();
      for (int i = 0; i < steps; ++i) EXPECT_TRUE(integrator->step(system, state, end / steps).done);
      return NodeVectors(state.x - body.mesh().X);
    };
    const NodeVectors exact = run(false, damping), own = run(true, damping), undamped = run(true, {});
    EXPECT_LE((own - exact).norm(), 0.03 * exact.norm()) << handler << " " << damping.alpha;
    EXPECT_GT((undamped - exact).norm(), 0.1 * exact.norm()) << handler << ": damping must matter";
  }
}

TEST(DampedHandlers, RefuseWhatTheyDoNotWorkWith) {
  Body body = test::sliverBody("corotational");
  const auto expect = [&](const char* handler, const RayleighDamping& damping, const char* solver, const char* what) {
    HandlerOptions options;
    options.damping = damping;
    if (solver) options.own.set("solver", std::string(solver));
    try {
      makeHandler(handler, body, makeIntegrator("verlet"), options)->prepare(body.mesh().X, 1e-3);
      ADD_FAILURE() << handler;
    } catch (const InputError& fault) {
      EXPECT_NE(std::string(fault.what()).find(what), std::string::npos) << fault.what();
    }
  };
  expect("fe-pbd", {1, 0}, nullptr, "works without mass-proportional damping");
  expect("modal-filter", {0, 1e-5}, nullptr, "works without stiffness-proportional damping");
  expect("local-time-stepping", {0, 1e-5}, nullptr, "works without stiffness-proportional damping");
  expect("imex", {1, 0}, "newton", "\"newton\" works without damping");
  expect("imex", {3000, 0}, nullptr, "needs a step below");
}

}  // namespace
}  // namespace ringwatch
