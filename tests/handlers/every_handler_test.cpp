// What holds of every handler.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include <ringwatch/base/error.h>
#include <ringwatch/handlers/handler.h>
#include <ringwatch/integrators/body_system.h>
#include <tests/handlers/handler_cases.h>

namespace ringwatch {
namespace {

/// All variants of a handler, as options; one without any where it has none.
std::vector<HandlerOptions> variantsOf(const HandlerInfo& handler) {
  const OptionInfo* variant = findOption(handler.options, "variant");
  if (!variant) return {{}};
  std::vector<HandlerOptions> all;
  for (const std::string_view choice : variant->choices) all.push_back({.own = {{"variant", choice}}});
  return all;
}

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

TEST_P(EveryHandler, IsPlainExplicitWhereTheStepIsFine) {
  for (const HandlerOptions& options : variantsOf(*GetParam().info))
    for (const char* base : {"symplectic-euler", "verlet"}) {
      Body body = test::sliverBody("corotational");
      body.addBodyForce({0, 0, -1});
      const double h = 0.75 * test::criticalStepOf(body);
      const auto handler = GetParam().make(body, makeIntegrator(base), options);
      handler->prepare(body.mesh().X, h);
      EXPECT_TRUE(handler->elements().empty());
      EXPECT_EQ(&handler->explicitBody(), &body);
      EXPECT_FALSE(handler->leastHandledDeterminant(body.mesh().X).has_value());
      EXPECT_EQ(handler->uncertifiedPart(body.mesh().X), "");
      const auto plain = makeIntegrator(base);
      BodySystem a(body), b(body);
      State with = a.initialState(), without = b.initialState();
      for (int i = 0; i < 50; ++i) {
        handler->step(a, with, h);
        plain->step(b, without, h);
      }
      EXPECT_EQ(with.x, without.x);
      EXPECT_EQ(with.v, without.v);
    }
}

TEST_P(EveryHandler, FindsTheHandledElementThatIsInverted) {
  Body body = test::sliverBody("corotational", 0.98);
  const auto handler = GetParam().make(body, makeIntegrator("verlet"), {});
  handler->prepare(body.mesh().X, 4 * test::criticalStepOf(body));
  const auto least = handler->leastHandledDeterminant(body.mesh().X);
  if (&handler->explicitBody() == &body) {  // all are explicit, where a monitor observes
    EXPECT_FALSE(least.has_value());
    return;
  }
  ASSERT_TRUE(least.has_value());
  EXPECT_NEAR(least->value, 1, 1e-12);
  // One node through the opposite face.
  const ElementRef e = handler->elements()[handler->elements().size() / 2];
  const auto nodes = body.blocks()[0]->nodesOf(e.element);
  NodeVectors x = body.mesh().X;
  const Eigen::Vector3d centre = (x.col(nodes[0]) + x.col(nodes[1]) + x.col(nodes[2])) / 3;
  x.col(nodes[3]) += 1.5 * (centre - x.col(nodes[3]));
  double own = 1;
  for (const ElementRef one : handler->elements()) {
    const auto at = body.blocks()[0]->nodesOf(one.element);
    Eigen::Matrix3d now, rest;
    for (int k = 0; k < 3; ++k) {
      now.col(k) = x.col(at[static_cast<std::size_t>(k) + 1]) - x.col(at[0]);
      rest.col(k) = body.mesh().X.col(at[static_cast<std::size_t>(k) + 1]) - body.mesh().X.col(at[0]);
    }
    own = std::min(own, now.determinant() / rest.determinant());
  }
  ASSERT_LT(own, 0);
  EXPECT_NEAR(handler->leastHandledDeterminant(x)->value, own, 1e-9 * std::abs(own));
}

TEST_P(EveryHandler, RefusesAStepThatItWasNotPreparedFor) {
  Body body = test::sliverBody();
  const double h = 4 * test::criticalStepOf(body);
  const auto handler = GetParam().make(body, makeIntegrator("verlet"), {});
  handler->prepare(body.mesh().X, h);
  BodySystem system(body);
  State state = system.initialState();
  try {
    handler->step(system, state, 0.5 * h);
    ADD_FAILURE() << "no refusal";
  } catch (const InputError& fault) {
    EXPECT_THAT(fault.what(), ::testing::HasSubstr("prepared for"));
  }
}

TEST(Handlers, RefuseWhatTheyCannotDo) {
  const Material material = makeMaterial("corotational", test::young, test::poisson, test::density);
  Body hexahedra(test::gridMesh("hex8", {2, 2, 2}, {1, 1, 1}), material, {}), linear = test::sliverBody("linear"),
                                                                              slivers = test::sliverBody();
  const HandlerOptions plain, variant{.own = {{"variant", "round"}}}, passes{.own = {{"passes", 33}}},
      rigidPasses{.own = {{"variant", "rigid"}, {"passes", 2}}}, rings{.selection = Selection::fierzRing},
      single{.selection = Selection::elementFrequency}, below{.own = {{"dissipation", -0.1}}},
      above{.own = {{"dissipation", 1.1}}}, noLevel{.own = {{"levels", 0}}}, manyLevels{.own = {{"levels", 13}}},
      unknown{.own = {{"dissipaton", 0.1}}};
  const struct {
    const char* handler;
    Body& body;
    const HandlerOptions& options;
    const char* text;
  } cases[]{
      {"fe-pbd", hexahedra, plain, "fe-pbd handles tet4, and the mesh has hex8"},
      {"modal-filter", hexahedra, plain, "modal-filter handles tet4, and the mesh has hex8"},
      {"fe-pbd", linear, plain, "\"linear\""},
      {"modal-filter", linear, plain, "\"linear\""},
      {"fe-pbd", slivers, variant, "fe-pbd: variant \"round\": must be one of linear, rigid"},
      {"modal-filter", slivers, variant, "modal-filter: variant \"round\": must be one of compliant, projection"},
      {"local-time-stepping", slivers, variant, "variant \"round\": must be one of stabilised, plain"},
      {"fe-pbd", slivers, passes, "passes 33"},
      {"fe-pbd", slivers, rigidPasses, "passes 2: goes with variant linear, not with \"rigid\""},
      {"modal-filter", slivers, rings, "must be certified or element-frequency"},
      {"mass-scaling", slivers, rings, "must be certified"},
      {"local-time-stepping", slivers, single, "must be certified or fierz-ring"},
      {"imex", slivers, below, "dissipation -0.1"},
      {"imex", slivers, above, "dissipation 1.1"},
      {"imex", slivers, unknown, "did you mean \"dissipation\"?"},
      {"mass-scaling", slivers, above, "dissipation 1.1: there are no options"},
      {"local-time-stepping", slivers, below, "dissipation -0.1"},
      {"local-time-stepping", slivers, noLevel, "levels 0"},
      {"local-time-stepping", slivers, manyLevels, "levels 13"},
  };
  for (const auto& one : cases) try {
      makeHandler(one.handler, one.body, makeIntegrator("verlet"), one.options);
      ADD_FAILURE() << one.handler << " does not refuse: " << one.text;
    } catch (const InputError& fault) {
      EXPECT_THAT(fault.what(), ::testing::HasSubstr(one.text)) << one.handler;
    }
}

TEST_P(EveryHandler, IsFoundByItsNameAndItsAlias) {
  const HandlerInfo& info = *GetParam().info;
  EXPECT_EQ(findHandler(info.name), &info);
  if (!info.alias.empty()) {
    EXPECT_EQ(findHandler(info.alias), &info);
  }
  EXPECT_FALSE(info.help.empty());
  EXPECT_FALSE(info.selections.empty());
  for (const OptionInfo& option : info.options) {
    EXPECT_FALSE(option.help.empty()) << option.name;
    if (!option.onlyWith.option.empty()) {
      EXPECT_NE(findOption(info.options, option.onlyWith.option), nullptr);
    }
  }
  EXPECT_NO_THROW(completed(info.name, info.options, {}));
}

TEST(Handlers, TakeOfTheOptionsOfOthersWhatTheyDeclare) {
  const HandlerOptions scene{.selection = Selection::fierzRing,
                             .margin = 0.2,
                             .own = {{"variant", "rigid"}, {"iterations", 5}, {"dissipation", 0.3}}};
  const HandlerOptions imex = optionsFor(*findHandler("imex"), scene),
                       filter = optionsFor(*findHandler("modal-filter"), scene);
  EXPECT_EQ(imex.selection, Selection::fierzRing);
  EXPECT_EQ(imex.margin, 0.2);
  EXPECT_EQ(imex.own.integer("iterations"), 5);
  EXPECT_EQ(imex.own.number("dissipation"), 0.3);
  EXPECT_EQ(imex.own.find("variant"), nullptr);
  EXPECT_EQ(filter.selection, Selection::certified);
  EXPECT_TRUE(filter.own.empty());  // "rigid" is no variant of it, and iterations go with its projection
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
  second->prepare(cut.mesh.X, h, cut, *first);
  // What was handled away from the cut still is; beside it, certified elements may be given back.
  const std::vector<bool> near = touchedNodes(after, cut.changed);
  std::size_t carried = 0;
  for (std::size_t e = 0; e < cut.changed[0].size(); ++e) {
    const auto nodes = after.blocks()[0]->nodesOf(e);
    if (!first->chosen()[0][cut.parent[0][e]] ||
        std::any_of(nodes.begin(), nodes.end(), [&](std::int32_t n) { return near[n]; }))
      continue;
    EXPECT_TRUE(second->chosen()[0][e]) << e;
    ++carried;
  }
  EXPECT_GT(carried, 0u);
  BodySystem system(after);
  State state = system.initialState();
  state.v.row(1) = 0.1 * state.x.row(0);
  const test::ConservedQuantities conserved(after);
  const double start = conserved.energy(state);
  for (int i = 0; i < 200; ++i) ASSERT_TRUE(second->step(system, state, h).done);
  EXPECT_LE(conserved.energy(state), 1.02 * start);
}

TEST(RegisteredHandler, CannotClaimTheStepsThatAGpuHasOfAnother) {
  const HandlerEntry* onGpu = nullptr;
  for (const HandlerEntry& entry : allHandlers())
    if (entry.info->forGpu) onGpu = &entry;
  ASSERT_TRUE(onGpu);
  static HandlerInfo info;
  info = *onGpu->info;
  info.name = "of-a-program";
  info.alias = "";
  const std::size_t before = allHandlers().size();
  try {
    registerHandler({&info, onGpu->make});
    ADD_FAILURE() << "it is registered";
  } catch (const InputError& fault) {
    EXPECT_STREQ(fault.what(),
                 "handler \"of-a-program\": has forGpu, but a GPU takes the steps of the library's own handlers alone; "
                 "leave it out");
  }
  EXPECT_EQ(allHandlers().size(), before);
}

}  // namespace
}  // namespace ringwatch
