// What handlers dissipate, against energies of the whole body that are computed anew.
#include <gtest/gtest.h>

#include <cmath>

#include <ringwatch/handlers/handled_work.h>
#include <ringwatch/handlers/imex/imex.h>
#include <tests/handlers/handler_cases.h>

namespace ringwatch {
namespace {

using test::criticalStepOf;

struct WorkCase {
  std::string_view handler;
  Options own;
};
std::vector<WorkCase> everyCountingVariant() {
  return {{"imex", {{"solver", Imex::newton}}},
          {"imex", {{"solver", Imex::newton}, {"dissipation", 1.0}}},
          {"imex", {{"solver", "cholesky"}}},
          {"imex", {{"solver", "cg"}, {"momentum", "free"}}},
          {"local-time-stepping", {}},
          {"local-time-stepping", {{"levels", 1}}},
          {"fe-pbd", {}},
          {"fe-pbd", {{"variant", "rigid"}}},
          {"modal-filter", {}}};
}
class WorkOfHandler : public ::testing::TestWithParam<int> {
 protected:
  WorkCase own() const { return everyCountingVariant()[GetParam()]; }
};
INSTANTIATE_TEST_SUITE_P(All, WorkOfHandler, ::testing::Range(0, static_cast<int>(everyCountingVariant().size())),
                         [](const auto& test) {
                           return "variant_" + std::to_string(test.param) + "_" +
                                  test::testName(everyCountingVariant()[test.param].handler);
                         });

// Where every element is handled, kinetic and strain energy half way between steps and what was dissipated add up to a
// constant: Theorem 67.
TEST_P(WorkOfHandler, AddsUpWithTheEnergy) {
  Body body = test::sliverBody("corotational", 0.95, false);
  auto handler = makeHandler(own().handler, body, makeIntegrator("symplectic-euler"), {.own = own().own});
  const double h = 40 * criticalStepOf(body);
  handler->prepare(body.mesh().X, h);
  ASSERT_EQ(handler->elements().size(), body.mesh().elementCount());
  EXPECT_EQ(handler->dissipated(), 0);
  BodySystem system(body);
  State state = system.initialState();
  state.v = test::Random(5).nodeVectors(body.nodeCount(), 0.002);
  Body::Workspace workspace;
  const auto energy = [&] {
    return 0.5 * (state.v * body.lumpedMass().asDiagonal()).cwiseProduct(state.v).sum() +
           body.energy(state.x - 0.5 * h * state.v, workspace);
  };
  const double first = energy();
  double most = 0;
  for (int step = 0; step < 40; ++step) {
    ASSERT_TRUE(handler->step(system, state, h).done);
    EXPECT_NEAR(energy() + handler->dissipated(), first, 1e-11 * first) << step;
    most = std::max(most, std::abs(handler->dissipated()));
  }
  EXPECT_GT(most, 0.01 * first);  // it is not all zero
}

// Choosing again begins another count, which goes on from the one before.
TEST_P(WorkOfHandler, GoesOnAfterANewChoice) {
  Body body = test::sliverBody("corotational", 0.95, false);
  auto handler = makeHandler(own().handler, body, makeIntegrator("symplectic-euler"), {.own = own().own});
  const double h = 40 * criticalStepOf(body);
  handler->prepare(body.mesh().X, h);
  BodySystem system(body);
  State state = system.initialState();
  state.v = test::Random(5).nodeVectors(body.nodeCount(), 0.002);
  for (int step = 0; step < 5; ++step) ASSERT_TRUE(handler->step(system, state, h).done);
  const double before = handler->dissipated();
  EXPECT_NE(before, 0);
  handler->prepare(state.x, h);
  EXPECT_EQ(handler->dissipated(), before);
}

// A bar that a support pulls apart slowly: the work that EnergyBalance gives the support is stored, and nothing else
// is.
TEST(HandledWork, CountsSupportsAsTheEnergyBalanceDoes) {
  Body body = test::sliverBody("corotational", 0.95);
  for (const std::int32_t n : body.mesh().nodeSets.at("x-max"))
    for (int c = 0; c < 3; ++c) body.constraints().move(n, c, c == 0 ? 0.02 : 0);
  auto handler = makeHandler("imex", body, makeIntegrator("symplectic-euler"),
                             {.own = {{"solver", Imex::newton}, {"dissipation", 0.0}, {"tolerance", 1e-9}}});
  const double h = 40 * criticalStepOf(body);
  handler->prepare(body.mesh().X, h);
  ASSERT_EQ(handler->elements().size(), body.mesh().elementCount());
  BodySystem system(body);
  State state = system.initialState();
  body.constraints().imposeVelocity(state.v);
  Body::Workspace workspace;
  NodeVectors force, lastForce, lastX = state.x;
  body.internalForce(state.x, lastForce, workspace);
  double work = 0;
  const double start = 0.5 * (state.v * body.lumpedMass().asDiagonal()).cwiseProduct(state.v).sum();
  for (int step = 0; step < 100; ++step) {
    ASSERT_TRUE(handler->step(system, state, h).done);
    body.internalForce(state.x, force, workspace);
    for (const std::int64_t i : body.constraints().components())
      work += 0.5 * (force.data()[i] + lastForce.data()[i]) * (state.x.data()[i] - lastX.data()[i]);
    lastForce = force;
    lastX = state.x;
  }
  const double now =
      0.5 * (state.v * body.lumpedMass().asDiagonal()).cwiseProduct(state.v).sum() + body.energy(state.x, workspace);
  ASSERT_GT(work, 10 * start);
  // The last state is half a step after the last that the work is counted to.
  EXPECT_NEAR(now - start + handler->dissipated(), work, 0.02 * work);
  EXPECT_LE(std::abs(handler->dissipated()), 0.02 * work);
}

}  // namespace
}  // namespace ringwatch
