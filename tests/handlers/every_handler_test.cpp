// What holds of every handler.
#include <gtest/gtest.h>

#include <ringwatch/handlers/handler.h>
#include <ringwatch/integrators/body_system.h>
#include <tests/handlers/handler_cases.h>

namespace ringwatch {
namespace {

class EveryHandler : public ::testing::TestWithParam<HandlerEntry> {};
INSTANTIATE_TEST_SUITE_P(All, EveryHandler, ::testing::ValuesIn(allHandlers().begin(), allHandlers().end()),
                         [](const auto& test) { return test::testName(test.param.info->name); });

TEST_P(EveryHandler, GivesTheSameBitsForAnyNumberOfThreads) {
  NodeVectors x[2];
  for (int k = 0; k < 2; ++k) {
    Body body(test::sliverBar(0.98), makeMaterial("stvk", test::young, test::poisson, test::density),
              {{}, Lumping::rowSum, k == 0 ? 1 : 3});
    body.addBodyForce({0, 0, -1});
    const double h = 4 * test::criticalStepOf(body);
    const auto handler = GetParam().make(body, makeIntegrator("verlet"), {});
    handler->prepare(body.mesh().X, h);
    ASSERT_FALSE(handler->elements().empty());
    BodySystem system(body);
    State state = system.initialState();
    for (int i = 0; i < 100; ++i) ASSERT_TRUE(handler->step(system, state, h).done);
    x[k] = state.x;
  }
  EXPECT_EQ(x[0], x[1]);
}

TEST_P(EveryHandler, GoesOnAfterACutWithTheChoiceMadeBefore) {
  const Mesh mesh = test::sliverBar(0.98);
  const CutMesh cut = cutMesh(mesh, CutSurface::plane({0.11, 0, 0}, {1, 0.2, 0.1}), mesh.X, 0.02);
  ASSERT_GT(cut.facesOpened, 0u);
  const Material material = makeMaterial("corotational", test::young, test::poisson, test::density);
  Body before(mesh, material), after(cut.mesh, material);
  const double h = 4 * test::criticalStepOf(before);
  const auto first = GetParam().make(before, makeIntegrator("verlet"), {}),
             second = GetParam().make(after, makeIntegrator("verlet"), {});
  first->prepare(mesh.X, h);
  second->prepare(cut.mesh.X, h, cut, first->chosen());
  // What was handled far from the cut still is.
  std::size_t carried = 0;
  for (std::size_t e = 0; e < cut.changed[0].size(); ++e) {
    if (cut.changed[0][e] || !first->chosen()[0][static_cast<std::size_t>(cut.parent[0][e])]) continue;
    EXPECT_TRUE(second->chosen()[0][e]) << e;
    ++carried;
  }
  EXPECT_GT(carried, 0u);
  BodySystem system(after);
  State state = system.initialState();
  state.v.row(1) = 0.1 * state.x.row(0);
  const test::MotionBooks books(after);
  const double start = books.energy(state);
  for (int i = 0; i < 200; ++i) ASSERT_TRUE(second->step(system, state, h).done);
  EXPECT_LE(books.energy(state), 1.02 * start);
}

}  // namespace
}  // namespace ringwatch
